import { setPageState } from '../../src/playground/page/elements.js';
import { FrameScheduler } from '../../src/playground/viewport/Frames.js';
import type { TechniqueChoice } from './FigureDrawing.js';
import { FigurePainter } from './FigurePainter.js';
import { FigurePanel } from './FigurePanel.js';
import { FIGURES, type Figure } from './figures.js';
import { figuresPage } from './figuresPage.js';

declare global {
  interface Window {
    /**
     * For tests: the number of frames drawn since the page was opened, and whether all panels in view are up to date.
     */
    __figures?: { readonly framesDrawn: number; readonly isIdle: boolean };
  }
}

/** After so many milliseconds, the remaining panels are left to the next frame. */
const FRAME_MILLISECONDS = 12;

/** The first figure that is not in the paper. A heading stands before it. */
const FIRST_BEYOND = FIGURES.find(({ inThePaper }) => inThePaper === undefined);

/** Adds the figures to the page, whether they can be drawn or not, and returns their panels. */
export function layOutFigures(say: (sentence: string) => void, onOutdated: () => void): FigurePanel[] {
  const style = getComputedStyle(document.documentElement);
  const context = {
    ink: style.getPropertyValue('--ink').trim(),
    paper: style.getPropertyValue('--paper').trim(),
    onOutdated,
    onFailure: say,
  };
  return FIGURES.flatMap((figure) => {
    const rows = figure.rows.map(({ label, panels }) => ({
      label,
      panels: panels.map((panel) => new FigurePanel(figure, panel, context)),
    }));
    if (figure === FIRST_BEYOND) figuresPage.figures.append(partHeading('Beyond the paper'));
    figuresPage.figures.append(figureElement(figure, rows));
    return rows.flatMap(({ panels }) => panels);
  });
}

function figureElement(figure: Figure, rows: { label?: string | undefined; panels: FigurePanel[] }[]): HTMLElement {
  const element = document.createElement('figure');
  element.id = `figure-${figure.number}`;
  const plates = document.createElement('div');
  plates.className = figure.beside ? 'plates is-beside' : 'plates';
  for (const { label, panels } of rows) {
    const row = document.createElement('div');
    row.className = 'row';
    row.dataset.columns = String(panels.length);
    row.style.setProperty('--columns', String(Math.max(panels.length, 2)));
    if (label) row.append(paragraph(label, 'row-label'));
    for (const { element: panel, canvas } of panels) {
      canvas.style.aspectRatio = String(figure.aspect);
      row.append(panel);
    }
    plates.append(row);
  }
  const caption = document.createElement('figcaption');
  const heading = document.createElement('h2');
  heading.textContent = `Figure ${figure.number}. ${figure.title}`;
  caption.append(heading);
  if (figure.inThePaper) caption.append(captionLine('In the paper', figure.inThePaper));
  caption.append(captionLine('Here', figure.here));
  element.append(plates, caption);
  return element;
}

function partHeading(text: string): HTMLElement {
  return Object.assign(document.createElement('h2'), { className: 'part', textContent: text });
}

function captionLine(where: string, sentence: string): HTMLElement {
  const element = paragraph(` ${sentence}`);
  const name = document.createElement('em');
  name.textContent = `${where}:`;
  element.prepend(name);
  return element;
}

function paragraph(text: string, className = ''): HTMLElement {
  const element = document.createElement('p');
  if (className) element.className = className;
  element.textContent = text;
  return element;
}

/** Draws the panels that are in view, whenever they are out of date. */
export function createFiguresPage(context: WebGL2RenderingContext, say: (sentence: string) => void): void {
  const { turn, turnValue, technique } = figuresPage;
  const scheduler = new FrameScheduler(draw);
  const panels = layOutFigures(say, () => scheduler.invalidate());
  const painter = new FigurePainter(context);
  const paintedAt = new Map(panels.map((panel) => [panel, 0]));
  let turned = 0;
  let choice: TechniqueChoice = 'asInPaper';

  Object.defineProperty(window, '__figures', {
    value: {
      get framesDrawn() {
        return scheduler.frames;
      },
      get isIdle() {
        return !scheduler.isWaiting && panels.every(({ isSettled }) => isSettled);
      },
    },
  });

  function draw(): void {
    const start = performance.now();
    const ready = panels.filter(({ isReady }) => isReady);
    // Panels that were drawn longest ago come first, so that all are drawn in turn while the light keeps turning.
    for (const panel of ready.sort((a, b) => paintedAt.get(a)! - paintedAt.get(b)!)) {
      if (performance.now() - start > FRAME_MILLISECONDS) {
        scheduler.invalidate();
        return;
      }
      panel.paint(painter, turned, choice);
      paintedAt.set(panel, performance.now());
    }
  }

  observePanels(panels);

  function invalidateAll(): void {
    for (const panel of panels) panel.invalidate();
  }

  turn.addEventListener('input', () => {
    turned = turn.valueAsNumber;
    turn.ariaValueText = `${turned < 0 ? '−' : ''}${Math.abs(turned)}°`;
    turnValue.textContent = turn.ariaValueText;
    invalidateAll();
  });
  technique.addEventListener('change', (event) => {
    choice = (event.target as HTMLInputElement).value as TechniqueChoice;
    invalidateAll();
  });

  watchContext(context.canvas as HTMLCanvasElement, say, invalidateAll);
  setPageState('ready');
}

/** Tells panels whether they are in view, and the sizes of their canvases. */
function observePanels(panels: readonly FigurePanel[]): void {
  const byCanvas = new Map<Element, FigurePanel>(panels.map((panel) => [panel.canvas, panel]));
  const views = new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries) byCanvas.get(target)!.setVisible(isIntersecting);
    },
    { rootMargin: '25%' },
  );
  const sizes = new ResizeObserver((entries) => {
    for (const { target, devicePixelContentBoxSize, contentRect } of entries) {
      // Exactly as many pixels as on the screen, so that the canvas is not blurred. Not every browser reports that.
      const { inlineSize, blockSize } = devicePixelContentBoxSize?.[0] ?? {
        inlineSize: Math.round(contentRect.width * devicePixelRatio),
        blockSize: Math.round(contentRect.height * devicePixelRatio),
      };
      byCanvas.get(target)!.resize(inlineSize, blockSize);
    }
  });
  const box = 'devicePixelContentBoxSize' in ResizeObserverEntry.prototype ? 'device-pixel-content-box' : 'content-box';
  for (const { canvas } of panels) {
    views.observe(canvas);
    sizes.observe(canvas, { box });
  }
}

/** Says when the graphics context is lost, and calls back when it is there again. */
function watchContext(buffer: HTMLCanvasElement, say: (sentence: string) => void, onRestored: () => void): void {
  buffer.addEventListener('webglcontextlost', () => {
    setPageState('lost');
    say(
      'The graphics card has let go of the figures. They stay as they are until it comes back; if not, reload the page.',
    );
  });
  buffer.addEventListener('webglcontextrestored', () => {
    setPageState('ready');
    say('');
    onRestored();
  });
}
