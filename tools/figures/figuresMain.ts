import { setPageState } from '../../src/playground/page/elements.js';
import { createFiguresPage, layOutFigures } from './createFiguresPage.js';
import { figuresPage } from './figuresPage.js';

const say = (sentence: string): void => {
  figuresPage.status.textContent = sentence;
};
const context = document.createElement('canvas').getContext('webgl2', {
  alpha: false,
  antialias: true,
  powerPreference: 'high-performance',
});

if (context) createFiguresPage(context, say);
else {
  layOutFigures(say, () => {});
  setPageState('failed');
  say('The figures need WebGL 2, which this browser does not offer or has switched off.');
}
