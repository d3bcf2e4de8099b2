import {
  BoxGeometry,
  type BufferGeometry,
  type Camera,
  DoubleSide,
  Float32BufferAttribute,
  Group,
  InstancedMesh,
  type Material,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  OrthographicCamera,
  PerspectiveCamera,
  PlaneGeometry,
  SphereGeometry,
  TorusKnotGeometry,
  Vector3,
} from 'three';
import { describe, expect, test } from 'vitest';
import { flatteringLight, prepareHatchingGeometry } from '../../../../src/index.js';
import { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';
import { shareOfShade } from '../../../../src/scene/lighting/chooseLight.js';
import { readTriangles } from '../../../../src/scene/lighting/readTriangles.js';
import { seenSurface } from '../../../../src/scene/lighting/seenSurface.js';

/** The share of light below which a surface looks less than half as bright as paper, by sRGB. */
const HALF_AS_BRIGHT = ((0.5 + 0.055) / 1.055) ** 2.4;

const plain = new MeshBasicMaterial();
const meshOf = (geometry: BufferGeometry, material: Material = plain): Mesh => new Mesh(geometry, material);
const ball = (): Mesh => meshOf(new SphereGeometry(1, 64, 48));
const knot = (): Mesh => meshOf(new TorusKnotGeometry(0.6, 0.25, 200, 24));

const flatCamera = (from: Vector3, half = 1.2): OrthographicCamera =>
  placed(new OrthographicCamera(-half, half, half, -half, 0.1, 20), from);
const camera = (from: Vector3): PerspectiveCamera => placed(new PerspectiveCamera(30, 1.4, 0.1, 100), from);

function placed<Kind extends Camera>(camera: Kind, from: Vector3): Kind {
  camera.position.copy(from);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  return camera;
}

/** The share of shade of an object as a camera sees it. */
function shadeOf(object: Object3D, camera: Camera, light: Vector3): number {
  object.updateMatrixWorld();
  return shareOfShade(seenSurface(readTriangles(object, camera)), light.clone().normalize().toArray());
}

/** The share of a disc under which a sphere is in shade, counted point by point. @param light in the viewer's space */
function shadeOfSphere(light: Vector3): number {
  const [x, y, z] = light.clone().normalize();
  let [dark, all] = [0, 0];
  for (let i = -0.9975; i < 1; i += 0.005) {
    for (let k = -0.9975; k < 1; k += 0.005) {
      const height = 1 - i * i - k * k;
      if (height <= 0) continue;
      all++;
      if (i * x + k * y + Math.sqrt(height) * z < HALF_AS_BRIGHT) dark++;
    }
  }
  return dark / all;
}

describe('the share of shade', () => {
  test.each([
    [0, 0, 1],
    [-1, 1, 1],
    [1, 0.2, 0],
    [0.5, 0.3, -1],
    [0, 0, -1],
  ])('of a sphere under a light at %f, %f, %f', (...light) => {
    const direction = new Vector3(...light);
    expect(
      Math.abs(shadeOf(ball(), flatCamera(new Vector3(0, 0, 5)), direction) - shadeOfSphere(direction)),
    ).toBeLessThan(0.02);
  });

  test.each([
    [[1, 1, 1], 0],
    [[1, 1, 0], 1 / 3],
    [[1, 0, 0], 2 / 3],
    [[1, 1, 0.3], 1 / 3],
    [[1, 1, 0.32], 0],
    [[-1, -1, -1], 1],
  ])('of a cube seen from a corner, under a light at %j', (light, share) => {
    const cube = meshOf(new BoxGeometry());
    expect(shadeOf(cube, flatCamera(new Vector3(3, 3, 3)), new Vector3(...light))).toBeCloseTo(share, 1.7);
  });

  test('does not count what is hidden or beyond the sheet, nor the backs of what is drawn from one side', () => {
    const wall = meshOf(new PlaneGeometry(4, 4), new MeshBasicMaterial({ side: DoubleSide }));
    const behind = ball().translateZ(-2);
    const beside = meshOf(new BoxGeometry())
      .translateX(3)
      .rotateY(Math.PI / 4);
    const fromFront = flatCamera(new Vector3(0, 0, 5));
    const light = new Vector3(0, 0.1, 1);
    expect(shadeOf(new Group().add(wall, behind, beside), fromFront, light)).toBe(0);
    const behindNothing = shadeOf(new Group().add(behind, beside), fromFront, light);
    expect(behindNothing).toBeGreaterThan(0.03);
    wall.visible = false;
    expect(shadeOf(new Group().add(wall, behind, beside), fromFront, light)).toBe(behindNothing);
    // Glass does not count, unless there is nothing else.
    wall.visible = true;
    (wall.material as Material).transparent = true;
    expect(shadeOf(new Group().add(wall, behind, beside), fromFront, light)).toBe(behindNothing);
    expect(seenSurface(readTriangles(wall, fromFront)).pixels.length).toBeGreaterThan(0);
    const leaf = meshOf(new PlaneGeometry().rotateY(Math.PI));
    const surface = seenSurface(readTriangles(leaf, fromFront));
    expect(surface.pixels).toHaveLength(0);
    leaf.scale.x = -1;
    leaf.updateMatrixWorld();
    expect(seenSurface(readTriangles(leaf, fromFront)).pixels).toHaveLength(0);
  });

  test('the nearer surface is seen, also in perspective', () => {
    const near = meshOf(new PlaneGeometry(2, 2).rotateX(-0.9)).translateZ(1);
    const far = meshOf(new PlaneGeometry(2, 2)).translateZ(-40);
    far.scale.setScalar(12);
    // The far surface is in shade. It would be larger on the sheet, but the near one covers its middle.
    const share = shadeOf(new Group().add(near, far), camera(new Vector3(0, 0, 6)), new Vector3(0, 1, 0.1));
    expect(share).toBeGreaterThan(0.1);
    expect(share).toBeLessThan(0.9);
  });

  test('baked occlusion counts as far as the material draws it', async () => {
    const material = new HatchingMaterial({ occlusion: 1 });
    const mesh = meshOf(await prepareHatchingGeometry(new PlaneGeometry(), { layout: 'indexed' }), material);
    const { hatchNormal } = mesh.geometry.attributes;
    const light = new Vector3(0, 0, 1);
    expect(shadeOf(mesh, flatCamera(light), light)).toBe(0);
    for (let i = 0; i < hatchNormal.count; i++) hatchNormal.setW(i, -0.9);
    expect(shadeOf(mesh, flatCamera(light), light)).toBe(1);
    material.occlusion = 0.5;
    expect(shadeOf(mesh, flatCamera(light), light)).toBe(0);
  });
});

describe('the pose', () => {
  test('morph targets and instances count where they are drawn', () => {
    const geometry = new PlaneGeometry();
    const tilted = new PlaneGeometry().rotateX(-Math.PI / 2);
    geometry.morphAttributes.position = [tilted.attributes.position as Float32BufferAttribute];
    const mesh = meshOf(geometry);
    const [fromAbove, light] = [flatCamera(new Vector3(0, 1, 1)), new Vector3(0, 1, 0)];
    expect(shadeOf(mesh, fromAbove, light)).toBe(1);
    mesh.morphTargetInfluences = [1];
    expect(shadeOf(mesh, fromAbove, light)).toBe(0);

    const many = new InstancedMesh(new PlaneGeometry(), plain, 2);
    many.setMatrixAt(0, new Matrix4().makeTranslation(-0.5, 0, 0));
    many.setMatrixAt(1, new Matrix4().makeRotationY(1.2).setPosition(0.5, 0, 0));
    const share = Math.cos(1.2) / (1 + Math.cos(1.2));
    const front = flatCamera(new Vector3(0, 0, 5), 2);
    expect(Math.abs(shadeOf(many, front, new Vector3(-1, 0, 0.3)) - share)).toBeLessThan(0.02);
  });
});

describe('the light', () => {
  const front = new Vector3(0.3, 0.6, 5);

  test('leaves about two fifths of a sphere in shade, from the upper front', () => {
    const view = camera(front);
    const { direction, shade } = flatteringLight(ball(), view);
    expect(Math.abs(shade - 0.4)).toBeLessThan(0.05);
    expect(shade).toBe(shadeOf(ball(), view, direction));
    expect(direction.length()).toBeCloseTo(1);
    const seen = direction.clone().transformDirection(view.matrixWorldInverse);
    expect(seen.x).toBeLessThan(-0.3);
    expect(seen.y).toBeGreaterThan(0.3);
    expect(seen.z).toBeGreaterThan(0.3);
  });

  test.each([
    ['the front', front],
    ['above', new Vector3(0, 5, 0.5)],
    ['below', new Vector3(1, -5, 2)],
    ['behind', new Vector3(-2, 1, -4)],
  ])('never comes from behind, seen from %s', (_, from) => {
    for (const object of [ball(), knot(), meshOf(new BoxGeometry())]) {
      const view = camera(from);
      const { direction, shade } = flatteringLight(object, view);
      const seen = direction.clone().transformDirection(view.matrixWorldInverse);
      expect(seen.z).toBeGreaterThan(0.1);
      expect(seen.y).toBeGreaterThan(0.2);
      expect(Math.abs(seen.x)).toBeGreaterThan(0.1);
      if (from.y > 0) expect(direction.y).toBeGreaterThan(Math.sin(Math.PI / 9) - 1e-6);
      expect([shade >= 0, shade <= 1]).toEqual([true, true]);
    }
  });

  test('comes from the right if that shows more', () => {
    // Two walls like an open book: the left one faces the viewer.
    const left = meshOf(new PlaneGeometry(1.2, 2)).translateX(-0.6);
    const right = meshOf(new PlaneGeometry(1, 2)).translateX(0.3).rotateY(-1.15);
    const mirrored = new Group().add(left, right);
    const { direction } = flatteringLight(mirrored, flatCamera(new Vector3(0, 0, 5)));
    mirrored.scale.x = -1;
    const other = flatteringLight(mirrored, flatCamera(new Vector3(0, 0, 5)));
    expect(Math.sign(other.direction.x)).toBe(-Math.sign(direction.x));
  });

  test('is the same twice, and after the scene was moved, turned or scaled with its camera', () => {
    const model = knot().rotateX(0.4);
    const view = camera(front);
    const whole = new Group().add(model, view);
    const first = flatteringLight(model, view);
    expect(flatteringLight(model, view)).toEqual(first);
    whole.position.set(30, -4, 7);
    whole.scale.setScalar(1000);
    const moved = flatteringLight(model, view);
    expect(moved.direction.distanceTo(first.direction)).toBeLessThan(1e-5);
    expect(moved.shade).toBeCloseTo(first.shade, 2);
    whole.rotation.y = 2;
    const turned = flatteringLight(model, view);
    expect(turned.direction.distanceTo(first.direction.clone().applyAxisAngle(view.up, 2))).toBeLessThan(1e-5);
    expect(turned.shade).toBeCloseTo(first.shade, 2);
  });

  test('of a dense mesh is that of a coarse one, though only some of its triangles are read', () => {
    const dense = meshOf(new SphereGeometry(1, 900, 700));
    expect(readTriangles(dense, camera(front)).count).toBeLessThan(50_000);
    const { direction, shade } = flatteringLight(dense, camera(front));
    const coarse = flatteringLight(ball(), camera(front));
    expect(direction.distanceTo(coarse.direction)).toBeLessThan(0.1);
    expect(Math.abs(shade - coarse.shade)).toBeLessThan(0.02);
    // Small meshes next to it are read whole.
    const small = meshOf(new BoxGeometry());
    expect(readTriangles(new Group().add(dense, small), camera(front)).isSample).toContain(0);
  });

  test('has a direction if nothing is seen, and if numbers are not finite', () => {
    for (const object of [new Group(), ball().translateZ(90), meshOf(broken())]) {
      const { direction, shade } = flatteringLight(object, camera(front));
      expect(direction.length()).toBeCloseTo(1);
      expect(shade).toBe(0);
    }
  });

  describe('of an object on the ground', () => {
    const post = (): Mesh => meshOf(new BoxGeometry(0.3, 1.6, 0.3));
    /** The reach of the shadow from the middle of the sheet. */
    const reachOf = (object: Mesh, view: Camera, light: Vector3): number => {
      const { position } = object.geometry.attributes;
      const ground = -0.8;
      let reach = 0;
      for (let i = 0; i < position.count; i++) {
        const corner = new Vector3().fromBufferAttribute(position, i);
        corner.addScaledVector(light, -(corner.y - ground) / light.y).project(view);
        reach = Math.max(reach, Math.abs(corner.x), Math.abs(corner.y));
      }
      return reach;
    };
    const narrow = (): PerspectiveCamera => placed(new PerspectiveCamera(30, 0.5, 0.1, 100), front);

    test('is higher, or from another side, so that the shadow stays on the sheet', () => {
      const [object, view] = [post(), narrow()];
      expect(reachOf(object, view, flatteringLight(object, view).direction)).toBeGreaterThan(1);
      const { direction } = flatteringLight(object, view, { onGround: true });
      expect(reachOf(object, view, direction)).toBeLessThanOrEqual(1.001);
      const corners = object.geometry.attributes.position.array;
      expect(flatteringLight(object, view, { onGround: corners }).direction).toEqual(direction);
    });

    test('is unchanged if the shadow stays on the sheet anyway', () => {
      const view = placed(new PerspectiveCamera(60, 2, 0.1, 100), front);
      expect(flatteringLight(post(), view, { onGround: true })).toEqual(flatteringLight(post(), view));
    });

    test('lets the shadow leave the sheet as little as possible if no light keeps it there', () => {
      const [object, view] = [post(), placed(new PerspectiveCamera(30, 0.12, 0.1, 100), front)];
      const { direction } = flatteringLight(object, view, { onGround: true });
      expect(reachOf(object, view, direction)).toBeLessThan(
        reachOf(object, view, flatteringLight(object, view).direction),
      );
    });

    test('counts all poses of a moving object', () => {
      const [object, view] = [post(), placed(new PerspectiveCamera(30, 1, 0.1, 100), front)];
      const still = flatteringLight(object, view, { onGround: true });
      const moving = flatteringLight(object, view, { onGround: [-0.9, -0.8, 0, 0.9, -0.8, 0, 0.9, 1, 0, -0.9, 1, 0] });
      expect(moving.direction.y).toBeGreaterThan(still.direction.y);
    });
  });

  test('needs an object and a camera', () => {
    expect(() => flatteringLight(ball(), camera(front), { ground: true } as never)).toThrow('ground');
    expect(() => flatteringLight({} as Object3D, camera(front))).toThrow('expected a THREE.Object3D');
    expect(() => flatteringLight(ball(), ball() as unknown as Camera)).toThrow('expected a THREE.Camera');
  });
});

/** A triangle with a corner that is not finite, and one with missing corners. */
function broken(): BufferGeometry {
  const geometry = new PlaneGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute([0, 0, 0, 1, 0, 0, Number.NaN, 1, 0], 3));
  geometry.setIndex([0, 1, 2, 7, 8, 9]);
  return geometry;
}
