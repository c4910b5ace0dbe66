//! The messages of the command.

mod checking;
pub(crate) mod count;
mod making;
pub(crate) mod running;
mod stopping;
mod using;

pub(crate) use checking::Checking;
pub(crate) use making::Making;
pub(crate) use running::Running;
pub(crate) use stopping::Stopping;
pub(crate) use using::Using;
