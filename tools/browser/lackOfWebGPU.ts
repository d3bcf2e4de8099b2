/** Why this browser has no WebGPU, as a sentence; null where it has. */
export async function lackOfWebGPU(): Promise<string | null> {
  if (!navigator.gpu) return 'The browser does not know WebGPU.';
  const adapter = await navigator.gpu.requestAdapter();
  if (!adapter) return 'The browser knows WebGPU, and has no adapter for it.';
  try {
    (await adapter.requestDevice()).destroy();
    return null;
  } catch (error) {
    return `The adapter for WebGPU gives no device: ${error}`;
  }
}
