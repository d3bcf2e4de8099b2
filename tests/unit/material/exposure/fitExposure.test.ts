import {
  AmbientLight,
  BoxGeometry,
  BufferAttribute,
  Color,
  DataTexture,
  DirectionalLight,
  EquirectangularReflectionMapping,
  FloatType,
  Group,
  HemisphereLight,
  InstancedMesh,
  type Light,
  LOD,
  Matrix4,
  Mesh,
  PlaneGeometry,
  PointLight,
  RGBAFormat,
  Scene,
  SphereGeometry,
  SpotLight,
  Vector3,
  Vector4,
} from 'three';
import { fitExposure, HatchingMaterial, type HatchingMaterialParameters, HatchingShadowMaterial } from 'three-hatching';
import { describe, expect, test } from 'vitest';
import { lightness } from '../../../../src/look/vectors.js';
import { ExposureFit } from '../../../../src/material/exposure/ExposureFit.js';
import { planScene } from '../../../../src/material/exposure/planScene.js';
import type { ToneFit } from '../../../../src/material/exposure/ToneFit.js';
import { writeValues } from '../../../../src/material/exposure/writeFit.js';

const ball = new SphereGeometry(1, 128, 64);
const auto = (parameters: HatchingMaterialParameters = {}): HatchingMaterial =>
  new HatchingMaterial({ composition: { exposure: 'auto' }, reflectedLight: 0, ...parameters });

function sun(intensity: number, x = 1, y = 2, z = 3): DirectionalLight {
  const light = new DirectionalLight(0xffffff, intensity);
  light.position.set(x, y, z);
  return light;
}

const sceneOf = (...objects: (Mesh | Light | Group | LOD)[]): Scene => new Scene().add(...objects);

/** A radiance after a fit. */
const exposed = ({ scale, offset }: { scale: number; offset: number }, radiance: number): number =>
  scale * radiance + offset;

describe('a sphere in one light', () => {
  test.each([0.05, 1, Math.PI, 40])('of intensity %d is drawn as in one of π', (intensity) => {
    const { scale, offset } = fitExposure(sceneOf(new Mesh(ball, auto()), sun(intensity)));
    // A tenth of 2048 samples is 205; one sample more or less is half a percent.
    expect(Math.abs((scale * intensity) / Math.PI - 1)).toBeLessThan(0.01);
    expect(offset).toBe(0);
  });

  test.each([
    { toneModel: 'halfLambert' },
    { reflectedLight: 0.4 },
    { toneModel: 'halfLambert', reflectedLight: 0.2 },
  ] as const)('of intensity π is left as it is with %o', (parameters) => {
    const { scale, offset } = fitExposure(sceneOf(new Mesh(ball, auto(parameters)), sun(Math.PI)));
    expect(scale).toBeCloseTo(1, 1);
    expect(offset).toBeCloseTo(0, 1);
  });

  test('may be of any size, in any place, and turned', () => {
    const mesh = new Mesh(ball, auto());
    mesh.position.set(30, -40, 5);
    mesh.rotation.set(1, 2, 3);
    mesh.scale.setScalar(7);
    expect(fitExposure(sceneOf(mesh, sun(2))).scale).toBeCloseTo(Math.PI / 2, 1);
  });

  test('loses the light from all around, where nothing else is dark', () => {
    const fit = fitExposure(sceneOf(new Mesh(ball, auto()), sun(Math.PI), new AmbientLight(0xffffff, 0.6 * Math.PI)));
    expect(fit.scale).toBeCloseTo(1, 1);
    expect(fit.offset).toBeCloseTo(-0.6, 1);
  });

  test('of a colour goes by its luminance', () => {
    const light = sun(Math.PI);
    light.color.setRGB(0.5, 0, 0);
    expect(fitExposure(sceneOf(new Mesh(ball, auto()), light)).scale).toBeCloseTo(1 / (0.5 * 0.2126), 0);
  });
});

describe('lights', () => {
  test('at a place are attenuated as three.js does', () => {
    const lamp = new PointLight(0xffffff, 1000);
    lamp.position.set(30, 40, 0);
    const { scale } = fitExposure(sceneOf(new Mesh(ball, auto()), lamp));
    expect(scale).toBeCloseTo((Math.PI * 50 ** 2) / 1000, 0);
  });

  test('have cones', () => {
    const spot = new SpotLight(0xffffff, Math.PI, 0, 0.5, 0, 0);
    spot.position.set(0, 0, 50);
    const inside = fitExposure(sceneOf(new Mesh(ball, auto()), spot));
    expect(inside.scale).toBeCloseTo(1, 1);
    spot.target.position.set(50, 0, 50);
    const outside = fitExposure(sceneOf(new Mesh(ball, auto()), spot, new Group().add(spot.target)));
    expect(outside).toMatchObject({ scale: 1, offset: 0, white: 1 });
  });

  test('of a sky leave a range from its ground to its top', () => {
    const sky = new HemisphereLight(0xffffff, 0x000000, Math.PI);
    const fit = fitExposure(sceneOf(new Mesh(ball, auto()), sky));
    // A radiance of 0.5 + 0.5 y, of which a tenth lies above 0.9 and a tenth below 0.1.
    expect(exposed(fit, 0.9)).toBeCloseTo(0.8, 1);
    expect(exposed(fit, 0.1)).toBeCloseTo(0, 1);
  });

  test('all around, and no others, are blown up by no more than four', () => {
    const fit = fitExposure(sceneOf(new Mesh(ball, auto()), new AmbientLight(0xffffff, 1)));
    expect(fit.scale / Math.PI).toBeCloseTo(4 * 0.8, 1);
    expect(exposed(fit, 1 / Math.PI)).toBeCloseTo(0.8, 1);
  });

  test('that there are none leaves all as it is', () => {
    expect(fitExposure(sceneOf(new Mesh(ball, auto())))).toMatchObject({ scale: 1, offset: 0, white: 1 });
    expect(fitExposure(new Scene())).toMatchObject({ scale: 1, offset: 0, white: 1 });
  });

  test('of an environment come from where its image is bright', () => {
    const rows = 32;
    const data = new Float32Array(4 * 2 * rows * rows);
    // The upper half is white; row 0 is the lowest.
    for (let i = 0; i < 2 * rows * rows; i++) data.fill(i >= rows * rows ? 1 : 0, 4 * i, 4 * i + 4);
    const texture = new DataTexture(data, 2 * rows, rows, RGBAFormat, FloatType);
    texture.mapping = EquirectangularReflectionMapping;
    const scene = sceneOf(new Mesh(ball, auto()));
    scene.environment = texture;
    // As a hemisphere light.
    const upright = fitExposure(scene);
    expect(exposed(upright, 0.9)).toBeCloseTo(0.8, 1);
    expect(exposed(upright, 0.1)).toBeCloseTo(0, 1);
    scene.environmentIntensity = 5;
    expect(fitExposure(scene).scale).toBeCloseTo(upright.scale / 5, 5);
    // A cup that is open at the top is lit from above, however the image is turned about the vertical axis.
    scene.environmentRotation.set(0, 1, 0);
    expect(fitExposure(scene).scale).toBeCloseTo(upright.scale / 5, 2);
  });
});

describe('surfaces', () => {
  test('count by their area in the world', () => {
    const large = new Mesh(ball, auto());
    const small = new Mesh(ball, auto({ emissive: new Color(1, 1, 1), emissiveIntensity: 50 }));
    small.scale.setScalar(0.05);
    const alone = fitExposure(sceneOf(large.clone(), sun(Math.PI)));
    expect(fitExposure(sceneOf(large, small, sun(Math.PI))).scale).toBeCloseTo(alone.scale, 1);
    small.scale.setScalar(5);
    expect(fitExposure(sceneOf(large, small, sun(Math.PI))).scale).toBeLessThan(0.1);
  });

  test('that are flat count only where there are no others', () => {
    const ground = new Mesh(new PlaneGeometry(100, 100).rotateX(-Math.PI / 2), auto());
    const alone = fitExposure(sceneOf(new Mesh(ball, auto()), sun(Math.PI)));
    expect(fitExposure(sceneOf(new Mesh(ball, auto()), ground, sun(Math.PI)))).toEqual(alone);
    const light = sun(1, 0, 1, 0);
    expect(exposed(fitExposure(sceneOf(ground, light)), 1 / Math.PI)).toBeCloseTo(0.8, 1);
  });

  test('of other materials do not count', () => {
    const other = new Mesh(new BoxGeometry(50, 50, 50), new HatchingMaterial());
    const hidden = new Mesh(new BoxGeometry(50, 50, 50), auto());
    hidden.visible = false;
    const shadow = new Mesh(
      new BoxGeometry(50, 50, 50),
      new HatchingShadowMaterial({ composition: { exposure: 'auto' } }),
    );
    const alone = fitExposure(sceneOf(new Mesh(ball, auto()), sun(2)));
    expect(fitExposure(sceneOf(new Mesh(ball, auto()), other, hidden, shadow, sun(2)))).toEqual(alone);
  });

  test('of instances are those of all of them', () => {
    const many = new InstancedMesh(ball, auto(), 100);
    for (let i = 0; i < 100; i++) many.setMatrixAt(i, new Matrix4().makeTranslation(3 * i, 0, 0));
    expect(fitExposure(sceneOf(many, sun(1))).scale).toBeCloseTo(Math.PI, 1);
  });

  test('with baked occlusion are darker', () => {
    const baked = ball.clone();
    const data = new Float32Array(4 * baked.attributes.position.count);
    for (let i = 3; i < data.length; i += 4) data[i] = -0.5;
    baked.setAttribute('hatchNormal', new BufferAttribute(data, 4));
    const { scale } = fitExposure(sceneOf(new Mesh(baked, auto()), sun(Math.PI)));
    expect(scale).toBeCloseTo(2, 1);
    const { scale: half } = fitExposure(sceneOf(new Mesh(baked, auto({ occlusion: 0.5 })), sun(Math.PI)));
    expect(half).toBeCloseTo(4 / 3, 1);
  });

  test('whose coordinates are no numbers are left out', () => {
    const broken = new BoxGeometry(9, 9, 9);
    (broken.attributes.position.array as Float32Array).fill(Number.NaN);
    const alone = fitExposure(sceneOf(new Mesh(ball, auto()), sun(2)));
    expect(fitExposure(sceneOf(new Mesh(ball, auto()), new Mesh(broken, auto()), sun(2)))).toEqual(alone);
  });
});

describe('colours', () => {
  const grey = (luminance: number, parameters: HatchingMaterialParameters = {}) =>
    auto({ color: new Color(luminance, luminance, luminance), colorHatching: 1, ...parameters });
  // Half as light as white, to the eye.
  const MIDDLE = 0.18418651851;

  test('are left white from the lightest tenth on', () => {
    expect(fitExposure(sceneOf(new Mesh(ball, grey(MIDDLE)), sun(1))).white).toBeCloseTo(0.5, 3);
    expect(fitExposure(sceneOf(new Mesh(ball, grey(1)), sun(1))).white).toBe(1);
    const light = new Mesh(ball, grey(1));
    light.scale.setScalar(0.3);
    const scene = sceneOf(new Mesh(ball, grey(MIDDLE)), light, sun(1));
    expect(fitExposure(scene).white).toBeCloseTo(0.5, 3);
    light.scale.setScalar(0.4);
    expect(fitExposure(scene).white).toBeCloseTo(1, 2);
  });

  test('that are all nearly black do not become white', () => {
    expect(fitExposure(sceneOf(new Mesh(ball, grey(0.01)), sun(1))).white).toBe(0.3);
  });

  test('do not count where they make no tone', () => {
    expect(fitExposure(sceneOf(new Mesh(ball, grey(MIDDLE, { colorHatching: 0 })), sun(1))).white).toBe(1);
  });

  test('are those of vertices and maps too', () => {
    const painted = ball.clone();
    const { count } = painted.attributes.position;
    painted.setAttribute('color', new BufferAttribute(new Float32Array(3 * count).fill(MIDDLE), 3));
    const ofVertices = sceneOf(new Mesh(painted, grey(1, { vertexColors: true })), sun(1));
    expect(fitExposure(ofVertices).white).toBeCloseTo(0.5, 3);
    // Left half dark, right half of middle grey.
    const data = new Float32Array([0.01, 0.01, 0.01, 1, MIDDLE, MIDDLE, MIDDLE, 1]);
    const map = new DataTexture(data, 2, 1, RGBAFormat, FloatType);
    expect(fitExposure(sceneOf(new Mesh(ball, grey(1, { map })), sun(1))).white).toBeCloseTo(0.5, 3);
    // The left half alone.
    map.repeat.set(0.4, 1);
    expect(fitExposure(sceneOf(new Mesh(ball, grey(1, { map })), sun(1))).white).toBe(0.3);
  });

  test('of undersides hardly count in the plan of values', () => {
    /** The darkness of the middle grey on one side of a slab whose other side is white. */
    const darkness = (side: 'above' | 'below'): number => {
      const [above, below] = [new PlaneGeometry(), new PlaneGeometry()];
      above.rotateX(-Math.PI / 2);
      below.rotateX(Math.PI / 2);
      const [seen, other] = side === 'above' ? [above, below] : [below, above];
      const { plan } = fitExposure(sceneOf(new Mesh(seen, grey(MIDDLE)), new Mesh(other, grey(1)), sun(1)));
      return plan.knots.reduce((sum, knot, i) => sum + plan.bends[i] * Math.max(knot - 0.5, 0), 0);
    };
    expect(darkness('above')).toBeLessThan(0.05);
    expect(darkness('below')).toBeGreaterThan(0.14);
  });
});

describe('parts of several materials', () => {
  const grey = (lightness: number, name = ''): HatchingMaterial => {
    const luminance = ((lightness + 0.16) / 1.16) ** 3;
    return auto({ name, color: new Color(luminance, luminance, luminance), colorHatching: 1 });
  };
  /** The darkness of a material in the plan of a scene. */
  const darkness = ({ plan }: ToneFit, material: HatchingMaterial): number => {
    const [knots, bends] = [new Vector4(), new Vector4()];
    writeValues(plan, material, knots, bends);
    const light = lightness(material.color.r);
    return knots.toArray().reduce((sum, knot, i) => sum + bends.toArray()[i] * Math.max(knot - light, 0), 0);
  };
  test('count by the material of each group, and not where triangles are in no group', () => {
    const box = new BoxGeometry(1, 1, 1);
    const [white, black] = [grey(1), grey(0.1)];
    const together = new Mesh(box, [white, white, black, black, white, white]);
    const split = (materials: readonly [number, HatchingMaterial][]): Mesh[] =>
      materials.map(([group, material]) => {
        const side = box.clone();
        side.clearGroups();
        side.setDrawRange(6 * group, 6);
        return new Mesh(side, material);
      });
    const sides = split([0, 1, 2, 3, 4, 5].map((group) => [group, group === 2 || group === 3 ? black : white]));
    const apart = fitExposure(sceneOf(...sides, sun(1)));
    const fit = fitExposure(sceneOf(together, sun(1)));
    expect(darkness(fit, black)).toBeCloseTo(darkness(apart, black), 1);
    expect(darkness(fit, black)).toBeGreaterThan(0.15);
    box.groups.splice(2, 2);
    expect(darkness(fitExposure(sceneOf(together, sun(1))), white)).toBeCloseTo(0, 9);
    expect(fitExposure(sceneOf(together, sun(1))).white).toBe(1);
  });

  test('that are many and small have the mean tone of those beside them, and few keep their own', () => {
    const materials = [grey(0.9), grey(0.1)];
    const ring = (count: number): Mesh[] =>
      Array.from({ length: count }, (_, i) => {
        const stone = new Mesh(new SphereGeometry(0.1, 8, 6), materials[i % 2]);
        const angle = (2 * Math.PI * i) / count;
        stone.position.set(3 * Math.cos(angle), 0, 3 * Math.sin(angle));
        return stone;
      });
    const [light, dark] = materials.map((material) => darkness(fitExposure(sceneOf(...ring(100), sun(1))), material));
    const few = fitExposure(sceneOf(...ring(12), sun(1)));
    expect(darkness(few, materials[0])).toBeCloseTo(0, 9);
    expect(darkness(few, materials[1])).toBeGreaterThan(0.15);
    expect(light).toBeCloseTo(darkness(few, materials[1]) / 2, 2);
    expect(dark).toBeCloseTo(light, 5);
  });
});

describe('the fit', () => {
  test('is the function of the scene, whatever came before', () => {
    const mesh = new Mesh(ball, auto({ reflectedLight: 0.3 }));
    const light = sun(2);
    const scene = sceneOf(mesh, light, new AmbientLight(0xffffff, 0.3));
    const fit = new ExposureFit((use) => use(planScene));
    const update = () => {
      scene.updateMatrixWorld();
      return { ...fit.update(scene, -1) };
    };
    const before = update();
    for (let i = 0; i < 20; i++) {
      light.position.set(Math.cos(i), Math.sin(i), 1);
      light.intensity = i + 0.1;
      mesh.rotation.y = i;
      expect(update()).toEqual(fitExposure(scene));
    }
    light.position.set(1, 2, 3);
    light.intensity = 2;
    mesh.rotation.y = 0;
    expect(update()).toEqual(before);
  });

  test('follows whatever it depends on', () => {
    const light = sun(2);
    const spot = new SpotLight(0xffffff, 9, 0, 0.2, 0, 0);
    const material = auto({ reflectedLight: 0.2 });
    const mesh = new Mesh(new BoxGeometry(1, 2, 3), material);
    const scene = sceneOf(mesh, light, spot);
    const fit = new ExposureFit((use) => use(planScene));
    const changes: (() => void)[] = [
      () => light.color.set('red'),
      () => light.target.position.set(0, 3, 0),
      () => spot.position.set(0, 0, 3),
      () => Object.assign(spot, { penumbra: 0.9 }),
      () => mesh.rotateX(0.7),
      () => Object.assign(material, { reflectedLight: 0.5 }),
      () => material.emissive.set('gray'),
      () => Object.assign(material, { toneModel: 'halfLambert' }),
      () => Object.assign(mesh, { geometry: new SphereGeometry() }),
      () => Object.assign(light, { visible: false }),
      () => scene.add(new AmbientLight(0xffffff, 1)),
    ];
    for (const [i, change] of changes.entries()) {
      const { scale, offset } = fit.update(scene, -1);
      change();
      scene.updateMatrixWorld();
      light.target.updateMatrixWorld();
      const after = { ...fit.update(scene, -1) };
      expect(after, `${i}`).not.toEqual({ scale, offset });
      expect(after).toEqual(fitExposure(scene));
    }
  });

  test('of a thing with levels of detail is that of the finest, whichever is shown', () => {
    const lod = new LOD();
    lod.addLevel(new Mesh(ball, auto()), 0);
    lod.addLevel(new Mesh(new BoxGeometry(), auto()), 10);
    const scene = sceneOf(lod, sun(2));
    const near = fitExposure(scene);
    [lod.levels[0].object.visible, lod.levels[1].object.visible] = [false, true];
    expect(fitExposure(scene)).toEqual(near);
  });

  test('refuses what is no object', () => {
    expect(() => fitExposure(new Vector3() as never)).toThrow('fitExposure: expected a THREE.Object3D');
  });
});
