import { ShaderChunk } from 'three';

/** The layout of a blurred environment in the installed three.js: an atlas before 0.187, a cube from 0.187 on. */
export const environmentLayout = (): 'atlas' | 'cube' =>
  'cube_uv_reflection_fragment' in ShaderChunk ? 'atlas' : 'cube';
