import { Matrix4, Quaternion, Vector3 } from 'three';
import { distinctNames, indexOfName, ModelError, shownName } from '../common/ModelError.js';
import { type FileCamera, type FileLight, type ModelExtras, movedExtras, NO_EXTRAS } from '../common/ModelExtras.js';
import type { ChosenScene } from './chooseScene.js';
import type { GltfCamera, GltfDocument, GltfLight, GltfNode } from './gltfDocument.js';

/** Default angle of a spot light, from KHR_lights_punctual. */
const SPOT_ANGLE = Math.PI / 4;
/** Luminance weights of linear RGB (Rec. 709). */
const [RED, GREEN, BLUE] = [0.2126, 0.7152, 0.0722];
/** The viewing or lighting direction and the up direction, in the node's own space. */
const FORWARDS = [0, 0, -1] as const;
const UP = [0, 1, 0] as const;

/** The cameras and lights of the shown scene, in its space and at rest, and the names of variants. */
export function gltfExtras(document: GltfDocument, { roots, visible }: ChosenScene): ModelExtras {
  const shown = new Set(visible);
  const cameras: FileCamera[] = [];
  const lights: FileLight[] = [];
  const pending = roots.map((node) => ({ node, matrix: matrixOf(document.nodes[node]) })).reverse();
  for (let next = pending.pop(); next; next = pending.pop()) {
    const { matrix } = next;
    const node = document.nodes[next.node];
    if (!shown.has(next.node)) continue;
    const camera = cameraOf(document.cameras?.[node.camera ?? -1], node.name);
    const light = lightOf(document.lights?.[node.extensions?.KHR_lights_punctual?.light ?? -1]);
    const placed = movedExtras(
      { ...NO_EXTRAS, cameras: camera ? [camera] : [], lights: light ? [light] : [] },
      unscaled(matrix),
    );
    cameras.push(...placed.cameras.filter(isSomewhere));
    lights.push(...placed.lights.filter(isSomewhere));
    for (const child of [...(node.children ?? [])].reverse())
      pending.push({ node: child, matrix: matrix.clone().multiply(matrixOf(document.nodes[child])) });
  }
  const names = distinctNames(
    cameras.map(({ name }) => name),
    'Camera',
  );
  const named = cameras.map((camera, i) => ({ ...camera, name: names[i] }));
  return { cameras: named, lights, variants: variantsOf(document) };
}

const isSomewhere = ({ position, forwards }: FileCamera | FileLight): boolean =>
  [...position, ...forwards].every(Number.isFinite);

/** The names of material variants, in file order. */
const variantsOf = ({ variants = [] }: GltfDocument): string[] =>
  distinctNames(
    variants.map((variant) => variant?.name),
    'Variant',
  );

/**
 * Gives all primitives the materials of a variant; those without one for it keep theirs.
 *
 * @param wanted its index, where an unknown one means none, or as text its name or its number counted from 1
 * @throws ModelError if there is no variant of this name
 */
export function useVariant(document: GltfDocument, wanted: string | number, fileName: string): void {
  const names = variantsOf(document);
  const isNumber = typeof wanted === 'number';
  const index = isNumber ? wanted : indexOfName(names, wanted);
  if (names.length === 0 && !isNumber) throw new ModelError(`${fileName} has no variants of its materials.`);
  if (index === -1) {
    const known = names.map(shownName).join(', ');
    throw new ModelError(`${fileName} has no variant ${shownName(String(wanted))}; it has ${known}.`);
  }
  for (const { primitives } of document.meshes) {
    for (const primitive of primitives) {
      const { mappings = [] } = primitive.extensions?.KHR_materials_variants ?? {};
      const mapping = mappings.find((one) => one?.variants.includes(index));
      if (mapping) primitive.material = mapping.material;
    }
  }
}

/** Removes scale from a matrix, since cameras are not scaled by their nodes. */
function unscaled(matrix: Matrix4): Matrix4 {
  const [position, turn, scale] = [new Vector3(), new Quaternion(), new Vector3()];
  matrix.decompose(position, turn, scale);
  return new Matrix4().compose(position, turn, new Vector3(1, 1, 1));
}

function matrixOf({ matrix, translation = [0, 0, 0], rotation = [0, 0, 0, 1], scale = [1, 1, 1] }: GltfNode): Matrix4 {
  if (matrix) return new Matrix4().fromArray(matrix);
  return new Matrix4().compose(
    new Vector3().fromArray(translation),
    new Quaternion().fromArray(rotation),
    new Vector3().fromArray(scale),
  );
}

function cameraOf(camera: GltfCamera | undefined, nodeName: string | undefined): FileCamera | undefined {
  const { type, perspective, orthographic } = camera ?? {};
  const placed = {
    name: camera?.name || nodeName || '',
    position: [0, 0, 0] as [number, number, number],
    forwards: [...FORWARDS] as [number, number, number],
    up: [...UP] as [number, number, number],
  };
  if (type === 'perspective' && perspective) {
    const { yfov, aspectRatio } = perspective;
    if (!(yfov > 0 && yfov < Math.PI)) return undefined;
    return { ...placed, high: Math.tan(yfov / 2), isOrthographic: false, aspect: positive(aspectRatio) };
  }
  if (type !== 'orthographic' || !orthographic) return undefined;
  const { xmag, ymag } = orthographic;
  if (!(xmag > 0 && ymag > 0)) return undefined;
  return { ...placed, high: ymag, isOrthographic: true, aspect: xmag / ymag };
}

const positive = (value: number | undefined): number | undefined =>
  value !== undefined && value > 0 ? value : undefined;

function lightOf(light: GltfLight | undefined): FileLight | undefined {
  if (!light) return undefined;
  const { type, color: [r, g, b] = [1, 1, 1], intensity = 1, spot } = light;
  const sent = intensity * (RED * r + GREEN * g + BLUE * b);
  if (!(sent > 0)) return undefined;
  return {
    kind: type,
    intensity: sent,
    position: [0, 0, 0],
    forwards: [...FORWARDS],
    angle: spot?.outerConeAngle ?? SPOT_ANGLE,
  };
}
