//! Words and spellings of other languages, with what is written here in their place. It never looks at programs.

mod command;
mod word;

pub use command::command;
pub use word::{axis_value, flag, is_g_code, is_speed, tells_time};

use crate::language::functions::{Axis, Operation};
use crate::language::reserved::LOOP;
use crate::language::{Edition, Keyword, flags};
use crate::message::ForeignWord;
use crate::syntax::{VariableKind, upper_case};
use std::collections::HashMap;
use std::sync::LazyLock;
use tip_runtime::function::Function;

/// Role of an unknown first word among the blocks, so that one mistake does not lead to others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Means {
    /// This keyword.
    Keyword(Keyword),
    /// A declaration of variables.
    Declaration(VariableKind),
    /// Something that no other statement depends on.
    Statement,
}

/// First words of statements.
pub struct Row {
    words: &'static str,
    pub means: Means,
    pub advice: ForeignWord,
}

const fn row(words: &'static str, means: Means, advice: ForeignWord) -> Row {
    Row {
        words,
        means,
        advice,
    }
}

/// Words with blanks between, what they mean, and what to write.
#[rustfmt::skip]
const ROWS: &[Row] = &[
    row("PRINT PRINTF PRINTLN ECHO DISP DISPLAY WRITE WRITELN PUTS SAY SHOW COUT ALERT LOG DEBUG TEXT MSG MESS FPRINTF SERIAL.PRINT SERIAL.PRINTLN CONSOLE.LOG SYSTEM.OUT.PRINTLN TPWRITE TYPE SERIAL.WRITE LCD.PRINT DISPLAY_TEXT SHOW_TEXT ?", Means::Statement, ForeignWord::ShowText),
    row("ELIF ELSIF ELSE_IF ELSEIFTHEN", Means::Keyword(Keyword::ElseIf), ForeignWord::ElseIf),
    row("FI END_IF IFEND END-IF", Means::Keyword(Keyword::EndIf), ForeignWord::EndIf),
    row("ENDWHILE END_WHILE ENDW WHEND WHILEEND WHILE_END", Means::Keyword(Keyword::Wend), ForeignWord::Wend),
    row("ENDFOR END_FOR FOREND FOR_END", Means::Keyword(Keyword::Next), ForeignWord::Next),
    row("ENDSUB END_SUB SUB_END ENDSUBROUTINE END_SUBROUTINE ENDPROC ENDFUNC ENDFUNCTION END_FUNCTION ENDPROCEDURE", Means::Keyword(Keyword::SubEnd), ForeignWord::SubEnd),
    row("REMARK COMMENT NOTE", Means::Statement, ForeignWord::Comment),
    row("RET", Means::Statement, ForeignWord::Return),
    row("DO", Means::Statement, ForeignWord::Loops),
    row("BREAK LEAVE EXITFOR EXIT_FOR EXITWHILE EXIT_WHILE", Means::Statement, ForeignWord::Break),
    row("CONTINUE CYCLE", Means::Statement, ForeignWord::Continue),
    row("WAIT DELAY PAUSE USLEEP MSLEEP TIMER WAIT_TIME WAITTIME WAIT_MS WAIT_SEC WAIT_FOR WAITFOR WAIT_UNTIL WAITUNTIL WAIT_MOVE TWAIT TIME.SLEEP SLEEP_MS DWELL G4 G04 INPOS IN_POS WAIT_FOR_INPOS WAIT_IN_POSITION WAIT_POS WAIT_MOTION WAIT_ALL WAIT_STOP WAIT_END WAIT_KB WAIT_KB_HIT SYNC DLY SWAIT WAITDI WAITDO", Means::Statement, ForeignWord::Wait),
    row("VAR DIM INT INTEGER FLOAT DOUBLE REAL NUM NUMBER LOCAL GLOBAL DEF DECLARE DEFVAR DEF_INT DEF_INTEGER DEF_FLOAT DEF_DOUBLE DEF_REAL DEF_NUM DEF_NUMBER DEF_BOOL DEF_STRING DEF_STR DEF_ARRAY DEF_VARIABLE DECL LONG BYTE UINT8_T INT16_T BOOL BOOLEAN STRING CHAR", Means::Declaration(VariableKind::Var), ForeignWord::Declare),
    row("CONST DEFINE #DEFINE DEF_CONST CONSTANT", Means::Declaration(VariableKind::Var), ForeignWord::Constant),
    row("POS POINT POSITION VECTOR DEFPOS DEF_POINT DEF_POSITION DEF_VECTOR DEF_COORD", Means::Declaration(VariableKind::Pos), ForeignWord::Declare),
    row("JOINT ANGLES DEFJOINT DEF_AGL DEF_TRQ DEF_TORQUE DEF_ANG DEF_ANGLE DEF_ANGLES DEF_JNT", Means::Declaration(VariableKind::Joint), ForeignWord::Declare),
    row("LET SET ASSIGN", Means::Statement, ForeignWord::Let),
    row("SUB FUNCTION FUNC FN PROC PROCEDURE ROUTINE VOID", Means::Keyword(Keyword::Subroutine), ForeignWord::Subroutine),
    row("JUMP JMP GO BRANCH", Means::Statement, ForeignWord::Goto),
    row("MOVE MOV MOVEL MOVEJ MOVEP MOVL MOVJ MOVS DRIVE WALK MOVEC MOVEABSJ MOVE_TO MOVETO MOVE_LEG MOVE_FOOT MOVELEG G0 G1 G2 G3 G00 G01 G02 G03 LIN CIRC APPRO APPROS DEPART DEPARTS SERVO SERVO.WRITE LINE LINEAR MOVES MOVEA MOVE_L MOVE_J ARC SPTP SLIN MVS MVR JMOVE LMOVE JAPPRO LAPPRO JDEPART LDEPART APPROACH STEP_TO GOTO_POS", Means::Statement, ForeignWord::Move),
    row("STOP HALT HLT M0 M00 M1 M01 ESTOP E_STOP BRAKE STOPMOVE EMERGENCY EMERGENCY_STOP EMG EMG_STOP", Means::Statement, ForeignWord::Stop),
    row("QUIT TERMINATE ABORT FINISH M2 M02 M30", Means::Statement, ForeignWord::Exit),
    row("INPUT PROMPT INKEY INKEY$ GETCH GETCHAR GETC GETKEY GET_KEY READKEY READ_KEY WAITKEY WAIT_KEY KEY SCANF READ SERIAL.READ", Means::Statement, ForeignWord::KeyIn),
    row("IN ADC AIN ADIN ANALOGREAD ANALOG_READ DIGITALREAD", Means::Statement, ForeignWord::AdIn),
    row("OUT DOUT LED LED0 LED1 LED2 LAMP LAMP0 LAMP1 LAMP2 DIGITALWRITE SETDO SET_DO RELAY RELAY_ON RELAY_OFF LED_ON LED_OFF SIGNAL SETOUT SET_OUT PULSE", Means::Statement, ForeignWord::Lamp),
    row("SWITCH SELECT", Means::Statement, ForeignWord::Cases),
    row("SPEED VEL VELOCITY SETSPEED SET_SPEED VELSET OVRD SPD JOVRD FEED FEEDRATE SET_VEL SET_VELOCITY", Means::Statement, ForeignWord::Speed),
    row("ACC ACCEL ACCELERATION DECEL ACCSET SETACC SETACCEL SET_ACC SET_ACCEL SET_ACCELERATION", Means::Statement, ForeignWord::Acceleration),
    row("TEACH GETPOS GET_POS GET_POSITION READPOS READ_POS READ_POSITION CURPOS CURRENT_POS GETANGLE GET_ANGLE GET_ANGLES READ_ANGLE HERE WHERE", Means::Statement, ForeignWord::Teach),
    row("HOME RESET INIT INITIALIZE INITIALISE G28 GOHOME GO_HOME HOMING", Means::Statement, ForeignWord::Home),
    row("SERVO_ON SERVO_OFF SERVOON SERVOOFF SVON SVOFF MOTOR_ON MOTOR_OFF MOTORS_ON MOTORS_OFF POWER_ON POWER_OFF TORQUE_ON TORQUE_OFF", Means::Statement, ForeignWord::Motors),
    row("CLS CLEAR CLRSCR CLEAR_SCREEN CLEARSCREEN CLC TPERASE", Means::Statement, ForeignWord::ClearText),
    row("PASS NOP NOOP", Means::Statement, ForeignWord::Nothing),
    row("UNLESS", Means::Keyword(Keyword::If), ForeignWord::WriteNot),
    row("WHEN WHENEVER ON IF_GOTO IF_GOSUB IF_CALL", Means::Statement, ForeignWord::Ask),
    row("INC INCR INCREMENT DEC DECR DECREMENT", Means::Statement, ForeignWord::Count),
    row("PINMODE SERIAL.BEGIN SERVO.ATTACH SETMODE GPIO.SETUP GPIO.SETMODE", Means::Statement, ForeignWord::NoSetup),
    row("TRY", Means::Statement, ForeignWord::NoCatch),
    row("G90 G91", Means::Statement, ForeignWord::RelativeMark),
    row("FOREVER", Means::Statement, ForeignWord::Forever),
    row("{ } BEGIN", Means::Statement, ForeignWord::Braces),
    row("PROGRAM PROG MODULE", Means::Statement, ForeignWord::FromTheTop),
    row("INCLUDE IMPORT USE REQUIRE #INCLUDE", Means::Statement, ForeignWord::OneFile),
];

/// Returns the row of a statement's first word in another language.
pub fn statement(word: &str) -> Option<&'static Row> {
    row_of(word).or_else(|| part_of(word))
}

/// The rows of some words, by each of them.
type Index = LazyLock<HashMap<&'static str, &'static Row>>;

fn index(rows: &'static [Row]) -> HashMap<&'static str, &'static Row> {
    let words = |row: &'static Row| row.words.split(' ').map(move |word| (word, row));
    rows.iter().flat_map(words).collect()
}

/// Returns the row of [`ROWS`] with a word, whatever its case.
fn row_of(word: &str) -> Option<&'static Row> {
    static INDEX: Index = LazyLock::new(|| index(ROWS));
    INDEX.get(upper_case(word).as_str()).copied()
}

/// Returns the row of [`PARTS`] with a word, whatever its case.
fn part_of(word: &str) -> Option<&'static Row> {
    static INDEX: Index = LazyLock::new(|| index(PARTS));
    INDEX.get(upper_case(word).as_str()).copied()
}

/// First words that go on with what one of [`ROWS`] began: alone they are as wrong as that one.
#[rustfmt::skip]
const PARTS: &[Row] = &[
    row("CASE DEFAULT OTHERWISE ENDSWITCH END_SWITCH ENDSELECT END_SELECT ESAC", Means::Statement, ForeignWord::Cases),
    row("DONE OD ENDLOOP END_LOOP LOOPEND", Means::Statement, ForeignWord::Loops),
    row("CATCH EXCEPT FINALLY THROW RAISE END_TRY ENDTRY", Means::Statement, ForeignWord::NoCatch),
    row(LOOP, Means::Statement, ForeignWord::LoopLabel),
];

/// Returns true if a routine of another language is its entry point or main loop.
pub fn is_main(name: &str) -> bool {
    const NAMES: &str = "MAIN SETUP LOOP";
    NAMES.split(' ').any(|one| one.eq_ignore_ascii_case(name))
}

/// Returns true if a word goes on with what the word `first` began in another language.
pub fn goes_on(first: &str, word: &str) -> bool {
    let (begun, part) = (row_of(first), part_of(word));
    begun.zip(part).is_some_and(|(begun, part)| {
        let is_loop = begun.advice == ForeignWord::Loops && part.advice == ForeignWord::LoopLabel;
        begun.advice == part.advice || is_loop
    }) || ends_routine(first, word)
        || begins_cases(first) && row_of(word).is_some_and(|row| row.advice == ForeignWord::Break)
        || first.eq_ignore_ascii_case(LOOP)
            && part.is_some_and(|part| part.advice == ForeignWord::Loops)
}

/// Returns true if a word ends the routine that another one begins: `PROC` … `ENDPROC`.
fn ends_routine(first: &str, word: &str) -> bool {
    let begins = row_of(first).is_some_and(|row| row.advice == ForeignWord::Subroutine);
    begins && row_of(word).is_some_and(|row| row.advice == ForeignWord::SubEnd)
}

/// Returns true if a word ends a loop in another language, whatever began it.
pub fn ends_loop(word: &str) -> bool {
    part_of(word)
        .is_some_and(|row| matches!(row.advice, ForeignWord::Loops | ForeignWord::LoopLabel))
}

/// Returns true if a word begins the cases of a value; a `BREAK` ends each of them.
fn begins_cases(word: &str) -> bool {
    row_of(word).is_some_and(|row| row.advice == ForeignWord::Cases)
}

/// Returns the words of other languages for the end of a block, after END, and what ends it here.
pub fn ends(word: &str) -> Option<Keyword> {
    match row_of(word)?.means {
        Means::Keyword(Keyword::Subroutine) => Some(Keyword::SubEnd),
        _ => None,
    }
}

/// Returns true if a word begins the line of a label.
pub fn begins_label(word: &str) -> bool {
    const WORDS: &str = "LABEL LBL";
    WORDS.split(' ').any(|one| one.eq_ignore_ascii_case(word))
}

/// Returns true if a word opens the block of a condition in another language.
pub fn opens_block(word: &str) -> bool {
    ["DO", "BEGIN", ":"]
        .iter()
        .any(|one| one.eq_ignore_ascii_case(word))
}

/// Returns true if a word is a function of other languages.
pub fn is_function(word: &str) -> bool {
    const FUNCTIONS: &str =
        "MAX MIN MOD RND RAND RANDOM POW EXP LOG LOG10 LN SGN SIGN FLOOR CEIL ROUND FIX SQR HYPOT";
    FUNCTIONS
        .split(' ')
        .any(|one| one.eq_ignore_ascii_case(word))
}

/// Returns the function that another language calls otherwise.
pub fn function(word: &str) -> Option<&'static str> {
    const CALLED: &[(&str, Operation)] = &[
        ("ARCTAN ATN", Operation::Scalar(Function::Atan)),
        ("ARCSIN ASN", Operation::Scalar(Function::Asin)),
        ("ARCCOS ACS", Operation::Scalar(Function::Acos)),
        ("ARCTAN2 ANGLE", Operation::Atan2),
        ("SQR ROOT", Operation::Scalar(Function::Sqrt)),
        ("FABS MAG", Operation::Scalar(Function::Abs)),
        ("FLOOR FIX TRUNC", Operation::Scalar(Function::Int)),
        ("RADIANS TORAD", Operation::Scalar(Function::Deg2Rad)),
        ("DEGREES TODEG", Operation::Scalar(Function::Rad2Deg)),
        ("LEN LENGTH HYPOT", Operation::Norm),
        ("NORMALIZE UNIT", Operation::UnitVect),
        ("ROTX ROT-X", Operation::Rotate(Axis::X)),
        ("ROTY ROT-Y", Operation::Rotate(Axis::Y)),
        ("ROTZ ROT-Z", Operation::Rotate(Axis::Z)),
    ];
    let is_it = |row: &&(&str, Operation)| row.0.split(' ').any(|one| one == word);
    CALLED.iter().find(is_it).map(|row| row.1.word())
}

/// Returns the relation that other languages write as a word or with other signs.
pub fn relation(word: &str) -> Option<&'static str> {
    Some(match word {
        "EQ" | "IS" | "EQUALS" => "==",
        "NE" | "NEQ" | "ISNT" | "~" => "<>",
        "GT" | "GREATER" => ">",
        "LT" | "LESS" => "<",
        "GE" | "GTE" => ">=",
        "LE" | "LTE" => "<=",
        _ => return None,
    })
}

/// Returns true if a word is a type, which stands before or after a name in declarations of other languages.
pub fn is_type(word: &str) -> bool {
    const TYPES: &str = "INT INTEGER FLOAT DOUBLE";
    TYPES.split(' ').any(|one| one.eq_ignore_ascii_case(word))
}

/// Returns true if a character has no width, so that nobody sees it.
pub fn is_invisible(char: char) -> bool {
    matches!(char, '\u{AD}' | '\u{200B}'..='\u{200F}' | '\u{2060}'..='\u{2064}' | '\u{FEFF}')
}

/// Returns true if a word is a unit, which no number has.
pub fn is_unit(word: &str) -> bool {
    const UNITS: &str =
        "% MM CM M DEG RAD S SEC MS MSEC N NM V HZ KHZ ° 度 ㎜ ㎝ 秒 ミリ ミリ秒 ℃ ％";
    UNITS.split(' ').any(|one| one.eq_ignore_ascii_case(word))
}

/// Returns the name that a word begins with: `PRINT` of `PRINT("…")`, `time.sleep` of `time.sleep(1)`.
pub fn name(word: &str) -> &str {
    let end = word.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_' || c == '.'));
    &word[..end.unwrap_or(word.len())]
}

/// Returns true if a statement that begins with this word was to show a text.
pub fn shows_text(word: &str) -> bool {
    let name = name(word);
    let is_message = name.eq_ignore_ascii_case(Keyword::Message.word());
    is_message || statement(name).is_some_and(|row| row.advice == ForeignWord::ShowText)
}

/// The marks of comments in other languages.
const COMMENTS: &[&str] = &[
    "#", "'", "/*", "*/", "--", "%", "(*", "\"\"\"", "\\\\", "・・", "／／", "※", "＃", "’",
];

/// Openers and closers of comments of several lines.
const OF_LINES: &[[&str; 2]] = &[["/*", "*/"], ["\"\"\"", "\"\"\""], ["'''", "'''"]];

/// Returns opener and closer of a comment of several lines that begins a statement.
pub fn comment_of_lines(statement: &str) -> Option<[&'static str; 2]> {
    let mut marks = OF_LINES.iter().copied();
    marks.find(|[opens, _]| statement.starts_with(opens))
}

/// The mark of comments in Fortran and Modula; the language negates flags with it.
const BANG: &str = "!";

/// Returns true if a statement is a comment in another language.
pub fn is_comment(statement: &str) -> bool {
    // Nearly all statements begin with a word.
    if statement.starts_with(|first: char| first.is_ascii_alphanumeric()) {
        return false;
    }
    let is_marked = COMMENTS.iter().any(|mark| statement.starts_with(mark))
        || is_banged(statement)
        || is_in_parentheses(statement);
    // `#include` is none.
    let first = || statement.split_whitespace().next().unwrap_or_default();
    is_marked && self::statement(first()).is_none()
}

/// `! text`, but not `!KB_HIT`.
fn is_banged(statement: &str) -> bool {
    let mut words = statement.strip_prefix(BANG).unwrap_or_default().split(' ');
    let first = words.next().unwrap_or_default().to_ascii_uppercase();
    words.next().is_some() && flags::find(&first, Edition::default()).is_none()
}

/// `(move to start)`, a comment of G-code. Numbers and signs are rather a calculation.
fn is_in_parentheses(statement: &str) -> bool {
    let inside = statement
        .trim_end()
        .strip_prefix('(')
        .and_then(|rest| rest.strip_suffix(')'));
    inside.is_some_and(|inside| {
        inside.contains(' ') && inside.chars().all(|it| it.is_alphabetic() || it == ' ')
    })
}

/// Returns true if a comment of another language, or what is taken for one, begins where this part of a line ends.
pub fn ends_in_comment_mark(part: &str) -> bool {
    let part = part.trim_end();
    part.ends_with(';') || COMMENTS.iter().any(|mark| part.ends_with(mark))
}

/// Returns the plain spelling of a typographic character.
pub fn plain(typeset: char) -> Option<&'static str> {
    Some(match typeset {
        '\u{2010}'..='\u{2015}' | '\u{2212}' => "-",
        '×' => "*",
        '÷' => "/",
        '≠' => "<>",
        '≧' | '≥' => ">=",
        '≦' | '≤' => "<=",
        '、' => ",",
        '←' => "=",
        'ﬁ' => "fi",
        'ﬂ' => "fl",
        _ => return None,
    })
}

/// Returns true if a text stands between the ends of a range: `1〜10`.
pub fn is_range(text: &str) -> bool {
    matches!(text, "〜" | "～" | "~")
}

/// Returns the mark that a comment of another language begins with.
pub fn comment_mark(comment: &str) -> Option<&'static str> {
    let mut marks = COMMENTS.iter().copied().chain([BANG]);
    marks.find(|mark| comment.starts_with(mark))
}

/// Returns the start of a comment of another language after a statement, if there is one.
pub fn comment_after(line: &str) -> Option<usize> {
    let marks = ["#", "'", "／／", "※", "＃", "’"];
    let starts = |at: &usize| marks.iter().any(|mark| line[*at..].starts_with(mark));
    let after_blank = line.match_indices([' ', '\t']).map(|(at, _)| at + 1);
    after_blank.into_iter().find(starts)
}

/// Returns the number to write in place of a constant of another language.
pub fn constant(word: &str) -> Option<&'static str> {
    Some(match word {
        "TRUE" | "ON" | "YES" | "HIGH" => "1",
        "FALSE" | "OFF" | "NO" | "LOW" | "NULL" | "NIL" | "NONE" => "0",
        "PI" | "M_PI" => "3.14159265",
        _ => return None,
    })
}

/// Returns true if a word joins two conditions in another language.
pub fn joins_conditions(word: &str) -> bool {
    ["AND", "OR", "XOR", "&&", "||", "&", "|"]
        .iter()
        .any(|one| one.eq_ignore_ascii_case(word))
}

/// Returns true if a word negates in another language.
pub fn negates(word: &str) -> bool {
    word.eq_ignore_ascii_case("NOT")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::{Edition, commands, keywords};
    use std::collections::HashSet;

    #[test]
    fn no_word_of_the_language_is_foreign_and_none_stands_twice() {
        let mut seen = HashSet::new();
        for word in ROWS
            .iter()
            .chain(PARTS)
            .flat_map(|row| row.words.split(' '))
        {
            assert!(seen.insert(word), "{word} twice");
            assert!(keywords::find(word, Edition::V3_1).is_none(), "{word}");
            assert!(commands::find(word).is_none(), "{word}");
            assert_eq!(commands::renamed(word), None, "{word}");
        }
    }

    #[test]
    fn comments_of_other_languages_are_known() {
        for text in ["# x", "#x", "'x", "/* x */", "-- x", "% x", "! x", "!x y"] {
            assert!(is_comment(text), "{text}");
        }
        for text in [
            "A = 1",
            "PTP F1",
            "#include <x>",
            "-A = 1",
            "!KB_HIT",
            "!KB_HIT GOTO L1:",
            "!x",
        ] {
            assert!(!is_comment(text), "{text}");
        }
    }
}
