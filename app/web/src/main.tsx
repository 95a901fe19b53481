import '@fontsource-variable/inter';
import '@mantine/core/styles.css';
import './app/tokens.css';
import './app/base.css';
import {StrictMode} from 'react';
import {createRoot} from 'react-dom/client';
import {App} from './app/App';

const root = document.getElementById('root');
if (!root) throw new Error('index.html has no element with the id root');
createRoot(root).render(<StrictMode><App /></StrictMode>);
