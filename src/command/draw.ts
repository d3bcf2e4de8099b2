import { stat } from 'node:fs/promises';
import { dirname, extname, join, resolve } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { Worker } from 'node:worker_threads';
import type { SVGDrawingLayer } from 'three-hatching/svg';
import { version } from '../../package.json';
import { plottingTime } from '../vector/plot/plotTime.js';
import { shownText } from '../viewer/files/common/ModelError.js';
import { readingTime } from '../viewer/files/common/ModelFile.js';
import { DrawingFiles } from './DrawingFiles.js';
import { DRAW_HELP, type DrawingOptions, parseDrawing } from './parseDrawing.js';
import { expandPattern, isPattern, type PlannedModel, planOutputs } from './planOutputs.js';
import { Interrupted, UsageError } from './readOptions.js';
import { type ProgressBar, readStandardInput, STANDARD, STANDARD_INPUT } from './standardStreams.js';

/**
 * Runs the command `draw`.
 *
 * @param args the arguments after its name
 * @returns how many models failed or were drawn incompletely
 * @throws UsageError if the arguments are not valid, or Interrupted
 */
export async function draw(args: readonly string[], signal: AbortSignal, bar: ProgressBar): Promise<number> {
  const request = parseDrawing(args);
  if (request.action === 'help') {
    process.stdout.write(DRAW_HELP);
    return 0;
  }
  if (request.action === 'version') {
    process.stdout.write(`${version}\n`);
    return 0;
  }
  const { out, force, jobs, options } = request;
  const models = await filesOf(request.models);
  const isFolder = (await stat(out).catch(() => undefined))?.isDirectory() ?? false;
  const planned = planOutputs(models, out, isFolder, options.frames, options.written);
  const files = new DrawingFiles(force);
  try {
    await files.open(planned.flatMap(({ outputs }) => outputs));
    return await new Draughtsmen(planned, options, files, signal, bar).draw(jobs);
  } catch (error) {
    throw signal.aborted ? new Interrupted(files.written) : error;
  } finally {
    await files.close();
    bar.clear();
  }
}

/** The models that names and patterns refer to, without duplicates. A pattern that is the name of an existing file is that file. */
async function filesOf(names: readonly string[]): Promise<string[]> {
  const models: string[] = [];
  for (const name of names) {
    if (name === STANDARD) {
      models.push(name);
      continue;
    }
    const isThere = await stat(name).then(
      () => true,
      () => false,
    );
    const found = isThere || !isPattern(name) ? [name] : await expandPattern(name);
    if (found.length === 0) throw new UsageError(`${name} matches no file; check its folder.`);
    models.push(...found);
  }
  return [...new Map(models.toReversed().map((model) => [placeOf(model), model])).values()].toReversed();
}

const placeOf = (model: string): string => (model === STANDARD ? STANDARD : resolve(model));

/** Draws several models in parallel. */
class Draughtsmen {
  /** Progress of each model, in [0, 1]. */
  private readonly done: number[];
  private failed = 0;
  /** The stream for the line printed about each drawing. */
  private readonly counts: NodeJS.WriteStream;

  constructor(
    private readonly planned: readonly PlannedModel[],
    private readonly options: DrawingOptions,
    private readonly files: DrawingFiles,
    private readonly signal: AbortSignal,
    private readonly bar: ProgressBar,
  ) {
    this.done = planned.map(() => 0);
    const isPiped = planned.some(({ outputs }) => outputs.includes(STANDARD));
    this.counts = isPiped ? process.stderr : process.stdout;
  }

  /** Whether there are several pens, each of which is reported. */
  private get hasPens(): boolean {
    const { pens, pen } = this.options;
    return pens !== undefined || typeof pen === 'object';
  }

  /** @returns how many models failed or were drawn incompletely */
  async draw(jobs: number): Promise<number> {
    const waiting = [...this.planned.keys()];
    const work = async (): Promise<void> => {
      for (let next = waiting.shift(); next !== undefined; next = waiting.shift()) await this.drawOne(next);
    };
    // Waits for all threads, so that none writes afterwards.
    await Promise.allSettled(Array.from({ length: Math.min(jobs, waiting.length) }, work));
    this.signal.throwIfAborted();
    return this.failed;
  }

  private async drawOne(index: number): Promise<void> {
    const { model, outputs } = this.planned[index];
    const { signal, files } = this;
    let began = performance.now();
    let writing = Promise.resolve();
    const onMessage = (message: DrawMessage): void => {
      if (message.kind === 'progress') this.show(index, message.stage, message.progress);
      else if (message.kind === 'note') this.tell(process.stderr, message.sentence);
      else if (message.kind === 'drawing') {
        const { frame, texts, counts } = message;
        writing = writing.then(async () => {
          for (const { ending, text } of texts) await files.write(withEnding(outputs[frame], ending), text);
          const now = performance.now();
          this.tell(this.counts, `${nameOf(outputs[frame])}: ${describe(counts, (now - began) / 1000)}`);
          if (this.hasPens)
            for (const layer of counts.layers)
              this.tell(this.counts, `${nameOf(outputs[frame])}, ${layer.name}: ${describeLayer(layer)}`);
          began = now;
        });
        // Marks the rejection as handled; the promise is awaited below.
        writing.catch(() => {});
      }
    };
    try {
      const { task, bytes } = await this.taskOf(model);
      const isWhole = await drawInThread(task, bytes, signal, onMessage);
      await writing;
      if (!isWhole) this.failed++;
    } catch (error) {
      await writing.catch(() => {});
      signal.throwIfAborted();
      this.failed++;
      this.tell(process.stderr, `three-hatching: ${(error as Error).message}`);
    }
    this.show(index, 'drawing', 1);
  }

  /**
   * The task for a thread, and the size of the model's file in bytes.
   *
   * @throws Error with a sentence if there is no model
   */
  private async taskOf(model: string): Promise<{ task: DrawTask; bytes: number }> {
    const { options, signal } = this;
    if (model !== STANDARD) return { task: { model, options }, bytes: await sizeOf(model) };
    const content = await readStandardInput(signal);
    return { task: { model: STANDARD_INPUT, options, content }, bytes: content.length };
  }

  private show(index: number, stage: string, progress: number): void {
    const { done, planned } = this;
    done[index] = progress;
    const count = planned.length === 1 ? '' : ` ${planned[index].model}`;
    this.bar.show(`${stage}${count}`, done.reduce((sum, share) => sum + share, 0) / done.length);
  }

  private tell(stream: NodeJS.WriteStream, line: string): void {
    this.bar.clear();
    // Names may contain control characters, which would move the cursor.
    stream.write(`${shownText(line)}\n`);
  }
}

/**
 * The size of a model's file in bytes.
 *
 * @throws Error with a sentence if it is no file
 */
async function sizeOf(model: string): Promise<number> {
  const found = await stat(model).catch((error: NodeJS.ErrnoException) => {
    throw new Error(
      error.code === 'ENOENT'
        ? `${model} is not there${whyNotThere(model)}.`
        : `${model} cannot be read (${error.code}).`,
    );
  });
  if (found.isDirectory())
    throw new Error(`${model} is a folder; name models in it, as "${join(model, '*.glb')}" in quotes.`);
  if (!found.isFile()) throw new Error(`${model} is no file.`);
  return found.size;
}

/** Likely reasons for a missing file, other than a mistyped name. */
function whyNotThere(model: string): string {
  if (/^https?:/i.test(model)) return ': nothing is fetched, so save the file first';
  return model.startsWith('~') ? ': shells expand ~ only outside of quotes' : '';
}

const inMetres = (millimetres: number): string => `${(millimetres / 1000).toFixed(2)} m`;

const nameOf = (output: string): string => (output === STANDARD ? 'the standard output' : output);

/** The path of a file with an ending of its name, before the extension. */
function withEnding(path: string, ending: string): string {
  if (ending === '') return path;
  const extension = extname(path);
  return `${path.slice(0, path.length - extension.length)}-${ending}${extension}`;
}

const countOf = (count: number, one: string): string =>
  `${count.toLocaleString('en')} ${count === 1 ? one : `${one}s`}`;

/** @param seconds since the start of the model, or since the previous frame */
function describe({ paths, drawn, travelBefore, travelAfter, plotSeconds }: DrawingCounts, seconds: number): string {
  const plotting = plotSeconds === null ? '' : ` ${plottingTime(plotSeconds)} to plot,`;
  return `${countOf(paths, 'path')}, ${inMetres(drawn)} drawn, ${inMetres(travelAfter)} of travel (${inMetres(travelBefore)} before ordering),${plotting} ${seconds.toFixed(1)} s.`;
}

const describeLayer = ({ paths, drawn, plotSeconds }: CountedLayer): string =>
  `${countOf(paths, 'path')}, ${inMetres(drawn)}${plotSeconds === null ? '' : `, ${plottingTime(plotSeconds)}`}`;

/** A model to draw in a worker thread. */
export interface DrawTask {
  /** The path of the model's file, or its name where `content` is given. */
  model: string;
  /** The bytes of the file; read from `model` if left out. */
  content?: Uint8Array;
  options: DrawingOptions;
}

/** Counts of one drawing. Lengths are in millimetres. */
export interface DrawingCounts {
  paths: number;
  drawn: number;
  travelBefore: number;
  travelAfter: number;
  /** The estimated time of plotting; null for a print. */
  plotSeconds: number | null;
  layers: readonly CountedLayer[];
}

/** Counts of one layer of a drawing. */
type CountedLayer = Pick<SVGDrawingLayer, 'name' | 'paths' | 'drawn' | 'plotSeconds'>;

/** A message from the thread: progress, a note for the user, a drawing, or the result. */
export type DrawMessage =
  | { kind: 'progress'; stage: string; progress: number; bytes?: number | undefined }
  | { kind: 'note'; sentence: string }
  | { kind: 'drawing'; frame: number; texts: readonly { ending: string; text: string }[]; counts: DrawingCounts }
  | { kind: 'done'; isWhole: boolean }
  | { kind: 'failed'; sentence: string };

/** A reader without progress is stopped after this multiple of its time limit on the page. */
const PATIENCE = 4;

/** The script of the threads, in the command's own folder. */
const SCRIPT = join(dirname(fileURLToPath(import.meta.url)), 'draw.worker.js');

/**
 * Draws a model in a worker thread, because some files keep a parser busy for minutes or use up the memory. A thread can be stopped at any
 * time, and its failure does not affect other models.
 *
 * @param bytes of the model's file
 * @param onMessage receives the thread's messages; what it returns is awaited before this function ends
 * @returns whether the drawing is complete
 * @throws Error whose message is a sentence about the model, or the reason of the signal
 */
async function drawInThread(
  task: DrawTask,
  bytes: number,
  signal: AbortSignal,
  onMessage: (message: DrawMessage) => void,
): Promise<boolean> {
  signal.throwIfAborted();
  // Keeps the loaders' console output from the user.
  const worker = new Worker(SCRIPT, { workerData: task, stdout: true, stderr: true });
  let timer: NodeJS.Timeout | undefined;
  let onAbort = (): void => {};
  try {
    return await new Promise<boolean>((resolve, reject) => {
      onAbort = () => reject(signal.reason);
      signal.addEventListener('abort', onAbort, { once: true });
      let size = bytes;
      const wait = (): void => {
        clearTimeout(timer);
        const seconds = PATIENCE * Math.ceil(readingTime(size));
        const sentence = `${task.model} was put aside, because there was no progress for ${seconds} seconds.`;
        timer = setTimeout(() => reject(new Error(sentence)), 1000 * seconds);
      };
      wait();
      worker.on('error', (error) => reject(new Error(whyEnded(task.model, error))));
      worker.on('exit', () => reject(new Error(`${task.model} could not be drawn: its thread has ended.`)));
      worker.on('message', (message: DrawMessage) => {
        if (message.kind === 'progress') size = Math.max(size, message.bytes ?? 0);
        wait();
        if (message.kind === 'done') resolve(message.isWhole);
        else if (message.kind === 'failed') reject(new Error(message.sentence));
        else onMessage(message);
      });
    });
  } finally {
    clearTimeout(timer);
    signal.removeEventListener('abort', onAbort);
    await worker.terminate();
  }
}

function whyEnded(model: string, error: NodeJS.ErrnoException): string {
  if (error.code === 'ERR_WORKER_OUT_OF_MEMORY')
    return `${model} needs more memory than there is; give Node more with NODE_OPTIONS=--max-old-space-size=8192, say.`;
  return `${model} could not be drawn (${error.message}).`;
}
