// Sends `tip serve` requests that nobody would send, over real sockets: node fuzz.mjs [SECONDS [SEED]].
// The server must not panic, must go on answering a good client, and must not grow.
import { readFileSync, readdirSync } from 'node:fs';
import { createConnection } from 'node:net';
import { serve } from './served.mjs';

const SECONDS = Number(process.argv[2] ?? 600);
let seed = Number(process.argv[3] ?? 1);
/** Number of clients at the same time. */
const CLIENTS = 8;
/** Longest time until a good client is answered, ms. */
const PATIENCE = 5000;
/** Largest growth of memory from the first half of the time to the second. */
const GROWTH = 1.2;

/** Returns a number below a limit. Each run of a seed has the same numbers (Steele, Lea, Flood: SplitMix32). */
function below(limit) {
  seed = (seed + 0x9e3779b9) | 0;
  let mixed = Math.imul(seed ^ (seed >>> 16), 0x21f0aaad);
  mixed = Math.imul(mixed ^ (mixed >>> 15), 0x735a2d97);
  return ((mixed ^ (mixed >>> 15)) >>> 0) % limit;
}
const one = (list) => list[below(list.length)];
const wait = (time) => new Promise((resolve) => setTimeout(resolve, time));

const WORDS = readFileSync('../../fuzz/dictionaries/requests.dict', 'utf8').split('\n').filter((line) => line.startsWith('"'))
  .map((line) => line.slice(1, -1).replace(/\\x0A/g, '').replace(/\\(["\\])/g, '$1'));
const REQUESTS = WORDS.filter((word) => word.startsWith('{'));
const NUMBERS = ['0', '-1', '1e999', '1e-999', '4294967296', '9007199254740993', '-9223372036854775808', '0.5', 'null', '"1"', '[]'];

/** Returns a request with a part of it changed. */
function message(version) {
  let text = one(REQUESTS).replace('"base":1', `"base":${version}`);
  for (let times = below(4); times > 0; times--) {
    const at = below(text.length + 1);
    text = one([
      () => text.slice(0, at) + one(WORDS) + text.slice(at),
      () => text.slice(0, at) + text.slice(at + below(9)),
      () => text.slice(0, at) + String.fromCharCode(below(0x3100)) + text.slice(at + 1),
      () => text.replace(/-?\d+(\.\d+)?/, one(NUMBERS)),
      () => text.replace(/"text":"/, `"text":"${'N = N + 1\\n'.repeat(below(400))}`),
      () => text.slice(0, at) + one(['[', '{"a":', '\\u0000', ' ']).repeat(below(3000)) + text.slice(at),
    ])();
  }
  return text;
}

/** Returns the frame of a WebSocket (RFC 6455), masked as a client's has to be. */
function frame(opcode, payload, end = true) {
  const body = Buffer.from(payload);
  const size = body.length < 126 ? [body.length] : body.length < 65536 ? [126, body.length >> 8, body.length & 255] : [127, 0, 0, 0, 0, ...[24, 16, 8, 0].map((shift) => (body.length >> shift) & 255)];
  const mask = [0, 0, 0, 0].map(() => below(256));
  const masked = body.map((byte, n) => byte ^ mask[n % 4]);
  return Buffer.concat([Buffer.from([(end ? 0x80 : 0) | opcode, 0x80 | size[0], ...size.slice(1), ...mask]), masked]);
}

/** Returns bytes, some of which are changed. */
function spoiled(bytes) {
  for (let times = 1 + below(6); times > 0; times--) bytes[below(Math.min(bytes.length, 400))] = below(256);
  return bytes;
}

const server = await serve('counts.prg');
const { host, port, search } = new URL(server.address);
const head = (target) => `GET ${target} HTTP/1.1\r\nHost: ${host}\r\nOrigin: http://${host}\r\nConnection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n`;
const counts = { heads: 0, messages: 0, frames: 0, connections: 0, answers: 0 };

/** Opens a connection. `hear` gets the text of every message of a viewer. */
function connect(hear) {
  counts.connections += 1;
  const socket = createConnection({ host: '127.0.0.1', port });
  const open = { socket, over: false };
  let bytes = Buffer.alloc(0);
  let isOpen = false;
  socket.on('error', () => {});
  socket.on('close', () => (open.over = true));
  socket.on('data', (data) => {
    if (!hear) return;
    bytes = Buffer.concat([bytes, data]);
    if (!isOpen) {
      const end = bytes.indexOf('\r\n\r\n');
      if (end < 0) return;
      isOpen = true;
      bytes = bytes.subarray(end + 4);
    }
    for (;;) {
      const [long, short] = [bytes[1] === 127, bytes[1] === 126];
      const begin = long ? 10 : short ? 4 : 2;
      if (bytes.length < begin) return;
      const size = long ? Number(bytes.readBigUInt64BE(2)) : short ? bytes.readUInt16BE(2) : bytes[1];
      if (bytes.length < begin + size) return;
      if ((bytes[0] & 15) === 1) hear(bytes.subarray(begin, begin + size).toString());
      bytes = bytes.subarray(begin + size);
    }
  });
  return open;
}

const KINDS = {
  async head() {
    const client = connect();
    const whole = Buffer.from(head(one(['/', '/live', '/x']) + one([search, '', `${search}0`])));
    client.socket.write(spoiled(whole).subarray(0, below(4) ? whole.length : below(whole.length)));
    counts.heads += 1;
    await wait(20 + below(100));
    client.socket.destroy();
  },
  async messages() {
    let version = 1;
    const client = connect((text) => {
      if (text.startsWith('{"type":"answer"')) counts.answers += 1;
      if (text.startsWith('{"type":"text"')) version = JSON.parse(text).version;
    });
    client.socket.write(head(`/live${search}`));
    for (let times = below(60); times > 0 && !client.over; times--) {
      const text = message(version);
      const cut = below(text.length + 1);
      client.socket.write(below(5) ? frame(1, text) : Buffer.concat([frame(1, text.slice(0, cut), false), frame(9, 'ping'), frame(0, text.slice(cut))]));
      counts.messages += 1;
      await wait(below(40));
    }
    if (below(2)) client.socket.write(frame(8, Buffer.from([3, 232])));
    await wait(below(100));
    client.socket.destroy();
  },
  async frames() {
    const client = connect();
    client.socket.write(head(`/live${search}`));
    for (let times = below(8); times > 0 && !client.over; times--) {
      client.socket.write(spoiled(frame(below(16), message(1), Boolean(below(2)))));
      counts.frames += 1;
      await wait(below(40));
    }
    client.socket.destroy();
  },
  async deaf() {
    const client = connect();
    client.socket.write(head(`/live${search}`));
    client.socket.pause();
    for (let times = 100; times > 0 && !client.over; times--) {
      client.socket.write(frame(1, '{"do":"hover","at":[3,1],"id":1}'));
      await wait(60);
    }
    client.socket.destroy();
  },
};

/** Returns the memory of the server's process, MB, and the number of its threads. */
function size() {
  const status = readFileSync(`/proc/${server.pid}/status`, 'utf8');
  const of = (name) => Number(new RegExp(`^${name}:\\s+(\\d+)`, 'm').exec(status)[1]);
  return { memory: of('VmRSS') / 1000, threads: of('Threads'), files: readdirSync(`/proc/${server.pid}/fd`).length };
}

// The server prints its address before all of its threads are there. Afterwards, the threads of clients take a moment to end.
const REST = 2000;
await wait(REST);
const [begin, quiet] = [performance.now(), size()];
const passed = () => (performance.now() - begin) / 1000;
let slowest = 0;
async function good() {
  while (passed() < SECONDS) {
    const asked = performance.now();
    let answered;
    const client = connect((text) => {
      if (text.includes('"type":"answer"') && text.includes('"id":77')) answered ??= performance.now();
    });
    client.socket.write(head(`/live${search}`));
    client.socket.write(frame(1, '{"do":"hover","at":[3,1],"id":77}'));
    while (!answered && performance.now() - asked < PATIENCE) await wait(10);
    slowest = Math.max(slowest, (answered ?? Infinity) - asked);
    client.socket.destroy();
    await wait(1000);
  }
}
async function bad() {
  while (passed() < SECONDS) await KINDS[one(['head', 'messages', 'messages', 'messages', 'frames', 'frames', 'deaf'])]();
}
const halves = [0, 0];
async function watch() {
  while (passed() < SECONDS) {
    await wait(Math.min(5000, SECONDS * 20));
    const half = passed() < SECONDS / 2 ? 0 : 1;
    halves[half] = Math.max(halves[half], size().memory);
  }
}
await Promise.all([good(), watch(), ...Array.from({ length: CLIENTS }, bad)]);
await wait(REST);
const rest = size();
const status = await server.end();
console.log(`${SECONDS} s: ${Object.entries(counts).map(([name, count]) => `${count} ${name}`).join(', ')}; a good client waited ${slowest.toFixed(0)} ms at most`);
console.log(`memory: ${quiet.memory.toFixed(0)} MB at first, at most ${halves[0].toFixed(0)} in the first half and ${halves[1].toFixed(0)} in the second; ${rest.threads} of ${quiet.threads} threads, ${rest.files} of ${quiet.files} files after all have gone`);
const faults = [
  [status !== 130, `it ended with ${status}`],
  [/panicked/.test(server.said()), 'it panicked'],
  [slowest > PATIENCE, 'a good client was not answered'],
  [halves[1] > halves[0] * GROWTH, 'it grew'],
  [rest.threads > quiet.threads || rest.files > quiet.files, 'something is left of clients that have gone'],
].filter(([is]) => is);
faults.forEach(([, what]) => console.log(what));
process.exit(faults.length ? 1 : 0);
