import type {
  Color,
  ColorRepresentation,
  DirectionalLight,
  InstancedMesh,
  Material,
  Mesh,
  Object3D,
  SkinnedMesh,
  Texture,
} from 'three';
import type { HatchingMaterial, HatchingMaterialParameters, PropertyNameOf } from 'three-hatching';
import { HATCHING_DEFAULTS, HATCHING_PROPERTIES, type HatchingProperty, scaledSizes } from 'three-hatching/facts';
import type { HatchingNodeMaterial, HatchingOutlineNodeMaterial, HatchingOutlines } from 'three-hatching/webgpu';
import type { Look } from '../settings/lookOf.js';

/** A material for either renderer; both kinds have the same properties. */
export type EitherMaterial = HatchingMaterial | HatchingNodeMaterial;

/** Creates what WebGPURenderer needs to draw a model. This room imports only types, so that the renderer is loaded on demand. */
export interface NodeMakers {
  /** A node material that looks like a material for WebGLRenderer. */
  material(like: HatchingMaterial): HatchingNodeMaterial;
  outlineMaterial(): HatchingOutlineNodeMaterial;
  outlines(mesh: Mesh | null, material: HatchingOutlineNodeMaterial): HatchingOutlines;
}

/**
 * Returns a function that sets these parameters on a material; they are sorted by kind once for all materials. Unlike `setValues`, it does
 * not warn of properties that the present technique ignores, since the page keeps them for the next technique.
 */
export function parameterSetter(parameters: HatchingMaterialParameters): (material: EitherMaterial) => void {
  const entries = Object.entries(parameters) as [PropertyNameOf<undefined>, unknown][];
  const colors = entries.filter(
    ([name]) => (HATCHING_PROPERTIES as Record<string, HatchingProperty>)[name]?.kind === 'color',
  );
  const others = Object.fromEntries(entries.filter((entry) => !colors.includes(entry)));
  return (material) => {
    Object.assign(material, others);
    for (const [name, value] of colors) (material[name] as Color).set(value as ColorRepresentation);
  };
}

const { minLineSpacing } = HATCHING_DEFAULTS;

/**
 * The sizes of materials on a sheet.
 *
 * @param share of the full stroke width, below 1 on small sheets
 * @param scale of a picture relative to the page
 */
export function materialSizesIn(
  { sizes, drawn: { screenSpaceShare } }: Look,
  share: number,
  scale = 1,
): HatchingMaterialParameters {
  return {
    ...sizes,
    ...scaledSizes({ ...sizes, screenSpaceShare }, share * scale),
    // The spacing below which lines merge does not depend on the size of the sheet.
    ...scaledSizes({ minLineSpacing }, scale),
  };
}

/** The sizes of outlines. @param factor on all of them */
export function outlineSizesIn({ outlines }: Look, factor: number) {
  return {
    outlineWidth: outlines.outlineWidth * factor,
    wobble: outlines.wobble * factor,
    overshoot: outlines.overshoot * factor,
    paperGrainSize: outlines.paperGrainSize * factor,
  };
}

/**
 * Disposes of the GPU resources of objects while the context is lost; they are uploaded again when drawn. If they were disposed of after
 * the context is restored, three.js would delete them in a context that never had them.
 */
export function releaseGraphics(root: Object3D): void {
  root.traverse((object) => {
    const { geometry, material, skeleton } = object as Partial<SkinnedMesh>;
    geometry?.dispose();
    for (const one of material ? [material].flat() : []) releaseMaterial(one);
    // The skeleton's bone texture is created again at the next rendering.
    skeleton?.dispose();
    if ('isLight' in object) (object as DirectionalLight).shadow?.dispose();
    // The event makes the renderer free its copy; the instances keep their data.
    if ('isInstancedMesh' in object) (object as InstancedMesh).dispatchEvent({ type: 'dispose' });
  });
}

/** As {@link releaseGraphics}, for a material and its textures. */
export function releaseMaterial(material: Material): void {
  material.dispose();
  for (const texture of texturesOf(material)) texture.dispose();
}

/** As {@link releaseGraphics}, for objects that will not be drawn again: closes their bitmaps too. */
export function freeGraphics(root: Object3D): void {
  releaseGraphics(root);
  root.traverse((object) => {
    const { material } = object as Partial<SkinnedMesh>;
    for (const one of material ? [material].flat() : []) {
      for (const { image } of texturesOf(one)) (image as Partial<ImageBitmap> | null)?.close?.();
    }
  });
}

function texturesOf(material: Material): Texture[] {
  const { uniforms = {} } = material as { uniforms?: Record<string, { value: unknown }> };
  const values: unknown[] = [...Object.values(material), ...Object.values(uniforms).map(({ value }) => value)];
  return values.filter(isTexture);
}

const isTexture = (value: unknown): value is Texture =>
  typeof value === 'object' && value !== null && 'isTexture' in value && value.isTexture === true;
