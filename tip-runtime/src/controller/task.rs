//! What a command that takes several cycles remembers between them.

/// The command under way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Task<const L: usize> {
    /// None.
    Idle,
    /// SLEEP: the cycles that are left.
    Sleep(f64),
    /// INITIAL_POSTURE: braking.
    Posture,
    /// STAND_UP and SIT_DOWN.
    Stand(Stand),
    /// DETECT_FLOOR by soles.
    Detect(Search<L>),
    /// DETECT_FLOOR and DETECT_OBJECT by touch.
    Feel(Feeling<L>),
}

/// How far STAND_UP or SIT_DOWN has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stand {
    /// The feet come to rest where they are.
    Settling,
    /// The feet move.
    Moving,
}

/// DETECT_FLOOR by soles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Search<const L: usize> {
    pub(super) course: Course,
    /// Which legs have still to find what they look for.
    pub(super) looking: [bool; L],
}

/// The operand of DETECT_FLOOR by soles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Course {
    /// One leg after the other goes down.
    DownInTurn,
    /// All legs go down at once.
    DownTogether,
    /// All legs go up: the body sinks.
    Up,
}

/// A search by touch: for how many cycles each finger has been still; `None` for one that does not
/// search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Feeling<const L: usize> {
    pub(super) still: [Option<u16>; L],
}
