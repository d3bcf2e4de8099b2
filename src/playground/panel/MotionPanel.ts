import type { Motion } from '../../viewer/drawing/Motion.js';
import { shownName } from '../../viewer/files/common/ModelError.js';
import { type SliderValue, ValueSlider } from '../page/ValueSlider.js';

/** The maximum number of morph target sliders. */
const MAX_MORPH_SLIDERS = 64;

/**
 * The controls of an animated model: play and pause, clip, time, speed, and morph targets. They are created once and reused for every
 * model, because browsers keep removed controls in memory, and with them their models.
 */
export class MotionPanel {
  private motion: Motion | undefined;
  private readonly row = document.createElement('div');
  private readonly play = Object.assign(document.createElement('button'), { type: 'button' });
  private readonly clips = document.createElement('select');
  private readonly time: ValueSlider;
  private readonly speed: ValueSlider;
  private readonly morphs: ValueSlider[] = [];

  /**
   * @param drawing the element on which the space bar plays and pauses
   * @param onChange called when a frame must be drawn
   */
  constructor(
    private readonly container: HTMLElement,
    drawing: HTMLElement,
    private readonly onChange: () => void,
    /** Called with the index of the clip that the user has chosen. */
    private readonly onChoose: (clip: number) => void,
  ) {
    this.row.className = 'motion-clip';
    this.clips.setAttribute('aria-label', 'Clip');
    this.row.append(this.play, this.clips);
    container.replaceChildren(this.row);
    this.time = this.addSlider();
    this.speed = this.addSlider();
    this.play.addEventListener('click', () => this.toggle());
    this.clips.addEventListener('change', () => this.chooseClip());
    drawing.addEventListener('keydown', (event) => {
      if (event.key !== ' ' || !this.motion?.clips.length) return;
      event.preventDefault();
      this.toggle();
    });
  }

  /** Shows the controls of a model, or none. Its clip starts playing unless the user prefers reduced motion. */
  show(motion: Motion | undefined): void {
    this.motion = motion;
    this.container.hidden = motion === undefined;
    const names = motion?.clips ?? [];
    if (motion && names.length > 0) motion.isPlaying = !matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.row.hidden = names.length === 0;
    this.clips.replaceChildren(...names.map((name, i) => new Option(shownName(name), String(i))));
    if (motion) this.clips.value = String(motion.clip);
    this.showClip();
    const morphs = motion?.morphs.slice(0, MAX_MORPH_SLIDERS) ?? [];
    while (this.morphs.length < morphs.length) this.morphs.push(this.addSlider());
    for (const [i, slider] of this.morphs.entries()) {
      slider.show(motion && i < morphs.length ? morphValue(motion, morphs[i]) : undefined);
    }
    this.update();
  }

  /** Updates the controls to the state of the model. Call this after each frame. */
  update(): void {
    if (!this.motion) return;
    const clip = String(this.motion.clip);
    if (this.clips.value !== clip && this.motion.clip >= 0) {
      this.clips.value = clip;
      this.showClip();
    }
    this.play.textContent = this.motion.isPlaying ? 'Pause' : 'Play';
    for (const slider of [this.time, this.speed, ...this.morphs]) slider.update();
  }

  private toggle(): void {
    this.motion!.isPlaying = !this.motion!.isPlaying;
    this.changed();
  }

  private chooseClip(): void {
    this.onChoose(Number(this.clips.value));
    this.showClip();
    this.changed();
  }

  /** Shows time and speed of the clip, if there is one. */
  private showClip(): void {
    const motion = this.motion?.clips.length ? this.motion : undefined;
    this.time.show(motion && timeValue(motion));
    this.speed.show(motion && speedValue(motion));
  }

  private changed(): void {
    this.update();
    this.onChange();
  }

  private addSlider(): ValueSlider {
    const slider = new ValueSlider(() => this.changed());
    this.container.append(slider.label);
    return slider;
  }
}

const percent = (share: number): string => `${Math.round(100 * share)} %`;

const timeValue = (motion: Motion): SliderValue => ({
  name: 'Time',
  min: 0,
  max: motion.duration,
  step: 0.01,
  format: (seconds) => `${seconds.toFixed(1)} s`,
  read: () => motion.time,
  write: (seconds) => {
    motion.time = seconds;
  },
});

const speedValue = (motion: Motion): SliderValue => {
  const write = (speed: number): void => {
    motion.speed = speed;
  };
  return {
    name: 'Speed',
    min: 0.1,
    max: 3,
    step: 0.1,
    format: percent,
    read: () => motion.speed,
    write,
    reset: () => write(1),
  };
};

const morphValue = (motion: Motion, name: string): SliderValue => ({
  name: shownName(name),
  hint: 'Double-click to let the clip set it again',
  min: 0,
  max: 1,
  step: 0.01,
  format: percent,
  read: () => motion.influenceOf(name),
  write: (influence) => motion.setInfluence(name, influence),
  reset: () => motion.setInfluence(name, undefined),
});
