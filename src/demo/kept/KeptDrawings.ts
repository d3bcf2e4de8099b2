import type { ModelFile } from '../files/common/ModelFile.js';
import type { CameraView } from '../settings/CameraView.js';
import { inTime } from './inTime.js';

/** A drawing that needs files of the user's own: everything but the files. */
export interface KeptDrawing {
  id: string;
  title: string;
  /** When it was last drawn, in milliseconds since 1970. */
  at: number;
  /** Of its files together. */
  bytes: number;
  /** Its settings, as a link has them. */
  link: string;
  /** Its view, to the last digit. Undefined if it is framed. */
  camera: CameraView | undefined;
  /** What it looks like, as the address of a small image. Undefined until it was drawn at rest, and for drawings of earlier versions. */
  picture?: string;
}

/** The files of a drawing. */
export interface KeptFiles {
  model?: readonly ModelFile[] | undefined;
  map?: readonly ModelFile[] | undefined;
}

const DATABASE = 'three-hatching';
const DRAWINGS = 'drawings';
/** Apart from the drawings, so that changing a setting does not write a model again. */
const FILES = 'files';
/** So many drawings are kept; the oldest goes when another comes. */
const MOST = 12;

/**
 * The drawings that the browser keeps for the page, with the files they need. Every call may reject, in private windows say; what is
 * read rejects after two seconds without an answer, and so does what is written, if the browser does not open the database. Once it
 * is open, writing may take as long as large files need.
 */
export class KeptDrawings {
  private opened: Promise<IDBDatabase> | undefined;

  /** All drawings, the latest first. */
  async list(): Promise<KeptDrawing[]> {
    const all = await this.run<KeptDrawing[]>('readonly', (store) => store(DRAWINGS).getAll());
    return all.sort((a, b) => b.at - a.at);
  }

  async read(id: string): Promise<{ drawing: KeptDrawing; files: KeptFiles } | undefined> {
    const drawing = await this.run<KeptDrawing | undefined>('readonly', (store) => store(DRAWINGS).get(id));
    const files = await this.run<KeptFiles | undefined>('readonly', (store) => store(FILES).get(id));
    return drawing && files && { drawing, files };
  }

  /**
   * Keeps a drawing with its files. Older ones make room: those beyond the number that is kept; one of the same name and size,
   * which is this model as it was opened before; and as many as the browser's quota asks for.
   */
  async keep(drawing: KeptDrawing, files: KeptFiles): Promise<void> {
    const others = (await this.list()).filter(({ id }) => id !== drawing.id);
    const isTwin = ({ title, bytes }: KeptDrawing) => title === drawing.title && bytes === drawing.bytes;
    await this.forget(...others.filter((one, i) => isTwin(one) || i >= MOST - 1).map(({ id }) => id));
    const rest = others.filter((one, i) => !isTwin(one) && i < MOST - 1);
    for (;;) {
      try {
        await this.write(drawing, files);
        return;
      } catch (error) {
        const oldest = rest.pop();
        if ((error as Error | null)?.name !== 'QuotaExceededError' || !oldest) throw error;
        await this.forget(oldest.id);
      }
    }
  }

  /** Changes what is known of a drawing, but for its files. One that was forgotten stays so. */
  async update(drawing: Pick<KeptDrawing, 'id'> & Partial<KeptDrawing>): Promise<void> {
    const known = await this.run<KeptDrawing | undefined>('readonly', (store) => store(DRAWINGS).get(drawing.id));
    if (known) await this.run('readwrite', (store) => store(DRAWINGS).put({ ...known, ...drawing }));
  }

  async forget(...ids: readonly string[]): Promise<void> {
    if (ids.length === 0) return;
    await this.run('readwrite', (store) => {
      for (const id of ids) {
        store(FILES).delete(id);
        store(DRAWINGS).delete(id);
      }
      return undefined;
    });
  }

  private async write(drawing: KeptDrawing, files: KeptFiles): Promise<void> {
    await this.run('readwrite', (store) => {
      store(FILES).put(files, drawing.id);
      return store(DRAWINGS).put(drawing);
    });
  }

  /** Runs requests in one transaction. Resolves, when it is complete, to the result of the request that is returned. */
  private async run<Result = void>(
    mode: IDBTransactionMode,
    ask: (store: (name: string) => IDBObjectStore) => IDBRequest | undefined,
  ): Promise<Result> {
    const database = await inTime(this.open());
    const result = new Promise<Result>((resolve, reject) => {
      const transaction = database.transaction([DRAWINGS, FILES], mode);
      const fail = (): void => reject(transaction.error ?? new Error('The browser has stopped keeping.'));
      transaction.addEventListener('abort', fail);
      transaction.addEventListener('error', fail);
      const request = ask((name) => transaction.objectStore(name));
      transaction.addEventListener('complete', () => resolve(request?.result as Result));
    });
    return mode === 'readonly' ? inTime(result) : result;
  }

  private open(): Promise<IDBDatabase> {
    this.opened ??= new Promise<IDBDatabase>((resolve, reject) => {
      const request = indexedDB.open(DATABASE, 1);
      request.addEventListener('upgradeneeded', () => {
        request.result.createObjectStore(DRAWINGS, { keyPath: 'id' });
        request.result.createObjectStore(FILES);
      });
      request.addEventListener('error', () => reject(request.error));
      request.addEventListener('success', () => {
        // Otherwise a page of a later version would wait for this one.
        request.result.addEventListener('versionchange', () => request.result.close());
        resolve(request.result);
      });
    });
    return this.opened;
  }
}
