import { Color, Vector2 } from 'three';
import type { SurfaceMaterial } from './SurfaceMaterial.js';

/**
 * The values of a material when it was last looked at, to find out in every frame whether one has changed. Each property is compared by
 * a line of its own: engines compile that to code that takes a fraction of a microsecond, and a loop over names to ten times as much.
 */
export class SeenValues {
  declare visible: unknown;
  declare opacity: unknown;
  declare transparent: unknown;
  declare side: unknown;
  declare alphaTest: unknown;
  declare alphaHash: unknown;
  declare blending: unknown;
  declare colorWrite: unknown;
  declare depthTest: unknown;
  declare depthFunc: unknown;
  declare depthWrite: unknown;
  declare polygonOffset: unknown;
  declare polygonOffsetFactor: unknown;
  declare polygonOffsetUnits: unknown;
  declare clippingPlanes: unknown;
  declare clipIntersection: unknown;
  declare alphaToCoverage: unknown;
  declare stencilWrite: unknown;
  declare stencilFunc: unknown;
  declare stencilRef: unknown;
  declare stencilFuncMask: unknown;
  declare vertexColors: unknown;
  declare fog: unknown;
  declare wireframe: unknown;
  declare map: unknown;
  declare alphaMap: unknown;
  declare normalMap: unknown;
  declare normalMapType: unknown;
  declare bumpMap: unknown;
  declare bumpScale: unknown;
  declare flatShading: unknown;
  declare aoMap: unknown;
  declare aoMapIntensity: unknown;
  declare lightMap: unknown;
  declare lightMapIntensity: unknown;
  declare emissiveIntensity: unknown;
  declare emissiveMap: unknown;
  declare metalness: unknown;
  declare roughness: unknown;
  readonly color = new Color();
  readonly emissive = new Color();
  readonly normalScale = new Vector2();

  constructor(source: SurfaceMaterial) {
    this.note(source);
  }

  note(source: SurfaceMaterial): void {
    this.visible = source.visible;
    this.opacity = source.opacity;
    this.transparent = source.transparent;
    this.side = source.side;
    this.alphaTest = source.alphaTest;
    this.alphaHash = source.alphaHash;
    this.blending = source.blending;
    this.colorWrite = source.colorWrite;
    this.depthTest = source.depthTest;
    this.depthFunc = source.depthFunc;
    this.depthWrite = source.depthWrite;
    this.polygonOffset = source.polygonOffset;
    this.polygonOffsetFactor = source.polygonOffsetFactor;
    this.polygonOffsetUnits = source.polygonOffsetUnits;
    this.clippingPlanes = source.clippingPlanes;
    this.clipIntersection = source.clipIntersection;
    this.alphaToCoverage = source.alphaToCoverage;
    this.stencilWrite = source.stencilWrite;
    this.stencilFunc = source.stencilFunc;
    this.stencilRef = source.stencilRef;
    this.stencilFuncMask = source.stencilFuncMask;
    this.vertexColors = source.vertexColors;
    this.fog = source.fog;
    this.wireframe = source.wireframe;
    this.map = source.map;
    this.alphaMap = source.alphaMap;
    this.normalMap = source.normalMap;
    this.normalMapType = source.normalMapType;
    this.bumpMap = source.bumpMap;
    this.bumpScale = source.bumpScale;
    this.flatShading = source.flatShading;
    this.aoMap = source.aoMap;
    this.aoMapIntensity = source.aoMapIntensity;
    this.lightMap = source.lightMap;
    this.lightMapIntensity = source.lightMapIntensity;
    this.emissiveIntensity = source.emissiveIntensity;
    this.emissiveMap = source.emissiveMap;
    this.metalness = source.metalness;
    this.roughness = source.roughness;
    const { color, emissive, normalScale } = source;
    if (color) this.color.copy(color);
    if (emissive) this.emissive.copy(emissive);
    if (normalScale) this.normalScale.copy(normalScale);
  }

  /** Whether a value has changed. Allocates nothing. */
  differFrom(source: SurfaceMaterial): boolean {
    const { color, emissive, normalScale } = source;
    return (
      this.visible !== source.visible ||
      this.opacity !== source.opacity ||
      this.transparent !== source.transparent ||
      this.side !== source.side ||
      this.alphaTest !== source.alphaTest ||
      this.alphaHash !== source.alphaHash ||
      this.blending !== source.blending ||
      this.colorWrite !== source.colorWrite ||
      this.depthTest !== source.depthTest ||
      this.depthFunc !== source.depthFunc ||
      this.depthWrite !== source.depthWrite ||
      this.polygonOffset !== source.polygonOffset ||
      this.polygonOffsetFactor !== source.polygonOffsetFactor ||
      this.polygonOffsetUnits !== source.polygonOffsetUnits ||
      this.clippingPlanes !== source.clippingPlanes ||
      this.clipIntersection !== source.clipIntersection ||
      this.alphaToCoverage !== source.alphaToCoverage ||
      this.stencilWrite !== source.stencilWrite ||
      this.stencilFunc !== source.stencilFunc ||
      this.stencilRef !== source.stencilRef ||
      this.stencilFuncMask !== source.stencilFuncMask ||
      this.vertexColors !== source.vertexColors ||
      this.fog !== source.fog ||
      this.wireframe !== source.wireframe ||
      this.map !== source.map ||
      this.alphaMap !== source.alphaMap ||
      this.normalMap !== source.normalMap ||
      this.normalMapType !== source.normalMapType ||
      this.bumpMap !== source.bumpMap ||
      this.bumpScale !== source.bumpScale ||
      this.flatShading !== source.flatShading ||
      this.aoMap !== source.aoMap ||
      this.aoMapIntensity !== source.aoMapIntensity ||
      this.lightMap !== source.lightMap ||
      this.lightMapIntensity !== source.lightMapIntensity ||
      this.emissiveIntensity !== source.emissiveIntensity ||
      this.emissiveMap !== source.emissiveMap ||
      this.metalness !== source.metalness ||
      this.roughness !== source.roughness ||
      (color !== undefined && !this.color.equals(color)) ||
      (emissive !== undefined && !this.emissive.equals(emissive)) ||
      (normalScale !== undefined && !this.normalScale.equals(normalScale))
    );
  }
}
