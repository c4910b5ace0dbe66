//! Moves a robot to poses that were taught, slowly and with torque, and switches the torque off after a key.

use crate::Status;
use crate::drives::robot::Connection;
use crate::drives::zero::relax;
use crate::error::Error;
use crate::message::Driving;
use crate::report;
use tip_drives::drives::Failure;
use tip_drives::guard::{SETTLING, Step};
use tip_view::live::LessonPhase;
use tipc::message::Lang;

/// The key that switches the torque off.
const RELEASE: u8 = b'r';

/// The key that ends the lesson.
const END: u8 = b'q';

/// The state of a robot after it has gone to its poses.
#[derive(Debug)]
pub(super) enum Gone {
    /// It has no torque.
    Limp,
    /// The operator or a fault has ended the lesson, and the robot was left: as at an end, or with this status.
    Left(Option<Status>),
}

/// Shows in each cycle what the robot does, and the place of the pose that it goes to or holds.
type Show<'a> = &'a mut dyn FnMut(LessonPhase, usize);

/// Moves a robot through poses and holds the last one until the key that releases it.
///
/// # Errors
/// A servo has not confirmed that its torque is off.
pub(super) fn go(
    connection: &Connection,
    poses: &[Vec<f64>],
    lang: Lang,
    show: Show<'_>,
) -> Result<Gone, Error> {
    let complain = |failure| report::complain(&format!("{}\n", connection.explain(failure)));
    let connected = connection.robot().connect();
    if let Err(failure) = connected {
        complain(failure);
        return Ok(Gone::Limp);
    }
    if let Some(reason) = connection.refusal_of_way(poses) {
        report::complain(&format!("{reason}\n"));
        return Ok(Gone::Limp);
    }
    connection.take_over(true);
    let mut ends = false;
    let step = through(connection, poses, &mut ends, lang, show);
    if let Err(failure) = step
        && !connection.robot().has_torque()
        && !connection.robot().is_stopped()
    {
        // A joint is where it must not be, and no torque was switched on.
        connection.finish();
        complain(failure);
        return Ok(Gone::Limp);
    }
    match connection.ended(step) {
        None => {}
        Some(Status::Interrupted) => return Ok(Gone::Left(None)),
        Some(status) => return Ok(Gone::Left(Some(status))),
    }
    // A robot that relaxes at its end sinks slowly.
    if connection.finish().is_stopped {
        return Ok(Gone::Left(Some(Status::Emergency)));
    }
    if ends {
        return Ok(Gone::Left(None));
    }
    relax(connection, lang)?;
    Ok(Gone::Limp)
}

/// Switches the torque on, moves the robot, and holds it until a key releases it or `ends` the lesson.
fn through(
    connection: &Connection,
    poses: &[Vec<f64>],
    ends: &mut bool,
    lang: Lang,
    show: Show<'_>,
) -> Result<Step, Failure> {
    let speed = connection.setup.bus.start;
    report::say(Driving::PoseGoes { speed }, lang);
    let mut step = connection.robot().hold()?;
    for (place, pose) in poses.iter().enumerate() {
        let mut settled = 0;
        while settled < SETTLING && !matches!(step, Step::Left(_)) {
            step = connection.robot().step(pose, speed)?;
            settled += u32::from(step == Step::Arrived);
            show(LessonPhase::Goes, place);
        }
    }
    let Some(last) = poses.last().filter(|_| !matches!(step, Step::Left(_))) else {
        return Ok(step);
    };
    // A key that was typed on the way does not release the robot.
    while connection.key().is_some() {}
    report::say(Driving::PoseReached, lang);
    while !matches!(step, Step::Left(_)) {
        let key = connection.key();
        *ends = key == Some(END);
        if *ends || key == Some(RELEASE) {
            break;
        }
        step = connection.robot().step(last, speed)?;
        show(LessonPhase::Holds, poses.len() - 1);
    }
    Ok(step)
}
