/** A long computation that a worker can run. Requests and results are plain data. */
export interface Task<Request, Result> {
  /** Loads what the task needs before it runs, such as code of others. */
  prepare?(request: Request): Promise<void>;
  /** Yields its progress in [0, 1] every few milliseconds of work. */
  run(request: Request): Generator<number, Result, void>;
  /** The buffers that are transferred back with the result. */
  resultBuffers(result: Result): ArrayBuffer[];
}

/** Tasks by name, of any types. */
export type Tasks = Readonly<
  Record<
    string,
    {
      prepare?(request: never): Promise<void>;
      run(request: never): Generator<number, unknown, void>;
      resultBuffers(result: never): ArrayBuffer[];
    }
  >
>;
export type NameIn<All extends Tasks> = keyof All & string;
export type RequestOf<All extends Tasks, Name extends keyof All> = Parameters<All[Name]['run']>[0];
export type ResultOf<All extends Tasks, Name extends keyof All> = Parameters<All[Name]['resultBuffers']>[0];

/** A task without its types, which whoever asks for it has checked. */
export type AnyTask = Task<unknown, unknown>;

/** All that workers of one kind can run. */
export interface TaskSet<All extends Tasks> {
  /** Fetches the tasks, for a thread without workers: their scripts contain them, and most pages need them only there. */
  fetchTasks(): Promise<All>;
  /** The buffers that are transferred with a request, so that the sender loses them. */
  requestBuffers: { [Name in keyof All]: (request: RequestOf<All, Name>) => ArrayBuffer[] };
  /** Fetches the function that creates the worker which is inlined in the library. */
  fetchWorker(): Promise<() => Worker>;
}
