/** A model that cannot be drawn. The message is one sentence for the person at the page. */
export class ModelError extends Error {
  override readonly name = 'ModelError';
}

/** What went wrong while a file was read, as a sentence; a ModelError is one already. */
export function toModelError(name: string, error: unknown): ModelError {
  if (error instanceof ModelError) return error;
  const reason =
    error instanceof Error ? error.message.replace(/^(THREE\.)?\w+:\s*/, '').replace(/[.\s]+$/, '') : String(error);
  return new ModelError(`${name} could not be read; it seems to be damaged (${reason}).`);
}
