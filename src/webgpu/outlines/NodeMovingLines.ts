import {
  type Camera,
  Color,
  FloatType,
  FrontSide,
  type InstancedMesh,
  type IUniform,
  type Material,
  type Mesh,
  NearestFilter,
  NoBlending,
  Object3D,
  RenderTarget,
  type Scene,
  type Vector4,
  type WebGLRenderer,
} from 'three';
import { type NodeBuilder, NodeMaterial, type WebGPURenderer } from 'three/webgpu';
import type { NumberedPart } from '../../material/outlines/NumberedPart.js';
import type { DrawnOutlines, LineDrawer } from '../../material/outlines/ScreenLines.js';
import { PosedCopy } from '../../material/three/PosedCopy.js';
import { threeNodes, tsl } from '../nodes/base/values.js';
import { clearInstanceNodes, clearNodes, meetingNodes } from '../nodes/outlines/meeting.js';
import { partWord, placePart } from '../nodes/outlines/partMap.js';
import { clippingOf } from './clippingOf.js';
import type { HatchingOutlineNodeMaterial, MakeNodes } from './HatchingOutlineNodeMaterial.js';
import { placesOf } from './instancePlaces.js';
import { hasFloatTargets } from './NodePosePass.js';

/** Outlines of nodes. */
interface Outlines extends DrawnOutlines {
  readonly material: HatchingOutlineNodeMaterial;
  drawOnScreen(
    renderer: WebGPURenderer,
    scene: Scene,
    camera: Camera,
    material: HatchingOutlineNodeMaterial,
    pass: string,
  ): void;
}

/** The uniforms of lines that outlines do not have, and their opacity: outlines of what is seen through may be paler. */
const OF_LINES = ['partMap', 'partLook', 'partNumber', 'opacity'];

const noColor = /* @__PURE__ */ new Color(0);
const clearColor = /* @__PURE__ */ new Color();

/** Draws a part into the map of parts. */
class PartMaterial extends NodeMaterial {
  /** The uniforms that nodes read. */
  readonly uniforms: Record<'partNumber' | 'partLook' | 'instancePlaces', IUniform> = {
    partNumber: { value: 0 },
    partLook: { value: 0 },
    instancePlaces: { value: null },
  };

  static override get type(): string {
    return 'HatchingPartNodeMaterial';
  }

  constructor(private readonly isInstanced: boolean) {
    super();
    this.outputNode = partWord;
    this.blending = NoBlending;
    // Applications that render without opaque objects still draw outlines.
    this.transparent = true;
    this.forceSinglePass = true;
    this.fog = false;
    this.lights = false;
  }

  override customProgramCacheKey(): string {
    return `HatchingPart ${this.isInstanced}`;
  }

  override setupPosition(builder: NodeBuilder): ReturnType<NodeMaterial['setupPosition']> {
    placePart(builder, this.isInstanced);
    return tsl.positionLocal as unknown as ReturnType<NodeMaterial['setupPosition']>;
  }

  override setupDiffuseColor(): void {
    threeNodes.diffuseColor.assign(threeNodes.vec4(0, 0, 0, 1));
  }
}

/** Draws lines between parts that move, with WebGPURenderer. */
class NodeMovingLines implements LineDrawer {
  private map: RenderTarget | null = null;
  private isMapped = false;
  private readonly scene = new Object3D();
  private readonly copies = new Map<Mesh, PosedCopy<PartMaterial>>();
  /** The copies of parts that are seen through. */
  private readonly clear = new Map<Mesh, PosedCopy<HatchingOutlineNodeMaterial>>();

  constructor(private readonly renderer: WebGPURenderer) {
    this.scene.matrixWorldAutoUpdate = false;
  }

  drawMap(parts: readonly NumberedPart[], outlines: DrawnOutlines, _scene: Scene, camera: Camera): void {
    // Each camera of an ArrayCamera would need a map of its own.
    this.isMapped = hasFloatTargets(this.renderer) && !('isArrayCamera' in camera);
    if (!this.isMapped) return;
    const { viewport } = (outlines as Outlines).material.uniforms;
    const { z: width, w: height } = viewport.value as Vector4;
    for (const copy of this.copies.values()) copy.visible = false;
    for (let i = 0; i < parts.length; i++) if (parts[i].look > 0 && !parts[i].isClear) this.take(parts[i]);
    this.render(this.mapOf(width, height), camera);
  }

  drawLines(outlines: DrawnOutlines, look: number, scene: Scene, camera: Camera): void {
    if (!this.isMapped) return;
    const lines = this.lookOf(outlines as Outlines, meetingNodes);
    lines.uniforms.partLook.value = look;
    (outlines as Outlines).drawOnScreen(this.renderer, scene, camera, lines, 'meetings');
  }

  drawClear({ number }: NumberedPart, outlines: DrawnOutlines, scene: Scene, camera: Camera): void {
    const mesh = outlines.mesh!;
    const isInstanced = 'isInstancedMesh' in mesh;
    if (!this.isMapped || (isInstanced && (mesh as InstancedMesh).count === 0)) return;
    const { renderer } = this;
    const lines = this.lookOf(outlines as Outlines, isInstanced ? clearInstanceNodes : clearNodes);
    lines.uniforms.partNumber.value = number;
    if (isInstanced) lines.uniforms.instancePlaces.value = placesOf(mesh as InstancedMesh);
    const copy = this.clear.get(mesh) ?? new PosedCopy(lines);
    this.clear.set(mesh, copy);
    copy.take(mesh);
    const lights = renderer.lighting.getNode(scene);
    const clipping = clippingOf(mesh, renderer);
    renderer.renderObject(copy, scene, camera, copy.geometry, lines, null, lights, clipping, 'meetings');
  }

  free(): void {
    this.map?.dispose();
    this.map = null;
    for (const { material } of this.copies.values()) material.dispose();
    this.copies.clear();
    this.clear.clear();
    this.scene.clear();
  }

  /** The material of lines with the look of outlines. */
  private lookOf({ material }: Outlines, makeNodes: MakeNodes): HatchingOutlineNodeMaterial {
    const lines = material.drawing(makeNodes, OF_LINES);
    const { partMap, opacity } = lines.uniforms;
    lines.depthTest = false;
    lines.opacity = opacity.value = material.opacity;
    partMap.value = this.map!.texture;
    return lines;
  }

  private render(into: RenderTarget, camera: Camera): void {
    const { renderer } = this;
    const target = renderer.getRenderTarget();
    const face = renderer.getActiveCubeFace();
    const level = renderer.getActiveMipmapLevel();
    const outputs = renderer.getMRT();
    const drawObject = renderer.getRenderObjectFunction();
    const { autoClear } = renderer;
    const { calls } = renderer.info.render;
    const clearAlpha = renderer.getClearAlpha();
    renderer.getClearColor(clearColor as Parameters<typeof renderer.getClearColor>[0]);
    renderer.setClearColor(noColor, 0);
    renderer.autoClear = true;
    renderer.setMRT(null);
    renderer.setRenderObjectFunction(this.drawClipped);
    renderer.setRenderTarget(into);
    renderer.render(this.scene, camera);
    renderer.setRenderTarget(target, face, level);
    renderer.setRenderObjectFunction(drawObject);
    renderer.setMRT(outputs);
    renderer.autoClear = autoClear;
    renderer.setClearColor(clearColor, clearAlpha);
    // three.js tells frames apart by this count, and the current frame goes on.
    renderer.info.render.calls = calls;
  }

  /** Draws a copy as the groups clip that its mesh is in. */
  private readonly drawClipped: WebGPURenderer['renderObject'] = (
    ...[copy, scene, camera, geometry, material, group, lights, , pass]
  ) => {
    const { renderer } = this;
    const clipping = clippingOf((copy as PosedCopy<PartMaterial>).source!, renderer);
    renderer.renderObject(copy, scene, camera, geometry, material, group, lights, clipping, pass);
  };

  private take({ number, look, outlines }: NumberedPart): void {
    const mesh = outlines.mesh!;
    const copy = this.copyOf(mesh);
    const { material } = copy;
    const { uniforms } = material;
    copy.take(mesh);
    copy.visible = copy.count > 0;
    uniforms.partNumber.value = number;
    uniforms.partLook.value = look;
    if ('isInstancedMesh' in mesh) uniforms.instancePlaces.value = placesOf(mesh as InstancedMesh);
    const surface: Material = Array.isArray(mesh.material) ? mesh.material[0] : mesh.material;
    material.side = surface.side ?? FrontSide;
  }

  private copyOf(mesh: Mesh): PosedCopy<PartMaterial> {
    let copy = this.copies.get(mesh);
    if (!copy) {
      copy = new PosedCopy(new PartMaterial('isInstancedMesh' in mesh));
      this.copies.set(mesh, copy);
      this.scene.add(copy);
    }
    return copy;
  }

  private mapOf(width: number, height: number): RenderTarget {
    if (this.map) {
      this.map.setSize(width, height);
      return this.map;
    }
    this.map = new RenderTarget(width, height, {
      type: FloatType,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      generateMipmaps: false,
    });
    return this.map;
  }
}

/** Makes what draws lines with WebGPURenderer. */
export const makeDrawer = (renderer: WebGLRenderer): LineDrawer =>
  new NodeMovingLines(renderer as unknown as WebGPURenderer);
