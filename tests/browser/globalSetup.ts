import { describeRenderer } from '../../tools/browser/describeRenderer.mjs';

/** Prints once per run who draws the pixels, and fails the run when nobody does. */
export default async function globalSetup(): Promise<void> {
  const { browser, renderer } = await describeRenderer();
  console.log(`Chromium ${browser}, ${renderer}`);
}
