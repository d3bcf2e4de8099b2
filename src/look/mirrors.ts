import { smoothstep } from './vectors.js';

/** The roughnesses up to which metal mirrors fully, and from which on it mirrors nothing. */
export const ROUGH = [0.4, 0.7] as const;

/** How metallic and how rough a surface is. */
export interface Metal {
  readonly metalness: number;
  readonly roughness: number;
}

/** Whether a surface is metal that mirrors the room. Allocates nothing. */
export const isMirror = ({ metalness, roughness }: Partial<Record<keyof Metal, unknown>>): boolean =>
  (metalness as number) > 0 && (roughness as number) < ROUGH[1];

/** How much of the room a surface mirrors, from 0 to 1. */
export const mirroredShare = ({ metalness, roughness }: Metal): number =>
  isMirror({ metalness, roughness }) ? Math.min(metalness, 1) * (1 - smoothstep(ROUGH[0], ROUGH[1], roughness)) : 0;
