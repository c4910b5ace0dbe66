// What the extension finds out about the bytes of programs, with the codec that VS Code has.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { encodingOf, place, respelt, unspellable } from '../../../editors/vscode/src/bytes.js';

const iconv = createRequire(import.meta.url)('@vscode/iconv-lite-umd');
const codec = {
  decode: async (bytes) => iconv.decode(Buffer.from(bytes), 'shiftjis'),
  encode: async (text) => Uint8Array.from(iconv.encode(text, 'shiftjis')),
};
const bytes = (...parts) => Uint8Array.from(parts.flatMap((part) => (typeof part === 'string' ? [...Buffer.from(part)] : part)));

test('the encoding is that of tip.toml, else that of the bytes', () => {
  const [ascii, utf8, japanese] = [bytes('3.1\n'), bytes('3.1\n歩く\n'), bytes('3.1\n', 0x95, 0xe0, '\n')];
  assert.equal(encodingOf(ascii), undefined);
  assert.equal(encodingOf(ascii, 'auto'), undefined);
  assert.equal(encodingOf(ascii, 'shift_jis'), 'shiftjis');
  assert.equal(encodingOf(utf8), 'utf8');
  assert.equal(encodingOf(utf8, 'shift_jis'), 'shiftjis');
  assert.equal(encodingOf(japanese), 'shiftjis');
  assert.equal(encodingOf(japanese, 'auto'), 'shiftjis');
  assert.equal(encodingOf(japanese, 'utf-8'), 'utf8');
});

test('bytes that come back as others are found where they are', async () => {
  // 歩, half-width ｱ, and ∵ of row 2: JIS X 0208 has them once.
  assert.deepEqual(await respelt(bytes('MESSAGE ', 0x95, 0xe0, 0xb1, 0x81, 0xe6, '\r\n'), codec), []);
  // ∵ of NEC's row 13 and 纊 of NEC's selection: ∵ is in row 2 too, 纊 among IBM's extensions.
  const found = await respelt(bytes('A', 0x95, 0xe0, 0x87, 0x9a, '\n', 0xed, 0x40), codec);
  assert.deepEqual(found, [
    { start: 2, end: 3, from: '87 9A', to: '81 E6' },
    { start: 4, end: 5, from: 'ED 40', to: 'FA 5C' },
  ]);
});

test('bytes are taken in pairs where Shift_JIS has pairs', async () => {
  // The first and last leads of both its stretches, half-width kana, and then ∵ of row 13.
  const code = bytes(0x81, 0x40, 0x9f, 0xfc, 0xe0, 0x40, 0xfc, 0x4b, 0xa1, 0xdf, 0x87, 0x9a);
  assert.deepEqual(await respelt(code, codec), [{ start: 6, end: 7, from: '87 9A', to: '81 E6' }]);
});

test('a place in a text is a line and a column, however lines end', () => {
  const text = 'a\r\nbc\rd\n歩e';
  const at = (offset) => Object.values(place(text, offset));
  assert.deepEqual([0, 3, 4, 6, 8, 9].map(at), [[0, 0], [1, 0], [1, 1], [2, 0], [3, 0], [3, 1]]);
});

test('an odd end is found and harms nothing', async () => {
  assert.equal((await respelt(bytes('A', 0x95), codec)).length, 1);
  assert.equal((await respelt(bytes(0x95, '\n', 'B'), codec)).length, 1);
});

test('every code of two bytes that is respelt is found', async () => {
  const trails = [...Array(0xfd).keys()].filter((trail) => trail >= 0x40 && trail !== 0x7f);
  const leads = [...Array(0xfd).keys()].filter((lead) => (lead >= 0x81 && lead <= 0x9f) || lead >= 0xe0);
  let survivors = 0;
  for (const lead of leads) {
    for (const trail of trails) {
      const code = bytes([lead, trail]);
      const back = await codec.encode(await codec.decode(code));
      const survives = Buffer.from(back).equals(Buffer.from(code));
      assert.equal((await respelt(code, codec)).length, survives ? 0 : 1, Buffer.from(code).toString('hex'));
      survivors += survives ? 1 : 0;
    }
  }
  // As many as the Encoding Standard gives back.
  assert.equal(survivors, 7326);
});

test('characters that Shift_JIS lacks are found where they are', async () => {
  assert.deepEqual(await unspellable('MESSAGE 歩く ｱ\n', codec), []);
  const found = await unspellable('歩😀é歩', codec);
  assert.deepEqual(found, [
    { start: 1, end: 3, from: '😀', to: found[0]?.to },
    { start: 3, end: 4, from: 'é', to: '?' },
  ]);
  assert.match(found[0].to, /^\?+$/);
});
