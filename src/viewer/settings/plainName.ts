const MOST = 40;

/** A name that somebody has given, in one line: without characters that control how text runs, and not too long. */
export function plainName(text: string): string {
  const visible = text.replace(/[\p{Cc}\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069]+/gu, ' ').replace(/\s+/g, ' ');
  return [...visible.trim()].slice(0, MOST).join('').trim();
}
