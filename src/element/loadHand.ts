import { FileLoader } from 'three';
import { type Hand, HatchingMaterial } from 'three-hatching';
import { sentenceOf } from './loadModel.js';

/**
 * Loads a hand, as `hand.json` holds it.
 *
 * @throws Error whose message is a sentence for the reader of the page; the signal's reason when aborted
 */
export async function loadHand(address: string, signal: AbortSignal): Promise<Hand> {
  try {
    const hand = JSON.parse((await new FileLoader().loadAsync(address)) as string) as Hand;
    const material = new HatchingMaterial({ technique: 'pen', hand });
    await material.ready;
    // With the code that draws hands every fault is found.
    material.hand = hand;
    material.dispose();
    signal.throwIfAborted();
    return hand;
  } catch (cause) {
    signal.throwIfAborted();
    const message = (cause as Error).message.replace(/^HatchingMaterial: /, '');
    throw new Error(sentenceOf('hand', address, new Error(message)), { cause });
  }
}
