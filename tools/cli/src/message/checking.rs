//! What is said of programs that were checked, after the findings.

use super::count::{Errors, Files, Steps, Warnings};
use tipc::message::Text;

tipc::message_table! {
    /// What checks come to.
    Checking;

    Sound { file: Text, steps: Steps, robot: String, warnings: Warnings }
        "{file}: {steps} for {robot}, {warnings}",
        "{file}: {robot}用、{steps}、{warnings}";
    Faulty { file: Text, errors: Errors, warnings: Warnings }
        "{file}: {errors}, {warnings}",
        "{file}: {errors}、{warnings}";
    Total { files: Files, errors: Errors, warnings: Warnings }
        "{files}: {errors}, {warnings}",
        "{files}の合計: {errors}、{warnings}";
    Watching { files: Files }
        "watching {files}; Ctrl-C ends",
        "{files}の変更を待っています。Ctrl-Cで終わります";
    Again { count: usize }
        "check {count}",
        "{count}回目の検査";
}
