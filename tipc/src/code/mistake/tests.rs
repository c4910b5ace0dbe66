use super::Mistake;
use crate::code::Code;
use crate::message::ROWS;
use std::collections::HashSet;

/// Rows that are reasons of codes which cover one kind of mistake only.
const PLAIN: &[(&str, &str)] = &[
    (
        "Reading",
        "System Folder NoFile NotAllowed NotRegular TooLarge Changed Linked TwoFiles OtherCharacters",
    ),
    (
        "Parsing",
        "OtherVersion NoVersion MoreThanVersion ProgramEndsHere TextEndsHere TextTooLong FileTextTooLong",
    ),
    ("Commanding", "OutOfRange NeverEnds"),
    (
        "Calculating",
        "DividedByZero NoSquareRoot NoResult NoDirection",
    ),
    (
        "Naming",
        "ReadAsFlag NotDeclared NoNumber NothingUses NothingReads AssignedNowhere NoValueOnAnyWay DefinedBelow
         NothingUsesConstant NoReading",
    ),
    ("Structuring", "NoSuchLabel NoLoopAbove NextCounts RunsInto"),
];

/// Rows that are not reasons: helps and labels.
const BESIDE: &[(&str, &str)] = &[
    ("Reading", "NotTheOtherEither SaveInThatEncoding"),
    (
        "Parsing",
        "StartWithVersion BreakTheLine PutEnd WriteHalfWidth TakeOut WantsOwnLine LabelBeforeCommentBehind
         NextStatementElsewhere WriteJump WriteLabel SeparateNames CommentElsewhere Escapes FullWidthCounts GosubCalls
         WriteThenOrJump WriteFor WriteSubroutine Conditions Relations LeftSide OneOperation SeparateArguments LeavePlusOut
         Constants Members NoParentheses NameCharacters PlainNames WriteEquation WriteThread WriteDefine",
    ),
    (
        "Commanding",
        "NeedsForces CommandOf OperatorBehindVariable CalledNow LabelOrEquation Write NameMember CopyIntoVar Takes RobotHas
         Inputs InputsWith CountOtherwise CountVar Compare Flags FlagsWith",
    ),
    (
        "Calculating",
        "LeftSideIs LeftSide OneType WholeVariable ChangeMembers WriteOfTwo WriteOfStruct WriteOfPos WriteRotation
         WriteFunction DivideByAnother SqrtTakes TakesToOne TakesToOneOrRatio AnotherThanZero",
    ),
    (
        "Naming",
        "ChooseAnother FlagHere FirstDeclared DeclaredHere LabelCharacters OwnName WriteNames VariableCharacters DeclareOnce NumberBelongsHere
         Declare DeclareAs AlsoHere VarMembers PosMembers JointMembers AssignBefore ConstantIs DefineAbove ConstantMembers Readings
         ReadingMembers",
    ),
    (
        "Structuring",
        "StillOpen CloseBefore Else ElseIsLast Opens Open StandsHere CloseWith SubroutineBefore WordBefore EndsBefore
         VariableOfFor JumpsHere DidYouMean DeclareLabel GosubCalls OwnLabel PutLoop MoveOut JumpBefore CallIt BlockStarts
         Label SubroutineStarts LeaveWith For PutJumpAbove ReturnOfGosub IfFirst SubEndCloses ClosesOuter ThreadStarts ThreadEndsAt
         OnlyThreads StartIt ThreadEndCloses",
    ),
    (
        "ForeignWord",
        "Plain PlainBlank NoBrackets NoText NoTarget OneLine GoesOnHere FlagOfTarget CommandNoCondition WriteThen
         WithoutColon NextStatement Update Power Remainder EachMember FunctionInEquation CalculateArgument FastFirst FlagApart OneTarget
         JointName ArgumentNames NoUnit NoHex NoLineNumbers SemicolonEndsText AfterEnd MoveEndOrComment EndsTheText StandsAfterEnd GoesOn
         NoHyphen NoArray WriteRelation CalculateBefore BlockBegins FlagAlone Character CharacterOrVariable
         ShowText ElseIf EndIf Wend Next SubEnd Return Loops Break Continue Wait Declare Let Subroutine Goto Move Stop Exit
         KeyIn AdIn Lamp Cases Speed Acceleration Teach Home Braces LoopLabel OneFile TargetFirst Glued Comment EachLine Increment WriteSigned
         Assign Initial Nest WriteNot WriteNotEqual Forever LeaveThenOut CloseOneLineIf InOneWord Number Comma Migrate Title
         TitleHere OtherEncoding Nothing Ask Motors ClearText KeyFirst TargetBefore InnerFirst NoParameters UntilCloses WithoutEquals
         NoSetup Constant NoCatch RelativeMark Count FromTheTop ChooseByIf AssignEach",
    ),
    (
        "Suggestion",
        "DidYouMean Write BlankAfter ElseOnNextLine ElseInBlock CountTo CommentOrName NoNumbers NumberedToo Digits Invisible ReadInput OfFoot OfJoint
         CommandFirst Keys ColonSeparates NoParentheses WithoutParentheses OpenBlock Limit Functions MemberByMember TypeLeftOut ShorterName
         Call JumpTo NoValues NoResult LeaveSubroutine Alone NextEach GotoLoop Closes
         CountTimes NumberOrVariable LargestNumber NoClock NestWithoutParentheses TitleInLineTwo FlagHere OtherName",
    ),
];

/// Tables of which no row is a reason of a code that covers several kinds.
const OTHERS: &[&str] = &["Warning", "Allowing", "Describing", "Building"];

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
fn every_reason_has_its_code() {
    let listed = |list: &[(&'static str, &'static str)]| -> HashSet<(&str, &str)> {
        let rows = |(table, rows): &(&'static str, &'static str)| {
            let table = *table;
            rows.split_whitespace().map(move |row| (table, row))
        };
        list.iter().flat_map(rows).collect()
    };
    let finer: HashSet<(&str, &str)> = Mistake::REASONS
        .iter()
        .map(|(_, table, row)| (*table, *row))
        .collect();
    let lists = [&finer, &listed(PLAIN), &listed(BESIDE)];
    let rows = ROWS.iter().copied().flatten();
    let rows = rows.filter(|row| !OTHERS.contains(&row.table));
    let mut all = HashSet::new();
    for row in rows {
        let name = (row.table, row.row);
        let count = lists.iter().filter(|list| list.contains(&name)).count();
        assert_eq!(
            count, 1,
            "{name:?} belongs to one of the mistakes in code/mistake.rs, or to one list of this test"
        );
        all.insert(name);
    }
    for name in lists.into_iter().flatten() {
        assert!(all.contains(name), "there is no row {name:?}");
    }
}

#[test]
fn no_reason_stands_twice_in_a_class() {
    let mut seen = HashSet::new();
    for reason in Mistake::REASONS {
        assert!(seen.insert(reason), "{reason:?}");
    }
}
