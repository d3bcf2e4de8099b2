import type {
  BufferGeometry,
  Color,
  HemisphereLight,
  InstancedMesh,
  Light,
  LightProbe,
  LOD,
  Material,
  Matrix4,
  Mesh,
  Object3D,
  Scene,
  SkinnedMesh,
  SpotLight,
  Texture,
} from 'three';
import { hatchNormal } from '../../mesh/bake/attributeLayouts.js';
import type { HatchingMaterialProperties } from '../HatchingMaterialProperties.js';
import { versionOf } from './surfaceSamples.js';
import { isFitted } from './ToneFit.js';

/**
 * The lights of a scene and the meshes whose exposure is fitted to them. Everything that the fit depends on is also kept as an array of
 * numbers, which shows whether anything has changed. Of objects with several levels of detail, which depend on the camera, the first
 * level counts.
 */
export class SceneContents {
  readonly meshes: Mesh[] = [];
  /** For each mesh, the first material whose exposure is fitted. Those of its groups are with the mesh. */
  readonly materials: HatchingMaterialProperties[] = [];
  readonly lights: Light[] = [];
  /** The material or materials of the previous mesh, and the fitted one of them: thousands of meshes may share them. */
  private given: Material | Material[] | undefined;
  private fitted: HatchingMaterialProperties | undefined;
  scene: Object3D | undefined;
  private facts = new Float64Array(256);
  private count = 0;
  private meshCount = 0;
  private lightCount = 0;
  private hasChanged = false;

  /**
   * Reads a scene whose world matrices are up to date. Allocates nothing unless something was added.
   *
   * @param layers the mask of the layers whose lights count
   * @returns whether anything has changed since the previous call
   */
  read(scene: Object3D, layers: number): boolean {
    const before = this.count;
    this.scene = scene;
    this.count = this.meshCount = this.lightCount = 0;
    this.given = undefined;
    this.hasChanged = false;
    this.visit(scene, layers);
    this.noteEnvironment(scene as Scene);
    shorten(this.meshes, this.meshCount);
    shorten(this.materials, this.meshCount);
    shorten(this.lights, this.lightCount);
    return this.hasChanged || this.count !== before;
  }

  private note(fact: number): void {
    const facts = this.factsFor(1);
    // NaN differs from itself; a fact that is NaN is no change.
    if (facts[this.count] !== fact) {
      facts[this.count] = fact;
      this.hasChanged ||= !Number.isNaN(fact);
    }
    this.count++;
  }

  /** The array of facts, enlarged if needed. */
  private factsFor(more: number): Float64Array {
    if (this.count + more > this.facts.length) {
      const longer = new Float64Array(2 * this.facts.length);
      longer.set(this.facts);
      this.facts = longer;
    }
    return this.facts;
  }

  private visit(object: Object3D, layers: number): void {
    if ('isLight' in object) this.noteLight(object as Light, layers);
    else if ('isMesh' in object) this.noteMesh(object as Mesh);
    const { children } = object;
    const finest = 'isLOD' in object ? (object as LOD).levels[0]?.object : undefined;
    for (let i = 0; i < children.length; i++) {
      const child = children[i];
      if (finest ? child === finest : child.visible) this.visit(child, layers);
    }
  }

  private noteLight(light: Light, layers: number): void {
    if ((light.layers.mask & layers) === 0) return;
    this.lights[this.lightCount++] = light;
    this.note(light.id);
    this.note(light.intensity);
    this.noteColor(light.color);
    this.noteMatrix(light.matrixWorld);
    const { target, distance, decay, angle, penumbra } = light as SpotLight;
    if (target) this.noteMatrix(target.matrixWorld);
    if (distance !== undefined) this.note(distance);
    if (decay !== undefined) this.note(decay);
    if (angle !== undefined) this.note(angle);
    if (penumbra !== undefined) this.note(penumbra);
    if ('groundColor' in light) this.noteColor((light as HemisphereLight).groundColor);
    if ('sh' in light)
      for (const color of (light as LightProbe).sh.coefficients) this.noteVector(color.x, color.y, color.z);
  }

  private noteMesh(mesh: Mesh): void {
    const isOther = mesh.material !== this.given;
    if (isOther) this.fitted = fittedMaterial(mesh.material);
    this.given = mesh.material;
    const material = this.fitted;
    if (!material || !mesh.geometry?.attributes.position || 'isBatchedMesh' in mesh) return;
    this.meshes[this.meshCount] = mesh;
    this.materials[this.meshCount++] = material;
    this.note(mesh.id);
    this.noteGeometry(mesh.geometry);
    if (!isOther) this.note(material.id);
    else if (Array.isArray(mesh.material)) this.noteMaterials(mesh.material);
    else this.noteMaterial(material);
    this.noteMatrix(mesh.matrixWorld);
    if ('isInstancedMesh' in mesh) {
      this.note((mesh as InstancedMesh).count);
      this.note(versionOf((mesh as InstancedMesh).instanceMatrix));
    }
    const bone = (mesh as SkinnedMesh).skeleton?.bones[0];
    if (bone) this.noteMatrix(bone.matrixWorld);
  }

  private noteMaterials(given: readonly Material[]): void {
    for (let i = 0; i < given.length; i++)
      if (isFittedMaterial(given[i])) this.noteMaterial(given[i] as unknown as HatchingMaterialProperties);
  }

  private noteGeometry({ id, attributes, index, groups, drawRange }: BufferGeometry): void {
    this.note(id);
    this.note(versionOf(attributes.position));
    this.note(versionOf(attributes[hatchNormal.name]));
    this.note(versionOf(index));
    this.note(versionOf(attributes.color));
    this.note(versionOf(attributes.uv));
    this.note(groups.length);
    this.note(drawRange.start);
    this.note(drawRange.count === Infinity ? -1 : drawRange.count);
  }

  private noteMaterial(material: HatchingMaterialProperties): void {
    this.note(material.id);
    this.note(material.side);
    this.note(Number(material.toneModel === 'halfLambert'));
    this.note(material.reflectedLight);
    this.note(material.occlusion);
    this.note(material.emissiveIntensity);
    this.noteColor(material.emissive);
    this.note(material.emissiveMap?.id ?? -1);
    this.note(Number(material.colorHatching > 0));
    this.note(Number(material.vertexColors));
    this.noteColor(material.color);
    this.noteMap(material.map);
  }

  private noteMap(map: Texture | null): void {
    this.note(map?.id ?? -1);
    if (!map) return;
    this.note(map.version);
    this.noteVector(map.offset.x, map.offset.y, map.rotation);
    this.noteVector(map.repeat.x, map.repeat.y, map.channel);
  }

  private noteEnvironment({ environment, environmentIntensity, environmentRotation }: Scene): void {
    this.note(environment?.id ?? -1);
    if (!environment) return;
    this.note(environment.version);
    this.note(environmentIntensity);
    this.noteVector(environmentRotation.x, environmentRotation.y, environmentRotation.z);
  }

  private noteColor({ r, g, b }: Color): void {
    this.noteVector(r, g, b);
  }

  /** Stores the matrix of a mesh. Its numbers are compared here, because each would be allocated as an argument. */
  private noteMatrix({ elements }: Matrix4): void {
    const facts = this.factsFor(16);
    for (let i = 0; i < 16; i++, this.count++) {
      if (facts[this.count] === elements[i]) continue;
      facts[this.count] = elements[i];
      this.hasChanged ||= !Number.isNaN(elements[i]);
    }
  }

  private noteVector(x: number, y: number, z: number): void {
    this.note(x);
    this.note(y);
    this.note(z);
  }
}

/** Shortens an array. Setting an unchanged length, too, would make later additions allocate. */
function shorten(array: unknown[], length: number): void {
  if (array.length !== length) array.length = length;
}

/** Whether a material is one whose exposure is fitted, and is seen. */
export const isFittedMaterial = (material: Material | null | undefined): boolean =>
  !!material?.visible &&
  'isHatchingMaterial' in material &&
  isFitted(material as unknown as HatchingMaterialProperties);

function fittedMaterial(material: Material | Material[]): HatchingMaterialProperties | undefined {
  const found = Array.isArray(material) ? material.find(isFittedMaterial) : isFittedMaterial(material) && material;
  return found ? (found as unknown as HatchingMaterialProperties) : undefined;
}
