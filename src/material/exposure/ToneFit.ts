/** What makes tone of the light and the colours of a scene. */
export interface ToneFit {
  /** What the radiance of a white surface is multiplied by. */
  scale: number;
  /** What is added to that. */
  offset: number;
  /** How light the colours look that are left blank, from 0, black, to 1, white (CIE lightness); lighter ones are so too. */
  white: number;
}
