/** The occlusion from which on light with a direction loses as much as light from all around. Shaders and the processor both know it. */
export const CAVITY = 0.4;
