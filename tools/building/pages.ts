import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Connect, Plugin } from 'vite';

/** The sources of the pages beside the playground, by the folder of their address. */
const SOURCES: Readonly<Record<string, string>> = {
  figures: 'tools/figures/index.html',
  fetch: 'src/playground/fetch/index.html',
};
const PAGES = Object.keys(SOURCES);

/** The entries of the build, as paths below the root: the playground's page, and one in a folder for each other page. */
export const pageInputs = ['index.html', ...PAGES.map((page) => `${page}/index.html`)];

/**
 * Gives the pages their short addresses: the source of `/figures/` is `tools/figures/index.html`. `/figures` is sent on to the folder, as
 * hosts of static files do.
 */
export function pages(): Plugin {
  let sources = new Map<string, string>();
  return {
    name: 'pages',
    configResolved({ root }) {
      sources = new Map(PAGES.map((page) => [join(root, page, 'index.html'), join(root, SOURCES[page])]));
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
  if (PAGES.some((page) => url === `/${page}`)) response.writeHead(301, { Location: `${url}/` }).end();
  else next();
};

const toSource: Connect.NextHandleFunction = (request, _response, next) => {
  const [path, ...query] = request.url?.split('?') ?? [];
  const page = PAGES.find((name) => path === `/${name}/` || path === `/${name}/index.html`);
  if (page) request.url = [`/${SOURCES[page]}`, ...query].join('?');
  next();
};
