import {
  type BufferGeometry,
  type Camera,
  type Material,
  Mesh,
  type Object3D,
  RawShaderMaterial,
  Scene,
  type Texture,
  type WebGLProgram as ThreeProgram,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { HATCHING_PROPERTIES, type HatchingPropertyName, type PropertyNameOf } from '../look/hatchingProperties.js';
import { needsAdjacency, usesThresholds } from '../look/queries.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import type { HatchingOutlines } from '../material/outlines/HatchingOutlines.js';
import { ObjectList } from '../material/three/posing.js';
import { isHatching, materialsOf } from './surfaceMeshes.js';

const POLL_MILLISECONDS = 10;

/** A mesh, with a geometry and a material that it will have. */
export interface CandidateLook {
  mesh: Mesh;
  geometry: BufferGeometry;
  material: Material | Material[];
}

/**
 * Does the work in advance that would delay the first frame with new looks: it compiles programs in the background, and uploads
 * geometries and textures piece by piece. The scene does not change.
 */
export class FirstFrame {
  private readonly awaited = new Set<ThreeProgram>();

  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly camera: Camera,
    private readonly root: Object3D,
  ) {}

  /**
   * Starts to compile the programs of these looks, with the lights of the root's scene. Looks whose technique needs adjacency are left
   * out before they are prepared, because their programs depend on it.
   */
  compile(looks: readonly CandidateLook[], outlines: readonly HatchingOutlines[], arePrepared: boolean): void {
    const drawn = arePrepared ? looks : looks.filter((look) => !materialsOf(look).some(dependsOnLayout));
    const known = new Set(this.programs);
    const list = new ObjectList([...drawn.map(({ mesh }) => mesh), ...outlines]);
    withLooks(drawn, () => {
      for (const { mesh } of drawn) {
        for (const material of materialsOf(mesh)) if (isHatching(material)) material.announce(mesh);
      }
      for (const one of outlines) one.showInstances();
      // Lights, fog and environment are read from the topmost object, whether or not it is a Scene.
      this.renderer.compile(list, this.camera, topOf(this.root) as Scene);
      for (const one of outlines) one.hideInstances();
    });
    for (const program of this.programs) if (!known.has(program)) this.awaited.add(program);
  }

  /** Resolves when the programs are compiled. */
  async built(signal: AbortSignal | undefined): Promise<void> {
    const gl = this.renderer.getContext();
    const parallel = gl.getExtension('KHR_parallel_shader_compile');
    const isBuilt = ({ program }: ThreeProgram): boolean =>
      !parallel || gl.getProgramParameter(program as WebGLProgram, parallel.COMPLETION_STATUS_KHR);
    for (;;) {
      signal?.throwIfAborted();
      const present = new Set(this.programs);
      for (const program of this.awaited) {
        if (!present.has(program) || gl.isContextLost()) this.awaited.delete(program);
        else if (isBuilt(program)) {
          // three.js queries the uniforms of a program once; within a frame, that would wait for what was drawn before.
          program.getUniforms();
          this.awaited.delete(program);
        }
      }
      if (this.awaited.size === 0) return;
      await new Promise((resume) => setTimeout(resume, POLL_MILLISECONDS));
    }
  }

  /** Uploads the geometries and textures of prepared looks, and yields after each of them. */
  *upload(looks: readonly CandidateLook[]): Generator<number, void, void> {
    const geometries = [...new Set(looks.map(({ geometry }) => geometry))];
    const textures = texturesOf(looks);
    const count = geometries.length + textures.length;
    const material = new RawShaderMaterial({
      vertexShader: 'void main() { gl_Position = vec4(0.0); }',
      fragmentShader: 'precision lowp float; void main() { gl_FragColor = vec4(0.0); }',
    });
    const target = new WebGLRenderTarget(1, 1);
    const proxy = new Mesh(undefined, material);
    const scene = new Scene().add(proxy);
    proxy.frustumCulled = false;
    try {
      for (const [i, texture] of textures.entries()) {
        this.renderer.initTexture(texture);
        yield (i + 1) / count;
      }
      for (const [i, geometry] of geometries.entries()) {
        proxy.geometry = geometry;
        // three.js reads the weights of morph targets when it draws.
        proxy.updateMorphTargets();
        this.draw(scene, geometry, target);
        yield (textures.length + i + 1) / count;
      }
    } finally {
      material.dispose();
      target.dispose();
    }
  }

  /** Draws a scene that shows no vertex of a geometry, because three.js uploads a geometry only when it draws it. */
  private draw(scene: Scene, { drawRange }: BufferGeometry, target: WebGLRenderTarget): void {
    const { renderer } = this;
    const { count } = drawRange;
    const present = renderer.getRenderTarget();
    const [face, level] = [renderer.getActiveCubeFace(), renderer.getActiveMipmapLevel()];
    const { enabled } = renderer.xr;
    try {
      drawRange.count = 0;
      renderer.xr.enabled = false;
      renderer.setRenderTarget(target);
      renderer.render(scene, this.camera);
    } finally {
      drawRange.count = count;
      renderer.xr.enabled = enabled;
      renderer.setRenderTarget(present, face, level);
    }
  }

  private get programs(): readonly ThreeProgram[] {
    return this.renderer.info.programs ?? [];
  }
}

/** Runs a function while meshes have other geometries and materials. */
function withLooks(looks: readonly CandidateLook[], work: () => void): void {
  const before = looks.map(({ mesh }) => ({ mesh, geometry: mesh.geometry, material: mesh.material }));
  for (const { mesh, geometry, material } of looks) Object.assign(mesh, { geometry, material });
  try {
    work();
  } finally {
    for (const { mesh, geometry, material } of before) Object.assign(mesh, { geometry, material });
  }
}

const dependsOnLayout = (material: Material): boolean => !isHatching(material) || needsAdjacency(material);

function topOf(object: Object3D): Object3D {
  let top = object;
  while (top.parent) top = top.parent;
  return top;
}

/** The textures of materials that have loaded. */
function texturesOf(looks: readonly CandidateLook[]): Texture[] {
  const textures = new Set<Texture>();
  for (const material of new Set(looks.flatMap(({ material }) => material))) {
    if (material && isHatching(material)) for (const texture of texturesIn(material)) textures.add(texture);
  }
  return [...textures].filter(({ image }) => image);
}

function texturesIn(material: HatchingMaterial): Texture[] {
  const { tonalArtMap } = material;
  const names = Object.keys(HATCHING_PROPERTIES) as HatchingPropertyName[];
  const maps = names
    .filter((name) => HATCHING_PROPERTIES[name].kind === 'texture')
    .map((name) => material[name as PropertyNameOf<undefined>] as Texture | null);
  if (typeof tonalArtMap === 'object' && tonalArtMap?.isReady)
    maps.push(usesThresholds(material) ? tonalArtMap.thresholdTexture : tonalArtMap.texture);
  return maps.filter((texture) => texture !== null);
}
