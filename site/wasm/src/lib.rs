//! Compiler, reference interpreter, runtime and plants behind one function, as a page without a server needs them.

mod answer;
mod ask;
#[cfg(target_arch = "wasm32")]
mod exports;
mod workbench;

pub use ask::{Ask, Task, Text};
pub use workbench::{Missing, Workbench};

/// Answers a question: both are JSON, of [`Ask`] and of what its task gives. What cannot be answered gives
/// `{"error": …}`.
pub fn answer(question: &str) -> String {
    let asked: Result<Ask, _> = serde_json::from_str(question);
    let answer = match asked {
        Ok(ask) => answer::answer(&ask),
        Err(error) => answer::error(&error),
    };
    answer.to_string()
}
