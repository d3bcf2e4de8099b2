/** Numbers by name: a single one is a float in shaders, an array is a vector. */
export type Constants = Readonly<Record<string, number | readonly number[]>>;

/**
 * Constants as defines.
 *
 * @param ending the suffix of whole numbers: '.' for floats, '' for integers and 'u' for unsigned integers
 */
export const definesOf = (constants: Constants, ending: '.' | '' | 'u' = '.'): string =>
  Object.entries(constants)
    .map(([name, value]) => `#define ${name} ${written(value, ending)}`)
    .join('\n');

function written(value: number | readonly number[], ending: string): string {
  if (typeof value === 'object') return `vec${value.length}(${value})`;
  return value % 1 ? `${value}` : value + ending;
}

const OUR_INCLUDE = /^[ \t]*#include[ \t]*"(.*)"[ \t]*$/gm;

/**
 * Replaces every line `#include "name"` in `source` by `chunks[name]`, recursively. Includes in angle brackets are left to three.js, so
 * the two never collide and three's ShaderChunk stays as it is.
 *
 * @throws Error if a chunk is missing, or includes itself.
 */
export const resolveIncludes = (source: string, chunks: Readonly<Record<string, string>>): string =>
  source.replace(OUR_INCLUDE, (_line, included: string) => {
    if (!Object.hasOwn(chunks, included)) throw new Error(`no shader chunk "${included}", or it includes itself`);
    const { [included]: text, ...others } = chunks;
    return resolveIncludes(text, others);
  });
