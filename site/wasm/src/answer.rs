//! What a page is answered.

use crate::ask::{Ask, Task};
use crate::workbench::{Missing, Workbench};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};
use std::fmt::Display;
use tip_sim::{Interpreter, Limit, Run};
use tip_view::{Extent, Recording};
use tipc::Loaded;
use tipc::message::Lang;
use tipc::render;

/// How long a run goes on that nobody ends: minutes of the robot's time.
const MINUTES: f64 = 2.0;

pub(crate) fn answer(ask: &Ask) -> Value {
    let lang = match &*ask.lang {
        "ja" => Lang::Japanese,
        _ => Lang::English,
    };
    let bench = match Workbench::of(ask) {
        Ok(bench) => bench,
        Err(Missing::Found(loaded)) => return json!({ "findings": findings(&loaded, lang) }),
        Err(Missing::Wrong(reason)) => return error(&reason),
    };
    let mut answer = json!({ "findings": findings(&bench.loaded, lang) });
    let done = match ask.task {
        _ if bench.loaded.program.is_none() => return answer,
        Task::Check => return answer,
        Task::Run => recording(&bench, ask).map(|text| ("recording", text)),
        Task::Trace => trace(&bench, ask).map(|text| ("trace", text)),
    };
    match done {
        Ok((key, text)) => answer[key] = Value::String(text),
        Err(reason) => return error(&reason),
    }
    answer
}

/// What the page says instead of an answer.
pub(crate) fn error(reason: &impl Display) -> Value {
    json!({ "error": reason.to_string() })
}

fn findings(loaded: &Loaded, lang: Lang) -> Vec<Value> {
    let diagnostics = loaded.diagnostics.iter();
    let objects = diagnostics.map(|diagnostic| {
        let object = render::json(&loaded.source, diagnostic, loaded.robot, lang);
        serde_json::from_str(&object).unwrap_or_default()
    });
    objects.collect()
}

fn recording(bench: &Workbench, ask: &Ask) -> Result<String, String> {
    let extent = ask.cycles.map_or(Extent::minutes(MINUTES), Extent::cycles);
    let recording = Recording::of(&bench.loaded, &bench.robot, &bench.events, extent, || true);
    let recording = recording.map_err(|error| error.to_string())?;
    Ok(STANDARD.encode(recording.packed()))
}

fn trace(bench: &Workbench, ask: &Ask) -> Result<String, String> {
    let program = bench.loaded.program.clone().ok_or("there is no program")?;
    let run = Run::new(Interpreter::new(program), bench.robot.clone());
    let run = run.map_err(|error| error.to_string())?.with_trace(true);
    let mut run = run
        .with_events(&bench.events)
        .map_err(|error| error.to_string())?;
    run.to_end(ask.cycles.map_or(Limit::NONE, Limit::cycles));
    Ok(run.trace())
}
