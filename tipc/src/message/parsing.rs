//! What is said of the form of lines and statements.

use super::phrase::End;
use smol_str::SmolStr;

messages! {
    /// What parsing says.
    Parsing;

    // Lines 1 and 2.
    OtherVersion { wanted: f64 } "this compiler reads version {wanted:?}";
    NoVersion "line 1 names no version";
    MoreThanVersion "line 1 holds the version number and nothing else";
    StartWithVersion { wanted: f64 } "start the file with the line `{wanted:?}`";

    // Lines.
    LineTooLong { limit: usize } "this line has more than {limit} bytes";
    BreakTheLine "break the line; a full-width character counts 2 bytes";
    ProgramEndsHere "the program ends here without END";
    PutEnd "put END on a line of its own behind the last statement";
    ControlCharacter "a control character cannot stand here";
    ForeignCharacters "only comments, MESSAGE and REM may hold such characters";
    WriteHalfWidth { narrow: String } "write it half-width: `{narrow}`";
    NotAlone { word: SmolStr } "{word} must be alone on its line";
    WantsOwnLine "this wants a line of its own";
    LabelBeforeCommentBehind "only a label may stand before it, and a comment behind it";
    NothingBehind { end: End } "nothing may stand behind {end}";
    NextStatementElsewhere "start the next statement on a line of its own, or behind `;`";

    // Labels, names and jumps.
    NameTooLong { limit: usize, length: usize } "a name has at most {limit} bytes, this one {length}";
    LabelNameMissing "the label's name is missing before this colon";
    LabelBelongsHere "a label belongs here";
    LabelMissing "a label is missing here";
    WriteJump { jump: SmolStr } "write `{jump} L1:`";
    BlankBeforeColon "no blank may stand before this colon";
    LabelColonMissing "the label's colon is missing";
    WriteLabel { name: SmolStr } "write `{name}:`";
    OnlyNames "only names can be declared";
    SeparateNames "separate the names by blanks or commas; every variable starts unassigned";

    // MESSAGE.
    BlankBehindMessage "a blank must stand between MESSAGE and its text";
    TextEndsHere "the text ends here";
    CommentElsewhere "put the comment on a line of its own";
    LineBreak "the message line is one line: it cannot be broken";
    Escapes "`\\a` (bell) and `\\t` (tab) are what a text may hold";
    TextTooLong { limit: usize } "a MESSAGE has at most {limit} bytes";
    FullWidthCounts "a full-width character counts 2 bytes";

    // Control structure.
    IfCannotCall "IF cannot CALL";
    GosubCalls "GOSUB calls a SUBROUTINE as well: `IF … GOSUB NAME:`";
    ThenOrJumpBelongsHere "THEN, GOTO or GOSUB belongs here";
    WriteThenOrJump "write THEN for a block, or GOTO or GOSUB and a label";
    ThenBelongsHere "THEN belongs here";
    ToBelongsHere "TO belongs here";
    ForEnds "FOR ends before this";
    VariableBelongsHere "a variable belongs here";
    AssignmentBelongsHere "`=` belongs here";
    WriteFor "write `FOR I = 1 TO 10`, or `FOR I = 10 TO 0 STEP -2`";
    NextNamesItsVariable "NEXT names the variable of its FOR, or nothing";
    NameBelongsHere "a name belongs here";
    NameMissing "the name is missing here";
    NameColonMissing "the name's colon is missing";
    WriteSubroutine { name: SmolStr } "write `SUBROUTINE {name}:`";

    // Conditions.
    ConditionMissing "a condition is missing here";
    NotStandsBeforeFlag "`!` stands right before an event flag, without a blank";
    NoRelation "no relation is written like this";
    CannotStandHere { text: SmolStr } "`{text}` cannot stand here";
    AssignsComparesNothing "`=` assigns; it compares nothing";
    ConditionCannotCalculate "a condition cannot calculate";
    RelationBelongsHere "a relation belongs here";
    ComparedWithNothing "this is compared with nothing";
    Conditions "a condition is a comparison of two numbers, as `A >= 5`, or an event flag, as `KB_HIT` or `!KB_HIT`";
    Relations "the relations are `==` (equal), `<>` (not equal), `<`, `>`, `<=`, `>=`";

    // Equations.
    OneVariableLeft "one variable stands left of the `=`";
    ConstantAssigned "a constant cannot be assigned";
    StartsWithVariable "an equation starts with a variable";
    LeftSide "the left side is a variable or a member, as `A` or `P.X`, without sign";
    OperatorOrNothing "`+`, `-`, `*`, `/` or nothing can stand here";
    EquationEnds "the equation ends before this";
    FunctionCannotStandHere { function: SmolStr } "{function} cannot stand here";
    OneOperation "an equation holds one operation or one function; use a variable for what comes between";

    // Operands.
    NoOperand { text: SmolStr } "`{text}` stands where an operand belongs";
    OperandMissing "an operand is missing here";
    OperandMissingBefore { word: SmolStr } "an operand is missing before {word}";
    BetweenArguments { text: SmolStr } "`{text}` stands between two arguments";
    SeparateArguments "arguments are separated by blanks or commas; a sign stands right before its number or name";
    SignStandsBefore "a sign stands right before its number or name, without a blank";
    PlusBeforeConstants "`+` stands only before constants";
    LeavePlusOut "leave the `+` out";
    ConstantTooLarge "this constant is too large";
    NoNumber { word: SmolStr } "`{word}` is no number";
    Constants "a constant is decimal, as `12`, `-0.5` or `1.5E3`; a name starts with a letter or `_`";
    NoMember { word: SmolStr } "`{word}` is no member";
    Members "a member is written `P.X` or `Q.J2`";
    ForeignInName { character: SmolStr } "`{character}` can stand in no name and no number";
    NoParentheses "the language has no parentheses: one operation an equation, and `SIN A` for a function";
    NameCharacters "a name is made of letters, digits and `_`";
}
