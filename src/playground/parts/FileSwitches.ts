import { FILE_CHANGE_KINDS, type FileChange, type FileChangeKind } from '../../viewer/files/common/fileChanges.js';
import { shownText } from '../../viewer/files/common/ModelError.js';
import { element, findElement } from '../page/elements.js';

/** What is said of a file that is left as it is written. */
const LEFT: Readonly<Record<FileChangeKind, string>> = {
  orientation: 'its faces point where the file says',
  sides: 'its surfaces have the sides that the file says',
  up: 'it lies as in the file',
  hidden: 'parts that are hidden in the file are shown',
};

/** What was done to the shown file, and is left on request. */
interface ChangedFile {
  readonly changes: readonly FileChange[];
  readonly asWritten: readonly FileChangeKind[];
}

/** The switches behind “i”: one for each kind of change that was made to the file. Turned off, the file is read without it. */
export class FileSwitches {
  private readonly list = findElement('model-changes');
  private readonly switches = new Map(
    FILE_CHANGE_KINDS.map((kind) => {
      const box = element('input', { type: 'checkbox' });
      box.setAttribute('role', 'switch');
      const text = element('span');
      return [kind, { box, text, item: element('li', { hidden: true }, element('label', {}, box, ' ', text)) }];
    }),
  );

  /** @param onSwitch called with the kinds of changes to leave out, in the order of `FILE_CHANGE_KINDS` */
  constructor(
    private readonly file: () => ChangedFile,
    onSwitch: (asWritten: FileChangeKind[]) => void,
  ) {
    for (const { box, item } of this.switches.values()) {
      this.list.append(item);
      box.addEventListener('change', () =>
        onSwitch([...this.switches].filter(([, { box, item }]) => !item.hidden && !box.checked).map(([kind]) => kind)),
      );
    }
  }

  /** Call this when another file is shown, or the same one in another way. */
  refresh(): void {
    const { changes, asWritten } = this.file();
    for (const [kind, { box, text, item }] of this.switches) {
      const sentences = changes.filter((change) => change.kind === kind).map(({ sentence }) => shownText(sentence));
      const isLeft = asWritten.includes(kind);
      item.hidden = !isLeft && sentences.length === 0;
      box.checked = !isLeft;
      text.textContent = isLeft ? LEFT[kind] : sentences.join('; ');
    }
    this.list.hidden = [...this.switches.values()].every(({ item }) => item.hidden);
  }
}
