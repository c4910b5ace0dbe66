//! Messages that no editor sends, and those that editors send in any order.

use robustness::dap::examine;
use tip_runtime::random::Random;

const COMMANDS: [&str; 26] = [
    "initialize",
    "launch",
    "configurationDone",
    "threads",
    "stackTrace",
    "scopes",
    "variables",
    "setVariable",
    "evaluate",
    "continue",
    "reverseContinue",
    "next",
    "stepIn",
    "stepOut",
    "stepBack",
    "pause",
    "setBreakpoints",
    "setFunctionBreakpoints",
    "setExceptionBreakpoints",
    "setDataBreakpoints",
    "dataBreakpointInfo",
    "exceptionInfo",
    "cancel",
    "attach",
    "terminate",
    "",
];

const ARGUMENTS: [&str; 16] = [
    "{}",
    "null",
    "[]",
    "3",
    r#"{"variablesReference":1}"#,
    r#"{"variablesReference":-9223372036854775808,"start":18446744073709551615,"count":18446744073709551615}"#,
    r#"{"variablesReference":1,"name":"N","value":"1e400"}"#,
    r#"{"variablesReference":1,"name":"N","value":"5"}"#,
    r#"{"expression":"N = 3","context":"repl"}"#,
    r#"{"expression":"to 18446744073709551615","context":"repl"}"#,
    r#"{"expression":"to 3","context":"repl"}"#,
    r#"{"expression":"discard key F","context":"repl"}"#,
    r#"{"expression":"N > 歩","context":"hover"}"#,
    r#"{"source":{"path":"debugged.prg"},"breakpoints":[{"line":9223372036854775807,"hitCondition":"% 0"},{"line":8,"condition":"N > 3","hitCondition":"% 3"}]}"#,
    r#"{"breakpoints":[{"name":"s","dataId":"P"},{"name":"PTP_ANGLE","dataId":"?"}],"filters":["fall"]}"#,
    r#"{"startFrame":-1,"levels":-1,"granularity":"instruction"}"#,
];

#[test]
fn every_request_with_every_argument_is_answered() {
    for command in COMMANDS {
        let requests = ARGUMENTS.map(|arguments| {
            format!(r#"{{"seq":9,"type":"request","command":"{command}","arguments":{arguments}}}"#)
        });
        examine(requests.join("\n").as_bytes());
    }
}

#[test]
fn requests_in_any_order_are_answered() {
    let mut random = Random::new(7);
    let mut below = |count| random.index(count);
    for _ in 0..30 {
        let requests: Vec<String> = (0..40)
            .map(|_| {
                let (command, arguments) = (COMMANDS[below(24)], ARGUMENTS[below(ARGUMENTS.len())]);
                format!(
                    r#"{{"seq":9,"type":"request","command":"{command}","arguments":{arguments}}}"#
                )
            })
            .collect();
        examine(requests.join("\n").as_bytes());
    }
}

#[test]
fn what_is_no_message_is_answered() {
    examine(b"{\n[]\n\"\"\n\xFF\n{}\nContent-Length: 3\r\n\r\n{}\n\nContent-Length: -1\r\n\r\n");
    examine(&b"[".repeat(100_000));
}
