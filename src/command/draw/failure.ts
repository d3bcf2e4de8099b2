import { basename } from 'node:path';
import { plainSentence } from './plainSentence.js';

/** Describes an error in a sentence that names the model. */
export function failure(model: string, error: unknown): string {
  const { code, name, message = String(error) } = error as NodeJS.ErrnoException;
  if (code === 'ERR_MODULE_NOT_FOUND')
    return `${model} needs a newer three: the one that is installed does not read its format.`;
  if (name === 'ModelError') return named(model, plainSentence(message));
  if (code !== undefined) return `${model} cannot be read (${code}).`;
  return `${model} could not be drawn: ${message.replace(/\.$/, '')}.`;
}

const named = (model: string, sentence: string): string =>
  sentence.includes(basename(model)) ? sentence : `${model}: ${sentence}`;
