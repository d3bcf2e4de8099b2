import { compareAnchored } from '../gpu/compareAnchored.js';
import { compareEngraved } from '../gpu/compareEngraved.js';
import { compareStipple } from '../gpu/compareStipple.js';
import { nodeReferencePage } from './nodeReferencePage.js';

for (const backend of ['forceWebGL', 'webgpu'] as const) {
  const test = nodeReferencePage(backend);
  test.describe(backend, { tag: '@all' }, () => {
    compareEngraved(test);
    compareAnchored(test);
    compareStipple(test);
  });
}
