import { Color, Vector2 } from 'three';
import type { SurfaceMaterial } from './SurfaceMaterial.js';

/**
 * The values of a material when it was last looked at, to find out in every frame whether one has changed. Each property is compared by
 * a line of its own: engines compile that to code that takes a fraction of a microsecond, and a loop over names to ten times as much.
 */
export class SeenValues {
  visible: unknown;
  opacity: unknown;
  transparent: unknown;
  side: unknown;
  alphaTest: unknown;
  alphaHash: unknown;
  blending: unknown;
  colorWrite: unknown;
  depthTest: unknown;
  depthFunc: unknown;
  depthWrite: unknown;
  polygonOffset: unknown;
  polygonOffsetFactor: unknown;
  polygonOffsetUnits: unknown;
  clippingPlanes: unknown;
  clipIntersection: unknown;
  alphaToCoverage: unknown;
  stencilWrite: unknown;
  stencilFunc: unknown;
  stencilRef: unknown;
  stencilFuncMask: unknown;
  vertexColors: unknown;
  fog: unknown;
  wireframe: unknown;
  map: unknown;
  alphaMap: unknown;
  normalMap: unknown;
  normalMapType: unknown;
  bumpMap: unknown;
  bumpScale: unknown;
  flatShading: unknown;
  aoMap: unknown;
  aoMapIntensity: unknown;
  lightMap: unknown;
  lightMapIntensity: unknown;
  emissiveIntensity: unknown;
  emissiveMap: unknown;
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
      (color !== undefined && !this.color.equals(color)) ||
      (emissive !== undefined && !this.emissive.equals(emissive)) ||
      (normalScale !== undefined && !this.normalScale.equals(normalScale))
    );
  }
}
