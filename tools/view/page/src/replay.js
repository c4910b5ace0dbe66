// The page that contains the recording of a run.

import { Alignment, changesOf, namesOf } from './comparison.js';
import { element } from './dom.js';
import { exporting } from './export.js';
import { showFigures } from './figures.js';
import { choices, dialogs, keys, languages, observeSize, openStage, showTab, tabs, themes } from './page.js';
import { Player } from './player.js';
import { Plots } from './plots.js';
import { Recording } from './recording.js';
import { source } from './source.js';
import { endOf, listMarks, state } from './state.js';
import { timeline } from './timeline.js';
import { whenSpoken, word } from './words.js';

/** Shows the recording in an element. */
export async function openReplay(held) {
  let player;
  languages(() => player?.goToTime(player.time));
  const stage = openStage();
  const recording = await Recording.of(held.textContent);
  const compared = element('compared').textContent;
  const other = compared && (await Recording.of(compared));
  const changes = other ? changesOf(other.diff) : [];
  player = new Player(recording, other, changes);
  element('title').textContent = recording.script.title || recording.script.name;
  whenSpoken(() => {
    const ghost = other ? ` · ${word('ghost', other.script.name)}` : '';
    element('file').textContent = `${recording.script.name} · ${recording.robot.name}${ghost}`;
  });
  stage?.begin(recording);
  if (other) stage?.compare(other, (time) => player.otherTime(time));
  // Charts are built after the first picture of the robot.
  let plots;
  const charts = () => (plots ??= new Plots(player));
  const strip = timeline(player);
  const plot = (scalar) => {
    showTab('plots-tab');
    charts().showVariable(scalar);
  };
  source(player, plot);
  state(player, plot);
  whenSpoken(() => {
    const runs = other ? [recording, other] : [recording];
    const names = namesOf(runs);
    element('outcome').textContent = other ? runs.map((run, n) => `${names[n]}: ${endOf(run)}`).join(' · ') : endOf(recording);
    element('outcome').classList.toggle('bad', recording.outcome.how === 'emergency' || other?.outcome?.how === 'emergency');
  });
  whenSpoken(() => listMarks(player));
  whenSpoken(() => showFigures(player, recording.summary, other || undefined));
  if (other) {
    const [align, subtract] = ['plot-align', 'plot-difference'].map(element);
    align.hidden = subtract.hidden = false;
    const press = (button, act) => button.addEventListener('click', () => {
      const on = button.getAttribute('aria-pressed') !== 'true';
      button.setAttribute('aria-pressed', on);
      act(on);
    });
    press(subtract, (on) => charts().subtract(on));
    press(align, (on) => {
      player.alignment = on ? new Alignment(recording, other, changes) : undefined;
      listMarks(player);
      charts().retime();
      strip.draw();
      player.goToTime(player.time);
    });
  }
  if (stage) {
    player.onMove(() => stage.show(player.time));
    exporting(player, stage);
    choices(stage, player);
  }
  player.onMove(() => rememberPlace(player));
  player.onState(() => rememberPlace(player));
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
  const go = () => player.goTo(linked() ?? player.place);
  window.addEventListener('hashchange', () => {
    player.pause();
    go();
  });
  stage?.resize();
  go();
  strip.draw();
  stage?.resetView();
  stage?.drawNow();
  const { dataset } = document.documentElement;
  dataset.ready = Math.round(performance.now());
  requestAnimationFrame(() => setTimeout(charts));
  // A page around this one may ask it to play immediately.
  if (dataset.plays !== undefined) player.play();
}

/** Returns the cycle of an address such as `#cycle=611`. */
function linked() {
  const cycle = new URLSearchParams(location.hash.slice(1)).get('cycle');
  return /^\d+$/.test(cycle ?? '') ? Number(cycle) : undefined;
}

function rememberPlace(player) {
  if (player.playing) return;
  clearTimeout(rememberPlace.due);
  rememberPlace.due = setTimeout(() => {
    try {
      history.replaceState(null, '', `#cycle=${player.place}`);
    } catch {
      // A page inside another one may be unable to change its address.
    }
  }, 200);
}
