//! The numbers of a gait, derived from the geometry, the joint limits and the speed of the servos.

use crate::message::Making;
use crate::new::gait::Kind;
use crate::new::gait::crawl::Crawl;
use crate::new::gait::reach::{
    Stride, Twist, angles, around, centre_of_mass, fastest_joint, largest, left_behind, margin,
    middle, size,
};
use tip_runtime::command::Target;
use tip_runtime::model::Point;
use tip_sim::RobotDescription;

/// Share of the servos' speed that a stride uses; when sticks move, it takes up to a fifth more.
const SPEED_SHARE: f64 = 0.8;
/// Share of it in a trot, where lifting the feet takes much of a joint's speed, whatever the sticks do.
const TROT_SPEED_SHARE: f64 = 0.9;
/// Largest speed of a joint in a trot, deg/s. Simulated servos turn faster, and keep the balance with the rest.
const TROT_SPEED: f64 = 270.0;
/// Share of it in a crawl, which leaves the rest to the body's leaning.
const CRAWL_SPEED_SHARE: f64 = 0.6;
/// Least speed of a gait, mm/s.
const SLOWEST: f64 = 5.0;
/// Share of the reach that a stride uses.
const REACH_SHARE: f64 = 0.8;
/// Least distance of the centre of mass from the edge of the support polygon, mm.
const LEAST_MARGIN: f64 = 15.0;
/// Slope that a gait is made for, deg.
pub(super) const SLOPE: f64 = 5.0;
/// Acceleration of gravity, m/s².
const GRAVITY: f64 = 9.806_65;
/// Coefficient of friction that gaits are made for.
const FRICTION: f64 = 0.5;
/// Half a stride of a trot, as shares of √(h / g): the body tips slowly for so long. Only slow servos need the longer one.
const TROT_SHARES: [f64; 2] = [0.8, 0.9];
/// Largest velocities that are tried: mm/s, mm/s, deg/s.
const FASTEST: Twist = [1000.0, 1000.0, 180.0];
/// Share of what a slope takes from the margin that a crawl keeps in reserve: the others are steps that are shorter then.
const SLOPE_SHARE: f64 = 0.6;
/// Time for which a program looks ahead at its feet, s.
const LOOK_AHEAD: f64 = 0.3;
/// Share of the reach beyond which the body waits for a foot.
const WAIT_SHARE: f64 = 0.9;
/// A crawl needs more of it for the body, which leans although it waits.
const CRAWL_WAIT_SHARE: f64 = 0.7;
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
    /// Speed of the servos, deg/s.
    pub(super) servos: f64,
    /// Control cycle, ms.
    pub(super) cycle: f64,
    /// Time in which every foot swings once, to the side, ahead, and turning: s.
    pub(super) stride: [f64; 3],
}

impl Plan {
    /// Derives the gait of a robot whose servos turn `servos` deg/s.
    ///
    /// # Errors
    /// The reason why the robot cannot walk so.
    pub(super) fn derive(
        description: &RobotDescription,
        kind: Kind,
        servos: f64,
    ) -> Result<Self, Making> {
        let legs = description.legs.len();
        let groups = groups(description, kind)?;
        let cycle = description.standards.period;
        let stance = Stance::of(description, legs)?;
        let height = -stance.homes[0][2];
        let limit = match kind {
            Kind::Trot => (TROT_SPEED_SHARE * servos).min(TROT_SPEED),
            Kind::Crawl => CRAWL_SPEED_SHARE * servos,
            _ => SPEED_SHARE * servos,
        };
        let sway = match kind {
            Kind::Crawl => stance.sway(description)?,
            _ => 0.0,
        };
        if kind != Kind::Trot {
            stance.check_balance(description, &groups, sway)?;
        }
        let share = sway / (legs as f64 - 1.0);
        let candidates = candidates(kind, cycle, height, Crawl::full(&stance.homes, share));
        let way = Way {
            description,
            stance: &stance,
            groups: &groups,
            share,
            lift: 0.0,
            limit,
            cycle,
            kind,
        };
        let mut best: Option<(f64, f64, f64, f64)> = None;
        let alternatives = match kind {
            Kind::Trot => 1,
            _ => candidates.len(),
        };
        for candidates in candidates.chunks(alternatives) {
            for lift in lifts(kind, height) {
                for &(swing, pause) in candidates {
                    let ahead = Way { lift, ..way }.top(1, swing, pause);
                    // A shorter stride is steadier, and a higher step safer: others must be worth it.
                    let least = match best {
                        Some((of, ..)) if of > lift => 1.3,
                        _ => 1.06,
                    };
                    if best.is_none_or(|(.., fastest)| ahead > least * fastest) {
                        best = Some((lift, swing, pause, ahead));
                    }
                }
            }
            if best.is_some_and(|(.., fastest)| fastest >= SLOWEST) {
                break;
            }
        }
        let best = best.filter(|best| best.3 >= SLOWEST);
        let (lift, swing, pause, ahead) = best.ok_or_else(|| {
            let limit = f64::INFINITY;
            let walks = |(swing, pause): &(f64, f64)| {
                Way { limit, ..way }.top(1, *swing, *pause) >= SLOWEST
            };
            match candidates.iter().any(walks) {
                true => Making::TooSlow { speed: servos },
                false => Making::OutOfReach,
            }
        })?;
        let free = Way { lift, ..way };
        let mut top = [free.top(0, swing, pause), ahead, free.top(2, swing, pause)];
        if kind == Kind::Trot {
            top[0] = top[0].min(ahead * stance.width_to_length());
        }
        let reach = free.reach();
        let stride = [0, 1, 2].map(|axis| free.stride(along(axis, top[axis]), swing, pause));
        let standing = stride[1] - swing / 1000.0;
        // At these speeds the body never waits for its feet.
        let steady = |way: f64| match kind {
            Kind::Tripod | Kind::Trot | Kind::Crawl => f64::INFINITY,
            Kind::Wave => 0.85 * way / (standing / 2.0 + LOOK_AHEAD),
        };
        let top = [0, 1, 2].map(|axis: usize| top[axis].min(steady(reach[axis])));
        let share = free.share_of_all(top, swing, pause);
        let top = top.map(|top| share * top);
        let ramp = match kind {
            Kind::Tripod | Kind::Trot => swing + pause,
            Kind::Wave | Kind::Crawl => 500.0 * standing,
        };
        let grip = ahead / (0.15 * FRICTION * GRAVITY);
        let round_to = |value: f64, step: f64| (value / step).floor() * step;
        Ok(Plan {
            kind,
            feet: description.feet.clone(),
            swing,
            pause,
            lift,
            delay: round_to(ramp.max(grip), 50.0) + 50.0,
            sway: (sway * 100.0).round() / 100.0,
            reach: round_to(way.wait_share() * reach[1], 5.0),
            weight: [
                tenth(reach[1] / reach[0].max(1.0)),
                tenth(reach[1] / reach[2].max(0.1)),
            ],
            lean: stance.lean,
            raise: stance.raise,
            lower: stance.lower(description),
            top: [
                round_to(top[0], 5.0).max(1.0),
                round_to(top[1], 5.0).max(5.0),
                round_to(top[2], 1.0).max(1.0),
            ],
            groups,
            servos,
            cycle,
            stride,
        })
    }

    /// Returns the gait with all speeds slower by a factor; the body of a crawl leans more slowly as well.
    pub(super) fn slower(&self, factor: f64) -> Self {
        let mut slower = self.clone();
        if self.kind == Kind::Crawl {
            slower.pause = (self.pause / factor / self.cycle).round() * self.cycle;
        }
        slower.top = self.top.map(|top| (top * factor).floor().max(1.0));
        slower
    }
}

/// Returns a velocity along an axis: 0 to the right, 1 ahead, 2 turning.
fn along(axis: usize, speed: f64) -> Twist {
    let mut twist = [0.0; 3];
    twist[axis] = speed;
    twist
}

/// Returns the name of the foot of a leg, from 0.
pub(super) fn foot_name(leg: usize) -> String {
    Target::Foot(u8::try_from(leg + 1).unwrap_or(u8::MAX)).to_string()
}

/// Rounds to a tenth.
fn tenth(value: f64) -> f64 {
    (value * 10.0).round() / 10.0
}

/// Returns the legs that swing together, in order.
fn groups(description: &RobotDescription, kind: Kind) -> Result<Vec<Vec<usize>>, Making> {
    let legs = description.legs.len();
    if legs < 4 {
        return Err(Making::TooFewLegs);
    }
    let feet = &description.feet;
    match kind {
        Kind::Trot if legs != 4 => Err(Making::TrotNeedsFour),
        Kind::Tripod if legs < 6 => Err(Making::TripodNeedsSix),
        Kind::Trot | Kind::Tripod => {
            let order = around(feet);
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
            let middle = middle(feet);
            let is_left = |leg: usize| feet[leg][0] < middle[0];
            let mut order: Vec<usize> = (0..legs).collect();
            order.sort_by(|a, b| {
                let sides = is_left(*b).cmp(&is_left(*a));
                sides.then(feet[*a][1].total_cmp(&feet[*b][1]))
            });
            Ok(order.into_iter().map(|leg| vec![leg]).collect())
        }
    }
}

/// Returns the times of swing and pause that are tried, ms, the shortest first. `full` is the distance that the body of a crawl leans
/// from one side to the other, mm.
fn candidates(kind: Kind, cycle: f64, height: f64, full: f64) -> Vec<(f64, f64)> {
    let whole = |time: f64| (time / cycle).round().max(1.0) * cycle;
    let both = whole(20.0);
    match kind {
        Kind::Trot => {
            let halves =
                TROT_SHARES.map(|share| 1000.0 * share * (height / 1000.0 / GRAVITY).sqrt());
            let swings = halves.map(|half| whole(half - both).max(2.0 * cycle));
            swings.map(|swing| (swing, both)).to_vec()
        }
        Kind::Tripod | Kind::Wave => {
            let swings = (0..9).map(|n| whole(200.0 + 40.0 * f64::from(n)));
            swings.map(|swing| (swing, both)).collect()
        }
        Kind::Crawl => {
            // The body leans over and stops with 0.4 of what friction gives it.
            let way = full / 1000.0;
            let time =
                (std::f64::consts::PI.powi(2) * way / (2.0 * 0.4 * FRICTION * GRAVITY)).sqrt();
            let shift = whole((1000.0 * time).max(300.0));
            let swings = (0..6).map(|n| whole(240.0 + 80.0 * f64::from(n)));
            swings.map(|swing| (swing, shift)).collect()
        }
    }
}

/// Returns the heights of steps that are tried, mm, the highest first.
fn lifts(kind: Kind, height: f64) -> Vec<f64> {
    let step = |share: f64| (share * height / 5.0).round() * 5.0;
    match kind {
        Kind::Trot => {
            let highest = step(0.1).clamp(10.0, 40.0);
            let lower = [5.0, 10.0].map(|less| highest - less);
            let lower = lower.into_iter().filter(|lift| *lift >= 10.0);
            std::iter::once(highest).chain(lower).collect()
        }
        // Without mass, feet up to 20 mm above the lowest one count as standing.
        _ => vec![step(0.14).clamp(25.0, 40.0)],
    }
}

/// The posture of the robot before it walks.
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
    fn of(description: &RobotDescription, legs: usize) -> Result<Self, Making> {
        let feet = &description.feet;
        let floor = feet
            .iter()
            .map(|foot| foot[2])
            .fold(f64::INFINITY, f64::min);
        let leg = description.legs.iter().map(|limb| {
            limb.joints
                .iter()
                .map(|joint| size(joint.link))
                .sum::<f64>()
        });
        let leg = leg.fold(0.0, f64::max);
        let belly = description.body.map_or(0.0, |body| body.z.min - floor);
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
            let homes = feet
                .iter()
                .map(|[x, y, z]| [*x, y - stance.lean, z - raise]);
            stance.homes = homes.collect();
            let posture = stance.posture(description).ok_or(Making::OutOfReach)?;
            stance.centre_of_mass = centre_of_mass(description, &posture);
            stance.lean = (mean - stance.centre_of_mass[1]).round() + 0.0;
        }
        Ok(stance)
    }

    /// Returns the joint angles of all legs.
    fn posture(&self, description: &RobotDescription) -> Option<Vec<Vec<f64>>> {
        let legs = description.legs.iter().zip(&self.homes);
        legs.map(|(limb, home)| angles(limb, *home, &limb.initial))
            .collect()
    }

    /// Returns the points on the floor of the feet that stand while a group is in the air.
    fn standing(&self, group: &[usize]) -> Vec<[f64; 2]> {
        let all = self.homes.iter().enumerate();
        let standing = all.filter(|(leg, _)| !group.contains(leg));
        standing.map(|(_, home)| [home[0], home[1]]).collect()
    }

    /// Returns how far the body must lean to the middle of the other feet before one lifts.
    fn sway(&self, description: &RobotDescription) -> Result<f64, Making> {
        // A slope takes the centre of mass aside.
        let slope = -self.homes[0][2] * SLOPE.to_radians().tan();
        let least = LEAST_MARGIN + SLOPE_SHARE * slope;
        let enough = |share: &f64| {
            (0..self.homes.len()).all(|leg| {
                let margin = self.margin(description, &[leg], *share);
                margin.is_some_and(|margin| margin >= least)
            })
        };
        let shares = (4..=16).map(|n| 0.05 * f64::from(n));
        shares.into_iter().find(enough).ok_or(Making::Falls)
    }

    /// Returns the margin with a group in the air. The legs move with the feet when the body leans, and hold the centre of mass back.
    fn margin(&self, description: &RobotDescription, group: &[usize], sway: f64) -> Option<f64> {
        let middle = middle(&self.homes);
        let share = sway / (self.homes.len() as f64 - 1.0);
        let [x, y] = [0, 1].map(|axis| {
            let away = group
                .iter()
                .map(|leg| self.homes[*leg][axis] - middle[axis]);
            share * away.sum::<f64>()
        });
        let moved = |home: &Point| [home[0] + x, home[1] + y, home[2]];
        let leaning = Stance {
            homes: self.homes.iter().map(moved).collect(),
            ..*self
        };
        let posture = leaning.posture(description)?;
        let standing = leaning.standing(group);
        Some(margin(&standing, centre_of_mass(description, &posture)))
    }

    /// Checks that the robot can stand while each group is in the air.
    fn check_balance(
        &self,
        description: &RobotDescription,
        groups: &[Vec<usize>],
        sway: f64,
    ) -> Result<(), Making> {
        for group in groups {
            let margin = self.margin(description, group, sway);
            let margin = margin.ok_or(Making::OutOfReach)?;
            if margin < LEAST_MARGIN {
                let names: Vec<String> = group.iter().map(|leg| foot_name(*leg)).collect();
                return Err(Making::NoBalance {
                    feet: names.join(" "),
                    // Adding 0 makes of −0 a plain 0.
                    margin: margin.round() + 0.0,
                });
            }
        }
        Ok(())
    }

    /// Returns the width over the length of the feet. Feet that move to the side take the line between two diagonal ones farther from
    /// the centre of mass than feet that move ahead by the same way: by the inverse of it.
    fn width_to_length(&self) -> f64 {
        let middle = middle(&self.homes);
        let [width, length] = [0, 1].map(|axis| {
            let ways = self
                .homes
                .iter()
                .map(|home| (home[axis] - middle[axis]).abs());
            ways.sum::<f64>()
        });
        width / length.max(1.0)
    }

    /// Returns the distance between the first and the last feet, mm, for each row of them but one.
    fn spacing(&self) -> f64 {
        let places = self.homes.iter().map(|home| home[1]);
        let last = places.clone().fold(f64::INFINITY, f64::min);
        let first = places.fold(f64::NEG_INFINITY, f64::max);
        (first - last) / (self.homes.len().div_ceil(2) as f64 - 1.0)
    }

    /// Returns the distance that the robot can sink, mm: to its belly, unless a joint ends before.
    fn lower(&self, description: &RobotDescription) -> f64 {
        let reaches = |way: f64| {
            let mut legs = description.legs.iter().zip(&self.homes);
            legs.all(|(limb, [x, y, z])| angles(limb, [*x, *y, z + way], &limb.initial).is_some())
        };
        let way = largest(self.belly.max(0.0) * 1.001, reaches);
        (way - 2.0).max(0.0).floor()
    }
}

/// The limits of the speed of a gait.
#[derive(Clone, Copy)]
struct Way<'a> {
    description: &'a RobotDescription,
    stance: &'a Stance,
    groups: &'a [Vec<usize>],
    /// Part of a foot's way from the middle that the body of a crawl leans away from it.
    share: f64,
    lift: f64,
    /// Largest speed of a joint, deg/s.
    limit: f64,
    /// ms
    cycle: f64,
    kind: Kind,
}

impl Way<'_> {
    /// Returns the time in which every foot swings once at a velocity, s.
    fn stride(&self, twist: Twist, swing: f64, pause: f64) -> f64 {
        match self.kind {
            Kind::Crawl => self.crawl(swing, pause, |crawl| crawl.stride(twist)),
            _ => self.groups.len() as f64 * (swing + pause) / 1000.0,
        }
    }

    /// Returns the share of the reach beyond which the body waits for a foot.
    fn wait_share(&self) -> f64 {
        match self.kind {
            Kind::Crawl => CRAWL_WAIT_SHARE,
            _ => WAIT_SHARE,
        }
    }

    /// Calculates something of a crawl from its swing and the time in which its body leans to the other side, ms.
    fn crawl<T>(&self, swing: f64, shift: f64, of: impl FnOnce(&Crawl<'_>) -> T) -> T {
        of(&Crawl {
            homes: &self.stance.homes,
            order: &self.groups.concat(),
            share: self.share,
            swing: swing / 1000.0,
            shift: shift / 1000.0,
        })
    }

    /// Returns the largest speed along an axis (0: right, 1: ahead, 2: turn): mm/s, deg/s.
    fn top(&self, axis: usize, swing: f64, pause: f64) -> f64 {
        let reach = self.reach();
        largest(FASTEST[axis], |speed| {
            let twist = along(axis, speed);
            let stride = Stride {
                swing: swing / 1000.0,
                stance: self.stride(twist, swing, pause) - swing / 1000.0,
                lift: self.lift,
                cycle: self.cycle / 1000.0,
            };
            let far = self.far(stride.stance);
            let side = reach[1] / reach[0].max(1.0);
            let fits = match self.kind {
                Kind::Crawl => self.crawl(swing, pause, |crawl| {
                    crawl.farthest(twist, side, LOOK_AHEAD) <= self.wait_share() * reach[1]
                }),
                _ => self.holds(twist, far) && self.reaches(twist, far),
            };
            fits && fastest_joint(self.description, &self.stance.homes, twist, stride)
                .is_some_and(|rate| rate <= self.limit)
        })
    }

    /// Returns the time that a foot is away from its place at most, s, of the time on the floor: one that landed when the body was slow
    /// stands for longer than half of its way behind its place.
    fn far(&self, stance: f64) -> f64 {
        let reserve = match self.kind {
            Kind::Tripod | Kind::Trot => 1.0,
            Kind::Wave | Kind::Crawl => 1.3,
        };
        reserve / REACH_SHARE * stance / 2.0
    }

    /// Returns the largest share of the speeds along the axes at which feet reach where all sticks together take them. A crawl waits
    /// for its feet instead.
    fn share_of_all(&self, top: Twist, swing: f64, pause: f64) -> f64 {
        if self.kind == Kind::Crawl {
            return 1.0;
        }
        let far = self.far(self.stride(top, swing, pause) - swing / 1000.0);
        let ends = [-1.0, 0.0, 1.0];
        let all = ends.map(|side| ends.map(|turn| [0.0, 1.0].map(|ahead| [side, ahead, turn])));
        let sticks = all.as_flattened().as_flattened();
        largest(1.0, |share| {
            sticks.iter().all(|sticks| {
                let part = share / size(*sticks).max(1.0);
                self.reaches([0, 1, 2].map(|axis| part * sticks[axis] * top[axis]), far)
            })
        })
    }

    /// Returns how far feet can be from their places: mm to the side, mm ahead, deg.
    fn reach(&self) -> [f64; 3] {
        let reach = [0, 1, 2].map(|axis| {
            let most = if axis == 2 { 45.0 } else { FARTHEST };
            largest(most, |way| self.reaches(along(axis, way), 1.0))
        });
        if self.kind != Kind::Crawl {
            return reach;
        }
        // In a crawl feet reach all of an ellipse. Feet that come near each other leave the body too little to stand on.
        let [side, ahead, turn] = reach;
        let ahead = ahead.min(0.5 * self.stance.spacing());
        let share = largest(1.0, |share| {
            [-0.75, -0.5, -0.25, 0.0, 0.25, 0.5]
                .into_iter()
                .all(|part| {
                    let (sin, cos) = (std::f64::consts::PI * part).sin_cos();
                    self.reaches([share * side * cos, share * ahead * sin, 0.0], 1.0)
                })
        });
        [side, ahead, turn].map(|way| share * way)
    }

    /// Returns true if all feet reach where a velocity takes them in a time (s) after and before their places, on the floor and lifted.
    fn reaches(&self, twist: Twist, seconds: f64) -> bool {
        let mut legs = self.description.legs.iter().zip(&self.stance.homes);
        legs.all(|(limb, home)| {
            [-seconds, seconds].into_iter().all(|seconds| {
                let [x, y, z] = left_behind(*home, twist, seconds);
                [0.0, self.lift]
                    .into_iter()
                    .all(|lift| angles(limb, [x, y, z + lift], &limb.initial).is_some())
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
