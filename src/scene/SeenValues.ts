import type { SurfaceMaterial } from './SurfaceMaterial.js';

/**
 * The values of a material when it was last looked at, to find out in every frame whether one has changed. Each property is compared by
 * a line of its own: engines compile that to code that takes a fraction of a microsecond, and a loop over names to ten times as much.
 */
export class SeenValues {
  private visible: unknown;
  private opacity: unknown;
  private transparent: unknown;
  private side: unknown;
  private alphaTest: unknown;
  private alphaHash: unknown;
  private blending: unknown;
  private colorWrite: unknown;
  private depthTest: unknown;
  private depthFunc: unknown;
  private depthWrite: unknown;
  private polygonOffset: unknown;
  private polygonOffsetFactor: unknown;
  private polygonOffsetUnits: unknown;
  private clippingPlanes: unknown;
  private clipIntersection: unknown;
  private alphaToCoverage: unknown;
  private stencilWrite: unknown;
  private stencilFunc: unknown;
  private stencilRef: unknown;
  private stencilFuncMask: unknown;
  private vertexColors: unknown;
  private fog: unknown;
  private wireframe: unknown;
  private map: unknown;
  private alphaMap: unknown;
  private normalMap: unknown;
  private normalMapType: unknown;
  private bumpMap: unknown;
  private bumpScale: unknown;
  private flatShading: unknown;
  private aoMap: unknown;
  private aoMapIntensity: unknown;
  private lightMap: unknown;
  private lightMapIntensity: unknown;
  private emissiveIntensity: unknown;
  private emissiveMap: unknown;
  private colorR = 0;
  private colorG = 0;
  private colorB = 0;
  private emissiveR = 0;
  private emissiveG = 0;
  private emissiveB = 0;
  private normalScaleX = 0;
  private normalScaleY = 0;

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
    if (color) {
      this.colorR = color.r;
      this.colorG = color.g;
      this.colorB = color.b;
    }
    if (emissive) {
      this.emissiveR = emissive.r;
      this.emissiveG = emissive.g;
      this.emissiveB = emissive.b;
    }
    if (normalScale) {
      this.normalScaleX = normalScale.x;
      this.normalScaleY = normalScale.y;
    }
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
      (color !== undefined && (this.colorR !== color.r || this.colorG !== color.g || this.colorB !== color.b)) ||
      (emissive !== undefined &&
        (this.emissiveR !== emissive.r || this.emissiveG !== emissive.g || this.emissiveB !== emissive.b)) ||
      (normalScale !== undefined && (this.normalScaleX !== normalScale.x || this.normalScaleY !== normalScale.y))
    );
  }
}
