/** Downloads a file. */
export function download(content: Blob, name: string): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  // The browser needs the URL for a moment after the click.
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
