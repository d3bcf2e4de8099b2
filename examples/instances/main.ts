import {
  BatchedMesh,
  ConeGeometry,
  CylinderGeometry,
  DirectionalLight,
  DodecahedronGeometry,
  IcosahedronGeometry,
  InstancedMesh,
  MathUtils,
  Mesh,
  MeshLambertMaterial,
  Object3D,
  OctahedronGeometry,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { applyHatching } from 'three-hatching';

const canvas = document.querySelector('canvas')!;
const renderer = new WebGLRenderer({ canvas, antialias: true });
renderer.setClearColor('#f7f3e8');
renderer.setPixelRatio(devicePixelRatio);
renderer.shadowMap.enabled = true;

const scene = new Scene();
const material = new MeshLambertMaterial();
const place = new Object3D();
/** Random numbers, which are the same every time. */
const within = (least: number, most: number) => MathUtils.lerp(least, most, MathUtils.seededRandom());
const heightAt = (x: number, z: number) => 1.5 * Math.exp(-(x * x + z * z) / 9) + 0.12 * Math.sin(1.3 * x + 0.8 * z);

const hill = new PlaneGeometry(24, 24, 120, 120).rotateX(-Math.PI / 2);
const { position } = hill.attributes;
for (let i = 0; i < position.count; i++) position.setY(i, heightAt(position.getX(i), position.getZ(i)));
hill.computeVertexNormals();
scene.add(new Mesh(hill, material));

// A single tree is drawn 90 times.
const tree = mergeGeometries([
  new CylinderGeometry(0.06, 0.08, 0.4, 12).translate(0, 0.2, 0),
  new ConeGeometry(0.42, 0.8, 20, 4).translate(0, 0.7, 0),
  new ConeGeometry(0.3, 0.7, 20, 4).translate(0, 1.15, 0),
  new ConeGeometry(0.18, 0.5, 20, 4).translate(0, 1.55, 0),
]);
const wood = new InstancedMesh(tree, material, 90);
for (let i = 0; i < wood.count; i++) {
  const [x, z] = [within(-4.5, 4.5), within(-4.5, 4.5)];
  place.position.set(x, heightAt(x, z), z);
  place.scale.setScalar(within(0.5, 1.1));
  place.updateMatrix();
  wood.setMatrixAt(i, place.matrix);
}
scene.add(wood);

// Stones of three kinds are drawn in one draw call.
const kinds = [new IcosahedronGeometry(0.2, 1), new DodecahedronGeometry(0.2), new OctahedronGeometry(0.2, 1)];
const stones = new BatchedMesh(36, 1000, 1000, material);
for (const kind of kinds.map((geometry) => stones.addGeometry(geometry))) {
  for (let i = 0; i < 12; i++) {
    const [x, z] = [within(-4, 4), within(1.5, 4.5)];
    place.position.set(x, heightAt(x, z), z);
    place.scale.setScalar(within(0.8, 2));
    place.rotation.set(i, 2 * i, 3 * i);
    place.updateMatrix();
    stones.setMatrixAt(stones.addInstance(kind), place.matrix);
  }
}
scene.add(stones);

scene.traverse((object) => {
  object.castShadow = object.receiveShadow = true;
});
await applyHatching(scene, { preset: 'pen', filter: (mesh) => mesh !== stones });
// A batch has no outlines.
await applyHatching(stones, { preset: 'pen', outlines: false });

const light = new DirectionalLight(0xffffff, Math.PI);
light.position.set(-6, 6, 2);
light.castShadow = true;
light.shadow.normalBias = 0.04;
light.shadow.mapSize.set(2048, 2048);
Object.assign(light.shadow.camera, { left: -8, right: 8, bottom: -8, top: 8 });
scene.add(light);

const camera = new PerspectiveCamera(26, 4 / 3, 0.1, 60);
camera.position.set(0, 3.4, 13);
const draw = () => renderer.render(scene, camera);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1.1, 0);
controls.addEventListener('change', draw);
controls.update();
new ResizeObserver(() => {
  renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
  draw();
}).observe(canvas);
