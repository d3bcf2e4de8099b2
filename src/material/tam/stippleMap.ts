import { DataTexture, NearestFilter, RepeatWrapping } from 'three';
import { STIPPLE_MAP_SIZE, STIPPLE_PERIOD } from './patternSizes.js';

/**
 * A self-similar set of points in the plane: scaled to half its size, it contains itself. So new points may appear between the old
 * ones without end as the camera approaches, and no point ever moves. It was found by tools/building/stippleSet.mjs.
 *
 * Each cell c = (x, y) has one point, which is the point of cell 2c + b of the set at half the size. b is the quarter of the cell
 * that it lies in: 0 and 1 are the lower quarters, 2 and 3 the upper ones. The string has a letter per cell, in rows. A letter holds
 * b, and the order in which the points of the three other quarters appear.
 */
const STIPPLE_SET =
  'WXAWJHXKPPDNEJIIWXAGXULKPQDNHTKGPQHPNCPHJJKXGJULVWHJWWKHJLKXGVTIORFSVIVHJFFALLSDCXGXVUKHJSEVLVSBUJLSEISGIKHLLIQLKTLSEMSHIQBMDFQUSGIXKIVJVEDDDENFBOGXSTSHPPMRNFTTUIJUSJTIXGIJKHRPBSAEMMMBULXSKNFRDKKSTKXKSGLHTFKJLPMAPUVHMMQMNOFMCFEOPNRMNTIGXGNDAROCPNPMPXVLVKNNFEEVXVUVIXGXFAPDAOLKXVUUJUTFOOPNGKIQUUSXJQFENAOACNAQEENQFNTSSTUKFGOMFMORONDCOEOFBPASKSVVAODMNPMFNBPREORQSTJXTEJJBXGWHUFQBTJXIULIQFMPDSXXWWCCOCDDDVLXARPRHWCDOQFDMFVKISBQSTHXSSIXJTJOCVVKKRBCOQCDVFCNBUTTAPDPOAJTKTIGJVTTEPFAOXKTSEFLJOTSVIKVHIJPEODCHONATIJSHJJSSIJWJMANEPDNHMAWGIJHXUVKJUJSJIJTSKKTLPBPOJUXGVFCJGJJQMPHJKKXIJIVTSFFBOCOPFMXLVHJXBDCTSVHJTDDKLUTOQACDKPVTERNEFIIWGJJSSSGIWILKIOOUIEEPFQDMNXVELLITGIJSTUJJXCCHVTTSIGJOFSOPROQQFDPWIJJOQSIJXCQEFNSTKMAPFEOOORMWDITWKNAPPPKHSLOCFOMPMOCPDCOPOOPRHIWVHWFPNPEBQFQBCOIWHLKXILUXSTWWDCNMFPJXVUEAITVIIVDWIIIOBEORQNDPLLUUEOAEEOHLLQSKJSHOPCBRECXWTIXXECOQFUHJSVFFFQFHKSDPREAJILPRTJRNJVXTHXGJOREBETHILTHQPCBDBDNQWAWKGTTVJIJWSWHGGVLOAODPOBCCMCUSVHXHHSSJIJOOMCGIAOCOBODUVIIIIKOPPFVKHXTIJJUVUIIJVLUUUSFSSFQCADOUIKSUCREUEFMVUKIKVJSJTHJ';

/** The orders of three quarters, by the number in a letter. */
const ORDERS = ['012', '021', '102', '120', '201', '210'];

/** The positions of the points within their cells, as xyxy…, from the quarters that they lie in. */
export function pointsOf(quarters: ArrayLike<number>): Float64Array {
  const points = new Float64Array(2 * STIPPLE_PERIOD ** 2);
  for (let cell = 0; cell < STIPPLE_PERIOD ** 2; cell++) {
    let [x, y] = [cell % STIPPLE_PERIOD, Math.floor(cell / STIPPLE_PERIOD)];
    // Each quarter on the way from set to smaller set adds a binary digit to both coordinates.
    for (let digit = 0.5; digit > 2 ** -24; digit /= 2) {
      const b = quarters[y * STIPPLE_PERIOD + x];
      points[2 * cell] += (b & 1) * digit;
      points[2 * cell + 1] += (b >> 1) * digit;
      x = (2 * x + (b & 1)) % STIPPLE_PERIOD;
      y = (2 * y + (b >> 1)) % STIPPLE_PERIOD;
    }
  }
  return points;
}

/** The rank of a cell in ordered dithering (Bayer 1973): the first cells of any number are spread evenly over the grid. */
export function bayerRank(cell: number): number {
  const [x, y] = [cell % STIPPLE_PERIOD, Math.floor(cell / STIPPLE_PERIOD)];
  let rank = 0;
  for (let bit = 1; bit < STIPPLE_PERIOD; bit *= 2)
    rank = 4 * rank + 2 * Number((x & bit) !== (y & bit)) + Number((y & bit) !== 0);
  return rank;
}

/** For each cell the quarter that holds its point, and the other quarters in the order in which their points appear. */
export function readStippleSet(): { quarters: number[]; births: number[][] } {
  const codes = Array.from(STIPPLE_SET, (letter) => letter.charCodeAt(0) - 65);
  const quarters = codes.map((code) => Math.floor(code / 6));
  const births = codes.map((code, cell) => {
    const others = [0, 1, 2, 3].filter((b) => b !== quarters[cell]);
    return Array.from(ORDERS[code % 6], (digit) => others[Number(digit)]);
  });
  return { quarters, births };
}

let stipple: DataTexture | undefined;

/**
 * The set of points for stippling, with a texel per quarter of a cell. Red and green hold the position of the quarter's point within
 * it; blue holds the moment at which the point appears in an octave of magnification, 0 if it was there before. The texture tiles. The
 * first call makes it in a few milliseconds; it is shared and never disposed of.
 */
export function stippleMap(): DataTexture {
  if (stipple === undefined) {
    stipple = new DataTexture(stippleTexels(), STIPPLE_MAP_SIZE, STIPPLE_MAP_SIZE);
    stipple.wrapS = stipple.wrapT = RepeatWrapping;
    stipple.magFilter = stipple.minFilter = NearestFilter;
    stipple.needsUpdate = true;
  }
  return stipple;
}

function stippleTexels(): Uint8Array {
  const texels = new Uint8Array(4 * STIPPLE_MAP_SIZE ** 2);
  const { quarters, births } = readStippleSet();
  const points = pointsOf(quarters);
  for (let cell = 0; cell < STIPPLE_PERIOD ** 2; cell++) {
    const [left, below] = [2 * (cell % STIPPLE_PERIOD), 2 * Math.floor(cell / STIPPLE_PERIOD)];
    for (const [place, b] of [quarters[cell], ...births[cell]].entries()) {
      const [x, y] = [left + (b & 1), below + (b >> 1)];
      const point = 2 * ((y % STIPPLE_PERIOD) * STIPPLE_PERIOD + (x % STIPPLE_PERIOD));
      // Each of the three new points of a cell appears in its own third of the octave, evenly distributed over the plane.
      const born = (place - 1 + (bayerRank(cell) + 0.5) / STIPPLE_PERIOD ** 2) / 3;
      texels.set(
        [255 * points[point], 255 * points[point + 1], place === 0 ? 0 : Math.max(1, 255 * born), 255].map(Math.round),
        4 * (y * STIPPLE_MAP_SIZE + x),
      );
    }
  }
  return texels;
}
