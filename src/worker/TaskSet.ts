/** A long computation that a worker can run. Requests and results are plain data; the arrays of a result are transferred. */
export interface Task<Request, Result> {
  /** Loads what the task needs before it runs, such as third-party code. */
  prepare?: ((request: Request) => Promise<void>) | undefined;
  /** Yields its progress in [0, 1] every few milliseconds of work. */
  run(request: Request): Generator<number, Result, void>;
}

/** Tasks by name, of any types. */
export type Tasks = Readonly<
  Record<
    string,
    {
      prepare?: ((request: never) => Promise<void>) | undefined;
      run(request: never): Generator<number, unknown, void>;
    }
  >
>;
export type NameIn<All extends Tasks> = keyof All & string;
export type RequestOf<All extends Tasks, Name extends keyof All> = Parameters<All[Name]['run']>[0];
export type ResultOf<All extends Tasks, Name extends keyof All> =
  ReturnType<All[Name]['run']> extends Generator<number, infer Result, void> ? Result : never;

/** A task without its types, which the caller has checked. */
export type AnyTask = Task<unknown, unknown>;

/** The tasks that workers of one kind can run. */
export interface TaskSet<All extends Tasks> {
  /** Loads the tasks for the main thread, where there are no workers. Worker scripts contain them, so most pages never load them. */
  fetchTasks(): Promise<All>;
  /** The buffers that are transferred with a request, so that the sender loses them. */
  requestBuffers: { [Name in keyof All]: (request: RequestOf<All, Name>) => ArrayBuffer[] };
  /** Loads the function that creates the inlined worker for a task. */
  fetchWorker(task: NameIn<All>): Promise<() => Worker>;
}

/** The buffers of all typed arrays in plain data, each once. A message with the data can transfer them. */
export function buffersIn(data: unknown): ArrayBuffer[] {
  const found = new Set<ArrayBuffer>();
  const visit = (value: unknown): void => {
    if (typeof value !== 'object' || value === null) return;
    if (!ArrayBuffer.isView(value)) Object.values(value).forEach(visit);
    else if (value.buffer instanceof ArrayBuffer) found.add(value.buffer);
  };
  visit(data);
  return [...found];
}
