/** What makes tone of the light of a scene: the radiance of a surface is multiplied by `scale`, and `offset` is added. */
export interface ToneFit {
  scale: number;
  offset: number;
}
