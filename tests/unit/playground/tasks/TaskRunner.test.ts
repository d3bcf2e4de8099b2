import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { TaskRunner } from '../../../../src/playground/tasks/TaskRunner.js';
import { LostContextError } from '../../../../src/playground/viewport/ContextLoss.js';
import { ModelError } from '../../../../src/viewer/files/common/ModelError.js';
import { fakeStatus } from './fakeStatus.js';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

/** A task that ends when it is told to. */
function openTask() {
  let end = (_error?: Error): void => {};
  const ended = new Promise<void>((resolve, reject) => {
    end = (error) => (error ? reject(error) : resolve());
  });
  return { task: () => ended, end };
}

function makePage({ hasDrawing = false } = {}) {
  const line = fakeStatus();
  const state = { hasDrawing, idle: 0 };
  const tasks = new TaskRunner(line.status, {
    hasDrawing: () => state.hasDrawing,
    onIdle: () => void state.idle++,
  });
  return { line, state, tasks };
}

describe('the status line', () => {
  test.each([
    ['before', true],
    ['after', false],
  ])(
    'shows what a loss of the context has cost, with its remedy, where the loss itself is noticed %s it',
    (_, isFirst) => {
      const line = fakeStatus();
      const lose = () => line.status.addProblem('context', 'The graphics card has let go.');
      if (isFirst) lose();
      line.status.addProblem('video', 'There is no video.', { label: 'Record it again', run: () => {} });
      if (!isFirst) lose();
      expect([line.text, line.remedy]).toEqual(['There is no video.', 'Record it again']);
      line.status.solveProblem('video');
      expect([line.text, line.remedy]).toEqual(['The graphics card has let go.', undefined]);
    },
  );

  test('shows a message for its seconds: only a new task of the user replaces it', async () => {
    const { line, tasks } = makePage({ hasDrawing: true });
    const reports: ((viewport: string) => void)[] = [];
    const begin = (slot: 'map' | 'occlusion') => {
      const { task, end } = openTask();
      const run = tasks.run(slot, (report) => {
        reports.push(report);
        report('at work');
        return task();
      });
      return { run, end };
    };
    const map = begin('map');
    line.status.say('Copied.');
    reports[0]('drawing strokes');
    expect([line.text, line.isWorking]).toEqual(['Copied.', true]);
    const hollows = begin('occlusion');
    map.end();
    await map.run;
    reports[1]('darkening hollows');
    expect([line.text, line.isWorking]).toEqual(['Copied.', true]);
    vi.advanceTimersByTime(6000);
    reports[1]('darkening hollows');
    expect(line.text).toBe('Darkening hollows…');
    line.status.say('Copied.');
    const next = begin('map');
    expect(line.text).toBe('At work…');
    line.status.say('Copied.');
    next.end();
    hollows.end();
    await Promise.all([next.run, hollows.run]);
    expect([line.text, line.isWorking]).toEqual(['Copied.', false]);
  });

  test('keeps an initial failure, whatever other tasks report', async () => {
    const { line, state, tasks } = makePage();
    const map = openTask();
    let report = (_stage: string): void => {};
    const map1 = tasks.run('map', (give) => {
      report = give;
      return map.task();
    });
    await tasks.run('model', () => Promise.reject(new ModelError('The dragon could not be fetched.')));
    expect(line.text).toBe('The dragon could not be fetched.');
    report('drawing strokes');
    expect(line.text).toBe('The dragon could not be fetched.');
    expect(line.isWorking).toBe(true);
    map.end();
    await map1;
    expect([line.text, line.isError, line.isWorking, state.idle]).toEqual([
      'The dragon could not be fetched.',
      true,
      false,
      1,
    ]);
  });

  test('keeps a failure until a choice solves it', async () => {
    const { line, tasks } = makePage();
    await tasks.run('model', () => Promise.reject(new ModelError('No model.')));
    await tasks.run('map', async () => {});
    expect(line.text).toBe('No model.');
    line.status.say('The link is on the clipboard.');
    expect([line.text, line.isError]).toEqual(['The link is on the clipboard.', false]);
    vi.advanceTimersByTime(7000);
    expect([line.text, line.isError]).toEqual(['No model.', true]);
    const model = openTask();
    const end = tasks.run('model', model.task);
    expect(line.isError).toBe(false);
    model.end();
    expect(await end).toBe('done');
    expect([line.text, line.isError]).toEqual(['', false]);
  });

  test('shows two failures, one after the other', async () => {
    const { line, tasks } = makePage();
    await tasks.run('model', () => Promise.reject(new ModelError('No model.')));
    await tasks.run('map', () => Promise.reject(new Error('seed is 1.5')));
    expect(line.text).toBe('That did not work: seed is 1.5');
    await tasks.run('map', async () => {});
    expect(line.text).toBe('No model.');
  });

  test('with a drawing, forgets a failure at the user’s next task, but not at one of the page', async () => {
    const { line, tasks } = makePage({ hasDrawing: true });
    await tasks.run('model', () => Promise.reject(new ModelError('letter.txt is no model.')));
    await tasks.run('occlusion', async () => {});
    expect(line.text).toBe('letter.txt is no model.');
    await tasks.run('map', async () => {});
    expect(line.text).toBe('');
  });

  test('says after a cancelled start that there is no drawing, and goes on saying so', async () => {
    const { line, tasks } = makePage();
    const model = openTask();
    const end = tasks.run('model', model.task);
    await tasks.run('map', async (report) => report('drawing strokes'));
    line.cancel();
    model.end();
    expect(await end).toBe('failed');
    vi.advanceTimersByTime(7000);
    expect(line.text).toMatch(/^Cancelled, so there is no drawing yet/);
  });

  test('shows no message about an obsolete task that is stopped', async () => {
    const { line, tasks } = makePage({ hasDrawing: true });
    const occlusion = openTask();
    let signal: AbortSignal | undefined;
    const end = tasks.run('occlusion', (report, given) => {
      report('darkening hollows');
      signal = given;
      return occlusion.task();
    });
    expect(line.isWorking).toBe(true);
    tasks.stop('occlusion');
    expect([signal!.aborted, tasks.isIdle, line.isWorking, line.text]).toEqual([true, true, false, '']);
    occlusion.end(new Error('aborted'));
    expect(await end).toBe('replaced');
    expect(line.text).toBe('');
  });

  test('does not show the URL of a missing script', async () => {
    const { line, tasks } = makePage();
    await tasks.run('map', () =>
      Promise.reject(new TypeError('Failed to fetch dynamically imported module: http://x/a.js')),
    );
    expect(line.text).toMatch(/^A part of this page could not be fetched\./);
  });

  test('offers to repeat a task that failed with a lost context, once no task runs', async () => {
    const { line, tasks } = makePage({ hasDrawing: true });
    let tries = 0;
    const again = { label: 'Save it again', run: () => void tries++ };
    await tasks.run('picture', () => Promise.reject(new Error('That is too large.')), again);
    expect([line.text, line.remedy]).toEqual(['That did not work: That is too large.', undefined]);
    const occlusion = openTask();
    const end = tasks.run('occlusion', occlusion.task);
    line.status.addProblem('context', 'Lost.');
    await tasks.run('picture', () => Promise.reject(new LostContextError('Gone.')), again);
    expect(line.text).toBe('That did not work: Gone.');
    expect(line.remedy).toBeUndefined();
    occlusion.end();
    await end;
    expect(line.remedy).toBe('Save it again');
    line.status.say('The link is on the clipboard.');
    expect(line.remedy).toBeUndefined();
    line.status.solveProblem('context', 'The drawing is back.');
    expect([line.text, line.isError, line.remedy]).toEqual(['That did not work: Gone.', true, 'Save it again']);
    line.mend();
    expect(tries).toBe(1);
    await tasks.run('picture', async () => {}, again);
    expect([line.text, line.remedy]).toEqual(['', undefined]);
  });

  test('a lost context is shown until it is restored, whatever ends meanwhile', async () => {
    const { line, tasks } = makePage({ hasDrawing: true });
    line.status.addProblem('context', 'Lost.');
    await tasks.run('model', async (report) => report('joining'));
    expect([line.text, line.isError]).toEqual(['Lost.', true]);
    line.status.solveProblem('context', 'It is back.');
    expect([line.text, line.isError]).toEqual(['It is back.', false]);
  });
});

describe('a background task', () => {
  const settled = async (promise: Promise<void> | undefined): Promise<boolean> => {
    let isSettled = false;
    void promise?.then(() => {
      isSettled = true;
    });
    for (let i = 0; i < 10; i++) await Promise.resolve();
    return isSettled;
  };

  test('resumes when the last of the others has ended, not when one is replaced', async () => {
    const { tasks } = makePage();
    const own = new AbortController().signal;
    const [occlusion, first, second, model] = [openTask(), openTask(), openTask(), openTask()];
    void tasks.run('occlusion', occlusion.task);
    expect(tasks.others('occlusion', own)).toBeUndefined();
    const running = [tasks.run('map', first.task), tasks.run('model', model.task)];
    const others = tasks.others('occlusion', own);
    running.push(tasks.run('map', second.task));
    first.end();
    await running[0];
    model.end();
    await running[1];
    expect(await settled(others)).toBe(false);
    second.end();
    await running[2];
    expect(await settled(others)).toBe(true);
    expect(tasks.others('occlusion', own)).toBeUndefined();
  });

  test('goes on to its end when it is aborted, or when the others are stopped', async () => {
    const { tasks } = makePage();
    const controller = new AbortController();
    void tasks.run('map', openTask().task);
    const aborted = tasks.others('occlusion', controller.signal);
    const stopped = tasks.others('occlusion', new AbortController().signal);
    controller.abort();
    expect(await settled(aborted)).toBe(true);
    expect(await settled(stopped)).toBe(false);
    tasks.stop('map');
    expect(await settled(stopped)).toBe(true);
  });
});
