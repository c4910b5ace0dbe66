//! Words of other languages, and their replacements in T.I.P.
//!
//! The compiler marks the diagnostic of a word that it does not know. An entry of this table replaces its help.

use crate::Loaded;
use crate::fix::Fixer;
use crate::fix::texts::{name, print};
use crate::fix::words as fixes;
use crate::message::Foreign;
use tipc::code::Code;
use tipc::diagnostic::Diagnostic;
use tipc::language::Keyword;
use tipc::message::{Message, Parsing, Suggestion};
use tipc::source::{Source, Span};
use tipc::syntax::upper_case;

/// A place of a word in a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Place {
    /// The first word.
    First,
    /// A number or a variable.
    Operand,
    /// The condition of an IF or a loop.
    Condition,
}

/// Words with the same meaning.
struct Row {
    place: Place,
    words: &'static str,
    /// First words of later parts of the same construct: they are reported with it as one mistake.
    parts: &'static str,
    help: fn(&str) -> Message,
    fix: Fixer,
}

const fn row(words: &'static str, help: fn(&str) -> Message, fix: Fixer) -> Row {
    Row {
        place: Place::First,
        words,
        parts: "",
        help,
        fix,
    }
}

impl Row {
    const fn with(self, parts: &'static str) -> Row {
        Row { parts, ..self }
    }

    const fn at(self, place: Place) -> Row {
        Row { place, ..self }
    }

    fn goes_on_with(&self, word: &str) -> bool {
        self.parts.split(' ').any(|part| part == word)
    }
}

/// Words with blanks between them, the help, and the source of the fix.
#[rustfmt::skip]
const ROWS: &[Row] = &[
    row("PRINT PRINTF PRINTLN ECHO DISP DISPLAY WRITE WRITELN PUTS SAY SHOW COUT ALERT LOG DEBUG TEXT MSG MESS SERIAL.PRINT SERIAL.PRINTLN CONSOLE.LOG SYSTEM.OUT.PRINTLN TPWRITE TYPE LCD.PRINT SHOW_TEXT ?", |_| Foreign::ShowText.into(), print),
    row("ELIF ELSIF ELSE_IF", |_| Suggestion::ElseIf.into(), fixes::branch),
    row("FI END_IF IFEND END-IF", |_| Foreign::EndIf.into(), |site| fixes::closer(site, Keyword::EndIf)),
    row("ENDWHILE END_WHILE ENDW WHEND WHILE_END", |_| Suggestion::Wend.into(), |site| fixes::closer(site, Keyword::Wend)),
    row("ENDFOR END_FOR FOREND FOR_END", |_| Suggestion::Next.into(), |site| fixes::closer(site, Keyword::Next)),
    row("ENDSUB END_SUB SUB_END ENDSUBROUTINE END_SUBROUTINE ENDPROC ENDFUNC ENDFUNCTION END_FUNCTION ENDPROCEDURE", |_| Suggestion::SubEnd.into(), |site| fixes::closer(site, Keyword::SubEnd)),
    row("REMARK COMMENT NOTE", |_| Suggestion::Comment.into(), fixes::none),
    row("RET", |_| Foreign::Return.into(), |site| fixes::closer(site, Keyword::Return)),
    row("DO", |_| Foreign::Loops.into(), fixes::none).with("LOOP DONE OD ENDLOOP END_LOOP"),
    row("DONE OD ENDLOOP END_LOOP", |_| Foreign::Loops.into(), fixes::none),
    row("BREAK LEAVE EXITFOR EXIT_FOR EXITWHILE EXIT_WHILE", |_| Suggestion::Break.into(), fixes::none),
    row("CONTINUE CYCLE", |_| Foreign::Continue.into(), fixes::none),
    row("WAIT DELAY PAUSE USLEEP MSLEEP TIMER WAIT_TIME WAITTIME WAIT_MS WAIT_SEC WAIT_FOR WAITFOR WAIT_UNTIL WAITUNTIL WAIT_MOVE TWAIT TIME.SLEEP SLEEP_MS DWELL G4 G04 INPOS IN_POS WAIT_POS WAIT_MOTION WAIT_ALL WAIT_STOP WAIT_END DLY", |_| Foreign::Wait.into(), fixes::wait),
    row("VAR INT INTEGER FLOAT DOUBLE REAL NUM NUMBER LOCAL GLOBAL DECLARE DEFVAR DEF_INT DEF_FLOAT DEF_REAL DEF_NUM DEF_VARIABLE LONG BYTE BOOL STRING CHAR", |_| Foreign::Declare.into(), |site| fixes::declaration(site, Keyword::DefVar)),
    row("DIM", arrays, |site| fixes::declaration(site, Keyword::DefVar)),
    row("DEF", define, |site| fixes::declaration(site, Keyword::DefVar)),
    row("POS POINT POSITION VECTOR DEFPOS DEF_POINT DEF_POSITION DEF_VECTOR", |_| Foreign::Declare.into(), |site| fixes::declaration(site, Keyword::DefPos)),
    row("JOINT ANGLES DEFJOINT DEF_AGL DEF_TRQ DEF_ANG DEF_ANGLE DEF_ANGLES DEF_JNT", |_| Foreign::Declare.into(), |site| fixes::declaration(site, Keyword::DefJoint)),
    row("CONST DEFINE DEF_CONST CONSTANT", |_| Foreign::Constant.into(), fixes::constant),
    row("LET SET ASSIGN", |_| Foreign::Let.into(), fixes::assignment),
    row("SUB FUNCTION FUNC FN PROC PROCEDURE ROUTINE VOID", |_| Foreign::Subroutine.into(), fixes::subroutine).with("ENDSUB END_SUB ENDPROC ENDFUNC ENDFUNCTION END_FUNCTION ENDPROCEDURE"),
    row("LABEL LBL", label, fixes::none),
    row("JUMP JMP GO BRANCH", |_| Foreign::Goto.into(), fixes::goto),
    row("MOVE MOV MOVEL MOVEJ MOVEP MOVL MOVJ MOVS DRIVE WALK MOVEC MOVE_TO MOVETO MOVE_LEG MOVE_FOOT G0 G1 G00 G01 LIN CIRC APPRO DEPART SERVO SERVO.WRITE LINE LINEAR MOVES MOVE_L MOVE_J MVS JMOVE LMOVE APPROACH STEP_TO GOTO_POS", |_| Foreign::Move.into(), fixes::none),
    row("STOP HALT HLT M0 M00 ESTOP E_STOP BRAKE STOPMOVE EMERGENCY EMERGENCY_STOP", |_| Foreign::Stop.into(), fixes::none),
    row("QUIT TERMINATE ABORT FINISH M2 M02 M30", |_| Suggestion::Exit.into(), |site| fixes::alone(site, Keyword::Exit)),
    row("INPUT PROMPT INKEY INKEY$ GETCH GETCHAR GETC GETKEY GET_KEY READKEY READ_KEY WAITKEY WAIT_KEY KEY SCANF READ SERIAL.READ", |_| Suggestion::KeyIn.into(), fixes::none),
    row("IN ADC AIN ADIN ANALOGREAD ANALOG_READ DIGITALREAD", |_| Suggestion::AdIn.into(), fixes::none),
    row("OUT DOUT LED LED0 LED1 LED2 LAMP LAMP0 LAMP1 LAMP2 DIGITALWRITE SETDO SET_DO RELAY LED_ON LED_OFF SIGNAL SET_OUT PULSE", |_| Foreign::Lamp.into(), fixes::none),
    row("SWITCH SELECT", |_| Foreign::Cases.into(), fixes::none).with("CASE DEFAULT OTHERWISE ENDSWITCH END_SWITCH ENDSELECT END_SELECT ESAC BREAK"),
    row("CASE DEFAULT OTHERWISE ENDSWITCH END_SWITCH ENDSELECT END_SELECT ESAC", |_| Foreign::Cases.into(), fixes::none),
    row("SPEED VEL VELOCITY SETSPEED SET_SPEED OVRD SPD FEED FEEDRATE SET_VEL SET_VELOCITY", |_| Foreign::Speed.into(), fixes::none),
    row("ACC ACCEL ACCELERATION DECEL SETACC SET_ACC SET_ACCEL SET_ACCELERATION", |_| Foreign::Acceleration.into(), fixes::none),
    row("TEACH GETPOS GET_POS GET_POSITION READPOS READ_POS READ_POSITION CURPOS GETANGLE GET_ANGLE GET_ANGLES READ_ANGLE HERE WHERE", |_| Foreign::Teach.into(), fixes::none),
    row("HOME RESET INIT INITIALIZE INITIALISE G28 GOHOME GO_HOME HOMING", |_| Foreign::Home.into(), fixes::none),
    row("SERVO_ON SERVO_OFF SVON SVOFF MOTOR_ON MOTOR_OFF MOTORS_ON MOTORS_OFF POWER_ON POWER_OFF TORQUE_ON TORQUE_OFF", |_| Foreign::Motors.into(), fixes::none),
    row("CLS CLEAR CLRSCR CLEAR_SCREEN CLC TPERASE", |_| Foreign::ClearText.into(), fixes::none),
    row("PASS NOP NOOP", |_| Foreign::Nothing.into(), fixes::none),
    row("UNLESS", |_| Suggestion::WriteNot.into(), fixes::none),
    row("WHEN WHENEVER ON IF_GOTO IF_GOSUB IF_CALL", |_| Foreign::Ask.into(), fixes::none),
    row("FOREACH", |_| Parsing::WriteFor.into(), fixes::none),
    row("INC INCR INCREMENT DEC DECR DECREMENT", |_| Foreign::Count.into(), fixes::none),
    row("PINMODE SERIAL.BEGIN SERVO.ATTACH SETMODE GPIO.SETUP GPIO.SETMODE", |_| Foreign::NoSetup.into(), fixes::none),
    row("TRY", |_| Foreign::NoCatch.into(), fixes::none).with("CATCH EXCEPT FINALLY THROW RAISE END_TRY ENDTRY"),
    row("G90 G91", |_| Foreign::RelativeMark.into(), fixes::none),
    row("FOREVER", |_| Suggestion::Forever.into(), fixes::none),
    row("{ } BEGIN", |_| Suggestion::Braces.into(), fixes::none),
    row("PROGRAM PROG MODULE MAIN SETUP", |_| Foreign::FromTheTop.into(), fixes::none),
    row("INCLUDE IMPORT USE REQUIRE", |_| Foreign::OneFile.into(), fixes::none),

    row("TRUE ON YES HIGH", |_| Foreign::Number { value: "1" }.into(), |site| fixes::everywhere(site, "1")).at(Place::Operand),
    row("FALSE OFF NO LOW NULL NIL NONE", |_| Foreign::Number { value: "0" }.into(), |site| fixes::everywhere(site, "0")).at(Place::Operand),
    row("PI M_PI", |_| Foreign::Number { value: "3.14159265" }.into(), |site| fixes::everywhere(site, "3.14159265")).at(Place::Operand),
    row("TRUE ON YES", |_| Suggestion::Forever.into(), fixes::none).at(Place::Condition),
];

/// Returns the source of the fix for the unknown word of a diagnostic.
pub(crate) fn fixer(diagnostic: &Diagnostic, source: &Source) -> Option<Fixer> {
    find(diagnostic, source).map(|row| row.fix)
}

/// Returns the row of the unknown word of a diagnostic.
fn find(diagnostic: &Diagnostic, source: &Source) -> Option<&'static Row> {
    if !diagnostic.is_guess {
        return None;
    }
    let place = match diagnostic.code {
        Code::UnknownCommand => Place::First,
        Code::UnknownVariable => Place::Operand,
        _ => Place::Condition,
    };
    let word = word_of(diagnostic, source);
    let name = name(&word);
    let last = name.rsplit('.').next().unwrap_or(name);
    let mut rows = [word.as_str(), name, last].into_iter();
    rows.find_map(|word| row_of(place, word))
}

fn row_of(place: Place, word: &str) -> Option<&'static Row> {
    let holds = |row: &&Row| row.place == place && row.words.split(' ').any(|it| it == word);
    ROWS.iter().find(holds)
}

/// Returns the help for `DEF N` or `DEF WALK()`.
fn define(line: &str) -> Message {
    match line.contains('(') {
        true => Foreign::Subroutine.into(),
        false => Foreign::Declare.into(),
    }
}

/// Returns the help for `DIM N` or `DIM A(10)`.
fn arrays(line: &str) -> Message {
    let name = line
        .split('(')
        .next()
        .and_then(|it| it.split_whitespace().nth(1));
    match name.filter(|_| line.contains('(')) {
        Some(name) => {
            let name = upper_case(name);
            Suggestion::NoArray { name }.into()
        }
        None => Foreign::Declare.into(),
    }
}

/// Returns the help for `LABEL L1`.
fn label(line: &str) -> Message {
    let name = line.split_whitespace().nth(1).unwrap_or("L1");
    let name = upper_case(name.trim_end_matches(':'));
    Parsing::WriteLabel { name }.into()
}

fn line_of<'s>(diagnostic: &Diagnostic, source: &'s Source) -> &'s str {
    let start = diagnostic.span.start;
    let (line, _) = source.line_column(start);
    source.slice(Span::new(start, source.line(line).span.end.max(start)))
}

fn word_of(diagnostic: &Diagnostic, source: &Source) -> String {
    let written = || source.slice(diagnostic.span);
    let word = diagnostic.subject.as_deref().unwrap_or_else(written);
    upper_case(word).into()
}

/// Adds helps to the diagnostics of unknown words that this table has.
pub(crate) fn advise(loaded: &mut Loaded) {
    let mut begun: Option<(usize, &Row)> = None;
    let mut kept: Vec<Diagnostic> = Vec::with_capacity(loaded.diagnostics.len());
    for mut diagnostic in loaded.diagnostics.drain(..) {
        let word = word_of(&diagnostic, &loaded.source);
        let is_first = diagnostic.is_guess && diagnostic.code == Code::UnknownCommand;
        if let Some((first, row)) = begun
            && is_first
            && row.goes_on_with(name(&word))
        {
            kept[first].point(diagnostic.span, Foreign::GoesOn);
            continue;
        }
        if let Some(row) = find(&diagnostic, &loaded.source) {
            diagnostic.help = Some((row.help)(line_of(&diagnostic, &loaded.source)));
            begun = Some((kept.len(), row));
        }
        kept.push(diagnostic);
    }
    loaded.diagnostics = kept;
}

#[cfg(test)]
mod tests {
    use super::{Place, ROWS};
    use std::collections::HashSet;
    use tipc::language::{Edition, commands, keywords};

    #[test]
    fn no_word_of_the_language_is_foreign_and_none_stands_twice() {
        let mut seen = HashSet::new();
        let words =
            |row: &'static super::Row| row.words.split(' ').map(move |word| (row.place, word));
        for (place, word) in ROWS.iter().flat_map(words) {
            assert!(seen.insert((place, word)), "{word} twice");
            assert!(keywords::find(word, Edition::default()).is_none(), "{word}");
            if place == Place::First {
                assert!(commands::find(word).is_none(), "{word}");
                assert_eq!(commands::renamed(word), None, "{word}");
            }
        }
    }
}
