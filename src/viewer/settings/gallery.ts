/** A drawing of the gallery. Its picture is stored in `public/gallery` under its name. */
export interface GalleryDrawing {
  name: string;
  title: string;
  /** Credit of the model's author, for models that this page's code did not make. */
  credit?: string;
  /** The hash of the link that opens it. */
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
  drawing(
    'dragon',
    'Dragon',
    'engraving',
    `model=dragon3&${SHADOWS}&lightAzimuth=-60&lightElevation=68&shadowStrokes=cross`,
    STANFORD,
  ),
  drawing(
    'bust',
    'Bust',
    'banknote',
    'model=bust&occlusion=100&shadows=on&lightAzimuth=-36&lightElevation=44',
    'stackgl',
  ),
  drawing('hand', 'Hand', 'woodcut', 'model=hand&lightAzimuth=-66&lightElevation=47&shadows=on', 'Amazon'),
  drawing('shell', 'Shell', 'stipple', `model=shell&${SHADOWS}&lightAzimuth=-15&lightElevation=65&boldness=90`),
  drawing('vase', 'Vase', 'crossHatching', `model=vase&${SHADOWS}&lightAzimuth=-22&lightElevation=68`),
  drawing(
    'column',
    'Column',
    'engraving',
    `model=column&${SHADOWS}&lightAzimuth=-5&lightElevation=71&shadowStrokes=cross&direction=y`,
  ),
  drawing('gears', 'Gears', 'technical', 'model=gears&shadows=on&occlusion=100&lightAzimuth=8&lightElevation=68'),
  drawing(
    'landscape',
    'Landscape',
    'pen',
    'model=landscape&shadows=on&lightAzimuth=106&lightElevation=35&occlusion=100',
  ),
  drawing(
    'knot',
    'Knot',
    'engraving',
    'model=knot&shadows=on&lightAzimuth=-40&lightElevation=56&shadowStrokes=cross&ink=%237a2e1d&paper=%23f4ead6',
  ),
  drawing(
    'bunny',
    'Rabbit',
    'pencil',
    'model=bunny&shadows=on&occlusion=100&lightAzimuth=-63&lightElevation=53',
    STANFORD,
  ),
  drawing(
    'suzanne',
    'Suzanne',
    'charcoal',
    'model=suzanne&shadows=on&occlusion=100&lightAzimuth=-10&lightElevation=71',
    'Blender Foundation',
  ),
  drawing(
    'teapot',
    'Teapot',
    'crossHatching',
    `model=teapot&${SHADOWS}&lightAzimuth=-43&lightElevation=62&ink=%231d3a5f&paper=%23eef1ee`,
  ),
  drawing('stairs', 'Staircase', 'pen', 'model=stairs&shadows=on&occlusion=40&lightAzimuth=-40&lightElevation=45'),
  drawing('room', 'Room', 'crossHatching', 'model=room&lightAzimuth=-30&lightElevation=34'),
  drawing('fox', 'Fox', 'woodcut', 'model=fox&shadows=on&lightAzimuth=72&lightElevation=50'),
  drawing('street', 'Street', 'engraving', 'model=street&shadows=on&lightAzimuth=-35&lightElevation=45'),
];
