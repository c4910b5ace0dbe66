//! A workshop without a robot: simulated servos that are where a robot at rest would hold them.

use crate::bus::ServoBus;
use crate::description::{Description, JOINTS, LEGS};
use crate::link::MemoryLink;
use crate::servo::Servo;
use tip_runtime::model::Model;

/// The described robot in its initial posture, on an in-memory wire.
pub fn bench(description: &Description, model: &Model<LEGS, JOINTS>) -> ServoBus<MemoryLink> {
    let mut servos = Vec::new();
    for (leg, joints) in model.legs.iter().zip(&description.joints) {
        for (angle, joint) in leg.initial.iter().zip(joints) {
            servos.push(Servo::new(
                joint.servo,
                description.servos.counts(joint, *angle),
            ));
        }
    }
    let link = MemoryLink::new(servos, model.standards.period);
    ServoBus::new(description.clone(), link)
}
