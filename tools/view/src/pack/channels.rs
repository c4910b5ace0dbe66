//! What of a frame is kept as numbers, each under a name.

use crate::recording::Frame;

/// A number of each frame.
pub(crate) struct Channel {
    pub(crate) name: String,
    pub(crate) value: Value,
}

/// What it is in a frame, if it is there.
pub(crate) type Value = Box<dyn Fn(&Frame) -> Option<f64>>;

/// Those that a frame has.
pub(crate) fn channels(first: &Frame) -> Vec<Channel> {
    let mut channels = all(first);
    channels.retain(|channel| (channel.value)(first).is_some());
    channels
}

fn all(first: &Frame) -> Vec<Channel> {
    let mut all = Vec::new();
    for axis in 0..6 {
        all.push(channel(format!("pose.{axis}"), move |frame| {
            let pose = frame.pose?;
            let [x, y, z] = pose.position;
            Some([x, y, z, pose.roll, pose.pitch, pose.yaw][axis])
        }));
    }
    all.push(channel("margin".to_owned(), |frame| frame.margin));
    for (leg, angles) in first.angles.iter().enumerate() {
        for joint in 0..angles.len() {
            let of = move |all: &[Vec<f64>]| all.get(leg)?.get(joint).copied();
            let (angle, torque) = (
                format!("angle.{leg}.{joint}"),
                format!("torque.{leg}.{joint}"),
            );
            all.push(channel(angle, move |frame| of(&frame.angles)));
            all.push(channel(torque, move |frame| of(&frame.torques)));
        }
        all.push(channel(format!("load.{leg}"), move |frame| {
            frame.loads.get(leg).copied()
        }));
        for axis in 0..3 {
            let (force, push) = (format!("force.{leg}.{axis}"), format!("push.{leg}.{axis}"));
            all.push(channel(force, move |frame| {
                frame.forces.get(leg).map(|force| force[axis])
            }));
            all.push(channel(push, move |frame| {
                frame.pushes.get(leg).map(|push| push[axis])
            }));
        }
    }
    for axis in 0..3 {
        all.push(channel(format!("slider.{axis}"), move |frame| {
            Some(frame.slider?[axis])
        }));
    }
    for thing in 0..first.objects.len() {
        for axis in 0..3 {
            all.push(channel(format!("thing.{thing}.{axis}"), move |frame| {
                let thing = frame.objects.get(thing)?;
                let [x, y, _] = thing.position;
                Some([x, y, thing.angle][axis])
            }));
        }
    }
    all
}

fn channel(name: String, value: impl Fn(&Frame) -> Option<f64> + 'static) -> Channel {
    Channel {
        name,
        value: Box::new(value),
    }
}
