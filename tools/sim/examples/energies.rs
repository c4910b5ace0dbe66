//! Throws TITAN VIII with mass through the air, its joints driven here and there, and writes how it is placed, how it
//! moves, and what energy and momentum it has for that, a line for each of 100 states: x, y, z (mm), roll, pitch, yaw
//! (deg), velocity (mm/s), turn (deg/s), angles (deg), their rates (deg/s), kinetic and potential energy (J), linear
//! (N·s) and angular momentum about the centre of mass (N·m·s).

use tip_runtime::hardware::{Hardware, HardwareFault, JointCommand, Outputs};
use tip_runtime::model::titan8;
use tip_runtime::plant::DynamicPlant;
use tip_runtime::plant::dynamic::Twist;
use tip_runtime::random::Random;

fn main() -> Result<(), HardwareFault> {
    let mut random = Random::new(1);
    let mut number = |most: f64| (random.below(2001) as f64 / 1000.0 - 1.0) * most;
    for _ in 0..100 {
        let mut plant = DynamicPlant::new(&titan8::MODEL)
            .lifted(3000.0)
            .with_twist(Twist {
                velocity: [(); 3].map(|()| number(500.0)),
                rate: [(); 3].map(|()| number(200.0)),
            });
        let angles = titan8::MODEL.legs.map(|leg| {
            leg.initial
                .map(|angle| JointCommand::at(angle + number(40.0)))
        });
        for _ in 0..20 {
            plant.write(&Outputs {
                joints: angles,
                slider: [0.0; 3],
                lamps: [0; 8],
                period: 20.0,
            })?;
        }
        let plant = plant.with_rates([(); 4].map(|()| [(); 3].map(|()| number(300.0))));
        let (pose, twist) = (plant.body(), plant.twist());
        let (energy, momentum) = (plant.energy(), plant.momentum());
        let numbers = pose
            .position
            .into_iter()
            .chain([pose.roll, pose.pitch, pose.yaw])
            .chain(twist.velocity)
            .chain(twist.rate)
            .chain(plant.angles().into_iter().flatten())
            .chain(plant.rates().into_iter().flatten())
            .chain([energy.kinetic, energy.potential])
            .chain(momentum.linear)
            .chain(momentum.angular);
        let line: Vec<String> = numbers.map(|number| number.to_string()).collect();
        println!("{}", line.join(","));
    }
    Ok(())
}
