//! The texts about words of other languages.

tipc::message_table! {
    /// The way of T.I.P. to say what another language says otherwise.
    Foreign;

    ShowText
        "show a text with `MESSAGE text`, without quotes; `%A%` in it shows the value of A",
        "文字の表示は `MESSAGE 文字列` です。引用符は不要で、`%A%` と書くとAの値が出ます";
    EndIf
        "ENDIF closes an IF, in one word",
        "IFを閉じるのは `ENDIF` (1語)です";
    Return
        "write `RETURN`",
        "`RETURN` と書いてください";
    Loops
        "a loop is `REPEAT` … `UNTIL condition`, or `WHILE condition` … `WEND`",
        "繰り返しは `REPEAT` … `UNTIL 条件式` か `WHILE 条件式` … `WEND` です";
    Continue
        "go on with `GOTO L1:`, and put `L1:` before the WEND, UNTIL or NEXT",
        "次の回に進むには `GOTO L1:` と書き、WEND、UNTIL、NEXTの前に `L1:` を置きます";
    Wait
        "`SLEEP 200` waits 200 ms, `WAIT_INPOS ALL` until all motions have ended, `REPEAT` … `UNTIL KB_HIT` until a flag is set",
        "200 ms待つのは `SLEEP 200`、全ての動作の終わりを待つのは `WAIT_INPOS ALL`、フラグを待つのは `REPEAT` … `UNTIL KB_HIT` です";
    Declare
        "declare variables with `DEF_VAR A` (a number), `DEF_POS P` or `DEF_JOINT Q`",
        "変数の宣言は `DEF_VAR A` (数値)、`DEF_POS P`、`DEF_JOINT Q` です";
    Constant
        "a constant is a variable: declare it with `DEF_VAR A`, and assign it on the next line: `A = 100`",
        "定数も変数で表します。`DEF_VAR A` で宣言し、次の行で `A = 100` のように代入してください";
    Let
        "no word stands before an assignment: `A = 1`",
        "代入の前に語は要りません: `A = 1`";
    Subroutine
        "write `SUBROUTINE NAME:` … `SUBEND`, and `CALL NAME:`",
        "`SUBROUTINE NAME:` … `SUBEND` と書き、`CALL NAME:` で呼びます";
    Goto
        "write `GOTO L1:`",
        "`GOTO L1:` と書いてください";
    Move
        "`PTP F1 x y z` moves a foot (mm), `PTP_ANGLE J11 30` turns a joint (deg)",
        "足先を動かすのは `PTP F1 x y z` (mm)、関節を回すのは `PTP_ANGLE J11 30` (deg)です";
    Stop
        "`ALL_STOP` stops the robot, `EXIT` ends the program",
        "ロボットを止めるのは `ALL_STOP`、プログラムを終えるのは `EXIT` です";
    Lamp
        "switch a lamp with `LAMP_ON 0` and `LAMP_OFF 0`",
        "ランプは `LAMP_ON 0` と `LAMP_OFF 0` で切り替えます";
    Cases
        "write `IF A == 1 THEN` … `ELSEIF A == 2 THEN` … `ELSE` … `ENDIF`",
        "`IF A == 1 THEN` … `ELSEIF A == 2 THEN` … `ELSE` … `ENDIF` と書いてください";
    Speed
        "set the speed with `SET_V_MAX F1 200` (feet) or `SET_OMEGA_MAX J11 90` (joints)",
        "速度は `SET_V_MAX F1 200` (足先)か `SET_OMEGA_MAX J11 90` (関節)で設定します";
    Acceleration
        "set the acceleration with `SET_A_MAX F1 1200`",
        "加速度は `SET_A_MAX F1 1200` で設定します";
    Teach
        "`TEACH_POSITION F1 P` stores where a foot is, `TEACH_ANGLE F1 Q` the angles of its joints",
        "足先の位置を読み取るのは `TEACH_POSITION F1 P`、関節角は `TEACH_ANGLE F1 Q` です";
    Home
        "`INITIAL_POSTURE` goes to the initial posture",
        "初期姿勢に戻るのは `INITIAL_POSTURE` です";
    ClearText
        "clear the message with `MESSAGE_CLEAR`",
        "メッセージを消すのは `MESSAGE_CLEAR` です";
    Motors
        "leave it out: the motors hold the robot from the start",
        "不要です。モータは最初から入っていて、ロボットを保持しています";
    NoSetup
        "leave it out: inputs, lamps and joints need no setting up",
        "不要です。入力、ランプ、関節の初期設定はありません";
    NoCatch
        "leave it out: a fault stops the program, and nothing can catch it; test before, as `IF A > 0 THEN`",
        "例外処理はありません。エラーが起きるとプログラムは止まります。`IF A > 0 THEN` のように前もって調べてください";
    RelativeMark
        "`PTP F1 x y z` is absolute, `REL_PTP F1 x y z` relative; `R` before one number makes that one relative",
        "絶対値は `PTP F1 x y z`、相対値は `REL_PTP F1 x y z` です。数値の前に `R` を付けると、その値だけ相対値になります";
    Count
        "count with `N += 1` or `N -= 1`",
        "数を増減するのは `N += 1` や `N -= 1` です";
    FromTheTop
        "a program runs from line 3 to END: leave it out, and repeat for ever with `LOOP:` … `GOTO LOOP:`",
        "プログラムは3行目からENDまで実行されます。これは取り、ずっと繰り返すなら `LOOP:` … `GOTO LOOP:` と書いてください";
    Nothing
        "leave it out: a block may be empty, and `REM` passes one control cycle",
        "消してください。ブロックは空でもかまいません。1制御周期だけ待つなら `REM` です";
    Ask
        "test with `IF condition GOTO L1:`, or wait with `REPEAT` … `UNTIL condition`",
        "調べるのは `IF 条件式 GOTO L1:`、待つのは `REPEAT` … `UNTIL 条件式` です";
    GoesOn
        "this belongs to it",
        "これもその一部です";
    OneFile
        "a program is one file: put the statements here",
        "プログラムは1つのファイルです。ここに直接書いてください";
    MoveEndOrComment
        "to run it, move END below it; write notes as comments, `// …`",
        "実行するなら、ENDをこの文より下に移してください。メモなら `// …` のようにコメントにしてください";
    Number { value: &'static str }
        "there are numbers only: write `{value}`",
        "値は数値だけです。`{value}` と書いてください";
}
