import { BackSide, type Material, type Mesh, type Object3D } from 'three';

/** Hides the sky and the ground that three's loader for VRML builds around a scene: the model would be a dot in them. */
export function withoutBackground<Root extends Object3D>(root: Root): Root {
  root.traverse((object) => {
    const { material } = object as Partial<Mesh>;
    if (material && !Array.isArray(material) && isBackground(material)) object.visible = false;
  });
  return root;
}

const isBackground = ({ side, depthTest, depthWrite }: Material): boolean =>
  side === BackSide && !depthTest && !depthWrite;
