/**
 * What the page is used as, which its query says: `?embed` in a frame of another page, `?kiosk` on a screen of an exhibition. Both show
 * nothing but the drawing and its lamp.
 */
export type PageForm = 'playground' | 'embed' | 'kiosk';

export const pageForm: PageForm = formOf(location.search);

function formOf(query: string): PageForm {
  const parameters = new URLSearchParams(query);
  if (parameters.has('kiosk')) return 'kiosk';
  return parameters.has('embed') ? 'embed' : 'playground';
}

// The style sheet reads these.
document.documentElement.dataset.form = pageForm;
document.documentElement.classList.toggle('is-bare', pageForm !== 'playground');
