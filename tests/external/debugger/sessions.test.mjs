// Whole sessions, as an editor has them.

import assert from 'node:assert/strict';
import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, test } from 'node:test';
import { createRequire } from 'node:module';
import { judge } from './judge.mjs';

const require = createRequire(import.meta.url);
const { DebugClient } = require('@vscode/debugadapter-testsupport');

const PROGRAM = `3.1
sessions
DEF_VAR N, K
DEF_POS P
N = 0
L:
GOSUB COUNT:
IF N < 50 GOTO L:
TEACH_POS F1 P
KEY_IN K
MESSAGE key %K%
SLEEP 100
EXIT
COUNT:
N += 1
RETURN
END
`;

const folder = mkdtempSync(join(tmpdir(), 'tip-sessions-'));
const program = join(folder, 'sessions.prg');
writeFileSync(program, PROGRAM);
const failing = join(folder, 'failing.prg');
writeFileSync(failing, '3.1\nfails\nDEF_VAR A, B\nA = 0\nB = 1 / A\nEND\n');

// Line 13 runs in cycle 5 for the first time, when the main program stands at line 9.
const threads = join(folder, 'threads.prg');
writeFileSync(threads, '3.2\ntwo\nDEF_VAR A, B\nA = 0\nB = 0\nSTART_THREAD SIDE:\nL:\nA += 1\nIF A < 99 GOTO L:\nEXIT\nTHREAD SIDE:\nAGAIN:\nB += 1\nSLEEP 40\nGOTO AGAIN:\nTHREADEND\nEND\n');

const endless = join(folder, 'endless.prg');
writeFileSync(endless, '3.1\nendless\nDEF_VAR N\nN = 0\nL:\nN += 1\nGOTO L:\nEND\n');

let client;
let sent;

beforeEach(async () => {
  sent = [];
  client = new DebugClient(process.env.TIP, 'dap', 'tip');
  // The client runs an adapter as a script of node; this one is a program.
  const { spawn } = require('node:child_process');
  const adapter = spawn(process.env.TIP, ['dap'], { stdio: ['pipe', 'pipe', 'inherit'] });
  const dispatch = client.dispatch.bind(client);
  client.dispatch = (body) => {
    sent.push(body);
    dispatch(body);
  };
  client.connect(adapter.stdout, adapter.stdin);
  client.adapter = adapter;
});

afterEach(async () => {
  client.adapter.kill();
  // Afterwards: the schema of each kind of message takes a while to make, and the client does not wait.
  assert.deepEqual(sent.flatMap((body) => judge(JSON.parse(body))), [], 'every message is as the protocol has it');
});

const stop = () => client.waitForEvent('stopped');

// Sends a request that moves, and gives where the program stands after it.
async function move(request) {
  const [event] = await Promise.all([stop(), request()]);
  const { body } = await client.stackTraceRequest({ threadId: 1 });
  return { reason: event.body.reason, line: body.stackFrames[0].line, frames: body.stackFrames.map((frame) => frame.name) };
}

async function launch(extra = {}, breakpoints = []) {
  const begun = client.waitForEvent('initialized').then(async () => {
    const placed = await client.setBreakpointsRequest({ source: { path: program }, breakpoints });
    assert.ok(placed.body.breakpoints.every((one) => one.verified));
    await client.configurationDoneRequest();
  });
  const stopped = stop();
  await Promise.all([client.launch({ program, stopOnEntry: true, ...extra }), begun]);
  return stopped;
}

const value = async (expression, context = 'watch') => (await client.evaluateRequest({ expression, context })).body.result;

test('a breakpoint is hit where the client says', () =>
  client.hitBreakpoint({ program }, { path: program, line: 15 }));

test('steps go over, into, out of, and back', async () => {
  assert.equal((await launch()).body.reason, 'entry');
  const thread = { threadId: 1 };
  const lines = [];
  for (const request of ['nextRequest', 'nextRequest', 'stepInRequest', 'stepInRequest', 'stepOutRequest', 'stepBackRequest']) {
    lines.push((await move(() => client[request](thread))).line);
  }
  assert.deepEqual(lines, [6, 7, 14, 15, 8, 7]);
  const start = await move(() => client.reverseContinueRequest(thread));
  assert.deepEqual([start.reason, start.line], ['entry', 5]);
});

test('threads stop together, and each steps for itself', async () => {
  const begun = client.waitForEvent('initialized').then(async () => {
    await client.setBreakpointsRequest({ source: { path: threads }, breakpoints: [{ line: 13 }] });
    await client.configurationDoneRequest();
  });
  const [stopped] = await Promise.all([stop(), client.launch({ program: threads }), begun]);
  assert.deepEqual([stopped.body.reason, stopped.body.threadId], ['breakpoint', 2]);
  const { body } = await client.threadsRequest();
  assert.deepEqual(body.threads, [{ id: 1, name: 'threads.prg' }, { id: 2, name: 'SIDE' }]);
  const line = async (threadId) => (await client.stackTraceRequest({ threadId })).body.stackFrames[0].line;
  assert.deepEqual([await line(1), await line(2)], [9, 13]);
  const moved = async (request, threadId) => {
    const [event] = await Promise.all([stop(), client[request]({ threadId })]);
    return [event.body.threadId, await line(threadId)];
  };
  assert.deepEqual(await moved('nextRequest', 2), [2, 14]);
  assert.deepEqual(await moved('nextRequest', 2), [2, 15]);
  assert.deepEqual(await moved('nextRequest', 1), [1, 7]);
  assert.deepEqual(await moved('stepBackRequest', 2), [2, 15]);
  assert.deepEqual(await moved('reverseContinueRequest', 2), [2, 13]);
});

test('conditions, counts of hits, and going back through them', async () => {
  await launch({}, [{ line: 15, condition: 'N >= 20', hitCondition: '% 10' }]);
  const thread = { threadId: 1 };
  const seen = [];
  for (const request of ['continueRequest', 'continueRequest', 'reverseContinueRequest']) {
    const { reason, frames } = await move(() => client[request](thread));
    assert.deepEqual([reason, frames], ['breakpoint', ['COUNT', 'sessions']]);
    seen.push(await value('N'));
  }
  assert.deepEqual(seen, ['29', '39', '29']);
});

test('a log point says what stands in braces, and stops nothing', async () => {
  await launch({}, [{ line: 15, logMessage: 'turn {N}: {N * 2}', condition: 'N >= 47' }, { line: 9 }]);
  const said = [];
  client.on('output', ({ body }) => said.push(body));
  const { reason, line } = await move(() => client.continueRequest({ threadId: 1 }));
  assert.deepEqual([reason, line], ['breakpoint', 9]);
  const logged = said.filter(({ output }) => output.startsWith('turn'));
  // It is said before its line runs, which adds to N.
  assert.deepEqual(logged.map(({ output }) => output), [47, 48, 49].map((n) => `turn ${n}: ${2 * n}\n`));
  assert.ok(logged.every(({ category }) => category === 'console'));
});

test('who set this last', async () => {
  await launch({}, [{ line: 9 }]);
  const thread = { threadId: 1 };
  await move(() => client.continueRequest(thread));
  const info = await client.dataBreakpointInfoRequest({ variablesReference: 1, name: 'N' });
  await client.setBreakpointsRequest({ source: { path: program }, breakpoints: [] });
  const watch = await client.setDataBreakpointsRequest({ breakpoints: [{ dataId: info.body.dataId, accessType: 'write' }] });
  assert.ok(watch.body.breakpoints[0].verified);
  const { reason, line } = await move(() => client.reverseContinueRequest(thread));
  assert.deepEqual([reason, line, await value('N')], ['data breakpoint', 15, '49']);
});

test('variables are shown and set; in the past only when asked twice', async () => {
  await launch({}, [{ line: 9 }]);
  const thread = { threadId: 1 };
  await move(() => client.continueRequest(thread));
  const { body: { scopes } } = await client.scopesRequest({ frameId: 1 });
  const list = async (reference) => (await client.variablesRequest({ variablesReference: reference })).body.variables;
  for (const scope of scopes) {
    assert.ok((await list(scope.variablesReference)).length > 0, scope.name);
  }
  await move(() => client.nextRequest(thread));
  const position = (await list(1)).find((variable) => variable.name === 'P');
  assert.deepEqual((await list(position.variablesReference)).map((member) => member.name), ['P.X', 'P.Y', 'P.Z']);
  assert.equal((await client.setVariableRequest({ variablesReference: 1, name: 'N', value: 'N + 5' })).body.value, '55');
  await move(() => client.stepBackRequest(thread));
  const change = () => client.setVariableRequest({ variablesReference: 1, name: 'N', value: '7' });
  await assert.rejects(change, /would be discarded: 1; repeat it to confirm/);
  assert.equal(await value('N'), '50');
  await change();
  assert.equal(await value('N'), '7');
});

test('keys and inputs come from the console, messages go there', async () => {
  await launch({}, [{ line: 10 }, { line: 12 }]);
  const thread = { threadId: 1 };
  await move(() => client.continueRequest(thread));
  await value('key F', 'repl');
  await value('VR1=8', 'repl');
  const said = client.waitForEvent('output');
  await move(() => client.continueRequest(thread));
  assert.deepEqual((await said).body, { category: 'stdout', output: 'key 70\n' });
  await assert.rejects(value('VR9=8', 'repl'));
  await assert.rejects(value('HEIGHT', 'repl'), /HEIGHT/);
  const there = await move(() => value('to 12', 'repl'));
  assert.equal(there.reason, 'goto');
  assert.equal(await value('CYCLE'), '12');
});

test('breakpoints by name', async () => {
  await launch();
  const placed = await client.setFunctionBreakpointsRequest({ breakpoints: [{ name: 'count' }, { name: 'TEACH_POS' }, { name: 'WALK' }] });
  assert.deepEqual(placed.body.breakpoints.map((one) => one.verified), [true, true, false]);
  const { reason, line } = await move(() => client.continueRequest({ threadId: 1 }));
  assert.deepEqual([reason, line], ['function breakpoint', 14]);
});

test('an emergency stop is an exception that is gone back from; going on ends the session', async () => {
  const begun = client.waitForEvent('initialized').then(() => client.configurationDoneRequest());
  const stopped = stop();
  await Promise.all([client.launch({ program: failing }), begun]);
  assert.equal((await stopped).body.reason, 'exception');
  const info = await client.exceptionInfoRequest({ threadId: 1 });
  assert.match(info.body.description, /^TIP_ERR:/);
  const { line } = await move(() => client.stepBackRequest({ threadId: 1 }));
  assert.equal(line, 5);
  await move(() => client.continueRequest({ threadId: 1 }));
  await Promise.all([client.waitForEvent('terminated'), client.continueRequest({ threadId: 1 })]);
  await client.disconnectRequest();
});

test('a run is paused', async () => {
  await launch();
  const { reason } = await move(async () => {
    await client.continueRequest({ threadId: 1 });
    await client.pauseRequest({ threadId: 1 });
  });
  // It waits for a key that nobody presses.
  assert.equal(reason, 'pause');
});

test('a long search says how far it is, and is given up', async () => {
  const said = { adapterID: 'tip', pathFormat: 'path', linesStartAt1: true, columnsStartAt1: true };
  await client.initializeRequest({ ...said, supportsProgressReporting: true });
  await Promise.all([client.waitForEvent('initialized'), client.launchRequest({ program: endless, stopOnEntry: true })]);
  await Promise.all([stop(), client.configurationDoneRequest()]);
  await move(() => value('to 30000', 'repl'));
  const breakpoints = [{ line: 6, condition: 'N < 0' }];
  await client.setBreakpointsRequest({ source: { path: endless }, breakpoints });
  const stopped = stop();
  const ended = client.waitForEvent('progressEnd');
  const [begun] = await Promise.all([client.waitForEvent('progressStart'), client.reverseContinueRequest({ threadId: 1 })]);
  assert.ok(begun.body.cancellable);
  const { progressId } = begun.body;
  await client.customRequest('cancel', { progressId });
  assert.equal((await ended).body.progressId, progressId);
  assert.equal((await stopped).body.reason, 'pause');
  assert.equal(await value('CYCLE'), '30000');
});

test('breakpoints of another file leave those of the program', async () => {
  await launch({}, [{ line: 9 }]);
  const other = await client.setBreakpointsRequest({ source: { path: failing }, breakpoints: [{ line: 5 }] });
  assert.deepEqual(other.body.breakpoints.map((one) => one.verified), [false]);
  assert.equal((await move(() => client.continueRequest({ threadId: 1 }))).line, 9);
});

test('what is wrong is answered', async () => {
  await client.initializeRequest();
  await assert.rejects(client.continueRequest({ threadId: 1 }), /no program/);
  await assert.rejects(client.customRequest('dance'), /not supported/);
  await assert.rejects(client.launchRequest({ program: join(folder, 'absent.prg') }), /absent\.prg/);
  await assert.rejects(client.launchRequest({ program, robot: 'dog' }));
});
