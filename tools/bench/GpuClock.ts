/** Frames of a GPU are too short to be timed one by one: this many are timed together. */
const FRAMES_PER_QUERY = 8;

/** The extension of WebGL 2 that times on the GPU. */
interface TimerQuery {
  readonly TIME_ELAPSED_EXT: number;
}

/** Times frames on the GPU, without the time of the processor (`EXT_disjoint_timer_query_webgl2`). */
export class GpuClock {
  private constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly timer: TimerQuery,
  ) {}

  /**
   * The clock that the page's address asks for by `?clock=gpu`; null where it does not.
   *
   * @throws if the browser has none
   */
  static of(gl: WebGL2RenderingContext): GpuClock | null {
    if (new URLSearchParams(location.search).get('clock') !== 'gpu') return null;
    const timer = gl.getExtension('EXT_disjoint_timer_query_webgl2');
    if (!timer) throw new Error('GpuClock: this browser cannot time on the GPU (EXT_disjoint_timer_query_webgl2).');
    return new GpuClock(gl, timer);
  }

  /** Milliseconds that a frame takes. */
  async time(drawFrame: () => void): Promise<number> {
    const { gl, timer } = this;
    const query = gl.createQuery();
    gl.beginQuery(timer.TIME_ELAPSED_EXT, query);
    for (let i = 0; i < FRAMES_PER_QUERY; i++) drawFrame();
    gl.endQuery(timer.TIME_ELAPSED_EXT);
    // Results arrive between tasks, never within one.
    do await new Promise((resolve) => setTimeout(resolve, 0));
    while (!gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE));
    const nanoseconds = gl.getQueryParameter(query, gl.QUERY_RESULT);
    gl.deleteQuery(query);
    return nanoseconds / 1e6 / FRAMES_PER_QUERY;
  }
}
