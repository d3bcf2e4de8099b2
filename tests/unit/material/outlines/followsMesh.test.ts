import {
  AddEquation,
  BoxGeometry,
  type BufferGeometry,
  Group,
  type Layers,
  type Material,
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  Vector4,
  type WebGLRenderer,
} from 'three';
import { beforeAll, describe, expect, test, vi } from 'vitest';
import { prepareHatchingGeometry } from '../../../../src/material/geometry/prepareHatchingGeometry.js';
import { HatchingOutlineMaterial } from '../../../../src/material/outlines/HatchingOutlineMaterial.js';
import { HatchingOutlines } from '../../../../src/material/outlines/HatchingOutlines.js';
import { randomNumbers } from '../../vector/randomNumbers.js';

let box: BufferGeometry;
let plane: BufferGeometry;
beforeAll(async () => {
  box = await prepareHatchingGeometry(new BoxGeometry(2, 2, 2), { outlines: true, layout: 'indexed' });
  plane = await prepareHatchingGeometry(new PlaneGeometry(2, 2, 4, 1), { outlines: true, layout: 'indexed' });
});

/** The state at the beginning of a draw of outlines. */
interface Draw {
  primitives: number;
  opacity: number;
  depthTest: boolean;
}

/** A renderer that records what it is told to draw. */
class NotingRenderer {
  readonly info = { render: { frame: 0 } };
  readonly properties = { get: () => ({}) };
  // The depth of a WebXR framebuffer cannot be copied.
  readonly xr = { isPresenting: true };
  readonly draws: Draw[] = [];

  getPixelRatio(): number {
    return 1;
  }

  getCurrentViewport(viewport: Vector4): Vector4 {
    return viewport.copy(new Vector4(0, 0, 100, 100));
  }

  renderBufferDirect(_camera: unknown, _scene: unknown, { drawRange }: BufferGeometry, material: Material): void {
    if (drawRange.count <= 0) return;
    const { uniforms, depthTest } = material as HatchingOutlineMaterial;
    this.draws.push({ primitives: drawRange.count / 3, opacity: uniforms.opacity.value, depthTest });
  }

  /** Draws outlines as three.js draws an object. */
  draw(outlines: HatchingOutlines, scene: Scene = sceneOf(outlines)): Draw[] {
    const camera = new PerspectiveCamera(60);
    camera.position.set(3, 4, 5);
    camera.lookAt(0, 0, 0);
    scene.updateMatrixWorld();
    camera.updateMatrixWorld();
    this.info.render.frame++;
    this.draws.length = 0;
    const renderer = this as unknown as WebGLRenderer;
    outlines.onBeforeRender(renderer, scene, camera);
    this.renderBufferDirect(camera, scene, outlines.geometry, outlines.material);
    outlines.onAfterRender(renderer, scene, camera);
    return [...this.draws];
  }
}

function sceneOf(outlines: HatchingOutlines): Scene {
  const scene = new Scene();
  scene.add(outlines.parent!);
  return scene;
}

function outlined(geometry: BufferGeometry, material: Material | Material[], look = {}) {
  const mesh = new Mesh(geometry, material);
  // With suggestive contours all primitives are drawn, so that they can be counted.
  const outlines = new HatchingOutlines(mesh, { weights: { suggestiveContours: 1 }, ...look });
  mesh.add(outlines);
  return { mesh, outlines };
}

const draw = (outlines: HatchingOutlines) => new NotingRenderer().draw(outlines);
const faded = (opacity: number) => new MeshBasicMaterial({ transparent: true, opacity });

describe('layers', () => {
  const isSeen = (outlines: HatchingOutlines, layer: number): boolean => {
    const camera = new PerspectiveCamera();
    camera.layers.set(layer);
    return outlines.layers.test(camera.layers);
  };

  test('are those of the mesh, also after a change', () => {
    const { mesh, outlines } = outlined(box, new MeshBasicMaterial());
    expect([isSeen(outlines, 0), isSeen(outlines, 1)]).toEqual([true, false]);
    mesh.layers.set(1);
    expect([isSeen(outlines, 0), isSeen(outlines, 1)]).toEqual([false, true]);
    mesh.layers.enable(0);
    expect([isSeen(outlines, 0), isSeen(outlines, 1)]).toEqual([true, true]);
    mesh.layers.mask = 4;
    expect(outlines.layers.mask).toBe(4);
    expect(outlines.layers.isEnabled(2)).toBe(true);
  });

  test('follow the mesh after all objects of a scene were moved to a layer', () => {
    const { mesh, outlines } = outlined(box, new MeshBasicMaterial());
    mesh.traverse((object) => object.layers.set(3));
    expect(isSeen(outlines, 3)).toBe(true);
    mesh.layers.set(0);
    expect([isSeen(outlines, 0), isSeen(outlines, 3)]).toEqual([true, false]);
  });

  test('can be set on the outlines themselves', () => {
    const { mesh, outlines } = outlined(box, new MeshBasicMaterial());
    outlines.layers.set(2);
    expect(mesh.layers.mask).toBe(1);
    mesh.layers.set(1);
    expect([isSeen(outlines, 1), isSeen(outlines, 2)]).toEqual([false, true]);
    outlines.layers.mask = mesh.layers.mask;
    mesh.layers.set(5);
    expect(isSeen(outlines, 5)).toBe(true);
  });

  test('of a clone are those of the mesh that was cloned with it', () => {
    const { mesh } = outlined(box, new MeshBasicMaterial());
    mesh.layers.set(1);
    const clone = mesh.clone();
    const outlines = clone.children[0] as HatchingOutlines;
    clone.layers.set(4);
    expect([isSeen(outlines, 4), isSeen(outlines, 1)]).toEqual([true, false]);
    expect(mesh.layers.mask).toBe(2);
  });

  test('without a mesh are the default layers', () => {
    const { layers }: { layers: Layers } = new HatchingOutlines();
    expect(layers.mask).toBe(1);
    layers.set(2);
    expect(layers.mask).toBe(4);
  });
});

test('renderOrder is that of the mesh, unless the outlines have their own', () => {
  const { mesh, outlines } = outlined(box, new MeshBasicMaterial());
  mesh.renderOrder = 7;
  expect(outlines.renderOrder).toBe(7);
  expect((mesh.clone().children[0] as HatchingOutlines).renderOrder).toBe(7);
  outlines.renderOrder = 9;
  mesh.renderOrder = 3;
  expect(outlines.renderOrder).toBe(9);
});

describe('a mesh with one material', () => {
  test('passes its opacity on to its outlines, which are not drawn at 0', () => {
    const material = faded(0.25);
    const { outlines } = outlined(box, material, { opacity: 0.5 });
    expect(draw(outlines)).toMatchObject([{ opacity: 0.25 }]);
    material.opacity = 0.75;
    expect(draw(outlines), 'lines do not fade twice').toMatchObject([{ opacity: 0.5 }]);
    expect(outlines.material.opacity).toBe(0.5);
    material.opacity = 0;
    expect(draw(outlines)).toEqual([]);
    material.transparent = false;
    expect(draw(outlines)).toMatchObject([{ opacity: 0.5 }]);
    material.colorWrite = false;
    expect(draw(outlines)).toEqual([]);
  });

  test('whose outlines share a material with others fades alone', () => {
    const shared = new HatchingOutlineMaterial({ weights: { suggestiveContours: 1 } });
    const renderer = new NotingRenderer();
    const make = (material: Material) => {
      const mesh = new Mesh(box, material);
      mesh.add(new HatchingOutlines(mesh, shared));
      return mesh.children[0] as HatchingOutlines;
    };
    const [one, other] = [make(faded(0.25)), make(new MeshBasicMaterial({ depthTest: false }))];
    for (let i = 0; i < 2; i++) {
      expect(renderer.draw(one)).toMatchObject([{ opacity: 0.25, depthTest: true }]);
      expect(renderer.draw(other)).toMatchObject([{ opacity: 1, depthTest: false }]);
    }
    expect(shared.depthTest).toBe(true);
  });
});

describe('groups', () => {
  const whole = () => draw(outlined(box, new MeshBasicMaterial()).outlines)[0].primitives;

  test('whose outlines look alike are drawn in one draw', () => {
    const colours = Array.from({ length: 6 }, (_, i) => new MeshBasicMaterial({ color: i }));
    expect(draw(outlined(box, colours).outlines)).toMatchObject([{ primitives: whole(), opacity: 1 }]);
  });

  test('without a visible material have no outlines', () => {
    const material = new MeshBasicMaterial();
    const hidden = new MeshBasicMaterial({ visible: false });
    // A side of two triangles shares four edges with others, which have borders there.
    const primitives = whole() - 2;
    for (const materials of [
      [material, material, material, hidden, material, material],
      [material, material, material, undefined!, material, material],
      [material, material, material, faded(0), material, material],
    ])
      expect(draw(outlined(box, materials).outlines)).toMatchObject([{ primitives }]);
    expect(draw(outlined(box, [material]).outlines)[0].primitives).toBe(2 + 4);
    expect(draw(outlined(box, []).outlines)).toEqual([]);
  });

  test('that fade do so separately, and share no edge with those that do not', () => {
    const materials: Material[] = Array.from({ length: 6 }, () => new MeshBasicMaterial());
    materials[3] = faded(0.5);
    const { outlines } = outlined(box, materials);
    const draws = draw(outlines);
    expect(draws).toMatchObject([{ opacity: 1 }, { opacity: 0.5, primitives: 2 }]);
    expect(draws[0].primitives).toBe(whole() - 2);
    materials[3].opacity = 0.25;
    expect(draw(outlines)[1].opacity).toBe(0.25);
    materials[3].opacity = 1;
    expect(draw(outlines)).toMatchObject([{ opacity: 1, primitives: whole() }]);
  });
});

test('outlines that change from frame to frame are drawn as new ones would be', () => {
  const random = randomNumbers(7);
  const pick = (count: number): number => Math.floor(count * random());
  const geometry = box.clone();
  const looks = [
    {},
    {},
    { opacity: 0.5 },
    { opacity: 0.25 },
    { visible: false },
    { depthTest: false },
    { alphaTest: 0.1 },
  ];
  const materials: Material[] = Array.from({ length: 4 }, () => new MeshBasicMaterial({ transparent: true }));
  const { mesh, outlines } = outlined(geometry, materials);
  const renderer = new NotingRenderer();
  const counts = new Set<number>();
  for (let frame = 0; frame < 300; frame++) {
    const what = pick(8);
    if (what < 4) {
      const plain = { opacity: 1, visible: true, depthTest: true, alphaTest: 0, transparent: true };
      Object.assign(materials[what], plain, looks[pick(looks.length)]);
    } else if (what === 4) geometry.setDrawRange(6 * pick(3), 6 * (2 + pick(6)));
    else if (what === 5) geometry.groups[pick(6)].materialIndex = pick(5);
    else if (what === 6) [materials[0], materials[1]] = [materials[1], materials[0]];
    const { outlines: fresh } = outlined(geometry, mesh.material as Material[]);
    const drawn = renderer.draw(outlines);
    expect(drawn, `frame ${frame}`).toEqual(draw(fresh));
    counts.add(drawn.length);
  }
  expect(counts.size).toBeGreaterThan(2);
});

test('a draw range is followed when it changes, and ends in borders', () => {
  const { mesh, outlines } = outlined(plane, new MeshBasicMaterial());
  const [all] = draw(outlines);
  expect(all.primitives).toBeGreaterThanOrEqual(8 + 10);
  mesh.geometry.setDrawRange(0, 12);
  // Half of the columns: their triangles, and the borders around them. Flat edges between triangles hold no outline.
  const [half] = draw(outlines);
  expect(half.primitives).toBeLessThan(all.primitives);
  expect(half.primitives).toBeGreaterThanOrEqual(4 + 4);
  mesh.geometry.setDrawRange(0, 0);
  expect(draw(outlines)).toEqual([]);
  mesh.geometry.setDrawRange(0, Infinity);
  expect(draw(outlines)).toEqual([all]);
});

test('a part has a list once it is unchanged, and the code of lists is there', async () => {
  const { mesh, outlines } = outlined(box, new MeshBasicMaterial(), { weights: { suggestiveContours: 0 } });
  const renderer = new NotingRenderer();
  mesh.geometry.setDrawRange(0, 24);
  expect(renderer.draw(outlines)[0].primitives).toBe(8 + 12);
  await vi.waitFor(() => expect(renderer.draw(outlines)[0].primitives).toBeLessThan(8 + 12));
  mesh.geometry.setDrawRange(0, Infinity);
});

describe('outlines that lie elsewhere than on their mesh', () => {
  test('are drawn where the mesh is reached, and not where one of its ancestors is hidden', () => {
    const scene = new Scene();
    const group = new Group();
    const mesh = new Mesh(box, new MeshBasicMaterial());
    const outlines = new HatchingOutlines(mesh);
    scene.add(group, outlines);
    const renderer = new NotingRenderer();
    expect(renderer.draw(outlines, scene)).toEqual([]);
    group.add(mesh);
    expect(renderer.draw(outlines, scene)).toHaveLength(1);
    group.visible = false;
    expect(renderer.draw(outlines, scene)).toEqual([]);
    scene.attach(mesh);
    expect(renderer.draw(outlines, scene)).toHaveLength(1);
    mesh.visible = false;
    expect(renderer.draw(outlines, scene)).toEqual([]);
  });
});

test('hooks of the mesh before and after drawing run only once', () => {
  const { mesh, outlines } = outlined(box, [new MeshBasicMaterial(), faded(0.5)]);
  mesh.onBeforeRender = vi.fn();
  mesh.onAfterRender = vi.fn();
  expect(draw(outlines)).toHaveLength(2);
  expect(mesh.onBeforeRender).not.toHaveBeenCalled();
  expect(mesh.onAfterRender).not.toHaveBeenCalled();
});

test('a material that overrides all others draws no outlines', () => {
  const { outlines } = outlined(box, new MeshBasicMaterial({ blendEquation: AddEquation }));
  const renderer = new NotingRenderer();
  const camera = new PerspectiveCamera();
  const scene = sceneOf(outlines);
  outlines.onBeforeRender(
    renderer as unknown as WebGLRenderer,
    scene,
    camera,
    outlines.geometry,
    new MeshBasicMaterial(),
  );
  expect(outlines.geometry.drawRange.count).toBe(-1);
});
