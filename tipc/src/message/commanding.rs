//! What is said of commands, their arguments, and the flags of conditions.

use super::list::{Alternatives, Both, List};
use super::phrase::{Bounds, Inventory, Lacking, Numbers, Standing, Type};
use smol_str::SmolStr;
use tip_runtime::command::Target;

messages! {
    /// What is said of commands.
    Commanding;

    // Which command.
    RobotLacks { robot: &'static str } "{robot} lacks this command";
    NeedsForces { command: &'static str } "{command} needs a robot that senses and gives torque: its description has no `[forces]`";
    CommandOf { command: &'static str, robots: Both } "{command} is a command of {robots}";
    VariableNotCommand "this is a variable, not a command";
    OperatorBehindVariable { name: SmolStr } "an equation has an operator behind its variable: `{name} = 0`";
    NoCommand "this is no command";
    CalledNow { command: &'static str } "this language calls it `{command}`";
    LabelOrEquation "a label ends with a colon, an equation has `=` behind its variable";

    // Arguments.
    Write { forms: Alternatives } "write {forms}";
    OtherType { command: SmolStr, wanted: Numbers, found: Type } "{command} wants {wanted} here, not {found}";
    TooFew { command: SmolStr, wanted: Numbers, found: Standing } "{command} wants {wanted}; {found} here";
    TooMany { command: SmolStr } "one argument too many for {command}";
    ToleranceElsewhere "SET_NEAR_POSITION and SET_NEAR_ANGLE set the tolerance";
    Missing { what: Lacking } "{what} is missing";
    FlagBeforeNumber { flag: SmolStr } "{flag} is a flag here: it stands before a number, and once";
    NoFlag { flag: SmolStr } "this command takes no {flag}";
    StructForNumber "a struct stands where one number belongs";
    NameMember "name a member, as `P.X` or `Q.J2`";
    ConstantOrVar "only a constant or a VAR can stand here";
    CopyIntoVar "copy the number into a VAR first";
    OutOfRange "out of range";
    Takes { command: SmolStr, bounds: Bounds, robot: &'static str } "{command} takes {bounds} on {robot}";

    // Targets.
    WantsTarget { command: SmolStr, targets: List } "{command} wants a target, as {targets}";
    TargetBelongsHere { targets: List } "a target belongs here, as {targets}";
    RobotHasNo { robot: &'static str, target: Target } "{robot} has no {target}";
    OtherTargets { command: SmolStr, target: Target, targets: List } "{command} takes no {target}; its targets are such as {targets}";
    RobotHas { inventory: Inventory } "{inventory}";

    // Variables to fill, inputs, native commands.
    PosVariable "a POS variable belongs here";
    JointVariable "a JOINT variable belongs here";
    VarOrJointMember "a VAR or a member of a JOINT belongs here";
    VarBelongsHere "a VAR belongs here";
    ConstantBelongsHere "a constant belongs here";
    OneBoard "there is one A/D board: number 0";
    Channels "the board has the channels 0…15";
    NoInput { robot: &'static str } "{robot} has no input of this name";
    Inputs { inventory: Inventory } "inputs are VR1…VR3, joints; {inventory}";
    InputsWith { others: List, inventory: Inventory } "inputs are VR1…VR3, joints, {others}; {inventory}";
    NativeCommands "native commands have the numbers 0…255";

    // FOR.
    NeverEnds "FOR never ends with a step of 0";
    CountOtherwise "count by another number, or leave STEP out to count by 1";
    CountsVar "the variable of a FOR is a VAR";
    CountVar "count a VAR, as `FOR I = 1 TO 10`";

    // Event flags.
    VariableNoCondition { name: SmolStr } "`{name}` is a variable; alone it is no condition";
    Compare { name: SmolStr } "compare it with something: `{name} <> 0`";
    NoEventFlag { robot: &'static str } "{robot} has no event flag of this name";
    Flags { inventory: Inventory } "flags are HALT_REQUEST, KB_HIT, INPOS_F1 and NEAR_F1 (or another target), SPECIAL_FLAG0…9; {inventory}";
    FlagsWith { others: List, inventory: Inventory } "flags are HALT_REQUEST, KB_HIT, INPOS_F1 and NEAR_F1 (or another target), SPECIAL_FLAG0…9, {others}; {inventory}";
}
