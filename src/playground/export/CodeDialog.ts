import type { CodeForm } from '../code/codeForms.js';
import type { CodeDrawing } from '../code/modelSource.js';
import { findElement } from '../page/elements.js';
import type { Session } from '../session/Session.js';
import { copyText, download, fileStem } from './download.js';

/** Shows the drawing as code in several forms, to copy or save. */
export class CodeDialog {
  private readonly dialog = findElement('code') as HTMLDialogElement;
  private readonly form = findElement('code-form') as HTMLSelectElement;
  private readonly about = findElement('code-about');
  private readonly text = findElement('code-text') as HTMLTextAreaElement;
  private readonly said = findElement('code-said');
  private shown: CodeForm | undefined;

  constructor(private readonly session: Session) {
    this.form.addEventListener('change', () => void this.show());
    findElement('code-copy').addEventListener('click', () => void this.copy());
    findElement('code-save').addEventListener('click', () => this.save());
    findElement('code-close').addEventListener('click', () => this.dialog.close());
  }

  async open(): Promise<void> {
    await this.show();
    this.dialog.showModal();
  }

  private get drawing(): CodeDrawing {
    const { viewport, settings, modelLoader } = this.session;
    return {
      model: modelLoader.codeModel,
      settings: { ...settings },
      camera: viewport.view.place,
      groundHeight: viewport.scenery.ground.height,
      aspect: viewport.camera.aspect,
    };
  }

  /** The address of this page in embed form, with the drawing. */
  private get embedAddress(): string {
    return new URL(`?embed#${this.session.link}`, location.href).href;
  }

  private async show(): Promise<void> {
    // Loaded on demand, because few users ask for code.
    const { codeForms } = await import('../code/codeForms.js');
    const { isModelInLink } = this.session;
    const make = codeForms[this.form.value as keyof typeof codeForms];
    this.shown = make(this.drawing, { address: this.embedAddress, isModelInLink });
    this.about.textContent = this.shown.about;
    this.text.value = this.shown.code;
    this.text.scrollTop = 0;
    this.said.textContent = '';
  }

  private async copy(): Promise<void> {
    if (await copyText(this.text.value)) {
      this.said.textContent = 'The code is on the clipboard.';
      return;
    }
    this.text.focus();
    this.text.select();
    this.said.textContent =
      'The browser does not let this page use the clipboard. The code is selected: copy it with the keyboard.';
  }

  private save(): void {
    if (!this.shown) return;
    const { code, extension } = this.shown;
    download(
      new Blob([code], { type: 'text/plain' }),
      `${fileStem(this.session.modelLoader.shown.title)}.${extension}`,
    );
  }
}
