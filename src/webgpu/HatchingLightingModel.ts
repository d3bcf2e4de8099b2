import type { Light } from 'three';
import { LightingModel, type NodeBuilder } from 'three/webgpu';
import { TONE_CONSTANTS } from '../look/constants/shadingConstants.js';
import { directedLights, hasPlace } from './nodes/base/directedLights.js';
import type { HatchingSurface } from './nodes/base/HatchingSurface.js';
import type { ToldLight } from './nodes/base/ToldLight.js';
import { hatchingUniform } from './nodes/base/uniforms.js';
import { tsl, type Value } from './nodes/base/values.js';
import { lightLuminance } from './nodes/chunks/lightLuminance.js';
import { fallOff, valuesFor } from './nodes/chunks/meanLight.js';
import { openToLights, openToSky } from './nodes/chunks/occlude.js';
import { hasShadows, type ShadowedLight, tellShadow } from './nodes/chunks/shadows.js';
import { shadowLeft } from './nodes/chunks/softShadows.js';

const { cameraViewMatrix, cross, dot, float, fwidth, length, max, normalView, positionView, positionViewDirection } =
  tsl;
const { pow, smoothstep, step, vec4 } = tsl;
const { BESIDE_FROM, BESIDE_LIGHT, LEAST_RESPONSE, SIDE_AXIS } = TONE_CONSTANTS;

/** A surface is plane where its normal changes by less than the first from one pixel to the next, and round from the second on. */
const PLANE = [2e-5, 1e-4] as const;

const shininess = /* @__PURE__ */ hatchingUniform('shininess', 'float');
const reflectedLight = /* @__PURE__ */ hatchingUniform('reflectedLight', 'float');

interface LightingContext {
  /** What a map takes of the light of the surroundings. */
  ambientOcclusion: Value;
  irradiance: Value;
  /** That of an environment. */
  iblIrradiance: Value;
  outgoingLight: Value;
  /** Gives the colour of a light that casts shadows. */
  getShadow?: (light: ShadowedLight) => Value;
}

/** The choices that decide how light is gathered. */
export interface LightingChoices {
  toneModel: string;
  /** As they are drawn. */
  shadowStrokes: string;
}

/** What light makes of a surface, but for the surface's own colour. */
export type LitSurface = Omit<HatchingSurface, 'darkness'>;

/** A surface that no light reaches. */
export const unlitSurface = (): LitSurface => ({ radiance: float(0), shadowed: null, shadowLeft: null, told: [] });

/** Sums over the lights that cast shadows. */
interface ShadowSums {
  /** What they take of the radiance. */
  shadowed: Value;
  /** What they take of all lights, and how much of that has dissolved. */
  taken: Value;
  lost: Value;
}

/** The twin of shaders/chunks/radiance.glsl: the radiance that a white surface shows under the scene's lights. three's own nodes walk the lights. */
export class HatchingLightingModel extends LightingModel {
  private radiance!: Value;
  /** 1 where the surface is plane, 0 where it is round. */
  private plane!: Value;
  private sums: ShadowSums | null = null;
  private told: ToldLight[] = [];
  /** What is known of the shadow of the light at hand. */
  private shadow: Omit<ToldLight, 'isShadowed'> | null = null;

  /** @param print makes the colour of a surface */
  constructor(
    private readonly choices: LightingChoices,
    private readonly lights: readonly Light[],
    private readonly print: (surface: LitSurface) => Value,
  ) {
    super();
  }

  /** Whether shadows are all that is drawn. */
  private get dissolves(): boolean {
    return this.choices.toneModel === 'shadow';
  }

  override start(builder: NodeBuilder): void {
    this.radiance = float(0).toVar();
    const isRound = smoothstep(PLANE[0], PLANE[1], length(fwidth(normalView)));
    // The tone of a shadow is that of the light it takes.
    this.plane = this.dissolves ? float(0) : float(1).sub(isRound).toVar();
    this.told = [];
    const isTold = (this.dissolves || this.choices.shadowStrokes !== 'tone') && hasShadows(builder, this.lights);
    this.sums = isTold ? { shadowed: float(0).toVar(), taken: float(0).toVar(), lost: float(0).toVar() } : null;
    const context = builder.context as LightingContext;
    // An application may have its own.
    context.getShadow ??= (lit) => {
      const shadow = tellShadow(builder, lit, this.dissolves);
      if (!isTold) return lit.baseColorNode.mul(shadow.shadow);
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
    told: Omit<ToldLight, 'isShadowed'>,
    { shadowed, taken, lost }: ShadowSums,
    { arriving, luminance, facing }: Record<'arriving' | 'luminance' | 'facing', Value>,
  ): void {
    const { light, shadow, toneLeft } = told;
    shadowed.addAssign(arriving.mul(float(1).sub(shadow)));
    if (toneLeft) {
      const takes = luminance.mul(facing).mul(float(1).sub(shadow)).toVar();
      taken.addAssign(takes);
      lost.addAssign(takes.mul(float(1).sub(toneLeft)));
    }
    let isShadowed: Value | null = null;
    if (this.choices.shadowStrokes === 'reorient') {
      const isTaken = facing.mul(float(1).sub(shadow.mul(2))).greaterThan(LEAST_RESPONSE);
      // A lamp that does not reach here has no shadow either.
      isShadowed = (hasPlace(light) ? isTaken.and(luminance.greaterThan(0)) : isTaken).toVar();
    }
    this.told.push({ ...told, isShadowed });
  }

  override indirect(builder: NodeBuilder): void {
    // Lights with a direction have been walked by now.
    const open = openToLights().toVar();
    this.radiance.mulAssign(open);
    this.sums?.shadowed.mulAssign(open);
    const { ambientOcclusion, irradiance, iblIrradiance } = builder.context as LightingContext;
    const surroundings = lightLuminance(irradiance.add(iblIrradiance)).div(Math.PI).mul(ambientOcclusion);
    this.radiance.addAssign(surroundings.mul(openToSky()));
  }

  override finish(builder: NodeBuilder): void {
    for (const light of directedLights(this.lights)) this.addReflection(light);
    const { radiance, sums, told } = this;
    const surface: LitSurface = {
      radiance,
      shadowed: sums?.shadowed ?? null,
      shadowLeft: sums && this.dissolves ? shadowLeft(sums.taken, sums.lost).toVar() : null,
      told,
    };
    (builder.context as LightingContext).outgoingLight.assign(this.print(surface));
  }

  /** What the surroundings reflect of one light. Of a lamp its cone and its shadow do not count. */
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
