// How the program and the robot are: message, lamps, keys, what each leg was told last, variables; and what happened.

import { clockTime, element, fixed, make } from './dom.js';
import { countUpTo } from './search.js';
import { shown } from './source.js';
import { whenSpoken, word } from './words.js';

/** How long a key stays lit, and a fall is announced: ms. */
const PRESSED = 600;
const ANNOUNCED = 2000;

const legName = (recording, leg) => `F${leg + 1}`;

export function state(player, plot) {
  const { recording } = player;
  const devices = [...new Set(recording.lamps.map((lamp) => lamp.device))].sort((one, other) => one - other);
  const lamps = devices.map((device) => make('span', { className: 'lamp', textContent: device }));
  element('lamps').append(...lamps);
  element('lamps-box').hidden = !devices.length;
  element('inputs-box').hidden = !recording.events.length;
  const modes = recording.robot.legs.map((_, leg) => {
    const [name, text, dot] = [make('dt'), make('dd', { textContent: '–' }), make('i', { className: 'dot' })];
    dot.style.background = `var(--leg-${(leg % 9) + 1})`;
    name.append(dot, legName(recording, leg));
    element('modes').append(name, text);
    return text;
  });
  const told = recording.robot.legs.map((_, leg) => recording.commands.filter(({ target }) => concerns(target, leg)));
  const cells = recording.script.scalars.map((name, scalar) => {
    const value = make('td');
    const button = make('button', { type: 'button', textContent: name });
    button.addEventListener('click', () => plot(scalar));
    element('variables').append(make('tr', {}, make('th', { scope: 'row' }, button), value));
    return { value, button, name };
  });
  whenSpoken(() => cells.forEach(({ button, name }) => button.setAttribute('aria-label', word('plotIt', name))));

  const show = () => {
    const { cycle } = player;
    element('message').textContent = recording.messageAt(cycle) || '\u00A0';
    // What nobody sees waits until its tab is chosen.
    if (element('state-panel').classList.contains('chosen')) showState(cycle);
    const alarm = alarmAt(player);
    element('alert').hidden = !alarm;
    element('alert').textContent = alarm;
    element('now-line').textContent = recording.lineAt(cycle) ?? '–';
    showMargin(player);
  };
  const showState = (cycle) => {
    lamps.forEach((lamp, n) => {
      const switched = recording.lamps.filter((lamp) => lamp.device === devices[n] && lamp.cycle <= cycle);
      lamp.classList.toggle('on', Boolean(switched.at(-1)?.on));
    });
    told.forEach((commands, leg) => {
      const last = commands[countUpTo(commands, cycle, (command) => command.cycle) - 1];
      modes[leg].textContent = last ? `${last.op} ${last.target} ${rounded(last.values)}` : '–';
    });
    cells.forEach(({ value }, scalar) => {
      const now = recording.valueAt(scalar, cycle);
      const text = now === undefined ? '–' : shown(now);
      value.classList.toggle('changed', value.textContent !== '' && value.textContent !== text);
      value.textContent = text;
    });
    const done = recording.events.slice(0, countUpTo(recording.events, cycle, (event) => event.cycle));
    element('inputs').replaceChildren(
      ...done.slice(-6).map((event) => {
        const fresh = player.time - recording.endOf(event.cycle) < PRESSED;
        return make('kbd', { className: fresh ? 'fresh' : '', textContent: event.text });
      }),
    );
  };
  player.onMove(show);
  document.addEventListener('tab', show);
  whenSpoken(show);
  whenSpoken(() => showEnd(recording));
  whenSpoken(() => listMarks(player));
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

function showEnd({ outcome, duration }) {
  const key = { limit: 'endedLimit', interrupted: 'endedInterrupted', emergency: 'endedEmergency' }[outcome.how] ?? 'endedProgram';
  const line = outcome.line ? `, ${word('line')} ${outcome.line}` : '';
  const why = outcome.error ? `: ${outcome.error}${line}` : '';
  element('outcome').textContent = word(key, outcome.how, clockTime(duration)) + why;
  element('outcome').classList.toggle('bad', outcome.how === 'emergency');
}

function listMarks(player) {
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

