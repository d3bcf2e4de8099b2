import type { WebGLInfo, WebGLRenderer } from 'three';

const POLL_MILLISECONDS = 10;

/** Compiles the programs of a scene in the background, so that the first frame that needs them does not block the page. */
export class ProgramBuilder {
  private readonly gl: WebGL2RenderingContext;
  /** A fence that is signalled when the browser has passed the programs to the driver. */
  private fence: WebGLSync | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** @param onBuilt called when the programs are ready */
  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly onBuilt: () => void,
  ) {
    this.gl = renderer.getContext() as WebGL2RenderingContext;
  }

  get isBuilding(): boolean {
    return this.timer !== undefined;
  }

  /** Builds programs. @param compile calls the renderer's `compile` for everything that is drawn next */
  build(compile: () => void): void {
    const newest = this.programs.at(-1);
    compile();
    if (this.programs.at(-1) === newest) return;
    this.stop();
    this.fence = this.gl.fenceSync(this.gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    this.gl.flush();
    this.wait();
  }

  stop(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.gl.deleteSync(this.fence);
    this.fence = null;
  }

  private get programs(): NonNullable<WebGLInfo['programs']> {
    return this.renderer.info.programs ?? [];
  }

  private get areReady(): boolean {
    const { gl, fence } = this;
    if (gl.isContextLost()) return true;
    if (fence && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) return false;
    const parallel = gl.getExtension('KHR_parallel_shader_compile');
    // The promise of compileAsync would throw if a material is disposed of meanwhile.
    return (
      !parallel ||
      this.programs.every(({ program }) =>
        gl.getProgramParameter(program as WebGLProgram, parallel.COMPLETION_STATUS_KHR),
      )
    );
  }

  private wait(): void {
    this.timer = setTimeout(() => {
      if (!this.areReady) {
        this.wait();
        return;
      }
      this.stop();
      // three.js queries the uniforms of a program once. During a frame, that would wait for earlier draw calls.
      for (const program of this.programs) program.getUniforms();
      this.onBuilt();
    }, POLL_MILLISECONDS);
  }
}
