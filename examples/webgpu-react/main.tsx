import { Canvas, useThree } from '@react-three/fiber';
import { type ReactNode, useEffect, useRef, useState } from 'react';
import { createRoot } from 'react-dom/client';
import type { Group } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { WebGPURenderer } from 'three/webgpu';
import { type PresetName, presets } from 'three-hatching';
import { applyHatching, type HatchedNodeScene } from 'three-hatching/webgpu';

interface HatchedProps {
  preset: PresetName;
  onHatched: (preset: PresetName) => void;
  children: ReactNode;
}

/** Hatches its children. With another preset, they are drawn as before until they are hatched anew. */
function Hatched({ preset, onHatched, children }: HatchedProps) {
  const group = useRef<Group>(null);
  const hatched = useRef<HatchedNodeScene>(undefined);
  const invalidate = useThree((state) => state.invalidate);

  useEffect(() => {
    const root = group.current!;
    const changed = new AbortController();
    const { signal } = changed;
    const ready = hatched.current?.setPreset(preset, { signal }) ?? applyHatching(root, preset, { signal });
    ready.then(
      (present) => {
        hatched.current = present;
        root.visible = true;
        onHatched(preset);
        invalidate();
      },
      (error) => {
        if (!changed.signal.aborted) console.error(error);
      },
    );
    return () => changed.abort();
  }, [preset, onHatched, invalidate]);
  useEffect(() => () => hatched.current?.dispose(), []);

  return (
    <group ref={group} visible={false}>
      {children}
    </group>
  );
}

function Drawing() {
  const [preset, setPreset] = useState<PresetName>('crossHatching');
  const [shown, setShown] = useState(preset);
  const { paper } = presets[shown].material;
  return (
    <>
      <Canvas
        flat // This renderer maps the tones of all that it draws, paper and ink among them.
        shadows="percentage"
        frameloop="demand"
        camera={{ position: [0, 1.6, 5], fov: 30 }}
        gl={async ({ canvas }) => {
          // The types leave room for a canvas of a worker, which <Canvas> never has.
          const element = canvas instanceof HTMLCanvasElement ? canvas : undefined;
          const renderer = new WebGPURenderer({ canvas: element, antialias: true });
          await renderer.init();
          return renderer;
        }}
        onCreated={({ camera, gl, invalidate }) => {
          new OrbitControls(camera, gl.domElement).addEventListener('change', () => invalidate());
        }}
        role="img"
        aria-label={`Rings in the look ${shown}`}
      >
        <color attach="background" args={[paper ?? 'white']} />
        <directionalLight position={[-3, 4, 3]} intensity={Math.PI} castShadow shadow-normalBias={0.02} />
        <Hatched preset={preset} onHatched={setShown}>
          {[0, 1, 2].map((i) => (
            <mesh key={i} rotation={[0.9 * i, 0.5 + i, 0]} castShadow receiveShadow>
              <torusGeometry args={[1.15 - 0.38 * i, 0.17, 48, 128]} />
              <meshStandardMaterial />
            </mesh>
          ))}
        </Hatched>
      </Canvas>
      <select aria-label="Preset" value={preset} onChange={(event) => setPreset(event.target.value as PresetName)}>
        {Object.keys(presets).map((name) => (
          <option key={name}>{name}</option>
        ))}
      </select>
    </>
  );
}

createRoot(document.querySelector('.picture')!).render(<Drawing />);
