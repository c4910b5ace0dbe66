//! Links and bodies with the model's inertia, compared with point masses.

use crate::dynamic::mass::{DIFFERENCE, Vector, rotation, rotors};
use crate::dynamic::rig::{GRAVITY, SMOOTH, all, go, loads, some};
use tip_runtime::hardware::{Hardware, JointCommand};
use tip_runtime::kinematics::frames;
use tip_runtime::model::{Body, InertialProperties, Joint, Leg, Model, Point, Range, titan8};
use tip_runtime::plant::dynamic::Twist;
use tip_runtime::plant::{DynamicPlant, SimulatedPlant};
use tip_runtime::random::Random;

/// Positions of four quarters of a mass, mm.
type Points = [Point; 4];

/// Returns the inertia of a link or body that has a quarter of its mass (kg) at each point.
const fn inertial(points: Points, mass: f64) -> InertialProperties {
    let mut centre = [0.0; 3];
    let mut at = 0;
    while at < 4 {
        let [x, y, z] = points[at];
        centre = [
            centre[0] + x / 4.0,
            centre[1] + y / 4.0,
            centre[2] + z / 4.0,
        ];
        at += 1;
    }
    let mut inertia = [0.0; 6];
    let mut at = 0;
    while at < 4 {
        let [x, y, z] = points[at];
        let [x, y, z] = [x - centre[0], y - centre[1], z - centre[2]];
        let part = mass / 4.0 * 1e-6;
        inertia = [
            inertia[0] + part * (y * y + z * z),
            inertia[1] + part * (x * x + z * z),
            inertia[2] + part * (x * x + y * y),
            inertia[3] - part * x * y,
            inertia[4] - part * x * z,
            inertia[5] - part * y * z,
        ];
        at += 1;
    }
    InertialProperties { centre, inertia }
}

const TRUNK: Points = [
    [60.0, 10.0, -20.0],
    [-50.0, 90.0, 5.0],
    [0.0, -70.0, 40.0],
    [20.0, 30.0, 60.0],
];
const LINK: Points = [
    [10.0, 0.0, -5.0],
    [-12.0, 25.0, -30.0],
    [4.0, -9.0, -70.0],
    [30.0, 8.0, -20.0],
];

/// Three legs of three slanted joints around a body, all of odd shapes, too far apart to meet.
const ODD: Model<3, 3> = Model {
    body: Some(Body {
        x: Range::new(-60.0, 60.0),
        y: Range::new(-90.0, 90.0),
        z: Range::new(-30.0, 60.0),
        mass: 2.0,
        inertial: Some(inertial(TRUNK, 2.0)),
    }),
    ..Model::generic(
        "odd",
        [leg(480.0, 10.0), leg(-480.0, 20.0), leg(5.0, -590.0)],
    )
};

const fn leg(x: f64, y: f64) -> Leg<3> {
    let joints = [
        Joint::revolute([0.0, 0.0, 1.0], [40.0, 5.0, -3.0]).mass(0.3),
        Joint::revolute([0.6, 0.8, 0.0], [10.0, 70.0, -20.0]).mass(0.2),
        Joint::revolute([0.0, 0.6, 0.8], [0.0, 15.0, -90.0]).mass(0.15),
    ];
    let [hip, thigh, shank] = joints;
    let joints = [
        hip.inertial(inertial(LINK, 0.3)),
        thigh.inertial(inertial(LINK, 0.2)),
        shank.inertial(inertial(LINK, 0.15)),
    ];
    Leg::at([x, y, 10.0], joints)
}

/// Returns each mass (kg) and its position in the world (m), after a motion of `time` s at constant
/// velocity.
fn masses(plant: &DynamicPlant<3, 3>, time: f64) -> Vec<(f64, Vector)> {
    let (pose, twist) = (plant.body(), plant.twist());
    let turn = Vector::from(twist.rate.map(f64::to_radians)) * time;
    let turned = nalgebra::Rotation3::from_scaled_axis(turn) * rotation(&pose);
    let at = (Vector::from(pose.position) + Vector::from(twist.velocity) * time) / 1000.0;
    let place = |point: Point| at + turned * Vector::from(point) / 1000.0;
    let mut masses = Vec::from(TRUNK.map(|point| (0.5, place(point))));
    let moving = plant.angles().into_iter().zip(plant.rates());
    for (leg, (mut angles, rates)) in ODD.legs.iter().zip(moving) {
        for (angle, rate) in angles.iter_mut().zip(rates) {
            *angle += rate * time;
        }
        for (frame, joint) in frames(leg.base, &leg.joints, &angles).zip(&leg.joints) {
            masses.extend(LINK.map(|point| (joint.mass / 4.0, place(frame.point(point)))));
        }
    }
    masses
}

/// Returns the robot thrown high up, turning, its joints released.
fn thrown(random: &mut Random) -> DynamicPlant<3, 3> {
    let plant = DynamicPlant::new(&ODD).with_drives(SMOOTH).lifted(5000.0);
    plant
        .with_twist(Twist {
            velocity: some(random, 800.0),
            rate: some(random, 300.0),
        })
        .with_rates([(); 3].map(|()| some(random, 300.0)))
}

fn let_go(plant: &mut DynamicPlant<3, 3>, period: f64) {
    let still = all([[JointCommand::Torque(0.0); 3]; 3], period);
    plant.write(&still).expect("it is simulated");
}

#[test]
fn a_robot_has_the_energy_and_the_centre_of_its_masses() {
    let mut random = Random::new(11);
    for _ in 0..20 {
        let mut plant = thrown(&mut random);
        let_go(&mut plant, 100.0);
        let (before, after) = (masses(&plant, -DIFFERENCE), masses(&plant, DIFFERENCE));
        let energies = before
            .iter()
            .zip(&after)
            .map(|((mass, before), (_, after))| {
                mass * ((after - before) / (2.0 * DIFFERENCE)).norm_squared() / 2.0
            });
        let points = energies.sum::<f64>() + rotors(&ODD, &plant);
        let matrix = plant.energy().kinetic;
        assert!(
            (matrix / points - 1.0).abs() < 1e-6,
            "{matrix} J, {points} J"
        );
        let now = masses(&plant, 0.0);
        let whole: f64 = now.iter().map(|(mass, _)| mass).sum();
        let centre: Vector = now.iter().map(|(mass, at)| at * *mass / whole).sum();
        let apart = Vector::from(plant.centre_of_mass()) - centre * 1000.0;
        assert!(apart.norm() < 1e-6, "{apart}");
    }
}

/// Returns the changes of energy (J), beyond what a method that falls g t (t + dt) / 2 loses, and
/// of momentum (N·m·s) after 0.2 s in steps of `step` ms.
fn changes(step: f64) -> [f64; 2] {
    let mut plant = thrown(&mut Random::new(5));
    let (energy, momentum) = (plant.energy(), plant.momentum());
    for _ in 0..(200.0 / step) as u32 {
        let_go(&mut plant, step);
    }
    let (end, turned) = (plant.energy(), plant.momentum());
    let method = 3.95 * GRAVITY * GRAVITY * 0.2 * step / 2000.0;
    let gained = end.kinetic + end.potential - energy.kinetic - energy.potential + method;
    let turned = Vector::from(turned.angular) - Vector::from(momentum.angular);
    [gained.abs(), turned.norm()]
}

#[test]
fn in_the_air_it_keeps_energy_and_momentum_the_better_the_shorter_the_step() {
    let thrown = thrown(&mut Random::new(5));
    let whole = [
        thrown.energy().kinetic,
        Vector::from(thrown.momentum().angular).norm(),
    ];
    let (coarse, fine) = (changes(0.5), changes(0.05));
    for ((coarse, fine), whole) in coarse.iter().zip(fine).zip(whole) {
        assert!(*coarse < 0.05 * whole, "{coarse} of {whole}");
        // A method of first order: a tenth of the step, a tenth of the error.
        assert!(fine < 0.15 * coarse, "{fine}, {coarse} of {whole}");
    }
}

/// Returns TITAN VIII with its uniform mass given explicitly.
fn even() -> Model<4, 3> {
    let mut model = titan8::MODEL;
    if let Some(body) = &mut model.body {
        body.inertial = Some(InertialProperties::block(
            [body.x, body.y, body.z],
            body.mass,
        ));
    }
    for joint in model.legs.iter_mut().flat_map(|leg| &mut leg.joints) {
        joint.inertial = Some(InertialProperties::rod(joint.link, joint.mass));
    }
    model
}

#[test]
fn what_is_spread_evenly_moves_as_what_says_nothing() {
    let (mut even, mut plain) = (
        DynamicPlant::new(&even()),
        DynamicPlant::new(&titan8::MODEL),
    );
    let up = [[10.0, -10.0, 80.0]; 4];
    go(&mut even, up);
    go(&mut plain, up);
    let pairs = even
        .angles()
        .into_iter()
        .flatten()
        .zip(plain.angles().into_iter().flatten());
    for (even, plain) in pairs {
        assert!((even - plain).abs() < 1e-6, "{even}, {plain}");
    }
    let (even, plain) = (even.body(), plain.body());
    for (even, plain) in even.position.into_iter().zip(plain.position) {
        assert!((even - plain).abs() < 1e-4, "{even}, {plain}");
    }
}

#[test]
fn a_body_that_is_heavier_in_front_loads_the_front_feet() {
    // 12 kg, 50 mm ahead of the middle; feet are 201 mm ahead of it and as far to its rear.
    let mut model = even();
    if let Some(inertial) = model.body.as_mut().and_then(|body| body.inertial.as_mut()) {
        inertial.centre = [0.0, 50.0, 0.0];
    }
    let expected = 12.0 * GRAVITY * 50.0 / 201.0;
    let more = |feet: [f64; 4]| feet[0] + feet[1] - feet[2] - feet[3];
    let up = [[0.0, -10.0, 80.0]; 4];
    let mut plant = DynamicPlant::new(&model);
    go(&mut plant, up);
    let heavy = more(plant.feet().map(|foot| foot.load));
    assert!((heavy / expected - 1.0).abs() < 0.01, "{heavy}, {expected}");
    assert!((loads(&plant) / (20.0 * GRAVITY) - 1.0).abs() < 1e-3);
    let mut plant = SimulatedPlant::new(&model);
    for _ in 0..200 {
        let still = all(up.map(|leg| leg.map(JointCommand::at)), 20.0);
        plant.write(&still).expect("it is simulated");
    }
    let heavy = more(plant.feet().map(|foot| foot.load));
    assert!((heavy / expected - 1.0).abs() < 0.01, "{heavy}, {expected}");
}
