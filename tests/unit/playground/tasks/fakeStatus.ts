import { Status } from '../../../../src/playground/tasks/Status.js';

/** A status line without a page: its text, whether it is an error, and whether the progress bar is shown. */
export function fakeStatus() {
  const classes = new Set<string>();
  const message = {
    textContent: '',
    classList: { toggle: (name: string, on: boolean) => (on ? classes.add(name) : classes.delete(name)) },
  };
  const progress = { hidden: true };
  const cancel = Object.assign(new EventTarget(), { hidden: true });
  const mend = Object.assign(new EventTarget(), { hidden: true, textContent: '' });
  const elements = { message, progress, progressLine: { style: { transform: '' } }, cancel, mend };
  const status = new Status(elements as never);
  return {
    status,
    get text() {
      return message.textContent;
    },
    get isError() {
      return classes.has('is-error');
    },
    get isWorking() {
      return !progress.hidden && !cancel.hidden;
    },
    /** What the button offers that mends a problem; undefined if it is hidden. */
    get remedy() {
      return mend.hidden ? undefined : mend.textContent;
    },
    mend: () => mend.dispatchEvent(new Event('click')),
    cancel: () => cancel.dispatchEvent(new Event('click')),
  };
}
