//! A controller on ideal fingers: joints hold their angles exactly, and turn with inertia and
//! viscous friction where they are commanded torques.

use tip_runtime::command::{Command, Op, Poll, Target, Teach, Value};
use tip_runtime::controller::Controller;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{JointCommand, Sensors};
use tip_runtime::kinematics::Chain;
use tip_runtime::model::hand;

pub(crate) const F1: Target = Target::Foot(1);
pub(crate) const J11: Target = Target::Joint(1, 1);
pub(crate) const J12: Target = Target::Joint(1, 2);
pub(crate) const J13: Target = Target::Joint(1, 3);

/// Inertia of each joint, kg·m².
const INERTIA: f64 = 1e-4;
/// Friction of each joint, N·m·s/rad.
const FRICTION: f64 = 0.01;
/// Stiffness of obstacles, N/mm.
const HARDNESS: f64 = 5.0;
const PIECES: usize = 5;

/// An obstacle of a fingertip.
#[derive(Clone, Copy)]
pub(crate) struct Wall {
    /// Direction from the wall to the free side.
    pub(crate) normal: [f64; 2],
    /// Position along the normal, mm.
    pub(crate) at: f64,
}

pub(crate) struct Hand {
    pub(crate) controller: Controller<3, 3>,
    pub(crate) sensors: Sensors<3, 3>,
    /// deg/s.
    rates: [[f64; 3]; 3],
    /// External force on each fingertip, N.
    pub(crate) pull: [[f64; 3]; 3],
    /// Rough obstacles: a fingertip sticks where it touches.
    pub(crate) walls: [Option<Wall>; 3],
    /// Position along its wall where each fingertip touched it, mm.
    touched: [Option<f64>; 3],
}

impl Hand {
    pub(crate) fn new() -> Self {
        let initial = hand::MODEL.legs.map(|finger| finger.initial);
        Hand {
            controller: Controller::new(&hand::MODEL),
            sensors: Sensors {
                angles: initial,
                slider: [0.0, -130.0, 0.0],
                ..Sensors::ZERO
            },
            rates: [[0.0; 3]; 3],
            pull: [[0.0; 3]; 3],
            walls: [None; 3],
            touched: [None; 3],
        }
    }

    pub(crate) fn command(
        &mut self,
        op: Op,
        target: Target,
        values: &[Value],
    ) -> Result<Poll, Fault> {
        self.controller.sense(&self.sensors)?;
        let poll = self.controller.command(&Command {
            op,
            hs: false,
            target,
            values,
        })?;
        self.advance();
        Ok(poll)
    }

    pub(crate) fn run(&mut self, op: Op, target: Target, values: &[f64]) -> Result<Poll, Fault> {
        let values: Vec<Value> = values.iter().copied().map(Value::Absolute).collect();
        self.command(op, target, &values)
    }

    /// Like `run`, with `R` before every operand.
    pub(crate) fn relative(&mut self, op: Op, target: Target, values: &[f64]) {
        let values: Vec<Value> = values.iter().copied().map(Value::Relative).collect();
        assert_eq!(self.command(op, target, &values), Ok(Poll::Done));
    }

    pub(crate) fn done(&mut self, op: Op, target: Target, values: &[f64]) {
        assert_eq!(self.run(op, target, values), Ok(Poll::Done));
    }

    pub(crate) fn fault(&mut self, op: Op, target: Target, values: &[f64]) -> Fault {
        self.run(op, target, values).expect_err("it must fail")
    }

    /// Returns the number of cycles until a command is done.
    pub(crate) fn cycles(&mut self, op: Op, target: Target, values: &[f64]) -> Option<usize> {
        (1..20_000).find(|_| self.run(op, target, values).expect("no fault") == Poll::Done)
    }

    pub(crate) fn idle(&mut self, cycles: usize) {
        for _ in 0..cycles {
            self.tick().expect("nothing goes wrong");
        }
    }

    pub(crate) fn tick(&mut self) -> Result<(), Fault> {
        self.controller.sense(&self.sensors)?;
        self.advance();
        Ok(())
    }

    pub(crate) fn teach(&self, what: Teach, target: Target) -> [f64; 3] {
        let members = self.controller.teach(what, target).expect("it is measured");
        [members[0], members[1], members[2]]
    }

    pub(crate) fn chain(&self, n: usize) -> Chain<3> {
        Chain::new(&hand::MODEL.legs[n - 1], &self.sensors.angles[n - 1])
    }

    pub(crate) fn tip(&self, n: usize) -> [f64; 3] {
        self.chain(n).foot()
    }

    /// Returns the commanded torques of finger `n`; `None` for a joint held by angle.
    pub(crate) fn commanded(&self, n: usize) -> [Option<f64>; 3] {
        self.controller.outputs()[n - 1].map(|command| match command {
            JointCommand::Angle { .. } => None,
            JointCommand::Torque(torque) => Some(torque),
        })
    }

    pub(crate) fn advance(&mut self) {
        self.controller.advance();
        self.sensors.slider = self.controller.slider();
        let seconds = self.controller.period() / 1000.0 / PIECES as f64;
        let outputs = self.controller.outputs();
        for _ in 0..PIECES {
            for (n, outputs) in outputs.iter().enumerate() {
                self.move_finger(n, outputs, seconds);
            }
        }
    }

    fn move_finger(&mut self, n: usize, outputs: &[JointCommand; 3], seconds: f64) {
        let chain = self.chain(n + 1);
        let mut force = self.pull[n];
        if let Some(Wall { normal, at }) = self.walls[n] {
            let [x, y, _] = chain.foot();
            let depth = at - (normal[0] * x + normal[1] * y);
            let along = normal[0] * y - normal[1] * x;
            if depth > 0.0 {
                let slip = along - *self.touched[n].get_or_insert(along);
                force[0] += HARDNESS * (depth * normal[0] + slip * normal[1]);
                force[1] += HARDNESS * (depth * normal[1] - slip * normal[0]);
            } else {
                self.touched[n] = None;
            }
        }
        let load = transposed(&chain, force);
        for m in 0..3 {
            match outputs[m] {
                JointCommand::Angle { angle, .. } => {
                    self.sensors.angles[n][m] = angle;
                    self.rates[n][m] = 0.0;
                    self.sensors.torques[n][m] = -load[m];
                }
                JointCommand::Torque(torque) => {
                    let rate = self.rates[n][m].to_radians();
                    let driving = (torque + load[m]) / 1000.0;
                    // Friction is taken at the end of the piece, which no stiffness upsets.
                    let rate =
                        (rate + driving / INERTIA * seconds) / (1.0 + FRICTION / INERTIA * seconds);
                    self.rates[n][m] = rate.to_degrees();
                    self.sensors.angles[n][m] += rate.to_degrees() * seconds;
                    self.sensors.torques[n][m] = torque;
                }
            }
        }
    }
}

/// Returns `Jᵀ F` in N·mm, from the places of the joints: the moment of the force about each.
pub(crate) fn transposed(chain: &Chain<3>, [fx, fy, _]: [f64; 3]) -> [f64; 3] {
    moments(chain, chain.foot(), [fx, fy])
}

/// Returns the moment of a force at `point` about each joint, positive where the joint's angle
/// grows, N·mm.
pub(crate) fn moments(chain: &Chain<3>, [px, py, _]: [f64; 3], [fx, fy]: [f64; 2]) -> [f64; 3] {
    let mut joints = chain.joints();
    let side = if chain.joint(0).expect("a joint")[0] < 0.0 {
        1.0
    } else {
        -1.0
    };
    core::array::from_fn(|_| {
        let [x, y, _] = joints.next().expect("three joints");
        side * ((px - x) * fy - (py - y) * fx)
    })
}

pub(crate) fn close(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{a} is not {b}");
}

pub(crate) fn all_close(a: [f64; 3], b: [f64; 3], tolerance: f64) {
    for (a, b) in a.iter().zip(b) {
        close(*a, b, tolerance);
    }
}
