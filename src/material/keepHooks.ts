import type { Material } from 'three';

type Hooks = Pick<Material, 'onBeforeRender' | 'onBeforeCompile' | 'customProgramCacheKey'>;
// Their arguments and results are only passed on, so any type will do.
type Hook = (this: unknown, ...parameters: unknown[]) => unknown;

/** The hook that a user set, by the function that was made of it. */
const given = /* @__PURE__ */ new WeakMap<object, unknown>();

/**
 * Runs a material's own parts of three's hooks (`onBeforeCompile` and others) even if a user sets hooks in their place. For the user
 * they behave as on three's own materials: the new hook may call the old one, bound to the material or not; a hook that was read can
 * be set again; the source of the new hook tells programs apart; and `delete` removes it.
 *
 * @param parts the material's own parts, from its prototype. They run before the user's hook, and once more if that calls the old hook.
 */
export function keepHooks(material: Material, parts: Hooks): void {
  for (const name of ['onBeforeRender', 'onBeforeCompile', 'customProgramCacheKey'] as const) {
    let hook = withPart(material, parts[name] as Hook, material[name] as Hook);
    Object.defineProperty(material, name, {
      get: () => hook,
      set: (value: Hook) => {
        hook = withPart(material, parts[name] as Hook, given.has(value) ? (given.get(value) as Hook) : value);
      },
      configurable: true,
    });
  }
}

function withPart(material: Material, part: Hook, set: Hook | null | undefined): Hook {
  // Parameters are named one by one, because rest parameters would allocate an array for every mesh of every frame. The renderer may hold
  // a proxy of the material; our part is called on the material itself, since textures read from a proxy are other ones to the renderer.
  const hook: Hook = function (a, b, c, d, e, f) {
    const result = part.call(material, a, b, c, d, e, f);
    return set === part ? result : set?.call(this, a, b, c, d, e, f);
  };
  hook.toString = () => String(set);
  given.set(hook, set);
  return hook;
}
