// How the program and the robot are: message, lamps, keys, what each leg was told last, variables; and what happened.

import { clockTime, element, fixed, make } from './dom.js';
import { countUpTo, lastUpTo } from './search.js';
import { shown } from './source.js';
import { whenSpoken, word } from './words.js';

/** How long a key stays lit, and a fall is announced: ms. */
const PRESSED = 600;
const ANNOUNCED = 2000;

const legName = (recording, leg) => `F${leg + 1}`;

export function state(player, plot) {
  const { recording } = player;
  let [devices, lamps, cells, modes] = [[], [], [], []];
  /** The rows that a robot and its program have, once it runs. */
  const begin = () => {
    element('modes').replaceChildren();
    modes = recording.robot.legs.map((_, leg) => {
      const [name, mode, command] = [make('dt'), make('span', { className: 'mode' }), make('span')];
      const dot = make('i', { className: 'dot' });
      dot.style.background = `var(--leg-${(leg % 9) + 1})`;
      name.append(dot, legName(recording, leg));
      element('modes').append(name, make('dd', {}, mode, command));
      return { mode, command };
    });
    cells = recording.script.scalars.map((name, scalar) => {
      const value = make('td');
      const button = make('button', { type: 'button', textContent: name });
      button.addEventListener('click', () => plot(scalar));
      return { value, button, name };
    });
    element('variables').replaceChildren(...cells.map(({ value, button }) => make('tr', {}, make('th', { scope: 'row' }, button), value)));
    nameCells();
  };
  const nameCells = () => cells.forEach(({ button, name }) => button.setAttribute('aria-label', word('plotIt', name)));

  const show = () => {
    const { cycle } = player;
    element('message').textContent = recording.messageAt(cycle);
    const alarm = alarmAt(player);
    element('alert').hidden = !alarm;
    element('alert').textContent = alarm;
    element('now-line').textContent = recording.lineAt(cycle) ?? '–';
    showMargin(player);
  };
  const showState = () => {
    // What nobody sees waits until its tab is chosen.
    if (!element('state-panel').classList.contains('chosen')) return;
    const { cycle } = player;
    showLamps(cycle);
    const now = lastUpTo(recording.modes, cycle)?.list ?? [];
    modes.forEach(({ mode, command }, leg) => {
      const last = lastCommand(recording.commands, leg, cycle);
      command.textContent = last ? `${last.op} ${last.target} ${rounded(last.values)}` : '–';
      mode.textContent = inWords(now.filter(([target]) => concerns(target, leg)));
    });
    const threads = recording.threadsAt(cycle).map(({ name, line }) => `${name}: ${word('line')} ${line}`);
    showBox('threads', recording.threads.length, threads.join(', '));
    const timers = recording.timersAt(cycle).map(({ timer, time }) => `${timer}: ${shown(Math.round(time * 1000) / 1000)} ms`);
    showBox('timers', recording.timers.length, timers.join(', '));
    showBox('locks', recording.locks.length, lastUpTo(recording.locks, cycle)?.text);
    const flags = lastUpTo(recording.flags, cycle)?.text;
    element('flags-box').hidden = flags === undefined;
    element('flags').textContent = flags || word('none');
    cells.forEach(({ value }, scalar) => {
      const now = recording.valueAt(scalar, cycle);
      const text = now === undefined ? '–' : shown(now);
      value.classList.toggle('changed', value.textContent !== '' && value.textContent !== text);
      value.textContent = text;
    });
    const done = recording.events.slice(0, countUpTo(recording.events, cycle, (event) => event.cycle));
    element('inputs-box').hidden = !recording.events.length;
    element('inputs').replaceChildren(
      ...done.slice(-6).map((event) => {
        const fresh = player.time - recording.endOf(event.cycle) < PRESSED;
        return make('kbd', { className: fresh ? 'fresh' : '', textContent: event.text });
      }),
    );
  };
  const showLamps = (cycle) => {
    const known = [...new Set(recording.lamps.map((lamp) => lamp.device))].sort((one, other) => one - other);
    if (known.join() !== devices.join()) {
      devices = known;
      lamps = devices.map((device) => make('span', { className: 'lamp', textContent: device }));
      element('lamps').replaceChildren(...lamps);
    }
    element('lamps-box').hidden = !devices.length;
    lamps.forEach((lamp, n) => {
      const switched = recording.lamps.findLast((lamp) => lamp.device === devices[n] && lamp.cycle <= cycle);
      lamp.classList.toggle('on', Boolean(switched?.on));
    });
  };
  begin();
  player.onMove(show);
  player.onRest(showState);
  document.addEventListener('tab', showState);
  whenSpoken(nameCells);
  whenSpoken(show);
  whenSpoken(showState);
  return { begin };
}

/** Shows what there is of something, where the run has any. */
function showBox(name, any, text) {
  element(`${name}-box`).hidden = !any;
  element(name).textContent = text || word('none');
}

/** How a leg is controlled: its foot, or its joints, which share a word if they can. */
function inWords(modes) {
  const said = modes.map(([target, mode]) => [target, word(`mode-${mode}`)]);
  const [first] = said;
  if (said.length && said.every(([, mode]) => mode === first[1])) return first[1];
  return said.map((words) => words.join(' ')).join(', ');
}

/** What a leg was commanded last until the end of a cycle. */
function lastCommand(commands, leg, cycle) {
  for (let n = countUpTo(commands, cycle, (command) => command.cycle) - 1; n >= 0; n--) {
    if (concerns(commands[n].target, leg)) return commands[n];
  }
  return undefined;
}

function showMargin({ recording, cycle, time }) {
  const margin = recording.value('margin', recording.between(time));
  element('margin-box').hidden = margin === undefined;
  element('falls-box').hidden = margin === undefined;
  if (margin === undefined) return;
  element('now-margin').textContent = `${fixed(margin, 0)} mm`;
  element('now-margin').classList.toggle('bad', margin < 0);
  const falls = countUpTo(recording.falls, cycle, (fall) => fall.cycle);
  element('now-falls').textContent = falls;
  element('now-falls').classList.toggle('bad', falls > 0);
}

/** What has just gone wrong, in words. */
function alarmAt({ recording, cycle, time }) {
  if (recording.outcome.how === 'emergency' && cycle === recording.cycles - 1) return word('fault');
  const fall = recording.falls[countUpTo(recording.falls, cycle, (one) => one.cycle) - 1];
  return fall && time - recording.endOf(fall.cycle) < ANNOUNCED ? word('fell') : '';
}

/** Whether a command is for a leg. */
function concerns(target, leg) {
  return target === 'ALL' || target === `F${leg + 1}` || (target.length === 3 && target.startsWith(`J${leg + 1}`));
}

function rounded(values) {
  return values.replace(/-?\d+\.\d+(e[-+]?\d+)?/g, (number) => shown(Number(number)));
}

/** How a run ended, and when. */
export function endOf({ outcome, duration }) {
  const key = { limit: 'endedLimit', interrupted: 'endedInterrupted', emergency: 'endedEmergency' }[outcome.how] ?? 'endedProgram';
  const line = outcome.line ? `, ${word('line')} ${outcome.line}` : '';
  const why = outcome.error ? `: ${outcome.error}${line}` : '';
  return word(key, outcome.how, clockTime(duration)) + why;
}

/** All that happened besides the motion. */
export function listMarks(player) {
  const { recording } = player;
  const words = {
    message: ({ text }) => text,
    event: ({ text }) => text,
    fall: ({ margin }) => `${word('fell')} (${fixed(margin, 1)} mm)`,
    slip: ({ leg, distance }) => `${word('slipped', legName(recording, leg))} (${fixed(distance, 1)} mm)`,
    fault: () => `${word('fault')}: ${recording.outcome.error}`,
  };
  const rows = recording.marks.map((mark) => {
    const button = make('button', { type: 'button', className: `mark ${mark.kind}` });
    button.append(
      make('time', { textContent: clockTime(recording.endOf(mark.cycle)) }),
      make('span', { className: 'kind', textContent: '' }),
      make('span', { textContent: words[mark.kind](mark) }),
    );
    button.addEventListener('click', () => {
      player.pause();
      player.goTo(mark.cycle);
    });
    return make('li', {}, button);
  });
  element('marks').replaceChildren(...(rows.length ? rows : [make('li', { className: 'nothing', textContent: word('noEvents') })]));
}

