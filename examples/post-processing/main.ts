import {
  Color,
  DirectionalLight,
  HalfFloatType,
  Mesh,
  PerspectiveCamera,
  Scene,
  TorusKnotGeometry,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { EffectComposer } from 'three/addons/postprocessing/EffectComposer.js';
import { OutputPass } from 'three/addons/postprocessing/OutputPass.js';
import { RenderPass } from 'three/addons/postprocessing/RenderPass.js';
import { ShaderPass } from 'three/addons/postprocessing/ShaderPass.js';
import { RGBShiftShader } from 'three/addons/shaders/RGBShiftShader.js';
import { HatchingMaterial, HatchingOutlines, prepareHatchingGeometry, presets } from 'three-hatching';

const canvas = document.querySelector('canvas')!;
const renderer = new WebGLRenderer({ canvas });
renderer.setPixelRatio(devicePixelRatio);

const geometry = await prepareHatchingGeometry(new TorusKnotGeometry(0.7, 0.24, 320, 40, 3, 5), { outlines: true });
const mesh = new Mesh(geometry, new HatchingMaterial({ preset: 'engraving' }));
mesh.add(new HatchingOutlines(mesh, presets.engraving.outlines));

const light = new DirectionalLight(0xffffff, Math.PI);
light.position.set(-3, 4, 3);
const scene = new Scene().add(mesh, light);
// The clear colour of the renderer would not do, because RenderPass treats it as linear.
scene.background = new Color('#f7f3e8');
const camera = new PerspectiveCamera(30, 4 / 3, 0.1, 20);
camera.position.set(0, 0, 5.2);

// The antialiasing of the canvas has no effect here, so the target of the composer has samples.
const composer = new EffectComposer(renderer, new WebGLRenderTarget(1, 1, { type: HalfFloatType, samples: 4 }));
composer.addPass(new RenderPass(scene, camera));
const shift = new ShaderPass(RGBShiftShader);
shift.uniforms.amount.value = 0.0025;
shift.uniforms.angle.value = 0.6;
composer.addPass(shift);
composer.addPass(new OutputPass());

const draw = () => composer.render();
// The code of its technique is fetched when it is first used.
mesh.material.ready.then(draw);
new OrbitControls(camera, canvas).addEventListener('change', draw);
new ResizeObserver(() => {
  renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
  composer.setSize(canvas.clientWidth, canvas.clientHeight);
  draw();
}).observe(canvas);
