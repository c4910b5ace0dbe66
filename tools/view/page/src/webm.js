// Writer of encoded frames as WebM (RFC 8794, RFC 9559): one track that is seekable at its key frames.

const IDS = {
  ebml: 0x1a45dfa3, version: 0x4286, readVersion: 0x42f7, longestId: 0x42f2, longestSize: 0x42f3, docType: 0x4282, docVersion: 0x4287, docReadVersion: 0x4285,
  segment: 0x18538067, info: 0x1549a966, scale: 0x2ad7b1, duration: 0x4489, muxer: 0x4d80, writer: 0x5741,
  tracks: 0x1654ae6b, track: 0xae, number: 0xd7, uid: 0x73c5, type: 0x83, lacing: 0x9c, codec: 0x86, each: 0x23e383, video: 0xe0, width: 0xb0, height: 0xba,
  cluster: 0x1f43b675, time: 0xe7, block: 0xa3, cues: 0x1c53bb6b, cue: 0xbb, cueTime: 0xb3, cuePlaces: 0xb7, cueTrack: 0xf7, cuePlace: 0xf1,
};
/** Length of a tick of the clock, ns. */
const TICK = 1_000_000;

/** Encodes a number in as few bytes as possible, the highest first. */
function whole(value) {
  const bytes = [];
  for (let rest = value; rest >= 1 || !bytes.length; rest = Math.floor(rest / 256)) bytes.unshift(rest % 256);
  return bytes;
}

/** Encodes the length of an element in 8 bytes. */
function size(length) {
  const bytes = whole(length);
  return [1, ...Array(7 - bytes.length).fill(0), ...bytes];
}

function float(value) {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, value);
  return [...new Uint8Array(view.buffer)];
}

const text = (value) => [...new TextEncoder().encode(value)];
const lengthOf = (parts) => parts.reduce((sum, part) => sum + part.length, 0);

/** Creates an element of bytes, given in parts. */
const leaf = (name, ...parts) => [[...whole(IDS[name]), ...size(lengthOf(parts))], ...parts];
/** Creates an element of other elements. */
const node = (name, ...inner) => leaf(name, ...inner.flat());

/** Creates a cluster of frames, of which the first is a key frame. */
function cluster(frames) {
  const blocks = frames.map(({ bytes, time, isKey }) => {
    const after = time - frames[0].time;
    return leaf('block', [0x81, after >> 8, after & 255, isKey ? 0x80 : 0], bytes);
  });
  return node('cluster', leaf('time', whole(frames[0].time)), ...blocks);
}

/** Creates a video of `frames` ({ bytes, time, isKey }, time in ms from 0), each shown for `each` ms. */
export function webm(frames, { codec, width, height, each }) {
  const head = node(
    'ebml', leaf('version', [1]), leaf('readVersion', [1]), leaf('longestId', [4]), leaf('longestSize', [8]),
    leaf('docType', text('webm')), leaf('docVersion', [4]), leaf('docReadVersion', [2]),
  );
  const duration = float((frames.at(-1)?.time ?? 0) + each);
  const info = node('info', leaf('scale', whole(TICK)), leaf('duration', duration), leaf('muxer', text('tip-view')), leaf('writer', text('tip-view')));
  const track = node(
    'track', leaf('number', [1]), leaf('uid', [1]), leaf('type', [1]), leaf('lacing', [0]), leaf('codec', text(codec)),
    leaf('each', whole(Math.round(each * TICK))), node('video', leaf('width', whole(width)), leaf('height', whole(height))),
  );
  const before = [...info, ...node('tracks', track)];
  let place = lengthOf(before);
  const [clusters, cues] = [[], []];
  for (let from = 0; from < frames.length; ) {
    const next = frames.findIndex(({ isKey }, n) => n > from && isKey);
    const until = next < 0 ? frames.length : next;
    const made = cluster(frames.slice(from, until));
    cues.push(node('cue', leaf('cueTime', whole(frames[from].time)), node('cuePlaces', leaf('cueTrack', [1]), leaf('cuePlace', whole(place)))));
    clusters.push(...made);
    place += lengthOf(made);
    from = until;
  }
  const parts = [...head, ...node('segment', before, clusters, node('cues', ...cues))];
  return new Blob(parts.map((part) => Uint8Array.from(part)), { type: 'video/webm' });
}
