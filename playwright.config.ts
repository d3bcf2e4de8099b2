import { defineConfig } from '@playwright/test';
import { launchOptions } from './tests/browser/launchOptions.mjs';
import type { ThreeOptions } from './tests/browser/ThreeOptions.js';

/** An uncommon port, so that a playground somebody left open is never mistaken for the code under test. */
const port = Number(process.env.HATCH_PORT ?? 41730);

/** What must hold with every version of three.js, by file and title; the other tests run with the newest only. */
const core = [
  /(embedding|engraved|lights|lines)\.spec/,
  /equals the double-precision reference: (torus|phong|reflected light|second layer|tone curve)/,
  /(anchored|engraved) equals .*(moved object|perceptual)/,
  /what three\.js computes on the processor: skin/,
  /under half a bright sky/,
  /first frame in an environment/,
  /make the tone of three's Lambert/,
  /(outside a shadow no stroke|under one light strokes run across|the tone of shadows alone)/,
  /strokes turn to the lights that arrive.*shadow of (directional|spot|point)/,
];

export default defineConfig<object, ThreeOptions>({
  testDir: 'tests',
  testMatch: '**/*.spec.ts',
  outputDir: 'tests/output/playwright',
  globalSetup: './tests/browser/globalSetup.ts',
  forbidOnly: !!process.env.CI,
  // Software rendering uses every core by itself; more browsers at once only wait for each other.
  workers: 1,
  retries: 0,
  timeout: 120_000,
  expect: { timeout: 15_000 },
  reporter: [['list'], ['json', { outputFile: 'tests/output/playwright.json' }]],
  use: {
    baseURL: `http://127.0.0.1:${port}/`,
    viewport: { width: 1000, height: 700 },
    deviceScaleFactor: 1,
    launchOptions: await launchOptions(),
    screenshot: 'only-on-failure',
    trace: 'off',
  },
  projects: [
    ...['gpu', 'visual', 'e2e', 'consumers'].map((name) => ({ name, testDir: `tests/${name}` })),
    ...['three-oldest', 'three-middle'].map((name) => ({
      name,
      testDir: 'tests/gpu',
      grep: core,
      use: { three: name },
    })),
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
