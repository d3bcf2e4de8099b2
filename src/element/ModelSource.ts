import type { WebGLRenderer } from 'three';

/** Where a model lies, and what unpacks it. */
export interface ModelSource {
  address: string;
  /** Folders of decoders, by what they unpack. Undefined where no attribute names one. */
  folders: Readonly<Record<'draco' | 'ktx2', string | undefined>>;
  /** What will draw it. */
  renderer: WebGLRenderer;
}
