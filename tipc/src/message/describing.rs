//! What is said of descriptions of robots, and of scenes.

use super::list::List;
use super::phrase::{Joints, Kind, Table};

messages! {
    /// What the reader of descriptions and scenes says.
    Describing;

    // Any table of the file.
    NotToml { error: String } "{error}";
    DescriptionsAreToml "descriptions are TOML: `key = value`, `[table]`, `[[one of many tables]]`";
    Lacks { table: Table, key: &'static str } "{table} lacks `{key}`";
    KeyMeans { key: &'static str, form: &'static str, meaning: &'static str } "`{key}` is {form}: {meaning}";
    KeyIs { key: String, form: &'static str } "`{key}` is {form}";
    NoKey { table: Table, key: String } "{table} has no key `{key}`";
    BelongsTo { key: String, table: Table } "`{key}` belongs to {table}";
    KeysOf { table: Table, keys: List } "the keys of {table} are {keys}";
    NumbersBelongHere { wanted: usize, found: usize } "{wanted} numbers belong here, and there are {found}";
    Above { min: f64, max: f64 } "{min} is above {max}";
    CannotBeThis { key: String } "`{key}` cannot be this";
    OutOfReach { most: f64 } "a number from -{most} to {most} belongs here";
    NotBelowZero "it cannot be below 0";
    AboveZero "it must be above 0";
    WrongKind { kind: Kind } "{kind} cannot stand here";

    // The robot's name.
    NeedsName "a robot needs a name";
    BlankAtEnd "a name neither begins nor ends with a blank";
    NameTooLong { most: usize } "a name has {most} characters at most";
    NotInName { character: char } "{character:?} cannot stand in a name";
    KnownRobot "this is the name of a robot that the compiler knows itself";

    // Legs and joints.
    NumberOfLegs { most: usize, found: usize } "a robot has 1 to {most} legs, and here are {found}";
    NoJoints { leg: usize } "leg F{leg} has no joints";
    DescribeJoints "describe them under [[joint]], for every leg, or under [[leg.joint]], for this one";
    NoLength { leg: usize } "leg F{leg} has no length";
    OneLinkNotZero "the link of one joint at least is not [0, 0, 0]";
    OtherNumberOfJoints { leg: usize, joints: Joints, first: usize } "leg F{leg} has {joints}, F1 has {first}";
    SameNumberOfJoints "every leg needs the same number of joints: the language names them J1…Jn";
    NumberOfJoints { most: usize, found: usize } "a leg has 1 to {most} joints, and here are {found}";
    OuterContainsLimits { min: f64, max: f64 } "the outer limits must contain the working limits {min} to {max}";
    NoDirection "an axis of length 0 has no direction";
    NoCoordinate { letter: char } "{letter:?} is no coordinate, or stands here twice";
    OtherNumberOfAngles { angles: usize, joints: Joints } "the initial posture has {angles} angles, the leg has {joints}";
    InitialOutside { angle: f64, joint: usize, min: f64, max: f64 } "the initial angle {angle} of joint {joint} is outside its limits {min} to {max}";
    JointsOfLeg { leg: usize, wanted: &'static str } "the joints of leg F{leg} {wanted}";

    // Settings.
    SamplingTimes { min: f64, max: f64 } "the robot accepts sampling times of {min} to {max} ms only";
    NoNumberOfLamps "this is no number of lamps";
    SliderOutside { at: f64 } "the slider stands at {at} first, which is outside";

    // Scenes.
    BothShapes "an object cannot have both `size` and `radius`";
    NoShape "an object needs `size` or `radius`";
    Shapes "a box has `size = [width, height]`, a disc `radius`, in mm";
    Simulated { error: String } "{error}";
    TakeOneAway "take one of them away";
    RadiusUnit "`radius` is in mm";
    SizeUnit "`size` is in mm";
    MassUnit "`mass` is in kg";
    OnlyNumbers "only numbers belong here";
}
