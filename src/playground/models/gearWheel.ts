import { type BufferGeometry, ExtrudeGeometry, Path, Shape } from 'three';

const TEETH = 20;
const ROOT = 0.78;
const TIP = 0.96;
const SPOKES = 5;
const CURVE_SEGMENTS = 48;

/** A spur gear with a hub and a keyway, as separate geometries. Its axis is z. */
export function gearWheel(): BufferGeometry[] {
  return [extruded(withHoles(rim(), spokeHoles()), -0.16, 0.32), extruded(withHoles(disc(0.34), [bore()]), 0.16, 0.16)];
}

const extruded = (shape: Shape, from: number, depth: number): BufferGeometry =>
  new ExtrudeGeometry(shape, { depth, bevelEnabled: false, curveSegments: CURVE_SEGMENTS }).translate(0, 0, from);

function withHoles(shape: Shape, holes: Path[]): Shape {
  shape.holes.push(...holes);
  return shape;
}

const disc = (radius: number): Shape => new Shape().absarc(0, 0, radius, 0, 2 * Math.PI, false) as Shape;

/** The outline with its trapezoidal teeth. */
function rim(): Shape {
  const shape = new Shape();
  const pitch = (2 * Math.PI) / TEETH;
  const at = (radius: number, turn: number) => [radius * Math.cos(turn), radius * Math.sin(turn)] as const;
  for (let i = 0; i < TEETH; i++) {
    const start = i * pitch;
    if (i === 0) shape.moveTo(...at(ROOT, start));
    shape.absarc(0, 0, ROOT, start, start + 0.4 * pitch, false);
    shape.lineTo(...at(TIP, start + 0.56 * pitch));
    shape.absarc(0, 0, TIP, start + 0.56 * pitch, start + 0.84 * pitch, false);
    shape.lineTo(...at(ROOT, start + pitch));
  }
  return shape;
}

/** The openings between the spokes, with the bore. */
function spokeHoles(): Path[] {
  const holes = [bore()];
  const share = (2 * Math.PI) / SPOKES;
  for (let i = 0; i < SPOKES; i++) {
    const middle = i * share + share / 4;
    const [inner, outer] = [0.27, 0.16];
    holes.push(
      new Path()
        .absarc(0, 0, 0.42, middle - inner * share, middle + inner * share, false)
        .absarc(
          0,
          0,
          0.64,
          middle + (inner + outer) * 0.78 * share,
          middle - (inner + outer) * 0.78 * share,
          true,
        ) as Path,
    );
  }
  return holes;
}

/** A round bore with a keyway. */
function bore(): Path {
  const half = Math.asin(0.05 / 0.17);
  const path = new Path().absarc(0, 0, 0.17, Math.PI / 2 + half, Math.PI / 2 + 2 * Math.PI - half, false) as Path;
  path.lineTo(0.05, 0.23);
  path.lineTo(-0.05, 0.23);
  path.closePath();
  return path;
}
