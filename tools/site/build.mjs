/**
 * `npm run site`: builds the site into dist-site, as static files: the guides, the declarations, the examples and the playground.
 * SITE_BASE is the path it will lie at, `/` if it is not set. The generator is a package of its own, with the older TypeScript that
 * TypeDoc needs; it is installed when it is missing.
 */
import { execFileSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { buildExamples } from '../../examples/build.mjs';
import { readExamples } from '../../examples/readExamples.mjs';

const root = fileURLToPath(new URL('../..', import.meta.url));
const site = join(root, 'tools/site');
const pages = join(site, 'pages');
const out = join(root, 'dist-site');
/** Pages whose source lies in the project's root, by the name of that file. */
const ROOT_PAGES = {
  'README.md': 'index.md',
  'CHANGELOG.md': 'changelog.md',
  'CONTRIBUTING.md': 'contributing.md',
  'SECURITY.md': 'security.md',
};

/** Runs a program of the generator's package, which has a Vite of its own. */
const run = (program, ...args) =>
  execFileSync(process.execPath, [join(site, 'node_modules', program), ...args], { cwd: site, stdio: 'inherit' });

if (!existsSync(join(site, 'node_modules'))) {
  execFileSync('npm', ['ci', '--no-audit', '--no-fund'], {
    cwd: site,
    stdio: 'inherit',
    shell: process.platform === 'win32',
  });
}
gatherPages();
run('typedoc/bin/typedoc', '--out', join(pages, 'api'));
run('vitepress/bin/vitepress.js', 'build', '--outDir', out);
await buildExamples(join(out, 'live'));
execFileSync(
  process.execPath,
  [
    join(root, 'node_modules/vite/bin/vite.js'),
    'build',
    '--logLevel',
    'error',
    '--outDir',
    join(out, 'playground'),
    '--emptyOutDir',
  ],
  { cwd: root, stdio: 'inherit' },
);

/** Copies README, guides and their pictures into one folder, as the generator expects them. */
function gatherPages() {
  rmSync(pages, { recursive: true, force: true });
  mkdirSync(pages);
  for (const name of readdirSync(join(root, 'docs')))
    cpSync(join(root, 'docs', name), join(pages, name), { recursive: true });
  cpSync(join(site, 'static'), pages, { recursive: true });
  cpSync(join(root, 'public/lamp.svg'), join(pages, 'public/lamp.svg'));
  for (const { folder } of readExamples()) {
    cpSync(join(root, `examples/${folder}/picture.webp`), join(pages, `public/examples-pictures/${folder}.webp`));
  }
  const home = readFileSync(join(pages, 'home.md'), 'utf8');
  rmSync(join(pages, 'home.md'));
  const readme = readFileSync(join(root, 'README.md'), 'utf8')
    .replace(/^# .*\n/, '')
    .replaceAll('](docs/', '](');
  writeFileSync(join(pages, 'index.md'), `${home}\n${readme}`);
  for (const [from, to] of Object.entries(ROOT_PAGES)) {
    if (from !== 'README.md')
      writeFileSync(join(pages, to), readFileSync(join(root, from), 'utf8').replaceAll('](docs/', ']('));
  }
  for (const folder of [pages, join(pages, 'research')]) {
    for (const name of readdirSync(folder).filter((file) => file.endsWith('.md'))) {
      const path = join(folder, name);
      const text = readFileSync(path, 'utf8');
      writeFileSync(path, folder === pages ? withSiteLinks(text) : withResearchLinks(text));
    }
  }
}

/** The links of a page in the folder `research`: those one folder up lead to guides. */
function withResearchLinks(text) {
  return text.replace(/\[([^\]]*)\]\(\.\.\/\.\.\/[^)]*\)/g, '$1');
}

/** Turns links between files of the project into links between pages. A link to a file that is no page becomes plain text. */
function withSiteLinks(text) {
  return text
    .replace(/\]\((?:\.\.\/)?(\w+\.md)/g, (link, name) => (ROOT_PAGES[name] ? `](${ROOT_PAGES[name]}` : link))
    .replace(/\]\(\.\.\/examples\/([\w-]+)\/page\.html\)/g, '](./examples.md#$1)')
    .replaceAll('](examples)', '](examples.md)')
    .replace(/\[([^\]]*)\]\(\.\.\/[^)]*\)/g, '$1');
}
