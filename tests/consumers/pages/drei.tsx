import font from '@pmndrs/assets/fonts/inter_regular.woff';
import {
  Bounds,
  Center,
  ContactShadows,
  Edges,
  Environment,
  Float,
  Grid,
  Instance,
  Instances,
  Lightformer,
  Line,
  MeshReflectorMaterial,
  OrbitControls,
  Outlines,
  RoundedBox,
  Sky,
  Stage,
  Text,
} from '@react-three/drei';
import { Canvas, type RootState, useFrame } from '@react-three/fiber';
import { Suspense, useState } from 'react';
import { createRoot } from 'react-dom/client';
import type { BufferGeometry, Material, Mesh, MeshStandardMaterial, Object3D } from 'three';
import type { HatchedScene } from 'three-hatching';
import { Hatched } from 'three-hatching/react';

let state: RootState | undefined;
let setColor: (color: string) => void;
const page = {
  hatchings: 0,
  frames: 0,
  /** Meshes of the model that were drawn with their own material, frame by frame. */
  flashes: 0,
  last: undefined as HatchedScene | undefined,
  errors: [] as string[],
  setColor: (color: string) => setColor(color),
  /** The types of the materials of all meshes with a name. */
  materials(): Record<string, string> {
    const found: Record<string, string> = {};
    state?.scene.traverse((object) => {
      const { isMesh, name, material } = object as Mesh<BufferGeometry, Material>;
      if (isMesh && name) found[name] = material.type;
    });
    return found;
  },
  colorOf: (name: string) =>
    (state!.scene.getObjectByName(name) as Mesh<BufferGeometry, MeshStandardMaterial>).material.color.getHexString(),
  /** The share of dark pixels, of what stands on the canvas after the next frame. */
  async ink(): Promise<number> {
    const { gl } = state!;
    await new Promise((go) => requestAnimationFrame(() => requestAnimationFrame(go)));
    const context = gl.getContext();
    const { drawingBufferWidth: width, drawingBufferHeight: height } = context;
    const bytes = new Uint8Array(width * height * 4);
    context.readPixels(0, 0, width, height, context.RGBA, context.UNSIGNED_BYTE, bytes);
    let dark = 0;
    for (let i = 0; i < bytes.length; i += 4) if (bytes[i] < 96) dark++;
    return dark / (width * height);
  },
};
Object.assign(window, { dreiPage: page });

declare global {
  interface Window {
    dreiPage: typeof page;
  }
}

/** Counts frames, and the meshes of the model that are about to be drawn with their own material. */
function Watch() {
  useFrame(({ scene, camera }) => {
    page.frames++;
    scene.traverseVisible((object: Object3D) => {
      if (!/^model/.test(object.name) || !('isMesh' in object) || !object.layers.test(camera.layers)) return;
      if (!('isHatchingMaterial' in (object as Mesh).material)) page.flashes++;
    });
  });
  return null;
}

function Ball() {
  const [color, set] = useState('#ff0000');
  setColor = set;
  return (
    <mesh name="model ball">
      <sphereGeometry args={[0.5, 24, 16]} />
      <meshStandardMaterial color={color} />
      <Outlines thickness={2} color="black" />
    </mesh>
  );
}

function Helpers() {
  return (
    <>
      <OrbitControls />
      <Environment resolution={16}>
        <Lightformer intensity={2} position={[0, 3, 0]} />
      </Environment>
      <Sky />
      <Grid name="grid" args={[4, 4]} position-y={-0.6} />
      <ContactShadows position-y={-0.59} resolution={32} />
      <Suspense fallback={null}>
        <Text name="text" font={font} fontSize={0.3} position-y={0.8}>
          hatch
        </Text>
      </Suspense>
      <Line
        points={[
          [-1, 0, 0],
          [1, 0, 0],
        ]}
      />
      <Bounds>
        <Center>
          <Float>
            <Ball />
          </Float>
        </Center>
      </Bounds>
      <RoundedBox name="model box" args={[0.4, 0.4, 0.4]} position-x={1}>
        <meshStandardMaterial />
        <Edges />
      </RoundedBox>
      <Instances name="model instances" limit={4}>
        <boxGeometry args={[0.2, 0.2, 0.2]} />
        <meshStandardMaterial />
        <Instance position={[-1, 0, 0]} />
        <Instance position={[-1, 0.5, 0]} />
      </Instances>
      <mesh name="mirror" position-z={-2}>
        <planeGeometry args={[2, 2]} />
        <MeshReflectorMaterial resolution={32} mirror={1} />
      </mesh>
    </>
  );
}

function Accumulating() {
  return (
    <Stage
      shadows={{ type: 'accumulative', size: 32, resolution: 32, frames: 30, amount: 1 }}
      environment={null}
      adjustCamera={false}
    >
      <Ball />
    </Stage>
  );
}

createRoot(document.getElementById('root')!).render(
  <Canvas
    flat
    dpr={1}
    shadows="percentage"
    camera={{ position: [0, 0.5, 4], fov: 40 }}
    gl={{ preserveDrawingBuffer: true, antialias: false }}
    onCreated={(created) => {
      state = created;
    }}
  >
    <directionalLight position={[2, 3, 4]} intensity={Math.PI} />
    <Hatched
      preset="pen"
      tonalArtMap={{ size: 64, tones: 4 }}
      onHatched={(hatched) => {
        page.hatchings++;
        page.last = hatched;
      }}
      onError={(error) => page.errors.push(String(error))}
    >
      {location.hash === '#stage' ? <Accumulating /> : <Helpers />}
    </Hatched>
    <Watch />
  </Canvas>,
);
