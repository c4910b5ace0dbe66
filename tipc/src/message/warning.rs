//! What is said of a program that loads.

use super::list::Quoted;
use super::phrase::{Assign, Lack, Stretch};

messages! {
    /// What the analysis warns of.
    Warning;

    Has { name: String, lack: Lack } "`{name}` has {lack}";
    Have { names: Quoted, lack: Lack } "{names} have {lack}";
    Assign { assign: Assign } "{assign}";
    NoValueOnWay { way: Stretch, assign: Assign } "no value on the way through {way}; {assign}";
}
