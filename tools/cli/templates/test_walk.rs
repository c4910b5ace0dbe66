//! Properties of the motion that must stay when it is tuned.

use <<crate>>::<<items>>;

use tip_sim::{Limit, Robot, Run};

#[test]
fn it_walks_and_does_not_fall() {
    let robot = <<simulated>>;
    let mut run = Run::new(<<Program>>::new(), robot).unwrap();
    run.to_end(Limit::cycles(20_000));
    assert_eq!(run.emergency(), None);
    let motion = run.motion().unwrap();
    assert!(motion.travel.y > <<travel>>, "{motion:?}");
    assert_eq!(motion.falls, 0);
}
