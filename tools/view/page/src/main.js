// The page of a run: one that is over, which the page holds, or that of `tip serve`, whose session is at the other end of a
// WebSocket of the same server.

import { element } from './dom.js';
import { openLive, prepareLive } from './live.js';
import { openReplay } from './replay.js';
import { socketSession } from './socket.js';

const held = element('recording');
if (held) openReplay(held);
else openLive(socketSession(`${location.protocol.replace('http', 'ws')}//${location.host}/live${location.search}`), prepareLive());
