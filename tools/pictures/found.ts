import { GLTFExporter } from 'three/addons/exporters/GLTFExporter.js';
import { OBJExporter } from 'three/addons/exporters/OBJExporter.js';
import { FOUND_SCENES } from './foundScenes.js';
import type { PlainFiles } from './plain.js';

/** Writes each of the found scenes as the file that a stranger would drop. */
async function writeFound(): Promise<PlainFiles> {
  return Promise.all(
    Object.entries(FOUND_SCENES).map(async ([title, { format, make }]) => {
      const scene = make();
      scene.updateMatrixWorld(true);
      const content =
        format === 'obj'
          ? new OBJExporter().parse(scene)
          : ((await new GLTFExporter().parseAsync(scene, { binary: true })) as ArrayBuffer);
      return { name: `${title.replaceAll(' ', '-')}.${format}`, content: await base64Of(new Blob([content])) };
    }),
  );
}

async function base64Of(blob: Blob): Promise<string> {
  const bytes = new Uint8Array(await blob.arrayBuffer());
  let binary = '';
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return btoa(binary);
}

declare global {
  interface Window {
    writeFound?: typeof writeFound;
  }
}
window.writeFound = writeFound;
