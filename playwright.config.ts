import { availableParallelism } from 'node:os';
import { defineConfig } from '@playwright/test';
import type { ThreeOptions } from './tests/browser/ThreeOptions.js';
import { BUILT } from './tools/browser/builtPlayground.js';
import { launchOptions } from './tools/browser/launchOptions.mjs';

/** An uncommon port, so that a playground somebody left open is never mistaken for the code under test. */
const port = Number(process.env.HATCH_PORT ?? 41730);
const pages = `http://127.0.0.1:${port}/`;

/** What must hold with every version of three.js, by file and title; the other tests run with the newest only. */
const core = [
  /(besideLambert|embedding|engraved|lights|lines|manyMeshes)\.spec/,
  /equals the double-precision reference: (torus|phong|reflected light|second layer|tone curve)/,
  /(anchored|engraved) equals .*(moved object|perceptual)/,
  /what three\.js computes on the processor: skin/,
  /under half a bright sky/,
  /first frame in an environment/,
  /make the tone of three's Lambert/,
  /(outside a shadow no stroke|under one light strokes run across|the tone of shadows alone)/,
  /(loses it evenly with the distance|as wide as those of a round lamp).*PCF, (directional|spot)$/,
  /strokes turn to the lights that arrive.*shadow of (directional|spot|point)/,
];

export default defineConfig<object, ThreeOptions>({
  testDir: 'tests',
  testMatch: '**/*.spec.ts',
  outputDir: 'tests/output/playwright',
  globalSetup: './tests/browser/globalSetup.ts',
  forbidOnly: !!process.env.CI,
  // Software rendering uses every core, but pages and compilers one at a time: two browsers at once take two thirds of the time.
  workers: Math.min(2, availableParallelism()),
  retries: 0,
  // What breaks everything shall not take hours to say so.
  maxFailures: process.env.CI ? 40 : 0,
  // Several times what the slowest test takes on two quiet cores: a limit of time must not decide whether a test passes.
  timeout: 300_000,
  expect: { timeout: 60_000 },
  reporter: [['list'], ['json', { outputFile: 'tests/output/playwright.json' }]],
  use: {
    baseURL: pages,
    viewport: { width: 1000, height: 700 },
    deviceScaleFactor: 1,
    launchOptions: await launchOptions(),
    screenshot: 'only-on-failure',
    trace: 'off',
  },
  // Those with one worker come first: at the end they would leave the other without work.
  projects: [
    // One page for all, in a browser with WebGPU.
    {
      name: 'webgpu',
      testDir: 'tests/webgpu',
      workers: 1,
      use: { launchOptions: await launchOptions(undefined, { webgpu: true }) },
    },
    // All of them build into one folder.
    { name: 'consumers', testDir: 'tests/consumers', workers: 1 },
    ...['three-oldest', 'three-middle'].map((name) => ({
      name,
      testDir: 'tests/gpu',
      grep: core,
      use: { three: name },
      // The server of each worker would prepare the same dependencies.
      workers: 1,
    })),
    { name: 'e2e', testDir: 'tests/e2e', use: { baseURL: new URL(BUILT, pages).href } },
    ...['gpu', 'visual'].map((name) => ({ name, testDir: `tests/${name}` })),
  ],
  webServer: {
    command: `node node_modules/vite/bin/vite.js --mode test --host 127.0.0.1 --port ${port} --strictPort`,
    url: `http://127.0.0.1:${port}/tests/browser/blank.html`,
    reuseExistingServer: false,
    stdout: 'ignore',
    stderr: 'pipe',
    timeout: 120_000,
  },
});
