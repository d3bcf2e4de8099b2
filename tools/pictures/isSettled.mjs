/** Runs in the page: whether it shows a drawing that stays as it is. */
export const isSettled = () =>
  document.documentElement.dataset.state === 'ready' && window.__playground?.isIdle === true;
