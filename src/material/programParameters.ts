import type { WebGLProgramParametersWithUniforms } from 'three';

/** The parameters of a program that three.js passes to `onBeforeCompile`. */
export type ProgramParameters = WebGLProgramParametersWithUniforms;

/** The define for shaders of a mesh that neither deforms nor has instances. */
const RIGID = '#define RIGID\n';

/** Whether the vertices of a program's meshes move only with their object. three.js defines these facts in the vertex shader alone. */
export function isRigid({ skinning, instancing, batching, morphTargets, morphNormals }: ProgramParameters): boolean {
  return !(skinning || instancing || batching || morphTargets || morphNormals);
}

/** Defines `RIGID` in both shaders of a rigid program. It may run twice, since a user's hook may call the material's. */
export function defineRigid(shader: ProgramParameters): void {
  if (!isRigid(shader) || shader.vertexShader.includes(RIGID)) return;
  shader.vertexShader = `${RIGID}${shader.vertexShader}`;
  shader.fragmentShader = `${RIGID}${shader.fragmentShader}`;
}
