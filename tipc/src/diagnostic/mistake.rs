//! Identities of mistakes.

use crate::code::Code;
use smol_str::SmolStr;

/// A mistake that shows at several places: it is reported at the first of them, and the others are its labels. Words are
/// upper case unless they cannot be.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) enum MistakeId {
    /// A word that no name or number is: `STEP-LENGTH`, `0x1F`, the `WALK` of `WALK(3)`.
    Word(SmolStr),
    /// A word in full-width characters, in half-width ones and without its colon.
    FullWidth(SmolStr),
    /// A label in the form of another language, such as `*L1`, by its name here: its jumps are wrong in the same way.
    ForeignLabel(SmolStr),
    /// A variable that is not declared.
    Variable(SmolStr),
    /// A member that a variable lacks.
    Member {
        /// The rule that is broken.
        code: Code,
        variable: SmolStr,
        member: SmolStr,
    },
    /// A label that is missing.
    Label(SmolStr),
    /// Numbers of lines.
    LineNumbers,
    /// More threads than there may be.
    Threads,
    /// A SUBROUTINE or THREAD called LOOP.
    RoutineLoop,
    /// A title that was left out, so that a statement stands in its place.
    Title,
    /// Labels that stand after END.
    LabelsAfterEnd,
    /// POS or JOINT variables where numbers belong, by the index of the statement.
    StructForNumber(Option<usize>),
    /// Two NEXT that name the variables of each other's FOR, by the index of the first.
    CrossedNext(usize),
}
