import type { Material } from 'three';

type Hooks = Pick<Material, 'onBeforeRender' | 'onBeforeCompile' | 'customProgramCacheKey'>;
// Whatever they take and return: it is handed on.
type Hook = (this: unknown, ...parameters: unknown[]) => unknown;

/** What a user set, by what was made of it. */
const given = /* @__PURE__ */ new WeakMap<object, unknown>();

/**
 * Lets a material do its part of three's hooks whatever a user sets in their place, who finds them as on three's own materials:
 * what is set may call what was there before, bound to the material or not; a hook that was read can be set again; programs are
 * told apart by the source of what was set; and `delete` takes it back.
 *
 * @param parts the material's own, from its prototype. They come first. Where what was set calls what was there before, they are
 * called once more.
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
  // Named one by one: rest parameters would be an array for every mesh of every frame. The renderer may know the material by a
  // proxy, whose textures would be proxies too, and others to the renderer: its part is that of the material itself.
  const hook: Hook = function (a, b, c, d, e, f) {
    const result = part.call(material, a, b, c, d, e, f);
    return set === part ? result : set?.call(this, a, b, c, d, e, f);
  };
  hook.toString = () => String(set);
  given.set(hook, set);
  return hook;
}
