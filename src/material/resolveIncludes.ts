const OUR_INCLUDE = /^[ \t]*#include +"(\w+)"[ \t]*$/gm;

/**
 * Replaces every line `#include "name"` in `source` by `chunks[name]`, recursively. Includes in angle brackets are
 * three's own and stay for three to resolve, so the two never collide and three's ShaderChunk is left alone.
 *
 * @throws Error if a chunk is missing.
 */
export function resolveIncludes(source: string, chunks: Readonly<Record<string, string>>): string {
  return source.replace(OUR_INCLUDE, (_line, name: string) => {
    const chunk = chunks[name];
    if (chunk === undefined) {
      throw new Error(
        `resolveIncludes: there is no shader chunk "${name}"; known are ${Object.keys(chunks).join(', ')}.`,
      );
    }
    return resolveIncludes(chunk, chunks);
  });
}
