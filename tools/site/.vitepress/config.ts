import { existsSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitepress';

const pages = new URL('../pages/', import.meta.url);

/** A page of the sidebar, under its own heading, which is put in as HTML. */
function page(name: string): { text: string; link: string } {
  const file = new URL(`${name}.md`, pages);
  const heading = existsSync(file) ? /^# (.+)$/m.exec(readFileSync(file, 'utf8'))?.[1] : undefined;
  return { text: (heading ?? name).replaceAll('`', '').replaceAll('<', '&lt;'), link: `/${name}` };
}

const group = (text: string, ...names: string[]) => ({ text, collapsed: false, items: names.map(page) });

export default defineConfig({
  base: process.env.SITE_BASE ?? '/',
  srcDir: fileURLToPath(pages),
  lang: 'en',
  title: 'three-hatching',
  description: 'Real-time hatching for three.js: strokes that lie in the surface and turn with the light.',
  cleanUrls: true,
  markdown: {
    // Double braces in code are code, and nothing to be filled in.
    config: ({ renderer }) => {
      const { code_inline: inline } = renderer.rules;
      renderer.rules.code_inline = (...rest) => (inline?.(...rest) ?? '').replace('<code', '<code v-pre');
    },
  },
  // The examples and the playground are built beside the pages.
  ignoreDeadLinks: [/^\/(playground|live)\//],
  head: [['link', { rel: 'icon', type: 'image/svg+xml', href: `${process.env.SITE_BASE ?? '/'}lamp.svg` }]],
  vite: {
    // Outside of this folder lies the list of examples.
    server: { fs: { allow: [fileURLToPath(new URL('../../..', import.meta.url))] } },
    build: { chunkSizeWarningLimit: 2000 },
  },
  themeConfig: {
    logo: '/lamp.svg',
    outline: [2, 3],
    search: { provider: 'local' },
    nav: [
      { text: 'Guides', link: '/first-picture' },
      { text: 'Examples', link: '/examples' },
      { text: 'Declarations', link: '/api/' },
      { text: 'Playground', link: '/playground/index.html', target: '_self' },
    ],
    sidebar: [
      group('Start', 'first-picture', 'examples', 'presets', 'lights-and-tone', 'recipes', 'troubleshooting'),
      group('Drawing', 'material', 'media', 'engraving', 'maps', 'hand', 'outlines', 'shadows', 'composition', 'svg'),
      group('Embedding', 'scene', 'configurator', 'react', 'element', 'geometry', 'performance', 'support', 'versions'),
      group(
        'How it is made',
        'research/paper',
        'research/figures',
        'research/methods',
        'research/metrics',
        'research/benchmarks',
        'research/gpu-cost',
        'research/rejected',
      ),
      group('Project', 'changelog', 'contributing', 'security'),
      { text: 'Declarations', link: '/api/' },
    ],
  },
});
