//! DETECT_FLOOR 2 from many postures, over floors that the fingertips can reach.

use crate::hand_plant::rig::Rig;
use tip_runtime::command::{Command, Op, Poll, Target, Value};
use tip_runtime::kinematics::Chain;
use tip_runtime::model::hand;
use tip_runtime::plant::{Scene, SimulatedHand};
use tip_runtime::random::Random;

/// Number of postures of the three fingers together.
const POSTURES: usize = 40;

/// Maximum number of cycles of a search: 4 s.
const CYCLES: usize = 2000;

/// Travel of the slider, which carries the floor, mm.
const TRAVEL: (f64, f64) = (-200.0, -60.0);

/// Returns the heights of a finger's third joint and fingertip at these angles, from the palm down,
/// mm.
fn depths([first, second, third]: [f64; 3]) -> [f64; 2] {
    let mut directions = [first, first + second, first + second + third].into_iter();
    let mut down = |length: f64| length * directions.next().expect("a link").to_radians().cos();
    let knuckle = down(70.0) + down(50.0);
    [knuckle, knuckle + down(40.0)]
}

/// Returns the greatest depth of a fingertip while joint 3 stays, mm. No other part is as deep
/// there.
fn deepest(third: f64) -> f64 {
    let postures = (-90..=90).flat_map(|first| (-10..=110).map(move |second| (first, second)));
    let depths = postures.map(|(first, second)| depths([first.into(), second.into(), third]));
    let tips = depths.filter(|[knuckle, tip]| knuckle < tip);
    tips.fold(0.0, |deepest: f64, [_, tip]| deepest.max(tip))
}

/// Returns postures of three fingers, and the height of a floor between them and the greatest depth
/// that all reach.
fn drawn(random: &mut Random) -> Option<([[f64; 3]; 3], f64)> {
    let postures = [(); 3].map(|()| {
        [(-90.0, 90.0), (-10.0, 110.0), (-10.0, 110.0)].map(|(min, max)| random.within(min, max))
    });
    let reached = postures.map(|[.., third]| deepest(third));
    let high = postures.iter().flat_map(|posture| depths(*posture));
    let high = TRAVEL.1.min(-high.fold(0.0, f64::max)) - 2.0;
    let low = TRAVEL.0.max(-reached.into_iter().fold(1000.0, f64::min)) + 1.0;
    (low < high).then(|| (postures, random.within(low, high)))
}

/// Returns the final heights of the fingertips on a floor; `None` if the search does not end.
fn searched(postures: &[[f64; 3]; 3], floor: f64, friction: f64) -> Option<[f64; 3]> {
    let mut model = hand::MODEL;
    for (leg, posture) in model.legs.iter_mut().zip(postures) {
        leg.initial = *posture;
    }
    model.slider.as_mut().expect("the hand has one").initial[1] = floor;
    let model = Box::leak(Box::new(model));
    let scene = Scene {
        friction,
        ..Scene::EMPTY
    };
    let mut rig = Rig::with(model, SimulatedHand::new(model).with_scene(&scene));
    let values = [Value::Absolute(2.0)];
    let search = Command {
        op: Op::DetectFloor,
        hs: false,
        target: Target::All,
        values: &values,
    };
    let mut cycles = 0..CYCLES;
    cycles.find(|_| rig.cycle(Some(&search)) == Ok(Poll::Done))?;
    let angles = rig.sensors().angles;
    let mut ends = angles.iter().zip(&hand::MODEL.legs);
    Some([(); 3].map(|()| {
        let (angles, leg) = ends.next().expect("three fingers");
        let chain = Chain::new(leg, angles);
        let heights = chain.joints().map(|[_, y, _]| y);
        // A knuckle that touches has found the floor, too.
        heights.fold(chain.foot()[1], f64::min)
    }))
}

// clauses: 7.45
#[test]
fn fingers_find_every_floor_that_they_reach() {
    let mut random = Random::new(0x9E37_79B9_7F4A_7C15);
    let mut missed = Vec::new();
    let mut tried = 0;
    while tried < POSTURES {
        let Some((postures, floor)) = drawn(&mut random) else {
            continue;
        };
        tried += 1;
        // Rough or slippery: what pushes straight down does not slide.
        for friction in [0.5, 0.02] {
            let ends = searched(&postures, floor, friction);
            let found = ends.is_some_and(|ends| ends.iter().all(|end| (end - floor).abs() < 1.5));
            if !found {
                missed.push((postures, floor, friction, ends));
            }
        }
    }
    assert!(
        missed.is_empty(),
        "{} of {}: {missed:#?}",
        missed.len(),
        2 * tried
    );
}
