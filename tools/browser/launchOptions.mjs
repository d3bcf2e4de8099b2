import { findChromium } from './findChromium.mjs';

/** Chromium's flags per rasteriser. SwiftShader draws the goldens; llvmpipe is a second software rasteriser (it needs libegl1 and
 * libgl1-mesa-dri), and gpu is the graphics card. */
const rasterisers = {
  swiftshader: ['--use-angle=swiftshader'],
  llvmpipe: ['--use-gl=angle', '--use-angle=gl-egl', '--ignore-gpu-blocklist'],
  // Headless Linux has no window system, but EGL.
  gpu: ['--use-gl=angle', ...(process.platform === 'linux' ? ['--use-angle=gl-egl'] : []), '--ignore-gpu-blocklist'],
};

/** Further flags for WebGPU in Chromium on Linux; other systems with a card need none. */
const withWebGPU = {
  swiftshader: ['--enable-unsafe-webgpu', '--use-webgpu-adapter=swiftshader'],
  llvmpipe: ['--enable-unsafe-webgpu'],
  gpu: ['--enable-unsafe-webgpu'],
};

/** With a software rasterizer the GPU process ends when a canvas of WebGPU is shown, unless the compositor uses Vulkan too. */
const showingWebGPU = { swiftshader: ['--enable-features=Vulkan', '--use-vulkan=swiftshader'], llvmpipe: [], gpu: [] };

/** Without these flags Chromium calls its maker's hosts, which only costs time on a closed network. */
const quiet = [
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--disable-quic',
  '--no-first-run',
];

/**
 * Playwright's launch options for the Chromium found here.
 *
 * The path found is kept in HATCH_CHROMIUM, so that the processes a test runner starts do not search again.
 *
 * @param {keyof typeof rasterisers} rasteriser - from HATCH_RASTERISER if not given; SwiftShader by default.
 * @param {{ webgpu?: boolean | 'shown' }} [options] - webgpu: whether to ask for WebGPU, which not every browser has, and whether its canvases
 *   are shown on pages. Default: false
 */
export async function launchOptions(
  rasteriser = process.env.HATCH_RASTERISER ?? 'swiftshader',
  { webgpu = false } = {},
) {
  const flags = rasterisers[rasteriser];
  if (!flags) {
    const known = Object.keys(rasterisers).join(', ');
    throw new Error(`launchOptions: no rasteriser "${rasteriser}"; HATCH_RASTERISER takes ${known}.`);
  }
  const { executablePath } = await findChromium();
  process.env.HATCH_CHROMIUM = executablePath;
  // Chromium's sandbox does not work for root; there Playwright leaves it off, as it does by default elsewhere.
  return {
    executablePath,
    chromiumSandbox: false,
    args: [
      ...flags,
      ...(webgpu ? withWebGPU[rasteriser] : []),
      ...(webgpu === 'shown' ? showingWebGPU[rasteriser] : []),
      ...quiet,
    ],
  };
}
