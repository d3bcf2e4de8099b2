import {
  CylinderGeometry,
  Fog,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  OrthographicCamera,
  Plane,
  SphereGeometry,
  TorusKnotGeometry,
  Vector3,
} from 'three';
import { ClippingGroup } from 'three/webgpu';
import { HatchingOutlines, prepareHatchingGeometry } from 'three-hatching';
import { HatchingOutlines as NodeOutlines } from 'three-hatching/webgpu';
import { loadIntersections } from '../../../src/material/outlines/loadIntersections.js';
import { bentTube, egg } from '../deforming.js';
import { knot } from '../knot.js';
import type { Kit, SceneCase, Stage } from '../SceneCase.js';

type Look = NonNullable<ConstructorParameters<typeof HatchingOutlines>[1]> &
  NonNullable<ConstructorParameters<typeof NodeOutlines>[1]>;

/** Nothing but lines where parts meet, so that a picture without them has two colours. */
const LOOK: Look = {
  ...{ outlineWidth: 5, intersections: true },
  weights: { contours: 0, innerContours: 0, borders: 0, creases: 0, materialBorders: 0, intersections: 1 },
};

/** Adds outlines to a mesh. */
async function outlined<Part extends Mesh>({ either }: Kit, mesh: Part, look: Look = LOOK): Promise<Part> {
  mesh.geometry = await prepareHatchingGeometry(mesh.geometry, { outlines: true });
  mesh.add(
    either<HatchingOutlines, NodeOutlines>(
      () => new HatchingOutlines(mesh, look),
      () => new NodeOutlines(mesh, look),
    ),
  );
  return mesh;
}

const paper = (): MeshBasicMaterial => new MeshBasicMaterial({ color: 0xfff4dd, fog: false });
const ball = (): Mesh => new Mesh(new SphereGeometry(0.5, 48, 32), paper());

/** A scene with parts in place of the knot. @param move moves them after the first frame, which fetches the code of moving lines */
async function stageOf(parts: readonly Mesh[], move: () => void = () => {}): Promise<Stage> {
  const { scene, camera, mesh } = knot(paper());
  scene.remove(mesh);
  scene.add(...parts);
  await (await loadIntersections()).settleIntersections(scene);
  return {
    ...{ scene, camera },
    async change() {
      // The frame has asked for the same before.
      await import('../../../src/material/outlines/MovingLines.js');
      await import('../../../src/webgpu/outlines/NodeMovingLines.js');
      move();
    },
  };
}

export const cases: readonly SceneCase[] = [
  {
    name: 'parts that move, in two inks, in a fog',
    async show(kit) {
      const still = new Mesh(new TorusKnotGeometry(0.62, 0.24, 96, 20), paper());
      const parts = [
        await outlined(kit, still),
        await outlined(kit, ball(), { ...LOOK, ink: 0xaa2211 }),
        await outlined(kit, ball(), { ...LOOK, paperGrain: 0.5 }),
      ];
      const [, red, grainy] = parts;
      red.position.set(0.5, 0.2, 0.1);
      grainy.position.set(-0.4, -0.4, 0.3);
      const stage = await stageOf(parts, () => {
        red.position.y += 0.1;
        grainy.position.x += 0.1;
      });
      red.position.x += 0.1;
      stage.scene.fog = new Fog(0xbbccff, 2.5, 6);
      return stage;
    },
  },
  {
    name: 'instances, a tube that bends and an egg, in a parallel projection',
    async show(kit) {
      const many = new InstancedMesh(new SphereGeometry(0.5, 48, 32), paper(), 4);
      for (let i = 0; i < many.count; i++) {
        many.setMatrixAt(i, new Matrix4().makeScale(1, 0.7, 1).setPosition(0.45 * i - 0.6, 0.25 * i - 0.5, 0.1 * i));
      }
      many.computeBoundingSphere();
      const parts = [
        await outlined(kit, many),
        await outlined(kit, bentTube(paper())),
        await outlined(kit, egg(paper())),
      ];
      parts[2].position.set(0.2, 0.6, -0.3);
      const camera = new OrthographicCamera(-1.4, 1.4, 1.4, -1.4, 0.1, 20);
      camera.position.set(1, 1, 3);
      camera.lookAt(0, 0, 0);
      return { ...(await stageOf(parts)), camera };
    },
  },
  {
    name: 'parts of which one is clipped',
    async show(kit) {
      const [still, cut] = [ball(), ball()];
      const parts = [await outlined(kit, still), await outlined(kit, cut)];
      still.position.x = -0.25;
      cut.position.x = 0.25;
      const stage = await stageOf(parts, () => {
        cut.position.y = 0.1;
      });
      cut.position.z = 0.2;
      const clippingPlanes = [new Plane(new Vector3(0, 1, 0), 0.1)];
      kit.either(
        () => Object.assign(cut.material, { clippingPlanes }),
        () => stage.scene.add(Object.assign(new ClippingGroup(), { clippingPlanes }).add(cut)),
      );
      return stage;
    },
  },
  {
    name: 'a rod and instances that move through glass',
    async show(kit) {
      const glass = new Mesh(new SphereGeometry(0.8, 48, 32), paper());
      Object.assign(glass.material, { transparent: true, opacity: 0.3, depthWrite: false });
      const rod = new Mesh(new CylinderGeometry(0.15, 0.15, 2.2, 32), paper());
      const beads = new InstancedMesh(new SphereGeometry(0.3, 32, 24), glass.material, 2);
      beads.setMatrixAt(0, new Matrix4().setPosition(0.7, -0.3, 0));
      beads.setMatrixAt(1, new Matrix4().setPosition(-0.7, 0.3, 0));
      beads.computeBoundingSphere();
      // Renderers draw what is as near in an order of their own, and instances by other centres.
      beads.position.z = 0.5;
      rod.rotation.set(0.5, 0, 1.1);
      const parts = [await outlined(kit, glass), await outlined(kit, rod), await outlined(kit, beads)];
      const stage = await stageOf(parts, () => {
        rod.position.y = -0.1;
      });
      rod.position.x = 0.1;
      return stage;
    },
  },
];
