/**
 * Sets the state of the page, which style sheets and tests can read: `lost` is without a graphics context, `failed` without
 * anything to draw.
 */
export function setPageState(state: 'loading' | 'ready' | 'lost' | 'failed'): void {
  const { dataset } = document.documentElement;
  if (dataset.state !== state) dataset.state = state;
}
