import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { formatted } from './formatted.js';
import { PROPERTIES } from './table.js';
import { TECHNIQUES } from './techniques.js';
import { writePropertyDocs } from './writeDocs.js';
import { writeOwnedTypes, writePropertyData, writePropertyFacts, writePropertyTypes } from './writeSource.js';

const absolute = (path: string): string => fileURLToPath(new URL(`../../${path}`, import.meta.url));

const DATA = 'src/look/hatchingProperties.ts';
const FACTS = 'src/look/hatchingFacts.ts';
const TYPES = 'src/material/HatchingMaterialProperties.ts';
const OWNED = 'src/material/groups/ownedProperties.ts';

/** The generated files: paths in the repository, and texts. */
export function outputs(): Record<string, string> {
  return {
    [DATA]: formatted(DATA, writePropertyData(PROPERTIES, TECHNIQUES)),
    [FACTS]: formatted(FACTS, writePropertyFacts(PROPERTIES)),
    [TYPES]: formatted(TYPES, writePropertyTypes(PROPERTIES)),
    [OWNED]: formatted(OWNED, writeOwnedTypes(PROPERTIES)),
    'docs/material.md': writePropertyDocs(readFileSync(absolute('docs/material.md'), 'utf8'), PROPERTIES),
  };
}
