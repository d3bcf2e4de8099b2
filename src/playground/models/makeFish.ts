import {
  AnimationClip,
  Bone,
  BufferGeometry,
  Float32BufferAttribute,
  Group,
  IcosahedronGeometry,
  Mesh,
  MeshStandardMaterial,
  Quaternion,
  QuaternionKeyframeTrack,
  Skeleton,
  SkinnedMesh,
  Uint16BufferAttribute,
  Vector3,
} from 'three';
import type { ModelScene } from '../../viewer/files/gltf/parseGltf.js';

/** The numbers of rings from nose to tail, of vertices per ring, and of bones along the spine. */
const RINGS = 96;
const SIDES = 48;
const BONES = 10;
/** Keyframes of a clip, without the last, which repeats the first. */
const KEYS = 24;

/** Half heights above and below the spine and half thickness, from nose (0) to tail (1). */
const PROFILE: readonly (readonly [place: number, above: number, below: number, thickness: number])[] = [
  [0, 0.02, 0.02, 0.02],
  [0.04, 0.1, 0.09, 0.08],
  [0.12, 0.2, 0.17, 0.14],
  [0.26, 0.3, 0.25, 0.19],
  [0.34, 0.42, 0.27, 0.19],
  [0.44, 0.5, 0.27, 0.16],
  [0.55, 0.36, 0.25, 0.13],
  [0.66, 0.2, 0.3, 0.09],
  [0.76, 0.1, 0.12, 0.05],
  [0.82, 0.09, 0.09, 0.035],
  [0.9, 0.27, 0.25, 0.02],
  [0.97, 0.42, 0.38, 0.012],
  [1, 0.36, 0.32, 0.004],
];

/** A swimming fish made from a profile, skinned to a chain of bones, with the clips `Swim` and `Dart` and the morph target `Puffed up`. */
export function makeFish(): ModelScene {
  const mesh = named(new SkinnedMesh(bodyGeometry(), new MeshStandardMaterial()));
  const bones = Array.from({ length: BONES }, (_, i) => {
    const bone = new Bone();
    bone.name = `spine${i}`;
    bone.position.x = i === 0 ? -1 : 2 / (BONES - 1);
    return bone;
  });
  for (const [i, bone] of bones.entries()) bones[i - 1]?.add(bone);
  bones[0].add(eye(1), eye(-1));
  const root = new Group().add(bones[0], mesh);
  root.updateMatrixWorld(true);
  mesh.bind(new Skeleton(bones));
  return { root, animations: [swim('Swim', 2, 0.13), swim('Dart', 0.8, 0.2)] };
}

/** @param side 1 or −1 */
function eye(side: number): Mesh {
  const geometry = new IcosahedronGeometry(0.032, 3).translate(0.2, 0.06, 0.085 * side);
  const moved = new Float32Array(geometry.attributes.position.array.length).map((_, i) =>
    i % 3 === 2 ? 0.045 * side : 0,
  );
  geometry.morphTargetsRelative = true;
  geometry.morphAttributes.position = [new Float32BufferAttribute(moved, 3)];
  return named(new Mesh(geometry, new MeshStandardMaterial({ color: 'black' })));
}

function named<Any extends Mesh>(mesh: Any): Any {
  mesh.updateMorphTargets();
  mesh.morphTargetDictionary = { 'Puffed up': 0 };
  return mesh;
}

/** A clip of a wave that runs down the spine and grows towards the tail. `bend` scales its angles, in radians. */
function swim(name: string, seconds: number, bend: number): AnimationClip {
  const times = Array.from({ length: KEYS + 1 }, (_, key) => (key / KEYS) * seconds);
  const up = new Vector3(0, 1, 0);
  const tracks = Array.from({ length: BONES }, (_, i) => {
    const place = i / (BONES - 1);
    const values = times.flatMap((time) => {
      const phase = 2 * Math.PI * (time / seconds - 0.9 * place);
      // The head sways a little against the tail.
      const angle = i === 0 ? -bend * Math.cos(phase - 0.6) : bend * (0.25 + 1.6 * place ** 1.5) * Math.sin(phase);
      return new Quaternion().setFromAxisAngle(up, angle).toArray();
    });
    return new QuaternionKeyframeTrack(`spine${i}.quaternion`, times, values);
  });
  return new AnimationClip(name, seconds, tracks);
}

function bodyGeometry(): BufferGeometry {
  const positions: number[] = [];
  const puffed: number[] = [];
  const skinIndices: number[] = [];
  const skinWeights: number[] = [];
  const indices: number[] = [];
  // Nose and tail are one vertex each.
  const vertexAt = (ring: number, side: number): number =>
    ring === 0 ? 0 : ring === RINGS ? positions.length / 3 - 1 : 1 + (ring - 1) * SIDES + (side % SIDES);
  for (let ring = 0; ring <= RINGS; ring++) {
    const place = ring / RINGS;
    const [above, below, thickness] = profileAt(place);
    // Only the body in front of the tail is puffed up, to a round cross section.
    const air = Math.exp(-(((place - 0.34) / 0.17) ** 2));
    const [bone, weight] = [Math.min(BONES - 2, Math.floor(place * (BONES - 1))), (place * (BONES - 1)) % 1];
    const isEnd = ring === 0 || ring === RINGS;
    for (let side = 0; side < (isEnd ? 1 : SIDES); side++) {
      const angle = (2 * Math.PI * side) / SIDES;
      const [y, z] = isEnd ? [0, 0] : [Math.sin(angle), Math.cos(angle)];
      // The body becomes thinner towards top and bottom, so that fins have sharp edges.
      const height = y * (y > 0 ? above : below);
      const width = z * thickness * (1 - 0.35 * Math.abs(y) ** 1.5);
      positions.push(2 * place - 1, height, width);
      puffed.push(0, air * (0.5 * y - 0.8 * height), air * (0.5 * z - width));
      skinIndices.push(bone, bone + 1, 0, 0);
      skinWeights.push(1 - weight, weight, 0, 0);
    }
  }
  for (let ring = 1; ring <= RINGS; ring++) {
    for (let side = 0; side < SIDES; side++) {
      const [a, b] = [vertexAt(ring - 1, side), vertexAt(ring - 1, side + 1)];
      const [c, d] = [vertexAt(ring, side), vertexAt(ring, side + 1)];
      if (a !== b) indices.push(a, d, b);
      if (c !== d) indices.push(a, c, d);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(positions, 3));
  geometry.setAttribute('skinIndex', new Uint16BufferAttribute(skinIndices, 4));
  geometry.setAttribute('skinWeight', new Float32BufferAttribute(skinWeights, 4));
  geometry.setIndex(indices);
  geometry.morphTargetsRelative = true;
  geometry.morphAttributes.position = [new Float32BufferAttribute(puffed, 3)];
  return geometry;
}

/** The profile at any place, interpolated smoothly. */
function profileAt(place: number): [above: number, below: number, thickness: number] {
  const next = Math.max(
    1,
    PROFILE.findIndex(([at]) => at >= place),
  );
  const [from, to] = [PROFILE[next - 1], PROFILE[next]];
  const share = (place - from[0]) / (to[0] - from[0]);
  const before = PROFILE[next - 2] ?? from;
  const after = PROFILE[next + 1] ?? to;
  return [1, 2, 3].map((i) => hermite(share, before[i], from[i], to[i], after[i])) as [number, number, number];
}

/** Cubic Hermite interpolation between b and c, with slopes from their neighbours a and d. */
function hermite(t: number, a: number, b: number, c: number, d: number): number {
  const [inward, outward] = [(c - a) / 2, (d - b) / 2];
  const cubic = 2 * (b - c) + inward + outward;
  return Math.max(0.004, b + t * (inward + t * (3 * (c - b) - 2 * inward - outward + t * cubic)));
}
