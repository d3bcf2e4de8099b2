import type { BufferGeometry, Camera, Object3D, Vector4, WebGLRenderer } from 'three';
import { silence } from '../diagnostics/silence.js';
import { isFetched } from '../parts/parts.js';
import type { DrawnMaterial, FirstDraw } from './FirstDraw.js';

/** What a mesh was drawn as when it was checked last. */
interface Seen {
  geometry: BufferGeometry;
  technique: unknown;
  toneMapped: boolean;
  isStale: boolean;
}

const waiting: FirstDraw[] = [];

/** The checks and their sentences, which are loaded when there is something to check; nobody waits for them. */
let checks: typeof import('./checkDraws.js') | undefined;

async function check(): Promise<void> {
  checks = await import('./checkDraws.js');
  checks.checkDraws(waiting.splice(0));
}

/** Whether a material has its code, and its map if it draws with one. */
const isWhole = (material: DrawnMaterial): boolean =>
  isFetched(material) && (material.uniforms.inked.value === 1 || material.tonalArtMap === null);

/** Knows which meshes one material has drawn, and has new ones checked for mistakes. */
export class DrawnMeshes {
  private readonly seen = new WeakMap<Object3D, Seen>();

  /** Notes that the material draws a mesh, to a part of the target in pixels. For one that was checked already this allocates nothing. */
  note(
    material: DrawnMaterial,
    renderer: WebGLRenderer,
    scene: Object3D,
    camera: Camera,
    geometry: BufferGeometry,
    mesh: Object3D,
    { w: height }: Vector4,
  ): void {
    if (silence.isOn) return;
    const stale = checks?.isStale(geometry) ?? false;
    const { technique, toneMapped } = material;
    const last = this.seen.get(mesh);
    const isSame = last?.geometry === geometry && last.technique === technique && last.toneMapped === toneMapped;
    if (isSame && last.isStale === stale) return;
    this.seen.set(mesh, { geometry, technique, toneMapped, isStale: stale });
    const isOnScreen = renderer.getRenderTarget() === null;
    const { frame } = renderer.info.render;
    const draw = { material, mesh, geometry, scene, camera, renderer, isOnScreen, height, frame };
    waiting.push({ ...draw, isWhole: isWhole(material) });
    // A page that cannot load the checks draws without them.
    if (waiting.length === 1) check().catch(() => waiting.splice(0));
  }
}
