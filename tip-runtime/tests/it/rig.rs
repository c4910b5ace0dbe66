//! A controller on ideal servos: every joint is measured at its command.

use tip_runtime::command::{Command, Op, Poll, Port, Target, Value};
use tip_runtime::controller::Controller;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{JointCommand, Sensors};
use tip_runtime::kinematics::Chain;
use tip_runtime::model::{Model, generic, titan8};

pub(crate) struct Rig {
    pub(crate) model: &'static Model<4, 3>,
    pub(crate) controller: Controller<4, 3>,
    /// The next readings of the sensors, except the angles of joints that follow their commands.
    pub(crate) sensors: Sensors<4, 3>,
    /// Joints that stand still whatever they are commanded, where the sensors say.
    pub(crate) stuck: [[bool; 3]; 4],
}

impl Rig {
    pub(crate) fn titan() -> Self {
        Self::new(&titan8::MODEL)
    }

    pub(crate) fn generic() -> Self {
        Self::new(&generic::MODEL)
    }

    pub(crate) fn new(model: &'static Model<4, 3>) -> Self {
        Rig {
            model,
            controller: Controller::new(model),
            sensors: Sensors::ZERO,
            stuck: [[false; 3]; 4],
        }
    }

    /// Returns the commanded joint angles, deg.
    pub(crate) fn commanded(&self) -> [[f64; 3]; 4] {
        self.controller
            .outputs()
            .map(|leg| leg.map(JointCommand::value))
    }

    /// Returns the commanded position of foot `n`, mm.
    pub(crate) fn foot(&self, n: usize) -> [f64; 3] {
        Chain::new(&self.model.legs[n - 1], &self.commanded()[n - 1]).foot()
    }

    /// Sets the reading of the sole of foot `n` from now on, V.
    pub(crate) fn sole(&mut self, n: usize, volts: f64) {
        assert!(self.sensors.inputs.set(Port::Paw(n as u8), volts));
    }

    /// Reads the sensors: phase 1.
    pub(crate) fn sense(&mut self) -> Result<(), Fault> {
        for (leg, commands) in self.controller.outputs().iter().enumerate() {
            for (joint, command) in commands.iter().enumerate() {
                // A torque moves nothing here.
                if let (JointCommand::Angle { angle, .. }, false) =
                    (command, self.stuck[leg][joint])
                {
                    self.sensors.angles[leg][joint] = *angle;
                }
            }
        }
        self.controller.sense(&self.sensors)
    }

    /// Runs a cycle with a command.
    pub(crate) fn run(&mut self, op: Op, target: Target, values: &[Value]) -> Result<Poll, Fault> {
        self.run_with(&Command {
            op,
            hs: false,
            target,
            values,
        })
    }

    /// Runs a cycle with a command.
    pub(crate) fn run_with(&mut self, command: &Command<'_>) -> Result<Poll, Fault> {
        self.sense()?;
        let poll = self.controller.command(command)?;
        self.controller.advance();
        Ok(poll)
    }

    /// Runs a cycle with a command that must be done immediately.
    pub(crate) fn done(&mut self, op: Op, target: Target, values: &[f64]) {
        assert_eq!(self.run(op, target, &absolute(values)), Ok(Poll::Done));
    }

    /// Runs a cycle with a command that must be done immediately, at high speed.
    pub(crate) fn done_hs(&mut self, op: Op, target: Target, values: &[f64]) {
        let poll = self.run_with(&Command {
            op,
            hs: true,
            target,
            values: &absolute(values),
        });
        assert_eq!(poll, Ok(Poll::Done));
    }

    /// Returns the fault of a command in a cycle that begins well.
    pub(crate) fn fault(&mut self, op: Op, target: Target, values: &[f64]) -> Fault {
        self.sense().expect("sensors read well");
        let fault = self
            .controller
            .command(&Command {
                op,
                hs: false,
                target,
                values: &absolute(values),
            })
            .expect_err("the command must fail");
        self.controller.advance();
        fault
    }

    /// Runs cycles without a command.
    pub(crate) fn idle(&mut self, cycles: usize) {
        for _ in 0..cycles {
            self.tick().expect("nothing goes wrong");
        }
    }

    /// Runs a cycle without a command.
    pub(crate) fn tick(&mut self) -> Result<(), Fault> {
        self.sense()?;
        self.controller.advance();
        Ok(())
    }

    /// Returns the number of cycles until a command is done.
    pub(crate) fn cycles(&mut self, op: Op, target: Target, values: &[f64]) -> usize {
        let values = absolute(values);
        for cycle in 1..100_000 {
            if self.run(op, target, &values).expect("no fault") == Poll::Done {
                return cycle;
            }
        }
        panic!("{} is never done", op.name());
    }
}

pub(crate) fn absolute(values: &[f64]) -> Vec<Value> {
    values.iter().copied().map(Value::Absolute).collect()
}

pub(crate) fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    libm::sqrt(squares.sum())
}
