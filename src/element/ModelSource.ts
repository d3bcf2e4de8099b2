import type { WebGLRenderer } from 'three';

/** The URL of a model, and the settings to decode it. */
export interface ModelSource {
  address: string;
  /** The folders of the decoders; undefined without the attribute. */
  folders: Readonly<Record<'draco' | 'ktx2', string | undefined>>;
  /** The material variant: a name, or a number from 1 on; '' for none. */
  variant: string;
  /** The renderer that will draw the model. */
  renderer: WebGLRenderer;
}
