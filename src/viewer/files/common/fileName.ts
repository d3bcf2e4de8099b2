/** The part of a path or URI after its last slash. */
export function baseName(path: string): string {
  return path.split(/[\\/]/).pop() ?? path;
}

/** The lower-case extension, without the dot. */
export function extensionOf(name: string): string | undefined {
  return /\.([a-z0-9]+)$/i.exec(name)?.[1]?.toLowerCase();
}

/** The name of a gzipped file once it is unpacked. */
export function withoutGz(name: string): string {
  return name.replace(/\.gz$/i, '');
}
