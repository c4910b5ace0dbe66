//! A movement under way, in portions.

use super::Debugger;
use super::backward::Back;
use super::goal::{Goal, Move, Origin};
use super::learn::Learn;
use super::progress::Progress;
use super::stop::{Reason, Stop};

/// What became of a portion of work.
#[derive(Clone, Debug, PartialEq)]
pub enum Work {
    /// There is more to do.
    Going(Progress),
    /// The debugger stands.
    Stopped(Stop),
}

/// A movement, from where it began.
#[derive(Debug)]
pub(super) struct Errand {
    pub(super) goal: Goal,
    pub(super) origin: Origin,
    is_back: bool,
    phase: Phase,
}

#[derive(Debug)]
enum Phase {
    /// Hits have to be counted first.
    Learning(Learn),
    Forward,
    Back(Back),
}

impl Debugger {
    /// Begins a movement, in the place of one that is under way; [`work`](Self::work) does it.
    pub fn start(&mut self, movement: Move) {
        self.errand = None;
        let origin = Origin {
            at: self.now,
            step: self.run.program().at(),
            depth: Self::depth(&self.run),
        };
        let goal = Goal::of(movement, self.now);
        let is_back = movement.is_back();
        if let Some(stop) = self.there_at_once(goal, is_back) {
            self.arrive(stop);
            return;
        }
        let unknown = self
            .breakpoints
            .count_known(&self.history, self.now + u64::from(!is_back));
        let unknown = unknown.filter(|_| goal.stops_early());
        if !is_back && self.now == 0 {
            self.log_here();
        }
        let phase = match unknown.and_then(|from| Learn::new(from, self)) {
            Some(learn) => Phase::Learning(learn),
            None => Phase::after_learning(is_back, self.now),
        };
        self.errand = Some(Errand {
            goal,
            origin,
            is_back,
            phase,
        });
    }

    /// Where a movement ends that needs no work.
    fn there_at_once(&self, goal: Goal, is_back: bool) -> Option<Stop> {
        let at = self.now;
        match goal {
            Goal::At(to) if is_back || to <= self.history.len() => {
                let reason = match (to, is_back) {
                    (0, true) => Reason::Start,
                    (_, true) => Reason::Step,
                    _ if to == at + 1 => self.end_at(to).unwrap_or(Reason::Step),
                    _ => Reason::There,
                };
                Some(Stop { reason, at: to })
            }
            _ if is_back => (at == 0).then_some(Stop {
                reason: Reason::Start,
                at,
            }),
            _ => self.end_at(at).map(|reason| Stop { reason, at }),
        }
    }

    /// Goes on with the movement for at most so many cycles. While it searches backwards, the debugger stands where it was.
    pub fn work(&mut self, cycles: u64) -> Work {
        let Some(mut errand) = self.errand.take() else {
            return Work::Stopped(self.stop.clone());
        };
        let mut left = cycles.max(1);
        let found = loop {
            match &mut errand.phase {
                Phase::Learning(learn) => match self.learn(learn, &mut left) {
                    true => errand.phase = Phase::after_learning(errand.is_back, self.now),
                    false => break None,
                },
                Phase::Forward => break self.run_on(errand.goal, &errand.origin, &mut left),
                Phase::Back(back) => {
                    break self.look_back(back, errand.goal, &errand.origin, &mut left);
                }
            }
        };
        match found {
            Some(stop) => {
                self.arrive(stop);
                Work::Stopped(self.stop.clone())
            }
            None => {
                let progress = errand.progress(self.now);
                self.errand = Some(errand);
                Work::Going(progress)
            }
        }
    }

    /// A whole movement.
    pub fn go(&mut self, movement: Move) -> Stop {
        self.start(movement);
        loop {
            if let Work::Stopped(stop) = self.work(u64::MAX) {
                return stop;
            }
        }
    }

    /// Whether a movement is under way.
    pub fn is_going(&self) -> bool {
        self.errand.is_some()
    }

    /// Gives a movement up: forwards the debugger stands where it has come to, backwards where it was.
    pub fn cancel(&mut self) -> &Stop {
        if self.errand.take().is_some() {
            self.stop = Stop {
                reason: Reason::Interrupted,
                at: self.now,
            };
        }
        &self.stop
    }

    fn arrive(&mut self, stop: Stop) {
        self.seek(stop.at);
        self.stop = stop;
    }
}

impl Phase {
    fn after_learning(is_back: bool, now: u64) -> Self {
        match is_back {
            true => Phase::Back(Back::new(now)),
            false => Phase::Forward,
        }
    }
}

impl Errand {
    fn progress(&self, now: u64) -> Progress {
        match &self.phase {
            Phase::Learning(learn) => learn.progress(),
            Phase::Forward => Progress {
                done: now - self.origin.at,
                of: match self.goal {
                    Goal::At(to) => Some(to - self.origin.at),
                    _ => None,
                },
            },
            Phase::Back(back) => back.progress(self.origin.at),
        }
    }
}
