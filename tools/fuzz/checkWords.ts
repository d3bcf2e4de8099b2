/** Texts of JavaScript that users should never read. */
const INTERNALS =
  /undefined|\bnull\b|NaN|not a function|not iterable|Cannot |is not defined|TypeError|RangeError|ReferenceError|SyntaxError|\[object|THREE\.|Invalid (array|typed)|out of bounds|offset is outside|JSON at|Unexpected (token|end)/;

/** @throws Error if a message to users has a text of JavaScript in it */
export function checkWords(text: string): void {
  // Text in quotes is from the file.
  if (INTERNALS.test(text.replace(/"[^"]*…?"?/g, '')))
    throw new Error(`A text of JavaScript is in the message: ${text}`);
}

/** @throws Error if a message of refusal is not one plain sentence */
export function checkSentence(sentence: string): void {
  checkWords(sentence);
  if (!/^\S.{5,400}\.$/s.test(sentence)) throw new Error(`This is not a sentence: ${JSON.stringify(sentence)}`);
}
