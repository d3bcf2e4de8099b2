import type { WebGLRenderer } from 'three';

/** The URL of a model, and what is needed to decode it. */
export interface ModelSource {
  address: string;
  /** The folders of the decoders; undefined if no attribute names one. */
  folders: Readonly<Record<'draco' | 'ktx2', string | undefined>>;
  /** The renderer that will draw the model. */
  renderer: WebGLRenderer;
}
