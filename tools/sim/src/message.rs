//! The messages of this crate: of the debugger, of the import of robots, and of plants in other processes.
//!
//! ```
//! use tip_sim::message::Debugging;
//!
//! assert_eq!(Debugging::Above.to_string(), "From above");
//! ```

mod debugging;
mod importing;
mod linting;
mod simulating;

pub use debugging::Debugging;
pub use importing::Importing;
pub use linting::Linting;
pub use simulating::Simulating;

use tipc::message::Text;

tipc::message_table! {
    /// A place in a file: line and column, from 1.
    Place;

    At { line: u32, column: u32 } "line {line}, column {column}", "{line}行{column}列";
}

tipc::message_table! {
    /// A kind of joint that URDF knows and no leg has.
    JointKind;

    Fixed "fixed", "固定(fixed)";
    Prismatic "prismatic", "直動(prismatic)";
    Floating "floating", "浮遊(floating)";
    Planar "planar", "平面(planar)";
    Spherical "spherical", "球(spherical)";
}

tipc::message_table! {
    /// The condition that ends a wait, in one word where the language has one.
    Awaited;

    Flags { names: Text } "{names}", "{names}";
    Key "a key", "キー入力";
    Motion "the end of its motion", "動作の完了";
    Touch "a contact", "接触";
    Native "its native code", "ネイティブコードの完了";
    Thread { name: Text } "the end of thread {name}", "スレッド{name}の終了";
}
