//! The texts about bytes, about the form of lines and statements, and to build scripts.

use super::Text;
use super::list::{Alternatives, OneOf};
use super::phrase::End;
use smol_str::SmolStr;

messages! {
    /// Messages of the parser.
    Parsing;

    // Lines 1 and 2.
    OtherVersion { wanted: OneOf }
        "line 1 must name version {wanted} of the language",
        "1行目には言語のバージョン{wanted}を書きます";
    NoVersion
        "line 1 must hold the version number of the language",
        "1行目には言語のバージョン番号を書きます";
    MoreThanVersion
        "line 1 holds the version number and nothing else",
        "1行目にはバージョン番号だけを書きます";
    StartWithVersion { wanted: Alternatives }
        "start the file with the line {wanted}",
        "ファイルの1行目を {wanted} にしてください";

    // Lines.
    LineTooLong { limit: usize } ["E105-02"]
        "this line has more than {limit} bytes",
        "この行は{limit}バイトを超えています";
    BreakTheLine
        "break the line; a full-width character counts 2 bytes",
        "行を分けてください。全角文字は1文字2バイトと数えます";
    ProgramEndsHere
        "the program ends here without END",
        "ENDがないままプログラムが終わっています";
    PutEnd
        "put END on a line of its own after the last statement",
        "最後の文の後に、ENDだけの行を置いてください";
    ControlCharacter ["E105-01"]
        "a control character cannot stand here",
        "ここに制御文字は書けません";
    ForeignCharacters ["E105-01"]
        "only comments, MESSAGE and REM may hold such characters",
        "このような文字を書けるのは、コメント、MESSAGE、REMの中だけです";
    WriteHalfWidth { narrow: String }
        "write it half-width: `{narrow}`",
        "半角で書いてください: `{narrow}`";
    TakeOut
        "take it out, or make it a comment with `//`",
        "取るか、前に `//` を付けてコメントにしてください";
    PlainNames
        "names and words are made of A-Z, 0-9 and `_`",
        "名前や語に使えるのはA-Z、0-9、`_` です";
    NotAlone { word: SmolStr } ["E105-03"]
        "{word} must be alone on its line",
        "{word}は1行に単独で書きます";
    WantsOwnLine
        "this needs a line of its own",
        "これは別の行に書く必要があります";
    LabelBeforeCommentBehind
        "only a label may stand before it, and a comment after it",
        "前に書けるのはラベルだけ、後に書けるのはコメントだけです";
    NothingBehind { end: End } ["E205-26"]
        "nothing may stand after {end}",
        "{end}の後には何も書けません";
    NextStatementElsewhere
        "start the next statement on a line of its own, or after `;`",
        "次の文は新しい行か `;` の後に書いてください";

    // Labels, names and jumps.
    NameTooLong { limit: usize, length: usize } ["E105-02"]
        "a name has at most {limit} bytes, this one {length}",
        "名前は{limit}バイトまでですが、これは{length}バイトあります";
    LabelNameMissing ["E205-19"]
        "the label's name is missing before this colon",
        "このコロンの前にラベル名がありません";
    LabelBelongsHere ["E205-19"]
        "a label belongs here",
        "ここにはラベルを書きます";
    LabelMissing ["E205-19"]
        "a label is missing here",
        "ここにラベルがありません";
    WriteJump { jump: SmolStr }
        "write `{jump} L1:`",
        "`{jump} L1:` のように書いてください";
    BlankBeforeColon ["E205-19"]
        "no blank may stand before this colon",
        "コロンの前に空白は置けません";
    LabelColonMissing ["E204-04" "E205-19"]
        "the label's colon is missing",
        "ラベルの後のコロンがありません";
    WriteLabel { name: SmolStr }
        "write `{name}:`",
        "`{name}:` と書いてください";
    OnlyNames ["E205-23"]
        "only names can be declared",
        "宣言できるのは変数名だけです";
    SeparateNames
        "separate the names by blanks or commas; every variable starts unassigned",
        "変数名は空白かコンマで区切ります。初期値は書けません。宣言の後で代入してください";

    // MESSAGE.
    BlankBehindMessage ["E205-27"]
        "a blank must stand between MESSAGE and its text",
        "MESSAGEと文字列の間には空白が必要です";
    TextEndsHere
        "the text ends here",
        "文字列はここで終わります";
    CommentElsewhere
        "put the comment on a line of its own",
        "コメントは別の行に書いてください";
    LineBreak ["E105-05"]
        "the message line is one line: it cannot be broken",
        "メッセージは1行です。改行はできません";
    Escapes
        "`\\a` (bell) and `\\t` (tab) are what a text may hold",
        "文字列に書けるのは `\\a` (ベル)と `\\t` (タブ)です";
    TextTooLong { limit: usize }
        "a MESSAGE has at most {limit} bytes",
        "MESSAGEの文字列は{limit}バイトまでです";
    FileTextTooLong { limit: usize }
        "an F_MESSAGE has at most {limit} bytes",
        "F_MESSAGEの文字列は{limit}バイトまでです";
    FullWidthCounts
        "a full-width character counts 2 bytes",
        "全角文字は1文字2バイトと数えます";

    // Control structure.
    IfCannotCall ["E205-17"]
        "IF cannot CALL",
        "IFからCALLはできません";
    GosubCalls
        "GOSUB calls a SUBROUTINE as well: `IF … GOSUB NAME:`",
        "GOSUBでもSUBROUTINEを呼べます: `IF … GOSUB NAME:`";
    ThenOrJumpBelongsHere ["E205-17"]
        "THEN, GOTO or GOSUB belongs here",
        "ここにはTHEN、GOTO、GOSUBのどれかを書きます";
    WriteThenOrJump
        "write THEN for a block, or GOTO or GOSUB and a label",
        "ブロックにするならTHEN、ジャンプするならGOTOかGOSUBとラベルを書いてください";
    ThenBelongsHere ["E205-17"]
        "THEN belongs here",
        "ここにはTHENを書きます";
    ToBelongsHere ["E205-18"]
        "TO belongs here",
        "ここにはTOを書きます";
    ForEnds ["E205-18"]
        "FOR ends before this",
        "FORの文はこの前で終わりです";
    VariableBelongsHere ["E205-18"]
        "a variable belongs here",
        "ここには変数を書きます";
    AssignmentBelongsHere ["E205-18"]
        "`=` belongs here",
        "ここには `=` を書きます";
    WriteFor
        "write `FOR I = 1 TO 10`, or `FOR I = 10 TO 0 STEP -2`",
        "`FOR I = 1 TO 10` や `FOR I = 10 TO 0 STEP -2` のように書いてください";
    NextNamesItsVariable ["E205-18"]
        "NEXT names the variable of its FOR, or nothing",
        "NEXTには対応するFORの変数を書くか、何も書きません";
    NameBelongsHere ["E205-19"]
        "a name belongs here",
        "ここには名前を書きます";
    NameMissing ["E205-19"]
        "the name is missing here",
        "ここに名前がありません";
    NameColonMissing ["E205-19"]
        "the name's colon is missing",
        "名前の後のコロンがありません";
    WriteSubroutine { name: SmolStr }
        "write `SUBROUTINE {name}:`",
        "`SUBROUTINE {name}:` と書いてください";
    WriteThread { name: SmolStr }
        "write `THREAD {name}:`",
        "`THREAD {name}:` と書いてください";
    WriteDefine
        "write DEFINE as `DEFINE STEP_LENGTH 90`: one name and one constant",
        "DEFINEは `DEFINE STEP_LENGTH 90` のように、名前一つと定数一つを書きます";

    // Conditions.
    ConditionMissing ["E205-14"]
        "a condition is missing here",
        "ここに条件式がありません";
    NotStandsBeforeFlag ["E205-16"]
        "`!` stands right before an event flag, without a blank",
        "`!` はイベントフラグの直前に、空白なしで書きます";
    NoRelation ["E205-15"]
        "this is not a relation",
        "このような関係演算子はありません";
    CannotStandHere { text: SmolStr } ["E205-16"]
        "`{text}` cannot stand here",
        "ここに `{text}` は書けません";
    AssignsComparesNothing ["E205-15"]
        "`=` assigns; `==` compares",
        "`=` は代入です。比較は `==` です";
    ConditionCannotCalculate ["E205-16"]
        "a condition cannot calculate",
        "条件式の中では計算できません";
    RelationBelongsHere ["E205-15"]
        "a relation belongs here",
        "ここには関係演算子を書きます";
    ComparedWithNothing ["E205-14"]
        "this is compared with nothing",
        "比較する相手がありません";
    Conditions
        "a condition is a comparison of two numbers, as `A >= 5`, or an event flag, as `KB_HIT` or `!KB_HIT`",
        "条件式は `A >= 5` のような2つの数値の比較か、`KB_HIT` や `!KB_HIT` のようなイベントフラグです";
    Relations
        "the relations are `==` (equal), `<>` (not equal), `<`, `>`, `<=`, `>=`",
        "関係演算子は `==` (等しい)、`<>` (等しくない)、`<`、`>`、`<=`、`>=` です";

    // Equations.
    OneVariableLeft ["E107-01"]
        "one variable stands left of the `=`",
        "`=` の左に書けるのは変数1つだけです";
    ConstantAssigned ["E107-01"]
        "a constant cannot be assigned",
        "定数には代入できません";
    StartsWithVariable ["E107-01"]
        "an equation starts with a variable",
        "式は変数で始まります";
    LeftSide
        "the left side is a variable or a member, as `A` or `P.X`, without a sign",
        "左辺は `A` や `P.X` のような、符号のない変数かメンバです";
    OperatorOrNothing ["E107-02"]
        "`+`, `-`, `*`, `/` or nothing can stand here",
        "ここに書けるのは `+`、`-`、`*`、`/` だけです";
    EquationEnds ["E107-02"]
        "the equation ends before this",
        "式はこの前で終わりです";
    NoSuchFunction { word: SmolStr } ["E107-05"]
        "there is no function {word}",
        "{word}という関数はありません";
    FunctionCannotStandHere { function: SmolStr } ["E107-02"]
        "{function} cannot stand here",
        "ここに{function}は書けません";
    OneOperation
        "an equation holds one operation or one function; use a variable for what comes between",
        "1つの式に書けるのは演算1つか関数1つです。途中の値は変数に入れてください";

    // Operands.
    NoOperand { text: SmolStr } ["E107-05" "E205-25"]
        "`{text}` stands where an operand belongs",
        "数値か変数を書くところに `{text}` があります";
    OperandMissing ["E107-03" "E205-01"]
        "an operand is missing here",
        "ここに数値か変数がありません";
    WriteEquation
        "write `A = B`, `A = B + C` or `A = SIN B`",
        "`A = B`、`A = B + C`、`A = SIN B` のように書いてください";
    OperandMissingBefore { word: SmolStr } ["E205-01"]
        "an operand is missing before {word}",
        "{word}の前に数値か変数がありません";
    BetweenArguments { text: SmolStr } ["E107-04" "E205-24"]
        "`{text}` stands between two arguments",
        "2つの引数の間に `{text}` があります";
    SeparateArguments
        "arguments are separated by blanks or commas; a sign stands right before its number or name",
        "引数は空白かコンマで区切ります。符号は数値や変数名の直前に書きます";
    SignStandsBefore ["E107-04" "E205-24"]
        "a sign stands right before its number or name, without a blank",
        "符号は数値や変数名の直前に、空白なしで書きます";
    PlusBeforeConstants ["E107-04" "E205-24"]
        "`+` stands only before constants",
        "`+` を付けられるのは定数だけです";
    LeavePlusOut
        "leave the `+` out",
        "`+` を取ってください";
    ConstantTooLarge ["E107-05" "E205-25"]
        "this constant is too large",
        "この定数は大きすぎます";
    NoNumber { word: SmolStr } ["E107-05" "E205-25"]
        "`{word}` is not a number",
        "`{word}` は数値ではありません";
    Constants
        "a constant is decimal, as `12`, `-0.5` or `1.5E3`; a name starts with a letter or `_`",
        "定数は `12`、`-0.5`、`1.5E3` のような10進数です。名前は英字か `_` で始まります";
    NoMember { word: SmolStr } ["E107-05" "E205-25"]
        "`{word}` is not a member",
        "`{word}` というメンバはありません";
    Members
        "a member is written `P.X` or `Q.J2`",
        "メンバは `P.X` や `Q.J2` のように書きます";
    ForeignInName { character: SmolStr } ["E107-05" "E205-25"]
        "`{character}` cannot be part of a name or a number",
        "名前や数値の中に `{character}` は書けません";
    NoParentheses
        "the language has no parentheses: one operation an equation, and `SIN A` for a function",
        "この言語に括弧はありません。1つの式に演算は1つ、関数は `SIN A` のように書きます";
    NameCharacters
        "a name is made of letters, digits and `_`",
        "名前に使えるのは英字、数字、`_` です";
}

messages! {
    /// Messages about reading files.
    Reading;

    System { error: Text } "{error}", "{error}";
    NoFile
        "there is no such file: check its name and its folder",
        "このファイルはありません。名前とフォルダを確かめてください";
    NotAllowed
        "the file may not be read: check its permissions",
        "ファイルを読む権限がありません。アクセス権を確かめてください";
    TwoFiles { first: Text, second: Text }
        "the path leads to two files, {first} and {second}; write a path that leads to one of them only",
        "このパスには{first}と{second}の二つのファイルがあります。どちらか一方だけを指すパスにしてください";
    Folder
        "this is a folder: name the files in it, as FOLDER/*.prg",
        "これはフォルダです。フォルダ/*.prg のように中のファイルを指定してください";
    NotRegular
        "this is a device, a pipe or a socket, which may never end: name a regular file",
        "これはデバイス、パイプ、またはソケットで、読み込みが終わらないことがあります。通常のファイルを指定してください";
    TooLarge { limit: usize }
        "the file is larger than {limit} MiB, the limit: split it, or check that it is the right file",
        "ファイルが上限の{limit} MiBを超えています。分割するか、正しいファイルかどうか確かめてください";
    Changed
        "the file has changed since it was read, and is left as it is: read it again",
        "読み込んだ後にファイルが変更されたため、書き込みませんでした。もう一度読み込んでください";
    Linked
        "a link to another file has taken the place of the file, and is not followed",
        "ファイルが別のファイルへのリンクに置き換わっています。リンクはたどりません";
    NotValid { byte: usize, encoding: &'static str } ["E105-06"]
        "byte {byte} of the file is not valid {encoding}",
        "ファイルの{byte}バイト目が{encoding}として正しくありません";
    NotTheOtherEither { encoding: &'static str, byte: usize }
        "the file is not {encoding} either (byte {byte}); save it in one of the two encodings",
        "{encoding}でもありません({byte}バイト目)。どちらかの文字コードで保存してください";
    OtherCharacters
        "this is read as other characters than those that were written",
        "書かれたものとは別の文字として読まれています";
    SaveInThatEncoding
        "save the file in that encoding, or name the right one",
        "その文字コードで保存するか、正しい文字コードを指定してください";
}

#[cfg(feature = "build")]
messages! {
    /// Messages of a compilation in a build script, besides what is wrong with the program.
    Building;

    Rust { error: Text } "{error}", "{error}";
    OneType
        "type_name names the type of one program, and there are several",
        "type_nameは1つのプログラムの型名ですが、プログラムが複数あります";
    NoRust { text: String, error: Text }
        "\"{text}\": {error}",
        "\"{text}\": {error}";
    NoFile { path: Text }
        "{path} does not name a file",
        "{path}はファイルを指していません";
    LineBreak { path: Text }
        "{path}: Cargo cannot track a path with a line break: rename the file or its folder",
        "{path}: 改行を含むパスはCargoに渡せません。ファイルかフォルダの名前を変えてください";
    SameOutput { one: Text, other: Text }
        "{one} and {other} would compile to the same file: give them different names or folders",
        "{one}と{other}のコンパイル結果が同じファイルになります。名前かフォルダを変えてください";
    NoOutDir
        "OUT_DIR is not set: call this from a build script, or choose an out_dir",
        "OUT_DIRが設定されていません。ビルドスクリプトから呼ぶか、out_dirを指定してください";
    CannotWrite { path: Text, error: Text }
        "File can not write({path}): {error}",
        "{path}に書き込めません: {error}";
}
