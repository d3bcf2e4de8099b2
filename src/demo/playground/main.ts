import { setPageState } from '../page/setPageState.js';
import { createPlayground } from './createPlayground.js';
import { page } from './page.js';
import { Status } from './Status.js';

const status = new Status(page.status);
const context = page.canvas.getContext('webgl2', {
  alpha: true,
  antialias: true,
  depth: true,
  powerPreference: 'high-performance',
});

if (context) createPlayground(context, status);
else {
  setPageState('failed');
  status.fail('This page needs WebGL 2, which this browser does not offer or has switched off.');
}
