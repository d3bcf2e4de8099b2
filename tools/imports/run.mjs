/** The second part of `npm run lint`: prints every import that the table of rooms forbids, and ends with 1 if there is any. */
import { forbiddenImports } from './forbiddenImports.mjs';

const found = forbiddenImports();
for (const sentence of found) console.error(sentence);
process.exitCode = found.length > 0 ? 1 : 0;
