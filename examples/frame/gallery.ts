/** The page of all examples. */
import { EXAMPLES } from '../examples.js';

document.querySelector('.gallery')!.append(
  ...EXAMPLES.map(({ folder, title, about }) => {
    const entry = document.createElement('li');
    const link = Object.assign(document.createElement('a'), { href: `./${folder}/` });
    const picture = Object.assign(document.createElement('img'), {
      src: `./${folder}/picture.webp`,
      alt: '',
      width: 480,
      height: 360,
      loading: 'lazy',
    });
    const heading = Object.assign(document.createElement('h2'), { textContent: title });
    const sentence = Object.assign(document.createElement('p'), { textContent: about });
    link.append(picture, heading, sentence);
    entry.append(link);
    return entry;
  }),
);
