import { type BufferGeometry, ExtrudeGeometry, Shape } from 'three';
import type { ModelScene } from '../../viewer/files/gltf/parseGltf.js';
import {
  box,
  moved,
  type Opening,
  type Parts as PartsOf,
  rectangle,
  sceneOf,
  slab,
  solid,
  together,
} from './solids.js';

const COLOURS = {
  plaster: '#e9dfc9',
  stone: '#9a958c',
  roof: '#6d3527',
  brick: '#a4573f',
  timber: '#4a3527',
  frame: '#f6f3ea',
  glass: '#1f2b33',
  shutter: '#3d6650',
  door: '#5d2f22',
};

type Parts = PartsOf<keyof typeof COLOURS>;

/** The length of the house along x, its depth along z, and its heights. */
const LENGTH = 2.3;
const DEPTH = 1.5;
const EAVES = 1.3;
const RIDGE = 2.1;
const WALL = 0.1;
/** The maximum edge length, so that the occlusion under the eaves has vertices to be stored at. */
const LONGEST_EDGE = 0.25;

const sash = (x: number, y: number): Opening => ({ x, y, width: 0.3, height: 0.5 });
const DOORWAY: Opening = { x: -0.05, y: 0, width: 0.36, height: 0.86 };
const SHUTTER = 0.15;

/** A half-timbered cottage with a tiled roof, windows with shutters and a door. Each part has its own colour. */
export function makeHouse(): ModelScene {
  const front = frontWall();
  const back = backWall();
  const gable = gableWall();
  const parts: Parts[] = [
    placed(front, 0, DEPTH / 2),
    placed(back, Math.PI, DEPTH / 2),
    placed(gable, Math.PI / 2, LENGTH / 2),
    placed(gable, -Math.PI / 2, LENGTH / 2),
    corners(),
    roof(),
    chimney(),
    { stone: [box(LENGTH + 0.14, 0.16, DEPTH + 0.14, 0, -0.16, 0)] },
  ];
  return sceneOf(COLOURS, together(...parts), LONGEST_EDGE);
}

/** Turns a wall's parts, whose outer face is z = 0, about the up axis and moves them outwards. */
const placed = (parts: Parts, turn: number, out: number): Parts =>
  moved(parts, (geometry) => geometry.translate(0, 0, out).rotateY(turn));

const oblong = (width: number): Shape => rectangle(new Shape(), { x: 0, y: 0, width, height: EAVES });

function frontWall(): Parts {
  const windows = [sash(-0.78, 0.38), sash(0.42, 0.38), sash(0.86, 0.38)];
  return together(
    { plaster: [slab(oblong(LENGTH), [...windows, DOORWAY], WALL)] },
    doorOf(DOORWAY),
    ...windows.map(windowOf),
  );
}

function backWall(): Parts {
  const windows = [sash(-0.6, 0.38), sash(0.5, 0.38)];
  return together({ plaster: [slab(oblong(LENGTH), windows, WALL)] }, ...windows.map(windowOf));
}

/** A gable between the long walls, just below the roof. */
function gableWall(): Parts {
  const half = DEPTH / 2 - WALL;
  const shoulder = EAVES + ((RIDGE - EAVES) * WALL) / (DEPTH / 2);
  const outline = new Shape();
  outline.moveTo(-half, 0).lineTo(half, 0).lineTo(half, shoulder).lineTo(0, RIDGE).lineTo(-half, shoulder).closePath();
  const windows = [sash(0, 0.38), { x: 0, y: 1.42, width: 0.24, height: 0.26 }];
  const tie = box(2 * half, 0.09, 0.05, 0, EAVES - 0.06, 0.005);
  return together({ plaster: [slab(outline, windows, WALL)], timber: [tie] }, ...windows.map(windowOf));
}

/** A window: a frame with bars, the glass behind it, a sill, and shutters if it is large. */
function windowOf(opening: Opening): Parts {
  const { x, y, width, height } = opening;
  const inner = { x, y: y + 0.03, width: width - 0.06, height: height - 0.06 };
  const frame = slab(rectangle(new Shape(), opening), [inner], 0.03).translate(0, 0, -0.03);
  const bars = [
    box(0.02, inner.height, 0.018, x, inner.y, -0.045),
    box(inner.width, 0.02, 0.017, x, y + 0.58 * height, -0.045),
  ];
  const shutters =
    height < 0.3 ? [] : [-1, 1].flatMap((side) => shutterOf(x + (side * (width + SHUTTER)) / 2, opening));
  return {
    frame: [frame, ...bars, box(width + 0.08, 0.035, 0.09, x, y - 0.035, 0.02)],
    glass: [box(inner.width, inner.height, 0.01, x, inner.y, -0.07)],
    shutter: shutters,
  };
}

/** A shutter with three boards across it. */
function shutterOf(x: number, { y, height }: Opening): BufferGeometry[] {
  const boards = [0.1, 0.46, 0.82].map((place) => box(SHUTTER - 0.03, 0.035, 0.02, x, y + place * height, 0.037));
  return [box(SHUTTER - 0.012, height, 0.026, x, y, 0.014), ...boards];
}

/** A framed door with two panels, a canopy and two steps. */
function doorOf({ x, y, width, height }: Opening): Parts {
  const leaf = width - 0.08;
  const panels = [0.08, 0.46].map((place) => box(0.66 * leaf, 0.3, 0.02, x, y + place, -0.045));
  return {
    frame: [-1, 1].map((side) => box(0.04, height, 0.05, x + (side * (width - 0.04)) / 2, y, -0.03)),
    door: [box(leaf, height, 0.03, x, y, -0.065), ...panels],
    timber: [
      box(width + 0.16, 0.05, 0.3, x, y + height + 0.04, 0.14),
      ...[-1, 1].map((side) => box(0.035, 0.12, 0.1, x + (side * width) / 2, y + height - 0.08, 0.05)),
    ],
    stone: [box(0.56, 0.08, 0.22, x, -0.08, 0.18), box(0.7, 0.08, 0.38, x, -0.16, 0.26)],
  };
}

/** Posts that stand out a little from the corners of the walls. */
function corners(): Parts {
  const posts = [-1, 1].flatMap((i) =>
    [-1, 1].map((k) => box(0.13, EAVES, 0.13, (i * (LENGTH - 0.09)) / 2, 0, (k * (DEPTH - 0.09)) / 2)),
  );
  return { timber: posts };
}

/** Two slopes of tiles in courses, each ending in an edge above the next. */
function roof(): Parts {
  const courses = 9;
  const pitch = Math.atan2(RIDGE - EAVES, DEPTH / 2);
  const run = Math.hypot(RIDGE - EAVES, DEPTH / 2) + 0.17;
  const step = run / courses;
  // Seen from the gable, with x down the slope and y up from it.
  const profile = new Shape().moveTo(0, 0).lineTo(0, 0.02);
  for (let i = 1; i <= courses; i++) profile.lineTo(i * step, 0.05).lineTo(i * step, i < courses ? 0.02 : 0);
  profile.closePath();
  const length = LENGTH + 0.34;
  const slope = solid(new ExtrudeGeometry(profile, { depth: length, bevelEnabled: false }))
    .translate(0, 0, -length / 2)
    .rotateZ(-pitch)
    .translate(0, RIDGE, 0);
  const sides = [-Math.PI / 2, Math.PI / 2].map((turn) => slope.clone().rotateY(turn));
  return { roof: [...sides, box(length + 0.02, 0.08, 0.12, 0, RIDGE + 0.01, 0)] };
}

function chimney(): Parts {
  const [x, z] = [0.66, -0.24];
  return {
    brick: [box(0.3, 0.85, 0.26, x, 1.65, z), box(0.14, 0.14, 0.14, x, 2.58, z)],
    stone: [box(0.38, 0.08, 0.34, x, 2.5, z)],
  };
}
