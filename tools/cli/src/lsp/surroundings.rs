//! What is around a program: its robot, and pages to read about its findings.

use std::path::Path;
use std::rc::Rc;
use tipc::Options;
use tipc::diagnostic::Diagnostic;
use tipc::message::Lang;

/// What a server asks of the machine that it runs on.
pub(crate) trait Surroundings {
    /// The robot of a file, if it is one; `asked` is what the editor's settings name. Complaints are in this language.
    fn robot(&mut self, path: Option<&Path>, asked: Option<&str>, lang: Lang) -> Rc<Chosen>;

    /// The warning that the crate around a file compiles it for another robot; `asked` is what the editor's settings name.
    fn other_robot(&mut self, path: &Path, asked: Option<&str>) -> Option<Diagnostic>;

    /// The address of a page about a code.
    fn page(&mut self, code: &str, lang: Lang) -> Option<String>;

    /// How the nearest `tip.toml` says that a file spells text: a name that it has for an encoding.
    fn encoding(&mut self, path: &Path) -> Option<String>;

    /// Files are others now.
    fn forget(&mut self);
}

/// What a program is checked for.
pub(crate) struct Chosen {
    pub(crate) options: Options,
    /// The robot's geometry.
    pub(crate) robot: Option<tip_sim::Robot>,
    /// Why it is not the one that was asked for.
    pub(crate) complaint: Option<String>,
}
