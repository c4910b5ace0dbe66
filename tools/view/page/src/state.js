// The state of program and robot: message, lamps, inputs, the last command of each leg, variables; and the list of events.

import { clockTime, element, fixed, make } from './dom.js';
import { feet } from './kinematics.js';
import { namesOf } from './comparison.js';
import { countUpTo } from './search.js';
import { shown } from './source.js';
import { label, whenSpoken, word } from './words.js';

/** Times for which a key stays lit and a fall is announced, ms. */
const PRESSED = 600;
const ANNOUNCED = 2000;

/** Distance from a limit within which a joint counts as at the limit, deg. */
const NEAR = 0.5;

const legName = (recording, leg) => `F${leg + 1}`;

/**
 * Shows the state. A replay has no `live`: its `assign(name, value)` assigns a variable, `constant(name)` returns what the text of the
 * program assigns to it, `{ line, value }`, and `write(name, value)` writes another value there.
 */
export function state(player, plot, live) {
  const { recording } = player;
  let [devices, lamps, cells, modes, joints, places] = [[], [], [], [], [], []];
  /** Creates the rows for the robot and the program of a run that begins. */
  const begin = () => {
    element('modes').replaceChildren();
    modes = recording.robot.legs.map((_, leg) => {
      const [name, mode, command] = [make('dt'), make('span', { className: 'mode' }), make('span')];
      name.append(dotOf(leg), legName(recording, leg));
      element('modes').append(name, make('dd', {}, mode, command));
      return { mode, command };
    });
    joints = recording.robot.legs.flatMap((leg, l) => leg.joints.map((joint, j) => jointRow(l, j, joint)));
    element('joint-rows').replaceChildren(...joints.map(({ row }) => row));
    element('feet').replaceChildren();
    places = recording.robot.legs.map((_, leg) => {
      const [name, place] = [make('dt', {}, dotOf(leg), legName(recording, leg)), make('dd')];
      element('feet').append(name, place);
      return place;
    });
    cells = recording.script.scalars.map((name, scalar) => {
      const [value, from, write] = [make('td'), make('button', { type: 'button' }), make('button', { type: 'button', hidden: true })];
      from.addEventListener('click', () => {
        const { cycle } = player;
        const { set, isOutside, read } = origin(name, scalar, cycle);
        player.pause();
        if (isOutside) {
          player.goTo(read);
          return;
        }
        // At the cycle of the assignment, the button leads to the one before.
        player.goTo((set === cycle ? recording.lastOf(`set.${scalar}`, cycle - 1) : set) ?? set);
      });
      if (live) assignable(value, name, live.assign);
      write.addEventListener('click', () => live.write(name, recording.at(`set.${scalar}`, player.cycle)));
      const button = make('button', { type: 'button', textContent: name });
      button.addEventListener('click', () => plot(scalar));
      return { value, button, name, from, write };
    });
    element('variables').replaceChildren(...cells.map(({ value, button, from, write }) => make('tr', {}, make('th', { scope: 'row' }, button), value, make('td', { className: 'from' }, from, write))));
    nameCells();
  };
  const nameCells = () => {
    cells.forEach(({ button, name }) => button.setAttribute('aria-label', word('plotIt', name)));
    element('torque-unit').textContent = word('torque', recording.robot.planar ? 'mN·m' : 'N·m');
  };

  const show = () => {
    const { cycle } = player;
    element('message').textContent = recording.messageAt(cycle);
    const { runs } = player;
    const names = runs.length > 1 ? namesOf(runs.map(({ recording }) => recording)) : [''];
    const alarms = runs.map((run, n) => [names[n], alarmAt(run)]).filter(([, alarm]) => alarm);
    element('alert').hidden = !alarms.length;
    element('alert').textContent = alarms.map((alarm) => alarm.filter(Boolean).join(': ')).join(' · ');
    element('now-line').textContent = runs.map(({ recording, cycle }) => recording.markedLineAt(cycle) ?? '–').join(' | ');
    showMargin(player);
  };
  const showState = () => {
    // A hidden tab is updated when it is chosen.
    if (!element('state-panel').classList.contains('chosen')) return;
    const { cycle } = player;
    showLamps(cycle);
    const now = recording.at('modes', cycle) ?? [];
    modes.forEach(({ mode, command }, leg) => {
      command.textContent = rounded(recording.at(`command.${leg + 1}`, cycle) ?? '–');
      mode.textContent = inWords(now.filter(([target]) => concerns(target, leg)));
    });
    showJoints();
    const threads = recording.threadsAt(cycle).map(({ name, line }) => `${name}: ${word('line')} ${line}`);
    showBox('threads', recording.threads.length, threads.join(', '));
    const timers = recording.timersAt(cycle).map(({ timer, time }) => `${timer}: ${shown(Math.round(time * 1000) / 1000)} ms`);
    showBox('timers', recording.numbers('timer').length, timers.join(', '));
    showBox('locks', recording.entries('locks').cycles.length, recording.at('locks', cycle));
    const flags = recording.at('flags', cycle);
    element('flags-box').hidden = flags === undefined;
    element('flags').textContent = flags || word('none');
    const events = recording.entries('event');
    cells.forEach(({ value, name, from, write }, scalar) => {
      const { set, isOutside, read } = origin(name, scalar, cycle);
      from.hidden = set === undefined;
      from.disabled = isOutside && read === undefined;
      if (from.disabled) {
        from.textContent = word('unread');
        label(from, 'unreadYet', name);
      } else if (!from.hidden) {
        const line = isOutside ? recording.at(`read.${scalar}`, cycle) : recording.lineAt(set);
        from.textContent = word(isOutside ? 'readIn' : 'inLine', line);
        label(from, isOutside ? 'readBy' : 'setBy', name, line);
      }
      const constant = isOutside ? live?.constant(name) : undefined;
      write.hidden = !constant || constant.value === recording.at(`set.${scalar}`, cycle);
      if (!write.hidden) {
        write.textContent = word('writeIt');
        label(write, 'writeInto', name, constant.line);
      }
      const now = recording.at(`set.${scalar}`, cycle);
      const text = now === undefined ? '–' : shown(now);
      // The user edits the value.
      if (value.firstElementChild) return;
      value.classList.toggle('changed', value.textContent !== '' && value.textContent !== text);
      value.textContent = text;
    });
    const done = countUpTo(events.cycles, cycle);
    element('inputs-box').hidden = !events.cycles.length;
    element('inputs').replaceChildren(
      ...events.values.slice(Math.max(done - 6, 0), done).map((text, n) => {
        const fresh = player.time - recording.endOf(events.cycles[Math.max(done - 6, 0) + n]) < PRESSED;
        return make('kbd', { className: fresh ? 'fresh' : '', textContent: text });
      }),
    );
  };
  /** Returns the cycle in which a variable got its value up to another one; if it came from outside, also the first that read it. */
  const origin = (name, scalar, cycle) => {
    const [set, last] = ['set', 'read'].map((key) => recording.lastOf(`${key}.${scalar}`, cycle));
    const events = recording.entries('event');
    const isOutside = events.cycles.some((cycle, n) => cycle === set && events.values[n].startsWith(`set ${name}=`));
    return { set, isOutside, read: isOutside && last >= set ? last : undefined };
  };
  const showJoints = () => {
    const place = recording.between(player.time);
    const value = (name) => recording.value(name, place);
    for (const { l, j, limits: [min, max], angle, setpoint, torque } of joints) {
      const [now, lag, effort] = ['angle', 'lag', 'torque'].map((name) => value(`${name}.${l}.${j}`));
      angle.textContent = fixed(now ?? 0, 1);
      angle.classList.toggle('bad', now < min + NEAR || now > max - NEAR);
      setpoint.textContent = lag === undefined ? '–' : fixed(now + lag, 1);
      torque.textContent = effort === undefined ? '–' : fixed(effort, 2);
    }
    // Without a pose, the places are in the robot frame, as in programs.
    feet(recording.robot, { angles: recording.posture(place).angles }).forEach((foot, leg) => {
      places[leg].textContent = foot.toArray().map((at) => fixed(at, 1)).join('  ');
    });
  };
  const showLamps = (cycle) => {
    const known = recording.numbers('lamp');
    if (known.join() !== devices.join()) {
      devices = known;
      lamps = devices.map((device) => make('span', { className: 'lamp', textContent: device }));
      element('lamps').replaceChildren(...lamps);
    }
    element('lamps-box').hidden = !devices.length;
    lamps.forEach((lamp, n) => lamp.classList.toggle('on', Boolean(recording.at(`lamp.${devices[n]}`, cycle))));
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

function dotOf(leg) {
  const dot = make('i', { className: 'dot' });
  dot.style.background = `var(--leg-${(leg % 9) + 1})`;
  return dot;
}

/** Creates a row of the table of joints. */
function jointRow(l, j, { limits }) {
  const [angle, setpoint, torque] = [make('td'), make('td'), make('td')];
  const range = make('td', { textContent: limits.map((limit) => fixed(limit, 0)).join(' … ') });
  const row = make('tr', {}, make('th', { scope: 'row' }, dotOf(l), `J${l + 1}${j + 1}`), angle, setpoint, range, torque);
  return { l, j, limits, angle, setpoint, torque, row };
}

/** Makes the cell of a variable editable: at a click or Enter it becomes a field. */
function assignable(cell, name, assign) {
  const open = () => {
    if (cell.firstElementChild) return;
    const field = make('input', { className: 'assigned', inputMode: 'decimal', value: cell.textContent === '–' ? '' : cell.textContent });
    field.setAttribute('aria-label', word('assign', name));
    let done = false;
    const close = (takes) => {
      if (done) return;
      done = true;
      const { value } = field;
      cell.textContent = value;
      if (takes && value.trim() !== '') assign(name, value.trim());
      cell.focus();
    };
    field.addEventListener('keydown', (event) => {
      event.stopPropagation();
      if (event.key === 'Enter') close(true);
      if (event.key === 'Escape') close(false);
    });
    field.addEventListener('blur', () => close(false));
    cell.replaceChildren(field);
    field.focus();
    field.select();
  };
  cell.tabIndex = 0;
  cell.classList.add('assignable');
  cell.addEventListener('click', open);
  cell.addEventListener('keydown', (event) => {
    if (event.key === 'Enter' && event.target === cell) {
      event.preventDefault();
      open();
    }
  });
}

/** Shows a box with a text, if the run has entries for it. */
function showBox(name, any, text) {
  element(`${name}-box`).hidden = !any;
  element(name).textContent = text || word('none');
}

/** Describes the control modes of a leg: of its foot, or of its joints, with one word if all have the same. */
function inWords(modes) {
  const said = modes.map(([target, mode]) => [target, word(`mode-${mode}`)]);
  const [first] = said;
  if (said.length && said.every(([, mode]) => mode === first[1])) return first[1];
  return said.map((words) => words.join(' ')).join(', ');
}

function showMargin({ runs }) {
  const known = runs.map(({ recording, cycle, time }) => {
    const margin = recording.value('margin', recording.between(time));
    return margin === undefined ? [] : [margin, (recording.at('fall', cycle) ?? [0])[0]];
  });
  const isKnown = known.some(({ length }) => length);
  element('margin-box').hidden = element('falls-box').hidden = !isKnown;
  if (!isKnown) return;
  const margins = known.map(([margin]) => (margin === undefined ? '–' : fixed(margin, 0)));
  element('now-margin').textContent = `${margins.join(' | ')} mm`;
  element('now-margin').classList.toggle('bad', known.some(([margin]) => margin < 0));
  element('now-falls').textContent = known.map(([, falls]) => falls ?? '–').join(' | ');
  element('now-falls').classList.toggle('bad', known.some(([, falls]) => falls > 0));
}

/** Returns the text about a fall or fault that has just happened. */
function alarmAt({ recording, cycle, time }) {
  if (recording.isStoppedAt(cycle)) return word('fault');
  const parts = recording.at('collision', cycle);
  if (parts) return word('overlap', ...parts);
  const fall = recording.lastOf('fall', cycle);
  if (fall === undefined || time - recording.endOf(fall) >= ANNOUNCED) return '';
  const [, , kind] = recording.at('fall', cycle);
  return word(kind ?? 'fell');
}

/** Returns true if a target concerns a leg. */
function concerns(target, leg) {
  return target === 'ALL' || target === `F${leg + 1}` || (target.length === 3 && target.startsWith(`J${leg + 1}`));
}

function rounded(values) {
  return values.replace(/-?\d+\.\d+(e[-+]?\d+)?/g, (number) => shown(Number(number)));
}

/** Describes the end of a run with its time. */
export function endOf({ outcome }) {
  const key = { limit: 'endedLimit', interrupted: 'endedInterrupted', emergency: 'endedEmergency' }[outcome.how] ?? 'endedProgram';
  const line = outcome.line ? `, ${word('line')} ${outcome.line}` : '';
  const why = outcome.error ? `: ${outcome.error}${line}` : '';
  return word(key, outcome.how, clockTime(outcome.time)) + why;
}

/** Fills the list of events of a run, or of two. */
export function listMarks(player) {
  const runs = player.runs.map(({ recording }) => recording);
  const names = runs.length > 1 && namesOf(runs);
  const words = {
    message: (text) => text,
    event: (text) => text,
    fall: ([, margin, kind]) => `${word(kind ?? 'fell')} (${fixed(margin, 1)} mm)`,
    collision: (parts) => word('overlap', ...parts),
    slip: ({ leg, distance }) => `${word('slipped', legName(player.recording, leg))} (${fixed(distance, 1)} mm)`,
    fault: (_, { outcome }) => `${word('fault')}: ${outcome.error}`,
  };
  const rows = player.marks.map((mark) => {
    const recording = runs[mark.run];
    const button = make('button', { type: 'button', className: `mark ${mark.kind}` });
    button.append(
      make('time', { textContent: clockTime(recording.told(recording.endOf(mark.kind === 'fall' ? mark.cycle - 1 : mark.cycle))) }),
      make('span', { className: 'kind', textContent: '' }),
      make('span', { textContent: (names ? `${names[mark.run]}: ` : '') + words[mark.kind](mark.value, recording) }),
    );
    button.addEventListener('click', () => {
      player.pause();
      player.goToMoment(mark);
    });
    return make('li', {}, button);
  });
  element('marks').replaceChildren(...(rows.length ? rows : [make('li', { className: 'nothing', textContent: word('noEvents') })]));
}

