import type { WebGLProgramParametersWithUniforms } from 'three';

/** The parameters of a program, which three.js passes to `onBeforeCompile`. */
export type ProgramParameters = WebGLProgramParametersWithUniforms;

/** Whether the vertices that the program draws move only with their object. three defines these facts in the vertex shader alone. */
export function isRigid({ skinning, instancing, batching, morphTargets, morphNormals }: ProgramParameters): boolean {
  return !(skinning || instancing || batching || morphTargets || morphNormals);
}
