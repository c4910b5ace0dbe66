// Reads MCAP files with npm's @mcap/core, on which Foxglove is built, and counts their messages.
const fs = require("node:fs");
const { McapIndexedReader } = require("@mcap/core");

async function read(path) {
  const bytes = fs.readFileSync(path);
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, length) => bytes.subarray(Number(offset), Number(offset + length)),
  };
  const reader = await McapIndexedReader.Initialize({ readable });
  let count = 0n;
  let before = 0n;
  for await (const message of reader.readMessages()) {
    if (message.logTime < before) throw new Error(`${path}: out of order`);
    before = message.logTime;
    count += 1n;
  }
  if (count !== reader.statistics.messageCount) throw new Error(`${path}: ${count} messages`);
  console.log(`${path.split("/").pop()}: ${count} messages by @mcap/core`);
}

(async () => {
  for (const path of process.argv.slice(2)) await read(path);
})().catch((error) => {
  console.error(error);
  process.exit(1);
});
