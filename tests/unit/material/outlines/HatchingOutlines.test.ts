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
import { prepareHatchingGeometry } from '../../../../src/material/geometry/prepareHatchingGeometry.js';
import { HatchingOutlineMaterial } from '../../../../src/material/outlines/HatchingOutlineMaterial.js';
import { HatchingOutlines } from '../../../../src/material/outlines/HatchingOutlines.js';

let geometry: BufferGeometry;
beforeAll(async () => {
  geometry = await prepareHatchingGeometry(new BoxGeometry(2, 2, 2), { outlines: true, layout: 'indexed' });
});

/** No test here may log anything. */
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

const createMesh = (withOutlines = true) => {
  const mesh = new Mesh(geometry, new MeshBasicMaterial());
  mesh.name = 'box';
  if (withOutlines) mesh.add(new HatchingOutlines(mesh));
  return mesh;
};

const outlinesOf = (object: Object3D) => object.children.find((child) => child instanceof HatchingOutlines)!;

describe('the mesh', () => {
  test('is the given one, or else the parent', () => {
    const mesh = createMesh(false);
    const outlines = new HatchingOutlines();
    expect(outlines.mesh).toBeNull();
    mesh.add(outlines);
    expect(outlines.mesh).toBe(mesh);
    const other = createMesh(false);
    other.add(outlines);
    expect(outlines.mesh).toBe(other);
    outlines.mesh = mesh;
    expect(outlines.mesh).toBe(mesh);
    outlines.mesh = null;
    expect(outlines.mesh).toBe(other);
    outlines.removeFromParent();
    expect(outlines.mesh).toBeNull();
    expect(new HatchingOutlines(mesh).mesh).toBe(mesh);
    expect(new HatchingOutlines(null).mesh).toBeNull();
  });

  test('is no group', () => {
    const outlines = new HatchingOutlines();
    new Group().add(outlines);
    expect(outlines.mesh).toBeNull();
  });

  test.each([undefined, 'mesh'])('when it is cloned, the clone draws its own outlines (given: %s)', (given) => {
    const mesh = createMesh(false);
    mesh.add(new HatchingOutlines(given ? mesh : undefined, { outlineWidth: 5 }));
    const clone = mesh.clone();
    expect(outlinesOf(clone)).not.toBe(outlinesOf(mesh));
    expect(outlinesOf(clone).mesh).toBe(clone);
    expect(outlinesOf(mesh).mesh).toBe(mesh);
    expect(outlinesOf(clone).material).toBe(outlinesOf(mesh).material);
  });

  test('in a group that is cloned too', () => {
    const group = new Group();
    group.add(createMesh());
    const clone = group.clone();
    expect(outlinesOf(clone.children[0]).mesh).toBe(clone.children[0]);
  });

  test('is kept if the outlines have another parent', () => {
    const mesh = createMesh(false);
    const outlines = new HatchingOutlines(mesh);
    new Scene().add(outlines);
    expect(outlines.clone().mesh).toBe(mesh);
  });
});

describe('the material', () => {
  test('is made from parameters, or the one that is given', () => {
    const material = new HatchingOutlineMaterial();
    expect(new HatchingOutlines(null, material).material).toBe(material);
    const own = new HatchingOutlines(null, { outlineWidth: 4, weights: { lit: 0, shade: 1 } }).material;
    expect(own.outlineWidth).toBe(4);
    expect(own.weights).toMatchObject({ lit: 0, shade: 1 });
    expect(new HatchingOutlines().material.outlineWidth).toBe(1.8);
    expect(own.isHatchingOutlineMaterial).toBe(true);
  });

  test('is disposed of with the outlines if it is their own', () => {
    const given = new HatchingOutlineMaterial();
    const [first, second] = [new HatchingOutlines(null, given), new HatchingOutlines()];
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

test('nothing is drawn with a foreign material, as helpers set on every object for a moment', () => {
  const outlines = outlinesOf(createMesh()) as HatchingOutlines;
  const own = outlines.material;
  Object.assign(outlines, { material: new ShaderMaterial() });
  outlines.onBeforeRender({} as WebGLRenderer, new Scene(), new PerspectiveCamera());
  expect(outlines.geometry.drawRange).toEqual({ start: 0, count: -1 });
  outlines.material = own;
});

test('a surface with invisible materials has no outlines', () => {
  const mesh = createMesh();
  const outlines = outlinesOf(mesh) as HatchingOutlines;
  for (const material of [mesh.material, [mesh.material, new MeshBasicMaterial({ visible: false })]]) {
    Object.assign(mesh, { material });
    for (const one of [material].flat()) one.visible = false;
    // A renderer without methods: drawing with it throws.
    outlines.onBeforeRender({} as WebGLRenderer, new Scene(), new PerspectiveCamera());
    expect(outlines.geometry.drawRange.count).toBe(-1);
    [material].flat()[0].visible = true;
    expect(() => outlines.onBeforeRender({} as WebGLRenderer, new Scene(), new PerspectiveCamera())).toThrow();
  }
});

test('an override material finds no colours and no morph targets of instances, which have none here', () => {
  // three.js compares with null.
  const { instanceColor, morphTexture } = new HatchingOutlines();
  expect([instanceColor, morphTexture]).toEqual([null, null]);
});

describe('in a scene', () => {
  test('raycasts ignore them', () => {
    const mesh = createMesh();
    const ray = new Raycaster(new Vector3(0, 0, 9), new Vector3(0, 0, -1));
    expect(ray.intersectObject(outlinesOf(mesh))).toEqual([]);
    const hits = ray.intersectObject(mesh);
    expect(hits.length).toBeGreaterThan(0);
    expect(new Set(hits.map(({ object }) => object))).toEqual(new Set([mesh]));
  });

  test.each([false, true])('bounding boxes ignore them (precise: %s)', (precise) => {
    const [mesh, plain] = [createMesh(), createMesh(false)];
    for (const object of [mesh, plain]) {
      object.position.set(5, 6, 7);
      object.rotation.set(0.3, 0.2, 0.1);
    }
    const box = new Box3().setFromObject(mesh, precise);
    expect(box).toEqual(new Box3().setFromObject(plain, precise));
    expect(box.isEmpty()).toBe(false);
    expect(new Box3().setFromObject(outlinesOf(mesh), precise).isEmpty()).toBe(true);
  });

  test('they cast no shadow, and are no mesh, line or points', () => {
    const outlines = new HatchingOutlines();
    expect([outlines.castShadow, outlines.receiveShadow]).toEqual([false, false]);
    for (const name of ['isMesh', 'isLine', 'isPoints']) expect(name in outlines).toBe(false);
  });

  test('they stand at the centre of the mesh, to be sorted with it', async () => {
    const sphere = new SphereGeometry(1, 24, 12).translate(3, 0, 0);
    const mesh = new Mesh(await prepareHatchingGeometry(sphere, { outlines: true }), new MeshBasicMaterial());
    const outlines = new HatchingOutlines(mesh);
    mesh.add(outlines);
    mesh.position.set(0, 1, 0);
    mesh.rotation.z = Math.PI / 2;
    const scene = new Scene();
    scene.add(mesh);
    scene.updateMatrixWorld();
    const expected = mesh.geometry.boundingSphere!.center.clone().applyMatrix4(mesh.matrixWorld);
    expect(new Vector3().setFromMatrixPosition(outlines.matrixWorld)).toEqual(expected);
    expect(expected.y).toBeCloseTo(4, 5);
    mesh.position.x = 10;
    outlines.updateWorldMatrix(true, false);
    expect(new Vector3().setFromMatrixPosition(outlines.matrixWorld).x).toBeCloseTo(10, 5);
  });

  test('nothing is drawn without a mesh, or with a geometry without outlines, which is reported once', () => {
    const outlines = new HatchingOutlines();
    const draw = () => outlines.onBeforeRender({} as never, new Scene(), new PerspectiveCamera());
    outlines.geometry.setDrawRange(0, 99);
    draw();
    expect(outlines.geometry.drawRange.count).toBe(-1);
    const error = vi.mocked(console.error).mockImplementation(() => {});
    const plain = new Mesh(new BoxGeometry());
    plain.name = 'crate';
    plain.add(outlines);
    outlines.geometry.setDrawRange(0, 99);
    draw();
    draw();
    expect(outlines.geometry.drawRange.count).toBe(-1);
    expect(error.mock.calls).toEqual([
      [expect.stringContaining('HatchingOutlines: the Mesh "crate" has no outlines to draw')],
    ]);
    error.mockClear();
  });
});

describe('files', () => {
  test('JSON has an empty object in their place, and loads again', () => {
    const mesh = createMesh();
    outlinesOf(mesh).name = 'outlines';
    const json = JSON.parse(JSON.stringify(mesh.toJSON()));
    const loaded = new ObjectLoader().parse(json) as Mesh;
    expect(loaded.isMesh).toBe(true);
    const [empty, ...others] = loaded.children;
    expect(others).toEqual([]);
    expect([empty.type, empty.name, empty.uuid, empty.children]).toEqual([
      'Object3D',
      'outlines',
      outlinesOf(mesh).uuid,
      [],
    ]);
    expect(empty).not.toBeInstanceOf(HatchingOutlines);
    // Only the box and its material.
    expect([json.geometries.length, json.materials.length]).toEqual([1, 1]);
    expect(outlinesOf(mesh).toJSON().object.type).toBe('Object3D');
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
    const [{ nodes, ...withOutlines }, { nodes: plainNodes, ...without }] = [
      await exported(createMesh()),
      await exported(createMesh(false)),
    ] as const;
    expect(withOutlines).toEqual(without);
    expect(withOutlines.meshes).toHaveLength(1);
    expect(nodes.filter((node) => 'mesh' in node)).toHaveLength(1);
    expect(nodes.filter((node) => !('mesh' in node) && Object.keys(node).length > 1)).toEqual([]);
    expect(plainNodes).toHaveLength(1);
    vi.mocked(console.warn).mockClear();
  });
});

/** The browser functions that the exporter needs. */
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
