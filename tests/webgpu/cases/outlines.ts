import {
  BoxGeometry,
  type BufferGeometry,
  DataTexture,
  Fog,
  HemisphereLight,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  OrthographicCamera,
  PointLight,
  SphereGeometry,
  SpotLight,
  TorusKnotGeometry,
} from 'three';
import { HatchingOutlines, prepareHatchingGeometry } from 'three-hatching';
import { HatchingOutlines as NodeOutlines } from 'three-hatching/webgpu';
import { loadIntersections } from '../../../src/material/outlines/loadIntersections.js';
import { strips } from '../../gpu/strips.js';
import { knot } from '../knot.js';
import type { Kit, SceneCase, Stage } from '../SceneCase.js';

type Look = NonNullable<ConstructorParameters<typeof HatchingOutlines>[1]> &
  NonNullable<ConstructorParameters<typeof NodeOutlines>[1]>;
type Outlines = HatchingOutlines | NodeOutlines;

/** A mesh of one tone with outlines, in place of the knot. */
type Outlined = ReturnType<typeof knot> & { outlines: Outlines; kit: Kit };

const outlinesOf = ({ either }: Kit, mesh: Mesh, look: Look): Outlines =>
  either(
    () => new HatchingOutlines(mesh, look),
    () => new NodeOutlines(mesh, look),
  );

const ofKnot = (): BufferGeometry => new TorusKnotGeometry(0.62, 0.24, 96, 20);

const paper = (): MeshBasicMaterial => new MeshBasicMaterial({ color: 0xfff4dd });

const show =
  (look: Look, geometry = ofKnot, arrange: (stage: Outlined) => Partial<Stage> = () => ({})) =>
  async (kit: Kit): Promise<Stage> => {
    const stage = knot(paper());
    stage.mesh.geometry = await prepareHatchingGeometry(geometry(), { outlines: true });
    const outlines = outlinesOf(kit, stage.mesh, look);
    stage.mesh.add(outlines);
    return { ...stage, ...arrange({ ...stage, outlines, kit }) };
  };

/** An open box, which has borders. */
function openBox(): BufferGeometry {
  const box = new BoxGeometry(1.2, 0.9, 0.8);
  return box.setIndex([...box.getIndex()!.array].slice(0, 30));
}

/** Instances that are turned, stretched and moved. */
function instances({ mesh, kit, scene }: Outlined, look: Look): InstancedMesh {
  mesh.visible = false;
  const many = new InstancedMesh(mesh.geometry, paper(), 5);
  for (let i = 0; i < many.count; i++) {
    const place = new Matrix4().makeRotationY(0.7 * i).multiply(new Matrix4().makeScale(0.3 + 0.05 * i, 0.4, 0.35));
    many.setMatrixAt(i, place.setPosition(0.8 * Math.cos(1.3 * i), 0.8 * Math.sin(1.3 * i), 0.2 * i));
  }
  many.computeBoundingSphere();
  many.add(outlinesOf(kit, many, look));
  scene.add(many);
  return many;
}

export const cases: readonly SceneCase[] = [
  { name: 'a knot', show: show({ outlineWidth: 3 }) },
  {
    name: 'creases and borders of a box',
    show: show({ outlineWidth: 4, overshoot: 6 }, openBox, ({ mesh }) => {
      mesh.rotation.set(0.5, 0.6, 0.2);
      return {};
    }),
  },
  {
    name: 'suggestive contours by an unsteady hand, blue, half opaque',
    show: show({
      ...{
        outlineWidth: 3,
        weights: { suggestiveContours: 0.8 },
        wobble: 3,
        accents: 2,
        taper: 0.2,
        ink: 0x2244aa,
        opacity: 0.5,
      },
      transparent: true,
    }),
  },
  { name: 'leaves that crowd, and one alone', show: show({ outlineWidth: 3 }, () => strips(40)) },
  {
    name: 'chalk, by an unsteady hand',
    show: show({ outlineWidth: 9, paperGrain: 0.8, paperGrainSize: 4, wobble: 1 }),
  },
  {
    name: 'hidden outlines, dashed',
    show: show({ outlineWidth: 3, weights: { creases: 1 }, hidden: 'dashed' }, openBox, ({ mesh }) => {
      mesh.rotation.set(0.5, 0.6, 0.2);
      return {};
    }),
  },
  {
    name: 'lines where a ball cuts a knot, and hidden ones',
    async show(kit) {
      const look = { outlineWidth: 4, weights: { intersections: 1 }, intersections: true, hidden: 'faint' } as const;
      const stage = await show(look)(kit);
      const ball = new Mesh(
        await prepareHatchingGeometry(new SphereGeometry(0.5, 48, 32), { outlines: true }),
        paper(),
      );
      ball.position.set(0.5, 0.2, 0.1);
      ball.add(outlinesOf(kit, ball, look));
      stage.scene.add(ball);
      await (await loadIntersections()).settleIntersections(stage.scene);
      return stage;
    },
  },
  { name: 'hidden outlines, faint', show: show({ outlineWidth: 3, hidden: 'faint' }) },
  {
    name: 'lights of every kind',
    show: show({ outlineWidth: 4, weights: { lit: 0.2, shade: 3 }, lostEdges: 0.8 }, ofKnot, ({ scene, sun }) => {
      sun.intensity = 0.5;
      const point = new PointLight(0xffddaa, 5, 3, 1.5);
      point.position.set(-1, 1, 1);
      const spot = new SpotLight(0xaaddff, 30, 0, 0.35, 0.5);
      spot.position.set(1, -2, 2);
      scene.add(point, spot, new HemisphereLight(0xffffff, 0x334422, 1.5));
      return {};
    }),
  },
  {
    name: 'an orthographic camera, from within a fog',
    show: show({ outlineWidth: 3 }, ofKnot, ({ scene }) => {
      const camera = new OrthographicCamera(-1.1, 1.1, 1.1, -1.1, 0.1, 20);
      camera.position.set(1, 1, 3);
      camera.lookAt(0, 0, 0);
      scene.fog = new Fog(0xbbccff, 2.5, 4.5);
      return { camera };
    }),
  },
  {
    name: 'what lies before the near plane',
    show: show(
      { outlineWidth: 4, weights: { creases: 1 } },
      () => new BoxGeometry(6, 1, 1),
      ({ camera, mesh }) => {
        camera.position.set(0, 0.9, 1.2);
        camera.lookAt(0.6, 0, 0);
        mesh.rotation.y = 0.9;
        return {};
      },
    ),
  },
  {
    name: 'sides of a box that fade, are hidden or pass every test',
    show: show(
      { outlineWidth: 4, weights: { creases: 1 } },
      () => new BoxGeometry(1.2, 0.9, 0.8),
      ({ mesh }) => {
        mesh.rotation.set(0.5, 0.6, 0.2);
        const materials = Array.from({ length: 6 }, paper);
        Object.assign(materials[0], { transparent: true, opacity: 0.5 });
        materials[2].visible = false;
        materials[3].depthTest = false;
        (mesh as Mesh).material = materials;
        return {};
      },
    ),
  },
  {
    name: 'a box that a picture cuts away in part, with what is hidden of it',
    show: show(
      { outlineWidth: 4, weights: { creases: 1 }, hidden: 'faint' },
      () => new BoxGeometry(1.2, 0.9, 0.8),
      ({ mesh }) => {
        mesh.rotation.set(0.5, 0.6, 0.2);
        const map = new DataTexture(Uint8Array.of(255, 255, 255, 255, 255, 255, 255, 0), 2, 1);
        map.needsUpdate = true;
        Object.assign(mesh.material, { map, alphaTest: 0.5 });
        return {};
      },
    ),
  },
  {
    name: 'instances, of which one is hidden by its scale',
    show: show({}, ofKnot, (stage) => {
      const many = instances(stage, { outlineWidth: 2.5 });
      many.setMatrixAt(1, new Matrix4().makeScale(0, 0, 0));
      return {};
    }),
  },
  {
    name: 'instances',
    show: show({}, ofKnot, (stage) => {
      instances(stage, { outlineWidth: 2.5 });
      return {};
    }),
  },
  {
    name: 'instances that move',
    show: show({}, ofKnot, (stage) => {
      const many = instances(stage, { outlineWidth: 2.5 });
      return {
        change() {
          many.setMatrixAt(0, new Matrix4().makeScale(0.6, 0.6, 0.6));
          many.instanceMatrix.needsUpdate = true;
          many.computeBoundingSphere();
        },
      };
    }),
  },
  {
    name: 'two looks, of which one changes',
    show: show({ outlineWidth: 2 }, ofKnot, ({ camera, kit, outlines, scene, mesh }) => {
      const ball = new Mesh(mesh.geometry, paper());
      ball.scale.setScalar(0.6);
      ball.position.set(0.5, -0.4, 1);
      ball.add(outlinesOf(kit, ball, { outlineWidth: 5, ink: 0xaa2211 }));
      scene.add(ball);
      return {
        change() {
          outlines.material.outlineWidth = 4;
          outlines.material.ink.set(0x0044ff);
          outlines.material.wobble = 2;
          camera.position.x = 1.5;
          camera.lookAt(0, 0, 0);
        },
      };
    }),
  },
  {
    name: 'two meshes of one material, of which one gets another geometry',
    async show(kit) {
      const stage = await show({ outlineWidth: 3 })(kit);
      const [mesh] = stage.scene.children.filter((one): one is Mesh => one instanceof Mesh);
      const [outlines] = mesh.children as Outlines[];
      const ball = new Mesh(
        await prepareHatchingGeometry(new SphereGeometry(0.4, 24, 16), { outlines: true }),
        paper(),
      );
      ball.position.set(0.4, 0.5, 0.7);
      ball.add(
        kit.either<Outlines, Outlines>(
          () => new HatchingOutlines(ball, outlines.material as HatchingOutlines['material']),
          () => new NodeOutlines(ball, outlines.material as NodeOutlines['material']),
        ),
      );
      stage.scene.add(ball);
      const other = await prepareHatchingGeometry(openBox(), { outlines: true });
      return {
        ...stage,
        change() {
          mesh.geometry = other;
        },
      };
    },
  },
];
