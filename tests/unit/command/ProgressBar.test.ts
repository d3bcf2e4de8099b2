import { describe, expect, it } from 'vitest';
import { ProgressBar } from '../../../src/command/standardStreams.js';

/** A stream that keeps what is written. */
function stream(isTTY: boolean): NodeJS.WriteStream & { written: string[] } {
  const written: string[] = [];
  return { isTTY, written, write: (text: string) => written.push(text) > 0 } as never;
}

describe('ProgressBar', () => {
  it('fills from left to right, once per per cent, and is erased', () => {
    const terminal = stream(true);
    const bar = new ProgressBar(terminal);
    for (const progress of [0, 0.5, 0.501, 1]) bar.show('drawing', progress);
    bar.clear();
    const filled = terminal.written.slice(0, 3).map((line) => line.split('█').length - 1);
    expect(filled).toEqual([0, 15, 30]);
    expect(terminal.written[1]).toContain(' 50 % drawing');
    expect(terminal.written).toHaveLength(4);
    expect(terminal.written.at(-1)).toBe('\r\x1b[K');
  });

  it('prints nothing to a log', () => {
    const log = stream(false);
    const bar = new ProgressBar(log);
    bar.show('drawing', 0.5);
    bar.clear();
    expect(log.written).toEqual([]);
  });
});
