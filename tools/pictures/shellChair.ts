import {
  BufferAttribute,
  BufferGeometry,
  CatmullRomCurve3,
  CylinderGeometry,
  LatheGeometry,
  Vector2,
  Vector3,
} from 'three';

/** Rows along the shell and columns across it: few, so that its triangles are visible. */
const ROWS = 18;
const COLUMNS = 12;

/** A chair with a moulded shell, splayed wooden legs and a cushion, as separate geometries. Its up axis is y. */
export function shellChair(): { shell: BufferGeometry; legs: BufferGeometry[]; cushion: BufferGeometry } {
  const legs = [
    [-1, -1],
    [-1, 1],
    [1, -1],
    [1, 1],
  ].map(([x, z]) => rod(new Vector3(0.24 * x, 0.9, 0.2 * z), new Vector3(0.42 * x, 0, 0.4 * z), 0.045, 0.028));
  const stays = [-1, 1].map((x) =>
    rod(new Vector3(0.33 * x, 0.45, -0.3), new Vector3(-0.33 * x, 0.45, 0.3), 0.014, 0.014),
  );
  return { shell: shell(), legs: [...legs, ...stays], cushion: cushion() };
}

/** The shell, from the front edge of the seat to the top of the back. */
function shell(): BufferGeometry {
  const spine = new CatmullRomCurve3(
    [
      [0, 0.84, 0.56],
      [0, 0.93, 0.42],
      [0, 0.9, 0.1],
      [0, 0.9, -0.22],
      [0, 1.08, -0.44],
      [0, 1.42, -0.54],
      [0, 1.78, -0.62],
    ].map((point) => new Vector3(...point)),
  );
  const positions: number[] = [];
  const place = new Vector3();
  const tangent = new Vector3();
  for (let row = 0; row <= ROWS; row++) {
    const v = row / ROWS;
    spine.getPointAt(v, place);
    spine.getTangentAt(v, tangent);
    // The inner normal: it points up from the seat and forwards from the back.
    const inward = new Vector3(0, -tangent.z, tangent.y);
    const width = 0.5 * (1 - 0.5 * (2 * v - 1) ** 6) - 0.04 * v;
    // The shell is deepest where seat and back meet, and flat at the front edge.
    const depth = 0.34 * Math.sin(Math.PI * Math.min(1, 0.9 * v)) ** 1.5;
    for (let column = 0; column <= COLUMNS; column++) {
      const u = (2 * column) / COLUMNS - 1;
      const cup = depth * Math.abs(u) ** 2.4;
      positions.push(width * u * (1 - 0.25 * cup), place.y + cup * inward.y, place.z + cup * inward.z);
    }
  }
  const indices: number[] = [];
  for (let row = 0; row < ROWS; row++) {
    for (let column = 0; column < COLUMNS; column++) {
      const a = row * (COLUMNS + 1) + column;
      const b = a + COLUMNS + 1;
      indices.push(a, a + 1, b, b, a + 1, b + 1);
    }
  }
  const geometry = new BufferGeometry().setIndex(indices);
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
  geometry.computeVertexNormals();
  return geometry;
}

/** A round rod whose radius goes from `from` to `to`. */
function rod(start: Vector3, end: Vector3, from: number, to: number): BufferGeometry {
  const along = end.clone().sub(start);
  const geometry = new CylinderGeometry(from, to, along.length(), 10, 5);
  // CylinderGeometry takes the top radius first.
  geometry
    .translate(0, -along.length() / 2, 0)
    .rotateX(Math.PI)
    .rotateX(Math.PI / 2);
  geometry.lookAt(along);
  return geometry.translate(start.x, start.y, start.z);
}

/** A round cushion, thickest in the middle. */
function cushion(): BufferGeometry {
  const profile = Array.from({ length: 9 }, (_, i) => {
    const angle = (i / 8 - 0.5) * Math.PI;
    return new Vector2(0.34 * Math.cos(angle) ** 0.5, 0.075 * Math.sin(angle));
  });
  return new LatheGeometry(profile, 24).translate(0, 0.98, 0.06);
}
