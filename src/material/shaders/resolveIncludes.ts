const OUR_INCLUDE = /^[ \t]*#include[ \t]*"(.*)"[ \t]*$/gm;

/**
 * Replaces every line `#include "name"` in `source` by `chunks[name]`, recursively. Includes in angle brackets are left to three.js, so
 * the two never collide and three's ShaderChunk stays as it is.
 *
 * @throws Error if a chunk is missing, or includes itself.
 */
export function resolveIncludes(
  source: string,
  chunks: Readonly<Record<string, string>>,
  within: readonly string[] = [],
): string {
  return source.replace(OUR_INCLUDE, (_line, name: string) => {
    if (!Object.hasOwn(chunks, name)) {
      throw new Error(
        `resolveIncludes: there is no shader chunk "${name}"; known are ${Object.keys(chunks).join(', ')}.`,
      );
    }
    if (within.includes(name)) {
      throw new Error(`resolveIncludes: the shader chunk "${name}" includes itself, by way of ${within.join(', ')}.`);
    }
    return resolveIncludes(chunks[name], chunks, [...within, name]);
  });
}
