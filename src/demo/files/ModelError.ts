import { errorMessage } from './errorMessage.js';

/** A model that cannot be drawn. The message is one sentence for the user. */
export class ModelError extends Error {
  override readonly name = 'ModelError';
}

/** Wraps what was thrown while a file was read. A ModelError is returned as it is. */
export function toModelError(name: string, error: unknown): ModelError {
  if (error instanceof ModelError) return error;
  const reason = errorMessage(error)
    .replace(/^(THREE\.)?\w+:\s*/, '')
    .replace(/[.\s]+$/, '');
  return new ModelError(`${name} could not be read; it seems to be damaged (${reason}).`);
}
