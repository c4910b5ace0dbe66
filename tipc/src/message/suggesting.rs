//! Helps: what to write in the place of what stands there.

use super::list::List;
use super::say::Decimal;
use crate::language::{Edition, Keyword};
use smol_str::SmolStr;

messages! {
    /// A replacement for what was written.
    Suggestion;

    // Words of blocks.
    ElseIf
        "write `ELSEIF condition THEN`, in one word",
        "`ELSEIF 条件式 THEN` と、1語で書いてください";
    Wend
        "WEND closes a WHILE",
        "WHILEを閉じるのは `WEND` です";
    Next
        "NEXT closes a FOR",
        "FORを閉じるのは `NEXT` です";
    SubEnd
        "SUBEND closes a SUBROUTINE",
        "SUBROUTINEを閉じるのは `SUBEND` です";
    Break
        "leave a loop with `GOTO L1:`, and put `L1:` after it",
        "ループから抜けるには `GOTO L1:` と書き、ループの後に `L1:` を置きます";
    Exit
        "`EXIT` ends the program where it stands",
        "その場でプログラムを終えるのは `EXIT` です";
    KeyIn
        "`KEY_IN A` waits for a key, `IF KB_HIT GOTO L1:` tests for one",
        "キー入力を待つのは `KEY_IN A`、調べるのは `IF KB_HIT GOTO L1:` です";
    AdIn
        "read an input with `AD_IN VR1 A`",
        "入力を読むのは `AD_IN VR1 A` です";
    NoBraces ["E205-26"]
        "there are no braces",
        "波括弧は使えません";
    Braces
        "blocks have no braces: IF ends with ENDIF, WHILE with WEND, FOR with NEXT",
        "ブロックに波括弧は使いません。IFはENDIF、WHILEはWEND、FORはNEXTで閉じます";
    TargetFirst { target: SmolStr }
        "the command stands first: `PTP {target} x y z`",
        "コマンドを先に書きます: `PTP {target} x y z`";
    Glued { command: &'static str }
        "put a blank after {command}, and leave parentheses and quotes out",
        "{command}の後に空白を入れ、括弧や引用符は取ってください";

    FastFirst { command: SmolStr }
        "HS stands right after the command: `{command} HS …`",
        "HSはコマンドのすぐ後に書きます: `{command} HS …`";
    FlagApart { flag: &'static str, number: SmolStr }
        "a blank stands after {flag}: `{flag} {number}`",
        "{flag}の後には空白を入れます: `{flag} {number}`";
    OneTarget { command: SmolStr }
        "{command} has one target: write a line for each",
        "{command}の対象は1つです。対象ごとに1行ずつ書いてください";
    JointName
        "a joint is named by its leg and its number: `J12` is joint 2 of leg 1",
        "関節は脚の番号と関節の番号で表します。`J12` は脚1の関節2です";
    ArgumentNames
        "write the numbers alone, in the order of the command's form",
        "名前は付けず、決まった順に数値だけを書いてください";
    NoUnit
        "write the number alone: lengths are in mm, angles in deg, times in ms",
        "数値だけを書きます。長さはmm、角度はdeg、時間はmsです";
    NoBrackets
        "write the numbers alone, without brackets",
        "括弧は付けず、数値だけを書いてください";
    NoText
        "variables hold numbers; a text stands after MESSAGE only",
        "変数に入るのは数値だけです。文字列を書けるのはMESSAGEの後だけです";
    NextStatement
        "a statement for each line, or `;` between two",
        "文は1行に1つずつ、または `;` で区切って書きます";
    NoTarget { command: SmolStr }
        "{command} takes no target",
        "{command}に対象は付けません";
    OneLine
        "a statement ends with its line: write it on one",
        "文は1行で終わります。1行に続けて書いてください";
    GoesOnHere
        "it goes on here",
        "続きはここです";
    NoHex { value: u32 }
        "constants are decimal: write `{value}`",
        "定数は10進数です。`{value}` と書いてください";
    NoLineNumbers { name: SmolStr }
        "a jump leads to a label, not to a line: put `{name}:` before a statement and write `{name}:` here",
        "行番号へは飛べません。飛び先に `{name}:` を置き、ここにも `{name}:` と書いてください";
    SemicolonEndsText
        "`;` ends the text before it: what follows is a statement",
        "`;` で文字列が終わり、その後は別の文になります";
    AfterEnd
        "END ends the text of the program: move it to the last line, and write EXIT here",
        "ENDより後は読まれません。ENDは最後の行に移し、ここはEXITにしてください";
    EndsTheText
        "the text of the program ends here",
        "プログラムはここで終わりです";
    StandsAfterEnd
        "this stands after END",
        "これはENDより後にあります";

    // Comments.
    Comment
        "a comment starts with `//`",
        "コメントは `//` で始めます";
    EachLine
        "start each line of a comment with `//`",
        "コメントは行ごとに `//` で始めてください";

    Plain { plain: &'static str }
        "write `{plain}`",
        "`{plain}` と書いてください";
    PlainBlank
        "this is a blank of another kind: type a plain one",
        "特殊な空白です。普通の空白を入れてください";

    // Equations.
    Increment { name: SmolStr, sign: SmolStr }
        "write `{name} {sign}= 1`",
        "`{name} {sign}= 1` と書いてください";
    NoOperator { sign: SmolStr } ["E107-08" "E204-05" "E205-24"]
        "there is no `{sign}`",
        "`{sign}` という演算子はありません";
    WriteSigned { text: SmolStr }
        "as a sign write `{text}`; between two operands it calculates",
        "符号なら `{text}` と書きます。2つの値の間なら計算になります";
    Update { name: SmolStr }
        "write it in one piece, as `{name} += 1`",
        "`{name} += 1` のように続けて書いてください";
    SplitOperator { sign: SmolStr } ["E204-05" "E205-15"]
        "no blank stands inside `{sign}`",
        "`{sign}` の途中に空白は入れられません";
    Power
        "there is no power: multiply, as `A = B * B`",
        "べき乗はありません。`A = B * B` のように掛け算で書いてください";
    Remainder
        "there is no remainder: of A by B it is `Q = A / B`, `Q = INT Q`, `Q *= B`, `R1 = A - Q`",
        "剰余の演算はありません。AをBで割った余りは `Q = A / B`、`Q = INT Q`、`Q *= B`、`R1 = A - Q` で求めます";
    ChooseByIf
        "an equation compares nothing: write `IF A > 0 THEN` … `ELSE` … `ENDIF` around the assignments",
        "式の中で比較はできません。`IF A > 0 THEN` … `ELSE` … `ENDIF` の中で代入してください";
    AssignEach { name: SmolStr }
        "an equation has one variable on its left: write one for each, as `{name} = …`",
        "式の左辺は変数1つです。`{name} = …` のように、1つずつ別の式にしてください";
    EachMember
        "a POS or JOINT is filled member by member: `P.X = …`, `P.Y = …`, `P.Z = …`",
        "POSやJOINTにはメンバごとに代入します: `P.X = …`、`P.Y = …`、`P.Z = …`";
    FunctionInEquation { function: SmolStr }
        "functions are for equations only: write `A = {function} B` on the line before, and A here",
        "関数は式の中だけで使えます。前の行に `A = {function} B` と書き、ここにはAを書いてください";
    CalculateArgument
        "calculate in an equation on the line before; a sign has a blank before it: `100 -20`",
        "計算は前の行の式で行います。符号なら前に空白を入れてください: `100 -20`";
    CompareAsStatement ["E204-05"]
        "`==` compares; `=` assigns",
        "`==` は比較です。代入は `=` です";
    Assign { name: SmolStr }
        "write `{name} = …`",
        "`{name} = …` と書いてください";
    Initial { name: SmolStr }
        "assign after the declaration, on a line of its own: `{name} = 0`",
        "宣言の後で、別の行で代入してください: `{name} = 0`";
    NoInitial ["E205-23"]
        "a declaration assigns no value",
        "宣言と同時に代入はできません";

    NoHyphen { name: SmolStr }
        "a name has no `-`: write `{name}`",
        "名前に `-` は使えません。`{name}` と書いてください";
    NoArray { name: SmolStr }
        "there are no arrays: declare `{name}1`, `{name}2` and so on",
        "配列はありません。`{name}1`、`{name}2` のように別々に宣言してください";
    KeyFirst { key: SmolStr }
        "read the key into a variable and compare that: `KEY_IN A`, then `IF A == {key} GOTO L1:`",
        "キーは変数に読んでから比較します: `KEY_IN A` の後に `IF A == {key} GOTO L1:`";
    TargetBefore { written: SmolStr }
        "the target stands first: `{written}`",
        "対象を先に書きます: `{written}`";
    NoParameters { name: SmolStr }
        "a SUBROUTINE takes no arguments: assign variables, and write `CALL {name}:`",
        "SUBROUTINEに引数はありません。変数に代入してから `CALL {name}:` と書いてください";
    UntilCloses
        "a loop is `REPEAT` … `UNTIL condition`, in this order",
        "繰り返しは `REPEAT` … `UNTIL 条件式` の順に書きます";
    WithoutEquals { written: SmolStr }
        "arguments follow the command without `=`: `{written}`",
        "引数に `=` は付けません: `{written}`";

    // Conditions.
    WriteRelation { relation: &'static str }
        "write `{relation}`",
        "`{relation}` と書いてください";
    CalculateBefore
        "calculate in an equation on the line before, and compare its variable",
        "計算は前の行の式で行い、その変数を比較してください";
    BlockBegins
        "the block begins on the next line: WHILE ends with WEND, UNTIL ends its REPEAT",
        "ブロックは次の行から始まります。WHILEはWENDで閉じ、UNTILはREPEATを閉じます";
    FlagOfTarget { flag: SmolStr }
        "write the flag in one word: `{flag}`",
        "フラグは `{flag}` と1語で書いてください";
    CommandNoCondition { command: &'static str }
        "{command} is a command and stands on a line of its own; a condition compares, or names a flag as `KB_HIT`",
        "{command}はコマンドなので、別の行に書きます。条件式は比較か、`KB_HIT` のようなフラグです";
    NoColon ["E205-26"]
        "no colon opens a block",
        "ブロックの始まりにコロンは書きません";
    WriteThen
        "an IF opens its block with THEN and ends with ENDIF; WHILE ends with WEND, FOR with NEXT",
        "IFのブロックはTHENで始めてENDIFで閉じます。WHILEはWEND、FORはNEXTで閉じます";
    WithoutColon { word: SmolStr }
        "write `{word}` without a colon",
        "`{word}` の後にコロンは要りません";
    FlagAlone { flag: SmolStr }
        "an event flag stands alone: `IF {flag} GOTO L1:`, or `!{flag}`",
        "イベントフラグは `IF {flag} GOTO L1:` や `!{flag}` のように単独で書きます";
    Character { character: SmolStr }
        "a key is compared with `CHAR_{character}`",
        "キーは `CHAR_{character}` と比較します";
    CharacterOrVariable { character: SmolStr }
        "declare it with `DEF_VAR {character}`; the key is `CHAR_{character}`",
        "変数なら `DEF_VAR {character}` と宣言します。キーなら `CHAR_{character}` です";
    ForCounts ["E205-18"]
        "FOR counts a variable from one number TO another",
        "FORでは変数をある値からある値まで(TO)数えます";
    AndOr { word: SmolStr } ["E205-16"]
        "a condition is one comparison or one flag: there is no {word}",
        "条件式は比較1つかフラグ1つです。{word}は使えません";
    Nest
        "put one IF inside the other for AND; for OR, write two `IF … GOTO L1:` with the same label",
        "ANDはIFの中にIFを入れます。ORは同じラベルへの `IF … GOTO L1:` を2つ書きます";
    Not ["E205-16"]
        "there is no NOT",
        "NOTは使えません";
    WriteNot
        "write `!` right before a flag, as `!KB_HIT`; reverse a comparison, as `<>` for `==`",
        "フラグは `!KB_HIT` のように直前に `!` を付け、比較は `==` を `<>` にするように逆にします";
    NotEqual ["E205-15"]
        "not equal is written `<>`",
        "等しくないことは `<>` と書きます";
    WriteNotEqual
        "write `A <> B`",
        "`A <> B` と書いてください";
    Forever
        "repeat for ever with `LOOP:` … `GOTO LOOP:`",
        "ずっと繰り返すには `LOOP:` … `GOTO LOOP:` と書きます";
    ThenJumps { jump: SmolStr } ["E205-17"]
        "THEN opens a block; {jump} directly follows the condition",
        "THENはブロックの始まりです。{jump}は条件式のすぐ後に書きます";
    LeaveThenOut { jump: SmolStr }
        "leave THEN out: `IF condition {jump} L1:`",
        "THENを取ってください: `IF 条件式 {jump} L1:`";
    OneLineIf ["E205-17"]
        "an IF with THEN is a block: its statements stand on lines of their own",
        "THENの付いたIFはブロックです。中の文は別の行に書きます";
    CloseOneLineIf
        "put the statement on the next line, and ENDIF after it",
        "文を次の行に移し、その後にENDIFを置いてください";
    ElseIfInTwo ["E105-04"]
        "`ELSE IF` would be two statements",
        "`ELSE IF` では2つの文になります";
    EndInTwo { word: SmolStr } ["E207-08"]
        "END ends the program, and this {word} is still open",
        "ENDはプログラムの終わりですが、この{word}がまだ閉じていません";
    InOneWord { word: SmolStr }
        "write `{word}`, in one word",
        "`{word}` と1語で書いてください";

    // Numbers and constants.
    Comma { whole: SmolStr, point: SmolStr }
        "a comma separates two arguments: write `{whole}`, or `{point}` with a decimal point",
        "コンマは引数の区切りです。`{whole}` か、小数なら `{point}` と書いてください";

    // Files.
    Migrate
        "`tip migrate OLD.prg -o NEW.prg` makes it a program of version 3.1",
        "`tip migrate OLD.prg -o NEW.prg` でバージョン3.1のプログラムに直せます";
    Title
        "line 2 is the title, not a statement: put a line with the title before it",
        "2行目は題名で、文ではありません。その前に題名の行を入れてください";
    TitleHere
        "this line is read as the title",
        "この行は題名として読まれます";
    OtherEncoding { encoding: &'static str }
        "the file looks like {encoding}: save it as UTF-8 or Shift_JIS",
        "ファイルは{encoding}のようです。UTF-8かShift_JISで保存してください";

    FitsTravel
        "look at `sign`, `offset` and `gear`, or give the drive narrower `limits`",
        "`sign`、`offset`、`gear` を確かめるか、`limits` を狭めてください";
    DidYouMean { near: SmolStr }
        "did you mean `{near}`?",
        "`{near}` の間違いではありませんか?";

    // Words.
    Write { text: SmolStr }
        "write `{text}`",
        "`{text}` と書いてください";
    BlankMissing { text: SmolStr }
        "a blank is missing: write `{text}`",
        "空白が足りません。`{text}` と書いてください";
    BlankAfter { command: &'static str }
        "put a blank after {command}",
        "{command}の後に空白を入れてください";
    ElseOnNextLine { statement: SmolStr }
        "write `{statement}` on the next line: the program goes on there if it does not jump",
        "`{statement}` は次の行に書いてください。ジャンプしないときはそこに進みます";
    ElseInBlock
        "ELSE belongs to a block: `IF condition THEN`, the statements, ELSE and ENDIF stand on lines of their own",
        "ELSEはブロックの中で使います。`IF 条件式 THEN`、文、ELSE、ENDIFをそれぞれ別の行に書いてください";
    NoNumbers
        "lines have no numbers: leave them out, and jump to labels, as `GOTO L1:` to `L1:`",
        "行番号は付けません。番号を取り、飛び先には `L1:` のようなラベルを置いて `GOTO L1:` と書いてください";
    NumberedToo
        "this line has a number, too",
        "この行にも番号が付いています";
    Digits { number: SmolStr }
        "did you mean the number `{number}`?",
        "数値の `{number}` の間違いではありませんか?";
    CountTo
        "write TO between two numbers: `FOR I = 1 TO 10`",
        "範囲は `FOR I = 1 TO 10` のようにTOで書いてください";
    CommentOrName
        "a comment starts with `//`; names and words are made of A-Z, 0-9 and `_`",
        "コメントなら `//` で始めてください。名前や語に使えるのはA-Z、0-9、`_` です";
    Invisible
        "this is an invisible character: delete it",
        "見えない文字が入っています。消してください";

    NumberOrVariable { name: SmolStr, number: SmolStr }
        "a number has digits only: write `{number}`; a variable needs `DEF_VAR {name}`",
        "数値なら数字だけで `{number}` と書きます。変数なら `DEF_VAR {name}` と宣言します";
    LargestNumber
        "the largest number is about 1.8E308",
        "書ける最大の数は約1.8E308です";
    TitleInLineTwo { wanted: Decimal }
        "write `{wanted}` alone on line 1; the title goes on line 2",
        "1行目は `{wanted}` だけにし、題名は2行目に書いてください";

    // Words of the language in another place.
    FlagHere
        "this is the flag, not the variable",
        "これはフラグで、変数ではありません";
    OtherName { name: SmolStr }
        "in motion commands `{name}` is always the flag: give the variable another name",
        "移動系コマンドの `{name}` はいつもフラグです。変数には別の名前を付けてください";
    ReadInput { input: SmolStr }
        "read the input on the line before: `AD_IN {input} A`, and write A here",
        "入力は前の行で `AD_IN {input} A` と読み、ここにはAを書いてください";
    OfFoot { target: SmolStr }
        "`TEACH_POSITION {target} P` reads where the foot is, `PTP {target} x y z` moves it",
        "足先の位置を読むのは `TEACH_POSITION {target} P`、動かすのは `PTP {target} x y z` です";
    OfJoint { target: SmolStr }
        "`TEACH_ANGLE {target} A` reads the joint's angle, `PTP_ANGLE {target} 30` turns it",
        "関節の角度を読むのは `TEACH_ANGLE {target} A`、回すのは `PTP_ANGLE {target} 30` です";
    CommandFirst { command: &'static str }
        "{command} is a command: it starts a statement, and its arguments follow after blanks",
        "{command}はコマンドです。文の先頭に書き、引数は空白で区切って続けます";
    Keys
        "the keys are `CHAR_0`…`CHAR_9`, `CHAR_A`…`CHAR_Z` and `CHAR_SPC` (the space bar)",
        "キーは `CHAR_0`…`CHAR_9`、`CHAR_A`…`CHAR_Z`、`CHAR_SPC` (スペース)です";
    ColonSeparates
        "a colon makes a label; between two statements write `;`, or start a new line",
        "コロンを付けるとラベルになります。文の区切りは `;` か改行です";

    // Conditions.
    NoParentheses
        "write it without parentheses",
        "括弧を付けずに書いてください";
    WithoutParentheses { written: SmolStr }
        "write it without parentheses: `{written}`",
        "括弧を付けずに書いてください: `{written}`";
    OpenBlock { written: SmolStr, closer: Keyword }
        "write it without parentheses and braces: `{written}`; {closer} ends the block",
        "括弧や波括弧を付けずに `{written}` と書き、ブロックは{closer}で閉じてください";
    NestWithoutParentheses
        "write it without parentheses: one IF inside the other for AND; for OR, two `IF … GOTO L1:` with the same label",
        "括弧は付けません。ANDはIFの中にIFを入れ、ORは同じラベルへの `IF … GOTO L1:` を2つ書いてください";
    Limit
        "calculate in an equation on the line before, and write its variable here",
        "計算は前の行の式で行い、ここにはその変数を書いてください";

    // Equations.
    Functions { functions: List }
        "the functions are {functions}",
        "使える関数は{functions}です";
    MemberByMember
        "calculate member by member, as `P.Z = P.Z + 10`",
        "`P.Z = P.Z + 10` のように、メンバごとに計算してください";
    ShorterName
        "choose a shorter name",
        "もっと短い名前にしてください";

    // Calls and labels.
    Call { name: SmolStr }
        "to call the SUBROUTINE write `CALL {name}:`",
        "SUBROUTINEを呼ぶのは `CALL {name}:` です";
    JumpTo { name: SmolStr }
        "to go there write `GOTO {name}:`, to call it `GOSUB {name}:`",
        "そこへ飛ぶのは `GOTO {name}:`、呼ぶのは `GOSUB {name}:` です";
    NoValues
        "a SUBROUTINE takes no values: assign variables before the CALL",
        "SUBROUTINEに値は渡せません。CALLの前に変数に代入してください";
    NoResult
        "RETURN returns no value: leave it in a variable",
        "RETURNで値は返せません。変数に入れておいてください";
    LeaveSubroutine
        "leave a SUBROUTINE with `RETURN`",
        "SUBROUTINEから戻るのは `RETURN` です";
    Alone { word: SmolStr }
        "write `{word}` alone",
        "`{word}` だけを書いてください";
    NextEach
        "close each FOR with a NEXT of its own, the inner one first",
        "FORごとにNEXTで閉じます。内側のFORから順に書いてください";
    GotoLoop
        "GOTO without a label goes to the `LOOP:` above: name the label, as `GOTO L1:`",
        "ラベルのないGOTOは上の `LOOP:` へ飛びます。`GOTO L1:` のように飛び先を書いてください";

    OfEdition { word: SmolStr, edition: Edition }
        "{word} came with edition {edition}: write `{edition}` in line 1",
        "{word}は{edition}版からの語です。1行目に `{edition}` と書いてください";

    // Blocks.
    Closes { opener: Keyword, closer: Keyword }
        "{closer} closes {opener}",
        "{opener}を閉じるのは{closer}です";
    CountTimes
        "REPEAT counts nothing: to repeat 3 times write `FOR I = 1 TO 3` … `NEXT`",
        "REPEATで回数は数えられません。3回繰り返すなら `FOR I = 1 TO 3` … `NEXT` です";
}
