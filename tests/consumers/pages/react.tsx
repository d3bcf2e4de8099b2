import { Canvas, type RootState, useFrame } from '@react-three/fiber';
import { StrictMode, Suspense, use, useMemo, useSyncExternalStore } from 'react';
import { createRoot } from 'react-dom/client';
import { BufferAttribute, BufferGeometry, Group, Mesh, MeshStandardMaterial, SphereGeometry } from 'three';
import type { HatchedScene, HatchingMaterial } from 'three-hatching';
import {
  Hatched,
  type HatchedProps,
  HatchingOutlines,
  useHatchingGeometry,
  useTonalArtMap,
} from 'three-hatching/react';
import { ReactModel } from './ReactModel.js';

/** The state of the page; the tests change it. */
interface Shown {
  flat: boolean;
  hatched: boolean;
  options: HatchedProps;
  shape: 'box' | 'sphere';
  color: string;
  second: boolean;
  loaded: boolean;
  broken: boolean;
  late: boolean;
  byHand: boolean;
  ink: string | undefined;
  outlineWidth: number | undefined;
  weights: { creases?: number; shade?: number } | undefined;
}

let shown: Shown = {
  flat: true,
  hatched: true,
  options: { preset: 'pen', tonalArtMap: { size: 64, tones: 4 } },
  shape: 'box',
  color: '#ffffff',
  second: false,
  loaded: false,
  broken: false,
  late: false,
  byHand: false,
  ink: undefined,
  outlineWidth: undefined,
  weights: undefined,
};
const listeners = new Set<() => void>();

const loadedScene = new Group();
loadedScene.add(new Mesh(new SphereGeometry(0.3, 12, 8), new MeshStandardMaterial({ name: 'loaded' })));
loadedScene.position.x = -0.9;

/** Four corners make no triangles. */
const broken = new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(4 * 3), 3));

let arrive = (): void => {};
const arrival = new Promise<void>((go) => {
  arrive = go;
});

let state: RootState | undefined;
const page = {
  /** Number of times that a scene was hatched or got new values. */
  hatchings: 0,
  errors: [] as string[],
  progress: [] as number[],
  last: undefined as HatchedScene | undefined,
  /** Whether a part was asked for that has not arrived. */
  isLateAwaited: false,
  /** Meshes that were drawn with their own material, frame by frame. */
  flashes: 0,
  show(change: Partial<Shown>): void {
    shown = { ...shown, ...change };
    for (const tell of listeners) tell();
  },
  arrive: () => arrive(),
  get state() {
    return state!;
  },
  /** The meshes of the scene by name: their materials, inks and numbers of triangles. */
  meshes(): Record<string, { material: string; ink: string | null; color: string; triangles: number | null }> {
    const found: ReturnType<typeof page.meshes> = {};
    state?.scene.traverse((object) => {
      if (!('isMesh' in object)) return;
      const { material, geometry, name } = object as Mesh<BufferGeometry, HatchingMaterial>;
      found[name || material.name] = {
        material: material.type,
        ink: material.ink?.getHexString() ?? null,
        color: material.color.getHexString(),
        triangles: geometry.userData.hatching?.triangles ?? null,
      };
    });
    return found;
  },
  memory() {
    const { memory, programs } = state!.gl.info;
    return { ...memory, programs: programs!.length };
  },
  /** The red of every pixel, drawn anew. */
  pixels(): number[] {
    const { gl, scene, camera } = state!;
    gl.render(scene, camera);
    const context = gl.getContext();
    const { drawingBufferWidth: width, drawingBufferHeight: height } = context;
    const bytes = new Uint8Array(width * height * 4);
    context.readPixels(0, 0, width, height, context.RGBA, context.UNSIGNED_BYTE, bytes);
    return Array.from({ length: width * height }, (_, i) => bytes[4 * i]);
  },
};
Object.assign(window, { page });

declare global {
  interface Window {
    page: typeof page;
  }
}

/** Looks at what is about to be drawn. */
function Watch() {
  useFrame(({ scene, camera }) => {
    scene.traverseVisible((object) => {
      if (!('isMesh' in object) || !object.layers.test(camera.layers)) return;
      if (!('isHatchingMaterial' in (object as Mesh).material)) page.flashes++;
    });
  });
  return null;
}

function Late() {
  page.isLateAwaited = true;
  use(arrival);
  return (
    <mesh name="late" position-y={0.9}>
      <boxGeometry args={[0.4, 0.4, 0.4]} />
      <meshStandardMaterial />
    </mesh>
  );
}

function ByHand({ ink, outlineWidth, weights }: Pick<Shown, 'ink' | 'outlineWidth' | 'weights'>) {
  const tonalArtMap = useTonalArtMap({ style: 'woodcut', size: 64, tones: 4 });
  const source = useMemo(() => new SphereGeometry(0.4, 16, 12), []);
  const geometry = useHatchingGeometry(source, { outlines: true });
  if (!geometry) return null;
  return (
    <mesh name="by hand" geometry={geometry} position-y={-0.9}>
      <hatchingMaterial
        technique="hatching"
        tonalArtMap={tonalArtMap}
        perTriangle={{ strokeOffset: [0.5, 0] }}
        {...(ink && { ink })}
      />
      <HatchingOutlines
        wobble={1}
        {...(outlineWidth !== undefined && { outlineWidth })}
        {...(weights !== undefined && { weights })}
      />
    </mesh>
  );
}

function App() {
  const now = useSyncExternalStore(
    (tell) => {
      listeners.add(tell);
      return () => listeners.delete(tell);
    },
    () => shown,
  );
  return (
    <Canvas
      key={String(now.flat)}
      flat={now.flat}
      dpr={1}
      frameloop="demand"
      camera={{ position: [0, 0, 4], fov: 40 }}
      gl={{ preserveDrawingBuffer: true, antialias: false }}
      onCreated={(created) => {
        created.gl.setClearColor('#ffffff');
        state = created;
      }}
    >
      <directionalLight position={[2, 3, 4]} intensity={Math.PI} />
      {now.hatched && (
        <Hatched
          {...now.options}
          object={now.loaded ? loadedScene : undefined}
          onHatched={(hatched) => {
            page.hatchings++;
            page.last = hatched;
          }}
          onProgress={(progress) => page.progress.push(progress)}
          onError={(error) => page.errors.push(String(error))}
        >
          <mesh name="first" rotation={[0.5, 0.6, 0]}>
            {now.shape === 'box' ? <boxGeometry /> : <sphereGeometry args={[0.6, 16, 12]} />}
            <meshStandardMaterial key={now.color} color={now.color} />
          </mesh>
          {now.second && <ReactModel />}
          {now.broken && <mesh name="broken" geometry={broken} />}
          {now.late && (
            <Suspense fallback={null}>
              <Late />
            </Suspense>
          )}
        </Hatched>
      )}
      <Watch key={String(now.hatched)} />
      {now.byHand && (
        <Suspense fallback={null}>
          <ByHand ink={now.ink} outlineWidth={now.outlineWidth} weights={now.weights} />
        </Suspense>
      )}
    </Canvas>
  );
}

createRoot(document.getElementById('root')!).render(
  <StrictMode>
    <App />
  </StrictMode>,
);
