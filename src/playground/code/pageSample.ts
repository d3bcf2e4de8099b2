import { shownName } from '../../viewer/files/common/shownText.js';
import type { CodeDrawing } from './CodeModel.js';
import { drawingSample } from './drawingSample.js';
import { escapeHtml } from './escapeHtml.js';
import { CDN } from './versions.js';

/** The import map of a copied page: the addresses of the packages that the code imports. */
export const IMPORT_MAP = {
  three: `${CDN.three}/build/three.module.js`,
  'three/addons/': `${CDN.three}/examples/jsm/`,
  'three-hatching': `${CDN.hatching}/dist/index.js`,
  // These packages are not ES modules: jsDelivr serves them as such.
  bunny: `${CDN.bunny}/+esm`,
  'snowden/lo.js': `${CDN.bust}/lo.js/+esm`,
  '@pmndrs/assets/': `${CDN.assets}/`,
} as const;

/** A whole web page that shows the drawing, which can be turned, without any change. */
export function pageSample(drawing: CodeDrawing): string {
  const { imports, code, note } = drawingSample(drawing);
  const title = escapeHtml(shownName(drawing.model.title));
  const entries = Object.entries(IMPORT_MAP)
    .filter(([name]) => imports.includes(`from '${name}`))
    .map(([name, address]) => `          ${JSON.stringify(name)}: ${JSON.stringify(address)}`);
  return `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8" />
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    <title>${title}, hatched</title>
    <link rel="icon" href="data:," />
    <style>
      html,
      body {
        height: 100%;
        margin: 0;
        background: ${drawing.settings.paper};
      }
      canvas {
        display: block;
        width: 100%;
        height: 100%;
        touch-action: none;
      }
    </style>
    <script type="importmap">
      {
        "imports": {
${entries.join(',\n')}
        }
      }
    </script>
  </head>
  <body>
    <canvas id="drawing" role="img" aria-label="Hatched drawing: ${title}"></canvas>
    <script type="module">
${commented(note)}${imports}

${code.replace('export async', 'async')}

drawHatching(document.getElementById('drawing')).catch((error) => {
  document.body.replaceChildren(\`The drawing could not be made: \${error.message}\`);
  throw error;
});
    </script>
  </body>
</html>
`;
}

/** The same as an ES module, for a project with a bundler or an import map. */
export function moduleSample(drawing: CodeDrawing): string {
  const { imports, code, note } = drawingSample(drawing);
  return `${commented(note)}${imports}\n\n${code}\n`;
}

const commented = (note: string | undefined): string => (note ? `// ${note.replaceAll('<', '‹')}\n` : '');
