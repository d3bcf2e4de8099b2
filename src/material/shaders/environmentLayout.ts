import { ShaderChunk } from 'three';

/** How the installed three.js lays out a blurred environment: an atlas before 0.187, a cube from then on. */
export const environmentLayout = (): 'atlas' | 'cube' =>
  'cube_uv_reflection_fragment' in ShaderChunk ? 'atlas' : 'cube';
