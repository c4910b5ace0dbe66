//! What is said of labels, variables, and their use.

use super::phrase::Assign;
use smol_str::SmolStr;

messages! {
    /// What is said of names.
    Naming;

    // Labels and variables.
    WordOfLanguage { word: SmolStr }
        "`{word}` is a word of the language",
        "`{word}` はこの言語の予約語です";
    ChooseAnother
        "choose another name",
        "別の名前にしてください";
    DeclaredAgain { name: SmolStr }
        "`{name}` is declared again",
        "`{name}` が二重に宣言されています";
    FirstDeclared
        "first declared here",
        "最初の宣言はここです";
    DeclaredHere
        "declared here",
        "宣言はここです";

    // Labels.
    NoLabelName { word: SmolStr }
        "`{word}` cannot name a label",
        "`{word}` はラベル名に使えません";
    LabelCharacters
        "a label is made of letters, digits and `_`",
        "ラベル名に使えるのは英字、数字、`_` です";
    OwnName
        "give each label a name of its own; only LOOP may stand more than once",
        "ラベルには別々の名前を付けてください。何度も使えるのはLOOPだけです";
    SubroutineLoop
        "a SUBROUTINE cannot be named LOOP",
        "SUBROUTINEにLOOPという名前は付けられません";

    // Variables.
    NoNames
        "this declaration names no variable",
        "宣言に変数名がありません";
    WriteNames
        "write the names after it, separated by blanks or commas",
        "後に変数名を、空白かコンマで区切って書いてください";
    ReadAsFlag
        "motion commands read this word as their flag",
        "移動系コマンドはこの語をフラグとして読みます";
    FlagHere
        "the flag, not the variable",
        "変数ではなくフラグです";
    NoVariableName { word: SmolStr }
        "`{word}` cannot name a variable",
        "`{word}` は変数名に使えません";
    VariableCharacters
        "a name is made of letters, digits and `_`, and does not start with a digit",
        "名前に使えるのは英字、数字、`_` で、先頭に数字は使えません";
    DeclareOnce
        "declare it once",
        "宣言は一度だけにしてください";
    NotDeclared { name: SmolStr }
        "`{name}` is not declared",
        "`{name}` は宣言されていません";
    NoNumber { word: SmolStr }
        "`{word}` is a word of the language and does not stand for a number",
        "`{word}` はこの言語の予約語で、数値にはなりません";
    NumberBelongsHere
        "a number or a variable belongs here",
        "ここには数値か変数を書きます";
    Declare { name: SmolStr }
        "declare it: `DEF_VAR {name}`, `DEF_POS {name}` or `DEF_JOINT {name}`",
        "`DEF_VAR {name}`、`DEF_POS {name}`、`DEF_JOINT {name}` のどれかで宣言してください";
    DeclareAs { declaration: SmolStr }
        "declare it: `{declaration}`",
        "`{declaration}` と宣言してください";
    AlsoHere
        "used here too",
        "ここでも使われています";
    NoMember { name: SmolStr, member: SmolStr }
        "`{name}` has no member `{member}`",
        "`{name}` に `{member}` というメンバはありません";
    VarMembers { name: SmolStr }
        "`{name}` is a VAR: it has no members",
        "`{name}` はVAR型で、メンバはありません";
    PosMembers { name: SmolStr }
        "`{name}` is a POS: it has the members X, Y, Z",
        "`{name}` はPOS型で、メンバはX、Y、Zです";
    JointMembers { name: SmolStr, last: usize }
        "`{name}` is a JOINT: on this robot it has the members J1…J{last}",
        "`{name}` はJOINT型で、このロボットではメンバはJ1…J{last}です";

    // Use.
    NothingUses
        "nothing uses this name",
        "この名前はどこでも使われていません";
    NothingReads
        "nothing reads this variable",
        "この変数はどこでも読まれていません";
    AssignedNowhere { name: SmolStr }
        "`{name}` is read here and never assigned",
        "`{name}` はここで読まれますが、どこでも代入されていません";
    AssignBefore { assign: Assign } "{assign}", "{assign}";
}
