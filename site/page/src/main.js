// The playground: the page of `tip serve` with its session in a module of this page, and a guided tour.

import { openLive, prepareLive } from '../../../tools/view/page/src/live.js';
import { teach } from '../../../tools/view/page/src/words.js';
import { playground } from '../../wasm.mjs';
import { localSession } from './local.js';
import { Tour } from './tour.js';
import { TOUR_WORDS } from './words.js';

async function begin() {
  teach(TOUR_WORDS);
  // The graphics get ready while the module still comes.
  const stage = prepareLive();
  const session = localSession(await playground(await globalThis.module));
  openLive(session, stage);
  await new Tour(session).openAddress();
}

begin();
