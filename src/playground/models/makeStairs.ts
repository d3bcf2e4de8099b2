import { type BufferGeometry, ExtrudeGeometry, Path, Shape } from 'three';
import type { ModelScene } from '../../viewer/files/gltf/parseGltf.js';
import { box, type Parts as PartsOf, polygon, rectangle, sceneOf, slab, solid, together } from './solids.js';

const COLOURS = {
  wall: '#e8dfcc',
  stone: '#d6d0c2',
  step: '#efe9da',
  timber: '#4a3527',
  iron: '#26282b',
  leaf: '#5a3424',
  crate: '#b08a58',
};

type Parts = PartsOf<keyof typeof COLOURS>;

const RISE = 0.17;
const RUN = 0.28;
/** The number of risers in each of the two flights. */
const RISERS = 6;
const WIDTH = 1.1;
/** The length of a flight, the heights of landing and platform, and the length of the platform. */
const FLIGHT = (RISERS - 1) * RUN;
const LANDING = RISERS * RISE;
const PLATFORM = 2 * LANDING;
const PLATFORM_LENGTH = 1.25;
/** The overhang of a step over the next riser, and its thickness. */
const NOSING = 0.03;
const TREAD = 0.05;
/** The corner between the walls is x = z = 0; they run along −x and along z. */
const REACH = WIDTH + FLIGHT + PLATFORM_LENGTH;
const DEPTH = WIDTH + FLIGHT + 0.75;
const WALL_HEIGHT = PLATFORM + 1.8;
/** The length of the wall beyond the platform. */
const BEYOND = 0.3;
const WALL = 0.14;
const RAIL_HEIGHT = 0.82;
const LONGEST_EDGE = 0.3;

/** A staircase with a landing in the corner of two walls, up to a door. */
export function makeStairs(): ModelScene {
  return sceneOf(
    COLOURS,
    together<keyof typeof COLOURS>(walls(), window(), crates(), lowerFlight(), upperFlight(), door(), rails()),
    LONGEST_EDGE,
  );
}

/** The middle of the door along x. */
const DOOR_X = -REACH + PLATFORM_LENGTH / 2 - 0.02;
const DOOR = { x: DOOR_X, y: PLATFORM, width: 0.74, height: 1.3 };

const WINDOW = { x: -0.62, y: LANDING + 1.05, width: 0.62, height: 0.95 };

function walls(): Parts {
  const [width, middle] = [REACH + BEYOND, -(REACH + BEYOND) / 2];
  const base = 0.12;
  const outline = rectangle(new Shape(), { x: middle, y: 0, width, height: WALL_HEIGHT });
  return {
    wall: [slab(outline, [DOOR, WINDOW], WALL)],
    stone: [
      box(width + 0.2, base, DEPTH + WALL + 0.12, middle + 0.02, -base, (DEPTH - WALL) / 2),
      box(width + 0.16, 0.1, WALL + 0.12, middle, WALL_HEIGHT, -WALL / 2),
    ],
  };
}

/** A window with bars above the landing. */
function window(): Parts {
  const { x, y, width, height } = WINDOW;
  const inner = { x, y: y + 0.05, width: width - 0.1, height: height - 0.1 };
  return {
    timber: [
      slab(rectangle(new Shape(), WINDOW), [inner], 0.04).translate(0, 0, -0.05),
      box(0.04, inner.height, 0.03, x, inner.y, -0.07),
      box(inner.width, 0.03, 0.028, x, y + 0.6 * height, -0.07),
    ],
    stone: [
      box(width + 0.16, 0.06, 0.12, x, y - 0.06, 0.03),
      box(width + 0.16, 0.12, 0.06, x, y + height + 0.01, 0.02),
    ],
    iron: [box(inner.width, inner.height, 0.01, x, inner.y, -0.1)],
  };
}

/** Crates at the foot of the wall with the arch. */
function crates(): Parts {
  const crate = (side: number, x: number, y: number, z: number, turn: number): BufferGeometry[] => {
    const bar = 0.16 * side;
    const solids = [
      box(0.9 * side, side, 0.9 * side, 0, 0, 0),
      ...[-1, 1].flatMap((i) => [
        ...[-1, 1].map((k) => box(bar, side + 0.01, bar, (i * (side - bar)) / 2, 0, (k * (side - bar)) / 2)),
        ...[0, 1].map((end) => box(side - 2 * bar, bar, bar, 0, end * (side - bar), (i * (side - bar)) / 2)),
        ...[0, 1].map((end) => box(bar, bar, side - 2 * bar, (i * (side - bar)) / 2, end * (side - bar), 0)),
      ]),
    ];
    return solids.map((geometry) => geometry.rotateY(turn).translate(x, y, z));
  };
  return { crate: [...crate(0.5, -2.15, 0, WIDTH + 0.62, 0.3), ...crate(0.36, -2.72, 0, WIDTH + 0.95, -0.25)] };
}

/** Steps towards −z, up to the landing in the corner. */
function lowerFlight(): Parts {
  const solids = [box(WIDTH, LANDING - TREAD, WIDTH, -WIDTH / 2, 0, WIDTH / 2)];
  const steps = [box(WIDTH + NOSING, TREAD, WIDTH + NOSING, -WIDTH / 2, LANDING - TREAD, (WIDTH + NOSING) / 2)];
  for (let i = 1; i < RISERS; i++) {
    const z = WIDTH + FLIGHT - (i - 0.5) * RUN;
    solids.push(box(WIDTH, i * RISE - TREAD, RUN, -WIDTH / 2, 0, z));
    steps.push(box(WIDTH + 2 * NOSING, TREAD, RUN + NOSING, -WIDTH / 2, i * RISE - TREAD, z + NOSING / 2));
  }
  return { stone: solids, step: steps };
}

/** Steps towards −x from the landing to the platform, on a wall with an arch below the platform. */
function upperFlight(): Parts {
  const outline: [number, number][] = [[-REACH, 0]];
  const steps: BufferGeometry[] = [];
  const foot = -WIDTH;
  outline.push([foot, 0], [foot, LANDING + RISE - TREAD]);
  for (let i = 1; i < RISERS; i++) {
    const x = foot - i * RUN;
    outline.push([x, LANDING + i * RISE - TREAD], [x, LANDING + (i + 1) * RISE - TREAD]);
    steps.push(
      box(
        RUN + NOSING,
        TREAD,
        WIDTH + NOSING,
        x + (RUN + NOSING) / 2,
        LANDING + i * RISE - TREAD,
        (WIDTH + NOSING) / 2,
      ),
    );
  }
  outline.push([-REACH, PLATFORM - TREAD]);
  steps.push(
    box(
      PLATFORM_LENGTH + 2 * NOSING,
      TREAD,
      WIDTH + NOSING,
      -REACH + PLATFORM_LENGTH / 2,
      PLATFORM - TREAD,
      (WIDTH + NOSING) / 2,
    ),
  );
  const shape = polygon(outline);
  shape.holes.push(arch());
  return {
    stone: [solid(new ExtrudeGeometry(shape, { depth: WIDTH, bevelEnabled: false }))],
    step: steps,
  };
}

/** The opening below the platform, topped with flat stones. */
function arch(): Path {
  const [middle, half, spring] = [-REACH + 0.78, 0.5, 0.85];
  const path = new Path().moveTo(middle - half, 0.02).lineTo(middle + half, 0.02);
  for (let i = 0; i <= 8; i++) {
    const angle = (i / 8) * Math.PI;
    path.lineTo(middle + half * Math.cos(angle), spring + half * Math.sin(angle));
  }
  path.closePath();
  return path;
}

/** A boarded door in a frame, with a lintel. */
function door(): Parts {
  const { x, y, width, height } = DOOR;
  const boards = [-1, 0, 1].map((place) => box(0.2, height - 0.07, 0.04, x + 0.21 * place, y + 0.02, -0.1));
  return {
    timber: [
      ...[-1, 1].map((side) => box(0.06, height - 0.06, 0.1, x + side * (width / 2 - 0.03), y, -0.05)),
      box(width, 0.06, 0.1, x, y + height - 0.06, -0.05),
      box(width + 0.3, 0.14, 0.12, x, y + height + 0.01, 0.03),
    ],
    leaf: boards,
    iron: [box(0.05, 0.05, 0.06, x + 0.22, y + 0.62, -0.06)],
  };
}

/** Rails on both open sides: newels, balusters, and a bar along each slope. */
function rails(): Parts {
  const inset = 0.07;
  const lower = run(
    [-WIDTH + inset, WIDTH + FLIGHT - 0.5 * RUN],
    [-WIDTH + inset, WIDTH - inset + 0.02],
    RISE,
    LANDING,
  );
  const upper = run(
    [-WIDTH - 0.5 * RUN, WIDTH - inset],
    [-WIDTH - FLIGHT - 0.14, WIDTH - inset],
    LANDING + RISE,
    PLATFORM,
  );
  const level = run([-WIDTH - FLIGHT - 0.14, WIDTH - inset], [-REACH + inset, WIDTH - inset], PLATFORM, PLATFORM);
  const end = run([-REACH + inset, WIDTH - inset], [-REACH + inset, 0.1], PLATFORM, PLATFORM);
  return together<keyof typeof COLOURS>(lower, upper, level, end);
}

type Place = readonly [x: number, z: number];

/** A rail between two newels. @param from, to their places @param low, high heights of their feet */
function run(from: Place, to: Place, low: number, high: number): Parts {
  const along = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(...along);
  const newels = [
    [from, low],
    [to, high],
  ] as const;
  const count = Math.round(length / 0.16);
  const bars = Array.from({ length: count - 1 }, (_, i) => {
    const t = (i + 1) / count;
    const foot = low + t * (high - low) - (high > low ? 0.1 : 0);
    const tall = RAIL_HEIGHT - 0.06 + (high > low ? 0.1 : 0);
    return box(0.024, tall, 0.024, from[0] + t * along[0], foot, from[1] + t * along[1]);
  });
  const slope = Math.hypot(length, high - low);
  const rail = box(slope, 0.05, 0.08, 0, 0, 0)
    .rotateZ(Math.atan2(high - low, length))
    .rotateY(Math.atan2(-along[1], along[0]))
    .translate(from[0] + along[0] / 2, (low + high) / 2 + RAIL_HEIGHT - 0.07, from[1] + along[1] / 2);
  return {
    timber: [
      rail,
      ...newels.flatMap(([[x, z], foot]) => [
        box(0.11, RAIL_HEIGHT + 0.06, 0.11, x, foot, z),
        box(0.15, 0.04, 0.15, x, foot + RAIL_HEIGHT + 0.06, z),
      ]),
    ],
    iron: bars,
  };
}
