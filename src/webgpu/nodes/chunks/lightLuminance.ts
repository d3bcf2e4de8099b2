/** Counterpart of shaders/chunks/lightLuminance.glsl. */
import { tsl, type Value } from '../base/values.js';

const { dot, vec3 } = tsl;

/** Luminance by the weights of Rec. 709. */
export const lightLuminance = (rgb: Value): Value => dot(rgb, vec3(0.2126, 0.7152, 0.0722));
