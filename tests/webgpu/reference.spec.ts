import { compareAnchored } from '../gpu/compareAnchored.js';
import { compareEngraved } from '../gpu/compareEngraved.js';
import { compareStipple } from '../gpu/compareStipple.js';
import { nodeReferencePage } from './nodeReferencePage.js';

/** What nodes do not draw yet. */
const drawn = (name: string): boolean => !/, (cross|reorient)\b|shadow that crosses|crossed by shadow/.test(name);

for (const backend of ['forceWebGL', 'webgpu'] as const) {
  const test = nodeReferencePage(backend);
  test.describe(backend, () => {
    compareEngraved(test, drawn);
    compareAnchored(test, drawn);
    compareStipple(test, drawn);
  });
}
