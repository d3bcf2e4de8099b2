import { shownName } from '../../viewer/files/common/shownText.js';
import type { CodeDrawing } from './CodeModel.js';
import { codeSample } from './codeSample.js';
import { escapeHtml } from './escapeHtml.js';
import { moduleSample, pageSample } from './pageSample.js';

/** Code that draws what the page shows, and what it is for, in one sentence. */
interface CodeForm {
  about: string;
  code: string;
  extension: 'html' | 'js';
}

/** The page itself, in the form for other pages. */
interface Embed {
  address: string;
  isModelInLink: boolean;
}

/** The forms that the code of a drawing comes in. */
export const codeForms = {
  page: (drawing) => ({
    about: 'A whole web page. It fetches three.js and three-hatching, in these very versions, from jsDelivr.',
    code: pageSample(drawing),
    extension: 'html',
  }),
  module: (drawing) => ({
    about: 'An ES module for a project of yours: drawHatching(canvas) draws the same.',
    code: moduleSample(drawing),
    extension: 'js',
  }),
  look: ({ settings, model }) => ({
    about: 'The look alone, for a scene, a camera and a renderer of yours.',
    // Only a model that the user opened is a file that the code can load.
    code: codeSample(settings, model.model === 'file' ? model.sceneRadius : undefined, model.title),
    extension: 'js',
  }),
  embed: ({ model }, { address, isModelInLink }) => ({
    about: isModelInLink
      ? 'This page in a page of yours, without its panel; the light can be dragged.'
      : 'This page in a page of yours. An address cannot carry your own model: the dragon stands in for it.',
    code: embedSample(address, model.title),
    extension: 'html',
  }),
} as const satisfies Record<string, (drawing: CodeDrawing, embed: Embed) => CodeForm>;

/** HTML that shows the playground, without its panel, in another page. */
function embedSample(address: string, title: string): string {
  return `<iframe
  src="${escapeHtml(address)}"
  title="Hatched drawing: ${escapeHtml(shownName(title))}"
  width="800"
  height="600"
  style="max-width: 100%; border: 0"
  loading="lazy"
  allow="fullscreen"
></iframe>
`;
}
