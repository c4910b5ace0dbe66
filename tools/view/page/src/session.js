// A live run, wherever it is: behind a WebSocket (socket.js), or in a module of this page.
//
// A session has two functions:
//
//   send(request)       asks for something: an object from below. Its answer is an update like the others.
//   listen(listener)    calls listener(update) for each update from now on, the first ones bringing all that there is.
//
// and may have a third, watch(listener), which calls listener(true) when it is reached and listener(false) when it is not.
// After it is reached anew it begins anew, with an update `run`.
//
// A page that replays a run holds three updates, one a line: `run`, one `more`, and a `status` with outcome and summary alone.
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
//   {do: 'hover', at}                     what is known of the word at a place (line and UTF-16 column, from 1); the answer has
//                                         `hover`: {from, to, text}, Markdown in English and Japanese, or null
//   {do: 'complete', at}                  what can be written there; the answer has `offers`: [{label, detail, description,
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
//   more       {run, first, from, cycles, clock, frames, now, steps, contacts, sets, messages, lamps, commands, flags, modes,
//              falls, slips, events, threads, timers, locks}: what happened up to cycle `cycles`. What was known of cycles from `from` on is not so any
//              more, and what was before `first` is forgotten. What is much is in columns, the first of them cycles: `frames`
//              has one for each channel (0.01 mm, deg or N), `steps` steps, `contacts` bits of feet or fingers, `sets` variables
//              and their values, `threads` threads, counted from 1, and their steps, counted from 1, or 0 where one is over.
//              `threads`, `timers` and `locks` are there if they have an entry. Columns of cycles, steps and motion hold differences. Other lists have an entry of its cycle
//              and more for each thing. `now` is a frame of the last cycle that the next update takes back, or null
//   text       {version, by, text}: the text of the editor
//   findings   {version, findings, good}: what is found in it, and whether it is a program. Each has `level`, `code`, `from`
//              and `to` (line and UTF-16 column, from 1), `text` and `help` (English and Japanese), `classical`
//   status     {playing, speed, late, over, outcome, summary, running, changed, overtaken}: whether the run keeps up, how and when it
//              ended, its figures (docs/files.md) unless it plays,
//              which version of the text runs, whether that of the editor is not the file's, and whether someone else
//              has changed the file
//   robot      {driver, held, asked, hold, stage, phase, servos, answers, late, stopped_in, problem}: a robot on servos; whether this
//              viewer drives, somebody does, another one asks for it, and the button is needed; `phase` ready, approach, running,
//              leaving or left; `stage` driven, paused, halt or emergency; each servo has `joint`, `id`, `angle`, `load`, `voltage`,
//              `temperature` and `age`; answers asked for and got; late cycles; ms that the emergency stop took; what is wrong
//   answer     {id, ok, error, detail}: to a request of this viewer alone. `error` is malformed, unknown, long, impossible,
//              over, many, stale, errors, unspelled, unsaved, unread, flood, and of a robot on servos
//              watching, hold, forward, moving, still or simulated; `detail` says more

/** Sends requests, and calls `refused(answer)` for each that is not fulfilled. */
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
    // What was asked of a session that is lost is not answered any more.
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

  /** The answer to a question, whether it is fulfilled or not. */
  ask(question) {
    return new Promise((take) => {
      this.asked.set(this.last + 1, take);
      this.send(question);
    });
  }
}
