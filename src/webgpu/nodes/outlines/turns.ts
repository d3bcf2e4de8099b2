/** Counterpart of shaders/perTriangle/turns.glsl: rotations as quaternions (x, y, z, w). */
import { tsl, type Value } from '../base/values.js';

const { If, cross, determinant, dot, float, mat3, max, normalize, vec3, vec4 } = tsl;

/** The rotation of a 3 × 3 matrix as a quaternion; zero for one that mirrors or flattens. */
export function turnOf(matrix: Value): Value {
  const turn = vec4(0).toVar();
  If(determinant(matrix).greaterThan(0), () => {
    const x = normalize(matrix.element(0)).toVar();
    const second = matrix.element(1).toVar();
    const y = normalize(second.sub(x.mul(dot(x, second)))).toVar();
    const z = cross(x, y).toVar();
    // Four times the square of each component, minus 1; dividing by the largest component is the most accurate.
    const ofX = x.x.sub(y.y).sub(z.z).toVar();
    const ofY = y.y.sub(z.z).sub(x.x).toVar();
    const ofZ = z.z.sub(x.x).sub(y.y).toVar();
    const ofW = x.x.add(y.y).add(z.z).toVar();
    const largest = max(max(ofX, ofY), max(ofZ, ofW)).toVar();
    const most = largest.add(1).toVar();
    If(ofW.equal(largest), () => {
      turn.assign(vec4(y.z.sub(z.y), z.x.sub(x.z), x.y.sub(y.x), most));
    }).Else(() => {
      If(ofX.equal(largest), () => {
        turn.assign(vec4(most, x.y.add(y.x), x.z.add(z.x), y.z.sub(z.y)));
      }).Else(() => {
        If(ofY.equal(largest), () => {
          turn.assign(vec4(x.y.add(y.x), most, y.z.add(z.y), z.x.sub(x.z)));
        }).Else(() => {
          turn.assign(vec4(x.z.add(z.x), y.z.add(z.y), most, x.y.sub(y.x)));
        });
      });
    });
    turn.assign(normalize(turn));
  });
  return turn;
}

/** The matrix of the inverse rotation. */
export function turnBack(turn: Value): Value {
  const q = normalize(turn).toVar();
  const [x, y, z] = [q.x, q.y, q.z].map((component) => component.mul(2).toVar());
  const { w } = q;
  const columns = [
    vec3(float(1).sub(y.mul(q.y)).sub(z.mul(q.z)), x.mul(q.y).sub(z.mul(w)), x.mul(q.z).add(y.mul(w))),
    vec3(x.mul(q.y).add(z.mul(w)), float(1).sub(x.mul(q.x)).sub(z.mul(q.z)), y.mul(q.z).sub(x.mul(w))),
    vec3(x.mul(q.z).sub(y.mul(w)), y.mul(q.z).add(x.mul(w)), float(1).sub(x.mul(q.x)).sub(y.mul(q.y))),
  ];
  return mat3(...columns).toVar();
}
