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
    const name = `${path.replace(/^docs\//, '').replace('.md', '')}-${i + 1}`;
    if (fence !== 'html') return [{ name, kind: fence as 'ts' | 'tsx', code: completed(sample) }];
    return sample.includes('<hatched-model') ? [{ name, kind: 'html', code: sample }] : [];
  }),
);
