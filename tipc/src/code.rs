//! The table of diagnostic codes: the classical message and level of each. A code that covers several kinds of mistakes,
//! as `E205`, is their class, and each [`Mistake`] has a finer code of its own, as `E205-03`.

use crate::language::Edition;
use crate::message::Lang;
use tip_runtime::fault::{Fault, Kind, UNASSIGNED};

/// Severity of a diagnostic.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Level {
    /// The program does not load.
    Error,
    /// The program loads, but something in it is probably wrong.
    Warning,
}

impl Level {
    /// Returns `error` or `warning`.
    pub const fn name(self) -> &'static str {
        match self {
            Level::Error => "error",
            Level::Warning => "warning",
        }
    }
}

macro_rules! codes {
    ($( $(#[$doc:meta])* $variant:ident $id:literal $kind:expr, $message:expr $(, $japanese:literal)?; )*) => {
        /// Subject of a diagnostic. `{}` in a message stands for the name that the diagnostic is about.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[non_exhaustive]
        pub enum Code {
            $( $(#[$doc])* $variant, )*
        }

        impl Code {
            /// Every code.
            pub const ALL: &'static [Code] = &[$( Code::$variant, )*];

            /// Returns the stable identifier: `E…` for errors, `W…` for warnings.
            pub const fn id(self) -> &'static str {
                match self { $( Code::$variant => $id, )* }
            }

            /// Returns the class of an error; `None` for a warning.
            pub const fn kind(self) -> Option<Kind> {
                match self { $( Code::$variant => $kind, )* }
            }

            /// Returns the classical message of an error (T.I.P. 3.1 §9), or the message of a warning.
            pub const fn template(self) -> &'static str {
                match self { $( Code::$variant => $message, )* }
            }

            /// Returns the message in a language. Diagnostics print the classical ones in English, as [`Code::template`] has them.
            pub const fn template_in(self, lang: Lang) -> &'static str {
                match (self, lang) {
                    $( $( (Code::$variant, Lang::Japanese) => $japanese, )? )*
                    (_, _) => self.template(),
                }
            }
        }
    };
}

codes! {
    /// Reserved: nothing here can cause it.
    CannotAllocate "E101" Some(Kind::Preprocess), "Can not allocate memory for {}",
        "{}のメモリを確保できません";
    /// An output file cannot be written.
    CannotWrite "E102" Some(Kind::Preprocess), "File can not write({})",
        "ファイルに書けません({})";
    /// The source file cannot be read.
    FileNotFound "E103" Some(Kind::Preprocess), "File not found({})",
        "ファイルがありません({})";
    /// Reserved: nothing here can cause it.
    LongFilename "E104" Some(Kind::Preprocess), "Too long filename",
        "長すぎるファイル名";
    /// The text breaks the format of a program.
    Format "E105" Some(Kind::Preprocess), "Format error",
        "書式の誤り";
    /// A MESSAGE text over 70 bytes.
    LongString "E106" Some(Kind::Preprocess), "too much long string",
        "長すぎる文字列";
    /// An assignment that the language lacks.
    Equation "E107" Some(Kind::Preprocess), "Wrong equation format",
        "式の誤り";
    /// Line 1 does not name this compiler's version of the language.
    Version "E108" Some(Kind::Preprocess), "Wrong version number",
        "版番号の誤り";
    /// A label declared twice.
    DuplicateLabel "E201" Some(Kind::Syntax), "Duplicated label name",
        "重複したラベル";
    /// A jump to a label that is not declared.
    UnknownLabel "E202" Some(Kind::Syntax), "Label \"{}\" does not exist",
        "ラベル \"{}\" がありません";
    /// No END.
    NoEnd "E203" Some(Kind::Syntax), "Not exist END",
        "ENDがありません";
    /// A word that is not a command, or one that the robot lacks.
    UnknownCommand "E204" Some(Kind::Syntax), "Unknown command \"{}\"",
        "\"{}\" というコマンドはありません";
    /// Arguments that do not fit the command.
    Argument "E205" Some(Kind::Syntax), "Wrong argument",
        "引数の誤り";
    /// A name that is not declared.
    UnknownVariable "E206" Some(Kind::Syntax), "unknown variable \"{}\"",
        "変数 \"{}\" は宣言されていません";
    /// Openers and closers, or a jump into a block.
    Structure "E207" Some(Kind::Syntax), "Control structure mismatch",
        "制御構造の誤り";
    /// A variable that is read and never assigned.
    NeverAssigned "E301" Some(Kind::Runtime), UNASSIGNED,
        "代入前の変数の使用";
    /// A run came to a value that cannot be used.
    Domain "E302" Some(Kind::Runtime), "Domain error",
        "範囲外の値";
    /// A run came to RETURN or SUBEND without a call.
    InvalidReturn "E303" Some(Kind::Runtime), "Invalid Return command",
        "呼び出しのないRETURN";
    /// The target of a command was under another control.
    InvalidMode "E304" Some(Kind::Runtime), "Invalid control mode",
        "合わない制御モード";
    /// More than ten nested calls.
    TooDeep "E305" Some(Kind::Runtime), "Too deep subroutine call",
        "深すぎるサブルーチン呼び出し";
    /// Reserved: no program that loads can cause it.
    WrongStep "E306" Some(Kind::Runtime), "Wrong step number",
        "存在しないステップ";
    /// A robot's description that cannot be used.
    Description "E401" Some(Kind::Robot), "Wrong robot description",
        "ロボットの記述の誤り";
    /// A scene that cannot be used.
    Scene "E402" Some(Kind::Robot), "Wrong scene",
        "シーンの誤り";
    /// A joint came to its limit in a run.
    JointLimit "E403" Some(Kind::Robot), "Joint limit {}",
        "関節{}の動作範囲の端";
    /// A target, or the path to it, that the robot did not reach in a run.
    NotReached "E404" Some(Kind::Robot), "Out of reach {}",
        "{}が目標に届きません";
    /// A sensor that read nonsense in a run.
    Sensor "E405" Some(Kind::Robot), "Sensor fault {}",
        "{}のセンサの異常";
    /// Hardware that failed in a run.
    Hardware "E406" Some(Kind::Robot), "Hardware fault {}",
        "{}のハードウェアの異常";
    /// Someone pressed the key of the emergency stop.
    EmergencyKey "E407" Some(Kind::Robot), "Emergency stop key",
        "非常停止キー";
    /// A `tip.toml` that cannot be used.
    Project "E408" Some(Kind::Robot), "Wrong tip.toml",
        "tip.tomlの誤り";
    /// A variable that nothing uses.
    Unused "W101" None, "variable \"{}\" is declared but never used",
        "変数 \"{}\" は宣言されていますが、使われていません";
    /// A variable that nothing reads.
    NeverRead "W102" None, "variable \"{}\" is assigned but never read",
        "変数 \"{}\" は代入されますが、読まれません";
    /// `//` cuts a MESSAGE text.
    CommentInMessage "W103" None, "the comment cuts this MESSAGE text",
        "コメントがMESSAGEの文字列を途中で切っています";
    /// A variable named like a flag of motion commands.
    FlagName "W104" None, "\"{}\" is always the flag, never the variable, in motion commands",
        "\"{}\" は移動系コマンドではいつもフラグと読まれ、変数にはなりません";
    /// A jump into a FOR loop.
    EntersFor "W105" None, "this jump enters a FOR loop from outside",
        "このジャンプは外からFORループに入ります";
    /// A SUBROUTINE reached from the step above it.
    RunsInto "W106" None, "the program can run into SUBROUTINE \"{}\" from above",
        "上からSUBROUTINE \"{}\" に入ってしまうことがあります";
    /// A constant that its command refuses at runtime.
    OutOfRange "W107" None, "this constant is out of range and stops the program when it runs",
        "この定数は範囲外で、実行すると緊急停止します";
    /// A read for which no path assigns a value.
    Unassigned "W108" None, "variable \"{}\" is read before it is assigned",
        "変数 \"{}\" が代入の前に読まれています";
    /// A read for which some path assigns no value.
    PerhapsUnassigned "W109" None, "variable \"{}\" may be read before it is assigned",
        "変数 \"{}\" が代入の前に読まれるおそれがあります";
    /// `%NAME%` of something that MESSAGE cannot show.
    Placeholder "W110" None, "the message shows \"%{}%\" as it is",
        "\"%{}%\" は値に置き換わらず、そのまま表示されます";
    /// A MESSAGE text in quotes.
    QuotedMessage "W111" None, "the message shows its quotes or parentheses",
        "引用符や括弧もそのまま表示されます";
    /// A step that no path leads to.
    Unreachable "W112" None, "the program never comes to this step",
        "このステップは決して実行されません";
    /// A part that is called and does not come back.
    NoReturn "W113" None, "\"{}\" is called but never returns",
        "\"{}\" は呼び出されますが、戻りません";
    /// A RETURN that is reached without a call.
    LostReturn "W114" None, "the program can come to this RETURN without a GOSUB",
        "GOSUBなしでこのRETURNに来てしまうことがあります";
    /// A FOR over constants that never enters its body.
    ForNever "W115" None, "this FOR never runs",
        "このFORは一度も実行されません";
    /// A condition that is always true, or always false.
    ConstantCondition "W116" None, "the outcome of this condition never changes",
        "この条件式の結果は決して変わりません";
    /// A loop that nothing ends.
    EndlessLoop "W117" None, "nothing in this loop changes its condition",
        "このループの中では条件が変わりません";
    /// A SLEEP below one control cycle.
    ShortSleep "W118" None, "this SLEEP is shorter than one control cycle",
        "このSLEEPは1制御周期より短い時間です";
    /// `=+` that is no `+=`.
    SwappedSigns "W119" None, "=+ assigns; it adds nothing",
        "=+ は代入で、加算ではありません";
    /// `R` before the first of several numbers.
    RelativeFirst "W120" None, "R is for the first number only",
        "Rは最初の数値にだけ付いています";
    /// A comment that is to silence a warning, and does not.
    Allow "W121" None, "this comment silences nothing",
        "このコメントで消える警告はありません";
    /// A constant target that the robot cannot reach.
    OutOfReach "W122" None, "this target is out of reach and stops the program when it runs",
        "この目標には届かず、実行すると緊急停止します";
    /// A SPECIAL that the robot does not answer by itself.
    Unanswered "W123" None, "nothing answers this SPECIAL, and it stops the program when it runs",
        "このSPECIALに応えるものがなく、実行すると緊急停止します";
    /// A value in a MESSAGE as other languages write it.
    ForeignValue "W124" None, "the message shows this as it is",
        "値に置き換わらず、このまま表示されます";
    /// A program that `tip.toml` gives another robot than its crate.
    OtherRobot "W125" None, "its crate compiles this program for another robot",
        "このプログラムは、クレートでは別のロボット用にコンパイルされます";
    /// A wait for what nothing in the program moves or sets.
    WaitsForNothing "W126" None, "nothing in the program moves or sets this",
        "プログラムの中に、これを動かしたり立てたりする文がありません";
    /// A constant target that the robot reaches, but not on the straight path from where the foot is.
    PathLeavesReach "W127" None, "the straight path to this target leaves the reach and stops the program when it runs",
        "この目標までの直線経路が可動範囲を外れ、実行すると緊急停止します";
    /// A title that would be a statement of the program.
    StatementAsTitle "W128" None, "this statement is read as the title and does not run",
        "この文は題名として読まれ、実行されません";
    /// A file in an encoding that programs do not have, which can be read all the same.
    OtherEncoding "W129" None, "the file seems to be in another encoding",
        "ファイルは別の文字コードで書かれているようです";
    /// A label that is the word of a jump and a label in one piece.
    GluedJump "W130" None, "this is a label, and jumps nowhere",
        "これはラベルで、ジャンプしません";
    /// A statement after the END of the text.
    AfterEnd "W131" None, "this statement stands after END and does not run",
        "この文はENDより後にあり、実行されません";
    /// A constant that nothing uses.
    UnusedConstant "W132" None, "constant \"{}\" is defined but never used",
        "定数 \"{}\" は定義されていますが、使われていません";
    /// A THREAD that nothing starts.
    NeverStarted "W133" None, "nothing starts THREAD \"{}\"",
        "THREAD \"{}\" を動かす文がありません";
    /// A thread that waits for itself.
    WaitsForItself "W134" None, "this thread waits for itself, which stops the program",
        "このスレッドは自分自身を待つため、実行すると緊急停止します";
    /// A program whose F_MESSAGEs never end a line.
    NoLineEnd "W135" None, "all F_MESSAGEs of this program write into one line",
        "このプログラムのF_MESSAGEはすべて1行につながります";
    /// A timer that is read and never started.
    StoppedTimer "W136" None, "\"{}\" is always 0: nothing starts this timer",
        "\"{}\" はいつも0です。このタイマを動かす文がありません";
    /// A command that has no effect, since a later one of the same cycle stands.
    Overridden "W137" None, "another thread commands the same joint in this cycle, and its command stands",
        "別のスレッドが同じ周期に同じ関節を動かし、そちらの命令が有効になります";
    /// A constant target in which two parts of the robot overlap.
    HitsItself "W138" None, "at this target the robot hits itself",
        "この目標では、ロボットの部分どうしがぶつかります";
}

impl Code {
    /// Returns the code that a mistake has in an edition: a strict one refuses some that 3.1 warns of.
    pub const fn in_edition(self, edition: Edition) -> Code {
        match self {
            Code::OutOfRange if edition.is_strict() => Code::Domain,
            Code::Unassigned if edition.is_strict() => Code::NeverAssigned,
            Code::EntersFor | Code::RunsInto if edition.is_strict() => Code::Structure,
            code => code,
        }
    }

    /// Returns the severity of a diagnostic with this code, by the rules of an edition.
    pub const fn level(self, edition: Edition) -> Level {
        match self.in_edition(edition).kind() {
            Some(_) => Level::Error,
            None => Level::Warning,
        }
    }

    /// Returns the code of a fault that ended a run. `{}` in its message stands for the subject of the fault.
    pub const fn of_fault(fault: &Fault) -> Code {
        match fault {
            Fault::Domain => Code::Domain,
            Fault::InvalidReturn => Code::InvalidReturn,
            Fault::Unassigned(_) => Code::NeverAssigned,
            Fault::InvalidMode => Code::InvalidMode,
            Fault::TooDeep => Code::TooDeep,
            Fault::WrongStep => Code::WrongStep,
            Fault::JointLimit(..) => Code::JointLimit,
            Fault::OutOfReach(_) => Code::NotReached,
            Fault::Sensor(_) | Fault::SliderSensor | Fault::JointSensor(..) => Code::Sensor,
            Fault::EmergencyKey => Code::EmergencyKey,
            // All other faults are faults of the robot's hardware.
            _ => Code::Hardware,
        }
    }
}

/// One of several kinds of mistakes that a code covers. Messages that are reasons of this kind have its finer code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Mistake {
    /// The code that it is part of.
    pub class: Code,
    /// The stable finer code: that of the class, a dash and two digits.
    pub id: &'static str,
    english: &'static str,
    japanese: &'static str,
}

impl Mistake {
    /// Returns a title of a few words.
    pub const fn title(&self, lang: Lang) -> &'static str {
        lang.pick(self.english, self.japanese)
    }

    /// Returns the kinds that a code covers; nothing for a code that covers one kind only.
    pub fn of_class(class: Code) -> impl Iterator<Item = &'static Mistake> {
        Self::ALL
            .iter()
            .filter(move |mistake| mistake.class == class)
    }
}

const fn mistake(
    class: Code,
    id: &'static str,
    english: &'static str,
    japanese: &'static str,
) -> Mistake {
    Mistake {
        class,
        id,
        english,
        japanese,
    }
}

// A number never changes: a new kind takes the next one of its class.
#[rustfmt::skip]
impl Mistake {
    /// Every kind, in order of the codes.
    pub const ALL: &'static [Mistake] = &[
        mistake(Code::Format, "E105-01", "a character that cannot stand there", "そこには書けない文字"),
        mistake(Code::Format, "E105-02", "a line or a name that is too long", "長すぎる行や名前"),
        mistake(Code::Format, "E105-03", "a word that must be alone on its line", "1行に単独で書く語"),
        mistake(Code::Format, "E105-04", "ELSE IF in two words", "2語に分かれたELSE IF"),
        mistake(Code::Format, "E105-05", "a line break in a MESSAGE", "MESSAGEの中の改行"),
        mistake(Code::Format, "E105-06", "bytes that are not text", "文字として読めないバイト"),
        mistake(Code::Equation, "E107-01", "a left side that is not one variable", "1つの変数ではない左辺"),
        mistake(Code::Equation, "E107-02", "more than one operation or function", "2つ以上の演算や関数"),
        mistake(Code::Equation, "E107-03", "a missing operand", "足りない数値や変数"),
        mistake(Code::Equation, "E107-04", "a sign that stands apart", "離れた符号"),
        mistake(Code::Equation, "E107-05", "neither a number nor a name nor a member", "数値でも変数名でもメンバでもない語"),
        mistake(Code::Equation, "E107-06", "types that do not go together", "一緒に計算できない型"),
        mistake(Code::Equation, "E107-07", "a function with too many or too few operands", "関数に渡す値の過不足"),
        mistake(Code::Equation, "E107-08", "an operator of another language", "ほかの言語の演算子"),
        mistake(Code::UnknownCommand, "E204-01", "a word that is not a command", "コマンドではない語"),
        mistake(Code::UnknownCommand, "E204-02", "a command that the robot lacks", "ロボットにないコマンド"),
        mistake(Code::UnknownCommand, "E204-03", "a variable without an operator", "演算子のない変数"),
        mistake(Code::UnknownCommand, "E204-04", "a label without its colon", "コロンのないラベル"),
        mistake(Code::UnknownCommand, "E204-05", "an equation of another language", "ほかの言語の式"),
        mistake(Code::Argument, "E205-01", "too few arguments", "引数の不足"),
        mistake(Code::Argument, "E205-02", "too many arguments", "多すぎる引数"),
        mistake(Code::Argument, "E205-03", "a missing target", "対象の書き忘れ"),
        mistake(Code::Argument, "E205-04", "a target that the robot lacks", "ロボットにない対象"),
        mistake(Code::Argument, "E205-05", "a joint after a command for feet", "足先のコマンドに書いた関節"),
        mistake(Code::Argument, "E205-06", "a target that the command does not take", "そのコマンドでは使えない対象"),
        mistake(Code::Argument, "E205-07", "R, A or HS where it cannot stand", "R、A、HSを書けないところ"),
        mistake(Code::Argument, "E205-08", "a value of another type", "型の合わない値"),
        mistake(Code::Argument, "E205-09", "no variable to fill", "値を受け取る変数でないもの"),
        mistake(Code::Argument, "E205-10", "a number that nothing has", "存在しない番号"),
        mistake(Code::Argument, "E205-11", "a variable in the place of a constant", "定数のところにある変数"),
        mistake(Code::Argument, "E205-12", "an input that the robot lacks", "ロボットにない入力"),
        mistake(Code::Argument, "E205-13", "an event flag that the robot lacks", "ロボットにないイベントフラグ"),
        mistake(Code::Argument, "E205-14", "a condition that compares nothing", "何も比較しない条件式"),
        mistake(Code::Argument, "E205-15", "a wrong relation", "関係演算子の誤り"),
        mistake(Code::Argument, "E205-16", "more than a condition can say", "条件式に書けないこと"),
        mistake(Code::Argument, "E205-17", "THEN, GOTO and GOSUB of an IF", "IFのTHEN、GOTO、GOSUB"),
        mistake(Code::Argument, "E205-18", "a FOR or NEXT of another form", "FORとNEXTの形の誤り"),
        mistake(Code::Argument, "E205-19", "an incomplete label", "不完全なラベル"),
        mistake(Code::Argument, "E205-20", "a call that does not fit its label", "ラベルに合わない呼び出し"),
        mistake(Code::Argument, "E205-21", "a name that cannot be used", "使えない名前"),
        mistake(Code::Argument, "E205-22", "a variable declared twice", "二重に宣言した変数"),
        mistake(Code::Argument, "E205-23", "a declaration of anything but names", "変数名だけではない宣言"),
        mistake(Code::Argument, "E205-24", "a sign that stands apart", "離れた符号"),
        mistake(Code::Argument, "E205-25", "neither a number nor a name nor a member", "数値でも変数名でもメンバでもない語"),
        mistake(Code::Argument, "E205-26", "words after the end of a statement", "文の終わりの後に続く語"),
        mistake(Code::Argument, "E205-27", "a MESSAGE without a blank", "空白のないMESSAGE"),
        mistake(Code::Argument, "E205-28", "more threads than a program may have", "多すぎるスレッド"),
        mistake(Code::Structure, "E207-01", "a block that is not closed", "閉じていないブロック"),
        mistake(Code::Structure, "E207-02", "a word without its block", "対応するブロックのない語"),
        mistake(Code::Structure, "E207-03", "a SUBROUTINE inside a block", "ブロックの中のSUBROUTINE"),
        mistake(Code::Structure, "E207-04", "a branch after ELSE", "ELSEより後の分岐"),
        mistake(Code::Structure, "E207-05", "a NEXT with another variable", "変数の違うNEXT"),
        mistake(Code::Structure, "E207-06", "a jump into a block", "ブロックの中へのジャンプ"),
        mistake(Code::Structure, "E207-07", "a GOTO out of a SUBROUTINE", "SUBROUTINEの外へのGOTO"),
        mistake(Code::Structure, "E207-08", "END and a word in the place of one", "2語に分かれた終わりの語"),
        mistake(Code::Structure, "E207-09", "a way that runs into a SUBROUTINE or THREAD", "SUBROUTINEやTHREADに上から入る経路"),
    ];
}

#[cfg(test)]
mod tests {
    use super::{Code, Mistake};
    use crate::message;
    use std::collections::HashSet;

    #[test]
    fn a_finer_code_is_its_class_and_two_digits() {
        let ids: Vec<&str> = Mistake::ALL.iter().map(|mistake| mistake.id).collect();
        assert!(ids.is_sorted_by(|first, second| first < second), "{ids:?}");
        for Mistake { class, id, .. } in Mistake::ALL {
            let digits = id
                .strip_prefix(class.id())
                .and_then(|rest| rest.strip_prefix('-'));
            let digits = digits.unwrap_or_else(|| panic!("{id} is not part of {}", class.id()));
            assert!(
                digits.len() == 2 && digits.bytes().all(|digit| digit.is_ascii_digit()),
                "{id}"
            );
        }
        for class in Code::ALL {
            assert_ne!(Mistake::of_class(*class).count(), 1, "{}", class.id());
        }
    }

    #[test]
    fn the_codes_of_reasons_are_those_of_mistakes_each_of_another_class() {
        let mut used = HashSet::new();
        for reason in message::each(0) {
            let mut classes = HashSet::new();
            for code in reason.codes() {
                let mut mistakes = Mistake::ALL.iter();
                let mistake = mistakes.find(|mistake| mistake.id == *code);
                let mistake = mistake.unwrap_or_else(|| panic!("{reason}: there is no {code}"));
                assert!(classes.insert(mistake.class), "{reason}: {code}");
                used.insert(mistake.id);
            }
        }
        for mistake in Mistake::ALL {
            assert!(used.contains(mistake.id), "no reason has {}", mistake.id);
        }
    }
}
