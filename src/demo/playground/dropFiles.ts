import type { ModelFile } from '../files/readModel.js';

/** Takes files dropped anywhere on the page or picked by a button; while some are over the page, `overlay` says what it takes. */
export function dropFiles(
  elements: { overlay: HTMLElement; input: HTMLInputElement; buttons: readonly HTMLElement[] },
  onFiles: (files: ModelFile[]) => void,
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
    // Leaving the page has no element it leads to; going from one element to another has.
    if (event.relatedTarget === null) overlay.hidden = true;
  });
  addEventListener('drop', async (event) => {
    overlay.hidden = true;
    if (!carriesFiles(event) || !event.dataTransfer) return;
    event.preventDefault();
    onFiles(await droppedFiles(event.dataTransfer));
  });
  input.addEventListener('change', () => {
    const files = [...(input.files ?? [])].map((file) => ({ name: file.name, content: file }));
    // The same file picked again must be a change again.
    input.value = '';
    if (files.length > 0) onFiles(files);
  });
  for (const button of buttons) button.addEventListener('click', () => input.click());
}

/** The files of a drop, also those in dropped folders. */
async function droppedFiles(transfer: DataTransfer): Promise<ModelFile[]> {
  // Both must be read before anything is awaited: the transfer is emptied after the event.
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
    // A reader gives its entries in portions, the last of them empty.
    const batch = await new Promise<FileSystemEntry[]>((resolve, reject) => reader.readEntries(resolve, reject));
    if (batch.length === 0) return found;
    for (const child of batch) found.push(...(await filesOf(child)));
  }
}
