import { MathUtils } from 'three';
import { shownName } from '../../viewer/files/common/ModelError.js';
import { FULL_SHEET, LEAST_STROKE_SHARE } from '../../viewer/sceneSetup/framing.js';
import { GROUND } from '../../viewer/sceneSetup/Ground.js';
import { LENS } from '../../viewer/sceneSetup/LensCamera.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { codeLook, entries, lightSample, lookSample, round, when } from './lookSample.js';
import { type CodeDrawing, type CodeModel, IMPORT_MAP, type ModelSource, modelSource } from './modelSource.js';

const THREE =
  'AnimationMixer BoxGeometry BufferGeometry Color DirectionalLight DoubleSide Float32BufferAttribute Group MathUtils Mesh MeshStandardMaterial OrthographicCamera PerspectiveCamera PlaneGeometry PointLight Scene Sphere SpotLight Vector3 WebGLRenderer';
const HATCHING =
  'HatchingBackground HatchingShadowMaterial TonalArtMap applyHatching bakeOcclusion prepareHatchingGeometry presets scalePreset';

/** The import declaration of what code uses of a package. */
const imported = (code: string, names: string, from: string, more: readonly string[] = []): string => {
  const used = names.split(' ').filter((name) => new RegExp(`\\b${name}\\b`).test(code));
  return `import { ${[...new Set([...used, ...more])].sort().join(', ')} } from '${from}';`;
};

/** The import declarations of code that uses three.js and the library. */
export const importsOf = (code: string, { classes = [], imports = [] }: Partial<ModelSource> = {}): string =>
  [imported(code, THREE, 'three', classes), ...new Set(imports), imported(code, HATCHING, 'three-hatching')].join('\n');

const PLAYING = `
let before = performance.now();
renderer.setAnimationLoop((now) => {
  mixer.update((now - before) / 1000);
  before = now;
  draw();
});`;

const listed = (numbers: readonly number[]): string => numbers.map(round).join(', ');

/** The camera, and how it shows as much in a picture of any proportion as on the page. */
function cameraSample({ camera: { lens }, aspect: shown }: CodeDrawing): { made: string; sized: string } {
  const { isOrthographic, high, aspect, up } = lens ?? {
    ...{
      isOrthographic: false,
      high: Math.tan(MathUtils.degToRad(LENS.fieldOfView / 2)),
      aspect: shown,
      up: [0, 1, 0],
    },
  };
  const [kind, frustum] = isOrthographic
    ? ['OrthographicCamera', '-1, 1, 1, -1']
    : ['PerspectiveCamera', `${LENS.fieldOfView}, 1`];
  const turned = when(up.join() !== '0,1,0', `\ncamera.up.set(${listed(up)});`);
  const [tall, wide] = [high, high * aspect].map((size) => Number(size.toPrecision(5)));
  const set = isOrthographic
    ? 'Object.assign(camera, { left: -half * aspect, right: half * aspect, top: half, bottom: -half });'
    : 'Object.assign(camera, { aspect, fov: MathUtils.radToDeg(2 * Math.atan(half)) });';
  return {
    made: `const camera = new ${kind}(${frustum}, ${LENS.near}, ${LENS.far});${turned}`,
    sized: `  const aspect = width / height;
  // A picture of any proportion shows all that the camera sees.
  const half = ${wide > 0 ? `Math.max(${tall}, ${wide} / aspect)` : tall};
  ${set}`,
  };
}

/** An ES module that draws all that the page shows: model, paper, camera, lights, shadows, ground and outlines. */
function drawingSample(drawing: CodeDrawing): string {
  const { settings, camera } = drawing;
  const { made: cameraMade, sized } = cameraSample(drawing);
  const { paper, lights } = codeLook(settings);
  const made = modelSource(drawing.model);
  const clip = made.hasClips ? drawing.model.clip : undefined;
  const look: Settings = drawing.model.hasParts ? settings : { ...settings, outlineMeetings: 'off' };
  const posing = `
const mixer = new AnimationMixer(model);
mixer.clipAction(animations[${clip?.index}]).play();
mixer.setTime(${round(clip?.time ?? 0)});`;
  const body = `const renderer = new WebGLRenderer({ canvas, antialias: true });
renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
renderer.setClearColor('${paper}');
// Strokes shrink on small sheets.
const sheet = Math.min(canvas.clientWidth / ${FULL_SHEET.width}, canvas.clientHeight / ${FULL_SHEET.height});
const share = MathUtils.clamp(sheet, ${LEAST_STROKE_SHARE}, 1);
const scene = new Scene();
${cameraMade}
camera.position.set(${listed(camera.position)});
const controls = new OrbitControls(camera, canvas);
controls.target.set(${listed(camera.target)});
controls.update();

// The model, its centre in the middle of the scene, with a radius of 1.
${made.code}
${placed(drawing, made)}${when(clip, posing)}

${lookSample(look, 'root', { share: 'share', isOpen: drawing.model.isOpen })}
${surroundings(drawing)}
${lightSample(settings, 'root')}

// A frame is drawn when something has changed.
const draw = () => {${when(lights.isWithViewer, '\n  lights.quaternion.copy(camera.quaternion);')}
  renderer.render(scene, camera);
};
controls.addEventListener('change', draw);
new ResizeObserver(() => {
  const { clientWidth: width, clientHeight: height } = canvas;
  if (width === 0 || height === 0) return;
  renderer.setSize(width, height, false);
${sized}
  camera.updateProjectionMatrix();
  draw();
}).observe(canvas);${when(clip?.isPlaying, PLAYING)}`;
  const orbit = "import { OrbitControls } from 'three/addons/controls/OrbitControls.js';";
  return `${when(made.note, `// ${made.note?.replaceAll('<', '‹')}\n`)}${importsOf(body, { ...made, imports: [orbit, ...made.imports] })}
${when(made.functions, `\n${made.functions}\n`)}
/** Draws into a canvas, which keeps its size by itself. Rejects with an Error if the model cannot be loaded. */
export async function drawHatching(canvas) {
${body.replace(/^(?=.)/gm, '  ')}
}
`;
}

/** A number with as few digits as possible without moving anything by a pixel. */
const exact = (value: number): number => Number(value.toPrecision(5));

/** Code that puts `model` into `root`, its middle at the origin, with a radius of 1 and its up axis at the top. */
function placed({ model: { place }, settings }: CodeDrawing, { hasGeometry }: ModelSource): string {
  const { upright } = codeLook(settings);
  // Strokes lie in the space of a geometry: as the page does, it is moved itself.
  const fitted = hasGeometry
    ? `geometry.center().computeBoundingSphere();
const scale = 1 / geometry.boundingSphere.radius;
geometry.scale(scale, scale, scale);`
    : place
      ? `const holder = new Group().add(model);
holder.scale.setScalar(${exact(place.scale)});
holder.position.set(${place.position.map(exact).join(', ')});`
      : `const points = [];
model.updateMatrixWorld(true);
model.traverse((object) => {
  const count = object.isMesh ? object.geometry.attributes.position.count : 0;
  for (let i = 0; i < count; i++) points.push(object.localToWorld(object.getVertexPosition(i, new Vector3())));
});
const { center, radius } = new Sphere().setFromPoints(points);
model.position.sub(center);
const holder = new Group().add(model);
holder.scale.setScalar(1 / radius);`;
  return `${fitted}
const root = new Group().add(${hasGeometry ? 'model' : 'holder'});
root.rotation.set(${upright.map(round).join(', ')});
scene.add(root);`;
}

/** Code of the ground and of the lines behind the model. */
function surroundings({ settings, groundHeight }: CodeDrawing): string {
  const { ground, groundShadow, background, material } = codeLook(settings);
  const { size, parts } = GROUND;
  const scale = round(material.tilesPerObjectUnit ?? 1);
  const plane = `new PlaneGeometry(${size}, ${size}, ${parts}, ${parts}).rotateX(-Math.PI / 2)`;
  const standing = `ground.position.y = ${round(groundHeight)};
ground.receiveShadow = true;
scene.add(ground);\n`;
  const shadow = `const ground = new Mesh(
  await prepareHatchingGeometry(${plane}, { adjacency: true }),
  new HatchingShadowMaterial({
    ...scalePreset(look, share).material,
    ${entries(groundShadow).join(', ')}, depthWrite: false,
    color: '${settings.color}',
    tonalArtMap: hatched.materials[0].tonalArtMap,
    tilesPerObjectUnit: ${scale},
    composition: hatched.composition,
  }),
);
${standing}`;
  const floor = `const ground = new Mesh(${plane});
${standing}await applyHatching(ground, {
  preset: scalePreset(look, share),
  outlines: false,
  material: {
    color: '${settings.color}',
    tonalArtMap: hatched.materials[0].tonalArtMap,
    composition: hatched.composition,
  },
  tilesPerWorldUnit: ${scale},
});\n`;
  const { spacing = 0, ...look } = background ?? {};
  const field = `scene.add(new HatchingBackground(hatched.composition.extent, {
  ${[...entries(look), `spacing: ${round(spacing)} * share`].join(',\n  ')},
}));\n`;
  return `${when(ground === 'shadow', shadow)}${when(ground === 'floor', floor)}${when(background, field)}`;
}

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
