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

/** A format of depth that can be copied from and to. */
interface Format {
  type: TextureDataType;
  format: DepthTexture['format'];
}

/** So many copies are kept at most, and none that was not made again for so many frames. */
const MOST_COPIES = 4;
const KEPT_FRAMES = 60;

interface Copy {
  target: WebGLRenderTarget;
  /** The frame in which it was last made. */
  frame: number;
}

/** What WebGL says about the depth of a framebuffer. */
interface DepthFacts {
  bits: number;
  isFloat: boolean;
  /** Null if it is not known: the canvas may have a stencil that it does not show. */
  hasStencil: boolean | null;
}

/** The formats that a depth may have, the likeliest first. A wrong one makes browsers write a warning to the console. */
function formatsOf({ bits, isFloat, hasStencil }: DepthFacts): readonly Format[] {
  const withStencil = { type: isFloat ? FloatType : UnsignedInt248Type, format: DepthStencilFormat };
  const alone = { type: isFloat ? FloatType : bits === 16 ? UnsignedShortType : UnsignedIntType, format: DepthFormat };
  if (hasStencil !== null) return [hasStencil ? withStencil : alone];
  return isFloat || bits === 16 ? [alone] : [withStencil, alone];
}

/**
 * Copies the depth of what a renderer has drawn so far in a frame, so that outlines can read it: once for each camera, when its first
 * outlines are drawn, after all opaque objects.
 */
export class SceneDepth {
  /** The copies of what is drawn to, one for each size and format: pictures in a scene have others than the canvas. */
  private copies: Copy[] = [];
  private latest: WebGLRenderTarget | null = null;
  private frame = -1;
  private camera: Camera | null = null;
  private isCopied = false;
  /** The format of the depth of each framebuffer, or null if it has none that can be copied. The canvas has no object. */
  private readonly formats = new WeakMap<object, Format | null>();

  constructor(private readonly renderer: WebGLRenderer) {}

  /** The depth of the scene as a camera sees it in this frame; null if it cannot be read. @param viewport the part that the camera draws into */
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
   * Frees the copies. What reads it later makes another. It is also called when the context is lost: in a restored context the old names of
   * its textures may stand for others.
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
    // The framebuffers of virtual reality cannot be copied.
    if (renderer.xr.isPresenting) return false;
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const framebuffer: WebGLFramebuffer | null = gl.getParameter(gl.DRAW_FRAMEBUFFER_BINDING);
    const key = framebuffer ?? gl;
    const known = this.formats.get(key);
    if (known !== undefined) return known !== null && this.copyFrom(framebuffer, known, camera, viewport);
    const found = this.candidates(gl, framebuffer).find((format) => {
      // Errors of earlier calls are none of the copy's.
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
    // All of it, into a texture of its size: where samples are resolved, drivers copy nothing else, or all but what they copied before.
    const width = target ? Math.max(1, target.width >> level) : gl.drawingBufferWidth;
    const height = target ? Math.max(1, target.height >> level) : gl.drawingBufferHeight;
    this.latest = this.copyOf(format, width, height);
    renderer.setRenderTarget(this.latest);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, from);
    gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.DEPTH_BUFFER_BIT, gl.NEAREST);
    renderer.setRenderTarget(target, face, level);
    gl.bindFramebuffer(gl.FRAMEBUFFER, from);
    // Each camera of an ArrayCamera draws into its own part of the target.
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
    if (oldest && this.copies.length >= MOST_COPIES) this.free(oldest);
    renderer.domElement.addEventListener('webglcontextlost', this.dispose);
    const depthTexture = new DepthTexture(width, height, type);
    depthTexture.format = format;
    const target = new WebGLRenderTarget(width, height, {
      // A framebuffer needs a colour; of one byte.
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

/** The copy of the depth that outlines share which a renderer draws. */
export function sceneDepthOf(renderer: WebGLRenderer): SceneDepth {
  let depth = depths.get(renderer);
  if (!depth) {
    depth = new SceneDepth(renderer);
    depths.set(renderer, depth);
  }
  return depth;
}
