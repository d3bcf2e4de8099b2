/** What stands around each example: its title, the way to the others, and its source. */
import { EXAMPLES } from '../examples.js';
import { highlight } from './highlight.js';

const SOURCES = import.meta.glob<string>(['../*/main.{ts,tsx}', '../*/page.html'], {
  query: '?raw',
  import: 'default',
});

const folder = location.pathname.split('/').at(-2);
const at = EXAMPLES.findIndex((example) => example.folder === folder);
const { title, about } = EXAMPLES[at];
document.title = `${title} – three-hatching`;

const text = document.createElement('div');
text.className = 'about';
const heading = document.createElement('h1');
heading.textContent = title;
const sentence = document.createElement('p');
sentence.textContent = about;
const ways = document.createElement('nav');
ways.ariaLabel = 'Examples';
ways.append(
  ...[
    ['../', 'All examples'],
    [`../${EXAMPLES.at(at - 1)!.folder}/`, 'Previous'],
    [`../${EXAMPLES[(at + 1) % EXAMPLES.length].folder}/`, 'Next'],
  ].map(([address, words]) => Object.assign(document.createElement('a'), { href: address, textContent: words })),
);
text.append(heading, sentence, ways);

const code = document.createElement('pre');
code.className = 'source';
code.tabIndex = 0;
code.ariaLabel = 'Source';
document.body.append(text, code);
// A folder has one module or, where there is no build step, one page.
const [, source] = Object.entries(SOURCES).find(([path]) => path.startsWith(`../${folder}/`))!;
highlight(code, await source());
