/** Cells of the set per side, after which it repeats: a power of two. */
export const PERIOD = 32;

/**
 * A set of points in the plane that is its own enlargement: half as large, it holds itself. So points may be born between others
 * for ever as one comes nearer, and none ever moves. Found by tools/building/stippleSet.mjs.
 *
 * Cell c = (x, y), in rows, has one point. It is that of cell 2c + b, at half the size, where b is one of its quarters: 0 and 1, then
 * 2 and 3 above them. A letter holds b and which of the three other quarters' points, at half the size, are born first, second and
 * third.
 */
export const STIPPLE_SET =
  'WXAWJHXKPPDNEJIIWXAGXULKPQDNHTKGPQHPNCPHJJKXGJULVWHJWWKHJLKXGVTIORFSVIVHJFFALLSDCXGXVUKHJSEVLVSBUJLSEISGIKHLLIQLKTLSEMSHIQBMDFQUSGIXKIVJVEDDDENFBOGXSTSHPPMRNFTTUIJUSJTIXGIJKHRPBSAEMMMBULXSKNFRDKKSTKXKSGLHTFKJLPMAPUVHMMQMNOFMCFEOPNRMNTIGXGNDAROCPNPMPXVLVKNNFEEVXVUVIXGXFAPDAOLKXVUUJUTFOOPNGKIQUUSXJQFENAOACNAQEENQFNTSSTUKFGOMFMORONDCOEOFBPASKSVVAODMNPMFNBPREORQSTJXTEJJBXGWHUFQBTJXIULIQFMPDSXXWWCCOCDDDVLXARPRHWCDOQFDMFVKISBQSTHXSSIXJTJOCVVKKRBCOQCDVFCNBUTTAPDPOAJTKTIGJVTTEPFAOXKTSEFLJOTSVIKVHIJPEODCHONATIJSHJJSSIJWJMANEPDNHMAWGIJHXUVKJUJSJIJTSKKTLPBPOJUXGVFCJGJJQMPHJKKXIJIVTSFFBOCOPFMXLVHJXBDCTSVHJTDDKLUTOQACDKPVTERNEFIIWGJJSSSGIWILKIOOUIEEPFQDMNXVELLITGIJSTUJJXCCHVTTSIGJOFSOPROQQFDPWIJJOQSIJXCQEFNSTKMAPFEOOORMWDITWKNAPPPKHSLOCFOMPMOCPDCOPOOPRHIWVHWFPNPEBQFQBCOIWHLKXILUXSTWWDCNMFPJXVUEAITVIIVDWIIIOBEORQNDPLLUUEOAEEOHLLQSKJSHOPCBRECXWTIXXECOQFUHJSVFFFQFHKSDPREAJILPRTJRNJVXTHXGJOREBETHILTHQPCBDBDNQWAWKGTTVJIJWSWHGGVLOAODPOBCCMCUSVHXHHSSJIJOOMCGIAOCOBODUVIIIIKOPPFVKHXTIJJUVUIIJVLUUUSFSSFQCADOUIKSUCREUEFMVUKIKVJSJTHJ';

/** Which of three is first, second and third. */
const ORDERS = ['012', '021', '102', '120', '201', '210'];

/** The points of the cells in their cells, as xyxy…, from the quarters they lie in. */
export function pointsOf(quarters: ArrayLike<number>): Float64Array {
  const points = new Float64Array(2 * PERIOD ** 2);
  for (let cell = 0; cell < PERIOD ** 2; cell++) {
    let [x, y] = [cell % PERIOD, Math.floor(cell / PERIOD)];
    // Binary digits: each cell on the way adds one of either coordinate.
    for (let digit = 0.5; digit > 2 ** -24; digit /= 2) {
      const b = quarters[y * PERIOD + x];
      points[2 * cell] += (b & 1) * digit;
      points[2 * cell + 1] += (b >> 1) * digit;
      x = (2 * x + (b & 1)) % PERIOD;
      y = (2 * y + (b >> 1)) % PERIOD;
    }
  }
  return points;
}

/** The rank of a cell in an order that is everywhere on the grid as soon as possible: that of ordered dithering (Bayer 1973). */
export function bayerRank(cell: number): number {
  const [x, y] = [cell % PERIOD, Math.floor(cell / PERIOD)];
  let rank = 0;
  for (let bit = 1; bit < PERIOD; bit *= 2)
    rank = 4 * rank + 2 * Number((x & bit) !== (y & bit)) + Number((y & bit) !== 0);
  return rank;
}

/** The quarter of each cell that has its own point, and the others in the order of their birth. */
export function readStippleSet(): { quarters: number[]; births: number[][] } {
  const codes = Array.from(STIPPLE_SET, (letter) => letter.charCodeAt(0) - 65);
  const quarters = codes.map((code) => Math.floor(code / 6));
  const births = codes.map((code, cell) => {
    const others = [0, 1, 2, 3].filter((b) => b !== quarters[cell]);
    return Array.from(ORDERS[code % 6], (digit) => others[Number(digit)]);
  });
  return { quarters, births };
}
