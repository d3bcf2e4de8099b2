import { Color, LinearSRGBColorSpace, Material, NoToneMapping, Scene, SRGBColorSpace, type Vector2 } from 'three';
import { type Node, type NodeBuilder, TSL, WebGPURenderer } from 'three/webgpu';
import type { HatchingMaterial, HatchingPropertyName, PropertyNameOf } from 'three-hatching';
import { HATCHING_PROPERTIES } from 'three-hatching/facts';
import {
  HatchingNodeMaterial,
  HatchingOutlineNodeMaterial,
  HatchingOutlines,
  HatchingShadowNodeMaterial,
} from 'three-hatching/webgpu';
import type { HatchedModel } from '../../viewer/drawing/HatchedModel.js';
import type { NodeMakers } from '../../viewer/drawing/materials.js';
import { strokeShare } from '../../viewer/sceneSetup/framing.js';
import { Ground } from '../../viewer/sceneSetup/Ground.js';
import { createCamera, type LensCamera } from '../../viewer/sceneSetup/LensCamera.js';
import { LightRig } from '../../viewer/sceneSetup/LightRig.js';
import type { Look } from '../../viewer/settings/lookOf.js';
import type { FrameSize, Screen } from './Frames.js';
import type { Painter } from './Painter.js';
import type { Scenery } from './Scenery.js';

const NAMES = (Object.keys(HATCHING_PROPERTIES) as HatchingPropertyName[]).filter(
  (name): name is PropertyNameOf<undefined> => !('owner' in HATCHING_PROPERTIES[name]),
);

/**
 * A node material with the properties of another material. Values that equal a default of the technique stay defaults, and change with the
 * technique.
 */
function nodesLike(drawn: HatchingMaterial): HatchingNodeMaterial {
  const nodes = new HatchingNodeMaterial();
  Material.prototype.copy.call(nodes, drawn);
  nodes.technique = drawn.technique;
  for (const name of NAMES) {
    const { kind } = HATCHING_PROPERTIES[name];
    if (kind === 'color') (nodes[name] as Color).copy(drawn[name] as Color);
    else if (kind === 'vector2') (nodes[name] as Vector2).copy(drawn[name] as Vector2);
    else if (nodes[name] !== drawn[name]) Object.assign(nodes, { [name]: drawn[name] });
  }
  nodes.composition = drawn.composition;
  return nodes;
}

const nodeMakers: NodeMakers = {
  material: nodesLike,
  outlineMaterial: () => new HatchingOutlineNodeMaterial(),
  outlines: (mesh, material) => new HatchingOutlines(mesh, material),
};

/** What a {@link NodeScreen} needs from the page. */
interface NodeScreenHost {
  painter: Painter;
  scenery: Scenery;
  /** Requests a frame. */
  refine(): void;
  /** Called when the device is lost. The screen is unusable then. */
  onLost(): void;
}

/**
 * Draws the scenery with WebGPURenderer and node materials. It borrows the model from the scenery, but has its own camera, lights and
 * ground, because each renderer writes data to these that the other cannot read.
 */
export class NodeScreen implements Screen {
  readonly canvas = document.createElement('canvas');
  private readonly scene = new Scene();
  private readonly camera = createCamera();
  private readonly lights = new LightRig(this.scene);
  private readonly ground: Ground;
  private readonly renderer: WebGPURenderer;
  private look: Look | undefined;
  /** The model and programs of the last build. */
  private builtModel: HatchedModel | undefined;
  private builtFor = '';
  private builds = 0;
  /** What is being built: the programs, or other resources of the first frame. */
  private building: 'programs' | 'rest' | undefined;
  /** Whether no frame was drawn since programs were built. */
  private isFirst = false;
  private isDisposed = false;
  /** The painter's count of shadow changes when shadows were drawn last. */
  private shadows = -1;
  /** The size of the canvas. */
  private readonly size: FrameSize = { width: 0, height: 0, ratio: 0 };

  /**
   * Creates the renderer, on a canvas over the painter's.
   *
   * @throws Error if the browser provides no device
   */
  static async create(host: NodeScreenHost): Promise<NodeScreen> {
    const screen = new NodeScreen(host);
    try {
      await screen.renderer.init();
      if (!screen.device) throw new Error('There is no device.');
    } catch (error) {
      screen.dispose();
      throw error;
    }
    host.painter.canvas.after(screen.canvas);
    return screen;
  }

  private constructor(private readonly host: NodeScreenHost) {
    const { canvas } = this;
    // Hidden until its first frame, so that the painter's last frame stays visible.
    canvas.hidden = true;
    canvas.className = 'node-screen';
    canvas.setAttribute('aria-hidden', 'true');
    const antialias = host.painter.context.getContextAttributes()?.antialias ?? true;
    this.renderer = new WebGPURenderer({ canvas, antialias });
    encodeInMaterials(this.renderer);
    this.renderer.shadowMap.enabled = true;
    this.renderer.onDeviceLost = () => {
      if (!this.isDisposed) host.onLost();
    };
    const materials = { floor: new HatchingNodeMaterial(), shadow: new HatchingShadowNodeMaterial() };
    this.ground = new Ground(this.scene, () => this.outdate(), materials);
    this.scene.addEventListener('intersections' as 'added', () => host.refine());
  }

  /** The WebGPU device; undefined if the renderer has fallen back to WebGL. */
  private get device(): GPUDevice | undefined {
    return (this.renderer.backend as { device?: GPUDevice }).device;
  }

  get canDraw(): boolean {
    const { look, shown } = this.host.scenery;
    return look !== undefined && shown.model !== undefined && look.lackOfNodes === undefined;
  }

  get isBuilding(): boolean {
    return this.building !== undefined;
  }

  prepare(): boolean {
    const { look, shown } = this.host.scenery;
    if (!look || (look.programs === this.builtFor && shown.model === this.builtModel))
      return this.building !== 'programs';
    this.builtFor = look.programs;
    this.builtModel = shown.model;
    void this.build();
    return false;
  }

  draw({ width, height, ratio }: FrameSize): void {
    const { renderer, size } = this;
    this.follow(width, height);
    // Both calls reallocate the canvas.
    if (size.ratio !== ratio) renderer.setPixelRatio(ratio);
    if (size.width !== width || size.height !== height) renderer.setSize(width, height, false);
    Object.assign(size, { width, height, ratio });
    try {
      renderer.render(this.scene, this.camera);
    } catch (error) {
      // When the browser's GPU process crashes, three.js is not told of the lost device.
      console.error(error);
      this.host.onLost();
      return;
    }
    if (this.isFirst) void this.buildRest();
  }

  dispose(): void {
    const { canvas, ground, host, renderer } = this;
    this.isDisposed = true;
    this.building = undefined;
    host.scenery.dropNodes();
    ground.dispose();
    canvas.remove();
    // Disposal waits for a set-up that may have failed, which was reported to the creator.
    Promise.resolve(renderer.dispose()).catch(() => {});
  }

  /** Makes the next frame wait for programs, because there is more to draw. */
  private outdate(): void {
    this.builtFor = '';
    this.host.refine();
  }

  /** Builds the resources of the next frame, then requests it. The canvas keeps the last frame meanwhile. */
  private async build(): Promise<void> {
    const { host, renderer, ground, lights } = this;
    const build = ++this.builds;
    this.building = 'programs';
    this.follow(this.size.width, this.size.height);
    // Anything that cannot be fetched or built is missing in the frame, and the console says why.
    try {
      await Promise.all([host.scenery.shown.model?.nodesReady(), ground.ready]);
      if (!this.isDisposed) await renderer.compileAsync(this.scene, this.camera);
    } catch (error) {
      if (!this.isDisposed) console.error(error);
    }
    if (build !== this.builds || this.isDisposed) return;
    this.building = undefined;
    this.isFirst = true;
    lights.outdateShadows();
    host.refine();
  }

  /**
   * Waits for the first frame, for which the graphics card builds the programs of shadows and of the output. Until then, the page shows the
   * previous frame, and further frames would wait as well.
   */
  private async buildRest(): Promise<void> {
    const { builds } = this;
    this.isFirst = false;
    this.building = 'rest';
    // A device lost meanwhile does not finish it.
    await this.device?.queue.onSubmittedWorkDone().catch(() => {});
    if (builds !== this.builds || this.isDisposed) return;
    this.building = undefined;
    this.host.refine();
  }

  /** Synchronizes with the scenery, on a sheet of this size in CSS pixels. */
  private follow(width: number, height: number): void {
    const { camera, ground, host, lights, renderer } = this;
    const { painter, scenery } = host;
    const { look, shown, tonalArtMap } = scenery;
    if (!look) return;
    scenery.lend(this.scene, nodeMakers);
    if (look !== this.look) {
      this.look = look;
      lights.apply(look.lights);
      ground.apply(look);
      renderer.setClearColor(new Color(look.paper).convertLinearToSRGB(), 1);
    }
    ground.height = scenery.ground.height;
    ground.extent = shown.model?.extent ?? null;
    if (tonalArtMap) ground.tonalArtMap = tonalArtMap;
    const share = strokeShare(width, height);
    shown.model?.setWidths(look, share);
    ground.setWidths(look, share);
    placeLike(camera, painter.camera);
    lights.place(camera);
    scenery.endShadow(camera, painter.sheetOf(), { ground, lights });
    if (painter.shadowChanges === this.shadows) return;
    this.shadows = painter.shadowChanges;
    lights.outdateShadows();
  }
}

/** Copies position and lens of another camera. */
function placeLike(camera: LensCamera, other: LensCamera): void {
  const { position, quaternion, aspect, lens, sheet } = other;
  camera.position.copy(position);
  camera.quaternion.copy(quaternion);
  if (camera.aspect !== aspect || camera.lens !== lens || camera.sheet !== sheet) camera.takeLens(other);
}

/**
 * Makes a renderer draw straight to its canvas, in sRGB colours encoded by each material, as WebGLRenderer does. By default WebGPURenderer
 * blends in a linear picture and encodes it afterwards, which makes half-covered pixels lighter. The renderer's clear color is not encoded.
 */
function encodeInMaterials(renderer: WebGPURenderer): void {
  renderer.outputColorSpace = LinearSRGBColorSpace;
  const getOutput = (color: Node<'vec4'>, builder: NodeBuilder): Node =>
    builder.renderer.isOutputTarget ? TSL.renderOutput(color, NoToneMapping, SRGBColorSpace) : color;
  renderer.contextNode = TSL.context({ getOutput });
}
