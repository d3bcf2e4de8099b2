/** The name of a drawing as that of a file, without an extension. */
export function fileStem(title: string): string {
  const stem = title
    .replace(/\.\w+$/, '')
    .replace(/\W+/g, '-')
    .toLowerCase();
  return stem || 'drawing';
}
