import { choiceOf, inGroup } from './rows.js';

/** What the view shows. */
export const VIEW_SETTINGS = inGroup('View', 'subject', {
  upAxis: {
    kind: 'choice',
    label: 'Upright',
    default: 'y',
    choices: { y: 'Y up', z: 'Z up', x: 'X up', '-y': 'Y down', '-z': 'Z down', '-x': 'X down' },
  },
  debugView: choiceOf('debugView', {
    label: 'Show',
    owner: 'check',
    choices: { none: 'The drawing', blendFactors: 'Blend factors', tone: 'Tone', frames: 'Frames' },
  }),
});

/** Labels of paper sizes. */
const PAPER = {
  ...{ a6: 'A6 sheet', a5: 'A5 sheet', a4: 'A4 sheet', a3: 'A3 sheet', a2: 'A2 sheet', a1: 'A1 sheet', a0: 'A0 sheet' },
  ...{ letter: 'Letter sheet', legal: 'Legal sheet', tabloid: 'Tabloid sheet' },
} as const;
const PAPER_SIZES = Object.keys(PAPER);
const OWN_SHEET = { pictureSize: ['own'] };
const OWN_INCHES = { pictureSize: ['inches'] };
const SHEETS = [...PAPER_SIZES, 'own', 'inches'];
const MILLIMETRES = {
  kind: 'number',
  when: OWN_SHEET,
  default: 200,
  unit: 'mm',
  min: 20,
  max: 1200,
  step: 0.1,
} as const;
const INCHES = { kind: 'number', when: OWN_INCHES, default: 8, unit: 'in', min: 1, max: 48, step: 0.05 } as const;

const PLOTTED = { pictureSvg: ['pen'] };
const OWN_PENS = { ...PLOTTED, picturePens: ['two', 'three'] };
const THIRD_PEN = { ...PLOTTED, picturePens: ['three'] };
const PEN_WIDTH = { kind: 'number', default: 0.3, unit: 'mm', min: 0.1, max: 2, step: 0.05 } as const;

/** The saved picture. */
export const PICTURE_SETTINGS = inGroup('Picture', 'output', {
  pictureSize: {
    kind: 'choice',
    label: 'Size',
    default: '1',
    choices: {
      1: 'As on the page',
      2: 'Twice the page',
      4: 'Four times the page',
      ...PAPER,
      own: 'A sheet of your own',
      inches: 'A sheet of your own, in inches',
    },
  },
  pictureWidth: { ...MILLIMETRES, label: 'Sheet width' },
  pictureHeight: { ...MILLIMETRES, label: 'Sheet height' },
  pictureWidthInches: { ...INCHES, label: 'Sheet width' },
  pictureHeightInches: { ...INCHES, label: 'Sheet height' },
  pictureTurn: {
    kind: 'choice',
    label: 'Turned',
    when: { pictureSize: PAPER_SIZES },
    default: 'suited',
    choices: { suited: 'As suits the model', portrait: 'Portrait', landscape: 'Landscape' },
  },
  pictureDpi: {
    kind: 'choice',
    label: 'Fineness',
    when: { pictureSize: SHEETS },
    default: '300',
    choices: { 150: '150 dpi', 300: '300 dpi', 600: '600 dpi', 1200: '1,200 dpi' },
  },
  pictureCrop: {
    kind: 'choice',
    label: 'Cut to',
    default: 'sheet',
    choices: { sheet: 'The sheet', drawing: 'The drawing' },
  },
  pictureLayers: {
    kind: 'choice',
    label: 'Layers',
    default: 'one',
    choices: { one: 'One picture', apart: 'Apart, in a ZIP' },
  },
  pictureGround: {
    kind: 'choice',
    label: 'Ground',
    when: { pictureLayers: ['one'] },
    default: 'paper',
    choices: { paper: 'Paper', transparent: 'Transparent', strokes: 'Transparent, strokes alone' },
  },
  pictureSvg: {
    kind: 'choice',
    label: 'SVG',
    default: 'print',
    choices: { print: 'Filled, for print', pen: 'Lines, for a pen plotter' },
  },
  picturePens: {
    kind: 'choice',
    label: 'Pens',
    when: PLOTTED,
    default: 'layer',
    choices: {
      layer: 'One for each kind of line',
      ink: 'One for each ink',
      material: 'One for each material',
      part: 'One for each part',
      two: 'Two of your own',
      three: 'Three of your own',
    },
  },
  picturePenA: { kind: 'color', label: 'First pen', when: OWN_PENS, default: '#1c1a17' },
  picturePenWidthA: { ...PEN_WIDTH, label: 'Its width', when: OWN_PENS },
  picturePenB: { kind: 'color', label: 'Second pen', when: OWN_PENS, default: '#c0282c' },
  picturePenWidthB: { ...PEN_WIDTH, label: 'Its width', when: OWN_PENS },
  picturePenC: { kind: 'color', label: 'Third pen', when: THIRD_PEN, default: '#2a5ca8' },
  picturePenWidthC: { ...PEN_WIDTH, label: 'Its width', when: THIRD_PEN },
  picturePen: {
    ...PEN_WIDTH,
    label: 'Width of pens',
    when: { ...PLOTTED, picturePens: ['layer', 'ink', 'material', 'part'] },
  },
  pictureNote: {
    kind: 'choice',
    label: 'Note',
    when: PLOTTED,
    default: 'none',
    choices: { none: 'None', pens: 'Pens and times, in the margin' },
  },
  pictureMargin: {
    kind: 'number',
    label: 'SVG margin',
    when: { pictureSize: SHEETS, pictureCrop: ['sheet'] },
    default: 10,
    unit: 'mm',
    min: 0,
    max: 100,
    step: 1,
  },
});

/** The saved video. */
export const VIDEO_SETTINGS = inGroup('Video', 'output', {
  videoMotion: {
    kind: 'choice',
    label: 'Motion',
    default: 'turn',
    choices: {
      turn: 'The model turns',
      sweep: 'The light goes around',
      swing: 'The light swings',
      clip: 'The model’s own',
    },
  },
  videoSize: {
    kind: 'choice',
    label: 'Frame',
    default: '1920x1080',
    choices: {
      page: 'As on the page',
      '1280x720': '1,280 × 720 px',
      '1920x1080': '1,920 × 1,080 px',
      '3840x2160': '3,840 × 2,160 px',
      '1080x1080': '1,080 × 1,080 px',
      '1080x1920': '1,080 × 1,920 px',
    },
  },
  videoSeconds: { kind: 'number', label: 'Length', default: 6, unit: 's', min: 1, max: 30, step: 1 },
  videoRate: {
    kind: 'choice',
    label: 'Frames',
    default: '30',
    choices: { 12: '12 a second', 24: '24 a second', 30: '30 a second', 60: '60 a second' },
  },
  videoForm: {
    kind: 'choice',
    label: 'Saved as',
    default: 'video',
    choices: { video: 'A video', frames: 'Pictures, in a ZIP' },
  },
});
