//! The master's tables against those of the simulated servos, which are written from the makers' manuals: what a joint is
//! commanded is what its servo does, and what a servo measures is what the master reads.

use crate::drives::{Robot, START, bus_of, cycle, held_with, joint, timing};
use tip_drives::drives::{Drives, Joint, Settings};
use tip_drives::model::{MODELS, Model};
use tip_drives::simulated::{Servo, SimulatedBus};
use tip_runtime::model::Range;

fn held(joints: &[Joint], at: f64) -> Robot {
    let servos = joints.iter().map(|joint| {
        let mut servo = Servo::of(joint.model.name, joint.id, 0.0);
        // By hand, in degrees of the maker's scale: the master's scale is not asked.
        servo.place(joint.sign * at);
        servo
    });
    let bus = SimulatedBus::new(servos.collect(), timing(joints[0].model));
    let settings = Settings {
        voltage: Range::new(1.0, 60.0),
        ..Settings::default()
    };
    let drives = Drives::new(bus_of(bus, joints[0].model), joints, settings);
    held_with(drives.expect("not too many"))
}

/// Half of the torque, where it can be limited.
fn torque_of(model: &Model) -> f64 {
    if model.family.limits_torque() {
        0.5
    } else {
        1.0
    }
}

fn joints(model: &'static Model) -> Vec<Joint> {
    [1, 2]
        .map(|id| Joint {
            speed: 60.0,
            torque: torque_of(model),
            ..joint(id, model)
        })
        .to_vec()
}

#[test]
fn a_joint_is_where_its_servo_is() {
    for model in MODELS {
        let joints = joints(model);
        let mut drives = held(&joints, 10.0);
        // The makers' resolutions: 0.29, 0.24 and 0.088 deg.
        for (number, to) in [(0, 10.0), (150, 70.0), (300, -80.0)] {
            for number in START + number..START + number + 150 {
                cycle(&mut drives, number, to).expect(model.name);
            }
            for (joint, servo) in joints.iter().zip(drives.bus().port().bus.servos()) {
                let off = (servo.angle() * joint.sign - to).abs();
                assert!(
                    off < 0.3,
                    "{}: {} deg instead of {to}",
                    model.name,
                    servo.angle()
                );
            }
            for number in 0..joints.len() {
                let angle = drives.angle(number).expect("measured");
                assert!(
                    (angle - to).abs() < 0.3,
                    "{}: {angle} instead of {to}",
                    model.name
                );
            }
        }
    }
}

#[test]
fn speed_torque_supply_and_temperature_are_those_of_the_servo() {
    for model in MODELS {
        let mut drives = held(&joints(model), 0.0);
        for number in START..START + 50 {
            cycle(&mut drives, number, 20.0).expect(model.name);
        }
        let measured = drives.measured(0).expect("measured");
        let servo = drives.bus().port().bus.servos()[0].clone();
        let name = model.name;
        assert!(servo.has_torque(), "{name}");
        // As much as the unit of speeds rounds, and more. An LX has the time of each move instead.
        let (has_speed, has_torque) = (model.speed_unit.is_some(), model.full_torque.is_some());
        let limit = servo.speed_limit();
        assert!(
            !has_speed || (60.0..65.0).contains(&limit),
            "{name}: {limit} deg/s"
        );
        let torque = servo.torque_limit();
        let expected = if has_torque { 0.5 } else { 1.0 };
        assert!((torque - expected).abs() < 0.002, "{name}: {torque}");
        let temperature = measured.temperature.expect(name);
        assert!(
            (temperature - servo.temperature()).abs() <= 1.0,
            "{name}: {temperature} °C"
        );
        let voltage = measured.voltage.expect(name);
        assert!(
            (voltage - servo.voltage()).abs() < 0.11,
            "{name}: {voltage} V"
        );
        // Nothing loads it but its own motion.
        assert!(
            measured.load.is_none_or(|it| it.abs() < 0.5),
            "{name}: {:?}",
            measured.load
        );
        drives.bus_mut().port_mut().bus.block(1);
        for number in START + 50..START + 60 {
            cycle(&mut drives, number, 20.0).expect(name);
        }
        let load = drives.measured(0).expect("measured").load;
        assert!(
            load.is_none_or(|it| (0.95..1.05).contains(&it)),
            "{name}: {load:?}"
        );
        assert_eq!(load.is_none(), model.family.key() == "lx", "{name}");
    }
}

#[test]
fn the_delay_of_answers_is_that_of_the_servo() {
    // AX-12A: address 5, XL430: 9, STS3215: 7; 2 µs each.
    for (name, address) in [("AX-12", 5), ("XL430-W250", 9), ("STS3215", 7)] {
        let model = Model::named(name).expect("a model");
        let middle = model.counts(0.0);
        let servo = Servo::of(name, 1, middle).with(address, 90);
        let bus = bus_of(SimulatedBus::new(vec![servo], timing(model)), model);
        let drives = Drives::new(bus, &[joint(1, model)], Settings::default());
        let mut drives = drives.expect("one");
        drives.connect().expect("it is there");
        assert_eq!(drives.bus().timing().return_delay, 180, "{name}");
    }
}
