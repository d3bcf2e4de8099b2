import { GROUND } from '../../viewer/sceneSetup/Ground.js';
import { LENS } from '../../viewer/sceneSetup/LensCamera.js';
import { SHADOWS, SUN_DISTANCE } from '../../viewer/sceneSetup/LightRig.js';
import { FULL_SHEET, LEAST_STROKE_SHARE } from '../../viewer/sceneSetup/strokeShare.js';
import { backgroundLook } from '../../viewer/settings/compositionLook.js';
import { shadowNumbers } from '../../viewer/settings/groundShadow.js';
import { presetOf } from '../../viewer/settings/presets.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { type LightPlace, placeOfLight, placeOfSecondLight, UPRIGHT } from '../../viewer/settings/settingValues.js';
import { withBoldnessAndDensity } from '../../viewer/settings/withBoldnessAndDensity.js';
import type { CodeDrawing } from './CodeModel.js';
import { intensityOf, mainLight, positionOf } from './lightSource.js';
import {
  compositionParameters,
  drawnWithMap,
  mapSource,
  materialParameters,
  outlineParameters,
  prepareArgument,
  shiftsStrokes,
} from './lookSample.js';
import { modelSource } from './modelSource.js';
import { round } from './round.js';

/** An ES module that draws all that the page shows: model, paper, camera, lights, shadows, ground and outlines. */
export interface DrawingSample {
  /** Import declarations. */
  imports: string;
  /** The declaration of `drawHatching(canvas)`, and of functions that it calls. */
  code: string;
  /** What users of the module have to know. */
  note: string | undefined;
}

/** Statements, and the names that they need. */
interface Part {
  code: string;
  three?: string[];
  hatching?: string[];
}

/** The variable by which strokes shrink on small sheets. */
const SHARE = 'share';

/** The code of a drawing. */
export function drawingSample(shown: CodeDrawing): DrawingSample {
  const drawing = { ...shown, settings: withBoldnessAndDensity(shown.settings) };
  const source = modelSource(drawing.model);
  const parts: Part[] = [
    stagePart(drawing),
    {
      code: `// The model, its centre in the middle of the scene, with a radius of 1.\n${source.code}`,
      three: source.classes,
    },
    fittingPart(drawing, source.hasGeometry),
    clipPart(drawing, source.hasClips),
    lookPart(drawing),
    groundPart(drawing),
    backgroundPart(drawing.settings),
    lightsPart(drawing.settings),
    framesPart(drawing, source.hasClips),
  ];
  const body = parts.flatMap(({ code }) => (code ? [indented(code)] : [])).join('\n\n');
  const names = (kind: 'three' | 'hatching') =>
    [...new Set(parts.flatMap((part) => part[kind] ?? []))].sort().join(', ');
  return {
    note: source.note,
    imports: [
      `import { ${names('three')} } from 'three';`,
      "import { OrbitControls } from 'three/addons/controls/OrbitControls.js';",
      ...new Set(source.imports),
      `import { ${names('hatching')} } from 'three-hatching';`,
    ].join('\n'),
    code: `${source.functions ? `${source.functions}\n\n` : ''}/** Draws into a canvas, which keeps its size by itself. Rejects with an Error if the model cannot be loaded. */
export async function drawHatching(canvas) {
${body}
}`,
  };
}

const indented = (code: string): string => code.replace(/^(?=.)/gm, '  ');

const listed = (numbers: readonly number[]): string => numbers.map(round).join(', ');

function stagePart({ settings, camera }: CodeDrawing): Part {
  const { lens } = camera;
  const [kind, frustum] = lens?.isOrthographic
    ? ['OrthographicCamera', '-1, 1, 1, -1']
    : ['PerspectiveCamera', `${LENS.fieldOfView}, 1`];
  const up = lens && lens.up.join() !== '0,1,0' ? `camera.up.set(${listed(lens.up)});\n` : '';
  const shadows = settings.shadows === 'on' ? '\nrenderer.shadowMap.enabled = true;' : '';
  return {
    three: ['WebGLRenderer', 'Scene', kind],
    code: `const renderer = new WebGLRenderer({ canvas, antialias: true });
renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
renderer.setClearColor('${settings.paper}');${shadows}
// Strokes shrink on small sheets.
const sheet = Math.min(canvas.clientWidth / ${FULL_SHEET.width}, canvas.clientHeight / ${FULL_SHEET.height});
const ${SHARE} = MathUtils.clamp(sheet, ${LEAST_STROKE_SHARE}, 1);
const scene = new Scene();
const camera = new ${kind}(${frustum}, ${LENS.near}, ${LENS.far});
${up}camera.position.set(${listed(camera.position)});
const controls = new OrbitControls(camera, canvas);
controls.target.set(${listed(camera.target)});
controls.update();`,
  };
}

function fittingPart({ model: { place }, settings: { upAxis } }: CodeDrawing, hasGeometry = false): Part {
  const turned = (group: string): string =>
    upAxis === 'y' ? '' : `\n${group}.rotation.set(${listed(UPRIGHT[upAxis])}); // its ${upAxis} axis points up`;
  if (place) {
    return {
      three: ['Group'],
      code: `const holder = new Group().add(model);
holder.scale.setScalar(${exact(place.scale)});
holder.position.set(${place.position.map(exact).join(', ')});
const upright = new Group().add(holder);${turned('upright')}
scene.add(upright);`,
    };
  }
  // Strokes lie in the space of the geometry: as the page does, it is moved itself.
  if (hasGeometry) {
    return {
      three: ['Group'],
      code: `geometry.center().computeBoundingSphere();
const scale = 1 / geometry.boundingSphere.radius;
geometry.scale(scale, scale, scale);
const holder = new Group().add(model);${turned('holder')}
scene.add(holder);`,
    };
  }
  return {
    three: ['Box3', 'Group', 'Vector3'],
    code: `const points = [];
model.updateMatrixWorld(true);
model.traverse((object) => {
  const count = object.isMesh ? object.geometry.attributes.position.count : 0;
  for (let i = 0; i < count; i++) {
    points.push(object.getVertexPosition(i, new Vector3()).applyMatrix4(object.matrixWorld));
  }
});
const centre = new Box3().setFromPoints(points).getCenter(new Vector3());
const radius = points.reduce((most, point) => Math.max(most, point.distanceTo(centre)), 0);
model.position.sub(centre);
const holder = new Group().add(model);
holder.scale.setScalar(1 / radius);${turned('holder')}
scene.add(holder);`,
  };
}

/** A number of any size, with as few digits as possible without moving anything by a pixel. */
const exact = (value: number): number => Number(value.toPrecision(5));

function clipPart({ model: { clip } }: CodeDrawing, hasClips = false): Part {
  if (!clip || !hasClips) return { code: '' };
  return {
    three: ['AnimationMixer'],
    code: `const mixer = new AnimationMixer(model);
mixer.clipAction(animations[${clip.index}]).play();
mixer.setTime(${round(clip.time)});`,
  };
}

function lookPart({ model, settings }: CodeDrawing): Part {
  const preset = presetOf(settings);
  const three: string[] = [];
  const hatching = ['applyHatching'];
  // Presets do not set these; the page does.
  const own: string[] = [];
  if (settings.shadows === 'on' && settings.shadowStrokes !== 'tone')
    own.push(`shadowStrokes: '${settings.shadowStrokes}'`);
  if (settings.occlusion > 0) own.push(`occlusion: ${settings.occlusion / 100}`);
  if (model.isOpen) {
    own.push('side: DoubleSide');
    three.push('DoubleSide');
  }
  own.push(...compositionParameters(settings, true));
  let look: string[];
  let rest: string;
  let before = '';
  if (preset) {
    hatching.push('presets', 'scalePreset');
    before = `const preset = scalePreset(presets.${preset}, ${SHARE});\n`;
    look = ['...preset.material'];
    if (settings.surfaceColors === 'paper') own.push(`color: 'white'`, 'map: null', 'vertexColors: false');
    rest = '  ...preset,\n';
  } else {
    if (drawnWithMap(settings)) {
      hatching.push('TonalArtMap');
      if (settings.mapStyle === 'file') {
        before = '// The playground saves your map as a ZIP: unpack it beside this file.\n';
      } else if (settings.mapStyle === 'ownHand') {
        before = '// The playground saves your own hand as hand.json: put it beside this file.\n';
      }
      before += `const tonalArtMap = ${mapSource(settings)};\n`;
    }
    look = materialParameters(settings, true, SHARE);
    if (shiftsStrokes(settings)) three.push('Vector2');
    const outlines = settings.outlines === 'on' ? outlineParameters(settings, SHARE) : undefined;
    rest = outlines ? `  outlines: {\n${outlines.map((line) => `    ${line},\n`).join('')}  },\n` : '';
  }
  const entries = [...look, ...own].map((entry) => `  ${entry},\n`).join('');
  let after = '';
  if (settings.color !== '#ffffff') {
    three.push('Color');
    after += `\nfor (const { color } of hatching.materials) color.multiply(new Color('${settings.color}'));`;
  }
  if (settings.occlusion > 0) {
    hatching.push('bakeOcclusion');
    after += '\nawait bakeOcclusion(holder);';
  }
  return {
    three,
    hatching,
    code: `${before}const look = {
${entries}};
const tilesPerUnit = ${round(settings.tilesPerUnit)}; // tiles per unit of the scene
const hatching = await applyHatching(holder, {
${rest}  material: look,
  tilesPerWorldUnit: tilesPerUnit,
});${after}`,
  };
}

const shadowNumbersOf = (settings: Settings): string =>
  Object.entries(shadowNumbers(settings))
    .map(([name, value]) => `\n  ${name}: ${round(value)},`)
    .join('');

function groundPart({ settings, groundHeight }: CodeDrawing): Part {
  if (settings.ground === 'none') return { code: '' };
  const { size, parts } = GROUND;
  const kind =
    settings.ground === 'shadow'
      ? `\n  toneModel: 'shadow', // nothing but shadows${shadowNumbersOf(settings)}\n  transparent: true,\n  paperOpacity: 0,\n  depthWrite: false,`
      : '';
  return {
    three: ['Mesh', 'PlaneGeometry'],
    hatching: ['HatchingMaterial', 'prepareHatchingGeometry'],
    code: `const plane = new PlaneGeometry(${size}, ${size}, ${parts}, ${parts}).rotateX(-Math.PI / 2);
const groundMaterial = new HatchingMaterial({
  ...look,
  tonalArtMap: hatching.materials[0].tonalArtMap,
  extent: hatching.materials[0].extent,
  tilesPerUnit,
  color: '${settings.color}',${kind}
});
const ground = new Mesh(await prepareHatchingGeometry(plane${prepareArgument(settings)}), groundMaterial);
ground.position.y = ${round(groundHeight)};
ground.receiveShadow = true;
scene.add(ground);`,
  };
}

function backgroundPart(settings: Settings): Part {
  const look = backgroundLook(settings);
  if (!look) return { code: '' };
  const { spacing, ink, ...numbers } = look;
  const entries = Object.entries(numbers).map(([name, value]) => `  ${name}: ${round(value)},\n`);
  return {
    hatching: ['HatchingBackground'],
    code: `scene.add(new HatchingBackground(hatching.materials[0].extent, {
${entries.join('')}  spacing: ${round(spacing)} * ${SHARE},
  ink: '${ink}',
}));`,
  };
}

function lightsPart(settings: Settings): Part {
  const { made, name } = mainLight(settings);
  const at = (place: LightPlace) => positionOf(place, place.distance ?? SUN_DISTANCE);
  const three = [name];
  const second = placeOfSecondLight(settings);
  const lines = [`const light = ${made};`, `light.position.${at(placeOfLight(settings))};`];
  if (second) {
    three.push('DirectionalLight');
    lines.push(
      `const second = new DirectionalLight('white', ${intensityOf(settings.secondStrength)});`,
      `second.position.${at(second)};`,
    );
  }
  const names = second ? 'light, second' : 'light';
  lines.push(`const lights = [${names}];`, 'scene.add(...lights);');
  if (settings.shadows === 'on') {
    const { reach, near, far, mapSize, normalBias, softness } = SHADOWS;
    lines.push(
      `for (const one of lights) {
  one.castShadow = true;
  const { shadow } = one;
  Object.assign(shadow.camera, { near: ${near}, far: ${far} });
  if (one.isDirectionalLight) Object.assign(shadow.camera, { left: -${reach}, right: ${reach}, bottom: -${reach}, top: ${reach} });
  shadow.mapSize.set(${mapSize}, ${mapSize});
  shadow.normalBias = ${normalBias};
  shadow.radius = ${softness};
}
holder.traverse((object) => {
  if (object.isMesh) object.castShadow = object.receiveShadow = true;
});`,
    );
  }
  if (settings.lightFollows === 'viewer') lines.push('const places = lights.map(({ position }) => position.clone());');
  return { code: lines.join('\n'), three };
}

/** How the camera shows as much in a picture of any proportion as on the page. */
function proportionCode({ camera: { lens }, aspect }: CodeDrawing): string {
  if (!lens) {
    return `  camera.aspect = width / height;
  // A narrow picture shows as much of the width as a wide one.
  const widening = Math.max(1, ${round(aspect)} / camera.aspect);
  const slope = Math.tan(MathUtils.degToRad(${LENS.fieldOfView / 2}));
  camera.fov = MathUtils.radToDeg(2 * Math.atan(widening * slope));`;
  }
  const [high, wide] = [lens.high, lens.high * lens.aspect].map((size) => Number(size.toPrecision(5)));
  const half = wide > 0 ? `Math.max(${high}, ${wide} / aspect)` : high;
  return `  const aspect = width / height;
  // All that the camera of the file sees is in the picture.
  const half = ${half};
${
  lens.isOrthographic
    ? '  Object.assign(camera, { left: -half * aspect, right: half * aspect, top: half, bottom: -half });'
    : '  camera.aspect = aspect;\n  camera.fov = MathUtils.radToDeg(2 * Math.atan(half));'
}`;
}

function framesPart(drawing: CodeDrawing, hasClips = false): Part {
  const { model, settings } = drawing;
  const following =
    settings.lightFollows === 'viewer'
      ? `
  // The lights stay with the viewer.
  for (const [i, { position }] of lights.entries()) position.copy(places[i]).applyQuaternion(camera.quaternion);`
      : '';
  const isPlaying = hasClips && model.clip?.isPlaying;
  const playing = isPlaying
    ? `
let before = performance.now();
renderer.setAnimationLoop((now) => {
  mixer.update((now - before) / 1000);
  before = now;
  draw();
});`
    : '';
  return {
    three: ['MathUtils'],
    code: `// A frame is drawn when something has changed.
const draw = () => {${following}
  renderer.render(scene, camera);
};
controls.addEventListener('change', draw);
new ResizeObserver(() => {
  const { clientWidth: width, clientHeight: height } = canvas;
  if (width === 0 || height === 0) return;
  renderer.setSize(width, height, false);
${proportionCode(drawing)}
  camera.updateProjectionMatrix();
  draw();
}).observe(canvas);${playing}`,
  };
}
