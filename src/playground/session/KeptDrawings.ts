import type { ModelFile } from '../../viewer/files/common/ModelFile.js';
import type { CameraView } from '../../viewer/settings/CameraView.js';

const TURNS = 8;
const TURN_MILLISECONDS = 250;

/**
 * Waits two seconds for an answer. The time is counted in timer ticks, so that it does not run out while the page is busy and the answer
 * cannot be delivered.
 *
 * @throws the answer's reason, or an Error if none comes in time
 */
async function inTime<Result>(answer: Promise<Result>): Promise<Result> {
  const settled = answer.then(
    () => true,
    () => true,
  );
  for (let i = 0; i < TURNS; i++) {
    const turn = new Promise<boolean>((resolve) => setTimeout(resolve, TURN_MILLISECONDS, false));
    if (await Promise.race([settled, turn])) return answer;
  }
  throw new Error('The browser does not answer.');
}

/** The stored record of a drawing with the user's own files, apart from the files themselves. */
export interface KeptDrawing {
  id: string;
  title: string;
  /** The time of the last change, in milliseconds since 1970. */
  at: number;
  /** The size of all its files together. */
  bytes: number;
  /** The settings, as the text of a link. */
  link: string;
  /** The camera, in full precision. Undefined if the model is framed. */
  camera: CameraView | undefined;
  /** A thumbnail, as a data URL. Undefined until the drawing has been complete once, and for drawings of earlier versions. */
  picture?: string;
}

/** The user's own files of a drawing. */
export interface KeptFiles {
  model?: readonly ModelFile[] | undefined;
  map?: readonly ModelFile[] | undefined;
}

const DATABASE = 'three-hatching';
const DRAWINGS = 'drawings';
/** The files have a store of their own, so that changing a setting does not write the model again. */
const FILES = 'files';
/** The maximum number of stored drawings. The oldest is deleted for a new one. */
const MOST = 12;

/**
 * The drawings that the browser stores in IndexedDB, with their files. Every call may reject, for instance in a private window. Reading
 * rejects after two seconds without an answer, and so does writing if the database does not open. Once it is open, writing may take as long
 * as large files need.
 */
export class KeptDrawings {
  private opened: Promise<IDBDatabase> | undefined;

  /** All drawings, latest first. */
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
   * Stores a drawing with its files. Deletes older drawings: those beyond the maximum number; those of the same title and size, which are
   * earlier openings of the same model; and as many as the browser's quota requires.
   */
  async keep(drawing: KeptDrawing, files: KeptFiles): Promise<void> {
    const others = (await this.list()).filter(({ id }) => id !== drawing.id);
    const isSameModel = ({ title, bytes }: KeptDrawing) => title === drawing.title && bytes === drawing.bytes;
    await this.forget(...others.filter((other, i) => isSameModel(other) || i >= MOST - 1).map(({ id }) => id));
    const rest = others.filter((other, i) => !isSameModel(other) && i < MOST - 1);
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

  /** Updates the record of a drawing, without its files. Does nothing if the drawing was deleted. */
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

  /** Runs requests in one transaction. Resolves, when it is complete, to the result of the returned request. */
  private async run<Result = void>(
    mode: IDBTransactionMode,
    ask: (store: (name: string) => IDBObjectStore) => IDBRequest | undefined,
  ): Promise<Result> {
    const database = await inTime(this.open());
    const result = new Promise<Result>((resolve, reject) => {
      const transaction = database.transaction([DRAWINGS, FILES], mode);
      const fail = (): void => reject(transaction.error ?? new Error('The browser has aborted the transaction.'));
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
        // Otherwise a page with a later version of the database would wait until this page is closed.
        request.result.addEventListener('versionchange', () => request.result.close());
        resolve(request.result);
      });
    });
    return this.opened;
  }
}
