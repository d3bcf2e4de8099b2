const MOST = 40;

/** A user's name for something, in one line, without control characters, and shortened to the maximum length. */
export function plainName(text: string): string {
  const visible = text.replace(/[\p{Cc}\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069]+/gu, ' ').replace(/\s+/g, ' ');
  return [...visible.trim()].slice(0, MOST).join('').trim();
}
