import { Canvas } from '@react-three/fiber';
import { useState } from 'react';
import { createRoot } from 'react-dom/client';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { type PresetName, presets } from 'three-hatching';
import { Hatched } from 'three-hatching/react';

function Drawing() {
  const [preset, setPreset] = useState<PresetName>('woodcut');
  const { paper } = presets[preset].material;
  return (
    <>
      <Canvas
        shadows="percentage"
        frameloop="demand"
        camera={{ position: [0, 1.6, 5], fov: 30 }}
        onCreated={({ camera, gl, invalidate }) => {
          new OrbitControls(camera, gl.domElement).addEventListener('change', () => invalidate());
        }}
        role="img"
        aria-label={`Rings in the look ${preset}`}
      >
        <color attach="background" args={[paper ?? 'white']} />
        <directionalLight position={[-3, 4, 3]} intensity={Math.PI} castShadow shadow-normalBias={0.02} />
        <Hatched preset={preset}>
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
