/**
 * `node tools/building/stippleSet.mjs`: finds the set of points that stipple has its dots on, and prints it as src/material/tam/stippleMap.ts holds it.
 *
 * One point per cell of a square grid that repeats. That of cell c is that of cell 2c + b, half as large, in quarter b of c: so the
 * set at half its size holds the set. Quarters are chosen one by one, over and over, so that points keep away from one another, with
 * ever less left to chance (simulated annealing). Then the three other points in each cell at half the size are put in the order of
 * their birth, so that points stay even meanwhile.
 */
import { fileURLToPath } from 'node:url';
import { createServer } from 'vite';

const root = fileURLToPath(new URL('../..', import.meta.url));
const server = await createServer({
  root,
  logLevel: 'error',
  server: { middlewareMode: true, ws: false, watch: null },
});
const { STIPPLE_PERIOD: PERIOD } = await server.ssrLoadModule('/src/material/tam/patternSizes.ts');
const { bayerRank, pointsOf } = await server.ssrLoadModule('/src/material/tam/stippleMap.ts');
await server.close();

const SWEEPS = 400;
const cells = PERIOD ** 2;
const at = (x, y) => ((y + 4 * PERIOD) % PERIOD) * PERIOD + ((x + 4 * PERIOD) % PERIOD);

let state = 1;
function random() {
  state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
  return (((state >>> 8) ^ (state >>> 24)) & 0xffffff) / 2 ** 24;
}

const quarters = Uint8Array.from({ length: cells }, () => Math.floor(4 * random()));
let points = pointsOf(quarters);

/** The crowding of a point at (px, py), in units of cells, in cell (x, y). */
function crowding(x, y, px, py) {
  let sum = 0;
  for (let dy = -2; dy <= 2; dy++) {
    for (let dx = -2; dx <= 2; dx++) {
      if (dx === 0 && dy === 0) continue;
      const other = at(x + dx, y + dy);
      sum += Math.exp(-4.5 * ((dx + points[2 * other] - px) ** 2 + (dy + points[2 * other + 1] - py) ** 2));
    }
  }
  return sum;
}

for (let sweep = 0; sweep < SWEEPS; sweep++) {
  const chance = 0.05 * (1 - sweep / SWEEPS) ** 2;
  for (let step = 0; step < cells; step++) {
    const cell = Math.floor(cells * random());
    const [x, y] = [cell % PERIOD, Math.floor(cell / PERIOD)];
    let least = Infinity;
    for (let b = 0; b < 4; b++) {
      const child = at(2 * x + (b & 1), 2 * y + (b >> 1));
      const point = [((b & 1) + points[2 * child]) / 2, ((b >> 1) + points[2 * child + 1]) / 2];
      const found = crowding(x, y, ...point) - chance * Math.log(random() + 1e-9);
      if (found >= least) continue;
      least = found;
      quarters[cell] = b;
      [points[2 * cell], points[2 * cell + 1]] = point;
    }
  }
  points = pointsOf(quarters);
}

// Births, on the grid of half the size.
const side = 2 * PERIOD;
const alive = new Uint8Array(side * side);
const placed = (x, y) => ((y + side) % side) * side + ((x + side) % side);
for (let cell = 0; cell < cells; cell++) {
  const b = quarters[cell];
  alive[placed(2 * (cell % PERIOD) + (b & 1), 2 * Math.floor(cell / PERIOD) + (b >> 1))] = 1;
}
const order = [...Array(cells).keys()].sort((a, b) => bayerRank(a) - bayerRank(b));
const births = Array.from({ length: cells }, () => []);
for (const sharpness of [2.5, 2.5, 3]) {
  for (const cell of order) {
    const [x, y] = [2 * (cell % PERIOD), 2 * Math.floor(cell / PERIOD)];
    let least = Infinity;
    let chosen = 0;
    for (let b = 0; b < 4; b++) {
      const [cx, cy] = [x + (b & 1), y + (b >> 1)];
      const sum = alive[placed(cx, cy)] ? Infinity : crowdingAmongAlive(cx, cy, sharpness);
      if (sum >= least) continue;
      least = sum;
      chosen = b;
    }
    births[cell].push(chosen);
    alive[placed(x + (chosen & 1), y + (chosen >> 1))] = 1;
  }
}

/** The crowding of the point of a cell of half the size, among the points that have appeared. */
function crowdingAmongAlive(cx, cy, sharpness) {
  const own = 2 * at(cx, cy);
  let sum = 0;
  for (let dy = -4; dy <= 4; dy++) {
    for (let dx = -4; dx <= 4; dx++) {
      if (!alive[placed(cx + dx, cy + dy)]) continue;
      const other = 2 * at(cx + dx, cy + dy);
      const away = (dx + points[other] - points[own]) ** 2 + (dy + points[other + 1] - points[own + 1]) ** 2;
      sum += Math.exp(-sharpness * away);
    }
  }
  return sum;
}

// A letter per cell: the quarter with its own point, and in which order the other three follow.
const ORDERS = ['012', '021', '102', '120', '201', '210'];
let text = '';
for (let cell = 0; cell < cells; cell++) {
  const others = [0, 1, 2, 3].filter((b) => b !== quarters[cell]);
  const code = births[cell].map((b) => others.indexOf(b)).join('');
  text += String.fromCharCode(65 + 6 * quarters[cell] + ORDERS.indexOf(code));
}
console.log(text);
