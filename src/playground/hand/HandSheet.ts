import type { HandNumbers, HandStroke } from 'three-hatching';
import { type ExampleHandName, exampleHand, exampleHandNames } from 'three-hatching/hands';
import { handLook, linesOfHand, lookWithoutHand } from '../../viewer/settings/handLook.js';
import { drawsWithMap } from '../../viewer/settings/settingValues.js';
import { download } from '../export/download.js';
import { element, textButton } from '../page/elements.js';
import { page } from '../page/page.js';
import { type SliderValue, ValueSlider } from '../page/ValueSlider.js';
import type { OwnHand } from '../session/DrawingState.js';
import type { Session } from '../session/Session.js';
import { HAND_NUMBER_NAMES, HAND_SLIDERS, inUnit, numberOfShown, shownNumber } from './handSliders.js';
import { changedNumbers, LEAST_STROKES, learnOwnHand, ownHandOf, withNumbers } from './ownHand.js';
import { SwatchCanvas, type SwatchTool } from './SwatchCanvas.js';
import { eraseStrokes, layOut, SWATCHES } from './swatches.js';

/** Pause before the map is redrawn, in milliseconds, in case another stroke or slider step follows. */
const PAUSE = 150;

/** Labels of the example hands. */
const GIVEN_HANDS: Readonly<Record<ExampleHandName, string>> = {
  brush: 'a pointed brush',
  dryBrush: 'a dry brush',
  reedPen: 'a reed pen',
  finePen: 'a steel pen',
  quill: 'a quill',
  ballpoint: 'a ballpoint',
  feltTip: 'a felt tip',
  softPencil: 'a soft pencil',
  crayon: 'a crayon',
  woodcut: 'a woodcut tool',
  scribble: 'a scribble',
  etchingNeedle: 'an etching needle',
};

const NONE: OwnHand = { strokes: [], hand: undefined, changed: {}, link: undefined, files: undefined };

/** The sheet beside the drawing, on which users draw a few strokes of their own hand. The model is hatched with them at once. */
export class HandSheet {
  private readonly swatches: SwatchCanvas;
  private readonly said = element('p', { className: 'hand-said' });
  private readonly tools: readonly (readonly [SwatchTool, HTMLButtonElement])[];
  private readonly undo = textButton('Undo', () => this.session.undo());
  private readonly clear = textButton('Clear', () => this.change([]), 'Clear the sheet');
  private readonly use = textButton('Draw with it', () => this.drawWithIt());
  private readonly save = textButton('Save', () => this.saveHand(), 'Save the hand as a file');
  private readonly given = element('select', {}, element('option', { value: '' }, 'an empty sheet'));
  private readonly asLearnt = textButton('As learnt', () => this.changeNumbers({}));
  private readonly numbers = element('fieldset', { className: 'motion hand-numbers', hidden: true });
  private readonly sliders: readonly ValueSlider[];
  private shown: OwnHand | undefined;
  /** The strokes of the present hand, laid out on the sheet. */
  private strokes: readonly HandStroke[] = [];
  /** The example hand that was chosen, as long as it is unchanged. */
  private chosen: OwnHand | undefined;
  private opener: Element | null = null;

  constructor(
    private readonly sheet: HTMLElement,
    private readonly session: Session,
  ) {
    this.swatches = new SwatchCanvas({
      drawn: (stroke) => this.change([...this.strokes, stroke]),
      rubbed: (x, y, radius) => this.rub(x, y, radius),
    });
    this.tools = (['pen', 'rubber'] as const).map((tool) => {
      const button = textButton(tool === 'pen' ? 'Pen' : 'Rubber', () => this.take(tool));
      return [tool, button] as const;
    });
    this.said.setAttribute('role', 'status');
    this.numbers.setAttribute('aria-label', 'What was learnt');
    this.sliders = HAND_NUMBER_NAMES.map(() => new ValueSlider(() => {}));
    this.build();
    this.take('pen');
    session.listen({ applied: () => this.refresh(), stepped: () => this.refresh() });
  }

  get isOpen(): boolean {
    return !this.sheet.hidden;
  }

  open(): void {
    if (this.isOpen) return;
    this.opener = document.activeElement;
    this.sheet.hidden = false;
    document.body.classList.add('has-hand-sheet');
    this.refresh();
    this.swatches.paint();
    this.sheet.querySelector('button')?.focus();
  }

  close(): void {
    if (!this.isOpen) return;
    this.sheet.hidden = true;
    document.body.classList.remove('has-hand-sheet');
    if (this.opener instanceof HTMLElement) this.opener.focus();
  }

  private get own(): OwnHand {
    return this.session.mapLoader.hand ?? NONE;
  }

  /** The numbers that stay when more strokes are drawn. */
  private get changed(): Partial<HandNumbers> {
    const { changed, hand } = this.own;
    return changed ?? (hand ? changedNumbers(hand) : {});
  }

  private build(): void {
    const title = element('h2', { id: 'hand-title' }, 'Your own hand');
    const penWidth = new ValueSlider(() => penWidth.update());
    const { swatches } = this;
    penWidth.show({
      ...{ name: 'Pen', hint: 'how wide it draws at half pressure', min: 0.1, max: 2, step: 0.05 },
      format: (value) => `${value.toFixed(2)} mm`,
      read: () => swatches.penWidth,
      write: (value) => {
        swatches.penWidth = value;
      },
    });
    const open = filePicker('Open a hand', '.json', (file) => {
      void this.session.mapLoader.showFiles([{ name: file.name, content: file }]);
    });
    const picture = filePicker('From a picture', 'image/png,image/jpeg', (file) => this.readPicture(file));
    for (const name of exampleHandNames) this.given.append(element('option', { value: name }, GIVEN_HANDS[name]));
    this.given.addEventListener('change', () => this.choose());
    const given = element('label', { className: 'hand-given' }, element('span', {}, 'Begin from'), this.given);
    const tools = element('p', { className: 'hand-tools' }, ...this.tools.map(([, button]) => button));
    tools.append(this.undo, this.clear);
    this.numbers.append(
      ...this.sliders.map(({ label }) => label),
      element('p', { className: 'hand-tools' }, this.asLearnt),
    );
    this.sheet.append(
      element(
        'header',
        { className: 'dialog-head' },
        title,
        textButton('Close', () => this.close()),
      ),
      element('p', {}, 'Hatch these fields with a pen, a finger or the mouse. One of them will do.'),
      tools,
      swatches.element,
      element('div', { className: 'motion hand-pen' }, penWidth.label),
      this.said,
      given,
      element('p', { className: 'hand-tools' }, this.use, this.save, ...open, ...picture),
      this.numbers,
    );
    this.sheet.addEventListener('drop', (event) => this.dropped(event));
    this.sheet.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.stopPropagation();
      this.close();
    });
    page.toggleCard.addEventListener('click', () => this.close());
  }

  /** Accepts a picture dropped on the sheet; other drops are left to the page. */
  private dropped(event: DragEvent): void {
    const [file, ...others] = event.dataTransfer?.files ?? [];
    if (!file || others.length > 0 || !/\.(png|jpe?g)$/i.test(file.name)) return;
    event.preventDefault();
    event.stopPropagation();
    page.drop.hidden = true;
    this.readPicture(file);
  }

  private readPicture(file: File): void {
    void this.session.mapLoader.tasks.run('map', async (report, signal) => {
      const { readPicture } = await import('./readPicture.js');
      const own = await readPicture(file, report, signal);
      if (!signal.aborted) this.takeOver(own);
    });
  }

  /** Starts from an example hand, or from an empty sheet. */
  private choose(): void {
    const name = exampleHandNames.find((given) => given === this.given.value);
    const hand = name && exampleHand(name);
    const own = hand && ownHandOf(hand, layOut(hand.strokes), {});
    this.chosen = own;
    this.takeOver(own);
  }

  private drawWithIt(): void {
    const { session, own } = this;
    if (own.hand) session.useLook(handLook(session.settings, own.hand));
  }

  private saveHand(): void {
    for (const { name, content } of this.own.files ?? []) download(content, name);
  }

  private take(tool: SwatchTool): void {
    this.swatches.tool = tool;
    for (const [name, button] of this.tools) button.setAttribute('aria-pressed', String(name === tool));
  }

  private rub(x: number, y: number, radius: number): void {
    const { strokes } = this;
    const left = eraseStrokes(strokes, x, y, radius);
    // One rubbing gesture is one step.
    if (left !== strokes) this.change(left, 'hand rubber');
  }

  /** Changes the strokes as a step of the history. */
  private change(strokes: readonly HandStroke[], source?: string): void {
    this.takeOver(learnOwnHand(strokes, strokes.length > 0 ? this.changed : {}), source);
  }

  private changeNumbers(changed: Partial<HandNumbers>, source?: string): void {
    const { own } = this;
    const isBack = Object.keys(changed).length === 0;
    this.takeOver(isBack ? learnOwnHand(this.strokes, {}) : withNumbers(own, changed), source);
  }

  private takeOver(next: OwnHand | undefined, source?: string): void {
    const { session } = this;
    const had = this.own.hand !== undefined;
    const { settings } = session;
    const hand = next?.hand;
    const lookWith = had ? linesOfHand : handLook;
    const look = hand ? lookWith(settings, hand) : lookWithoutHand(settings);
    session.handChanged(next, look, source);
    session.mapLoader.showChosenAfter(PAUSE);
  }

  /** Shows the page's present hand, and whether the drawing uses it. */
  private refresh(): void {
    if (!this.isOpen) return;
    const { own, session } = this;
    const { strokes, hand } = own;
    this.undo.disabled = !session.canUndo;
    this.clear.disabled = strokes.length === 0;
    const isDrawnWith = session.settings.mapStyle === 'ownHand' && drawsWithMap(session.settings);
    this.use.hidden = hand === undefined || isDrawnWith;
    this.save.disabled = hand === undefined;
    if (own === this.shown) return;
    this.shown = own;
    this.strokes = layOut(strokes);
    this.swatches.show(this.strokes, describe(strokes));
    if (own !== this.chosen) this.given.value = '';
    this.said.textContent = sentenceAbout(own);
    this.numbers.hidden = hand === undefined;
    this.asLearnt.disabled = own.changed !== undefined && Object.keys(own.changed).length === 0;
    if (!hand) return;
    HAND_NUMBER_NAMES.forEach((name, i) => {
      this.sliders[i].show(this.sliderOf(name));
    });
  }

  private sliderOf(name: keyof HandNumbers): SliderValue {
    const { label, about, min, max, step } = HAND_SLIDERS[name];
    return {
      ...{ name: label, hint: about, min, max, step },
      format: (shown) => inUnit(name, shown),
      read: () => shownNumber(name, this.own.hand?.numbers[name] ?? 0),
      write: (shown) => this.changeNumbers({ ...this.changed, [name]: numberOfShown(name, shown) }, `hand ${name}`),
      reset: () => {
        const { [name]: _, ...others } = this.changed;
        this.takeOver(learnOwnHand(this.strokes, others));
      },
    };
  }
}

/** A button that asks for a file, and the input that it needs. */
function filePicker(label: string, accept: string, onFile: (file: File) => void): [HTMLElement, HTMLElement] {
  const input = element('input', { type: 'file', accept, hidden: true });
  input.addEventListener('change', () => {
    const [file] = input.files ?? [];
    // Otherwise, picking the same file again would fire no event.
    input.value = '';
    if (file) onFile(file);
  });
  return [textButton(label, () => input.click()), input];
}

/** The accessible description of the sheet. */
function describe(strokes: readonly HandStroke[]): string {
  const counts = SWATCHES.map(({ tone, label }) => {
    const count = strokes.filter(({ swatch = 'middle' }) => swatch === tone).length;
    return `${label.toLowerCase()} ${count}`;
  });
  return `The sheet to draw on, with ${inWords(strokes.length)}: ${counts.join(', ')}`;
}

const inWords = (count: number): string => (count === 1 ? '1 stroke' : `${count} strokes`);

function sentenceAbout({ strokes, hand }: OwnHand): string {
  if (hand) return `${inWords(strokes.length)}: this is what they tell.`;
  const missing = LEAST_STROKES - strokes.length;
  if (missing > 0) {
    const had = strokes.length === 0 ? '' : `${inWords(strokes.length)}: `;
    return `${had}${strokes.length === 0 ? `${LEAST_STROKES} strokes are enough` : `${missing} more`} to begin with.`;
  }
  return 'These are dots: draw strokes that are longer than wide.';
}
