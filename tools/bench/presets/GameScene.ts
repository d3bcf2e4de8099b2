import {
  Bone,
  BoxGeometry,
  type BufferGeometry,
  CapsuleGeometry,
  ConeGeometry,
  CylinderGeometry,
  DirectionalLight,
  Float32BufferAttribute,
  Group,
  IcosahedronGeometry,
  InstancedMesh,
  type Material,
  Matrix4,
  Mesh,
  Scene,
  Skeleton,
  SkinnedMesh,
  SphereGeometry,
  TorusGeometry,
  Uint16BufferAttribute,
} from 'three';

/** How many things of each kind a scene has. */
export interface GameCounts {
  meshes: number;
  skins: number;
  instances: number;
}

const BONES = 4;
const HEIGHT = 1.6;

/** What the meshes share: some kinds of things, as a game has them. */
const KINDS: readonly BufferGeometry[] = [
  new BoxGeometry(0.8, 0.8, 0.8, 4, 4, 4),
  new SphereGeometry(0.5, 24, 16),
  new TorusGeometry(0.4, 0.16, 16, 32),
  new CylinderGeometry(0.3, 0.4, 1, 24, 4),
  new ConeGeometry(0.45, 1, 24, 4),
  new IcosahedronGeometry(0.5, 2),
];
const SMALL = new IcosahedronGeometry(0.12, 1);
const FIGURE = skinned(new CapsuleGeometry(0.3, HEIGHT - 0.6, 8, 24, 12));

/** Meshes that share geometries and materials, skins that move, and instances of one mesh, on a square of grass. */
export class GameScene {
  readonly scene = new Scene();
  /** What is hatched. */
  readonly root = new Group();
  /** The length of a side of the square. */
  readonly side: number;
  private readonly sun = new DirectionalLight(0xffffff, Math.PI);
  private readonly bones: Bone[] = [];

  /** @param makeMaterial the material of a thing, by the number of its kind */
  constructor({ meshes, skins, instances }: GameCounts, makeMaterial: (kind: number) => Material) {
    this.side = Math.ceil(Math.sqrt(meshes + skins)) * 1.5;
    const things = meshes + skins;
    const materials = Array.from({ length: KINDS.length + 2 }, (_, kind) => makeMaterial(kind));
    const perRow = Math.ceil(Math.sqrt(things));
    for (let i = 0; i < things; i++) {
      // Skins stand among the meshes.
      const isSkin = Math.floor(((i + 1) * skins) / things) > Math.floor((i * skins) / things);
      const kind = isSkin ? KINDS.length : i % KINDS.length;
      const thing = isSkin ? this.skin(materials[kind]) : new Mesh(KINDS[kind], materials[kind]);
      thing.position.set((i % perRow) * 1.5 - this.side / 2, 0, Math.floor(i / perRow) * 1.5 - this.side / 2);
      this.root.add(thing);
    }
    this.root.add(this.grass(instances, materials[KINDS.length + 1]));
    this.scene.add(this.sun, this.root);
    this.move(0);
  }

  /** Moves the skins and the sun to a frame. */
  move(frame: number): void {
    this.sun.position.set(Math.cos(0.02 * frame), 1.2, Math.sin(0.02 * frame));
    for (const [i, bone] of this.bones.entries()) bone.rotation.z = 0.25 * Math.sin(0.2 * frame + i);
  }

  private skin(material: Material): SkinnedMesh {
    const mesh = new SkinnedMesh(FIGURE, material);
    const bones = Array.from({ length: BONES }, (_, i) => {
      const bone = new Bone();
      bone.position.y = i === 0 ? -HEIGHT / 2 : HEIGHT / BONES;
      return bone;
    });
    for (const [i, bone] of bones.entries()) if (i > 0) bones[i - 1].add(bone);
    mesh.add(bones[0]);
    mesh.bind(new Skeleton(bones));
    this.bones.push(...bones);
    return mesh;
  }

  private grass(count: number, material: Material): InstancedMesh {
    const mesh = new InstancedMesh(SMALL, material, count);
    const perRow = Math.ceil(Math.sqrt(count));
    const step = this.side / perRow;
    for (let i = 0; i < count; i++) {
      const [x, z] = [(i % perRow) * step - this.side / 2, Math.floor(i / perRow) * step - this.side / 2];
      mesh.setMatrixAt(i, new Matrix4().makeTranslation(x, -0.9, z));
    }
    return mesh;
  }
}

/** A geometry whose vertices follow the two nearest of a row of bones. */
function skinned(geometry: BufferGeometry): BufferGeometry {
  const position = geometry.getAttribute('position');
  const indices = new Uint16Array(4 * position.count);
  const weights = new Float32Array(4 * position.count);
  for (let i = 0; i < position.count; i++) {
    const place = Math.min(Math.max((position.getY(i) / HEIGHT + 0.5) * BONES, 0), BONES - 1.001);
    const bone = Math.floor(place);
    indices.set([bone, bone + 1], 4 * i);
    weights.set([1 - (place - bone), place - bone], 4 * i);
  }
  geometry.setAttribute('skinIndex', new Uint16BufferAttribute(indices, 4));
  geometry.setAttribute('skinWeight', new Float32BufferAttribute(weights, 4));
  return geometry;
}
