//! The other process: joints that are immediately where they are commanded to be.

use std::error::Error;
use std::time::Duration;
use tip_runtime::fault::Fault;
use tip_runtime::record::Ending;
use tip_sim::external::{PlantError, TimeLimits};
use tip_sim::{ExternalPlant, Limit, Robot, Run, load};

pub(crate) type Outcome = Result<(), Box<dyn Error>>;

/// Angles of TITAN VIII's joints.
pub(crate) const ANGLES: &str = "[0.0,0.0,90.0,0.0,0.0,90.0,0.0,0.0,90.0,0.0,0.0,90.0]";

/// Returns a shell script that does one thing at `hello`, another in each cycle, with `$n` and `$targets` as the line has them.
pub(crate) fn script(ready: &str, each: &str) -> String {
    format!(
        r#"while read -r line; do
           n=${{line#*\"n\":}}; n=${{n%%,*}}
           targets=${{line#*\"targets\":}}; targets=${{targets%%]*}}]
           case $line in
             *\"hello\"*) {ready};;
             *\"cycle\"*) {each};;
             *\"bye\"*) exit 0;;
           esac
         done"#
    )
}

/// Returns a shell command that writes an object with these fields; of the shell's expansions `$n` and `$targets` work in it.
pub(crate) fn says(fields: &str) -> String {
    format!("echo \"{{{}}}\"", fields.replace('"', "\\\""))
}

/// Returns the answer to `hello`, with more fields.
pub(crate) fn ready_with(more: &str) -> String {
    says(&format!(r#""version":2,"angles":{ANGLES}{more}"#))
}

/// Returns the answer to `hello`.
pub(crate) fn ready() -> String {
    ready_with("")
}

/// Returns the answer to a cycle, with more fields.
pub(crate) fn echo_with(more: &str) -> String {
    says(&format!(r#""n":$n,"angles":$targets{more}"#))
}

/// The answer to a cycle.
pub(crate) const ECHO: &str = r#"echo "{\"n\":$n,\"angles\":$targets}""#;

/// So much time as a test has.
pub(crate) const PATIENCE: TimeLimits = TimeLimits {
    first: Duration::from_secs(20),
    later: Duration::from_secs(20),
};

/// A process of a shell.
pub(crate) fn peer(ready: &str, each: &str) -> ExternalPlant {
    ExternalPlant::new("sh", ["-c", &script(ready, each)]).with_time_limits(PATIENCE)
}

/// A process that does something else in cycle 3.
pub(crate) fn in_cycle_3(does: &str) -> ExternalPlant {
    let each = format!("if [ $n = 3 ]; then {does}; else {ECHO}; fi");
    peer(&ready(), &each)
}

/// Some joints move, and the program ends.
pub(crate) const NOD: &str = "PTP_ANGLE F1 R 10 R -5 R 7.25\nWAIT_INPOS F1\nMESSAGE there\nEND";

/// Statements on TITAN VIII.
pub(crate) fn run(statements: &str, plant: &ExternalPlant) -> Result<Run, Box<dyn Error>> {
    run_on("titan8", statements, plant)
}

pub(crate) fn run_on(
    robot: &str,
    statements: &str,
    plant: &ExternalPlant,
) -> Result<Run, Box<dyn Error>> {
    let robot = Robot::named(robot)?;
    let program = load("p.prg", &format!("3.1\nt\n{statements}\n"), &robot)?;
    Ok(Run::external(program, &robot, plant)?.with_trace(true))
}

/// Runs it until it stops: the word, the cycle, and what is wrong.
pub(crate) fn stopped(
    plant: &ExternalPlant,
) -> Result<(&'static str, u64, PlantError), Box<dyn Error>> {
    let mut run = run(NOD, plant)?;
    let Ending::Emergency(emergency) = run.to_end(Limit::cycles(1000)) else {
        return Err("no emergency".into());
    };
    let Fault::Hardware(fault) = emergency.fault else {
        return Err(emergency.to_string().into());
    };
    let trouble = run.plant_error().cloned().ok_or("no trouble")?;
    Ok((fault.cause, emergency.cycle, trouble))
}
