//! What is said of labels, variables, and their use.

use super::phrase::Assign;
use smol_str::SmolStr;

messages! {
    /// What is said of names.
    Naming;

    // Labels and variables.
    WordOfLanguage { word: SmolStr } "`{word}` is a word of the language";
    ChooseAnother "choose another name";
    DeclaredAgain { name: SmolStr } "`{name}` is declared again";
    FirstDeclared "first declared here";
    DeclaredHere "declared here";

    // Labels.
    NoLabelName { word: SmolStr } "`{word}` is no name for a label";
    LabelCharacters "a label is made of letters, digits and `_`";
    OwnName "give each label a name of its own; only LOOP may stand more than once";
    SubroutineLoop "a SUBROUTINE cannot be named LOOP";

    // Variables.
    NoNames "this declaration names no variable";
    WriteNames "write the names behind it, separated by blanks or commas";
    ReadAsFlag "motion commands read this word as their flag";
    NoVariableName { word: SmolStr } "`{word}` is no name for a variable";
    VariableCharacters "a name is made of letters, digits and `_`, and does not start with a digit";
    DeclareOnce "declare it once";
    NotDeclared "this name is not declared";
    NoNumber { word: SmolStr } "`{word}` is a word of the language and stands for no number";
    Declare { name: SmolStr } "declare it: `DEF_VAR {name}`, `DEF_POS {name}` or `DEF_JOINT {name}`";
    NoMember { name: SmolStr, member: SmolStr } "`{name}` has no member `{member}`";
    VarMembers { name: SmolStr } "`{name}` is a VAR: it has no members";
    PosMembers { name: SmolStr } "`{name}` is a POS: it has the members X, Y, Z";
    JointMembers { name: SmolStr, last: usize } "`{name}` is a JOINT: on this robot it has the members J1…J{last}";

    // Use.
    NothingUses "nothing uses this name";
    NothingReads "nothing reads this variable";
    AssignedNowhere { name: SmolStr } "`{name}` is read here and assigned nowhere";
    AssignBefore { assign: Assign } "{assign}";
}
