//! The walk as one writes it by hand: the motion's figures are constants, the four swings share their
//! states, and the state is an enum. What the program calculates at its start is known here, so that
//! those cycles only pass.

use crate::by_hand::ask;
use tip_runtime::command::{Op, Poll, Target};
use tip_runtime::fault::Fault;
use tip_runtime::ops::finite;
use tip_runtime::program::{Context, Flow};

const STRIDE: f64 = 200.0;
const HALF: f64 = STRIDE / 2.0;
const TWICE: f64 = 80.0;
const GROUND: f64 = -250.0;
const TOP: f64 = GROUND + 40.0;
const LOAD: f64 = 60.0;
const START_CYCLES: u8 = 17;

/// A walking robot's program.
pub(crate) struct Walk {
    state: State,
    /// Return address of the swing or the sway.
    back: State,
    /// Cycles that are left of the start.
    start: u8,
    /// The leg that swings, from 0.
    leg: usize,
    feet: [[f64; 3]; 4],
    shift: [f64; 3],
}

#[derive(Clone, Copy)]
enum State {
    Start,
    Loop,
    RearLeft,
    FrontLeft,
    ShiftX,
    ShiftY,
    ShiftZ,
    SwayRight,
    RearRight,
    FrontRight,
    ShiftBack,
    SwayLeft,
    Again,
    Swing,
    Lift,
    Lifted,
    Advance,
    Forward,
    Ahead,
    Lower,
    Lowered,
    Load,
    SwingEnd,
    Sway,
    SweepF1,
    SweepF2,
    SweepF3,
    SweepF4,
    Hold,
    MoveF1,
    MoveF2,
    MoveF3,
    MoveF4,
    Release,
    Arrived,
    Settle,
    SwayEnd,
}

impl Walk {
    pub(crate) fn new() -> Self {
        Walk {
            state: State::Start,
            back: State::Loop,
            start: START_CYCLES,
            leg: 0,
            feet: [
                [-431.0, 201.0 - HALF, GROUND],
                [351.0, 201.0, GROUND],
                [-431.0, -201.0 - HALF, GROUND],
                [351.0, -201.0, GROUND],
            ],
            shift: [0.0; 3],
        }
    }

    #[inline]
    pub(crate) fn step(&mut self, cx: &mut dyn Context) -> Result<Flow, Fault> {
        let (poll, next) = match self.state {
            State::Start => {
                self.start -= 1;
                let next = if self.start == 0 {
                    State::Loop
                } else {
                    State::Start
                };
                (Poll::Done, next)
            }
            State::Loop => (Poll::Done, State::RearLeft),
            State::RearLeft => self.swing(2, State::FrontLeft),
            State::FrontLeft => self.swing(0, State::ShiftX),
            State::ShiftX => {
                self.shift[0] = TWICE;
                (Poll::Done, State::ShiftY)
            }
            State::ShiftY => {
                self.shift[1] = -HALF;
                (Poll::Done, State::ShiftZ)
            }
            State::ShiftZ => {
                self.shift[2] = 0.0;
                (Poll::Done, State::SwayRight)
            }
            State::SwayRight => self.sway(State::RearRight),
            State::RearRight => self.swing(3, State::FrontRight),
            State::FrontRight => self.swing(1, State::ShiftBack),
            State::ShiftBack => {
                self.shift[0] = -TWICE;
                (Poll::Done, State::SwayLeft)
            }
            State::SwayLeft => self.sway(State::Again),
            State::Again => (Poll::Done, State::Loop),

            State::Swing => (Poll::Done, State::Lift),
            State::Lift => (self.foot_at_the_top(cx)?, State::Lifted),
            State::Lifted => (self.wait(cx, Op::WaitNear)?, State::Advance),
            State::Advance => {
                let y = &mut self.feet[self.leg][1];
                *y = finite(*y + STRIDE)?;
                (Poll::Done, State::Forward)
            }
            State::Forward => (self.foot_at_the_top(cx)?, State::Ahead),
            State::Ahead => (self.wait(cx, Op::WaitInpos)?, State::Lower),
            State::Lower => (self.foot_in_place(cx, self.leg)?, State::Lowered),
            State::Lowered => (self.wait(cx, Op::WaitInpos)?, State::Load),
            State::Load => (ask(cx, Op::Sleep, Target::None, [LOAD])?, State::SwingEnd),
            State::SwingEnd => (Poll::Done, self.back),

            State::Sway => (Poll::Done, State::SweepF1),
            State::SweepF1 => (self.sweep(0)?, State::SweepF2),
            State::SweepF2 => (self.sweep(1)?, State::SweepF3),
            State::SweepF3 => (self.sweep(2)?, State::SweepF4),
            State::SweepF4 => (self.sweep(3)?, State::Hold),
            State::Hold => (ask(cx, Op::AllStop, Target::None, [])?, State::MoveF1),
            State::MoveF1 => (self.foot_in_place(cx, 0)?, State::MoveF2),
            State::MoveF2 => (self.foot_in_place(cx, 1)?, State::MoveF3),
            State::MoveF3 => (self.foot_in_place(cx, 2)?, State::MoveF4),
            State::MoveF4 => (self.foot_in_place(cx, 3)?, State::Release),
            State::Release => (
                ask(cx, Op::AllStopRelease, Target::None, [])?,
                State::Arrived,
            ),
            State::Arrived => (ask(cx, Op::WaitInpos, Target::All, [])?, State::Settle),
            State::Settle => (ask(cx, Op::Sleep, Target::None, [LOAD])?, State::SwayEnd),
            State::SwayEnd => (Poll::Done, self.back),
        };
        match poll {
            Poll::Done => {
                self.state = next;
                Ok(Flow::Next)
            }
            Poll::Pending => Ok(Flow::Wait),
        }
    }

    fn swing(&mut self, leg: usize, back: State) -> (Poll, State) {
        self.leg = leg;
        self.back = back;
        (Poll::Done, State::Swing)
    }

    fn sway(&mut self, back: State) -> (Poll, State) {
        self.back = back;
        (Poll::Done, State::Sway)
    }

    fn foot_at_the_top(&self, cx: &mut dyn Context) -> Result<Poll, Fault> {
        let [x, y, _] = self.feet[self.leg];
        ask(cx, Op::Ptp, self.foot(self.leg), [x, y, TOP])
    }

    fn foot_in_place(&self, cx: &mut dyn Context, leg: usize) -> Result<Poll, Fault> {
        ask(cx, Op::Ptp, self.foot(leg), self.feet[leg])
    }

    fn wait(&self, cx: &mut dyn Context, op: Op) -> Result<Poll, Fault> {
        ask(cx, op, self.foot(self.leg), [])
    }

    fn foot(&self, leg: usize) -> Target {
        Target::Foot(leg as u8 + 1)
    }

    fn sweep(&mut self, leg: usize) -> Result<Poll, Fault> {
        let ([x, y, z], [by_x, by_y, by_z]) = (self.feet[leg], self.shift);
        self.feet[leg] = [finite(x + by_x)?, finite(y + by_y)?, finite(z + by_z)?];
        Ok(Poll::Done)
    }
}
