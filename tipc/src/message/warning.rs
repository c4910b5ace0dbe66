//! What is said of a program that loads.

use super::list::Quoted;
use super::phrase::{Assign, Lack, Stretch};

messages! {
    /// What the analysis warns of.
    Warning;

    Has { name: String, lack: Lack }
        "`{name}` has {lack}",
        "`{name}` には、{lack}";
    Have { names: Quoted, lack: Lack }
        "{names} have {lack}",
        "{names} には、{lack}";
    Assign { assign: Assign } "{assign}", "{assign}";
    NoValueOnPath { path: Stretch, assign: Assign }
        "no value on the path through {path}; {assign}",
        "{path}を通る経路では値がありません。{assign}";
}
