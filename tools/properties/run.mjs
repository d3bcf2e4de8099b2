/** `npm run properties`: writes what the table of properties drives (tools/properties/outputs.ts). */
import { writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { createServer } from 'vite';

const root = fileURLToPath(new URL('../..', import.meta.url));
const server = await createServer({
  root,
  logLevel: 'error',
  server: { middlewareMode: true, ws: false, watch: null },
});
const { outputs } = await server.ssrLoadModule('/tools/properties/outputs.ts');
for (const [path, text] of Object.entries(outputs())) writeFileSync(`${root}${path}`, text);
await server.close();
