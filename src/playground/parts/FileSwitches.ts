import { FILE_CHANGE_KINDS, type FileChange, type FileChangeKind } from '../../viewer/files/common/fileChanges.js';
import { shownText } from '../../viewer/files/common/ModelError.js';
import { element, findElement } from '../page/elements.js';

/** What is said of a file that is left as it is written. */
const LEFT: Readonly<Record<Exclude<FileChangeKind, 'sides'>, string>> = {
  orientation: 'its faces point where the file says',
  up: 'it lies as in the file',
  hidden: 'parts that are hidden in the file are shown',
  ceiling: 'its rooms are closed by their ceiling',
};

/** What was done to the shown file, and what is switched from the usual. */
interface ChangedFile {
  readonly changes: readonly FileChange[];
  readonly switched: readonly FileChangeKind[];
  /** Whether backs of its surfaces are hidden that could be seen. */
  readonly hidesBacks: boolean;
}

/** Whether a kind of change is usually made. */
const isUsual = (kind: FileChangeKind): boolean => kind !== 'sides';

/**
 * The switches behind “i”: one for each kind of change that was made to the file, and one to draw the backs of its surfaces. The file is
 * read again with what is on.
 */
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

  /** @param onSwitch called with the kinds of changes that are switched from what is usual, in the order of `FILE_CHANGE_KINDS` */
  constructor(
    private readonly file: () => ChangedFile,
    onSwitch: (switched: FileChangeKind[]) => void,
  ) {
    for (const { box, item } of this.switches.values()) {
      this.list.append(item);
      box.addEventListener('change', () =>
        onSwitch(
          [...this.switches]
            .filter(([kind, { box, item }]) => !item.hidden && box.checked !== isUsual(kind))
            .map(([kind]) => kind),
        ),
      );
    }
  }

  /** Call this when another file is shown, or the same one in another way. */
  refresh(): void {
    const { changes, switched, hidesBacks } = this.file();
    for (const [kind, { box, text, item }] of this.switches) {
      const sentences = changes.filter((change) => change.kind === kind).map(({ sentence }) => shownText(sentence));
      const isSwitched = switched.includes(kind);
      box.checked = isSwitched !== isUsual(kind);
      item.hidden = !isSwitched && !(kind === 'sides' ? hidesBacks : sentences.length > 0);
      if (kind === 'sides') text.textContent = 'Draw both sides';
      else text.textContent = isSwitched ? LEFT[kind] : sentences.join('; ');
    }
    this.list.hidden = [...this.switches.values()].every(({ item }) => item.hidden);
  }
}
