import type { BufferGeometry, Camera, Object3D, Vector4, WebGLRenderer } from 'three';
import { silence } from '../diagnostics/warn.js';
import { isFetched } from '../parts/parts.js';
import type { DrawnMaterial, FirstDraw } from './FirstDraw.js';
import { loadChecks } from './loadChecks.js';

/** The state of a mesh when it was checked last. */
interface Seen {
  geometry: BufferGeometry;
  technique: unknown;
  toneMapped: boolean;
  isStale: boolean;
}

const waiting: FirstDraw[] = [];

/** The checks and their messages, loaded when there is something to check; drawing does not wait for them. */
let checks: typeof import('./checkDraws.js') | undefined;

async function check(load: NonNullable<typeof loadChecks>): Promise<void> {
  checks = await load();
  checks.checkDraws(waiting.splice(0));
}

/** Whether the code of a material, and its map if it uses one, have loaded. */
const isWhole = (material: DrawnMaterial): boolean =>
  isFetched(material) && (material.uniforms.inked.value === 1 || material.tonalArtMap === null);

/** Tracks the meshes that one material has drawn, and has new ones checked for mistakes. */
export class DrawnMeshes {
  private readonly seen = new WeakMap<Object3D, Seen>();

  /**
   * Registers that the material draws a mesh, to a part of the render target in pixels. Allocates nothing for a mesh that was checked
   * before.
   */
  note(
    material: DrawnMaterial,
    renderer: WebGLRenderer,
    scene: Object3D,
    camera: Camera,
    geometry: BufferGeometry,
    mesh: Object3D,
    { w: height }: Vector4,
  ): void {
    if (!loadChecks || silence.isOn) return;
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
    // If the checks cannot be loaded, the page draws without them.
    if (waiting.length === 1) check(loadChecks).catch(() => waiting.splice(0));
  }
}
