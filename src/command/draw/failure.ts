import { basename } from 'node:path';

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

/** Phrases of the readers' messages, which address a user who drops files on a page, and their replacements for the command line. */
const WORDS: readonly [RegExp, string][] = [
  [/; drop both files together/, '; put both files into one folder'],
  [/no (pictures?) that a browser reads/, 'no $1 that can be read'],
  [/, which this page does not (read|unpack)/, ', which is not $1 here'],
  [/a later version of this page, which this one cannot read/, 'a later version of the playground'],
  [/(model )?(that )?this page can read/, '$1that can be read here'],
  [/for which a page has no memory/, 'for which three-hatching has no memory'],
  [/more memory than this page can get/, 'more memory than there is'],
  [/this page (reads|takes)/, 'three-hatching $1'],
  [
    /whose decoder could not be fetched\. Look after the connection, and open it again/,
    'whose decoder of three.js did not start',
  ],
];

/** Rewords a message of the readers for the command line. */
export function plainSentence(sentence: string): string {
  return WORDS.reduce((text, [words, others]) => text.replace(words, others), sentence).replace(
    /which is not (unpack) here/,
    'which is not unpacked here',
  );
}
