/** An example: a folder with a page and its module, or with a single page. */
export interface Example {
  folder: string;
  title: string;
  about: string;
  /** The file that the site shows beside the picture. */
  source: 'main.ts' | 'main.tsx' | 'page.html';
}

const example = (folder: string, title: string, about: string, source: Example['source'] = 'main.ts'): Example => ({
  folder,
  title,
  about,
  source,
});

/** All examples, in the order in which they are best read. */
export const EXAMPLES: readonly Example[] = [
  example('one-mesh', 'One mesh', 'A geometry is baked, gets a hatching material and lines.'),
  example('loaded-model', 'A loaded scene', 'One call hatches everything in a glTF file.'),
  example('animated-model', 'An animated model', 'Strokes stay on the skin while it moves.'),
  example('instances', 'Instances and batches', 'A wood of one tree, and stones of three kinds.'),
  example('lights-and-shadows', 'Lights and shadows', 'Two lamps, whose strokes cross where both arrive.'),
  example('terrain', 'Engraved terrain', 'Lines cut by height, which swell in the shade.'),
  example('lines-alone', 'Lines alone', 'Contours and creases on blank paper, to be coloured in.'),
  example('own-style', 'A style of your own', 'Red chalk: a preset is a plain object.'),
  example('own-map', 'A map of your own', 'Strokes that you have drawn yourself, here small curls.'),
  example('print', 'Print', 'The same drawing in pixels for the screen and for 300 dpi.'),
  example('post-processing', 'Post-processing', 'EffectComposer of three.js: a print out of register.'),
  example('postprocessing-library', 'The postprocessing package', 'Chalk on a board, with dust and a darker rim.'),
  example('import-map', 'No build step', 'A plain page with an import map.', 'page.html'),
  example('web-component', 'A web component', 'Three drawings without a line of code.', 'page.html'),
  example('react', 'React', 'Components for React Three Fiber, and a choice of presets.', 'main.tsx'),
  example('strict-csp', 'A strict policy', 'A Content-Security-Policy that forbids inlined workers.'),
];
