/** Turns the title of a drawing into a file name without an extension. */
export function fileStem(title: string): string {
  const stem = title
    .replace(/\.\w+$/, '')
    .replace(/\W+/g, '-')
    .toLowerCase();
  return stem || 'drawing';
}
