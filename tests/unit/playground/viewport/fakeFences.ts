/** A graphics context of which only the fences work. They are signalled when the test says so. */
export function fakeFences() {
  const SIGNALED = 1;
  const fences = new Set<object>();
  const state = { isFinished: false, isLost: false, isFlushed: false };
  const context = {
    SYNC_GPU_COMMANDS_COMPLETE: 2,
    SYNC_STATUS: 3,
    SIGNALED,
    fenceSync: () => {
      if (state.isLost) return null;
      const fence = {};
      fences.add(fence);
      return fence;
    },
    flush: () => {
      state.isFlushed = true;
    },
    isContextLost: () => state.isLost,
    isSync: (fence: object) => fences.has(fence),
    getSyncParameter: (fence: object) => (fences.has(fence) && state.isFinished ? SIGNALED : null),
    deleteSync: (fence: object | null) => void (fence && fences.delete(fence)),
  };
  return {
    context: context as unknown as WebGL2RenderingContext,
    fences,
    get isFlushed() {
      return state.isFlushed;
    },
    /** Something is asked for that is not drawn yet. */
    begin: () => {
      state.isFinished = false;
    },
    /** Everything that was asked for is drawn. */
    finish: () => {
      state.isFinished = true;
    },
    /** Loses the context, and with it all fences. */
    lose: () => {
      state.isLost = true;
      fences.clear();
    },
    restore: () => {
      state.isLost = false;
    },
  };
}
