import type { Camera, Scene, WebGLInfo, WebGLRenderer } from 'three';

const POLL_MILLISECONDS = 10;

/**
 * Has the programs of a scene built beside the page, so that the first frame that needs them does not hold it up. Where browsers
 * cannot (KHR_parallel_shader_compile), programs count as ready at once.
 */
export class ProgramBuilder {
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** @param onBuilt called when programs that were waited for are ready */
  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly onBuilt: () => void,
  ) {}

  get isBuilding(): boolean {
    return this.timer !== undefined;
  }

  build(scene: Scene, camera: Camera): void {
    this.stop();
    this.renderer.compile(scene, camera);
    if (!this.areReady) this.wait();
  }

  stop(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
  }

  private get programs(): NonNullable<WebGLInfo['programs']> {
    return this.renderer.info.programs ?? [];
  }

  private get areReady(): boolean {
    const gl = this.renderer.getContext();
    const parallel = gl.getExtension('KHR_parallel_shader_compile');
    if (!parallel) return true;
    // Not by the promise of compileAsync: it throws where a material is disposed meanwhile.
    return this.programs.every(({ program }) =>
      gl.getProgramParameter(program as WebGLProgram, parallel.COMPLETION_STATUS_KHR),
    );
  }

  private wait(): void {
    this.timer = setTimeout(() => {
      if (!this.areReady) {
        this.wait();
        return;
      }
      this.timer = undefined;
      // Asks for them once, which in the middle of a frame would wait for what is drawn before.
      for (const program of this.programs) program.getUniforms();
      this.onBuilt();
    }, POLL_MILLISECONDS);
  }
}
