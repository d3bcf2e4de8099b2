import { type Material, MeshBasicMaterial, Texture, type WebGLRenderer } from 'three';
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';
import { isRigid, keepHooks, type ProgramParameters } from '../../../../src/material/three/hooks.js';

// Materials are read in the same task in which they are created.
await HatchingMaterial.preload();

// No renderer calls the second hook here, as with WebGPURenderer.
beforeEach(() => void vi.spyOn(console, 'error').mockImplementation(() => {}));
afterEach(() => vi.restoreAllMocks());

const RIGID = '#define RIGID\n';
const renderer = {} as WebGLRenderer;

/** The argument that the renderer passes to `onBeforeCompile`. */
const program = (flags: Partial<ProgramParameters> = {}): ProgramParameters =>
  ({ vertexShader: 'vertex', fragmentShader: 'fragment', ...flags }) as ProgramParameters;

/** Builds a program as the renderer does: it reads the key, then calls the hook. */
function compiled(material: Material, flags?: Partial<ProgramParameters>): [key: string, shader: ProgramParameters] {
  const key = material.customProgramCacheKey();
  const shader = program(flags);
  material.onBeforeCompile(shader, renderer);
  return [key, shader];
}

/** Properties of every material of three.js. */
describe.each([
  ['MeshBasicMaterial', () => new MeshBasicMaterial()],
  ['HatchingMaterial', () => new HatchingMaterial()],
])('the hooks of a %s', (_name, make) => {
  test('the key is the source of onBeforeCompile, which may be called without its material', () => {
    const material = make();
    const { onBeforeCompile } = material;
    expect(material.customProgramCacheKey()).toBe(onBeforeCompile.toString());
    expect(() => onBeforeCompile(program(), renderer)).not.toThrow();
    const hook = (shader: ProgramParameters): void => {
      shader.vertexShader += '// mine';
    };
    material.onBeforeCompile = hook;
    expect(material.onBeforeCompile.toString()).toBe(hook.toString());
    expect(material.customProgramCacheKey()).toBe(hook.toString());
    const other = make();
    other.onBeforeCompile = () => {};
    expect(other.customProgramCacheKey()).not.toBe(material.customProgramCacheKey());
  });

  test('decorators of the key call the previous one, however many there are', () => {
    const material = make();
    const plain = material.customProgramCacheKey();
    for (const letter of 'xyz') {
      const key = material.customProgramCacheKey;
      material.customProgramCacheKey = function () {
        return key.call(this) + letter;
      };
    }
    expect(material.customProgramCacheKey()).toBe(`${plain}xyz`);
  });

  test('decorators of onBeforeCompile call the previous one, bound or not, and each is called once, with the material', () => {
    const material = make();
    const calls: unknown[] = [];
    material.onBeforeCompile = function (shader, given) {
      calls.push(this === undefined || this === material, given === renderer);
      shader.vertexShader += '1';
    };
    for (const [letter, isBound] of [['2', true] as const, ['3', false] as const]) {
      const before = material.onBeforeCompile;
      material.onBeforeCompile = function (shader, given) {
        if (isBound) before.call(this, shader, given);
        else before(shader, given);
        shader.vertexShader += letter;
      };
    }
    expect(compiled(material)[1].vertexShader.endsWith('vertex123')).toBe(true);
    expect(calls).toEqual([true, true]);
  });

  test('a hook that was read can be set again, also on another material, and delete removes it', () => {
    const [material, another] = [make(), make()];
    const plain = material.customProgramCacheKey();
    const { onBeforeCompile, customProgramCacheKey } = material;
    const hook = vi.fn();
    material.onBeforeCompile = hook;
    material.customProgramCacheKey = () => 'mine';
    expect(compiled(material)[0]).toBe('mine');
    material.onBeforeCompile = onBeforeCompile;
    material.customProgramCacheKey = customProgramCacheKey;
    expect(compiled(material)[0]).toBe(plain);
    another.onBeforeCompile = onBeforeCompile;
    expect(compiled(another)[0]).toBe(plain);
    another.onBeforeCompile = hook;
    another.customProgramCacheKey = () => 'mine';
    Reflect.deleteProperty(another, 'onBeforeCompile');
    Reflect.deleteProperty(another, 'customProgramCacheKey');
    expect(compiled(another)[0]).toBe(plain);
    expect(hook).toHaveBeenCalledTimes(1);
  });

  test('are not copied', () => {
    const material = make();
    const hook = vi.fn();
    material.onBeforeCompile = hook;
    material.customProgramCacheKey = () => 'mine';
    expect(compiled(material.clone())[0]).toBe(make().customProgramCacheKey());
    expect(hook).not.toHaveBeenCalled();
  });

  test('methods of a class that extends it count', () => {
    const Base = make().constructor as new () => Material;
    class Mine extends Base {
      override customProgramCacheKey(): string {
        return `${super.customProgramCacheKey()} mine`;
      }
      override onBeforeCompile(shader: ProgramParameters): void {
        shader.vertexShader += ' mine';
      }
    }
    const [key, shader] = compiled(new Mine());
    expect(key.endsWith(' mine')).toBe(true);
    expect(shader.vertexShader.endsWith('vertex mine')).toBe(true);
  });
});

describe("the material's own part", () => {
  test('runs once, also if a hook that was read is set again, any number of times', () => {
    const material = new MeshBasicMaterial();
    const parts = { onBeforeRender: vi.fn(), onBeforeCompile: vi.fn(), customProgramCacheKey: vi.fn(() => 'ours') };
    keepHooks(material, parts);
    for (let times = 0; times < 2; times++) {
      const { onBeforeCompile, customProgramCacheKey } = material;
      Object.assign(material, { onBeforeCompile, customProgramCacheKey });
    }
    const [key] = compiled(material);
    expect(key).toBe(new MeshBasicMaterial().customProgramCacheKey());
    expect(parts.onBeforeCompile).toHaveBeenCalledOnce();
    expect(parts.customProgramCacheKey).toHaveBeenCalledOnce();
  });

  /** Every way for a user to set a hook, and none. */
  const ways: Record<string, (material: HatchingMaterial) => void> = {
    none: () => {},
    'a function': (material) => {
      material.onBeforeCompile = () => {};
      material.customProgramCacheKey = () => 'mine';
    },
    'a decorator': (material) => {
      const { onBeforeCompile, customProgramCacheKey } = material;
      material.onBeforeCompile = (shader, given) => {
        shader.vertexShader = `// mine\n${shader.vertexShader}`;
        onBeforeCompile(shader, given);
      };
      material.customProgramCacheKey = () => `${customProgramCacheKey()} mine`;
    },
    'what is taken back': (material) => {
      material.onBeforeCompile = () => {};
      Reflect.deleteProperty(material, 'onBeforeCompile');
      Reflect.deleteProperty(material, 'customProgramCacheKey');
    },
    nothing: (material) => {
      Object.assign(material, { onBeforeCompile: undefined });
    },
  };

  test.each(Object.entries(ways))('is done beside %s: RIGID once where nothing deforms, and defines', (_way, set) => {
    const material = new HatchingMaterial();
    set(material);
    material.map = new Texture();
    const { vertexShader, fragmentShader } = compiled(material)[1];
    for (const shader of [vertexShader, fragmentShader]) expect(shader.split(RIGID)).toHaveLength(2);
    expect(material.defines).toMatchObject({ MAP_CHANNEL: 'vUv', USE_UV0: '' });
    const skinned = compiled(material, { skinning: true })[1];
    expect(skinned.vertexShader + skinned.fragmentShader).not.toContain(RIGID);
  });
});

describe('isRigid', () => {
  const none = { skinning: false, instancing: false, batching: false, morphTargets: false, morphNormals: false };

  test('holds if vertices move only with their object', () => {
    expect(isRigid(none as ProgramParameters)).toBe(true);
  });

  test.each(Object.keys(none))('does not hold with %s', (name) => {
    expect(isRigid({ ...none, [name]: true } as ProgramParameters)).toBe(false);
  });
});
