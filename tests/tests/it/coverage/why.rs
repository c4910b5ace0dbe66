//! Why a cell cannot occur: the words that stand in it, explained.

/// Each word with what it means, in the order of the legend.
pub const WORDS: &[(&str, &str)] = &[
    (
        "no such command",
        "the robot lacks the command: nothing else can be wrong with it",
    ),
    ("known", "the robot has the command"),
    (
        "no such target",
        "the robot lacks this sort of target or input",
    ),
    ("has it", "the robot has it, and there is but one"),
    ("no target", "the form has no target"),
    ("no argument", "the form has no argument"),
    ("no operand", "the form has no operand"),
    (
        "optional",
        "with an argument more or less it is another form of the command",
    ),
    ("reads nothing", "no operand of the form is read"),
    ("no limit", "every value will do"),
    (
        "always finite",
        "the result is a finite number for all operands",
    ),
    (
        "no native code",
        "the robot has no native commands of its own",
    ),
    ("no palm", "the robot has no palm"),
    (
        "others turn",
        "where a joint is at its limit the others of the finger go on",
    ),
    (
        "later",
        "where torques, springs and searches end depends on what is around; if at a limit, it is a fault of a later step",
    ),
    ("no sensor", "it feels with torques"),
    ("passes", "with ALL it passes"),
    ("no text", "the form has no text"),
    ("no jump", "the form names no label"),
    ("no call", "the form calls nothing"),
    ("names nothing", "the form declares no name"),
];
