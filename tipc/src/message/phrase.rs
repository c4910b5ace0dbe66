//! Parts of messages that vary: an argument that is more than a word or a number.

use smol_str::SmolStr;

messages! {
    /// The end of a statement, behind which nothing may stand.
    End;

    Word { word: SmolStr } "{word}";
    Label "the label";
    Condition "the condition";
    NextAndVariable "NEXT and its variable";
    SubroutineAndName "SUBROUTINE and its name";
}
