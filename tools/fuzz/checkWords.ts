/** What JavaScript says where a sentence should be. */
const INTERNALS =
  /undefined|\bnull\b|NaN|not a function|not iterable|Cannot |is not defined|TypeError|RangeError|ReferenceError|SyntaxError|\[object|THREE\.|Invalid (array|typed)|out of bounds|offset is outside|JSON at|Unexpected (token|end)/;

/** @throws Error if JavaScript speaks in what users are told */
export function checkWords(text: string): void {
  // What stands in quotes was in the file.
  if (INTERNALS.test(text.replace(/"[^"]*…?"?/g, ''))) throw new Error(`JavaScript speaks: ${text}`);
}

/** @throws Error if a refusal is not one plain sentence */
export function checkSentence(sentence: string): void {
  checkWords(sentence);
  if (!/^\S.{5,400}\.$/s.test(sentence)) throw new Error(`No sentence: ${JSON.stringify(sentence)}`);
}
