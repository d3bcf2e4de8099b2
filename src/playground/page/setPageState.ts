/**
 * Sets the state of the page, which style sheets and tests read: `lost` means that the graphics context is lost, `failed` that there is
 * nothing to draw.
 */
export function setPageState(state: 'loading' | 'ready' | 'lost' | 'failed'): void {
  const { dataset } = document.documentElement;
  if (dataset.state !== state) dataset.state = state;
}
