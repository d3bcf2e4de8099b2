/**
 * The form of the page by its query: `?embed` in a frame of another page, `?kiosk` on a public screen. Both show only the drawing and its
 * light handles.
 */
export type PageForm = 'playground' | 'embed' | 'kiosk';

export const pageForm: PageForm = formOf(location.search);

function formOf(query: string): PageForm {
  const parameters = new URLSearchParams(query);
  if (parameters.has('kiosk')) return 'kiosk';
  return parameters.has('embed') ? 'embed' : 'playground';
}

// Read by the style sheet.
document.documentElement.dataset.form = pageForm;
document.documentElement.classList.toggle('is-bare', pageForm !== 'playground');
