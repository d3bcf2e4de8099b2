import type { Motion } from '../drawing/Motion.js';

/** Only the first morph targets of a model get sliders. */
const MAX_MORPH_SLIDERS = 64;

interface Slider {
  input: HTMLInputElement;
  output: HTMLOutputElement;
  /** Returns the current value. */
  read: () => number;
  format: (value: number) => string;
}

/** The controls of an animated model: play and pause, clip, time, speed, and morph targets. */
export class MotionPanel {
  private motion: Motion | undefined;
  private play: HTMLButtonElement | undefined;
  private sliders: Slider[] = [];

  /**
   * @param drawing the element on which the space bar plays and pauses
   * @param onChange called when a frame must be drawn
   */
  constructor(
    private readonly container: HTMLElement,
    drawing: HTMLElement,
    private readonly onChange: () => void,
  ) {
    drawing.addEventListener('keydown', (event) => {
      if (event.key !== ' ' || !this.motion?.clips.length) return;
      event.preventDefault();
      this.toggle();
    });
  }

  /** Shows the controls for a model, or none. Its clip starts playing unless the user prefers reduced motion. */
  show(motion: Motion | undefined): void {
    this.motion = motion;
    this.play = undefined;
    this.sliders = [];
    this.container.replaceChildren();
    this.container.hidden = motion === undefined;
    if (!motion) return;
    if (motion.clips.length > 0) {
      motion.isPlaying = !matchMedia('(prefers-reduced-motion: reduce)').matches;
      this.addClips(motion);
    }
    for (const name of motion.morphs.slice(0, MAX_MORPH_SLIDERS)) {
      const slider = this.addSlider(name, { min: 0, max: 1, step: 0.01 }, percent, () => motion.influenceOf(name), {
        write: (influence) => motion.setInfluence(name, influence),
        reset: () => motion.setInfluence(name, undefined),
      });
      slider.input.title = 'Double-click to give it back to the clip';
    }
    this.update();
  }

  /** Updates the controls to the state of the model. To be called after each frame. */
  update(): void {
    const { motion, play } = this;
    if (!motion) return;
    if (play) play.textContent = motion.isPlaying ? 'Pause' : 'Play';
    for (const { input, output, read, format } of this.sliders) {
      const value = read();
      input.value = String(value);
      const text = format(value);
      if (output.textContent === text) continue;
      output.textContent = text;
      input.setAttribute('aria-valuetext', text);
    }
  }

  private toggle(): void {
    this.motion!.isPlaying = !this.motion!.isPlaying;
    this.changed();
  }

  private changed(): void {
    this.update();
    this.onChange();
  }

  private addClips(motion: Motion): void {
    const row = document.createElement('div');
    row.className = 'motion-clip';
    this.play = Object.assign(document.createElement('button'), { type: 'button' });
    this.play.addEventListener('click', () => this.toggle());
    const clips = document.createElement('select');
    clips.setAttribute('aria-label', 'Clip');
    clips.append(...motion.clips.map((name, i) => new Option(name, String(i))));
    clips.value = String(motion.clip);
    clips.addEventListener('change', () => {
      motion.clip = Number(clips.value);
      this.sliders[0].input.max = String(motion.duration);
      this.changed();
    });
    row.append(this.play, clips);
    this.container.append(row);
    const seconds = (time: number): string => `${time.toFixed(1)} s`;
    this.addSlider('Time', { min: 0, max: motion.duration, step: 0.01 }, seconds, () => motion.time, {
      write: (time) => {
        motion.time = time;
      },
    });
    const setSpeed = (speed: number): void => {
      motion.speed = speed;
    };
    this.addSlider('Speed', { min: 0.1, max: 3, step: 0.1 }, percent, () => motion.speed, {
      write: setSpeed,
      reset: () => setSpeed(1),
    });
  }

  private addSlider(
    name: string,
    range: { min: number; max: number; step: number },
    format: (value: number) => string,
    read: () => number,
    { write, reset }: { write: (value: number) => void; reset?: () => void },
  ): Slider {
    const label = document.createElement('label');
    const input = Object.assign(document.createElement('input'), { type: 'range' });
    for (const [key, value] of Object.entries(range)) input.setAttribute(key, String(value));
    const output = document.createElement('output');
    const text = Object.assign(document.createElement('span'), { textContent: name, title: name });
    label.append(text, input, output);
    input.addEventListener('input', () => {
      write(input.valueAsNumber);
      this.changed();
    });
    label.addEventListener('dblclick', () => {
      reset?.();
      this.changed();
    });
    this.container.append(label);
    const slider = { input, output, read, format };
    this.sliders.push(slider);
    return slider;
  }
}

const percent = (share: number): string => `${Math.round(100 * share)} %`;
