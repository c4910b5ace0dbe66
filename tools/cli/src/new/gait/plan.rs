//! The numbers of a gait, derived from the geometry, the joint limits and the speed of the servos.

use crate::message::Making;
use crate::new::gait::Kind;
use crate::new::gait::reach::{
    Stride, Twist, angles, centre_of_mass, fastest_joint, largest, left_behind, margin, size,
};
use tip_runtime::model::Point;
use tip_runtime::plant::ServoDynamics;
use tip_sim::Anatomy;

/// Share of the servos' speed that a gait uses. A trot keeps more for its balance.
const SPEED_SHARE: f64 = 0.85;
const TROT_SPEED_SHARE: f64 = 0.75;
/// Share of the reach that a stride uses.
const REACH_SHARE: f64 = 0.8;
/// Least distance of the centre of mass from the edge of the support polygon, mm.
const LEAST_MARGIN: f64 = 15.0;
/// Acceleration of gravity, m/s².
const GRAVITY: f64 = 9.806_65;
/// Coefficient of friction that gaits are made for.
const FRICTION: f64 = 0.5;
/// Half a stride of a trot, as a share of √(h / g): the body tips slowly for so long.
const TROT_SHARE: f64 = 0.78;
/// Largest velocities that are tried: mm/s, mm/s, deg/s.
const FASTEST: Twist = [1000.0, 1000.0, 180.0];
/// Largest distance of a foot from its place that is tried, mm.
const FARTHEST: f64 = 300.0;

/// The constants of a gait, in the units of the program.
#[derive(Clone, Debug)]
pub(super) struct Plan {
    pub(super) kind: Kind,
    /// The legs that swing together, from 0, in order of their swings.
    pub(super) groups: Vec<Vec<usize>>,
    /// Places of the feet in the initial posture, mm.
    pub(super) feet: Vec<Point>,
    /// ms
    pub(super) swing: f64,
    /// Time with all feet on the floor, or for the body to lean to the other side, ms.
    pub(super) pause: f64,
    /// mm
    pub(super) lift: f64,
    /// ms
    pub(super) delay: f64,
    /// Share of the way to the middle of the feet that stand.
    pub(super) sway: f64,
    /// mm
    pub(super) reach: f64,
    /// Distances ahead that are as far as 1 mm to the side, and as 1 deg: mm.
    pub(super) weight: [f64; 2],
    /// mm
    pub(super) lean: f64,
    /// mm
    pub(super) raise: f64,
    /// mm
    pub(super) lower: f64,
    pub(super) top: Twist,
    /// Control cycle, ms.
    pub(super) cycle: f64,
}

impl Plan {
    /// Derives the gait of a robot.
    ///
    /// # Errors
    /// The reason why the robot cannot walk so.
    pub(super) fn derive(anatomy: &Anatomy, kind: Kind) -> Result<Self, Making> {
        let legs = anatomy.legs.len();
        let groups = groups(anatomy, kind)?;
        let cycle = anatomy.standards.period;
        let stance = Stance::of(anatomy, legs)?;
        let height = -stance.homes[0][2];
        let speed_share = match kind {
            Kind::Trot => TROT_SPEED_SHARE,
            _ => SPEED_SHARE,
        };
        let limit = speed_share * ServoDynamics::default().speed;
        let lift_share = if kind == Kind::Trot { 0.1 } else { 0.14 };
        let lift = ((lift_share * height / 5.0).round() * 5.0).clamp(5.0, 40.0);
        let sway = match kind {
            Kind::Crawl => stance.sway(legs)?,
            _ => 0.0,
        };
        if kind != Kind::Trot {
            stance.check_balance(&groups, sway)?;
        }
        let lean_to_side = sway * stance.widest() / (legs as f64 - 1.0);
        let candidates = candidates(kind, cycle, height, lean_to_side);
        let free = Way {
            anatomy,
            stance: &stance,
            groups: &groups,
            sway: lean_to_side,
            lift,
            limit,
            cycle,
            kind,
        };
        let mut best: Option<(f64, f64, f64)> = None;
        for (swing, pause) in candidates {
            let ahead = free.top(1, swing, pause);
            // A shorter stride is steadier: a longer one must be worth it.
            if best.is_none_or(|(_, _, fastest)| ahead > 1.05 * fastest) {
                best = Some((swing, pause, ahead));
            }
        }
        let (swing, pause, ahead) = best.filter(|best| best.2 >= 5.0).ok_or(Making::OutOfReach)?;
        let top = [free.top(0, swing, pause), ahead, free.top(2, swing, pause)];
        let reach = free.reach();
        let standing = free.stance_time(swing, pause);
        let ramp = match kind {
            Kind::Tripod | Kind::Trot => swing + pause,
            Kind::Wave | Kind::Crawl => 500.0 * standing,
        };
        let grip = ahead / (0.15 * FRICTION * GRAVITY);
        let round_to = |value: f64, step: f64| (value / step).floor() * step;
        Ok(Plan {
            kind,
            feet: anatomy.feet.clone(),
            swing,
            pause,
            lift,
            delay: round_to(ramp.max(grip), 50.0) + 50.0,
            sway: (sway * 100.0).round() / 100.0,
            reach: round_to(0.9 * reach[1], 5.0),
            weight: [
                tenth(reach[1] / reach[0].max(1.0)),
                tenth(reach[1] / reach[2].max(0.1)),
            ],
            lean: stance.lean,
            raise: stance.raise,
            lower: stance.lower(anatomy),
            top: [
                round_to(top[0], 5.0).max(1.0),
                round_to(top[1], 5.0),
                round_to(top[2], 1.0).max(1.0),
            ],
            groups,
            cycle,
        })
    }

    /// Makes all speeds slower by a factor.
    pub(super) fn slow_down(&mut self, factor: f64) {
        self.top = self.top.map(|top| (top * factor).floor().max(1.0));
    }
}

/// Rounds to a tenth.
fn tenth(value: f64) -> f64 {
    (value * 10.0).round() / 10.0
}

/// Returns the legs that swing together, in order.
fn groups(anatomy: &Anatomy, kind: Kind) -> Result<Vec<Vec<usize>>, Making> {
    let legs = anatomy.legs.len();
    if legs < 4 {
        return Err(Making::TooFewLegs);
    }
    let feet = &anatomy.feet;
    let count = legs as f64;
    let middle = [0, 1].map(|axis| feet.iter().map(|foot| foot[axis]).sum::<f64>() / count);
    let mut order: Vec<usize> = (0..legs).collect();
    match kind {
        Kind::Trot if legs != 4 => return Err(Making::TrotNeedsFour),
        Kind::Tripod if legs < 6 => return Err(Making::TripodNeedsSix),
        Kind::Trot | Kind::Tripod => {
            let angle =
                |leg: usize| (feet[leg][1] - middle[1]).atan2(feet[leg][0] - middle[0]);
            order.sort_by(|a, b| angle(*a).total_cmp(&angle(*b)));
            let every_other = |first: usize| {
                let mut group: Vec<usize> = order.iter().skip(first).step_by(2).copied().collect();
                group.sort_unstable();
                group
            };
            let mut groups = vec![every_other(0), every_other(1)];
            groups.sort();
            Ok(groups)
        }
        Kind::Crawl | Kind::Wave => {
            let is_left = |leg: usize| feet[leg][0] < middle[0];
            order.sort_by(|a, b| {
                let sides = is_left(*b).cmp(&is_left(*a));
                sides.then(feet[*a][1].total_cmp(&feet[*b][1]))
            });
            Ok(order.into_iter().map(|leg| vec![leg]).collect())
        }
    }
}

/// Returns the times of swing and pause that are tried, ms, the shortest first.
fn candidates(kind: Kind, cycle: f64, height: f64, lean: f64) -> Vec<(f64, f64)> {
    let whole = |time: f64| (time / cycle).round().max(1.0) * cycle;
    let both = whole(20.0);
    match kind {
        Kind::Trot => {
            let half = 1000.0 * TROT_SHARE * (height / 1000.0 / GRAVITY).sqrt();
            vec![(whole(half - both).max(2.0 * cycle), both)]
        }
        Kind::Tripod | Kind::Wave => {
            let swings = (0..9).map(|n| whole(200.0 + 40.0 * f64::from(n)));
            swings.map(|swing| (swing, both)).collect()
        }
        Kind::Crawl => {
            // The body leans over and stops with 0.4 of what friction gives it.
            let way = 2.0 * lean / 1000.0;
            let time = (std::f64::consts::PI.powi(2) * way / (2.0 * 0.4 * FRICTION * GRAVITY)).sqrt();
            let shift = whole((1200.0 * time).max(300.0));
            let swings = (0..6).map(|n| whole(240.0 + 80.0 * f64::from(n)));
            swings.map(|swing| (swing, shift)).collect()
        }
    }
}

/// How the robot stands before it walks.
struct Stance {
    /// Places of the feet, mm.
    homes: Vec<Point>,
    centre_of_mass: [f64; 2],
    lean: f64,
    raise: f64,
    /// Distance of the belly from the floor, mm.
    belly: f64,
}

impl Stance {
    fn of(anatomy: &Anatomy, legs: usize) -> Result<Self, Making> {
        let feet = &anatomy.feet;
        let floor = feet.iter().map(|foot| foot[2]).fold(f64::INFINITY, f64::min);
        let leg = anatomy.legs.iter().map(|limb| limb.joints.iter().map(|joint| size(joint.link)).sum::<f64>());
        let leg = leg.fold(0.0, f64::max);
        let belly = anatomy.body.map_or(0.0, |body| body.z.min - floor);
        // A robot that lies on its belly stands up first.
        let wanted = (0.1 * leg - belly).max(0.0);
        let raise = (wanted / 10.0).ceil() * 10.0;
        let mean = feet.iter().map(|foot| foot[1]).sum::<f64>() / legs as f64;
        let mut stance = Stance {
            homes: feet.clone(),
            centre_of_mass: [0.0; 2],
            lean: 0.0,
            raise,
            belly: belly + raise,
        };
        // The legs move with their feet, and take the centre of mass along.
        for _ in 0..3 {
            let homes = feet.iter().map(|[x, y, z]| [*x, y - stance.lean, z - raise]);
            stance.homes = homes.collect();
            let posture = stance.posture(anatomy).ok_or(Making::OutOfReach)?;
            stance.centre_of_mass = centre_of_mass(anatomy, &posture);
            stance.lean = (mean - stance.centre_of_mass[1]).round() + 0.0;
        }
        Ok(stance)
    }

    /// Returns the joint angles of all legs.
    fn posture(&self, anatomy: &Anatomy) -> Option<Vec<Vec<f64>>> {
        let legs = anatomy.legs.iter().zip(&self.homes);
        legs.map(|(limb, home)| angles(limb, *home, &limb.initial)).collect()
    }

    /// Returns the points on the floor of the feet that stand while a group is in the air.
    fn standing(&self, group: &[usize]) -> Vec<[f64; 2]> {
        let all = self.homes.iter().enumerate();
        let standing = all.filter(|(leg, _)| !group.contains(leg));
        standing.map(|(_, home)| [home[0], home[1]]).collect()
    }

    fn middle(&self) -> [f64; 2] {
        let count = self.homes.len() as f64;
        [0, 1].map(|axis| self.homes.iter().map(|home| home[axis]).sum::<f64>() / count)
    }

    /// Returns how far the body must lean to the middle of the other feet before one lifts.
    fn sway(&self, legs: usize) -> Result<f64, Making> {
        /// Shares that are tried.
        const SHARES: [f64; 6] = [0.3, 0.4, 0.5, 0.6, 0.7, 0.8];
        let enough = |share: &f64| {
            (0..legs).all(|leg| self.margin(&[leg], *share) >= LEAST_MARGIN)
        };
        let share = SHARES.into_iter().find(enough);
        share.ok_or(Making::Falls)
    }

    /// Returns the margin with a group in the air.
    fn margin(&self, group: &[usize], sway: f64) -> f64 {
        let middle = self.middle();
        let share = sway / (self.homes.len() as f64 - 1.0);
        let [x, y] = [0, 1].map(|axis| {
            let away: f64 = group.iter().map(|leg| self.homes[*leg][axis] - middle[axis]).sum();
            self.centre_of_mass[axis] - share * away
        });
        margin(&self.standing(group), [x, y])
    }

    /// Checks that the robot can stand while each group is in the air.
    fn check_balance(&self, groups: &[Vec<usize>], sway: f64) -> Result<(), Making> {
        for group in groups {
            let margin = self.margin(group, sway);
            if margin < LEAST_MARGIN {
                let names: Vec<String> = group.iter().map(|leg| format!("F{}", leg + 1)).collect();
                return Err(Making::NoBalance {
                    feet: names.join(" "),
                    margin: margin.round(),
                });
            }
        }
        Ok(())
    }

    /// Returns the largest distance of a foot to the side of the middle, mm.
    fn widest(&self) -> f64 {
        let middle = self.middle();
        let sides = self.homes.iter().map(|home| (home[0] - middle[0]).abs());
        sides.fold(0.0, f64::max)
    }

    /// Returns the distance that the robot can sink, mm: to its belly, unless a joint ends before.
    fn lower(&self, anatomy: &Anatomy) -> f64 {
        let reaches = |way: f64| {
            let mut legs = anatomy.legs.iter().zip(&self.homes);
            legs.all(|(limb, [x, y, z])| angles(limb, [*x, *y, z + way], &limb.initial).is_some())
        };
        let way = largest(self.belly.max(0.0) * 1.001, reaches);
        (way - 2.0).max(0.0).floor()
    }
}

/// What limits the speed of a gait.
struct Way<'a> {
    anatomy: &'a Anatomy,
    stance: &'a Stance,
    groups: &'a [Vec<usize>],
    /// Largest distance that the body leans to a side, mm.
    sway: f64,
    lift: f64,
    /// Largest speed of a joint, deg/s.
    limit: f64,
    /// ms
    cycle: f64,
    kind: Kind,
}

impl Way<'_> {
    /// Returns the time that a foot stands, s.
    fn stance_time(&self, swing: f64, pause: f64) -> f64 {
        let count = self.groups.len() as f64;
        let time = match self.kind {
            Kind::Crawl => {
                let short = (pause / self.cycle / 3.0).floor() * self.cycle;
                (count - 1.0) * (swing + short) + 2.0 * pause - short
            }
            _ => count * (swing + pause) - swing,
        };
        time / 1000.0
    }

    /// Returns the largest speed along an axis (0: right, 1: ahead, 2: turn): mm/s, deg/s.
    fn top(&self, axis: usize, swing: f64, pause: f64) -> f64 {
        let stride = Stride {
            swing: swing / 1000.0,
            stance: self.stance_time(swing, pause),
            lift: self.lift,
            cycle: self.cycle / 1000.0,
        };
        // A foot that landed when the body was slow stands for longer than half of its way behind its place.
        let reserve = match self.kind {
            Kind::Tripod | Kind::Trot => 1.0 / REACH_SHARE,
            Kind::Wave | Kind::Crawl => 1.3 / REACH_SHARE,
        };
        largest(FASTEST[axis], |speed| {
            let mut twist = [0.0; 3];
            twist[axis] = speed;
            let far = reserve * stride.stance / 2.0;
            self.holds(twist, far)
                && self.reaches(twist, far)
                && fastest_joint(self.anatomy, &self.stance.homes, twist, stride)
                    .is_some_and(|rate| rate <= self.limit)
        })
    }

    /// Returns how far feet can be from their places: mm to the side, mm ahead, deg.
    fn reach(&self) -> [f64; 3] {
        [0, 1, 2].map(|axis| {
            let most = if axis == 2 { 45.0 } else { FARTHEST };
            largest(most, |way| {
                let mut twist = [0.0; 3];
                twist[axis] = way;
                self.reaches(twist, 1.0)
            })
        })
    }

    /// Returns true if all feet reach where a velocity takes them in a time (s) after and before their places, on the floor and
    /// lifted, however the body leans.
    fn reaches(&self, twist: Twist, seconds: f64) -> bool {
        let mut legs = self.anatomy.legs.iter().zip(&self.stance.homes);
        legs.all(|(limb, home)| {
            [-seconds, seconds].into_iter().all(|seconds| {
                let [x, y, z] = left_behind(*home, twist, seconds);
                [-self.sway, self.sway].into_iter().all(|sway| {
                    [0.0, self.lift].into_iter().all(|lift| {
                        angles(limb, [x + sway, y, z + lift], &limb.initial).is_some()
                    })
                })
            })
        })
    }

    /// Returns true if the robot stands safely on the feet of every group, as far behind as a velocity takes them in a time (s), and
    /// as far ahead.
    fn holds(&self, twist: Twist, seconds: f64) -> bool {
        if self.kind == Kind::Trot || self.kind == Kind::Crawl {
            return true;
        }
        self.groups.iter().all(|group| {
            [-seconds, seconds].into_iter().all(|seconds| {
                let homes = self.stance.homes.iter().enumerate();
                let standing = homes.filter(|(leg, _)| !group.contains(leg));
                let feet: Vec<[f64; 2]> = standing
                    .map(|(_, home)| left_behind(*home, twist, seconds))
                    .map(|[x, y, _]| [x, y])
                    .collect();
                margin(&feet, self.stance.centre_of_mass) >= LEAST_MARGIN
            })
        })
    }
}
