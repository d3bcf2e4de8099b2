const POLL_MILLISECONDS = 10;

/**
 * Resolves when the graphics card has finished all commands so far, or the context was lost. Reading pixels earlier would block the page
 * until then.
 */
export function whenDrawn(gl: WebGL2RenderingContext): Promise<void> {
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  // Without the flush, the fence might wait for the commands of the next frame.
  gl.flush();
  return new Promise((resolve) => {
    const poll = (): void => {
      // A fence is invalid once its context was lost, even if the context has been restored since.
      if (fence && gl.isSync(fence) && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) {
        setTimeout(poll, POLL_MILLISECONDS);
        return;
      }
      gl.deleteSync(fence);
      resolve();
    };
    setTimeout(poll, POLL_MILLISECONDS);
  });
}
