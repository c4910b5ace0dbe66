//! Messages of tables that other crates define.

use super::Lang;
use super::say::Say;
use std::any::Any;
use std::fmt::{self, Debug, Formatter};
use std::sync::Arc;

/// A message of a table that another crate defines with [`message_table!`](crate::message_table).
#[derive(Clone)]
pub struct Other(Arc<dyn AnyMessage>);

/// What [`Other`] needs of a message.
trait AnyMessage: Any + Debug + Say + Send + Sync {
    /// Returns true if the other message is of the same table and row, with the same arguments.
    fn equals(&self, other: &dyn Any) -> bool;
}

impl<T: Any + Debug + PartialEq + Say + Send + Sync> AnyMessage for T {
    fn equals(&self, other: &dyn Any) -> bool {
        other.downcast_ref() == Some(self)
    }
}

impl Other {
    /// Wraps a message of any table.
    #[doc(hidden)]
    pub fn new(message: impl Any + Debug + PartialEq + Say + Send + Sync) -> Self {
        Other(Arc::new(message))
    }

    /// Returns the message if it is of the table `T`.
    pub fn get<T: Any>(&self) -> Option<&T> {
        let message: &dyn Any = &*self.0;
        message.downcast_ref()
    }
}

impl Debug for Other {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl PartialEq for Other {
    fn eq(&self, other: &Self) -> bool {
        self.0.equals(&*other.0)
    }
}

impl Say for Other {
    fn say(&self, lang: Lang, f: &mut Formatter<'_>) -> fmt::Result {
        self.0.say(lang, f)
    }
}
