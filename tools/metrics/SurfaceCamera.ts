import {
  AmbientLight,
  BufferAttribute,
  BufferGeometry,
  DirectionalLight,
  DoubleSide,
  FloatType,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  NearestFilter,
  type Object3D,
  PerspectiveCamera,
  Scene,
  ShaderMaterial,
  Vector3,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import type { HatchingMaterial } from 'three-hatching';
import type { LocatedImage } from './measures/reprojectedChange.js';
import type { SurfaceImage } from './measures/SurfaceImage.js';

/** Camera position of the standard view: a little from above, with the model filling the picture. */
const EYE = new Vector3(0.3, 0.4, 3.9);
/** Direction to the light, in world space and in object space. */
export const TO_LIGHT = new Vector3(1, 1.2, 1).normalize();
const UP = new Vector3(0, 1, 0);
/** The place of a light that casts shadows on a wall. */
const BESIDE = new Vector3(-1.5, 0.4, 3);
/** Light intensity too weak to change the tone; the light still gives strokes their direction. */
const DIRECTION_ALONE = 1e-6;

/** Takes pictures of one model, without antialiasing, as numbers in linear light. */
export class SurfaceCamera {
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(30, 1, 0.01, 20);
  private readonly sun = new DirectionalLight();
  private readonly fill = new AmbientLight();
  private readonly mesh: Mesh<BufferGeometry, HatchingMaterial>;
  private readonly colours: WebGLRenderTarget;
  private readonly places: WebGLRenderTarget;

  constructor(
    readonly renderer: WebGLRenderer,
    readonly size: number,
    geometry: BufferGeometry,
    material: HatchingMaterial,
  ) {
    this.colours = new WebGLRenderTarget(size, size);
    this.places = new WebGLRenderTarget(size, size, {
      type: FloatType,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
    });
    this.mesh = new Mesh(geometry, material);
    this.scene.add(this.mesh, this.sun, this.fill);
    renderer.setClearColor(0x000000, 0);
    this.lit().view();
  }

  /** Under one directional light, as in Suarez et al., that is turned by `lightDegrees` about the vertical. */
  lit(lightDegrees = 0): this {
    this.sun.intensity = Math.PI;
    this.fill.intensity = 0;
    return this.lightFrom(lightDegrees);
  }

  /** The same tone everywhere. Strokes follow a light that is turned by `lightDegrees` about the vertical. */
  evenlyToned(tone: number, lightDegrees = 0): this {
    this.sun.intensity = DIRECTION_ALONE;
    this.fill.intensity = Math.PI * (1 - tone);
    return this.lightFrom(lightDegrees);
  }

  /**
   * Under one light from the left, in whose shadow a caster draws bars that are not seen themselves: `lit` and `shaded` are the tones of a
   * wall that faces the camera.
   */
  barred(lit: number, shaded: number, caster: BufferGeometry): this {
    const { renderer, scene, sun, fill, mesh } = this;
    renderer.shadowMap.enabled = true;
    sun.castShadow = mesh.receiveShadow = true;
    sun.shadow.mapSize.setScalar(2048);
    sun.shadow.bias = -0.002;
    Object.assign(sun.shadow.camera, { left: -2, right: 2, bottom: -2, top: 2, near: 0.1, far: 10 });
    sun.position.copy(BESIDE);
    sun.intensity = (Math.PI * (shaded - lit)) / BESIDE.clone().normalize().z;
    fill.intensity = Math.PI * (1 - shaded);
    const bars = new Mesh(caster, new MeshBasicMaterial({ colorWrite: false, depthWrite: false, side: DoubleSide }));
    bars.castShadow = true;
    bars.renderOrder = -1;
    scene.add(bars);
    return this;
  }

  /** The standard view, enlarged about its middle. */
  view(zoom = 1): this {
    return this.placeCamera(EYE, new Vector3(), zoom);
  }

  /** The standard view moved towards a point of the model, to 1 / `times` of the distance. */
  dolly(target: Vector3, times: number): this {
    return this.placeCamera(new Vector3().lerpVectors(target, EYE, 1 / times), target, 1);
  }

  /** The standard view from a place that is turned about the vertical. */
  orbit(degrees: number): this {
    return this.placeCamera(EYE.clone().applyAxisAngle(UP, (degrees * Math.PI) / 180), new Vector3(), 1);
  }

  shoot(): SurfaceImage {
    return this.draw(this.mesh);
  }

  /** Draws only edges: lines between pairs of corners, shaded with the attributes of these corners. */
  shootEdges(corners: Uint32Array): SurfaceImage {
    const geometry = new BufferGeometry();
    Object.assign(geometry.attributes, this.mesh.geometry.attributes);
    geometry.setIndex(new BufferAttribute(corners, 1));
    const lines = new LineSegments(geometry, this.mesh.material);
    this.scene.add(lines);
    const image = this.draw(lines);
    this.scene.remove(lines);
    return image;
  }

  /** Records also the point of the model at every pixel. */
  shootLocated(): LocatedImage {
    const image = this.shoot();
    const places = new Float32Array(4 * this.size * this.size);
    this.scene.overrideMaterial = placeMaterial;
    this.render(this.places);
    this.scene.overrideMaterial = null;
    this.renderer.readRenderTargetPixels(this.places, 0, 0, this.size, this.size, places);
    const objectToClip = this.camera.projectionMatrix.clone().multiply(this.camera.matrixWorldInverse).toArray();
    return { ...image, places, objectToClip };
  }

  dispose(): void {
    this.colours.dispose();
    this.places.dispose();
  }

  private lightFrom(degrees: number): this {
    this.sun.position.copy(TO_LIGHT).applyAxisAngle(UP, (degrees * Math.PI) / 180);
    return this;
  }

  private placeCamera(eye: Vector3, target: Vector3, zoom: number): this {
    this.camera.position.copy(eye);
    this.camera.zoom = zoom;
    this.camera.lookAt(target);
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    return this;
  }

  private draw(shown: Object3D): SurfaceImage {
    this.mesh.visible = shown === this.mesh;
    this.render(this.colours);
    this.mesh.visible = true;
    const pixels = this.size * this.size;
    const rgba = new Uint8Array(4 * pixels);
    this.renderer.readRenderTargetPixels(this.colours, 0, 0, this.size, this.size, rgba);
    return {
      width: this.size,
      height: this.size,
      luminance: Float32Array.from({ length: pixels }, (_, i) => rgba[4 * i] / 255),
      surface: Uint8Array.from({ length: pixels }, (_, i) => rgba[4 * i + 3]),
    };
  }

  private render(target: WebGLRenderTarget): void {
    this.renderer.setRenderTarget(target);
    this.renderer.render(this.scene, this.camera);
    this.renderer.setRenderTarget(null);
  }
}

/** Writes the position in object space, and the cosine between normal and line of sight. */
const placeMaterial = new ShaderMaterial({
  vertexShader: `
    varying vec3 vPlace, vNormal, vToEye;
    void main() {
      vec4 seen = modelViewMatrix * vec4(position, 1.0);
      vPlace = position;
      vNormal = normalMatrix * normal;
      vToEye = -seen.xyz;
      gl_Position = projectionMatrix * seen;
    }`,
  fragmentShader: `
    varying vec3 vPlace, vNormal, vToEye;
    void main() {
      gl_FragColor = vec4(vPlace, dot(normalize(vNormal), normalize(vToEye)));
    }`,
});
