import reactHooks from 'eslint-plugin-react-hooks';
import tseslint from 'typescript-eslint';

// Imports only go downwards: wire is the floor, then parts, then console, then curriculum, then pages, then app.
const layer = (folder, above) => ({
  files: [`src/${folder}/**/*.{ts,tsx}`],
  rules: {
    'no-restricted-imports': ['error', {
      patterns: above.map((name) => ({
        regex: `(^|/)\\.\\./(.*/)?${name}(/|$)`,
        message: `${folder} lies below ${name}: imports only go downwards.`,
      })),
    }],
  },
});

export default tseslint.config(
  {ignores: ['dist', 'node_modules']},
  tseslint.configs.strict,
  reactHooks.configs.flat['recommended-latest'],
  layer('wire', ['parts', 'pages', 'console', 'curriculum', 'app']),
  layer('parts', ['pages', 'console', 'curriculum', 'app']),
  layer('pages', ['app']),
  layer('console', ['pages', 'curriculum', 'app']),
  layer('curriculum', ['pages', 'app']),
);
