/** Known in three.js 0.170 to 0.187: the order in which renderers call the hooks of a material, and what they pass. */
import type { Material, WebGLProgramParametersWithUniforms } from 'three';
import { warnOfRenderer } from '../diagnostics/warn.js';

type Hooks = Pick<Material, 'onBeforeRender' | 'onBeforeCompile' | 'customProgramCacheKey'>;
// Arguments and results are only passed on, so any type will do.
type Hook = (this: unknown, ...parameters: unknown[]) => unknown;

/** The user's hook, keyed by the function that wraps it. */
const userHooks = /* @__PURE__ */ new WeakMap<object, unknown>();

/**
 * Runs a material's own parts of three's hooks (`onBeforeCompile` and others) even if a user sets hooks in their place. To the user,
 * the hooks behave as on three's own materials: a new hook may call the old one, bound to the material or not; a hook that was read can
 * be set again; the source of the new hook decides the program's key; and `delete` removes it.
 *
 * @param parts the material's own hooks, from its prototype. They run before the user's hook, and again if that calls the old hook.
 */
export function keepHooks(material: Material, parts: Hooks): void {
  for (const name of ['onBeforeRender', 'onBeforeCompile', 'customProgramCacheKey'] as const) {
    let hook = withPart(material, parts[name] as Hook, material[name] as Hook);
    Object.defineProperty(material, name, {
      get: () => hook,
      set: (value: Hook) => {
        hook = withPart(material, parts[name] as Hook, userHooks.has(value) ? (userHooks.get(value) as Hook) : value);
      },
      configurable: true,
    });
  }
}

function withPart(material: Material, part: Hook, set: Hook | null | undefined): Hook {
  // Parameters are named one by one, because rest parameters would allocate an array for every mesh of every frame. The renderer may
  // hold a proxy of the material; the material's own part runs on the material itself, because to the renderer a texture read from a
  // proxy is another texture.
  const hook: Hook = function (a, b, c, d, e, f) {
    const result = part.call(material, a, b, c, d, e, f);
    return set === part ? result : set?.call(this, a, b, c, d, e, f);
  };
  hook.toString = () => String(set);
  userHooks.set(hook, set);
  return hook;
}

/**
 * Finds out whether a material is drawn by another renderer than WebGLRenderer, and warns of it. These are its states:
 *
 * | state | the renderer has called | next |
 * | --- | --- | --- |
 * | `'new'` | nothing | `'asked'` or `'webgl'` |
 * | `'asked'` | `customProgramCacheKey`, as every renderer does | `'webgl'` in the same task, or else a warning |
 * | `'webgl'` | `onBeforeCompile` or `onBeforeRender`, which WebGPURenderer does not call | none |
 */
export class RendererKind {
  state: 'new' | 'asked' | 'webgl' = 'new';

  /** To be called with `customProgramCacheKey`. */
  ask(what: string): void {
    if (this.state !== 'new') return;
    this.state = 'asked';
    queueMicrotask(() => {
      if (this.state === 'asked') warnOfRenderer(what);
    });
  }
}

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
