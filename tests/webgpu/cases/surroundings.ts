import { DoubleSide, FogExp2, type Material, Mesh, Plane, SphereGeometry, Vector3 } from 'three';
import { mrt, normalView, output, pass } from 'three/tsl';
import { ClippingGroup } from 'three/webgpu';
import {
  type HatchingMaterialParameters,
  type HatchingOutlineParameters,
  HatchingOutlines,
  prepareHatchingGeometry,
} from 'three-hatching';
import { HatchingOutlines as NodeOutlines } from 'three-hatching/webgpu';
import { bentTube } from '../deforming.js';
import { type KnotStage, knot } from '../knot.js';
import type { Kit, SceneCase, Stage } from '../SceneCase.js';

const LINES = {
  technique: 'engraving',
  direction: 'slant',
  shadowStrokes: 'tone',
  composition: { exposure: 1 },
} as const;

type Look = Pick<HatchingOutlineParameters, 'hidden'>;
type Outlined = KnotStage & { outlines: HatchingOutlines | NodeOutlines };

/** Gives a mesh outlines. */
async function outline({ either }: Kit, mesh: Mesh, look: Look = {}): Promise<Outlined['outlines']> {
  mesh.geometry = await prepareHatchingGeometry(mesh.geometry, { outlines: true });
  const outlines = either(
    () => new HatchingOutlines(mesh, { outlineWidth: 3, ...look }),
    () => new NodeOutlines(mesh, { outlineWidth: 3, ...look }),
  );
  mesh.add(outlines);
  return outlines;
}

/** An engraved knot with outlines, before a ball. */
async function outlined(kit: Kit, parameters: HatchingMaterialParameters = {}, look?: Look): Promise<Outlined> {
  const stage = knot(await kit.hatching({ ...LINES, ...parameters }));
  const ball = new Mesh(new SphereGeometry(0.5, 40, 30), await kit.hatching(LINES));
  ball.position.set(-0.6, 0.4, -1);
  stage.scene.add(ball);
  await outline(kit, ball);
  return { ...stage, outlines: await outline(kit, stage.mesh, look) };
}

const planes = (): Plane[] => [
  new Plane(new Vector3(-1, 0.2, 0.3).normalize(), 0.35),
  new Plane(new Vector3(0.3, -1, 0).normalize(), 0.3),
];

/** Clips by planes: those of the material in GLSL, and of a ClippingGroup for nodes. */
async function clipped(kit: Kit, clipIntersection: boolean, look?: Look): Promise<Stage> {
  const stage = await outlined(kit, { side: DoubleSide }, look);
  const clippingPlanes = planes();
  kit.either<void, void>(
    () => {
      stage.scene.traverse((object) => {
        const { material } = object as { material?: Material };
        if (material) Object.assign(material, { clippingPlanes, clipIntersection });
      });
    },
    () => {
      const group = new ClippingGroup();
      Object.assign(group, { clippingPlanes, clipIntersection });
      group.add(...stage.scene.children.filter((one) => one instanceof Mesh));
      stage.scene.add(group);
    },
  );
  return stage;
}

/** Clipping planes, depth buffers, passes and fog. */
export const cases: readonly SceneCase[] = [
  { name: 'clipped by each of two planes', show: (kit) => clipped(kit, false) },
  { name: 'clipped where two planes meet', show: (kit) => clipped(kit, true) },
  { name: 'hidden outlines, clipped', show: (kit) => clipped(kit, false, { hidden: 'faint' }) },
  { name: 'logarithmic depth', depth: 'logarithmic', show: (kit) => outlined(kit) },
  { name: 'reversed depth', depth: 'reversed', show: (kit) => outlined(kit) },
  {
    name: 'a camera whose pictures are turned, as those of a CubeCamera',
    async show(kit) {
      const stage = await outlined(kit);
      stage.camera.fov *= -1;
      stage.camera.updateProjectionMatrix();
      return stage;
    },
  },
  {
    name: 'outlines on half transparent surfaces',
    show: (kit) => outlined(kit, { transparent: true, opacity: 0.5 }),
  },
  {
    name: 'half transparent outlines',
    async show(kit) {
      const stage = await outlined(kit);
      stage.outlines.material.opacity = 0.4;
      return stage;
    },
  },
  {
    name: 'from within an even fog, which leaves one alone',
    async show(kit) {
      const stage = await outlined(kit, { fog: false });
      stage.scene.fog = new FogExp2(0x8899aa, 0.25);
      return stage;
    },
  },
  {
    name: 'through a pass',
    show: async (kit) => ({ ...(await outlined(kit)), through: (scene, camera) => pass(scene, camera) }),
  },
  {
    name: 'through a pass that has normals too, and outlines of a skin',
    async show(kit) {
      const stage = await outlined(kit);
      const tube = bentTube(await kit.hatching(LINES));
      tube.scale.setScalar(0.5);
      tube.position.set(0.6, 0.4, 0.8);
      stage.scene.add(tube);
      await outline(kit, tube);
      return {
        ...stage,
        through(scene, camera) {
          const both = pass(scene, camera);
          both.setMRT(mrt({ output, normal: normalView }));
          return both.getTextureNode('output');
        },
      };
    },
  },
];
