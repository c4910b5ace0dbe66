// The page of `tipc serve`: its session is at the other end of a WebSocket of the same server.

import { openLive } from './live.js';
import { socketSession } from './socket.js';

openLive(socketSession(`${location.protocol.replace('http', 'ws')}//${location.host}/live${location.search}`));
