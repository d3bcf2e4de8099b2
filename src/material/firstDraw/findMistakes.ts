import {
  type AmbientLight,
  type BufferAttribute,
  type BufferGeometry,
  type Camera,
  type Color,
  type HemisphereLight,
  type Light,
  type Object3D,
  type PointLight,
  type Scene,
  Sphere,
  Vector3,
} from 'three';
import { counts } from '../../look/measuredFacts.js';
import { luminanceOf } from '../../look/vectors.js';
import { hatchNormal } from '../../mesh/bake/attributeLayouts.js';
import { isFitted } from '../exposure/ToneFit.js';
import { identityOf } from '../geometry/identityOf.js';
import type { TonalArtMap } from '../tam/TonalArtMap.js';
import type { FirstDraw, NoteMistake } from './FirstDraw.js';
import { rounded } from './sentences.js';

/** An object of a scene, and its bounding sphere if it has one. */
interface Bounded extends Object3D {
  geometry?: BufferGeometry;
  boundingSphere?: Sphere | null;
}

/** A bounding sphere of meshes in world space; empty if none of them has bounds. */
function worldSphere(meshes: Iterable<Object3D>): Sphere {
  const whole = new Sphere().makeEmpty();
  for (const mesh of meshes) {
    // Instances, batches and skins have a sphere beside that of their geometry.
    const { geometry, boundingSphere } = mesh as Bounded;
    const own = boundingSphere ?? geometry?.boundingSphere;
    if (own && own.radius >= 0) whole.union(own.clone().applyMatrix4(mesh.matrixWorld));
  }
  if (whole.isEmpty()) whole.radius = Infinity;
  return whole;
}

/** The light that arrives somewhere, as a sum of intensities. A surface that faces light of sum π is blank paper. */
export interface LightSum {
  /** The least light on any surface that faces the lights. */
  least: number;
  /** The greatest; infinite if the intensity of a light does not tell its strength. */
  most: number;
  /** Whether any of the lights is more than ambient. */
  hasForm: boolean;
}

/** Adds up the lights of a scene as they arrive in a sphere, without shadows and cones. */
function lightOn({ center, radius }: Sphere, scene: Object3D, camera: Camera): LightSum {
  const sum: LightSum = { least: 0, most: 0, hasForm: false };
  const add = (least: number, most: number): void => {
    sum.least += least;
    sum.most += most;
  };
  if ((scene as Scene).environment) {
    add(0, Infinity);
    sum.hasForm = true;
  }
  scene.traverseVisible((object) => {
    if (!('isLight' in object) || !object.layers.test(camera.layers)) return;
    const light = object as Light;
    const full = light.intensity * luminanceOf(light.color);
    if (full > 0 && !(light as Partial<AmbientLight>).isAmbientLight) sum.hasForm = true;
    switch (light.type) {
      case 'AmbientLight':
      case 'DirectionalLight':
        add(full, full);
        break;
      case 'HemisphereLight': {
        const ground = light.intensity * luminanceOf((light as HemisphereLight).groundColor);
        add(Math.min(full, ground), Math.max(full, ground));
        break;
      }
      case 'PointLight':
      case 'SpotLight': {
        const away = new Vector3().setFromMatrixPosition(light.matrixWorld).distanceTo(center);
        const lamp = light as PointLight;
        const least = light.type === 'PointLight' ? lampAt(lamp, full, away + radius) : 0;
        add(least, lampAt(lamp, full, Math.max(away - radius, 0)));
        break;
      }
      default:
        add(0, full > 0 ? Infinity : 0);
    }
  });
  return sum;
}

/** The light of a lamp at a distance, by three's formula. */
function lampAt({ decay, distance: reach }: PointLight, full: number, distance: number): number {
  const left = full / Math.max(distance ** decay, 0.01);
  return reach > 0 ? left * Math.max(1 - (distance / reach) ** 4, 0) ** 2 : left;
}

/** Sums of intensities below and above which nearly everything is black or blank. A single light of intensity 1 is too dark. */
const TOO_DARK = Math.PI / 3;
const TOO_BRIGHT = 4 * Math.PI;

/** The identities of scenes whose lights were checked. Meshes that come into view later may stand far from their lights on purpose. */
const checkedScenes = new WeakSet<object>();

/** Finds a mistake in the lights of a scene, from its meshes that are drawn first. */
export function findLightMistake(draws: readonly FirstDraw[], note: NoteMistake): void {
  const lit = draws.filter(({ material }) => material.lights);
  if (lit.length === 0) return;
  const [first] = lit;
  const { scene, camera } = first;
  if (checkedScenes.has(identityOf(scene))) return;
  checkedScenes.add(identityOf(scene));
  const sphere = worldSphere(lit.map(({ mesh }): Object3D => mesh));
  const { least, most, hasForm } = lightOn(sphere, scene, camera);
  // An exposure that is fitted to the scene suits any light.
  const isExposed = lit.every(({ material }) => isFitted(material));
  if (least > TOO_BRIGHT && !isExposed) note('tooBright', first, scene, rounded(least));
  else if ((most >= TOO_DARK || (most > 0 && isExposed)) && hasForm) return;
  else if (lit.some(hasOwnForm)) return;
  else if (most === 0) note('noLight', first, scene);
  else if (!hasForm) note('ambientOnly', first, scene);
  else note('tooDark', first, scene, rounded(most));
}

/** Whether a mesh shows its form under any light: by light maps, emission or baked occlusion. */
function hasOwnForm({ material, geometry }: FirstDraw): boolean {
  const { lightMap, aoMap, emissive, emissiveIntensity, occlusion } = material;
  if (lightMap || aoMap || luminanceOf(emissive as Color) * (emissiveIntensity as number) > 0) return true;
  const normals = geometry.attributes[hatchNormal.name] as BufferAttribute | undefined;
  if (occlusion === 0 || !normals?.array) return false;
  for (let i = 0; i < normals.count; i++) if (normals.getW(i) !== 0) return true;
  return false;
}

/**
 * Stroke widths in pixels of the drawing buffer, below and above which a mistake is likely. Strokes that are a little thinner than a
 * pixel, or very wide, are a matter of taste.
 */
const TOO_THIN = 0.5;
const WIDE = 32;
/** Lengths of strokes, as shares of a tile. */
const LONGEST_STROKE = 0.5;
/** The unit of `lineSpacing` on the object, as a share of a tile. */
const SPACING_UNIT = 1 / 256;
/** Values that suit every model: tiles per radius, and widths of strokes and distances of lines in pixels. */
const SUITABLE = { tilesPerRadius: 3, strokeWidth: 1.5, lineSpacing: 5 };

/** Finds strokes that are too small or too large to be seen as strokes, from the meshes of a scene that are drawn first. */
export function findStrokeMistakes(draws: readonly FirstDraw[], note: NoteMistake): void {
  // All hatched meshes of the scene count as one model. It is measured once, and only if strokes are sized on it.
  let model: Sphere | undefined;
  for (const draw of draws) {
    const { material, scene } = draw;
    const onScreen = counts(material, 'screenSpaceShare') ? material.screenSpaceShare : 0;
    if (onScreen === 0) {
      model ??= hatchedMeshes(scene);
      checkOnObject(draw, model, note);
    } else if (onScreen === 1) checkOnScreen(draw, note);
  }
}

function checkOnObject(draw: FirstDraw, model: Sphere, note: NoteMistake): void {
  const { material, mesh } = draw;
  const tilesPerObjectUnit = material.tilesPerObjectUnit as number;
  const scale = mesh.matrixWorld.getMaxScaleOnAxis();
  const tile = scale / tilesPerObjectUnit;
  const forModel = (SUITABLE.tilesPerRadius / model.radius) * scale;
  const say = (mistake: 'tooFine' | 'tooCoarse', suitable: number): void =>
    note(mistake, draw, material, 'tilesPerObjectUnit', rounded(tilesPerObjectUnit), rounded(suitable));
  const length = counts(material, 'lineSpacing') ? (material.lineSpacing as number) * SPACING_UNIT : LONGEST_STROKE;
  // Strokes as long as the model are plausible; those of twice its diameter are a mistake.
  if (tile * length > 4 * model.radius) say('tooCoarse', forModel);
  const map = material.tonalArtMap as TonalArtMap | string | null;
  if (!map || typeof map === 'string' || !counts(material, 'tonalArtMap')) return;
  // Levels of the map keep the drawn width of strokes, down to the coarsest level.
  const coarsest = map.size >> (map.levels - 1);
  const width = (tile * pixelsPerUnit(draw) * map.strokeTexels) / coarsest;
  // A distant model needs larger strokes than one that fills the picture.
  if (width < TOO_THIN) say('tooFine', Math.min(forModel, (tilesPerObjectUnit * width) / SUITABLE.strokeWidth));
}

function checkOnScreen(draw: FirstDraw, note: NoteMistake): void {
  const { material, mesh, renderer } = draw;
  const property = counts(material, 'lineSpacing') ? 'lineSpacing' : 'strokeWidth';
  const size = material[property] as number | null;
  if (size === null) return;
  const say = (mistake: 'tooFine' | 'tooCoarse'): void =>
    note(mistake, draw, material, property, rounded(size), String(SUITABLE[property]));
  const pixels = size * renderer.getPixelRatio();
  if (pixels < TOO_THIN) say('tooFine');
  else if (pixels > WIDE && pixels > 2 * worldSphere([mesh]).radius * pixelsPerUnit(draw)) say('tooCoarse');
}

/** The number of pixels per world unit at the point of the mesh that is nearest to the camera. */
function pixelsPerUnit({ mesh, camera, height }: FirstDraw): number {
  const { elements } = camera.projectionMatrix;
  const pixels = (Math.abs(elements[5]) * height) / 2;
  if (elements[11] === 0) return pixels;
  const { center, radius } = worldSphere([mesh]);
  const depth = -center.clone().applyMatrix4(camera.matrixWorldInverse).z - radius;
  return depth > 0 ? pixels / depth : Infinity;
}

/** A sphere around all hatched meshes of a scene: one stroke size serves the whole model, not each of its parts. */
function hatchedMeshes(scene: Object3D): Sphere {
  const meshes: Object3D[] = [];
  scene.traverseVisible((object) => {
    const { material } = object as { material?: object };
    if ([material].flat().some((one) => one && 'isHatchingMaterial' in one)) meshes.push(object);
  });
  return worldSphere(meshes);
}
