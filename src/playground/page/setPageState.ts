/**
 * Sets the state of the page for style sheets and tests: `lost` means that the graphics context is lost, `failed` that there is nothing to
 * draw.
 */
export function setPageState(state: 'loading' | 'ready' | 'lost' | 'failed'): void {
  const { dataset } = document.documentElement;
  if (dataset.state !== state) dataset.state = state;
}
