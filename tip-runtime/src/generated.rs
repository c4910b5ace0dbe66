//! What generated code is made of. It is no part of the public API: [`version`](crate::version) ties generated
//! code to this crate.

use crate::command::Command;
use crate::fault::Fault;
use crate::program::{Context, Flow};

/// What a state does.
pub type Run<P> = fn(&mut P, &mut dyn Context) -> Result<Flow, Fault>;

/// A row of a program's table of states. The number is the step that comes next.
#[derive(Clone, Copy, Debug)]
pub enum Step<P: 'static> {
    /// Asks for a command of constants, and goes on when it is done.
    Ask(&'static Command<'static>, u32),
    /// Only goes on.
    Go(u32),
    /// Needs code.
    Run(Run<P>),
}
