//! The finer codes: the kinds of mistakes that one code covers, each by the reasons that belong to it.

use super::Code;
use crate::message::{
    Calculating, Commanding, ForeignWord, Lang, Message, Naming, Parsing, Reading, Structuring,
};

/// One kind of mistake, of several that a code covers.
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

    /// Returns the kinds that a code covers; none of a code that covers one kind only.
    pub fn of_class(class: Code) -> impl Iterator<Item = &'static Mistake> {
        Self::ALL
            .iter()
            .filter(move |mistake| mistake.class == class)
    }
}

macro_rules! mistakes {
    ($(
        $class:ident $id:literal $english:literal, $japanese:literal:
        $( $table:ident { $( $row:ident )+ } )+;
    )*) => {
        impl Mistake {
            /// Every kind, in order of the codes.
            pub const ALL: &'static [Mistake] = &[$( Mistake {
                class: Code::$class,
                id: $id,
                english: $english,
                japanese: $japanese,
            }, )*];

            /// Returns the kind that a reason is of.
            pub const fn of(class: Code, reason: &Message) -> Option<&'static Mistake> {
                match (class, reason) {
                    $( $(
                        (Code::$class, Message::$table($( $table::$row { .. } )|+)) => Some(&Mistake {
                            class: Code::$class,
                            id: $id,
                            english: $english,
                            japanese: $japanese,
                        }),
                    )+ )*
                    _ => None,
                }
            }

            /// Class, table and row of each reason.
            #[cfg(test)]
            pub(crate) const REASONS: &'static [(Code, &'static str, &'static str)] = &[
                $( $( $( (Code::$class, stringify!($table), stringify!($row)), )+ )+ )*
            ];
        }
    };
}

// A number is chosen once: a kind that is new takes the next one of its class.
mistakes! {
    Format "E105-01" "a character that cannot stand there", "そこには書けない文字":
        Parsing { ForeignCharacters ControlCharacter };
    Format "E105-02" "a line or a name that is too long", "長すぎる行や名前":
        Parsing { LineTooLong NameTooLong };
    Format "E105-03" "a word that must be alone on its line", "1行に単独で書く語":
        Parsing { NotAlone };
    Format "E105-04" "ELSE IF in two words", "2語に分かれたELSE IF":
        ForeignWord { ElseIfInTwo };
    Format "E105-05" "a line break in a MESSAGE", "MESSAGEの中の改行":
        Parsing { LineBreak };
    Format "E105-06" "bytes that are not text", "文字として読めないバイト":
        Reading { NotValid };

    Equation "E107-01" "a left side that is not one variable", "1つの変数ではない左辺":
        Parsing { OneVariableLeft ConstantAssigned StartsWithVariable }
        Calculating { LeftSideSign }
        Naming { ReadingAssigned };
    Equation "E107-02" "more than one operation or function", "2つ以上の演算や関数":
        Parsing { OperatorOrNothing EquationEnds FunctionCannotStandHere };
    Equation "E107-03" "a missing operand", "足りない数値や変数":
        Parsing { OperandMissing };
    Equation "E107-04" "a sign that stands apart", "離れた符号":
        Parsing { SignStandsBefore BetweenArguments PlusBeforeConstants };
    Equation "E107-05" "neither a number nor a name nor a member", "数値でも変数名でもメンバでもない語":
        Parsing { NoNumber NoMember ForeignInName ConstantTooLarge NoOperand NoSuchFunction }
        Naming { NoMember };
    Equation "E107-06" "types that do not go together", "一緒に計算できない型":
        Calculating { SidesDiffer NotTogether BelongsHere StructSign }
        Commanding { StructForNumber ConstantOrVar };
    Equation "E107-07" "a function with too many or too few operands", "関数に渡す値の過不足":
        Calculating { OtherOperands };
    Equation "E107-08" "an operator of another language", "ほかの言語の演算子":
        ForeignWord { NoOperator };

    UnknownCommand "E204-01" "a word that is not a command", "コマンドではない語":
        Commanding { NoCommand };
    UnknownCommand "E204-02" "a command that the robot lacks", "ロボットにないコマンド":
        Commanding { RobotLacks };
    UnknownCommand "E204-03" "a variable without an operator", "演算子のない変数":
        Commanding { VariableNotCommand };
    UnknownCommand "E204-04" "a label without its colon", "コロンのないラベル":
        Parsing { LabelColonMissing };
    UnknownCommand "E204-05" "an equation of another language", "ほかの言語の式":
        ForeignWord { NoOperator SplitOperator CompareAsStatement };

    Argument "E205-01" "too few arguments", "引数の不足":
        Commanding { TooFew Missing }
        Parsing { OperandMissing OperandMissingBefore };
    Argument "E205-02" "too many arguments", "多すぎる引数":
        Commanding { TooMany ToleranceElsewhere };
    Argument "E205-03" "a missing target", "対象の書き忘れ":
        Commanding { WantsTarget TargetBelongsHere };
    Argument "E205-04" "a target that the robot lacks", "ロボットにない対象":
        Commanding { RobotHasNo };
    Argument "E205-05" "a joint after a command for feet", "足先のコマンドに書いた関節":
        Commanding { MovesFeet };
    Argument "E205-06" "a target that the command does not take", "そのコマンドでは使えない対象":
        Commanding { OtherTargets };
    Argument "E205-07" "R, A or HS where it cannot stand", "R、A、HSを書けないところ":
        Commanding { FlagBeforeNumber NoFlag };
    Argument "E205-08" "a value of another type", "型の合わない値":
        Commanding { OtherType StructForNumber ConstantOrVar WantsTwoJoints };
    Argument "E205-09" "no variable to fill", "値を受け取る変数でないもの":
        Commanding { PosVariable JointVariable VarOrJointMember VarBelongsHere };
    Argument "E205-10" "a number that nothing has", "存在しない番号":
        Commanding { OneBoard Channels NativeCommands };
    Argument "E205-11" "a variable in the place of a constant", "定数のところにある変数":
        Commanding { ConstantBelongsHere }
        Naming { NotConstant };
    Argument "E205-12" "an input that the robot lacks", "ロボットにない入力":
        Commanding { NoInput }
        Naming { NotSensed };
    Argument "E205-13" "an event flag that the robot lacks", "ロボットにないイベントフラグ":
        Commanding { NoEventFlag };
    Argument "E205-14" "a condition that compares nothing", "何も比較しない条件式":
        Commanding { VariableNoCondition }
        Parsing { ComparedWithNothing ConditionMissing };
    Argument "E205-15" "a wrong relation", "関係演算子の誤り":
        Parsing { NoRelation AssignsComparesNothing RelationBelongsHere }
        ForeignWord { NotEqual SplitOperator };
    Argument "E205-16" "more than a condition can say", "条件式に書けないこと":
        ForeignWord { AndOr Not }
        Parsing { NotStandsBeforeFlag ConditionCannotCalculate CannotStandHere };
    Argument "E205-17" "THEN, GOTO and GOSUB of an IF", "IFのTHEN、GOTO、GOSUB":
        Parsing { ThenOrJumpBelongsHere ThenBelongsHere IfCannotCall }
        ForeignWord { ThenJumps OneLineIf };
    Argument "E205-18" "a FOR or NEXT of another form", "FORとNEXTの形の誤り":
        Parsing { ToBelongsHere ForEnds VariableBelongsHere AssignmentBelongsHere NextNamesItsVariable }
        Commanding { CountsVar }
        ForeignWord { ForCounts };
    Argument "E205-19" "an incomplete label", "不完全なラベル":
        Parsing {
            LabelBelongsHere LabelMissing BlankBeforeColon LabelColonMissing LabelNameMissing
            NameColonMissing NameBelongsHere NameMissing
        };
    Argument "E205-20" "a call that does not fit its label", "ラベルに合わない呼び出し":
        Structuring { PlainLabel LoopForGoto NoThread CalledThread };
    Argument "E205-21" "a name that cannot be used", "使えない名前":
        Naming { NoVariableName NoLabelName WordOfLanguage SubroutineLoop ThreadLoop };
    Argument "E205-22" "a variable declared twice", "二重に宣言した変数":
        Naming { DeclaredAgain };
    Argument "E205-23" "a declaration of anything but names", "変数名だけではない宣言":
        Parsing { OnlyNames }
        Naming { NoNames }
        ForeignWord { NoInitial };
    Argument "E205-24" "a sign that stands apart", "離れた符号":
        Parsing { SignStandsBefore BetweenArguments PlusBeforeConstants }
        ForeignWord { NoOperator };
    Argument "E205-25" "neither a number nor a name nor a member", "数値でも変数名でもメンバでもない語":
        Parsing { NoNumber NoMember ForeignInName ConstantTooLarge NoOperand }
        Naming { NoMember };
    Argument "E205-26" "words after the end of a statement", "文の終わりの後に続く語":
        Parsing { NothingBehind }
        ForeignWord { NoBraces NoColon };
    Argument "E205-27" "a MESSAGE without a blank", "空白のないMESSAGE":
        Parsing { BlankBehindMessage };
    Argument "E205-28" "more threads than a program may have", "多すぎるスレッド":
        Naming { TooManyThreads };

    Structure "E207-01" "a block that is not closed", "閉じていないブロック":
        Structuring { NotClosed };
    Structure "E207-02" "a word without its block", "対応するブロックのない語":
        Structuring { NothingOpen };
    Structure "E207-03" "a SUBROUTINE inside a block", "ブロックの中のSUBROUTINE":
        Structuring { SubroutineInside ThreadInside };
    Structure "E207-04" "a branch after ELSE", "ELSEより後の分岐":
        Structuring { BehindElse };
    Structure "E207-05" "a NEXT with another variable", "変数の違うNEXT":
        Structuring { NextNames NextNamesAnother };
    Structure "E207-06" "a jump into a block", "ブロックの中へのジャンプ":
        Structuring { Enters };
    Structure "E207-07" "a GOTO out of a SUBROUTINE", "SUBROUTINEの外へのGOTO":
        Structuring { LeavesSubroutine LeavesThread };
    Structure "E207-08" "END and a word in the place of one", "2語に分かれた終わりの語":
        ForeignWord { EndInTwo };
    Structure "E207-09" "a way that runs into a SUBROUTINE or THREAD", "SUBROUTINEやTHREADに上から入る経路":
        Structuring { RunsIntoSubroutine RunsIntoThread };
}

#[cfg(test)]
mod tests;
