/** The messages from the client to the worker. `id` is the client's number for a request. */
export type ToWorker =
  | { type: 'run'; id: number; task: string; request: unknown }
  /** Stops the request. The worker sends no reply. */
  | { type: 'abort'; id: number }
  /** Asks for a sign of life. */
  | { type: 'ping' };

/** The messages from the worker to the client. */
export type FromWorker =
  /** The first message: the script has loaded, and requests may be posted. The worker holds `lock` as long as it lives. */
  | { type: 'ready'; lock?: string | undefined }
  /** The answer to `ping`, between two slices of work. */
  | { type: 'alive' }
  | { type: 'progress'; id: number; progress: number }
  | { type: 'done'; id: number; result: unknown }
  | { type: 'failed'; id: number; error: TransportedError };

/** An error as plain data. Structured clones of errors would differ between browsers. */
export interface TransportedError {
  name: string;
  message: string;
}

const errorClasses: Record<string, ErrorConstructor> = { Error, RangeError, TypeError };

export function packError(error: unknown): TransportedError {
  if (error instanceof Error) return { name: error.name, message: error.message };
  return { name: 'Error', message: String(error) };
}

/** Rebuilds the error as an instance of its class if that is one of `errorClasses`, otherwise as an Error of the same name. */
export function unpackError({ name, message }: TransportedError): Error {
  const error = new (errorClasses[name] ?? Error)(message);
  error.name = name;
  return error;
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
