// The page of `tip serve`: its session is at the other end of a WebSocket of the same server.

import { openLive, prepareLive } from './live.js';
import { socketSession } from './socket.js';

const stage = prepareLive();
openLive(socketSession(`${location.protocol.replace('http', 'ws')}//${location.host}/live${location.search}`), stage);
