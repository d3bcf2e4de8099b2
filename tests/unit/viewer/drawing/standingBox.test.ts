import {
  Box3,
  BoxGeometry,
  BufferAttribute,
  Group,
  Mesh,
  MeshPhysicalMaterial,
  MeshStandardMaterial,
  Vector3,
} from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { describe, expect, test } from 'vitest';
import { carryingBox, standingBox } from '../../../../src/viewer/drawing/meshes.js';

/** A box of a height on another height. */
function boxAt(y: number, height: number, material = new MeshStandardMaterial()): Mesh {
  const mesh = new Mesh(new BoxGeometry(0.1, height, 0.1), material);
  mesh.position.y = y + height / 2;
  return mesh;
}

function lowestOf(...meshes: Mesh[]): number {
  const root = new Group().add(...meshes);
  root.updateMatrixWorld(true);
  return carryingBox(root).min.y;
}

describe('what a model stands on', () => {
  test('is its lowest drawn point, whatever is hidden below it', () => {
    const hidden = boxAt(-0.5, 0.4);
    hidden.visible = false;
    const unseen = boxAt(-0.6, 0.4, new MeshStandardMaterial({ transparent: true, opacity: 0 }));
    const unused = boxAt(-0.7, 0.4, new MeshStandardMaterial({ visible: false }));
    expect(lowestOf(boxAt(0, 1), hidden, unseen, unused)).toBeCloseTo(0, 6);
  });

  test('is nothing that is seen through, unless all is', () => {
    const glass = () => boxAt(-0.5, 0.2, new MeshStandardMaterial({ transparent: true, opacity: 0.3 }));
    const crystal = boxAt(-0.6, 0.2, new MeshPhysicalMaterial({ transmission: 1 }));
    expect(lowestOf(boxAt(0, 1), glass(), crystal)).toBeCloseTo(0, 6);
    expect(lowestOf(glass())).toBeCloseTo(-0.5, 6);
  });

  test('is each part of a mesh by its own material', () => {
    const geometry = mergeGeometries(
      [
        new BoxGeometry(0.1, 1, 0.1).translate(0, 0.5, 0),
        new BoxGeometry(0.1, 0.3, 0.1).translate(0, -0.2, 0),
        new BoxGeometry(0.1, 0.3, 0.1).translate(0, -0.5, 0),
      ],
      true,
    );
    const glass = new MeshStandardMaterial({ transparent: true, opacity: 0.3 });
    const hidden = new MeshStandardMaterial({ visible: false });
    expect(lowestOf(new Mesh(geometry, [new MeshStandardMaterial(), glass, hidden]))).toBeCloseTo(0, 6);
    expect(lowestOf(new Mesh(geometry, [hidden, glass, hidden]))).toBeCloseTo(-0.35, 6);
  });

  test('is no vertex that no triangle uses', () => {
    const mesh = boxAt(0, 1);
    const { array } = mesh.geometry.getAttribute('position');
    mesh.geometry.setAttribute('position', new BufferAttribute(Float32Array.from([...array, 0, -3, 0]), 3));
    expect(lowestOf(mesh)).toBeCloseTo(0, 6);
  });

  test('is what the first pose stands on if others reach hardly farther, and all of them if they do', () => {
    const pose = (y: number) => new Box3(new Vector3(-0.5, y, -0.5), new Vector3(0.5, y + 1, 0.5));
    expect(standingBox([pose(0)]).min.y).toBe(0);
    expect(standingBox([pose(0), pose(0.3), pose(-0.02)]).min.y).toBe(0);
    expect(standingBox([pose(0), pose(0.3), pose(-0.4)]).min.y).toBe(-0.4);
  });
});
