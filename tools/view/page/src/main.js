// Entry point of the page: it replays the recording that it contains, or shows the live run of `tip serve`, whose session is
// behind a WebSocket of the same server.

import { element } from './dom.js';
import { openLive, prepareLive } from './live.js';
import { openReplay } from './replay.js';
import { socketSession } from './socket.js';

const held = element('recording');
if (held) openReplay(held);
else openLive(socketSession(`${location.protocol.replace('http', 'ws')}//${location.host}/live${location.search}`), prepareLive());
