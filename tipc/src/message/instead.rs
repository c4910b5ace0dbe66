//! What to write in place of what stands there.

use super::list::List;
use super::say::Decimal;
use crate::language::Keyword;
use smol_str::SmolStr;

messages! {
    /// Another way of writing.
    Instead;

    // Words.
    Write { text: SmolStr }
        "write `{text}`",
        "`{text}` と書いてください";
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
    NoClock
        "there is no clock: each step takes one control cycle, so count with `N += 1`",
        "時計はありません。1ステップが1制御周期なので、`N += 1` で数えてください";
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
    TypeLeftOut
        "leave it out: `DEF_VAR` declares numbers",
        "これは要りません。`DEF_VAR` で数値の変数になります";
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
        "RETURN gives no value back: leave it in a variable",
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

    // Blocks.
    Closes { opener: Keyword, closer: Keyword }
        "{closer} closes {opener}",
        "{opener}を閉じるのは{closer}です";
    CountTimes
        "REPEAT counts nothing: to repeat 3 times write `FOR I = 1 TO 3` … `NEXT`",
        "REPEATで回数は数えられません。3回繰り返すなら `FOR I = 1 TO 3` … `NEXT` です";
}
