/** A table in Markdown whose columns are aligned, so that it can be read in a terminal too. The first row is the head. */
export function table(rows) {
  const widths = rows[0].map((_, column) => Math.max(...rows.map((row) => row[column].length), 2));
  const line = (row) =>
    `| ${row.map((cell, i) => (i === 0 ? cell.padEnd(widths[i]) : cell.padStart(widths[i]))).join(' | ')} |`;
  const rule = `| ${widths.map((width, i) => (i === 0 ? '-'.repeat(width) : `${'-'.repeat(width - 1)}:`)).join(' | ')} |`;
  return [line(rows[0]), rule, ...rows.slice(1).map(line)].join('\n');
}

/** Times on a shared machine are good for three digits. @param {number | undefined} value */
export function figure(value) {
  if (value === undefined) return '';
  return Math.abs(value) >= 100 ? value.toFixed(0) : String(Number(value.toPrecision(3)));
}

/**
 * A ratio or an exponent with its interval; empty where there is none, as for a phase that takes no time. NaN
 * becomes null in a JSON file.
 *
 * @param {readonly (number | null)[]} interval
 * @param {number} [digits] - after the point
 */
export const withInterval = (interval, digits = 2) => {
  if (!interval.every(Number.isFinite)) return '';
  const [value, low, high] = interval.map((number) => number.toFixed(digits));
  return `${value} [${low}, ${high}]`;
};
