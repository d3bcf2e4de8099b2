/** Who draws what WebGPU draws, as far as the browser tells; null where it has no adapter. */
export async function describeAdapter(): Promise<string | null> {
  const info = (await navigator.gpu?.requestAdapter())?.info;
  if (!info) return null;
  const { vendor, architecture, device, description } = info;
  return [...new Set([vendor, architecture, device, description])].filter(Boolean).join(', ');
}
