// The page of a live run with any session.

import { controls } from './controls.js';
import { Driving } from './driving.js';
import { element } from './dom.js';
import { Editor } from './editor.js';
import { showFigures } from './figures.js';
import { FollowingPlayer } from './following.js';
import { choices, dialogs, keys, languages, notice, observeSize, openStage, showTab, tabs, themes } from './page.js';
import { Lesson } from './lesson.js';
import { LIVE_WORDS } from './live-words.js';
import { Plots } from './plots.js';
import { Recording } from './recording.js';
import { Requests } from './session.js';
import { endOf, listMarks, state } from './state.js';
import { timeline } from './timeline.js';
import { teach, whenSpoken, word } from './words.js';

/** Time between two updates of plots, marks and the list of events, ms. */
const SELDOM = 250;
/** Length of the part that plots show while they follow the run, ms. */
const WINDOW = 30_000;

/** Chooses the language and opens the stage before a run begins. */
export function prepareLive() {
  teach(LIVE_WORDS);
  languages();
  return openStage();
}

/** Shows the run of a session (see session.js) on a stage. */
export function openLive(session, stage) {
  let [page, recording, begun] = [];
  const requests = new Requests(session, (answer) => {
    if (answer.error === 'stale') page?.editor.refused();
    notice(word(`refused-${answer.error}`, answer.detail ?? ''));
  });
  const takes = {
    // The page is built with the first cycle, which an update `more` brings.
    run: (update) => (begun = update),
    more(update) {
      const begins = begun;
      begun = undefined;
      if (begins) recording = page ? recording.begin(begins) : new Recording(begins);
      recording.take(update);
      page ??= build(requests, recording, stage);
      if (begins) page.begun();
      page.more();
    },
    text: (update) => page.editor.takeText(update),
    findings: (update) => page.editor.takeFindings(update),
    status: (update) => page.status(update),
    robot: (update) => page.robot(update),
    lesson: (update) => page.lesson(update),
  };
  session.listen((update) => takes[update.type]?.(update));
  session.watch?.((reached) => {
    document.documentElement.dataset.reached = reached;
    element('lost').hidden = reached;
    // Without a session only the recorded cycles can be shown, so the other controls are disabled.
    for (const part of ['controls', 'play', 'speed', 'restart', 'save', 'reload', 'go-on']) element(part)?.toggleAttribute('inert', !reached);
  });
  return requests;
}

/** Builds all views of a run at its first cycle. Returns the handlers of updates. */
function build(requests, recording, stage) {
  let status = { playing: false, speed: 1 };
  const kind = () => JSON.stringify([recording.robot, recording.scene]);
  let around = kind();
  // A page without a file, such as the playground, has no button to save.
  const hasFile = Boolean(element('save'));
  let [dirty, seldom] = [false, 0];
  const player = new FollowingPlayer(recording, requests);
  const editor = new Editor(requests, player);
  editor.running(recording.script);
  stage?.begin(recording);
  // Charts are built after the first picture of the robot.
  let plots;
  const charts = () => (plots ??= new Plots(player));
  const strip = timeline(player);
  const shown = state(player, (scalar) => {
    showTab('plots-tab');
    charts().showVariable(scalar);
  }, {
    assign: (name, value) => requests.send({ do: 'event', event: `set ${name}=${value}` }),
    constant: (name) => editor.constantOf(name),
    write: (name, value) => notice(editor.writeConstant(name, value)),
  });
  const [driving, lesson] = [new Driving(requests), new Lesson()];
  const knobs = controls(requests, recording, driving);

  const showNames = () => {
    const { title, name } = recording.script;
    document.title = title || name;
    element('title').textContent = title || name;
    element('file').textContent = `${name} · ${recording.robot.name}`;
  };
  const showStatus = () => {
    const { playing, late, over, changed, overtaken } = status;
    const goes = late ? 'runsLate' : 'runs';
    element('outcome').textContent = over ? endOf(recording) : word(playing ? goes : 'rests');
    element('outcome').classList.toggle('bad', Boolean(over) && recording.outcome.how === 'emergency');
    if (hasFile) {
      element('file-state').textContent = word(overtaken ? 'overtaken' : changed ? 'unsaved' : 'saved');
      element('file-state').classList.toggle('bad', Boolean(overtaken));
    }
    if (status.summary) showFigures(player, status.summary);
    element('past').hidden = player.following;
    element('past-text').textContent = word('looksBack', player.cycle);
  };
  const showSeldom = () => {
    const now = performance.now();
    if (now - seldom < SELDOM) return;
    seldom = now;
    strip.draw();
    if (player.following) plots?.follow(WINDOW);
    if (element('log-panel').classList.contains('chosen')) listMarks(player);
  };
  const draw = () => {
    dirty = false;
    stage?.forget(recording.changed);
    recording.changed = recording.frames.length;
    player.grown();
    showSeldom();
  };

  player.onMove(() => {
    stage?.show(player.time);
    knobs.show();
    if (!player.following) showStatus();
  });
  player.onRest(() => editor.light(recording.markedLineAt(player.cycle), recording.threadsAt(player.cycle)));
  player.onState(showStatus);
  whenSpoken(showStatus);
  whenSpoken(() => listMarks(player));
  document.addEventListener('tab', () => {
    listMarks(player);
    seldom = 0;
    showSeldom();
  });
  const offer = stage ? choices(stage, player) : () => {};
  element('restart').addEventListener('click', () => editor.ask({ do: 'restart' }));
  if (hasFile) {
    element('save').addEventListener('click', () => editor.ask({ do: 'save' }));
    element('reload').addEventListener('click', () => requests.send({ do: 'reload' }));
  }
  element('newest').addEventListener('click', () => player.newest());
  element('go-on').addEventListener('click', () => player.goOnFromHere());
  themes(() => {
    stage?.recolour();
    plots?.build();
    strip.draw();
    player.goToTime(player.time);
  });
  observeSize(stage, strip);
  tabs();
  dialogs();
  keys(player, stage);
  showNames();
  stage?.resize();
  draw();
  stage?.resetView();
  stage?.drawNow();
  document.documentElement.dataset.ready = Math.round(performance.now());
  requestAnimationFrame(() => setTimeout(charts));

  return {
    editor,
    begun() {
      if (kind() !== around) {
        around = kind();
        stage?.begin();
        offer();
      }
      knobs.begin();
      shown.begin();
      plots?.begin();
      editor.running(recording.script);
      showNames();
      player.newest();
    },
    more() {
      if (dirty) return;
      dirty = true;
      requestAnimationFrame(draw);
    },
    robot(update) {
      player.goesForward = true;
      driving.take(update);
    },
    lesson: (update) => lesson.take(update),
    status(update) {
      status = update;
      recording.outcome = update.outcome ?? { how: 'limit' };
      player.takeStatus(update);
      player.grown();
    },
  };
}
