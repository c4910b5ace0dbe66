// Runs a module that writes traces, and passes them on: node run.mjs FILE.wasm
import { readFileSync, writeFileSync } from "node:fs";

const [file] = process.argv.slice(2);
const decoder = new TextDecoder();
let traces = "";
const host = {
  write: (text, length) => {
    traces += decoder.decode(new Uint8Array(instance.exports.memory.buffer, text, length));
  },
};
const { instance } = await WebAssembly.instantiate(readFileSync(file), { host });
process.exitCode = instance.exports.run() === 1 ? 0 : 1;
writeFileSync(process.stdout.fd, traces);
