import type { Mutation } from '../Mutation.js';

export const page: readonly Mutation[] = [
  {
    name: 'a double-click resets nothing',
    file: 'src/playground/panel/SettingsPanel.ts',
    find: "controller.domElement.addEventListener('dblclick'",
    replace: "controller.domElement.addEventListener('auxclick'",
    caughtBy: {
      layer: 'e2e',
      file: 'tests/e2e/page.spec.ts',
      title: 'settings have labels and units, apply at once and are reset by double-click',
    },
  },
  {
    name: 'a clip does not begin by itself',
    file: 'src/playground/panel/MotionPanel.ts',
    find: "motion.isPlaying = !matchMedia('(prefers-reduced-motion: reduce)').matches",
    replace: 'motion.isPlaying = false',
    caughtBy: {
      layer: 'e2e',
      file: 'tests/e2e/motion.spec.ts',
      title: 'a model with a clip plays when it is dropped; paused, the page is idle',
    },
  },
];
