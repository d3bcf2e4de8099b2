/** An image in memory. */
export interface Pixels {
  width: number;
  height: number;
  /** 1 for grey, 3 for RGB. */
  channels: 1 | 3;
  /** width·height·channels bytes, top row first. */
  data: Uint8Array;
}
