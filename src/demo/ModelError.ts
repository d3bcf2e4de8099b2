/** A model that cannot be drawn. The message is one sentence for the person at the page. */
export class ModelError extends Error {
  override readonly name = 'ModelError';
}
