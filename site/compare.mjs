// Compares the trace of each example and lesson in WebAssembly with that of the command, by their hashes.
// node compare.mjs FILE.wasm TIP
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { playground } from './wasm.mjs';

const [wasm, tip] = process.argv.slice(2);
const root = `${import.meta.dirname}/..`;
const read = (path) => readFileSync(`${root}/${path}`, 'utf8');
const { robots, examples, lessons } = JSON.parse(read('site/contents.json'));
const { trace } = await playground(await WebAssembly.compile(readFileSync(wasm)));
const hash = (text) => createHash('sha256').update(text).digest('hex').slice(0, 16);
const filled = (text) => text && { name: text.name, ...(text.name.includes('/') ? { text: read(text.name) } : {}) };

let different = 0;
for (const { program, robot: name, events = '' } of [...examples, ...lessons]) {
  const { robot, scene } = robots[name];
  const here = trace({ program: { name: program, text: read(program) }, robot: filled(robot), scene: filled(scene), events });
  const options = ['--robot', robot.name, ...(scene ? ['--scene', scene.name] : []), ...(events ? ['--events', events] : [])];
  const native = execFileSync(tip, ['run', program, '--quiet', '--trace', '-', '--trace-state', ...options], { cwd: root, maxBuffer: 1e9, encoding: 'utf8' });
  const equal = hash(here) === hash(native);
  different += equal ? 0 : 1;
  console.log(`${program}: ${here.split('\n').length - 1} records, ${hash(here)}${equal ? '' : ` DIFFERS from ${hash(native)}`}`);
}
console.log(different ? `${different} traces DIFFER` : 'all traces equal');
process.exit(different ? 1 : 0);
