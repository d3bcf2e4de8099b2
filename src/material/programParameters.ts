import type { WebGLProgramParametersWithUniforms } from 'three';

/** The parameters of a program, which three.js passes to `onBeforeCompile`. */
export type ProgramParameters = WebGLProgramParametersWithUniforms;

/** Is put before the shaders of a mesh that neither deforms nor has instances. */
const RIGID = '#define RIGID\n';

/** Whether the vertices that the program draws move only with their object. three defines these facts in the vertex shader alone. */
export function isRigid({ skinning, instancing, batching, morphTargets, morphNormals }: ProgramParameters): boolean {
  return !(skinning || instancing || batching || morphTargets || morphNormals);
}

/** Tells both shaders of a program if it is rigid. A user's hook may call the material's, which then does this twice. */
export function defineRigid(shader: ProgramParameters): void {
  if (!isRigid(shader) || shader.vertexShader.includes(RIGID)) return;
  shader.vertexShader = `${RIGID}${shader.vertexShader}`;
  shader.fragmentShader = `${RIGID}${shader.fragmentShader}`;
}
