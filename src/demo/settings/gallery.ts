/** A finished drawing of the gallery. Its picture lies in `public/gallery`, by its name. */
export interface GalleryDrawing {
  name: string;
  title: string;
  /** Who made the model, if it was not made by the code of this page. */
  credit?: string;
  /** What opens it: a link without its address. */
  link: string;
}

const STANFORD = 'Stanford Computer Graphics Laboratory';
const SHADOWS = 'shadows=on&ground=shadow&occlusion=100';
const drawing = (name: string, title: string, preset: string, rest: string, credit?: string): GalleryDrawing => ({
  name,
  title,
  link: `preset=${preset}&${rest}`,
  ...(credit && { credit }),
});

export const GALLERY: readonly GalleryDrawing[] = [
  drawing('dragon', 'Dragon', 'engraving', `model=dragon3&${SHADOWS}&shadowStrokes=cross`, STANFORD),
  drawing(
    'bust',
    'Bust',
    'banknote',
    'model=bust&occlusion=100&shadows=on&lightAzimuth=-62&lightElevation=34',
    'stackgl',
  ),
  drawing('hand', 'Hand', 'woodcut', 'model=hand&lightAzimuth=-60&lightElevation=30&shadows=on', 'Amazon'),
  drawing('shell', 'Shell', 'stipple', `model=shell&${SHADOWS}&boldness=90`),
  drawing('vase', 'Vase', 'crossHatching', `model=vase&${SHADOWS}`),
  drawing(
    'column',
    'Column',
    'engraving',
    `model=column&${SHADOWS}&lightAzimuth=-40&lightElevation=42&shadowStrokes=cross&lineField=y`,
  ),
  drawing('gears', 'Gears', 'technical', 'model=gears&shadows=on&occlusion=100'),
  drawing(
    'landscape',
    'Landscape',
    'pen',
    'model=landscape&shadows=on&lightAzimuth=-70&lightElevation=28&occlusion=100',
  ),
  drawing('knot', 'Knot', 'engraving', 'model=knot&shadows=on&shadowStrokes=cross&ink=%237a2e1d&paper=%23f4ead6'),
  drawing('bunny', 'Rabbit', 'pencil', 'model=bunny&shadows=on&occlusion=100', STANFORD),
  drawing('suzanne', 'Suzanne', 'charcoal', `model=suzanne&shadows=on&occlusion=100`, 'Blender Foundation'),
  drawing('teapot', 'Teapot', 'crossHatching', `model=teapot&${SHADOWS}&ink=%231d3a5f&paper=%23eef1ee`),
];
