/** What the tests of meshes that deform build from, beside the toolkit: models that move, and what the pre-pass made of them. */
import './toolkit.js';
import * as THREE from 'three';
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import type { HatchingMaterial } from 'three-hatching';

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
  for (let i = 0; i < position!.count; i++) {
    const upper = THREE.MathUtils.smoothstep(position!.getY(i), -0.3, 0.3);
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
    for (let i = 0; i < source!.count; i++) {
      const before = new THREE.Vector3().fromBufferAttribute(source!, i);
      const after = change(before.clone(), position!.getY(i));
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

/** A mesh on two bones at the origin, the second to be turned; `geometry` is what `tubeGeometry` gave, perhaps prepared. */
function onBones(
  geometry: THREE.BufferGeometry,
  material: HatchingMaterial,
): THREE.SkinnedMesh<THREE.BufferGeometry, HatchingMaterial> {
  const mesh = new THREE.SkinnedMesh(geometry, material);
  const bones = [new THREE.Bone(), new THREE.Bone()];
  bones[0]!.add(bones[1]!);
  mesh.add(bones[0]!);
  mesh.bind(new THREE.Skeleton(bones));
  return mesh;
}

/** Parses a glTF whose buffers are all inside: text, or a binary file in base64. */
async function loadGltf(content: string): Promise<GLTF> {
  const data = content.startsWith('{') ? content : Uint8Array.from(atob(content), (c) => c.charCodeAt(0)).buffer;
  return new GLTFLoader().parseAsync(data, '');
}

/** What the pre-pass wrote for each corner of the mesh that the material drew last. */
function deformedCorners(renderer: THREE.WebGLRenderer, material: HatchingMaterial): DeformedVertex[] {
  const texture = material.uniforms.deformedPositions!.value as THREE.Texture;
  const target = texture.renderTarget as THREE.WebGLRenderTarget;
  const [positions, normals] = [0, 1].map((attachment) => {
    const texels = new Float32Array(4 * target.width * target.height);
    renderer.readRenderTargetPixels(target, 0, 0, target.width, target.height, texels, undefined, attachment);
    return texels;
  });
  const words = (material.uniforms.triangleVertices!.value as THREE.DataTexture).image.data as Uint32Array;
  return Array.from({ length: (3 * words.length) / 8 }, (_, corner) => {
    const texel = 4 * words[8 * Math.floor(corner / 3) + (corner % 3)]!;
    return { position: [...positions!.slice(texel, texel + 3)], normal: [...normals!.slice(texel, texel + 3)] };
  });
}

/** The same by three.js on the processor; the normal by its formula, for which it has no function. */
function expectedCorner(mesh: THREE.Mesh, corner: number): DeformedVertex {
  const { geometry } = mesh;
  const position = mesh.getVertexPosition(corner, new THREE.Vector3());
  const normal = new THREE.Vector3().fromBufferAttribute(geometry.attributes.normal!, corner);
  const targets = geometry.morphAttributes.normal ?? [];
  const influences = mesh.morphTargetInfluences ?? [];
  if (targets.length > 0) {
    const base = geometry.morphTargetsRelative ? 1 : 1 - influences.reduce((sum, x) => sum + x, 0);
    normal.multiplyScalar(base);
    targets.forEach((target, i) => {
      normal.addScaledVector(new THREE.Vector3().fromBufferAttribute(target, corner), influences[i]!);
    });
  }
  if (mesh instanceof THREE.SkinnedMesh) {
    const matrix = new THREE.Matrix4().multiplyScalar(0);
    for (const axis of ['X', 'Y', 'Z', 'W'] as const) {
      const bone = geometry.attributes.skinIndex![`get${axis}`](corner);
      const weight = geometry.attributes.skinWeight![`get${axis}`](corner);
      const { bones, boneInverses } = mesh.skeleton;
      const moved = new THREE.Matrix4().multiplyMatrices(bones[bone]!.matrixWorld, boneInverses[bone]!);
      moved.elements.forEach((x, i) => {
        matrix.elements[i]! += weight * x;
      });
    }
    matrix.premultiply(mesh.bindMatrixInverse).multiply(mesh.bindMatrix);
    const [x, y, z] = normal.toArray();
    const e = matrix.elements;
    normal.set(
      e[0]! * x + e[4]! * y + e[8]! * z,
      e[1]! * x + e[5]! * y + e[9]! * z,
      e[2]! * x + e[6]! * y + e[10]! * z,
    );
  }
  return { position: position.toArray(), normal: normal.toArray() };
}

/** The largest distances of the pre-pass from three.js on the processor: of positions over the model's size, and of normals. */
function deviation(renderer: THREE.WebGLRenderer, mesh: THREE.Mesh<THREE.BufferGeometry, HatchingMaterial>) {
  const corners = deformedCorners(renderer, mesh.material);
  const box = new THREE.Box3();
  const worst = { position: 0, normal: 0, moved: 0 };
  const expected = Array.from({ length: mesh.geometry.attributes.position!.count }, (_, i) => expectedCorner(mesh, i));
  for (const { position } of expected) box.expandByPoint(new THREE.Vector3(...position));
  const size = box.getSize(new THREE.Vector3()).length();
  const distance = (a: number[], b: number[]) => Math.hypot(...a.map((x, i) => x - b[i]!));
  for (const [corner, { position, normal }] of expected.entries()) {
    const rest = new THREE.Vector3().fromBufferAttribute(mesh.geometry.attributes.position!, corner).toArray();
    // Not Math.max, which would lose a NaN.
    for (const [name, value] of [
      ['position', distance(position, corners[corner]!.position) / size],
      ['normal', distance(normal, corners[corner]!.normal) / Math.hypot(...normal)],
      ['moved', distance(position, rest) / size],
    ] as const) {
      if (!(value <= worst[name])) worst[name] = value;
    }
  }
  return worst;
}

const deforming = { tubeGeometry, addMorphTargets, onBones, loadGltf, deformedCorners, deviation };

declare global {
  interface Window {
    deforming: typeof deforming;
  }
}
window.deforming = deforming;
