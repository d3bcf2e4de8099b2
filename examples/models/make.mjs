/** `node examples/models/make.mjs`: writes the models of the examples, which are made by code. */
import { writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { createServer } from 'vite';

const root = fileURLToPath(new URL('../..', import.meta.url));
const server = await createServer({
  root,
  logLevel: 'error',
  server: { middlewareMode: true, ws: false, watch: null },
});
const { makeModels } = await server.ssrLoadModule('/examples/models/makeModels.ts');
for (const [name, content] of Object.entries(await makeModels())) {
  writeFileSync(new URL(name, import.meta.url), content);
  console.log(`${name}: ${Math.round(content.length / 1000)} kB`);
}
await server.close();
