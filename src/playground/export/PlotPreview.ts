import { plottingTime, type SVGDrawing } from 'three-hatching/svg';
import { element, findElement, textButton } from '../page/elements.js';
import { PASS_COLORS, PlotSheet } from './PlotSheet.js';
import { downloadLines, type LineFile } from './saveSvg.js';

/** Seconds in which a whole plot is played. */
const PLAYED = 20;

/** A plot with the time of each path from the beginning of the whole, seconds. */
interface Plot {
  file: LineFile;
  sheet: PlotSheet;
  times: Float64Array;
}

/** Shows what a plotter will draw before it is saved: path by path, with its time and length by layer, and where ink lies several times. */
export class PlotPreview {
  private readonly dialog = findElement('plot') as HTMLDialogElement;
  private readonly scroller = findElement('plot-sheet');
  private readonly place = findElement('plot-place') as HTMLInputElement;
  private readonly said = findElement('plot-said');
  private readonly layers = findElement('plot-layers');
  private readonly inkMap = findElement('plot-ink') as HTMLInputElement;
  private readonly large = findElement('plot-large') as HTMLInputElement;
  private readonly play = textButton('Play', () => this.playOrPause());
  private readonly steps = [
    this.play,
    textButton('Back', () => this.goTo(this.place.valueAsNumber - 1), 'One path back'),
    textButton('On', () => this.goTo(this.place.valueAsNumber + 1), 'One path on'),
  ];
  private plot: Plot | undefined;
  /** The request of the next frame while the plot is played. */
  private frame = 0;

  /** @param onSaved called with a sentence after the file was saved */
  constructor(private readonly onSaved: (sentence: string) => void) {
    findElement('plot-steps').append(...this.steps);
    findElement('plot-actions').append(
      textButton('Save SVG', () => this.save()),
      textButton('Close', () => this.dialog.close()),
    );
    this.place.addEventListener('input', () => this.goTo(this.place.valueAsNumber));
    this.inkMap.addEventListener('change', () => this.showMapOrPlot());
    this.large.addEventListener('change', () => {
      this.scroller.classList.toggle('is-large', this.large.checked);
      const { scrollWidth, scrollHeight, clientWidth, clientHeight } = this.scroller;
      this.scroller.scrollTo((scrollWidth - clientWidth) / 2, (scrollHeight - clientHeight) / 2);
      // Focusable where it can be scrolled, so that the keyboard can scroll it.
      this.scroller.tabIndex = this.large.checked ? 0 : -1;
    });
    this.dialog.addEventListener('close', () => this.end());
  }

  /** Opens with a plot, all of it drawn. @param paper the colour of its sheet */
  open(file: LineFile, paper: string): void {
    const { drawing } = file;
    const sheet = new PlotSheet(drawing.svg, paper);
    this.plot = { file, sheet, times: timesOf(drawing) };
    sheet.canvas.setAttribute('role', 'img');
    this.scroller.replaceChildren(sheet.canvas);
    this.layers.replaceChildren(...rowsOf(drawing));
    Object.assign(this.place, { max: String(sheet.count), value: String(sheet.count) });
    this.inkMap.checked = false;
    this.dialog.showModal();
    this.showMapOrPlot();
  }

  /** Shows the ink map, all of it, or the plot, through which one can step. */
  private showMapOrPlot(): void {
    for (const control of [this.place, ...this.steps]) control.disabled = this.inkMap.checked;
    void this.refresh();
  }

  /** Shows the plot up to the chosen path, or its ink map. */
  private async refresh(): Promise<void> {
    const { plot, place } = this;
    if (!plot) return;
    const { sheet, times } = plot;
    if (this.inkMap.checked) {
      this.pause();
      this.say('Counting how often pens pass over each place …');
      const wet = await sheet.showPasses();
      if (wet !== null) this.sayPasses(wet);
      return;
    }
    const count = place.valueAsNumber;
    const seconds = count > 0 ? times[count - 1] : 0;
    const all = sheet.count.toLocaleString('en');
    this.say(`${minutes(seconds)} of ${minutes(times.at(-1) ?? 0)} min, path ${count.toLocaleString('en')} of ${all}`);
    await sheet.show(count);
  }

  private sayPasses(wet: number): void {
    const key = ['once', 'twice', 'three times or more'].map((words, i) => {
      const patch = element('span', { className: 'plot-patch' });
      patch.style.background = PASS_COLORS[i + 1];
      return element('span', {}, patch, ` ${words}${i < 2 ? ',' : '.'}`);
    });
    const share = `${(100 * wet).toFixed(1)} % of the ink lies three times or more.`;
    this.said.replaceChildren('Pens pass ', ...key.flatMap((one) => [one, ' ']), share);
    this.plot?.sheet.canvas.setAttribute('aria-label', `The ink map of the plot. ${share}`);
  }

  private say(words: string): void {
    this.said.textContent = words;
    this.plot?.sheet.canvas.setAttribute('aria-label', `The plot: ${words}`);
  }

  private goTo(count: number): void {
    this.pause();
    this.place.valueAsNumber = count;
    void this.refresh();
  }

  private playOrPause(): void {
    const { plot, place } = this;
    if (!plot) return;
    if (this.frame !== 0) {
      this.pause();
      return;
    }
    if (place.valueAsNumber >= plot.sheet.count) place.value = '0';
    this.play.textContent = 'Pause';
    const { times, sheet } = plot;
    const perMillisecond = (times.at(-1) ?? 0) / (1000 * PLAYED);
    let count = place.valueAsNumber;
    let now = count > 0 ? times[count - 1] : 0;
    let last: number | undefined;
    const step = (at: number): void => {
      now += perMillisecond * (at - (last ?? at));
      last = at;
      while (count < sheet.count && times[count] <= now) count++;
      place.valueAsNumber = count;
      void this.refresh();
      if (count < sheet.count) this.frame = requestAnimationFrame(step);
      else this.pause();
    };
    this.frame = requestAnimationFrame(step);
  }

  private pause(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    this.play.textContent = 'Play';
  }

  private save(): void {
    if (!this.plot) return;
    this.onSaved(downloadLines(this.plot.file));
    this.dialog.close();
  }

  /** Frees the canvas and the paths. */
  private end(): void {
    this.pause();
    this.plot?.sheet.stop();
    this.plot = undefined;
    this.scroller.replaceChildren();
  }
}

const minutes = (seconds: number): string => (seconds / 60).toFixed(1);

/** The time at which each path is drawn, of all layers one after the other, seconds. */
function timesOf({ layers }: SVGDrawing): Float64Array {
  let before = 0;
  const times = layers.map(({ pathSeconds, plotSeconds }) => {
    const own = (pathSeconds ?? new Float64Array()).map((seconds) => before + seconds);
    before += plotSeconds ?? 0;
    return own;
  });
  const all = new Float64Array(times.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const own of times) {
    all.set(own, at);
    at += own.length;
  }
  return all;
}

/** A row of the table for each layer, and one for all of them. */
function rowsOf({ layers, paths, drawn, plotSeconds }: SVGDrawing): HTMLElement[] {
  const all = layers.length > 1 ? [{ name: 'All', paths, drawn, plotSeconds }] : [];
  return [...layers, ...all].map(({ name, ...counts }) =>
    element(
      'tr',
      {},
      element('th', { scope: 'row', title: name }, name),
      element('td', {}, plottingTime(counts.plotSeconds ?? 0)),
      element('td', {}, `${(counts.drawn / 1000).toFixed(1)} m`),
      element('td', {}, `${counts.paths.toLocaleString('en')} ${counts.paths === 1 ? 'lift' : 'lifts'}`),
    ),
  );
}
