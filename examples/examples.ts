/** What example.json in the folder of an example says of it. */
interface ExampleFile {
  title: string;
  about: string;
  /** Where it stands among the others: they are shown in the order in which they are best read. */
  order: number;
}

/** An example: a folder with a page and its module, or with a single page. */
export interface Example extends ExampleFile {
  folder: string;
}

const files = import.meta.glob<ExampleFile>('./*/example.json', { eager: true, import: 'default' });

/** All examples, by what their folders hold. What runs outside of Vite reads the same with `readExamples.mjs`. */
export const EXAMPLES: readonly Example[] = Object.entries(files)
  .map(([path, file]) => ({ ...file, folder: path.split('/')[1] }))
  .sort((a, b) => a.order - b.order);
