import { shownName } from '../../viewer/files/common/shownText.js';
import type { CodeDrawing, CodeModel } from './CodeModel.js';
import { drawingSample, importsOf } from './drawingSample.js';
import { lightSample, lookSample } from './lookSample.js';
import { IMPORT_MAP } from './versions.js';

/** Code that draws what the page shows, and what it is for, in one sentence. */
export interface CodeForm {
  about: string;
  code: string;
  extension: 'html' | 'js';
}

/** The page itself, in the form for other pages. */
interface Embed {
  address: string;
  isModelInLink: boolean;
}

/** Escapes text for HTML, also for an attribute. Line breaks become spaces. */
const escapeHtml = (text: string): string =>
  text.replace(/[&<>"]/g, (character) => `&#${character.charCodeAt(0)};`).replace(/\s+/g, ' ');

const titleOf = ({ title }: CodeModel): string => escapeHtml(`Hatched drawing: ${shownName(title)}`);

/** The forms that the code of a drawing comes in. */
export const codeForms = {
  page: (drawing) => ({
    about: 'A whole web page. It fetches three.js and three-hatching, in these very versions, from jsDelivr.',
    code: pageOf(drawing),
    extension: 'html',
  }),
  module: (drawing) => ({
    about: 'An ES module for a project of yours: drawHatching(canvas) draws the same.',
    code: drawingSample(drawing),
    extension: 'js',
  }),
  look: ({ settings, model: { sceneRadius: radius } }) => {
    const look = lookSample(settings, 'model', { radius });
    const code = `${look}\n\n${lightSample(settings, 'model', radius)}`;
    const turning =
      settings.lightFollows === 'viewer' ? '\nlights.quaternion.copy(camera.quaternion); // again in every frame' : '';
    return {
      about: 'The look and the light alone, for a model, a scene, a camera and a renderer of yours.',
      code: `${importsOf(code)}\n\n${code}${turning}\n`,
      extension: 'js',
    };
  },
  embed: ({ model }, { address, isModelInLink }) => ({
    about: isModelInLink
      ? 'This page in a page of yours, without its panel; the light can be dragged.'
      : 'This page in a page of yours. An address cannot carry your own model: the dragon stands in for it.',
    code: `<iframe
  src="${escapeHtml(address)}"
  title="${titleOf(model)}"
  width="800"
  height="600"
  style="max-width: 100%; border: 0"
  loading="lazy"
  allow="fullscreen"
></iframe>
`,
    extension: 'html',
  }),
} as const satisfies Record<string, (drawing: CodeDrawing, embed: Embed) => CodeForm>;

/** A whole web page that shows the drawing, which can be turned, without any change. */
function pageOf(drawing: CodeDrawing): string {
  const script = drawingSample(drawing).replace('export async', 'async');
  const imports = Object.entries(IMPORT_MAP).filter(([name]) => script.includes(`from '${name}`));
  return `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8" />
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    <title>${titleOf(drawing.model)}</title>
    <link rel="icon" href="data:," />
    <style>
      html, body { height: 100%; margin: 0; background: ${drawing.settings.paper}; }
      canvas { display: block; width: 100%; height: 100%; touch-action: none; }
    </style>
    <script type="importmap">
${JSON.stringify({ imports: Object.fromEntries(imports) }, null, 2)}
    </script>
  </head>
  <body>
    <canvas id="drawing" role="img" aria-label="${titleOf(drawing.model)}"></canvas>
    <script type="module">
${script}
drawHatching(document.getElementById('drawing')).catch((error) => {
  document.body.replaceChildren(\`The drawing could not be made: \${error.message}\`);
  throw error;
});
    </script>
  </body>
</html>
`;
}
