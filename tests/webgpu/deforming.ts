import {
  Bone,
  type BufferGeometry,
  CylinderGeometry,
  Float32BufferAttribute,
  type Material,
  Mesh,
  Skeleton,
  SkinnedMesh,
  SphereGeometry,
  Uint16BufferAttribute,
} from 'three';

/** A tube that two bones bend. */
export function bentTube(material: Material): SkinnedMesh {
  const geometry = new CylinderGeometry(0.35, 0.35, 1.8, 40, 24);
  const { position } = geometry.attributes;
  const indices: number[] = [];
  const weights: number[] = [];
  for (let i = 0; i < position.count; i++) {
    const share = Math.min(Math.max(position.getY(i) + 0.5, 0), 1);
    indices.push(0, 1, 0, 0);
    weights.push(1 - share, share, 0, 0);
  }
  geometry.setAttribute('skinIndex', new Uint16BufferAttribute(indices, 4));
  geometry.setAttribute('skinWeight', new Float32BufferAttribute(weights, 4));
  const root = new Bone();
  const upper = new Bone();
  root.position.y = -0.9;
  upper.position.y = 0.9;
  root.add(upper);
  const mesh = new SkinnedMesh(geometry, material);
  mesh.add(root);
  mesh.bind(new Skeleton([root, upper]));
  upper.rotation.z = -0.9;
  root.rotation.x = 0.3;
  return mesh;
}

/** A ball that a morph target makes an egg. */
export function egg(material: Material): Mesh {
  const geometry = new SphereGeometry(0.7, 40, 30);
  const target = new SphereGeometry(0.7, 40, 30).scale(0.6, 1.4, 1);
  geometry.morphAttributes = { position: [target.attributes.position], normal: [target.attributes.normal] };
  const mesh = new Mesh<BufferGeometry, Material>(geometry, material);
  mesh.morphTargetInfluences![0] = 0.7;
  return mesh;
}
