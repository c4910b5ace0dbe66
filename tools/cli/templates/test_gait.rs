//! Properties of the gait that hold however it is tuned.

use <<crate>>::<<items>>;

use tip_sim::{Limit, Plant, Robot, Run};

#[test]
fn it_walks_as_the_stick_says_and_does_not_fall() {
    let robot = <<simulated>>.with_plant(Plant::Dynamic);
    let run = Run::new(<<Program>>::new(), robot).unwrap();
    // The stick is ahead for 1000 cycles.
    let sticks = "0:VR1=5, 0:VR2=5, 0:VR3=5, 400:VR1=10, 1400:VR1=5, 1600:halt";
    let mut run = run.events(sticks).unwrap();
    run.to_end(Limit::cycles(20_000));
    assert_eq!(run.emergency(), None);
    assert!(run.ending().is_some(), "it sits down");
    let motion = run.motion().unwrap();
    assert!(motion.travel.y > <<travel>>, "{motion:?}");
    assert_eq!(motion.falls, 0);
}
