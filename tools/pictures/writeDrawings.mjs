/**
 * `npm run build:lib && node tools/pictures/writeDrawings.mjs`: draws the three vector files of docs/svg.md from the built library, without
 * a browser.
 */
import { mkdirSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import {
  Box3,
  BoxGeometry,
  CylinderGeometry,
  DirectionalLight,
  ExtrudeGeometry,
  Group,
  LatheGeometry,
  Mesh,
  MeshLambertMaterial,
  Path,
  PerspectiveCamera,
  Scene,
  Shape,
  Sphere,
  SphereGeometry,
  SplineCurve,
  Vector2,
} from 'three';
import { applyHatching, HatchingOutlines } from '../../dist/index.js';
import { drawSVG } from '../../dist/svg.js';

const folder = fileURLToPath(new URL('../../docs/drawings/', import.meta.url));

/** A vase and a ball beside it. */
function still() {
  const radii = [0.001, 0.34, 0.36, 0.28, 0.44, 0.62, 0.66, 0.54, 0.34, 0.22, 0.21, 0.27, 0.38];
  const profile = new SplineCurve(radii.map((radius, i) => new Vector2(radius, 0.17 * Math.max(0, i - 1) - 0.9)));
  const vase = new Mesh(new LatheGeometry(profile.getPoints(80), 64), new MeshLambertMaterial());
  const ball = new Mesh(new SphereGeometry(0.34, 64, 48), new MeshLambertMaterial());
  ball.position.set(0.75, -0.56, 0.45);
  return new Group().add(vase, ball);
}

/** A bracket with a hole in its foot and one in its wall. */
function bracket() {
  const plate = (width, height, hole) => {
    const shape = new Shape()
      .moveTo(-width / 2, 0)
      .lineTo(width / 2, 0)
      .lineTo(width / 2, height)
      .lineTo(-width / 2, height);
    shape.closePath();
    shape.holes.push(new Path().absarc(0, hole, 0.22, 0, 2 * Math.PI, true));
    return new ExtrudeGeometry(shape, { depth: 0.22, bevelEnabled: false, curveSegments: 32 });
  };
  const wall = new Mesh(plate(1.4, 1.3, 0.8), new MeshLambertMaterial());
  const foot = new Mesh(plate(1.4, 1.3, 0.75).rotateX(Math.PI / 2), new MeshLambertMaterial());
  foot.position.y = 0.22;
  const pin = new Mesh(new CylinderGeometry(0.2, 0.2, 0.9, 48), new MeshLambertMaterial());
  pin.position.set(0, 0.35, 0.75);
  const rib = new Mesh(new BoxGeometry(0.16, 0.5, 0.5), new MeshLambertMaterial());
  rib.position.set(0.5, 0.47, 0.47);
  return new Group().add(wall, foot, pin, rib);
}

/** Draws a group as the page would light it, in a picture of 10 × 10 cm. */
async function draw(name, title, group, view, preset, options) {
  const scene = new Scene().add(group);
  const { center, radius } = new Box3().setFromObject(group).getBoundingSphere(new Sphere());
  const light = new DirectionalLight('white', Math.PI);
  light.position.set(-0.55, 0.8, 0.6).multiplyScalar(5);
  light.castShadow = true;
  scene.add(light);
  group.traverse((object) => {
    object.castShadow = object.receiveShadow = 'isMesh' in object;
  });
  const camera = new PerspectiveCamera(24, 1, 0.1, 50);
  camera.position
    .set(...view)
    .setLength(radius / Math.sin((12 * Math.PI) / 180) / 0.95)
    .add(center);
  camera.lookAt(center);
  await applyHatching(scene, { preset });
  if (preset === 'technical')
    scene.traverse((object) => {
      if (object instanceof HatchingOutlines) object.material.hidden = 'dashed';
    });
  const { svg, paths, seconds } = await drawSVG(scene, camera, { sheet: [100, 100], margin: 3, ...options });
  writeFileSync(`${folder}${name}.svg`, svg.replace('\n', `\n<title>${title}</title>\n`));
  console.log(`${name}: ${paths} paths, ${Math.round(svg.length / 1000)} kB, ${seconds.toFixed(1)} s`);
}

mkdirSync(folder, { recursive: true });
await draw('print', 'A vase and a ball, engraved', still(), [0.5, 0.45, 2], 'engraving', { shadows: 'hard' });
await draw('pen', 'A vase and a ball, in strokes of one pen', still(), [0.5, 0.45, 2], 'engraving', {
  kind: 'pen',
  penWidth: 0.35,
  shadows: 'hard',
});
await draw('hidden', 'A bracket with a pin, its hidden edges dashed', bracket(), [1.1, 0.9, 1.6], 'technical', {
  shadows: false,
  dpi: 72,
});
