// The interface of a session, which holds a live run: behind a WebSocket (socket.js), or in a module of this page.
//
// A session has two functions:
//
//   send(request)       sends a request: an object from the list below. Its answer is one of the updates.
//   listen(listener)    calls listener(update) for each update from now on. The first ones have the whole state.
//
// It may have a third one, watch(listener), which calls listener(true) when the session is connected and listener(false) when it
// is lost. After a new connection the updates begin again with `run`.
//
// A page that replays a run contains three updates, one a line: `run`, one `more`, and a `status` with outcome and summary alone.
//
// Requests; each may have a number `id`, which its answer repeats:
//
//   {do: 'play'}   {do: 'pause'}          the run goes on, or rests
//   {do: 'step', cycles: -1}              so many cycles forward or back (1000 at most), then it rests
//   {do: 'go', cycle: 611}                back to the end of a cycle, then it rests
//   {do: 'speed', times: 0.5}             as a multiple of the robot's own
//   {do: 'event', event: 'VR1=8'}         an event as its text, which is what `--events` takes without the cycle: 'key F', 'halt'
//   {do: 'restart'}                       runs the text of the editor from the beginning
//   {do: 'edit', text, base, by}          another text in the place of version `base`, by a viewer of that name
//   {do: 'save'}   {do: 'reload'}         writes the text to its file, or takes that of the file
//   {do: 'hover', at}                     the meaning of the word at a place (line and UTF-16 column, from 1); the answer has
//                                         `hover`: {from, to, text}, Markdown in English and Japanese, or null
//   {do: 'complete', at}                  completions at a place; the answer has `offers`: [{label, detail, description,
//                                         from, to, text, fills}]: descriptions in English and Japanese, and the
//                                         text a snippet of LSP if it `fills` places
//
// and for a robot on servos, where only the viewer that drives moves it, and the emergency stop is for all:
//
//   {do: 'take'}   {do: 'give'}           takes the robot, or asks its driver for it; hands it to the viewer that asks
//   {do: 'drive', press, sticks}          a sign of life, every 100 ms: the number of the press of the button, 0 while it is not
//                                         pressed, and what VR1 to VR3 read, V. It has no answer unless it is refused
//
// Updates, by their `type`:
//
//   run        {run, robot, scene, script, channels, inputs}: a run begins. `channels` names the columns of motion, `inputs`
//              what has sliders
//   more       {run, first, from, cycles, log, frames, now}: the run up to cycle `cycles`. It replaces the entries of cycles
//              from `from` on. Entries before `first` are removed, except the last one of each key, which still holds. `log` has
//              a column of cycles and one of values under each key below. `frames` has a column of cycles and one for each
//              channel (0.01 mm, deg or N). Columns of cycles and motion hold differences. `now` is a frame of the last cycle,
//              which the next update removes, or null
//   text       {version, by, text}: the text of the editor
//   findings   {version, findings, good}: the diagnostics of the text; `good` is true if it is a program. Each has `level`,
//              `code`, `from` and `to` (line and UTF-16 column, from 1), `text` and `help` (English and Japanese), `classical`
//   status     {playing, speed, late, over, outcome, summary, running, changed, overtaken}. `late`: the run does not keep up;
//              `outcome`: how and when it ended; `summary`: its figures (docs/files.md), unless it plays; `running`: the
//              version of the text that runs; `changed`: the text of the editor differs from the file; `overtaken`: someone
//              else has changed the file
//   robot      {driver, held, asked, hold, stage, phase, servos, answers, late, stopped_in, problem}: a robot on servos.
//              `driver`: this viewer drives; `held`: somebody drives; `asked`: another viewer asks to drive; `hold`: the button
//              is needed; `phase`: ready, approach, running, leaving or left; `stage`: driven, paused, halt or emergency;
//              `servos`: each has `joint`, `id`, `angle`, `load`, `voltage`, `temperature`, `age`, `missing` and `problem`; `answers`: asked for and
//              got; `late`: number of late cycles; `stopped_in`: ms that the emergency stop took; `problem`: what is wrong
//   lesson     {phase, poses, chosen, samples, servos, problem}: a robot that a hand teaches, whose posture is the only cycle of
//              the run. `phase`: limp, goes or holds; `poses`: their names; `chosen`: the place of the pose that is chosen, or
//              to which the robot goes; `samples`: number of samples of a motion, or null; `servos` and `problem` as above
//   answer     {id, ok, error, detail}: to a request of this viewer alone. `error` is malformed, unknown, long, impossible,
//              over, many, stale, errors, unspelled, unsaved, unread, flood, and of a robot on servos
//              watching, hold, forward, moving, still, simulated or taught; `detail` says more

// Keys of the log, with their values. A value holds until the next one; a key without entries is left out. Legs, fingers and
// threads count from 1 in keys, as in programs, but for those of slips:
//
//   clock       [cycle, time, period]: this cycle began at a time (ms), and from it on each takes a period (ms)
//   step        the step of the main program      thread.N    the step of a thread, or null where it is over
//   set.N       the value of a variable, from 0   timer.N     [runs, time]: its time, or that of the robot at which it was 0 (ms)
//   read.N      the first line, but for messages, that read it after an event had set it
//   lamp.N      whether it is on                  command.N   the last command for a leg, as a text
//   message     its text                          locks       the joints that are locked, with blanks between
//   flags       those that are up, with blanks between        modes       [[target, mode]]
//   contacts    a number, whose lowest bit says whether the first foot or finger touches something
//   fall        [count, margin, kind]: falls so far, mm       slip.N      how far a foot, from 0, had slipped when that was noticed (mm)
//   collision   the two parts of the robot that overlap, such as ['link12', 'body'], or null where that is over
//   event       what happened from outside, as a text

/** Sends requests, and calls `refused(answer)` for each one that is refused. */
export class Requests {
  constructor(session, refused) {
    this.session = session;
    this.refused = refused;
    this.last = 0;
    this.asked = new Map();
    session.listen((update) => {
      if (update.type !== 'answer') return;
      const take = this.asked.get(update.id) ?? ((answer) => answer.ok || this.refused(answer));
      this.asked.delete(update.id);
      take(update);
    });
    // A lost session does not answer its open questions.
    session.watch?.(() => {
      this.asked.forEach((take) => take({ ok: false }));
      this.asked.clear();
    });
  }

  send(request) {
    this.last = (this.last + 1) % 2 ** 31;
    this.session.send({ id: this.last, ...request });
    return this.last;
  }

  /** Resolves to the answer to a question, also if it is refused. */
  ask(question) {
    return new Promise((take) => {
      this.asked.set(this.last + 1, take);
      this.send(question);
    });
  }
}
