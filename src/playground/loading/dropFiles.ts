import type { ModelFile } from '../../viewer/files/readModel.js';

/**
 * Receives files that are dropped anywhere on the page or picked with a button. `overlay` is shown while files are dragged over the page;
 * `onFailure` is called if a folder cannot be read.
 */
export function dropFiles(
  elements: { overlay: HTMLElement; input: HTMLInputElement; buttons: readonly HTMLElement[] },
  onFiles: (files: ModelFile[]) => void,
  onFailure: (error: unknown) => void,
): void {
  const { overlay, input, buttons } = elements;
  const carriesFiles = (event: DragEvent): boolean => event.dataTransfer?.types.includes('Files') ?? false;
  addEventListener('dragenter', (event) => {
    if (carriesFiles(event)) overlay.hidden = false;
  });
  addEventListener('dragover', (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    event.dataTransfer!.dropEffect = 'copy';
  });
  addEventListener('dragleave', (event) => {
    // `relatedTarget` is null when the pointer leaves the page.
    if (event.relatedTarget === null) overlay.hidden = true;
  });
  addEventListener('drop', (event) => {
    overlay.hidden = true;
    if (!carriesFiles(event) || !event.dataTransfer) return;
    event.preventDefault();
    droppedFiles(event.dataTransfer).then(onFiles, onFailure);
  });
  input.addEventListener('change', () => {
    const files = [...(input.files ?? [])].map((file) => ({ name: file.name, content: file }));
    // Otherwise, picking the same file again would fire no event.
    input.value = '';
    if (files.length > 0) onFiles(files);
  });
  for (const button of buttons) button.addEventListener('click', () => input.click());
}

/** The dropped files, including those in folders. */
async function droppedFiles(transfer: DataTransfer): Promise<ModelFile[]> {
  // Both are read before the first await, because the browser empties the transfer after the event.
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry?.() ?? null);
  const files = [...transfer.files];
  if (!entries.some((entry) => entry?.isDirectory)) return files.map((file) => ({ name: file.name, content: file }));
  return (await Promise.all(entries.map((entry) => (entry ? filesOf(entry) : [])))).flat();
}

async function filesOf(entry: FileSystemEntry): Promise<ModelFile[]> {
  if (entry.isFile) {
    const file = await new Promise<File>((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject));
    return [{ name: file.name, content: file }];
  }
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  const found: ModelFile[] = [];
  for (;;) {
    // A reader returns its entries in batches, the last of which is empty.
    const batch = await new Promise<FileSystemEntry[]>((resolve, reject) => reader.readEntries(resolve, reject));
    if (batch.length === 0) return found;
    for (const child of batch) found.push(...(await filesOf(child)));
  }
}
