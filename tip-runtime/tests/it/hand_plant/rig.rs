//! A controller on the simulated hand.

use tip_runtime::command::{Command, Op, Poll, Target, Teach, Value};
use tip_runtime::controller::Controller;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, JointCommand, Outputs, Sensors};
use tip_runtime::model::{Model, hand};
use tip_runtime::plant::{ObjectState, Scene, SimulatedHand};

pub(crate) type Plant = SimulatedHand<3, 3>;

pub(crate) const F1: Target = Target::Foot(1);
pub(crate) const J11: Target = Target::Joint(1, 1);
pub(crate) const J13: Target = Target::Joint(1, 3);

/// Returns the hand alone, commanded joint by joint.
pub(crate) fn plant() -> Plant {
    SimulatedHand::new(&hand::MODEL)
}

/// Returns the hand alone, over a scene.
pub(crate) fn over(scene: &Scene) -> Plant {
    plant().with_scene(scene)
}

/// Returns the first object of the scene.
pub(crate) fn object(plant: &Plant) -> ObjectState {
    plant.objects()[0].expect("there is an object")
}

/// Returns one cycle of the model's sampling time.
pub(crate) fn outputs(joints: [[JointCommand; 3]; 3]) -> Outputs<3, 3> {
    Outputs {
        joints,
        slider: [0.0, -130.0, 0.0],
        lamps: [0; 8],
        period: hand::MODEL.standards.period,
    }
}

/// Returns commands that hold the initial angles.
pub(crate) fn held() -> [[JointCommand; 3]; 3] {
    hand::MODEL
        .legs
        .map(|leg| leg.initial.map(JointCommand::at))
}

/// Returns commands of zero torque.
pub(crate) fn limp() -> [[JointCommand; 3]; 3] {
    [[JointCommand::Torque(0.0); 3]; 3]
}

pub(crate) fn write(plant: &mut Plant, outputs: &Outputs<3, 3>, cycles: usize) {
    for _ in 0..cycles {
        plant.write(outputs).expect("a simulation does not fail");
    }
}

/// Returns the number of cycles in `seconds`.
pub(crate) fn cycles(seconds: f64) -> usize {
    (seconds * 1000.0 / hand::MODEL.standards.period).round() as usize
}

/// A controller on the hand.
pub(crate) struct Rig {
    pub(crate) controller: Controller<3, 3>,
    pub(crate) plant: Plant,
}

impl Rig {
    pub(crate) fn new() -> Self {
        Rig::on(plant())
    }

    pub(crate) fn on(plant: Plant) -> Self {
        Rig::with(&hand::MODEL, plant)
    }

    pub(crate) fn with(model: &'static Model<3, 3>, plant: Plant) -> Self {
        Rig {
            controller: Controller::new(model),
            plant,
        }
    }

    /// Runs a control cycle, with a command if there is one.
    pub(crate) fn cycle(&mut self, command: Option<&Command<'_>>) -> Result<Poll, Fault> {
        let sensors = self.sensors();
        self.controller.sense(&sensors)?;
        let poll = match command {
            Some(command) => self.controller.command(command)?,
            None => Poll::Done,
        };
        self.controller.advance();
        let outputs = Outputs {
            joints: self.controller.outputs(),
            slider: self.controller.slider(),
            lamps: [0; 8],
            period: self.controller.period(),
        };
        write(&mut self.plant, &outputs, 1);
        Ok(poll)
    }

    pub(crate) fn sensors(&mut self) -> Sensors<3, 3> {
        let mut sensors = Sensors::ZERO;
        self.plant.read(&mut sensors).expect("good sensors");
        sensors
    }

    /// Runs a command until it is done; returns the number of cycles.
    pub(crate) fn run(&mut self, op: Op, target: Target, values: &[f64]) -> usize {
        let values: Vec<Value> = values.iter().copied().map(Value::Absolute).collect();
        let command = Command {
            op,
            hs: false,
            target,
            values: &values,
        };
        let done = |poll| poll == Poll::Done;
        (1..20_000)
            .find(|_| done(self.cycle(Some(&command)).expect("no fault")))
            .expect("the command gets done")
    }

    pub(crate) fn idle(&mut self, seconds: f64) {
        for _ in 0..cycles(seconds) {
            self.cycle(None).expect("nothing goes wrong");
        }
    }

    pub(crate) fn teach(&mut self, what: Teach, target: Target) -> [f64; 3] {
        let sensors = self.sensors();
        self.controller.sense(&sensors).expect("good sensors");
        let members = self.controller.teach(what, target).expect("it is measured");
        [members[0], members[1], members[2]]
    }
}

pub(crate) fn close(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{a} is not {b}");
}
