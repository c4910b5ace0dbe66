//! The messages of the Debug Adapter Protocol that are served, as types of serde.

use serde::{Deserialize, Serialize};
use serde_json::Value;

/// A request of the client.
#[derive(Debug, Deserialize)]
pub(crate) struct Request {
    pub(crate) seq: i64,
    pub(crate) command: String,
    #[serde(default)]
    pub(crate) arguments: Value,
}

/// A message to the client.
#[derive(Debug, Serialize)]
#[serde(tag = "type", rename_all = "lowercase")]
pub(crate) enum Sent {
    Response(Response),
    Event(Event),
}

#[derive(Debug, Serialize)]
pub(crate) struct Response {
    pub(crate) seq: i64,
    pub(crate) request_seq: i64,
    pub(crate) success: bool,
    pub(crate) command: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) message: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) body: Option<Value>,
}

#[derive(Debug, Serialize)]
pub(crate) struct Event {
    pub(crate) seq: i64,
    pub(crate) event: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) body: Option<Value>,
}

/// The capabilities of the client: the arguments of `initialize`.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(crate) struct Client {
    pub(crate) lines_start_at1: bool,
    pub(crate) columns_start_at1: bool,
    pub(crate) supports_progress_reporting: bool,
    pub(crate) supports_invalidated_event: bool,
    pub(crate) locale: Option<String>,
}

impl Default for Client {
    fn default() -> Self {
        Client {
            lines_start_at1: true,
            columns_start_at1: true,
            supports_progress_reporting: false,
            supports_invalidated_event: false,
            locale: None,
        }
    }
}

/// The arguments of `launch`: a program, its robot and its inputs.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Launch {
    /// The path of the program.
    pub program: String,
    /// The robot, by name or description.
    #[serde(default)]
    pub robot: Option<String>,
    /// The scene, by name or file.
    #[serde(default)]
    pub scene: Option<String>,
    /// The simulated plant.
    #[serde(default)]
    pub plant: Option<String>,
    /// The encoding of the program.
    #[serde(default)]
    pub encoding: Option<String>,
    /// The events of the run, as the option `--events` takes them.
    #[serde(default)]
    pub events: Option<String>,
    /// Stop before the first statement.
    #[serde(default)]
    pub stop_on_entry: bool,
    /// Stop when the robot falls.
    #[serde(default)]
    pub stop_on_fall: bool,
    /// Run without stops.
    #[serde(default)]
    pub no_debug: bool,
}

/// The arguments of `restart`.
#[derive(Debug, Default, Deserialize)]
pub(crate) struct Restart {
    /// The newest arguments of `launch`, if the client sends them.
    #[serde(default)]
    pub(crate) arguments: Option<Launch>,
}

#[derive(Clone, Debug, Default, Deserialize, Serialize)]
pub(crate) struct SourceFile {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) name: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) path: Option<String>,
}

#[derive(Debug, Deserialize)]
pub(crate) struct SetBreakpoints {
    pub(crate) source: SourceFile,
    #[serde(default)]
    pub(crate) breakpoints: Vec<SourceBreakpoint>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct SourceBreakpoint {
    pub(crate) line: i64,
    pub(crate) column: Option<i64>,
    pub(crate) condition: Option<String>,
    pub(crate) hit_condition: Option<String>,
    pub(crate) log_message: Option<String>,
}

#[derive(Debug, Deserialize)]
pub(crate) struct SetFunctionBreakpoints {
    pub(crate) breakpoints: Vec<FunctionBreakpoint>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct FunctionBreakpoint {
    pub(crate) name: String,
    pub(crate) condition: Option<String>,
    pub(crate) hit_condition: Option<String>,
}

#[derive(Debug, Deserialize)]
pub(crate) struct SetExceptionBreakpoints {
    pub(crate) filters: Vec<String>,
}

#[derive(Debug, Deserialize)]
pub(crate) struct DataBreakpointInfo {
    pub(crate) name: String,
}

#[derive(Debug, Deserialize)]
pub(crate) struct SetDataBreakpoints {
    pub(crate) breakpoints: Vec<DataBreakpoint>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct DataBreakpoint {
    pub(crate) data_id: String,
    pub(crate) condition: Option<String>,
    pub(crate) hit_condition: Option<String>,
}

/// A breakpoint of a response: its line, or the reason why it was not placed.
#[derive(Debug, Default, Serialize)]
pub(crate) struct Breakpoint {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) id: Option<u32>,
    pub(crate) verified: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) message: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) line: Option<i64>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(crate) struct StackTrace {
    pub(crate) thread_id: Option<i64>,
    pub(crate) start_frame: Option<i64>,
    pub(crate) levels: Option<i64>,
}

#[derive(Debug, Serialize)]
pub(crate) struct StackFrame {
    pub(crate) id: i64,
    pub(crate) name: String,
    pub(crate) source: SourceFile,
    pub(crate) line: i64,
    pub(crate) column: i64,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct Variables {
    pub(crate) variables_reference: i64,
    pub(crate) start: Option<u64>,
    pub(crate) count: Option<u64>,
}

#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct Variable {
    pub(crate) name: String,
    pub(crate) value: String,
    #[serde(rename = "type", skip_serializing_if = "Option::is_none")]
    pub(crate) kind: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) evaluate_name: Option<String>,
    pub(crate) variables_reference: i64,
}

#[derive(Debug, Deserialize)]
pub(crate) struct SetVariable {
    pub(crate) name: String,
    pub(crate) value: String,
}

#[derive(Debug, Deserialize)]
pub(crate) struct Evaluate {
    pub(crate) expression: String,
    pub(crate) context: Option<String>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(crate) struct Step {
    pub(crate) thread_id: Option<i64>,
    pub(crate) granularity: Option<String>,
}
