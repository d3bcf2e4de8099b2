import type { WebGLRenderer } from 'three';
import type { Deformations } from './Deformations.js';

let fetched: Deformations<WebGLRenderer> | undefined;

/** The deformations of WebGLRenderer, for outlines; undefined until `fetchDeformations` has fetched their code. */
export const fetchedDeformations = (): Deformations<WebGLRenderer> | undefined => fetched;

/** Fetches the code that deforms vertices. Few scenes have meshes that deform. */
export async function fetchDeformations(): Promise<void> {
  fetched ??= (await import('./PrePass.js')).glslDeformations;
}
