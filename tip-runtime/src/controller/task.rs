//! The state that a command of several cycles keeps between them.

/// The command in progress.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Task {
    /// None.
    Idle,
    /// SLEEP: the cycles that are left.
    Sleep(f64),
    /// INITIAL_POSTURE: braking.
    Posture,
    /// STAND_UP and SIT_DOWN.
    Stand(Stand),
    /// DETECT_FLOOR by soles.
    DetectFloor(FloorSearch),
    /// DETECT_FLOOR and DETECT_OBJECT by touch.
    DetectTouch,
}

/// Phase of STAND_UP or SIT_DOWN.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stand {
    /// The feet come to rest where they are.
    Settling,
    /// The feet move.
    Moving,
}

/// The operand of DETECT_FLOOR by soles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FloorSearch {
    /// One leg after the other goes down.
    DownInTurn,
    /// All legs go down at once.
    DownTogether,
    /// All legs go up: the body sinks.
    Up,
}
