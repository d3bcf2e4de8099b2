import {
  type Camera,
  DepthFormat,
  DepthStencilFormat,
  DepthTexture,
  FloatType,
  RedFormat,
  type Texture,
  type TextureDataType,
  UnsignedInt248Type,
  UnsignedIntType,
  UnsignedShortType,
  type Vector4,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';

/** A depth format that can be copied from and to. */
interface Format {
  type: TextureDataType;
  format: DepthTexture['format'];
}

/** The greatest number of copies, and the number of frames after which an unused copy is freed. */
const MAX_COPIES = 4;
const KEPT_FRAMES = 60;

interface Copy {
  target: WebGLRenderTarget;
  /** The frame of the last copy. */
  frame: number;
}

/** The depth format of a framebuffer, as WebGL reports it. */
interface DepthFacts {
  bits: number;
  isFloat: boolean;
  /** Null if unknown: a canvas may have a stencil that it does not report. */
  hasStencil: boolean | null;
}

/** The depth formats that fit, the likeliest first: a wrong one makes browsers write a warning to the console. */
function formatsOf({ bits, isFloat, hasStencil }: DepthFacts): readonly Format[] {
  const withStencil = { type: isFloat ? FloatType : UnsignedInt248Type, format: DepthStencilFormat };
  const alone = { type: isFloat ? FloatType : bits === 16 ? UnsignedShortType : UnsignedIntType, format: DepthFormat };
  if (hasStencil !== null) return [hasStencil ? withStencil : alone];
  return isFloat || bits === 16 ? [alone] : [withStencil, alone];
}

/**
 * Copies the depth that a renderer has drawn so far in a frame, so that outlines can read it: once per camera, when its first outlines
 * are drawn, after all opaque objects.
 */
export class SceneDepth {
  /** The copies, one per size and format of the render target: pictures in a scene have others than the canvas. */
  private copies: Copy[] = [];
  private latest: WebGLRenderTarget | null = null;
  private frame = -1;
  private camera: Camera | null = null;
  private isCopied = false;
  /** The depth format of each framebuffer; null if it has none that can be copied. The canvas has no framebuffer object. */
  private readonly formats = new WeakMap<object, Format | null>();

  constructor(private readonly renderer: WebGLRenderer) {}

  /**
   * The depth of the scene as a camera sees it in this frame; null if it cannot be read. @param viewport the part of the render target
   * that the camera draws into
   */
  read(camera: Camera, viewport: Vector4): Texture | null {
    const { frame } = this.renderer.info.render;
    if (frame !== this.frame || camera !== this.camera) {
      this.frame = frame;
      this.camera = camera;
      this.isCopied = this.update(camera, viewport);
    }
    return this.isCopied ? this.latest!.depthTexture : null;
  }

  /**
   * Frees the copies; a later read makes new ones. Also called when the context is lost: in a restored context the old names of its
   * textures may stand for others.
   */
  readonly dispose = (): void => {
    for (const { target } of this.copies) target.dispose();
    this.copies = [];
    this.latest = null;
    this.frame = -1;
    this.renderer.domElement.removeEventListener('webglcontextlost', this.dispose);
  };

  private update(camera: Camera, viewport: Vector4): boolean {
    const { renderer } = this;
    // The framebuffers of WebXR cannot be copied.
    if (renderer.xr.isPresenting) return false;
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const framebuffer: WebGLFramebuffer | null = gl.getParameter(gl.DRAW_FRAMEBUFFER_BINDING);
    const key = framebuffer ?? gl;
    const known = this.formats.get(key);
    if (known !== undefined) return known !== null && this.copyFrom(framebuffer, known, camera, viewport);
    const found = this.candidates(gl, framebuffer).find((format) => {
      // Errors of earlier calls are not those of the copy.
      for (let i = 0; i < 8 && gl.getError() !== gl.NO_ERROR; i++);
      this.copyFrom(framebuffer, format, camera, viewport);
      return gl.getError() === gl.NO_ERROR;
    });
    this.formats.set(key, found ?? null);
    return found !== undefined;
  }

  private candidates(gl: WebGL2RenderingContext, framebuffer: WebGLFramebuffer | null): readonly Format[] {
    const at = framebuffer ? gl.DEPTH_ATTACHMENT : gl.DEPTH;
    const ask = (what: number, where: number = at): number =>
      gl.getFramebufferAttachmentParameter(gl.FRAMEBUFFER, where, what);
    if (ask(gl.FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) === gl.NONE) return [];
    return formatsOf({
      bits: ask(gl.FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE),
      isFloat: ask(gl.FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) === gl.FLOAT,
      hasStencil: framebuffer && ask(gl.FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, gl.STENCIL_ATTACHMENT) !== gl.NONE,
    });
  }

  private copyFrom(from: WebGLFramebuffer | null, format: Format, camera: Camera, viewport: Vector4): true {
    const { renderer } = this;
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const target = renderer.getRenderTarget();
    const face = renderer.getActiveCubeFace();
    const level = renderer.getActiveMipmapLevel();
    // The whole depth into a texture of its size: where samples are resolved, drivers copy nothing else, or everything but what they
    // copied before.
    const width = target ? Math.max(1, target.width >> level) : gl.drawingBufferWidth;
    const height = target ? Math.max(1, target.height >> level) : gl.drawingBufferHeight;
    this.latest = this.copyOf(format, width, height);
    renderer.setRenderTarget(this.latest);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, from);
    gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.DEPTH_BUFFER_BIT, gl.NEAREST);
    renderer.setRenderTarget(target, face, level);
    gl.bindFramebuffer(gl.FRAMEBUFFER, from);
    // Each camera of an ArrayCamera draws into its own part of the render target.
    if ((camera as Camera & { viewport?: Vector4 }).viewport) renderer.state.viewport(viewport);
    return true;
  }

  private copyOf({ type, format }: Format, width: number, height: number): WebGLRenderTarget {
    const { frame, renderer } = this;
    let found: Copy | null = null;
    let oldest: Copy | null = null;
    for (let i = this.copies.length - 1; i >= 0; i--) {
      const copy = this.copies[i];
      const { depthTexture, width: copyWidth, height: copyHeight } = copy.target;
      const isOfFormat = depthTexture?.type === type && depthTexture.format === format;
      if (isOfFormat && copyWidth === width && copyHeight === height) found = copy;
      else if (copy.frame < frame - KEPT_FRAMES) this.free(copy);
      else if (oldest === null || copy.frame < oldest.frame) oldest = copy;
    }
    if (found) {
      found.frame = frame;
      return found.target;
    }
    if (oldest && this.copies.length >= MAX_COPIES) this.free(oldest);
    renderer.domElement.addEventListener('webglcontextlost', this.dispose);
    const depthTexture = new DepthTexture(width, height, type);
    depthTexture.format = format;
    const target = new WebGLRenderTarget(width, height, {
      // A framebuffer needs a colour attachment; one byte per texel is the least.
      format: RedFormat,
      depthTexture,
      stencilBuffer: format === DepthStencilFormat,
      generateMipmaps: false,
    });
    this.copies.push({ target, frame });
    return target;
  }

  private free(copy: Copy): void {
    copy.target.dispose();
    this.copies.splice(this.copies.indexOf(copy), 1);
  }
}

const depths = new WeakMap<WebGLRenderer, SceneDepth>();

/** The depth copies that the outlines of one renderer share. */
export function sceneDepthOf(renderer: WebGLRenderer): SceneDepth {
  let depth = depths.get(renderer);
  if (!depth) {
    depth = new SceneDepth(renderer);
    depths.set(renderer, depth);
  }
  return depth;
}
