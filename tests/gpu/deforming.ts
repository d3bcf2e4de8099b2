/** The helpers for tests of meshes that deform, besides the toolkit: models that move, and the output of the pre-pass. */
import './toolkit.js';
import * as THREE from 'three';
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import type { HatchingMaterial, HatchingMaterialParameters } from 'three-hatching';
import { drawsLines } from '../../src/look/queries.js';
import { pulledVerticesOf } from '../../src/material/geometry/pulledVerticesOf.js';
import { plainLook } from '../../tools/plainLook.js';
import { reactive } from '../unit/material/geometry/reactive.js';

export interface DeformedVertex {
  position: number[];
  normal: number[];
}

/**
 * A tube along y from −1 to 1 for two bones: below −0.3 it follows the first alone, above 0.3 the second, with a smooth bend
 * between.
 */
function tubeGeometry(): THREE.BufferGeometry {
  const geometry = new THREE.CylinderGeometry(0.35, 0.35, 2, 16, 20, true);
  const { position } = geometry.attributes;
  const indices: number[] = [];
  const weights: number[] = [];
  for (let i = 0; i < position.count; i++) {
    const upper = THREE.MathUtils.smoothstep(position.getY(i), -0.3, 0.3);
    indices.push(0, 1, 0, 0);
    weights.push(1 - upper, upper, 0, 0);
  }
  geometry.setAttribute('skinIndex', new THREE.Uint16BufferAttribute(indices, 4));
  geometry.setAttribute('skinWeight', new THREE.Float32BufferAttribute(weights, 4));
  return geometry;
}

/** Adds two morph targets with normals: a bulge, and a twist about y. */
function addMorphTargets(geometry: THREE.BufferGeometry, isRelative: boolean): THREE.BufferGeometry {
  const { position, normal } = geometry.attributes;
  const target = (name: string, source: typeof position, change: (v: THREE.Vector3, y: number) => THREE.Vector3) => {
    const values: number[] = [];
    for (let i = 0; i < source.count; i++) {
      const before = new THREE.Vector3().fromBufferAttribute(source, i);
      const after = change(before.clone(), position.getY(i));
      values.push(...(isRelative ? after.sub(before) : after));
    }
    const attribute = new THREE.Float32BufferAttribute(values, 3);
    attribute.name = name;
    return attribute;
  };
  const bulge = (v: THREE.Vector3, y: number) => v.multiply(new THREE.Vector3(1 + 0.6 * Math.cos(y), 1, 1));
  const twist = (v: THREE.Vector3, y: number) => v.applyAxisAngle(new THREE.Vector3(0, 1, 0), 0.5 * y);
  geometry.morphTargetsRelative = isRelative;
  geometry.morphAttributes.position = [target('bulge', position, bulge), target('twist', position, twist)];
  geometry.morphAttributes.normal = [target('bulge', normal, bulge), target('twist', normal, twist)];
  return geometry;
}

/** A mesh with two bones, of which the second can be turned. `geometry` comes from `tubeGeometry`, and may be prepared. */
function onBones(
  geometry: THREE.BufferGeometry,
  material: HatchingMaterial,
): THREE.SkinnedMesh<THREE.BufferGeometry, HatchingMaterial> {
  const mesh = new THREE.SkinnedMesh(geometry, material);
  const bones = [new THREE.Bone(), new THREE.Bone()];
  // The bone is away from the origin: if surface and light turned about the origin together, no coordinate would change.
  bones[1].position.set(0.25, 0.1, 0);
  bones[0].add(bones[1]);
  mesh.add(bones[0]);
  mesh.bind(new THREE.Skeleton(bones));
  return mesh;
}

/** Parses a glTF whose buffers are all inside: text, or a binary file in base64. */
async function loadGltf(content: string): Promise<GLTF> {
  const data = content.startsWith('{') ? content : Uint8Array.from(atob(content), (c) => c.charCodeAt(0)).buffer;
  return new GLTFLoader().parseAsync(data, '');
}

/** A loaded model, hatched in grey, every mesh prepared, and a function that brings it to a time of its clip, in seconds. */
async function hatchedModel(content: string, clip: number, parameters: HatchingMaterialParameters = {}) {
  const { HatchingMaterial, prepareHatchingGeometry, greyMap } = window.toolkit;
  const { scene: root, animations } = await loadGltf(content);
  const meshes: THREE.Mesh<THREE.BufferGeometry, HatchingMaterial>[] = [];
  root.traverse((object) => {
    if (object instanceof THREE.Mesh) meshes.push(object);
  });
  for (const mesh of meshes) {
    mesh.geometry = await prepareHatchingGeometry(mesh.geometry, { adjacency: true });
    mesh.material = new HatchingMaterial(plainLook({ tonalArtMap: greyMap(), ...parameters }));
    mesh.frustumCulled = false;
  }
  const mixer = new THREE.AnimationMixer(root);
  const animation = animations[clip];
  if (animation) mixer.clipAction(animation).play();
  const setTime = (time: number) => {
    mixer.setTime(time);
    root.updateMatrixWorld(true);
  };
  return { scene: new THREE.Scene().add(root), meshes, setTime };
}

/** The words of the triangles of a geometry of the layout `pull`. */
const wordsOf = (geometry: THREE.BufferGeometry) =>
  pulledVerticesOf(geometry)!.triangleVertices.image.data as unknown as Uint32Array;

/** The texels of a float texture that was drawn into. In older versions a texture does not know its render target. */
function texelsOf(renderer: THREE.WebGLRenderer, texture: THREE.Texture): Float32Array {
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const { width, height } = texture.image as { width: number; height: number };
  const texels = new Float32Array(4 * width * height);
  const framebuffer = gl.createFramebuffer();
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer);
  const { __webglTexture: drawn } = renderer.properties.get(texture) as { __webglTexture: WebGLTexture };
  gl.framebufferTexture2D(gl.READ_FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, drawn, 0);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, texels);
  gl.deleteFramebuffer(framebuffer);
  renderer.resetState();
  return texels;
}

/** The output of the pre-pass for each corner of the mesh that was drawn last. */
function deformedCorners(
  renderer: THREE.WebGLRenderer,
  { geometry, material }: THREE.Mesh<THREE.BufferGeometry, HatchingMaterial>,
): DeformedVertex[] {
  const words = wordsOf(geometry);
  const corners = geometry.attributes.position.count;
  const [positions, normals] = ['deformedPositions', 'deformedNormals'].map((name) =>
    texelsOf(renderer, material.uniforms[name].value),
  );
  return Array.from({ length: corners }, (_, corner) => {
    const texel = 4 * words[8 * Math.floor(corner / 3) + (corner % 3)];
    return { position: [...positions!.slice(texel, texel + 3)], normal: [...normals!.slice(texel, texel + 3)] };
  });
}

/** The same from three.js on the CPU; the normal from its formula, for which three.js has no function. */
function expectedCorner(mesh: THREE.Mesh, corner: number): DeformedVertex {
  const { geometry } = mesh;
  const position = mesh.getVertexPosition(corner, new THREE.Vector3());
  const normal = new THREE.Vector3().fromBufferAttribute(geometry.attributes.normal, corner);
  const targets = geometry.morphAttributes.normal ?? [];
  const influences = mesh.morphTargetInfluences ?? [];
  if (targets.length > 0) {
    const base = geometry.morphTargetsRelative ? 1 : 1 - influences.reduce((sum, x) => sum + x, 0);
    normal.multiplyScalar(base);
    targets.forEach((target, i) => {
      normal.addScaledVector(new THREE.Vector3().fromBufferAttribute(target, corner), influences[i]);
    });
  }
  if (mesh instanceof THREE.SkinnedMesh) {
    const matrix = new THREE.Matrix4().multiplyScalar(0);
    for (const axis of ['X', 'Y', 'Z', 'W'] as const) {
      const bone = geometry.attributes.skinIndex[`get${axis}`](corner);
      const weight = geometry.attributes.skinWeight[`get${axis}`](corner);
      const { bones, boneInverses } = mesh.skeleton;
      const moved = new THREE.Matrix4().multiplyMatrices(bones[bone].matrixWorld, boneInverses[bone]);
      moved.elements.forEach((x, i) => {
        matrix.elements[i] += weight * x;
      });
    }
    matrix.premultiply(mesh.bindMatrixInverse).multiply(mesh.bindMatrix);
    const [x, y, z] = normal.toArray();
    const e = matrix.elements;
    normal.set(e[0] * x + e[4] * y + e[8] * z, e[1] * x + e[5] * y + e[9] * z, e[2] * x + e[6] * y + e[10] * z);
  }
  return { position: position.toArray(), normal: normal.toArray() };
}

/** The largest distances of the pre-pass from three.js on the processor: of positions over the model's size, and of normals. */
function deviation(renderer: THREE.WebGLRenderer, mesh: THREE.Mesh<THREE.BufferGeometry, HatchingMaterial>) {
  const corners = deformedCorners(renderer, mesh);
  const box = new THREE.Box3();
  const worst = { position: 0, normal: 0, moved: 0 };
  const expected = Array.from({ length: mesh.geometry.attributes.position.count }, (_, i) => expectedCorner(mesh, i));
  for (const { position } of expected) box.expandByPoint(new THREE.Vector3(...position));
  const size = box.getSize(new THREE.Vector3()).length();
  const distance = (a: number[], b: number[]) => Math.hypot(...a.map((x, i) => x - b[i]));
  for (const [corner, { position, normal }] of expected.entries()) {
    const rest = new THREE.Vector3().fromBufferAttribute(mesh.geometry.attributes.position, corner).toArray();
    // Math.max would hide a NaN here.
    for (const [name, value] of [
      ['position', distance(position, corners[corner].position) / size],
      ['normal', distance(normal, corners[corner].normal) / Math.hypot(...normal)],
      ['moved', distance(position, rest) / size],
    ] as const) {
      if (!(value <= worst[name])) worst[name] = value;
    }
  }
  return worst;
}

/** Makes a material write the stroke coordinates of two triangles of the adjacency primitive instead of a colour. */
function writeCoordinates(material: HatchingMaterial, first: 0 | 2): void {
  const ofStrokes =
    'tilesPerObjectUnit * vec2(dot(vRestPosition, parameters.uAxis), dot(vRestPosition, parameters.vAxis))';
  const { technique } = material;
  const folder = drawsLines(technique)
    ? 'lines'
    : technique === 'triangle' || technique === 'adjacency'
      ? technique
      : 'strokes';
  material.fragmentShader = material.fragmentShader.replace(
    '#include <opaque_fragment>',
    {
      triangle: 'gl_FragColor = vec4(parameters.uv, parameters.uv);',
      adjacency: `gl_FragColor = vec4(parameters.uv[${first}], parameters.uv[${first + 1}]);`,
      strokes: `gl_FragColor = vec4(${ofStrokes}, ${ofStrokes});`,
      lines: 'gl_FragColor = vec4(parameters.point, 1.0);',
    }[folder],
  );
  // Each corner is drawn as a point on its own pixel, whatever the camera.
  material.vertexShader = material.vertexShader.replace(
    /}\s*$/,
    `gl_PointSize = 1.0;
     gl_Position = vec4((vec2(gl_VertexID % ${COLUMNS}, gl_VertexID / ${COLUMNS}) + 0.5) / float(${COLUMNS / 2}) - 1.0, 0.0, 1.0);
    }`,
  );
}

/** Corners per row and column of a picture of coordinates. */
const COLUMNS = 128;

/** For each corner of a mesh, as it would be drawn now, four numbers that `writeCoordinates` made the material write. */
function readCoordinates(renderer: THREE.WebGLRenderer, scene: THREE.Scene, mesh: THREE.Mesh): Float32Array {
  const target = new THREE.WebGLRenderTarget(COLUMNS, COLUMNS, { type: THREE.FloatType, depthBuffer: false });
  const words = new Float32Array(4 * COLUMNS * COLUMNS);
  Object.assign(mesh, { isMesh: false, isPoints: true, frustumCulled: false });
  renderer.setRenderTarget(target);
  renderer.render(scene, window.toolkit.makeCamera());
  renderer.readRenderTargetPixels(target, 0, 0, COLUMNS, COLUMNS, words);
  renderer.setRenderTarget(null);
  Object.assign(mesh, { isMesh: true, isPoints: false });
  target.dispose();
  return words;
}

/** The bone that carries each vertex of the position texture alone, or −1. */
function onlyBones(mesh: THREE.SkinnedMesh, words: Uint32Array): Map<number, number> {
  const { skinIndex, skinWeight } = mesh.geometry.attributes;
  const bones = new Map<number, number>();
  for (let corner = 0; corner < skinIndex.count; corner++) {
    const components = ['getX', 'getY', 'getZ', 'getW'] as const;
    const first = components.find((component) => skinWeight[component](corner) > 0.99999);
    const bone = first ? skinIndex[first](corner) : -1;
    bones.set(words[8 * Math.floor(corner / 3) + (corner % 3)], bone);
  }
  return bones;
}

/**
 * Measures the largest change of stroke coordinates from frame to frame, in tiles, of a skinned mesh that `move` brings into the pose of
 * each frame. For each bone the light is fixed in the frame of the bone, and the triangles are those that move rigidly with it,
 * together with their neighbours. Also returns the numbers of such triangles and bones.
 */
function drift(
  scene: THREE.Scene,
  mesh: THREE.SkinnedMesh<THREE.BufferGeometry, HatchingMaterial>,
  move: (frame: number) => void,
  frames: number,
) {
  const renderer = window.toolkit.makeRenderer();
  const light = window.toolkit.sun();
  scene.add(light, light.target);
  const tiles = 8 / (2 * mesh.geometry.boundingSphere!.radius);
  const materials = ([0, 2] as const).slice(0, mesh.material.technique === 'adjacency' ? 2 : 1).map((first) => {
    const material = mesh.material.clone();
    material.tilesPerObjectUnit = tiles;
    writeCoordinates(material, first);
    return material;
  });
  const words = wordsOf(mesh.geometry);
  const bones = onlyBones(mesh, words);
  const triangles = Array.from({ length: mesh.geometry.attributes.position.count / 3 }, (_, t) => t);
  const boneOf = (t: number) => {
    const six = [0, 1, 2, 4, 5, 6].map((k) => bones.get(words[8 * t + k])!);
    return six.every((bone) => bone === six[0]) ? six[0] : -1;
  };
  const rigid = new Map<number, number[]>();
  for (const triangle of triangles) rigid.set(boneOf(triangle), [...(rigid.get(boneOf(triangle)) ?? []), triangle]);
  rigid.delete(-1);
  let largest = 0;
  let count = 0;
  for (const [bone, ofBone] of rigid) {
    count += ofBone.length;
    let before: Float32Array[] | null = null;
    for (let frame = 0; frame < frames; frame++) {
      move(frame);
      scene.updateMatrixWorld(true);
      const { bones: list, boneInverses } = mesh.skeleton;
      const restToWorld = new THREE.Matrix4()
        .multiplyMatrices(list[bone].matrixWorld, boneInverses[bone])
        .premultiply(mesh.bindMatrixInverse)
        .multiply(mesh.bindMatrix)
        .premultiply(mesh.matrixWorld);
      light.position.set(0.5, 0.6, 0.7).transformDirection(restToWorld);
      const now: Float32Array[] = materials.map((material) => {
        mesh.material = material;
        return readCoordinates(renderer, scene, mesh);
      });
      for (const [i, coordinates] of now.entries()) {
        if (!before) break;
        for (const triangle of ofBone) {
          for (let word = 12 * triangle; word < 12 * triangle + 12; word++) {
            const change = Math.abs(coordinates[word] - before[i][word]);
            if (!(change <= largest)) largest = change;
          }
        }
      }
      before = now;
    }
  }
  return { drift: largest, rigidTriangles: count, bones: rigid.size };
}

const deforming = { tubeGeometry, addMorphTargets, onBones, hatchedModel, deformedCorners, deviation, drift, reactive };

declare global {
  interface Window {
    deforming: typeof deforming;
  }
}
window.deforming = deforming;
