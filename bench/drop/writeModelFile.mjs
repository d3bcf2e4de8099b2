import { writeFileSync } from 'node:fs';
import { Mesh, TorusGeometry } from 'three';
import { PLYExporter } from 'three/addons/exporters/PLYExporter.js';
import { STLExporter } from 'three/addons/exporters/STLExporter.js';

/** Writes a torus of twice `rings` × `segments` triangles as a binary file; the end of its name says of which format. */
export function writeModelFile(path, rings, segments) {
  const mesh = new Mesh(new TorusGeometry(1, 0.4, rings, segments));
  const content = path.endsWith('.stl')
    ? new STLExporter().parse(mesh, { binary: true })
    : new PLYExporter().parse(mesh, undefined, { binary: true });
  writeFileSync(path, new DataView(content.buffer ?? content));
}
