/** The WebGPU adapter, as far as the browser describes it; null without one. */
export async function describeAdapter(): Promise<string | null> {
  const info = (await navigator.gpu?.requestAdapter())?.info;
  if (!info) return null;
  const { vendor, architecture, device, description } = info;
  return [...new Set([vendor, architecture, device, description])].filter(Boolean).join(', ');
}
