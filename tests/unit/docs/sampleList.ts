import { readFileSync } from 'node:fs';
import * as three from 'three';
import { DOCUMENTS, root } from './documents.js';

/** A piece of code in README or guides. */
export interface Sample {
  /** The document, and the how many-eth of its samples it is. */
  name: string;
  kind: 'ts' | 'tsx' | 'html';
  /** The module that it is part of, or the elements. */
  code: string;
}

/** The name of a document in those of its samples, which are files. */
const nameOf = (path: string): string =>
  path
    .replace(/^docs\//, '')
    .replaceAll('/', '-')
    .replace('.md', '');

const WORD = /\b[A-Za-z]\w*\b/g;
/** What the library exports, types included. */
const EXPORTED = [...readFileSync(`${root}src/index.ts`, 'utf8').matchAll(/^export (?:type )?\{([^}]*)\}/gm)].flatMap(
  ([, names]) => names.replace(/\btype\b/g, '').match(WORD) ?? [],
);

/** A sample with imports of what it uses and does not import, as readers add them. */
function completed(sample: string): string {
  const code = sample.replace(/\/\/.*|'[^'\n]*'/g, '');
  const imported = new Set(
    [...sample.matchAll(/^import\s+(?:type\s+)?\{([^}]*)\}/gm)].flatMap(([, names]) => names.match(WORD) ?? []),
  );
  const declared = new Set(
    [...code.matchAll(/\b(?:const|let|class|interface|function)\s+(\w+)/g)].map(([, name]) => name),
  );
  const used = new Set(code.match(WORD));
  const lacking = (names: string[]) =>
    names.filter((name) => used.has(name) && !imported.has(name) && !declared.has(name));
  const classes = Object.keys(three).filter((name) => /^[A-Z][a-z]/.test(name));
  return [
    `import { ${lacking(classes).join(', ')} } from 'three';`,
    `import { ${lacking(EXPORTED).join(', ')} } from 'three-hatching';`,
    `import { ${lacking(['GLTFLoader']).join(', ')} } from 'three/addons/loaders/GLTFLoader.js';`,
    `import { ${lacking(['useMemo']).join(', ')} } from 'react';`,
    `import { ${lacking(['Canvas']).join(', ')} } from '@react-three/fiber';`,
    `import { ${lacking(['Hatched']).join(', ')} } from 'three-hatching/react';`,
    // Elements alone, without a component around them.
    sample.startsWith('<') ? `export const elements = <>${sample}</>;` : sample,
    'export {};',
  ].join('\n');
}

/** Every sample in TypeScript, and of HTML the elements that draw. */
export const SAMPLES: readonly Sample[] = Object.entries(DOCUMENTS).flatMap(([path, text]) =>
  [...text.matchAll(/^```(tsx?|html)\n([\s\S]*?)^```/gm)].flatMap(([, fence, sample], i): Sample[] => {
    const name = `${nameOf(path)}-${i + 1}`;
    if (fence !== 'html') return [{ name, kind: fence as 'ts' | 'tsx', code: completed(sample) }];
    return sample.includes('<hatched-model') ? [{ name, kind: 'html', code: sample }] : [];
  }),
);

/** Every sample that runs in Node as it stands: it imports a module of Node. */
export const NODE_SAMPLES: readonly { name: string; code: string }[] = Object.entries(DOCUMENTS).flatMap(
  ([path, text]) =>
    [...text.matchAll(/^```js\n([\s\S]*?)^```/gm)]
      .filter(([, code]) => code.includes("from 'node:"))
      .map(([, code], i) => ({ name: `${nameOf(path)}-node-${i + 1}`, code })),
);

/** A call of the command in a guide: its arguments, what is piped into it and what its output is written to. */
export interface SampleCall {
  line: string;
  args: readonly string[];
  input: string | undefined;
  output: string | undefined;
}

/** Every call of the command in README and guides. */
export const SAMPLE_CALLS: readonly SampleCall[] = Object.values(DOCUMENTS).flatMap((text) =>
  [...text.matchAll(/^```sh\n([\s\S]*?)^```/gm)]
    .flatMap(([, lines]) => lines.split('\n'))
    .filter((line) => line.includes('npx three-hatching'))
    .map((line): SampleCall => {
      const words = [...line.matchAll(/"([^"]*)"|(\S+)/g)].map(([, quoted, word]) => quoted ?? word);
      const comment = words.indexOf('#');
      const call = words.slice(words.indexOf('three-hatching') + 1, comment < 0 ? undefined : comment);
      const redirect = call.indexOf('>');
      return {
        line,
        args: redirect < 0 ? call : call.slice(0, redirect),
        input: words[0] === 'cat' ? words[1] : undefined,
        output: redirect < 0 ? undefined : call[redirect + 1],
      };
    }),
);
