/** The types of three.js leave it out. */
declare module 'three/addons/loaders/usd/USDComposer.js' {
  export class USDComposer {}
}
