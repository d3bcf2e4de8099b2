import {
  Box3,
  BoxGeometry,
  type BufferGeometry,
  Group,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  ObjectLoader,
  PerspectiveCamera,
  Raycaster,
  Scene,
  ShaderMaterial,
  SphereGeometry,
  Vector3,
  type WebGLRenderer,
} from 'three';
import { GLTFExporter } from 'three/addons/exporters/GLTFExporter.js';
import { OBJExporter } from 'three/addons/exporters/OBJExporter.js';
import { STLExporter } from 'three/addons/exporters/STLExporter.js';
import { afterEach, beforeAll, beforeEach, describe, expect, test, vi } from 'vitest';
import { prepareHatchingGeometry } from '../../../src/geometry/prepareHatchingGeometry.js';
import { HatchingLineMaterial } from '../../../src/lines/HatchingLineMaterial.js';
import { HatchingLines } from '../../../src/lines/HatchingLines.js';

let geometry: BufferGeometry;
beforeAll(async () => {
  geometry = await prepareHatchingGeometry(new BoxGeometry(2, 2, 2), { lines: true, layout: 'indexed' });
});

/** Nothing here may leave a message. */
beforeEach(() => {
  vi.spyOn(console, 'warn');
  vi.spyOn(console, 'error');
});
afterEach(() => {
  expect(console.warn).not.toHaveBeenCalled();
  expect(console.error).not.toHaveBeenCalled();
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
});

const createMesh = (withLines = true) => {
  const mesh = new Mesh(geometry, new MeshBasicMaterial());
  mesh.name = 'box';
  if (withLines) mesh.add(new HatchingLines(mesh));
  return mesh;
};

const linesOf = (object: Object3D) => object.children.find((child) => child instanceof HatchingLines)!;

describe('the mesh', () => {
  test('is the one that is given, or else the parent', () => {
    const mesh = createMesh(false);
    const lines = new HatchingLines();
    expect(lines.mesh).toBeNull();
    mesh.add(lines);
    expect(lines.mesh).toBe(mesh);
    const other = createMesh(false);
    other.add(lines);
    expect(lines.mesh).toBe(other);
    lines.mesh = mesh;
    expect(lines.mesh).toBe(mesh);
    lines.mesh = null;
    expect(lines.mesh).toBe(other);
    lines.removeFromParent();
    expect(lines.mesh).toBeNull();
    expect(new HatchingLines(mesh).mesh).toBe(mesh);
    expect(new HatchingLines(null).mesh).toBeNull();
  });

  test('is no group', () => {
    const lines = new HatchingLines();
    new Group().add(lines);
    expect(lines.mesh).toBeNull();
  });

  test.each([undefined, 'mesh'])('when it is cloned, the clone draws its own lines (given: %s)', (given) => {
    const mesh = createMesh(false);
    mesh.add(new HatchingLines(given ? mesh : undefined, { lineWidth: 5 }));
    const clone = mesh.clone();
    expect(linesOf(clone)).not.toBe(linesOf(mesh));
    expect(linesOf(clone).mesh).toBe(clone);
    expect(linesOf(mesh).mesh).toBe(mesh);
    expect(linesOf(clone).material).toBe(linesOf(mesh).material);
  });

  test('in a group that is cloned too', () => {
    const group = new Group();
    group.add(createMesh());
    const clone = group.clone();
    expect(linesOf(clone.children[0]).mesh).toBe(clone.children[0]);
  });

  test('stays where the lines are elsewhere', () => {
    const mesh = createMesh(false);
    const lines = new HatchingLines(mesh);
    new Scene().add(lines);
    expect(lines.clone().mesh).toBe(mesh);
  });
});

describe('the material', () => {
  test('is made from parameters, or the one that is given', () => {
    const material = new HatchingLineMaterial();
    expect(new HatchingLines(null, material).material).toBe(material);
    const own = new HatchingLines(null, { lineWidth: 4, shadeWeights: [0, 1] }).material;
    expect(own.lineWidth).toBe(4);
    expect(own.shadeWeights.toArray()).toEqual([0, 1]);
    expect(new HatchingLines().material.lineWidth).toBe(1.8);
    expect(own.isHatchingLineMaterial).toBe(true);
  });

  test('is disposed of with the lines if it is their own', () => {
    const given = new HatchingLineMaterial();
    const [first, second] = [new HatchingLines(null, given), new HatchingLines()];
    const clone = second.clone();
    const disposed: string[] = [];
    given.addEventListener('dispose', () => disposed.push('given'));
    second.material.addEventListener('dispose', () => disposed.push('own'));
    first.dispose();
    expect(disposed).toEqual([]);
    clone.dispose();
    expect(disposed).toEqual([]);
    second.dispose();
    expect(disposed).toEqual(['own']);
  });
});

test('with a material of others, as helpers give to every object for a moment, nothing is drawn', () => {
  const lines = linesOf(createMesh()) as HatchingLines;
  const own = lines.material;
  Object.assign(lines, { material: new ShaderMaterial() });
  lines.onBeforeRender({} as WebGLRenderer, new Scene(), new PerspectiveCamera());
  expect(lines.geometry.drawRange).toEqual({ start: 0, count: -1 });
  lines.material = own;
});

describe('in a scene', () => {
  test('rays go through', () => {
    const mesh = createMesh();
    const ray = new Raycaster(new Vector3(0, 0, 9), new Vector3(0, 0, -1));
    expect(ray.intersectObject(linesOf(mesh))).toEqual([]);
    const hits = ray.intersectObject(mesh);
    expect(hits.length).toBeGreaterThan(0);
    expect(new Set(hits.map(({ object }) => object))).toEqual(new Set([mesh]));
  });

  test.each([false, true])('boxes are as without (precise: %s)', (precise) => {
    const [mesh, plain] = [createMesh(), createMesh(false)];
    for (const object of [mesh, plain]) {
      object.position.set(5, 6, 7);
      object.rotation.set(0.3, 0.2, 0.1);
    }
    const box = new Box3().setFromObject(mesh, precise);
    expect(box).toEqual(new Box3().setFromObject(plain, precise));
    expect(box.isEmpty()).toBe(false);
    expect(new Box3().setFromObject(linesOf(mesh), precise).isEmpty()).toBe(true);
  });

  test('they cast no shadow, and are no mesh, line or points', () => {
    const lines = new HatchingLines();
    expect([lines.castShadow, lines.receiveShadow]).toEqual([false, false]);
    for (const name of ['isMesh', 'isLine', 'isPoints']) expect(name in lines).toBe(false);
  });

  test('they stand at the centre of the mesh, to be sorted with it', async () => {
    const sphere = new SphereGeometry(1, 24, 12).translate(3, 0, 0);
    const mesh = new Mesh(await prepareHatchingGeometry(sphere, { lines: true }), new MeshBasicMaterial());
    const lines = new HatchingLines(mesh);
    mesh.add(lines);
    mesh.position.set(0, 1, 0);
    mesh.rotation.z = Math.PI / 2;
    const scene = new Scene();
    scene.add(mesh);
    scene.updateMatrixWorld();
    const expected = mesh.geometry.boundingSphere!.center.clone().applyMatrix4(mesh.matrixWorld);
    expect(new Vector3().setFromMatrixPosition(lines.matrixWorld)).toEqual(expected);
    expect(expected.y).toBeCloseTo(4, 5);
    mesh.position.x = 10;
    lines.updateWorldMatrix(true, false);
    expect(new Vector3().setFromMatrixPosition(lines.matrixWorld).x).toBeCloseTo(10, 5);
  });

  test('nothing is drawn without a mesh, or with a geometry that has no lines, which is said once', () => {
    const lines = new HatchingLines();
    const draw = () => lines.onBeforeRender({} as never, new Scene(), new PerspectiveCamera());
    lines.geometry.setDrawRange(0, 99);
    draw();
    expect(lines.geometry.drawRange.count).toBe(-1);
    const error = vi.mocked(console.error).mockImplementation(() => {});
    const plain = new Mesh(new BoxGeometry());
    plain.geometry.name = 'crate';
    plain.add(lines);
    lines.geometry.setDrawRange(0, 99);
    draw();
    draw();
    expect(lines.geometry.drawRange.count).toBe(-1);
    expect(error.mock.calls).toEqual([
      [expect.stringContaining('HatchingLines: geometry "crate" has no lines to draw')],
    ]);
    error.mockClear();
  });
});

describe('files', () => {
  test('JSON has an empty object in their place, and loads again', () => {
    const mesh = createMesh();
    linesOf(mesh).name = 'lines';
    const json = JSON.parse(JSON.stringify(mesh.toJSON()));
    const loaded = new ObjectLoader().parse(json) as Mesh;
    expect(loaded.isMesh).toBe(true);
    const [empty, ...others] = loaded.children;
    expect(others).toEqual([]);
    expect([empty.type, empty.name, empty.uuid, empty.children]).toEqual(['Object3D', 'lines', linesOf(mesh).uuid, []]);
    expect(empty).not.toBeInstanceOf(HatchingLines);
    // Only the box and its material.
    expect([json.geometries.length, json.materials.length]).toEqual([1, 1]);
    expect(linesOf(mesh).toJSON().object.type).toBe('Object3D');
  });

  test.each([
    ['STL', (mesh: Mesh) => new STLExporter().parse(mesh)],
    ['OBJ', (mesh: Mesh) => new OBJExporter().parse(mesh)],
  ])('%s is as without', (_, exported) => {
    const text = exported(createMesh());
    expect(text).toBe(exported(createMesh(false)));
    expect(text.length).toBeGreaterThan(500);
  });

  test('glTF has the same meshes, buffers and materials as without, and an empty node in their place', async () => {
    vi.stubGlobal('FileReader', FileReader);
    const exported = async (mesh: Mesh) =>
      (await new GLTFExporter().parseAsync(mesh, { binary: false })) as Record<string, { name?: string }[]>;
    vi.mocked(console.warn).mockImplementation(() => {});
    const [{ nodes, ...withLines }, { nodes: plainNodes, ...without }] = [
      await exported(createMesh()),
      await exported(createMesh(false)),
    ] as const;
    expect(withLines).toEqual(without);
    expect(withLines.meshes).toHaveLength(1);
    expect(nodes.filter((node) => 'mesh' in node)).toHaveLength(1);
    expect(nodes.filter((node) => !('mesh' in node) && Object.keys(node).length > 1)).toEqual([]);
    expect(plainNodes).toHaveLength(1);
    vi.mocked(console.warn).mockClear();
  });
});

/** What the exporter needs of the browser's. */
class FileReader {
  result: ArrayBuffer | string | null = null;
  onloadend: () => void = () => {};

  readAsArrayBuffer(blob: Blob): void {
    blob.arrayBuffer().then((buffer) => this.end(buffer));
  }

  readAsDataURL(blob: Blob): void {
    blob.arrayBuffer().then((buffer) => this.end(`data:;base64,${Buffer.from(buffer).toString('base64')}`));
  }

  private end(result: ArrayBuffer | string): void {
    this.result = result;
    this.onloadend();
  }
}
