import { execFileSync } from 'node:child_process';
import { cpus, loadavg } from 'node:os';
import { describeRenderer } from '../browser/describeRenderer.mjs';

const git = (...args) => execFileSync('git', args, { encoding: 'utf8' }).trim();

/**
 * The environment of a measurement and the commit. HATCH_RASTERISER names the rasterizer.
 *
 * @throws when another rasteriser draws than was asked for.
 */
export async function describeEnvironment() {
  const { browser, renderer } = await describeRenderer();
  const wanted = process.env.HATCH_RASTERISER;
  if (wanted && wanted !== 'gpu' && !renderer.toLowerCase().includes(wanted)) {
    throw new Error(
      `bench: ${wanted} was asked for, but ${renderer} draws. For llvmpipe, Debian needs libegl1 and libgl1-mesa-dri; --rasteriser=swiftshader does without.`,
    );
  }
  const changes = git('status', '--porcelain', '--', '.', ':!tools/bench/results', ':!docs/research/benchmarks.md');
  return {
    commit: `${git('rev-parse', '--short', 'HEAD')}${changes ? ' with changes' : ''}`,
    renderer,
    chromium: browser,
    node: process.version,
    cpu: cpus()[0]?.model,
    cores: cpus().length,
    // The load of the machine, by which a reader judges the times.
    load: loadavg()[0],
  };
}
