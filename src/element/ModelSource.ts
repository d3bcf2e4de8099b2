import type { WebGLRenderer } from 'three';

/** The URL of a model, and what is needed to decode it. */
export interface ModelSource {
  address: string;
  /** The folders of the decoders; undefined if no attribute names one. */
  folders: Readonly<Record<'draco' | 'ktx2', string | undefined>>;
  /** The variant of its materials: a name, or a number from 1 on; '' for none. */
  variant: string;
  /** The renderer that will draw the model. */
  renderer: WebGLRenderer;
}
