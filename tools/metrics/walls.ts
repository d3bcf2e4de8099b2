/** Measures how even a plain wall is in every preset and with every field of lines, near and far, seen straight and aslant. */
import {
  AmbientLight,
  DirectionalLight,
  Mesh,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import {
  HatchingMaterial,
  type HatchingMaterialParameters,
  prepareHatchingGeometry,
  presets,
  TonalArtMap,
} from 'three-hatching';
import { plainLook } from '../plainLook.js';
import { meanInk } from './measures/meanInk.js';
import { unevenness } from './measures/unevenness.js';

const SIZE = 384;
/** The blur, in pixels: a few strokes of the presets, whose lines lie about 4 pixels apart. */
const BLUR = 14;
const TONES = [0.2, 0.4, 0.6];
const DISTANCES = 12;
/** The farthest view is so many times as far as the nearest. */
const RANGE = 8;
/** Angles between the line of sight and the normal of the wall, degrees. */
const ANGLES = [0, 15, 30, 45, 60, 70];
const FIELDS = ['light', 'towardsLight', 'x', 'y', 'z', 'slant', 'form', 'acrossForm'] as const;

/** The worst of all views of a look, with the view. */
export interface WallMeasure {
  look: string;
  unevenness: number;
  uneven: { tone: number; distance: number; angle: number };
  /** The largest difference between the mean darkness and the tone that is asked. */
  toneError: number;
  off: { tone: number; distance: number; angle: number };
}

/** The looks on a wall: every preset, and plain lines of every field. */
function looks(): [string, HatchingMaterialParameters, Parameters<typeof TonalArtMap.generate>[0] | null][] {
  return [
    ...Object.entries(presets).map(([name, { material, tonalArtMap }]): ReturnType<typeof looks>[number] => [
      name,
      {
        ...material,
        toneCurve: 'linear',
        reflectedLight: 0,
        composition: { exposure: 1 },
        ink: 'black',
        paper: 'white',
      },
      tonalArtMap,
    ]),
    ...FIELDS.map((direction): ReturnType<typeof looks>[number] => [
      `lines, ${direction}`,
      plainLook({ technique: 'engraving', screenSpaceShare: 1, direction, crossFrom: 1 }),
      null,
    ]),
  ];
}

/**
 * Draws each look on a wall in even tones.
 *
 * @param wanted names of looks; all, if it is empty
 */
export async function measureWalls(renderer: WebGLRenderer, wanted: readonly string[]): Promise<WallMeasure[]> {
  // Directions of the wall are baked, and its axes differ from those of the world.
  const wall = await prepareHatchingGeometry(new PlaneGeometry(60, 60, 8, 8), { form: true });
  const view = new WallView(renderer);
  const found: WallMeasure[] = [];
  for (const [look, parameters, drawing] of looks()) {
    if (wanted.length > 0 && !wanted.includes(look)) continue;
    const map = drawing && (await TonalArtMap.generate(drawing));
    const material = new HatchingMaterial({ ...parameters, ...(map && { tonalArtMap: map }) });
    const mesh = new Mesh(wall, material);
    mesh.rotation.set(0.3, 0.2, 0.1);
    found.push({ look, ...view.worst(mesh) });
    for (const thing of [material, map]) thing?.dispose();
  }
  view.dispose();
  wall.dispose();
  return found;
}

class WallView {
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(30, 1, 0.05, 200);
  private readonly fill = new AmbientLight();
  private readonly target = new WebGLRenderTarget(SIZE, SIZE, { samples: 4 });

  constructor(private readonly renderer: WebGLRenderer) {
    // Too weak to change the tone, it gives strokes their direction.
    const sun = new DirectionalLight(0xffffff, 1e-6);
    sun.position.set(1, 1.2, 1);
    this.scene.add(sun, this.fill);
  }

  worst(mesh: Mesh): Omit<WallMeasure, 'look'> {
    this.scene.add(mesh);
    const none = { tone: 0, distance: 0, angle: 0 };
    const found = { unevenness: 0, uneven: none, toneError: 0, off: none };
    for (const tone of TONES) {
      this.fill.intensity = Math.PI * (1 - tone);
      for (let step = 0; step < DISTANCES; step++) {
        const distance = 1.5 * RANGE ** (step / (DISTANCES - 1));
        for (const angle of ANGLES) {
          const view = { tone, distance, angle };
          const image = this.shoot(mesh, distance, (angle * Math.PI) / 180);
          const uneven = unevenness(image, BLUR);
          const error = Math.abs(meanInk(image) - tone);
          if (uneven > found.unevenness) Object.assign(found, { unevenness: uneven, uneven: view });
          if (error > found.toneError) Object.assign(found, { toneError: error, off: view });
        }
      }
    }
    this.scene.remove(mesh);
    return found;
  }

  dispose(): void {
    this.target.dispose();
  }

  private shoot(mesh: Mesh, distance: number, angle: number) {
    const { camera, renderer, scene, target } = this;
    camera.position.set(0.3, 0.2 + distance * Math.sin(angle), distance * Math.cos(angle)).applyEuler(mesh.rotation);
    camera.up.set(0, 1, 0).applyEuler(mesh.rotation);
    camera.lookAt(mesh.localToWorld(camera.position.clone().set(0.3, 0.2, 0)));
    camera.updateMatrixWorld();
    renderer.setRenderTarget(target);
    renderer.render(scene, camera);
    renderer.setRenderTarget(null);
    const rgba = new Uint8Array(4 * SIZE * SIZE);
    renderer.readRenderTargetPixels(target, 0, 0, SIZE, SIZE, rgba);
    return {
      width: SIZE,
      height: SIZE,
      luminance: Float32Array.from({ length: SIZE * SIZE }, (_, i) => rgba[4 * i] / 255),
      surface: new Uint8Array(SIZE * SIZE).fill(1),
    };
  }
}
