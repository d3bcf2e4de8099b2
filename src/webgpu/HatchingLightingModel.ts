import type { Light } from 'three';
import { LightingModel, type NodeBuilder } from 'three/webgpu';
import { TONE_CONSTANTS } from '../look/constants/shadingConstants.js';
import type { ReceivedShadow } from './nodes/base/lights.js';
import { directedLights, fallOff, hasPlace, valuesFor } from './nodes/base/lights.js';
import { lightLuminance } from './nodes/base/maths.js';
import { hatchingUniform } from './nodes/base/uniforms.js';
import { tsl, type Value } from './nodes/base/values.js';
import { openToLights, openToSky } from './nodes/chunks/occlusion.js';
import { hasShadows, type ShadowedLight, type ShadowOfLight, separateShadow } from './nodes/chunks/shadows.js';
import { shadowLeft } from './nodes/chunks/softShadows.js';
import type { HatchingSurface } from './nodes/chunks/tone.js';

const { cameraViewMatrix, cross, dot, float, fwidth, length, max, normalView, positionView, positionViewDirection } =
  tsl;
const { pow, smoothstep, step, vec4 } = tsl;
const { BESIDE_FROM, BESIDE_LIGHT, LEAST_RESPONSE, SIDE_AXIS } = TONE_CONSTANTS;

/** The changes of the normal from one pixel to the next below which a surface counts as plane, and above which as round. */
const PLANE = [2e-5, 1e-4] as const;

const shininess = /* @__PURE__ */ hatchingUniform('shininess', 'float');
const reflectedLight = /* @__PURE__ */ hatchingUniform('reflectedLight', 'float');

interface LightingContext {
  /** The share of ambient light that an ambient occlusion map leaves. */
  ambientOcclusion: Value;
  irradiance: Value;
  /** The irradiance of an environment map. */
  iblIrradiance: Value;
  outgoingLight: Value;
  /** Colour of a light that casts shadows. */
  getShadow?: (light: ShadowedLight) => Value;
}

/** The choices that the sum of the lights depends on. */
export interface LightingChoices {
  toneModel: string;
  /** The choice `shadowStrokes`, resolved. */
  shadowStrokes: string;
  /** Whether strokes of a hand end at the edges of shadows. */
  endsStrokes: boolean;
}

/** The lighting of a surface, without the darkness of its own colour. */
export type LitSurface = Omit<HatchingSurface, 'darkness' | 'castShadows'>;

/** A surface that no light reaches. */
export const unlitSurface = (): LitSurface => ({
  radiance: float(0),
  shadowed: null,
  shadowLeft: null,
  receivedShadows: [],
});

/** Sums over the lights that cast shadows. */
interface ShadowSums {
  /** Radiance that shadows take. */
  shadowed: Value;
  /** Luminance that shadows take, and the part of it that has dissolved. */
  taken: Value;
  lost: Value;
}

/** The radiance of a white surface under the scene's lights, as in shaders/chunks/radiance.glsl. three's own nodes loop over the lights. */
export class HatchingLightingModel extends LightingModel {
  private radiance!: Value;
  /** 1 where the surface is plane, 0 where it is round. */
  private plane!: Value;
  private sums: ShadowSums | null = null;
  private receivedShadows: ReceivedShadow[] = [];
  /** The shadow of the current light; null if it casts none. */
  private shadow: ShadowOfLight | null = null;

  /** @param print makes the colour of a surface */
  constructor(
    private readonly choices: LightingChoices,
    private readonly lights: readonly Light[],
    private readonly print: (surface: LitSurface) => Value,
  ) {
    super();
  }

  /** True for surfaces that draw shadows alone. */
  private get dissolves(): boolean {
    return this.choices.toneModel === 'shadow';
  }

  override start(builder: NodeBuilder): void {
    this.radiance = float(0).toVar();
    const isRound = smoothstep(PLANE[0], PLANE[1], length(fwidth(normalView)));
    // The tone of a dissolving shadow is the share of the light that it takes.
    this.plane = this.dissolves ? float(0) : isRound.oneMinus().toVar();
    this.receivedShadows = [];
    const { shadowStrokes, endsStrokes } = this.choices;
    const isSeparate = (this.dissolves || shadowStrokes !== 'tone' || endsStrokes) && hasShadows(builder, this.lights);
    this.sums = isSeparate ? { shadowed: float(0).toVar(), taken: float(0).toVar(), lost: float(0).toVar() } : null;
    const context = builder.context as LightingContext;
    // An application may have set one of its own.
    context.getShadow ??= (lit) => {
      const shadow = separateShadow(builder, lit, this.dissolves);
      if (!isSeparate) return lit.baseColorNode.mul(shadow.shadow);
      this.shadow = shadow;
      return lit.baseColorNode;
    };
    super.start(builder);
  }

  override direct(light: unknown): void {
    const { lightDirection, lightColor } = light as { lightDirection: Value; lightColor: Value };
    const { toneModel } = this.choices;
    const cosine = dot(lightDirection, normalView).toVar();
    const halfway = cosine.mul(0.5).add(0.5);
    const response = (toneModel === 'halfLambert' ? halfway.mul(halfway) : max(cosine, 0)).toVar();
    if (toneModel === 'phong') {
      const toViewer = positionViewDirection;
      const mirrored = cosine.mul(2).mul(dot(toViewer, normalView)).sub(dot(lightDirection, toViewer));
      response.addAssign(step(0, cosine).mul(pow(max(mirrored, 1e-6), shininess)));
    }
    const luminance = lightLuminance(lightColor).toVar();
    const arriving = luminance.mul(response).div(Math.PI).toVar();
    if (this.shadow && this.sums) {
      this.takeShadow(this.shadow, this.sums, { arriving, luminance, facing: max(cosine, 0).toVar() });
      arriving.mulAssign(this.shadow.shadow);
      this.shadow = null;
    }
    this.radiance.addAssign(arriving);
  }

  /** @param facing the cosine between a light and the normal */
  private takeShadow(
    received: ShadowOfLight,
    { shadowed, taken, lost }: ShadowSums,
    { arriving, luminance, facing }: Record<'arriving' | 'luminance' | 'facing', Value>,
  ): void {
    const { light, shadow, toneLeft } = received;
    shadowed.addAssign(arriving.mul(shadow.oneMinus()));
    if (toneLeft) {
      const takes = luminance.mul(facing).mul(shadow.oneMinus()).toVar();
      taken.addAssign(takes);
      lost.addAssign(takes.mul(toneLeft.oneMinus()));
    }
    let isShadowed: Value | null = null;
    if (this.choices.shadowStrokes === 'reorient') {
      const isTaken = facing.mul(shadow.mul(2).oneMinus()).greaterThan(LEAST_RESPONSE);
      // A lamp casts no shadow beyond its reach.
      isShadowed = (hasPlace(light) ? isTaken.and(luminance.greaterThan(0)) : isTaken).toVar();
    }
    const sent = this.choices.endsStrokes ? arriving.toVar() : null;
    this.receivedShadows.push({ ...received, isShadowed, sent });
  }

  override indirect(builder: NodeBuilder): void {
    // three.js adds lights with a direction before hemisphere and ambient lights.
    const open = openToLights().toVar();
    this.radiance.mulAssign(open);
    this.sums?.shadowed.mulAssign(open);
    const { ambientOcclusion, irradiance, iblIrradiance } = builder.context as LightingContext;
    const surroundings = lightLuminance(irradiance.add(iblIrradiance)).div(Math.PI).mul(ambientOcclusion);
    this.radiance.addAssign(surroundings.mul(openToSky()));
  }

  override finish(builder: NodeBuilder): void {
    for (const light of directedLights(this.lights)) this.addReflection(light);
    const { radiance, sums, receivedShadows } = this;
    const surface: LitSurface = {
      radiance,
      shadowed: sums?.shadowed ?? null,
      shadowLeft: sums && this.dissolves ? shadowLeft(sums.taken, sums.lost).toVar() : null,
      receivedShadows,
    };
    (builder.context as LightingContext).outgoingLight.assign(this.print(surface));
  }

  /** Adds the light of one source that the surroundings reflect. The cone and the shadow of a lamp do not matter to it. */
  private addReflection(light: Light): void {
    const values = valuesFor(light);
    const isDistant = 'isDirectionalLight' in light;
    const way = isDistant ? values.direction : values.position.sub(positionView).toVar();
    const away = length(way).toVar();
    const toLight = way.div(away).toVar();
    const side = cross(toLight, cameraViewMatrix.mul(vec4(...SIDE_AXIS, 0)).xyz).toVar();
    const facing = max(dot(side.div(max(length(side), 1e-20)), normalView), 0);
    const behind = float(0.5).sub(dot(toLight, normalView).mul(0.5)).toVar();
    const beside = max(behind.sub(BESIDE_FROM), 0).mul(facing).mul(this.plane).mul(BESIDE_LIGHT);
    const seen = behind.add(beside);
    const arriving = isDistant ? lightLuminance(values.color) : lightLuminance(values.color).mul(fallOff(away, values));
    this.radiance.addAssign(openToSky().mul(reflectedLight).mul(arriving).div(Math.PI).mul(seen));
  }
}
