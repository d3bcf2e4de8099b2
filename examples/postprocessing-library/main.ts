import { BlendFunction, EffectComposer, EffectPass, NoiseEffect, RenderPass, VignetteEffect } from 'postprocessing';
import {
  Color,
  DirectionalLight,
  HalfFloatType,
  Mesh,
  PerspectiveCamera,
  Scene,
  TorusKnotGeometry,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { HatchingMaterial, HatchingOutlines, prepareHatchingGeometry, presets } from 'three-hatching';

const canvas = document.querySelector('canvas')!;
const renderer = new WebGLRenderer({ canvas, antialias: false, stencil: false, depth: false });
renderer.setPixelRatio(devicePixelRatio);

const geometry = await prepareHatchingGeometry(new TorusKnotGeometry(0.7, 0.26, 320, 40, 1, 2), { outlines: true });
const material = new HatchingMaterial({ preset: 'chalk' });
const mesh = new Mesh(geometry, material);
mesh.add(new HatchingOutlines(mesh, presets.chalk.outlines));

const light = new DirectionalLight(0xffffff, Math.PI);
light.position.set(-3, 4, 3);
const scene = new Scene().add(mesh, light);
scene.background = new Color(presets.chalk.material.paper);
const camera = new PerspectiveCamera(30, 4 / 3, 0.1, 20);
camera.position.set(0, 1, 4.2);

const composer = new EffectComposer(renderer, { frameBufferType: HalfFloatType, multisampling: 4 });
const dust = new NoiseEffect({ blendFunction: BlendFunction.OVERLAY });
dust.blendMode.opacity.value = 0.25;
composer.addPass(new RenderPass(scene, camera));
composer.addPass(new EffectPass(camera, dust, new VignetteEffect({ darkness: 0.55 })));

const draw = () => composer.render();
// Its map of strokes is drawn in a worker, and the code of dry media is fetched.
material.ready.then(draw);
new OrbitControls(camera, canvas).addEventListener('change', draw);
new ResizeObserver(() => {
  composer.setSize(canvas.clientWidth, canvas.clientHeight, false);
  draw();
}).observe(canvas);
