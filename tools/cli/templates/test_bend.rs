//! Properties of the motion that must stay when it is tuned.

use <<crate>>::<<items>>;

use tip_sim::{Robot, Run};

#[test]
fn every_joint_moves_and_comes_back() {
    let robot = <<simulated>>;
    let mut run = Run::new(<<Program>>::new(), robot).unwrap();
    run.cycle();
    let before = run.angles().to_vec();
    let mut farthest = vec![0.0_f64; before.len()];
    while run.ending().is_none() && run.cycles() < 20_000 {
        run.cycle();
        for ((farthest, now), before) in farthest.iter_mut().zip(run.angles()).zip(&before) {
            *farthest = farthest.max((now - before).abs());
        }
    }
    assert_eq!(run.emergency(), None);
    assert!(farthest.iter().all(|turn| *turn > 1.0), "{farthest:?}");
    for (now, before) in run.angles().iter().zip(&before) {
        assert!((now - before).abs() < 5.0, "{now} after {before}");
    }
}
