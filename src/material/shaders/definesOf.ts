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
