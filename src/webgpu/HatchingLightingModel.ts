import type { Light } from 'three';
import { LightingModel, type NodeBuilder } from 'three/webgpu';
import { directedLights } from './nodes/base/directedLights.js';
import { hatchingUniform } from './nodes/base/uniforms.js';
import { tsl, type Value } from './nodes/base/values.js';
import { lightLuminance } from './nodes/chunks/lightLuminance.js';
import { fallOff, valuesFor } from './nodes/chunks/meanLight.js';
import { openToLights, openToSky } from './nodes/chunks/occlude.js';

const { dot, float, length, max, normalView, positionView, positionViewDirection, pow, step } = tsl;

const shininess = /* @__PURE__ */ hatchingUniform('shininess', 'float');
const reflectedLight = /* @__PURE__ */ hatchingUniform('reflectedLight', 'float');

interface LightingContext {
  /** What a map takes of the light of the surroundings. */
  ambientOcclusion: Value;
  irradiance: Value;
  outgoingLight: Value;
}

/** The twin of shaders/chunks/radiance.glsl: the radiance that a white surface shows under the scene's lights. three's own nodes walk the lights. */
export class HatchingLightingModel extends LightingModel {
  private radiance!: Value;

  /** @param print makes the colour of a radiance */
  constructor(
    private readonly toneModel: string,
    private readonly lights: readonly Light[],
    private readonly print: (radiance: Value) => Value,
  ) {
    super();
  }

  override start(builder: NodeBuilder): void {
    this.radiance = float(0).toVar();
    super.start(builder);
  }

  override direct(light: unknown): void {
    const { lightDirection, lightColor } = light as { lightDirection: Value; lightColor: Value };
    const cosine = dot(lightDirection, normalView).toVar();
    const halfway = cosine.mul(0.5).add(0.5);
    const response = (this.toneModel === 'halfLambert' ? halfway.mul(halfway) : max(cosine, 0)).toVar();
    if (this.toneModel === 'phong') {
      const toViewer = positionViewDirection;
      const mirrored = cosine.mul(2).mul(dot(toViewer, normalView)).sub(dot(lightDirection, toViewer));
      response.addAssign(step(0, cosine).mul(pow(max(mirrored, 1e-6), shininess)));
    }
    this.radiance.addAssign(lightLuminance(lightColor).mul(response).div(Math.PI));
  }

  override indirect(builder: NodeBuilder): void {
    // Lights with a direction have been walked by now.
    this.radiance.mulAssign(openToLights());
    const { ambientOcclusion, irradiance } = builder.context as LightingContext;
    const surroundings = lightLuminance(irradiance).div(Math.PI).mul(ambientOcclusion);
    this.radiance.addAssign(surroundings.mul(openToSky()));
  }

  override finish(builder: NodeBuilder): void {
    for (const light of directedLights(this.lights)) this.addReflection(light);
    (builder.context as LightingContext).outgoingLight.assign(this.print(this.radiance));
  }

  /** What the surroundings reflect of one light. Of a lamp its cone and its shadow do not count. */
  private addReflection(light: Light): void {
    const values = valuesFor(light);
    const isDistant = 'isDirectionalLight' in light;
    const way = isDistant ? values.direction : values.position.sub(positionView).toVar();
    const away = length(way).toVar();
    const seen = float(0.5).sub(dot(way.div(away), normalView).mul(0.5));
    const arriving = isDistant ? lightLuminance(values.color) : lightLuminance(values.color).mul(fallOff(away, values));
    this.radiance.addAssign(openToSky().mul(reflectedLight).mul(arriving).div(Math.PI).mul(seen));
  }
}
