/** Whether warnings are turned off; `HatchingMaterial.silent` sets it. */
export const silence = { isOn: false };
