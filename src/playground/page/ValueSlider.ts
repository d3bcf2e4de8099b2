/** A number that a slider shows and sets. */
export interface SliderValue {
  name: string;
  /** The tooltip of the slider. */
  hint?: string;
  min: number;
  max: number;
  step: number;
  format: (value: number) => string;
  read: () => number;
  write: (value: number) => void;
  /** Called by a double-click. */
  reset?: () => void;
}

/** A labelled slider, which can be reused for another value. */
export class ValueSlider {
  readonly label = document.createElement('label');
  private readonly name = document.createElement('span');
  private readonly input = Object.assign(document.createElement('input'), { type: 'range' });
  private readonly output = document.createElement('output');
  private value: SliderValue | undefined;

  /** @param onChange called when the user has changed the value */
  constructor(onChange: () => void) {
    this.label.append(this.name, this.input, this.output);
    this.input.addEventListener('input', () => {
      this.value?.write(this.input.valueAsNumber);
      onChange();
    });
    this.label.addEventListener('dblclick', () => {
      this.value?.reset?.();
      onChange();
    });
    this.show(undefined);
  }

  /** Shows a value; undefined hides the slider. */
  show(value: SliderValue | undefined): void {
    this.value = value;
    this.label.hidden = value === undefined;
    if (!value) return;
    const { name, hint = '', min, max, step } = value;
    this.name.textContent = name;
    this.name.title = name;
    this.input.title = hint;
    for (const [key, limit] of Object.entries({ min, max, step })) this.input.setAttribute(key, String(limit));
    this.update();
  }

  /** Reads the value again. */
  update(): void {
    const { value, input, output } = this;
    if (!value) return;
    const number = value.read();
    input.value = String(number);
    const text = value.format(number);
    if (output.textContent === text) return;
    output.textContent = text;
    input.setAttribute('aria-valuetext', text);
  }
}
