import font from '@pmndrs/assets/fonts/inter_regular.woff';
import {
  AccumulativeShadows,
  Backdrop,
  Billboard,
  Bounds,
  Box,
  Bvh,
  CatmullRomLine,
  Caustics,
  Center,
  Clone,
  Cloud,
  Clouds,
  ContactShadows,
  CubeCamera,
  CubicBezierLine,
  Decal,
  Detailed,
  Edges,
  Environment,
  Float,
  GizmoHelper,
  GizmoViewport,
  GradientTexture,
  Grid,
  Html,
  Hud,
  Image,
  Instance,
  Instances,
  Lightformer,
  Line,
  MarchingCube,
  MarchingCubes,
  Mask,
  Merged,
  MeshDiscardMaterial,
  MeshDistortMaterial,
  MeshPortalMaterial,
  MeshReflectorMaterial,
  MeshTransmissionMaterial,
  MeshWobbleMaterial,
  OrbitControls,
  Outlines,
  PerspectiveCamera,
  PivotControls,
  Point,
  Points,
  PresentationControls,
  QuadraticBezierLine,
  RandomizedLight,
  RenderTexture,
  Resize,
  RoundedBox,
  ScreenQuad,
  ScreenSizer,
  Segment,
  Segments,
  Select,
  Shadow,
  Sky,
  Sparkles,
  SpotLight,
  Stage,
  Stars,
  Svg,
  Text,
  Text3D,
  Torus,
  Trail,
  TransformControls,
  useMask,
  Wireframe,
} from '@react-three/drei';
import type { FontData } from '@react-three/drei/core/useFont';
import { type ReactNode, Suspense, useEffect, useLayoutEffect, useRef, useState } from 'react';
import { BoxGeometry, DataTexture, Group, type InstancedMesh, Matrix4, Mesh, MeshStandardMaterial } from 'three';

/** What is expected of the picture inside of `<Hatched>`, beside the one outside of it. */
export type Expected =
  /** The meshes named "model" are hatched, and cover what they cover without hatching. */
  | 'hatched'
  /** It is left alone, and looks the same. */
  | 'same'
  /** Meshes named "model" are hatched, and the rest is left alone. It looks otherwise each time. */
  | 'varies';

export interface Part {
  readonly expected: Expected;
  /** How many more geometries it leaves in memory than outside of `<Hatched>`. */
  readonly leaves: number;
  readonly Content: (props: { changed: boolean }) => ReactNode;
}

const part = (expected: Expected, Content: Part['Content'], leaves = 0): Part => ({ expected, Content, leaves });

const COLORS = ['#e07050', '#5070e0'] as const;

const Look = ({ changed }: { changed: boolean }) => <meshStandardMaterial color={COLORS[Number(changed)]} />;

/** A mesh whose geometry and colour change. */
const Model = ({ changed, children }: { changed: boolean; children?: ReactNode }) => (
  <mesh name="model" rotation={[0.5, 0.6, 0]}>
    {changed ? <sphereGeometry args={[0.7, 24, 16]} /> : <boxGeometry />}
    <Look changed={changed} />
    {children}
  </mesh>
);

/** Instances in a row, whose geometry and material React attaches after it has made the mesh. */
function Row({ changed }: { changed: boolean }) {
  const mesh = useRef<InstancedMesh>(null);
  const count = changed ? 3 : 2;
  useLayoutEffect(() => {
    const row = mesh.current!;
    for (let i = 0; i < count; i++) row.setMatrixAt(i, new Matrix4().makeTranslation(i - (count - 1) / 2, 0, 0));
    row.instanceMatrix.needsUpdate = true;
    row.computeBoundingSphere();
  }, [count]);
  return (
    <instancedMesh ref={mesh} name="model" args={[null!, null!, count]}>
      {changed ? <sphereGeometry args={[0.4, 24, 16]} /> : <boxGeometry args={[0.6, 0.6, 0.6]} />}
      <Look changed={changed} />
    </instancedMesh>
  );
}

/** A mesh without geometry, and without material, that gets both while it is hidden, as by a component that loads. */
function Late({ changed }: { changed: boolean }) {
  return (
    <>
      <instancedMesh name={changed ? 'model' : ''} visible={changed} args={[null!, null!, 1]}>
        {changed && <boxGeometry />}
        {changed && <Look changed />}
      </instancedMesh>
      <mesh name="model" position-x={1}>
        <sphereGeometry args={[0.4, 24, 16]} />
        <Look changed={changed} />
      </mesh>
    </>
  );
}

const merged = new Mesh(new BoxGeometry(0.6, 0.6, 0.6), new MeshStandardMaterial({ name: 'merged' }));

const cloned = [COLORS[0], COLORS[1]].map((color, i) => {
  const mesh = new Mesh(new BoxGeometry(1, 1 + i, 1), new MeshStandardMaterial({ color }));
  mesh.name = 'model';
  return new Group().add(mesh);
});

const texture = new DataTexture(new Uint8Array([255, 0, 0, 255, 0, 0, 255, 255]), 2, 1);
texture.needsUpdate = true;

/** A typeface of two letters, which are a square and a triangle. */
const typeface = {
  ...{ familyName: 'Blocks', resolution: 1000, underlineThickness: 50, boundingBox: { yMax: 1000, yMin: 0 } },
  glyphs: {
    A: { ha: 1000, x_min: 0, x_max: 900, o: 'm 0 0 l 0 900 l 900 900 l 900 0 l 0 0' },
    B: { ha: 1000, x_min: 0, x_max: 900, o: 'm 0 0 l 450 900 l 900 0 l 0 0' },
  },
};

const picture = `data:image/svg+xml,${encodeURIComponent('<svg xmlns="http://www.w3.org/2000/svg" width="8" height="8"><rect width="8" height="8" fill="navy"/></svg>')}`;

const star = (color: string): string =>
  `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 2 2"><path fill="${color}" d="M0 0H2V2Z"/></svg>`;

function Masked({ changed }: { changed: boolean }) {
  const stencil = useMask(1);
  return (
    <mesh name="model">
      <boxGeometry args={[1.5, changed ? 1 : 0.8, 0.2]} />
      <meshStandardMaterial color={COLORS[Number(changed)]} {...stencil} />
    </mesh>
  );
}

function WithTarget({ changed }: { changed: boolean }) {
  const [target, setTarget] = useState<Mesh | null>(null);
  return (
    <>
      <mesh ref={setTarget} name="model">
        <boxGeometry />
        <Look changed={changed} />
      </mesh>
      {target && <TransformControls object={target} mode={changed ? 'rotate' : 'translate'} />}
    </>
  );
}

const LINE: [number, number, number][] = [
  [-1, 0, 0],
  [0, 1, 0],
  [1, 0, 0],
];
const colorOf = (changed: boolean): string => COLORS[Number(changed)];

/** Components of drei, and what React Three Fiber's own elements do that need the same care. */
export const PARTS: Record<string, Part> = {
  mesh: part('hatched', Model),
  instancedMesh: part('hatched', Row),
  'instancedMesh whose geometry comes late': part('hatched', Late),
  Instances: part('hatched', ({ changed }) => (
    <Instances name="model" limit={8} range={changed ? 3 : 2}>
      {changed ? <sphereGeometry args={[0.4, 24, 16]} /> : <boxGeometry args={[0.6, 0.6, 0.6]} />}
      <Look changed={changed} />
      <Instance position={[-1, 0, 0]} />
      <Instance position={[0, changed ? 1 : 0.5, 0]} color={changed ? 'white' : 'grey'} />
      {changed && <Instance position={[1, 0, 0]} />}
    </Instances>
  )),
  Merged: part('hatched', ({ changed }) => (
    <Merged meshes={[merged]}>
      {(Piece) => (
        <>
          <Piece position={[-0.7, 0, 0]} />
          {changed && <Piece position={[0.7, 0.4, 0]} color="white" />}
        </>
      )}
    </Merged>
  )),
  Detailed: part('hatched', ({ changed }) => (
    <Detailed distances={changed ? [0, 1] : [0, 100]}>
      <Model changed={changed} />
      <mesh name="model">
        <boxGeometry args={[0.5, 0.5, 0.5]} />
        <Look changed={changed} />
      </mesh>
    </Detailed>
  )),
  Clone: part('hatched', ({ changed }) => <Clone object={cloned[Number(changed)]} rotation={[0.4, 0.5, 0]} />),
  Center: part('hatched', ({ changed }) => (
    <Center top={changed}>
      <Model changed={changed} />
    </Center>
  )),
  Bounds: part('hatched', ({ changed }) => (
    <Bounds>
      <Model changed={changed} />
    </Bounds>
  )),
  Float: part('hatched', ({ changed }) => (
    <Float speed={0}>
      <Model changed={changed} />
    </Float>
  )),
  Billboard: part('hatched', ({ changed }) => (
    <Billboard lockX={changed}>
      <Model changed={changed} />
    </Billboard>
  )),
  Resize: part('hatched', ({ changed }) => (
    <Resize width={changed}>
      <Model changed={changed} />
    </Resize>
  )),
  ScreenSizer: part('hatched', ({ changed }) => (
    <ScreenSizer scale={changed ? 7 : 6}>
      <Model changed={changed} />
    </ScreenSizer>
  )),
  Bvh: part('hatched', ({ changed }) => (
    <Bvh>
      <Model changed={changed} />
    </Bvh>
  )),
  Select: part('hatched', ({ changed }) => (
    <Select>
      <Model changed={changed} />
    </Select>
  )),
  PresentationControls: part('hatched', ({ changed }) => (
    <PresentationControls>
      <Model changed={changed} />
    </PresentationControls>
  )),
  Edges: part('hatched', ({ changed }) => (
    <Model changed={changed}>
      <Edges color={colorOf(changed)} />
    </Model>
  )),
  Outlines: part('hatched', ({ changed }) => (
    <Model changed={changed}>
      <Outlines thickness={changed ? 0.1 : 0.05} />
    </Model>
  )),
  // drei frees the geometry that it finds on the mesh, which is the hatched one.
  Decal: part(
    'hatched',
    ({ changed }) => (
      <mesh name="model">
        <boxGeometry />
        <Look changed={changed} />
        <Decal position={[0, 0, 0.5]} rotation={[0, 0, 0]} scale={changed ? 0.5 : 0.7} map={texture} />
      </mesh>
    ),
    2,
  ),
  RoundedBox: part('hatched', ({ changed }) => (
    <RoundedBox name="model" args={[1, changed ? 0.6 : 1, 1]}>
      <Look changed={changed} />
    </RoundedBox>
  )),
  Box: part('hatched', ({ changed }) => (
    <Box name="model" args={[1, changed ? 0.6 : 1, 1]}>
      <Look changed={changed} />
    </Box>
  )),
  Torus: part('hatched', ({ changed }) => (
    <Torus name="model" args={[0.7, changed ? 0.2 : 0.3, 12, 32]}>
      <Look changed={changed} />
    </Torus>
  )),
  Text3D: part('hatched', ({ changed }) => (
    <Text3D name="model" font={typeface as unknown as FontData} size={0.8} height={0.2} position={[-1, 0, 0]}>
      {changed ? 'B' : 'A'}
      <Look changed={changed} />
    </Text3D>
  )),
  Svg: part('hatched', ({ changed }) => (
    <Svg src={star(changed ? 'navy' : 'tomato')} position={[-1, 1, 0]} fillMeshProps={{ name: 'model' }} />
  )),
  MarchingCubes: part('same', ({ changed }) => (
    <MarchingCubes
      userData={{ hatching: false }}
      resolution={16}
      maxPolyCount={4000}
      enableUvs={false}
      enableColors={false}
    >
      <MarchingCube strength={changed ? 0.7 : 0.5} subtract={12} position={[0, 0, 0]} />
      <Look changed={changed} />
    </MarchingCubes>
  )),
  Backdrop: part('hatched', ({ changed }) => (
    <Backdrop receiveShadow segments={8} floor={changed ? 0.5 : 0.25}>
      <Look changed={changed} />
    </Backdrop>
  )),
  'Mask and useMask': part('hatched', ({ changed }) => (
    <>
      <Mask id={1} position-z={0.5}>
        <circleGeometry args={[changed ? 0.5 : 0.4, 24]} />
      </Mask>
      <Masked changed={changed} />
    </>
  )),
  TransformControls: part('hatched', WithTarget),
  PivotControls: part('hatched', ({ changed }) => (
    <PivotControls scale={changed ? 1 : 0.8}>
      <Model changed={changed} />
    </PivotControls>
  )),
  GizmoHelper: part('hatched', ({ changed }) => (
    <>
      <Model changed={changed} />
      <GizmoHelper margin={[30, 30]}>
        <GizmoViewport scale={15} />
      </GizmoHelper>
    </>
  )),
  OrbitControls: part('hatched', ({ changed }) => (
    <>
      <OrbitControls enableDamping={changed} />
      <Model changed={changed} />
    </>
  )),
  // What reads an environment is made with the first one, and stays with the renderer.
  Environment: part(
    'hatched',
    ({ changed }) => (
      <>
        <Environment resolution={16}>
          <Lightformer intensity={2} position={[0, 3, 0]} />
        </Environment>
        <Model changed={changed} />
      </>
    ),
    2,
  ),
  SpotLight: part('hatched', ({ changed }) => (
    <>
      <SpotLight position={[0, 2.5, 0]} angle={changed ? 0.4 : 0.3} distance={4} />
      <Model changed={changed} />
    </>
  )),
  CubeCamera: part('hatched', ({ changed }) => (
    <CubeCamera frames={1} resolution={16}>
      {(map) => (
        <mesh name="model">
          <boxGeometry />
          <meshStandardMaterial color={colorOf(changed)} envMap={map} />
        </mesh>
      )}
    </CubeCamera>
  )),
  GradientTexture: part('hatched', ({ changed }) => (
    <mesh name="model">
      <boxGeometry />
      <meshStandardMaterial>
        <GradientTexture stops={[0, 1]} colors={changed ? ['navy', 'white'] : ['black', 'white']} size={16} />
      </meshStandardMaterial>
    </mesh>
  )),
  Html: part('hatched', ({ changed }) => (
    <>
      <Html>{changed ? 'words' : 'word'}</Html>
      <Model changed={changed} />
    </>
  )),
  'Html, occluded': part('hatched', ({ changed }) => (
    <>
      <Html transform occlude="blending">
        {changed ? 'words' : 'word'}
      </Html>
      <Model changed={changed} />
    </>
  )),
  Hud: part('hatched', ({ changed }) => (
    <>
      <Hud>
        <PerspectiveCamera makeDefault position={[0, 0, 6]} />
        <mesh position={[2, 2, 0]}>
          <planeGeometry args={[changed ? 0.5 : 0.4, 0.4]} />
          <meshBasicMaterial />
        </mesh>
      </Hud>
      <Model changed={changed} />
    </>
  )),
  Stage: part('hatched', ({ changed }) => (
    <Stage environment={null} adjustCamera={false} shadows={false}>
      <Model changed={changed} />
    </Stage>
  )),
  AccumulativeShadows: part('varies', ({ changed }) => (
    <>
      <AccumulativeShadows frames={2} resolution={32} position-y={-0.8} scale={changed ? 3 : 2}>
        <RandomizedLight amount={1} position={[1, 3, 1]} />
      </AccumulativeShadows>
      <Model changed={changed} />
    </>
  )),
  Caustics: part('hatched', ({ changed }) => (
    <Caustics causticsOnly={false} backside={false} frames={1} resolution={32} color={colorOf(changed)}>
      <Model changed={changed} />
    </Caustics>
  )),
  Trail: part('hatched', ({ changed }) => (
    <Trail length={2} color={colorOf(changed)}>
      <Model changed={changed} />
    </Trail>
  )),
  MeshReflectorMaterial: part('same', ({ changed }) => (
    <mesh>
      <planeGeometry args={[2, changed ? 1 : 2]} />
      <MeshReflectorMaterial resolution={32} mirror={1} color={colorOf(changed)} />
    </mesh>
  )),
  MeshTransmissionMaterial: part('same', ({ changed }) => (
    <mesh>
      <sphereGeometry args={[changed ? 0.6 : 0.7, 24, 16]} />
      <MeshTransmissionMaterial samples={1} resolution={32} distortion={0} temporalDistortion={0} />
    </mesh>
  )),
  MeshDistortMaterial: part('same', ({ changed }) => (
    <mesh>
      <sphereGeometry args={[0.7, 24, 16]} />
      <MeshDistortMaterial speed={0} color={colorOf(changed)} />
    </mesh>
  )),
  MeshWobbleMaterial: part('same', ({ changed }) => (
    <mesh>
      <boxGeometry />
      <MeshWobbleMaterial speed={0} color={colorOf(changed)} />
    </mesh>
  )),
  MeshPortalMaterial: part('same', ({ changed }) => (
    <mesh>
      <planeGeometry args={[1, changed ? 1 : 1.5]} />
      <MeshPortalMaterial blur={0} resolution={32}>
        <color attach="background" args={[colorOf(changed)]} />
      </MeshPortalMaterial>
    </mesh>
  )),
  MeshDiscardMaterial: part('same', ({ changed }) => (
    <mesh>
      <boxGeometry args={[1, changed ? 1 : 2, 1]} />
      <MeshDiscardMaterial />
    </mesh>
  )),
  Wireframe: part('same', ({ changed }) => (
    <mesh>
      <icosahedronGeometry args={[0.8, changed ? 2 : 1]} />
      <Wireframe fill={colorOf(changed)} />
    </mesh>
  )),
  RenderTexture: part('same', ({ changed }) => (
    <mesh>
      <planeGeometry args={[1.5, 1.5]} />
      <meshBasicMaterial>
        <RenderTexture attach="map" width={32} height={32} frames={1}>
          <color attach="background" args={[colorOf(changed)]} />
        </RenderTexture>
      </meshBasicMaterial>
    </mesh>
  )),
  Sky: part('same', ({ changed }) => <Sky sunPosition={changed ? [0, 1, 0] : [1, 0.2, 0]} />),
  Grid: part('same', ({ changed }) => <Grid args={[4, 4]} position-y={-0.6} cellColor={colorOf(changed)} />),
  ContactShadows: part('same', ({ changed }) => (
    <ContactShadows position-y={-0.7} resolution={32} frames={2} opacity={changed ? 1 : 0.5} />
  )),
  Shadow: part('same', ({ changed }) => (
    <Shadow
      userData={{ hatching: false }}
      position={[0, -0.7, 0]}
      scale={changed ? 2 : 1.5}
      colorStop={0}
      color="black"
      opacity={0.5}
    />
  )),
  Image: part('same', ({ changed }) => <Image url={picture} scale={changed ? 1.5 : 1} />),
  Text: part('same', ({ changed }) => (
    <Text font={font} fontSize={changed ? 1 : 0.8} color={colorOf(changed)}>
      hatch
    </Text>
  )),
  ScreenQuad: part('same', ({ changed }) => (
    <ScreenQuad>
      <shaderMaterial
        key={String(changed)}
        vertexShader="void main() { gl_Position = vec4(position.xy, 1.0, 1.0); }"
        fragmentShader={`void main() { gl_FragColor = vec4(${changed ? '1.0' : '0.5'}, 0.0, 0.0, 1.0); }`}
      />
    </ScreenQuad>
  )),
  Line: part('same', ({ changed }) => <Line points={LINE} color={colorOf(changed)} lineWidth={3} />),
  QuadraticBezierLine: part('same', ({ changed }) => (
    <QuadraticBezierLine start={[-1, 0, 0]} end={[1, 0, 0]} mid={[0, 1, 0]} color={colorOf(changed)} lineWidth={3} />
  )),
  CubicBezierLine: part('same', ({ changed }) => (
    <CubicBezierLine
      start={[-1, 0, 0]}
      end={[1, 0, 0]}
      midA={[0, 1, 0]}
      midB={[0, -1, 0]}
      color={colorOf(changed)}
      lineWidth={3}
    />
  )),
  CatmullRomLine: part('same', ({ changed }) => (
    <CatmullRomLine points={LINE} color={colorOf(changed)} lineWidth={3} />
  )),
  Segments: part('same', ({ changed }) => (
    <Segments limit={4} lineWidth={3}>
      <Segment start={[-1, 0, 0]} end={[1, changed ? 1 : 0, 0]} color={colorOf(changed)} />
    </Segments>
  )),
  Points: part('same', ({ changed }) => (
    <Points limit={4}>
      <pointsMaterial size={0.3} vertexColors />
      <Point position={[changed ? 1 : 0, 0, 0]} color={colorOf(changed)} />
    </Points>
  )),
  Stars: part('varies', ({ changed }) => <Stars count={changed ? 50 : 100} radius={3} depth={1} />),
  Sparkles: part('varies', ({ changed }) => <Sparkles count={changed ? 10 : 20} />),
  Cloud: part('varies', ({ changed }) => (
    <Clouds texture={picture}>
      <Cloud segments={changed ? 3 : 5} />
    </Clouds>
  )),
};

/** Tells that what stands beside it has loaded. */
function Loaded({ onLoaded }: { onLoaded: () => void }) {
  useEffect(onLoaded);
  return null;
}

interface ShownProps {
  name: string;
  changed: boolean;
  onLoaded: () => void;
}

/** A part, which may load what it needs. */
export function Shown({ name, changed, onLoaded }: ShownProps) {
  const { Content } = PARTS[name];
  return (
    <Suspense fallback={null}>
      <Content changed={changed} />
      <Loaded onLoaded={onLoaded} />
    </Suspense>
  );
}
