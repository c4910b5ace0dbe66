//! The servo bus as hardware of the control loop: the one trait that a robot must bring.

use crate::description::{Description, JOINTS, JointDescription, LEGS};
use crate::link::Link;
use crate::protocol::{BROADCAST, Frame, Instruction};
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, HardwareFault, JointCommand, Outputs, Sensors};

/// A robot of position servos on one bus.
#[derive(Clone, Debug)]
pub struct ServoBus<L> {
    description: Description,
    link: L,
}

impl<L: Link> ServoBus<L> {
    /// The robot of this description at the end of this link.
    pub fn new(description: Description, link: L) -> Self {
        ServoBus { description, link }
    }

    /// The link.
    pub fn link(&self) -> &L {
        &self.link
    }

    /// The link, to be changed.
    pub fn link_mut(&mut self) -> &mut L {
        &mut self.link
    }

    fn send(
        &mut self,
        servo: u8,
        instruction: Instruction,
        value: i16,
    ) -> Result<(), HardwareFault> {
        let frame = Frame {
            servo,
            instruction,
            value,
        };
        let sent = self.link.send(frame.encode());
        sent.then_some(()).ok_or(HardwareFault("servo bus: dead"))
    }

    fn ask(&mut self, servo: u8) -> Result<i16, HardwareFault> {
        self.send(servo, Instruction::Ask, 0)?;
        let bytes = self
            .link
            .receive()
            .ok_or(HardwareFault("servo bus: no answer"))?;
        let frame = Frame::decode(bytes).ok_or(HardwareFault("servo bus: damaged answer"))?;
        let expected = frame.servo == servo && frame.instruction == Instruction::Position;
        expected
            .then_some(frame.value)
            .ok_or(HardwareFault("servo bus: wrong answer"))
    }

    fn measure(&mut self, leg: usize, joint: usize) -> Result<f64, HardwareFault> {
        let servo = self.description.joints[leg][joint].servo;
        let counts = f64::from(self.ask(servo)?);
        Ok(self
            .description
            .servos
            .angle(&self.description.joints[leg][joint], counts))
    }

    fn aim(
        &mut self,
        leg: usize,
        joint: usize,
        command: JointCommand,
    ) -> Result<(), HardwareFault> {
        let JointCommand::Angle { angle, .. } = command else {
            return Err(HardwareFault("servo bus: position servos give no torque"));
        };
        let own: &JointDescription = &self.description.joints[leg][joint];
        let counts = self.description.servos.counts(own, angle).round() as i16;
        self.send(own.servo, Instruction::Target, counts)
    }
}

impl<L: Link> Hardware<LEGS, JOINTS> for ServoBus<L> {
    fn read(&mut self, into: &mut Sensors<LEGS, JOINTS>) -> Result<(), HardwareFault> {
        for leg in 0..LEGS {
            for joint in 0..JOINTS {
                into.angles[leg][joint] = self.measure(leg, joint)?;
            }
        }
        Ok(())
    }

    fn write(&mut self, outputs: &Outputs<LEGS, JOINTS>) -> Result<(), HardwareFault> {
        for (leg, commands) in outputs.joints.iter().enumerate() {
            for (joint, command) in commands.iter().enumerate() {
                self.aim(leg, joint, *command)?;
            }
        }
        self.send(BROADCAST, Instruction::Go, 0)
    }

    fn stop(&mut self, _why: &Fault) {
        // The emergency is known already; a dead bus cannot make it worse.
        let _ = self.send(BROADCAST, Instruction::Stop, 0);
    }
}
