import { errorMessage } from '../../src/viewer/files/common/ModelError.js';
import { FigureDrawing, type TechniqueChoice } from './FigureDrawing.js';
import type { FigurePainter } from './FigurePainter.js';
import type { Figure, Panel } from './figures.js';

/** The page's services for a panel. */
export interface PanelContext {
  ink: string;
  paper: string;
  /** Called when the panel has something new to draw. */
  onOutdated(): void;
  /** Called with one sentence when the panel cannot be drawn. */
  onFailure(sentence: string): void;
}

/** A canvas with its caption. Its model is loaded when the canvas first comes into view. */
export class FigurePanel {
  readonly element: HTMLElement;
  readonly canvas = document.createElement('canvas');
  /** Whether the canvas is in view, or just outside of it. */
  isVisible = false;
  /** Whether the canvas must be drawn again. */
  isOutdated = true;
  private size = { width: 0, height: 0 };
  private drawing: FigureDrawing | undefined;
  private loading: Promise<void> | undefined;

  constructor(
    private readonly figure: Figure,
    private readonly panel: Panel,
    private readonly context: PanelContext,
  ) {
    this.element = document.createElement('div');
    this.element.className = 'panel';
    this.canvas.dataset.panel = panel.name;
    this.canvas.role = 'img';
    this.canvas.ariaLabel = `Figure ${figure.number}, ${figure.title}: ${panel.label}`;
    this.canvas.width = 0;
    this.canvas.height = 0;
    const label = document.createElement('p');
    label.textContent = panel.label;
    this.element.append(this.canvas, label);
  }

  /** Whether the panel is out of view or up to date, so that nothing is to be awaited. */
  get isSettled(): boolean {
    return !this.isVisible || !this.isOutdated;
  }

  /** Whether the panel should be drawn, and can be. */
  get isReady(): boolean {
    return this.isVisible && this.isOutdated && this.drawing !== undefined;
  }

  setVisible(isVisible: boolean): void {
    this.isVisible = isVisible;
    if (isVisible) this.loading ??= this.make();
    if (this.isReady) this.context.onOutdated();
  }

  /** Sets the size of the canvas, in device pixels. */
  resize(width: number, height: number): void {
    this.size = { width, height };
    this.invalidate();
  }

  /** Asks for the panel to be drawn again. */
  invalidate(): void {
    this.isOutdated = true;
    if (this.isReady) this.context.onOutdated();
  }

  paint(painter: FigurePainter, turn: number, choice: TechniqueChoice): void {
    const drawing = this.drawing;
    if (!drawing) return;
    const { width, height } = this.size;
    if (width === 0 || height === 0) return;
    if (this.canvas.width !== width || this.canvas.height !== height) Object.assign(this.canvas, { width, height });
    drawing.setTechnique(choice);
    drawing.turnLight(turn);
    if (painter.paint(drawing, this.canvas, devicePixelRatio)) this.isOutdated = false;
  }

  private async make(): Promise<void> {
    const { ink, paper, onFailure, onOutdated } = this.context;
    try {
      this.drawing = await FigureDrawing.make(this.figure, this.panel, ink, paper);
      onOutdated();
    } catch (error) {
      this.isOutdated = false;
      onFailure(`Figure ${this.figure.number} cannot be drawn: ${errorMessage(error)}`);
    }
  }
}
