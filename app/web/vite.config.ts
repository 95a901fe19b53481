import react from '@vitejs/plugin-react';
import {defineConfig} from 'vitest/config';

const server = 'http://127.0.0.1:8080';

export default defineConfig({
  plugins: [react()],
  server: {proxy: {'/api': {target: server, ws: true}}},
  build: {
    target: 'es2022',
    // the server's content policy allows no data: addresses for fonts and scripts
    assetsInlineLimit: 0,
    // three.js, loaded only with the console, is larger than the default mark
    chunkSizeWarningLimit: 900,
  },
  test: {environment: 'node', include: ['src/**/*.test.ts']},
});
