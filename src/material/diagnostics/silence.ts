/** Whether the library says nothing of mistakes; `HatchingMaterial.silent` sets it. */
export const silence = { isOn: false };
