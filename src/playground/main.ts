import { HatchingMaterial } from 'three-hatching';
import { errorMessage } from '../viewer/files/common/ModelError.js';
import { createPlayground } from './createPlayground.js';
import { setPageState } from './page/elements.js';
import { page } from './page/page.js';
import { Status } from './tasks/Status.js';
import { drawsInSoftware, rendererAhead } from './viewport/graphicsCard.js';

// Silences warnings meant for developers: users choose weak lights or huge strokes on purpose, and paper is shown until a map is drawn.
HatchingMaterial.silent = true;

function open(renderer: string | undefined): void {
  const status = new Status(page.status);
  const context = page.canvas.getContext('webgl2', {
    alpha: true,
    // On a software renderer, antialiasing takes as long as everything else, and strokes and lines have soft edges of their own.
    antialias: !drawsInSoftware(renderer),
    depth: true,
    powerPreference: 'high-performance',
  });
  if (!context) {
    setPageState('failed');
    status.fail('This page needs WebGL 2, which this browser does not offer or has switched off.');
    return;
  }
  try {
    createPlayground(context, status);
  } catch (error) {
    setPageState('failed');
    status.fail(`The page could not be set up: ${errorMessage(error)}`);
    throw error;
  }
}

void rendererAhead().then(open);
