import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach } from 'vitest';
import { drawModel } from '../../../../src/command/draw/drawModel.js';
import { failure } from '../../../../src/command/draw/failure.js';
import type { DrawMessage } from '../../../../src/command/draw.js';
import { type DrawingOptions, parseDrawing } from '../../../../src/command/parseDrawing.js';

/** The folder of the running test. */
export let work: string;

/** Gives each test of a file an empty folder. Files share this module, so each calls it. */
export function useWorkFolder(): void {
  beforeEach(() => {
    work = mkdtempSync(join(tmpdir(), 'three-hatching-'));
  });
  afterEach(() => rmSync(work, { recursive: true, force: true }));
}

export const optionsOf = (...args: string[]): DrawingOptions => {
  const small = args.includes('--sheet') ? [] : ['--sheet', '100x100'];
  const request = parseDrawing(['a', '--out', 'b', ...small, ...args]);
  if (request.action !== 'draw') throw new Error('It asks for help.');
  return request.options;
};

/** A sheet that is soon drawn. */
export const SMALL = ['--sheet', '40x40', '--no-shadows'] as const;

export interface Drawn {
  svgs: string[];
  notes: string[];
  isWhole: boolean;
  drawn: number[];
}

/** Draws a file that is written first. */
export async function draw(name: string, content: string | Uint8Array, ...args: string[]): Promise<Drawn> {
  writeFileSync(join(work, name), content);
  const messages: DrawMessage[] = [];
  const isWhole = await drawModel({ model: join(work, name), options: optionsOf(...args) }, (message) =>
    messages.push(message),
  );
  const drawings = messages.flatMap((message) => (message.kind === 'drawing' ? [message] : []));
  return {
    svgs: drawings.flatMap(({ texts }) => texts.map(({ text }) => text)),
    drawn: drawings.map(({ counts }) => counts.drawn),
    notes: messages.flatMap((message) => (message.kind === 'note' ? [message.sentence] : [])),
    isWhole,
  };
}

export const refusal = async (name: string, content: string | Uint8Array, ...args: string[]): Promise<string> => {
  const error = await draw(name, content, ...args).then(
    () => new Error('It was drawn.'),
    (reason) => reason,
  );
  return failure(join(work, name), error);
};
