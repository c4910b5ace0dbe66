//! The certificate: what was compared, with what, and what no run reached.

use super::super::arguments::InputArguments;
use super::super::choices::PlantName;
use super::super::loader::Checked;
use super::super::plant::PlantChoice;
use std::fmt::Write as _;
use tip_lint::spots::Spot;
use tip_runtime::printable::Printable;
use tip_sim::search::Coverage;
use tip_sim::verify::{Project, VERSION};
use tipc::program::Step;

/// The text of a certificate.
pub(super) fn certificate(
    checked: &Checked,
    project: &Project,
    inputs: &InputArguments,
    coverage: &Coverage,
) -> String {
    let name = Printable::line(checked.source.name());
    let hash = checked.program.source_hash();
    let robot = checked.program.signature();
    let (robot, legs, joints) = (robot.robot, robot.legs, robot.joints);
    let scene = inputs.scene.as_ref();
    let mut scene = scene.map_or("level floor".to_owned(), |scene| {
        format!("scene {}", Printable::line(scene))
    });
    if let Some(plant) = inputs
        .plant
        .as_ref()
        .and_then(PlantChoice::name)
        .map(PlantName::name)
    {
        scene = format!("{scene}, {plant} plant");
    }
    let (rustc, cargo) = (
        project.version_of("RUSTC", "rustc"),
        project.version_of("CARGO", "cargo"),
    );
    let (runs, cycles) = (coverage.runs(), coverage.cycles);
    let (finished, limited, stopped) = (coverage.finished, coverage.limited, coverage.stopped);
    let all = coverage.reach.spots().all();
    let missed: Vec<&Spot> = (0..)
        .zip(all)
        .filter(|(spot, _)| !coverage.reach.has(*spot))
        .map(|(_, spot)| spot)
        .collect();
    let covered = |is_kind: fn(&Spot) -> bool| {
        let of = all.iter().filter(|spot| is_kind(spot)).count();
        let missed = missed.iter().filter(|spot| is_kind(spot)).count();
        format!("{} of {of}", of - missed)
    };
    let steps = covered(|spot| spot.way.is_none());
    let edges = covered(|spot| spot.way.is_some());
    let mut text = format!(
        "{name}: compiled code and interpreter agree\n\
         source       {hash:016x}\n\
         tools        tipc {VERSION}, {rustc}, {cargo}\n\
         robot        {robot}, {legs} x {joints} joints, {scene}\n\
         runs         {runs}: {finished} to END or EXIT, {limited} to the last cycle allowed, {stopped} to an emergency stop\n\
         compared     {cycles} cycles, each record with the state of every joint, floats by bits\n\
         steps        {steps}\n\
         branch edges {edges}\n"
    );
    let lines = missed.iter().filter(|spot| !follows(spot, &missed));
    let lines = lines.map(|spot| {
        (
            spot.step,
            spot.way
                .map_or("not reached".to_owned(), |way| format!("never {way}")),
        )
    });
    let dead = (0..)
        .take(checked.program.steps().len())
        .filter(|step| !coverage.reach.spots().can_reach(*step));
    let dead = dead.map(|step| (step, "no way leads here".to_owned()));
    let mut lines: Vec<_> = lines.chain(dead).collect();
    lines.sort();
    for (step, what) in lines {
        if let Some(Step {
            line,
            text: statement,
            ..
        }) = checked.program.steps().get(step as usize)
        {
            // Writing to a String cannot fail.
            let _ = writeln!(
                text,
                "  {name}:{line}: {what}: {}",
                Printable::line(statement)
            );
        }
    }
    text
}

/// An edge of a step that was not reached itself goes without saying.
fn follows(spot: &Spot, missed: &[&Spot]) -> bool {
    spot.way.is_some()
        && missed
            .iter()
            .any(|other| other.way.is_none() && other.step == spot.step)
}
