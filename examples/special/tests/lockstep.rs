//! What `tipc verify` does, with the commands of the robot's owner: both engines side by side until all of the dance was reached.

use special::native::Native;
use special::{Dance, SOURCE};
use tip_runtime::model::titan8;
use tip_runtime::plant::SimulatedPlant;
use tip_runtime::program::End;
use tip_runtime::record::Ending;
use tipc::lockstep::{Reach, Rig};

#[test]
fn both_engines_dance_alike_whether_all_feet_carry_or_not() {
    let loaded = tipc::load("dance.prg", SOURCE.as_bytes(), &tipc::Options::default());
    let rig = Rig {
        program: loaded.program.expect("it loads"),
        compiled: Dance::new(),
        model: &titan8::MODEL,
        plant: SimulatedPlant::new(&titan8::MODEL),
        special: Native::default(),
    };
    let mut reach = Reach::new(&rig.program);
    for inputs in ["", "--sensor PAW2=0@0"] {
        let inputs = inputs.parse().expect("inputs");
        let run = rig.run(&inputs, &mut reach).expect("TITAN VIII");
        assert_eq!(run.divergence, None);
        assert_eq!(run.ending, Some(Ending::Program(End::End)));
    }
    let spots = reach.spots().all();
    let missed: Vec<_> = (0..)
        .zip(spots)
        .filter(|(spot, _)| !reach.has(*spot))
        .collect();
    assert_eq!(missed, []);
}
