import {createTheme, type CSSVariablesResolver, type MantineColorsTuple} from '@mantine/core';

// Mantine in the words of tokens.css: shade 7 is the desk accent, shade 3 the accent in the lab.
const accent: MantineColorsTuple = [
  '#e8f1fb', '#d6e6f7', '#a3cdfa', '#7db7f5', '#4f97dd', '#2b7bc7', '#166abb', '#0b5cad', '#094c90', '#073d74',
];

export const theme = createTheme({
  fontFamily: 'var(--font)',
  fontFamilyMonospace: 'var(--mono)',
  headings: {fontFamily: 'var(--font)', fontWeight: '600'},
  fontSizes: {xs: '12px', sm: '13px', md: '14px', lg: '16px', xl: '20px'},
  lineHeights: {xs: '16px', sm: '18px', md: '20px', lg: '24px', xl: '28px'},
  spacing: {xs: '4px', sm: '8px', md: '12px', lg: '16px', xl: '24px'},
  radius: {sm: '4px', md: '6px', lg: '8px'},
  defaultRadius: 'md',
  colors: {accent},
  primaryColor: 'accent',
  primaryShade: {light: 7, dark: 3},
  autoContrast: true,
  focusRing: 'auto',
  respectReducedMotion: true,
  components: {
    Button: {
      defaultProps: {size: 'sm'},
      vars: (_theme: unknown, props: {size?: unknown}) => ({
        root: props.size === 'md' ? {'--button-height': '44px', '--button-fz': '16px'} : {'--button-height': '32px'},
      }),
    },
    Input: {vars: () => ({wrapper: {'--input-height': '32px', '--input-size': '32px'}})},
  },
});

const surfaces = {
  '--mantine-color-body': 'var(--canvas)',
  '--mantine-color-text': 'var(--text)',
  '--mantine-color-default': 'var(--surface)',
  '--mantine-color-default-hover': 'var(--surface-2)',
  '--mantine-color-default-color': 'var(--text)',
  '--mantine-color-default-border': 'var(--line-strong)',
  '--mantine-color-dimmed': 'var(--text-2)',
  '--mantine-color-placeholder': 'var(--text-3)',
  '--mantine-color-error': 'var(--bad)',
  '--mantine-color-anchor': 'var(--accent)',
  '--mantine-color-disabled': 'var(--surface-2)',
  '--mantine-color-disabled-color': 'var(--text-3)',
  '--mantine-color-disabled-border': 'var(--line)',
};

export const cssVariables: CSSVariablesResolver = () => ({
  variables: {},
  light: surfaces,
  dark: surfaces,
});
