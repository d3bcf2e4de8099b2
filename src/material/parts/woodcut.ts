import type { MaterialPart } from './MaterialPart.js';
import { surface } from './surface.js';

/** The technique `woodcut`, beyond what the part of lines has. */
export const part: MaterialPart = {
  surface,
  files: import.meta.glob<string>('./techniques/lines/carving.glsl', {
    base: '../../../shaders',
    query: '?raw',
    import: 'default',
    eager: true,
  }),
};
