/** Who draws what WebGPU draws, as far as the browser tells; null where it has no adapter. */
export async function describeAdapter(): Promise<{ name: string; isSoftware: boolean } | null> {
  const info = (await navigator.gpu?.requestAdapter())?.info;
  if (!info) return null;
  const { vendor, architecture, device, description } = info;
  const name = [...new Set([vendor, architecture, device, description])].filter(Boolean).join(', ');
  return { name, isSoftware: info.isFallbackAdapter || /swiftshader|llvmpipe|lavapipe/i.test(name) };
}
