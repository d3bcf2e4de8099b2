import { MeshLambertMaterial, MeshPhongMaterial, MeshStandardMaterial, PerspectiveCamera, WebGLRenderer } from 'three';
import { applyHatching } from 'three-hatching';
import { drawer } from '../drawer.js';
import { type GameCounts, GameScene } from './GameScene.js';
import { type LookName, lookOptions } from './lookOptions.js';

/** Milliseconds, one entry per turn, by drawing: the script of a frame alone, and the frame until a pixel can be read. */
export interface GameTimes {
  script: Record<string, number[]>;
  frame: Record<string, number[]>;
}

/** Small, so that the script counts and not the pixels. */
const SCRIPT_SIZE = 64;
const WARM_UP_TURNS = 4;
const COLOURS = [0xffffff, 0xd8c8a8, 0x8899aa, 0xcc8866, 0x99aa77, 0x666677, 0xeeddcc, 0x88aa66];

/** Draws a game's scene in Lambert's and Phong's shading and in a look, with and without outlines, in turn, while skins and light move. */
export async function measureGame(counts: GameCounts, look: LookName, turns: number, size: number): Promise<GameTimes> {
  const colour = (kind: number) => ({ color: COLOURS[kind] });
  const drawings: Record<string, GameScene> = {
    lambert: new GameScene(counts, (kind) => new MeshLambertMaterial(colour(kind))),
    phong: new GameScene(counts, (kind) => new MeshPhongMaterial(colour(kind))),
  };
  for (const outlines of [false, true]) {
    const game = new GameScene(counts, (kind) => new MeshStandardMaterial(colour(kind)));
    const hatched = await applyHatching(game.root, lookOptions(look), { outlines });
    await hatched.formReady;
    drawings[outlines ? 'outlines' : 'surface'] = game;
  }
  return {
    frame: (await timeGame(drawings, turns, size)).frame,
    script: (await timeGame(drawings, turns, SCRIPT_SIZE)).script,
  };
}

async function timeGame(
  drawings: Readonly<Record<string, GameScene>>,
  turns: number,
  size: number,
): Promise<GameTimes> {
  const renderer = new WebGLRenderer({ antialias: false });
  renderer.setSize(size, size, false);
  const { side } = drawings.lambert;
  const camera = new PerspectiveCamera(30, 1, 0.1, 10 * side);
  camera.position.set(0, 0.9 * side, 1.5 * side);
  camera.lookAt(0, 0, 0);
  const draw = drawer(renderer, camera);
  const names = Object.keys(drawings);
  const times: GameTimes = { script: {}, frame: {} };
  for (const name of names) {
    times.script[name] = [];
    times.frame[name] = [];
  }
  for (let turn = -WARM_UP_TURNS; turn < turns; turn++) {
    for (const name of turn % 2 === 0 ? names : names.toReversed()) {
      const game = drawings[name];
      game.move(turn);
      const { script, frame } = draw(game.scene);
      if (turn < 0) continue;
      times.script[name].push(script);
      times.frame[name].push(frame);
    }
    // Lists of contours arrive between frames.
    await new Promise((resolve) => setTimeout(resolve, 0));
  }
  renderer.dispose();
  renderer.forceContextLoss();
  return times;
}
