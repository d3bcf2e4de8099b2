import {
  BoxGeometry,
  type BufferGeometry,
  CylinderGeometry,
  DoubleSide,
  Group,
  Mesh,
  MeshStandardMaterial,
  type Object3D,
  PlaneGeometry,
} from 'three';
import { gearWheel } from '../../src/playground/models/gearWheel.js';
import { makeFox } from '../../src/playground/models/makeFox.js';
import { makeHouse } from '../../src/playground/models/makeHouse.js';
import { bookshelf, makeRoom } from '../../src/playground/models/makeRoom.js';
import { makeStairs } from '../../src/playground/models/makeStairs.js';
import { makeStreet } from '../../src/playground/models/makeStreet.js';
import { sceneOf } from '../../src/playground/models/solids.js';
import { makeCar } from './makeCar.js';
import { makeTerrain } from './makeTerrain.js';
import { shellChair } from './shellChair.js';

/** A scene by which drawings of plain faces are judged. */
export interface FlatScene {
  /** Makes it of lit meshes, as users have them. */
  make(): Object3D;
  /** Position and target of the camera. */
  eye: readonly [number, number, number];
  target: readonly [number, number, number];
  /** Direction to the light. */
  light: readonly [number, number, number];
  /** Vertical field of view in degrees. Default: 32 */
  fieldOfView?: number;
  /** Factor on the distance for the view from afar. Default: 2.4 */
  far?: number;
}

const SUBJECT_LIGHT = [-0.55, 1, 0.65] as const;

export const FLAT_SCENES = {
  house: {
    make: () => onGround(makeHouse().root, 5, -0.16),
    eye: [4.6, 2.5, 5.4],
    target: [0, 0.95, 0],
    light: SUBJECT_LIGHT,
  },
  /** Boxes, a roof of four sides that share their normals, and a round tower. */
  cottage: { make: makeCottage, eye: [5.2, 3.1, 6.4], target: [0, 0.8, 0], light: [-4, 6, 3] },
  room: {
    make: () => makeRoom().root,
    eye: [0.35, 1.5, 5.6],
    target: [0, 1.3, -1],
    light: [-0.35, 0.55, 1],
    fieldOfView: 40,
    far: 2,
  },
  stairs: {
    make: () => onGround(makeStairs().root, 9, -0.12),
    eye: [4.3, 4, 7.9],
    target: [-1.75, 1.7, 0.9],
    light: [0.35, 1, 0.9],
  },
  street: {
    make: () => onGround(makeStreet().root, 400, -0.15),
    eye: [0.45, 1.75, 3.6],
    target: [-0.1, 2.05, -14],
    light: [0.7, 0.9, 0.55],
    fieldOfView: 46,
    far: 1.6,
  },
  bookshelf: { make: makeBookshelf, eye: [1.65, 1.5, 3.9], target: [0, 0.93, 0], light: [-0.5, 0.8, 1] },
  gear: {
    make: () => new Group().add(...gearWheel().map((geometry) => new Mesh(geometry, white()))),
    eye: [1.65, 1.2, 3.2],
    target: [0, 0, 0],
    light: [-0.35, 1.1, 0.75],
  },
  car: { make: () => onGround(makeCar().root, 9, 0), eye: [4.35, 2.3, 5.5], target: [0, 0.6, 0], light: SUBJECT_LIGHT },
  chair: { make: makeChair, eye: [2.2, 1.7, 3.4], target: [0, 0.85, 0], light: SUBJECT_LIGHT },
  fox: {
    make: () => onGround(makeFox().root, 4, 0),
    eye: [1.75, 1.5, 3.05],
    target: [0.05, 0.85, 0],
    light: SUBJECT_LIGHT,
  },
  terrain: { make: makeTerrain, eye: [3, 6.5, 13], target: [-0.3, 0.9, 0], light: [-0.9, 0.75, 0.25] },
} satisfies Record<string, FlatScene>;

export type FlatSceneName = keyof typeof FLAT_SCENES;

const white = (color = '#ffffff'): MeshStandardMaterial => new MeshStandardMaterial({ color });

/** A subject on a plane of one quad. */
function onGround(subject: Object3D, size: number, y: number): Object3D {
  const ground = new Mesh(new PlaneGeometry(size, size).rotateX(-Math.PI / 2).translate(0, y, 0), white());
  return new Group().add(subject, ground);
}

function makeCottage(): Object3D {
  const root = new Group();
  const add = (geometry: BufferGeometry, x: number, y: number, z: number, color?: string): Mesh => {
    const mesh = new Mesh(geometry, white(color));
    mesh.position.set(x, y, z);
    root.add(mesh);
    return mesh;
  };
  add(new BoxGeometry(3, 1.6, 2), 0, 0.8, 0);
  add(new CylinderGeometry(0.001, 2.1, 1, 4, 1).rotateY(Math.PI / 4), 0, 2.1, 0, '#bb8877').scale.set(1.15, 1, 0.8);
  add(new BoxGeometry(0.3, 1.2, 0.3), 0.8, 2.2, 0.2);
  add(new BoxGeometry(1.2, 1, 1.4), 2.2, 0.5, 0.2, '#dddddd');
  add(new BoxGeometry(8, 0.1, 7), 0, -0.05, 0, '#eeeeee');
  add(new CylinderGeometry(0.35, 0.35, 1.4, 40), -2.4, 0.7, 1.2);
  add(new BoxGeometry(0.5, 1, 0.06), -0.6, 0.5, 1.02, '#554433');
  return root;
}

function makeBookshelf(): Object3D {
  const parts = bookshelf({ width: 1.3, height: 1.9, depth: 0.3, shelves: 5 });
  const colours = { wood: '#b98d5f', darkBook: '#3a2b3a', middleBook: '#a4573f', lightBook: '#e6d8b0' };
  const wall = new Mesh(new PlaneGeometry(5, 4).translate(0, 1.4, -0.005), white());
  return onGround(new Group().add(sceneOf(colours, parts).root, wall), 5, 0);
}

function makeChair(): Object3D {
  const { shell, legs, cushion } = shellChair();
  const root = new Group();
  const seat = new Mesh(shell, white());
  // The shell has no thickness.
  seat.material.side = DoubleSide;
  root.add(seat, ...legs.map((geometry) => new Mesh(geometry, white('#8a5f3c'))), new Mesh(cushion, white('#b5533f')));
  return onGround(root, 4, 0);
}
