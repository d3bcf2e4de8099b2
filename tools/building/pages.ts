import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Connect, Plugin } from 'vite';

/** The pages beside the playground. The address of each is the name of its room in src/playground. */
const ROOMS = ['figures', 'fetch'];

const sourceOf = (room: string): string => `src/playground/${room}/index.html`;

/** What the build starts from, as paths below the root: the playground's page, and one in a folder for each other page. */
export const pageInputs = ['index.html', ...ROOMS.map((room) => `${room}/index.html`)];

/**
 * Gives the pages their short addresses: the source of `/figures/` is `tools/figures/index.html`. `/figures` is sent on to the folder, as
 * hosts of static files do.
 */
export function pages(): Plugin {
  let sources = new Map<string, string>();
  return {
    name: 'pages',
    configResolved({ root }) {
      sources = new Map(ROOMS.map((room) => [join(root, room, 'index.html'), join(root, sourceOf(room))]));
    },
    resolveId: (id) => (sources.has(id) ? id : undefined),
    load(id) {
      const source = sources.get(id);
      return source === undefined ? undefined : readFileSync(source, 'utf8');
    },
    configureServer: ({ middlewares }) => void middlewares.use(toFolder).use(toSource),
    configurePreviewServer: ({ middlewares }) => void middlewares.use(toFolder),
  };
}

const toFolder: Connect.NextHandleFunction = ({ url }, response, next) => {
  if (ROOMS.some((room) => url === `/${room}`)) response.writeHead(301, { Location: `${url}/` }).end();
  else next();
};

const toSource: Connect.NextHandleFunction = (request, _response, next) => {
  const [path, ...query] = request.url?.split('?') ?? [];
  const room = ROOMS.find((name) => path === `/${name}/` || path === `/${name}/index.html`);
  if (room) request.url = [`/${sourceOf(room)}`, ...query].join('?');
  next();
};
