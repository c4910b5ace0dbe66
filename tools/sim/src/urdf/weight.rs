//! What links weigh that move as one.

use super::pose::Pose;
use super::robot::Link;
use tip_runtime::model::{Point, Spread};

/// How many digits of a tensor are written.
const DIGITS: usize = 11;

/// The mass of all: kg.
pub(super) fn mass(links: &[(&Link, Pose)]) -> f64 {
    links.iter().map(|(link, _)| link.mass).sum()
}

/// How that mass is spread, its centre seen from `at`, in a frame that is parallel to the robot frame; `None` if a link does not say
/// how its own is. No inertia is that of a robot which is larger than `reach`: mm.
pub(super) fn spread(links: &[(&Link, Pose)], at: Point, reach: f64) -> Option<Spread> {
    let mass = mass(links);
    let heavy = || links.iter().filter(|(link, _)| link.mass > 0.0);
    let is_known = heavy().all(|(link, _)| !is_flat(link) && !is_doubtful(link, reach));
    if !(mass > 0.0 && is_known) {
        return None;
    }
    let placed = |(link, pose): &(&Link, Pose)| (link.mass, pose.then(&link.centre), link.inertia);
    let centre = heavy().map(placed).fold([0.0; 3], |sum, (own, pose, _)| {
        let place = pose.origin();
        [0, 1, 2].map(|axis| sum[axis] + own / mass * place[axis])
    });
    let inertia = heavy().map(placed).fold([0.0; 6], |sum, (own, pose, of)| {
        let turned = pose.tensor(of);
        let place = pose.origin();
        let [x, y, z] = [0, 1, 2].map(|axis| (place[axis] - centre[axis]) / 1000.0);
        let moved = [
            y * y + z * z,
            x * x + z * z,
            x * x + y * y,
            -x * y,
            -x * z,
            -y * z,
        ];
        std::array::from_fn(|element| sum[element] + turned[element] + own * moved[element])
    });
    let spread = Spread {
        centre: [0, 1, 2].map(|axis| centre[axis] - at[axis]),
        inertia: rounded(inertia),
    };
    spread.is_sound().then_some(spread)
}

/// Whether a link weighs something and turns as if it were nothing.
pub(super) fn is_flat(link: &Link) -> bool {
    let [xx, yy, zz, ..] = link.inertia;
    link.mass > 0.0 && [xx, yy, zz].iter().any(|moment| *moment <= 0.0)
}

/// Whether a link weighs something, and turns as no rigid body does, or one that is larger than the robot.
pub(super) fn is_doubtful(link: &Link, reach: f64) -> bool {
    let own = Spread {
        centre: [0.0; 3],
        inertia: link.inertia,
    };
    let [xx, yy, zz, ..] = link.inertia;
    let most = link.mass * (reach / 1000.0) * (reach / 1000.0);
    link.mass > 0.0 && !is_flat(link) && !(own.is_sound() && xx.max(yy).max(zz) <= most)
}

/// A tensor without the dust that turning it leaves.
fn rounded(tensor: [f64; 6]) -> [f64; 6] {
    let most = tensor
        .iter()
        .fold(0.0_f64, |most, element| most.max(element.abs()));
    tensor.map(|element| match element.abs() > most * 1e-12 {
        true => format!("{element:.DIGITS$e}").parse().unwrap_or(element),
        false => 0.0,
    })
}
