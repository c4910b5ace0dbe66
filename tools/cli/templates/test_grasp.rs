//! Properties of the motion that must stay when it is tuned.

use <<crate>>::{<<Program>>, SCENE};

use tip_sim::{Limit, Robot, Run};

#[test]
fn it_lifts_the_cylinder() {
    let robot = <<simulated>>.with_scene(&SCENE).unwrap();
    let mut run = Run::new(<<Program>>::new(), robot).unwrap();
    run.to_end(Limit::cycles(20_000));
    assert_eq!(run.emergency(), None);
    let grasp = run.grasp().unwrap();
    assert!(grasp.objects[0].clearance > 30.0, "{grasp:?}");
}
