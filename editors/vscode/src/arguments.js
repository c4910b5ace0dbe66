// What `tip` is asked to do with a program.

const robot = (setting) => (setting('robot') ? ['--robot', setting('robot')] : []);

/** Where the trace of a program goes. */
export const traceOf = (file) => `${file.replace(/\.prg$/i, '')}.jsonl`;

export const runArguments = (file, setting) => ['run', file, ...robot(setting), ...setting('runArguments')];

export const traceArguments = (file, setting) => [
  'run', file, ...robot(setting), ...setting('traceArguments'), '--trace', traceOf(file),
];
