// Without the fonts of the default theme, which weigh more than the pages.
import Theme from 'vitepress/theme-without-fonts';
import './site.css';

export default Theme;
