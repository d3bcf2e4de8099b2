/** A worker and all that it imports, as the text of one module: see tools/building/bundledWorker.ts. */
declare module '*?bundled' {
  const text: string;
  export default text;
}
