import type { WebGLProgramParametersWithUniforms } from 'three';

/** What three.js builds a program by, which it hands to `onBeforeCompile`. */
export type ProgramParameters = WebGLProgramParametersWithUniforms;

/** Whether the vertices of what the program draws move with their object alone. three tells the vertex shader only. */
export function isRigid({ skinning, instancing, batching, morphTargets, morphNormals }: ProgramParameters): boolean {
  return !(skinning || instancing || batching || morphTargets || morphNormals);
}
