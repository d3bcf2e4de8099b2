import { fileURLToPath } from 'node:url';
import type { FormSource } from 'virtual:form-sources';
import { build, type Plugin, type Rolldown } from 'vite';

const NAME = 'virtual:form-sources';
const ENTRY = '\0form';

const pathOf = (file: string): string => fileURLToPath(new URL(`../../src/playground/models/${file}`, import.meta.url));

/** The functions that make models by code, and where they lie. */
const FORMS = {
  teapot: 'forms.ts',
  sphere: 'forms.ts',
  shell: 'forms.ts',
  vase: 'forms.ts',
  column: 'forms.ts',
  gears: 'forms.ts',
  landscape: 'forms.ts',
  knot: 'forms.ts',
  makeFish: 'makeFish.ts',
  makeHouse: 'makeHouse.ts',
  makeDrapery: 'makeDrapery.ts',
  makeStairs: 'makeStairs.ts',
  makeRoom: 'makeRoom.ts',
  makeStreet: 'makeStreet.ts',
  makeFox: 'makeFox.ts',
} as const;

/** Gives copied code the very functions that make the page's own models, as JavaScript: `import sources from 'virtual:form-sources'`. */
export const formSources: Plugin = {
  name: 'form-sources',
  resolveId: (id) => (id === NAME ? `\0${NAME}` : undefined),
  async load(id) {
    if (id !== `\0${NAME}`) return undefined;
    const sources: Record<string, FormSource> = {};
    for (const [form, file] of Object.entries(FORMS)) {
      this.addWatchFile(pathOf(file));
      sources[form] = sourceOf(await bundled(form, pathOf(file)));
    }
    return `export default ${JSON.stringify(sources)};`;
  },
};

/** Bundles the function with everything of ours that it calls. */
async function bundled(form: string, path: string): Promise<string> {
  const result = await build({
    configFile: false,
    logLevel: 'error',
    plugins: [
      {
        name: 'form-entry',
        resolveId: (id) => (id === ENTRY ? id : undefined),
        load: (id) => (id === ENTRY ? `export { ${form} } from ${JSON.stringify(path)};` : undefined),
      },
    ],
    build: {
      write: false,
      minify: false,
      target: 'esnext',
      modulePreload: false,
      rolldownOptions: { input: ENTRY, external: /^three($|\/)/, preserveEntrySignatures: 'strict' },
    },
  });
  return (result as Rolldown.RolldownOutput).output[0].code;
}

/** Splits a bundle into its imports and its declarations. */
function sourceOf(bundle: string): FormSource {
  const imports = [...bundle.matchAll(/^import \{ (.*) \} from "(.*)";$/gm)];
  const own = imports.filter(([, , from]) => from === 'three').flatMap(([, names]) => names.split(', '));
  return {
    imports: imports
      .filter(([, , from]) => from !== 'three')
      .map(([, names, from]) => `import { ${names} } from '${from}';`),
    classes: own,
    code: bundle
      .replace(/^(import|export) .*$/gm, '')
      .replace(/^\/\/(#region|#endregion| src\/).*$/gm, '')
      .replace(/^var /gm, 'const ')
      .replace(/^\t+/gm, (tabs) => '  '.repeat(tabs.length))
      .trim(),
  };
}
