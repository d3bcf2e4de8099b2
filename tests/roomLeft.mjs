/**
 * How much of its room a number has left before its limit: 1 far away, 0 at the limit.
 *
 * The room below a limit is the limit itself. The room above one is the limit too, but for a share that must be nearly 1: there it is what the limit
 * leaves of 1.
 *
 * @param {import('./browser/recordLimits.js').LimitRecord} record
 * @returns {number}
 */
export function roomLeft({ matcher, value, limit, digits = 2 }) {
  if (matcher === 'toBeCloseTo') return Math.max(0, 1 - Math.abs(value - limit) / (10 ** -digits / 2));
  const isShare = limit > 0.5 && limit < 1 && value <= 1;
  const isBelow = matcher.startsWith('toBeLess');
  const room = !isBelow && isShare ? 1 - limit : Math.abs(limit);
  if (room === 0) return 1;
  return Math.min(1, Math.max(0, (isBelow ? limit - value : value - limit) / room));
}
