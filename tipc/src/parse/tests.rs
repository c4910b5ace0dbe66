//! The parser, through one helper: a program's lines 3… in, statements and diagnostics out.

mod robustness;

use super::parse;
use crate::source::{Encoding, Source};

/// Parses `body` after a good version line and title, END added, and compares what comes out.
///
/// One line for each statement but END, as [`dump`] writes it, then one for each diagnostic: `LINE:COLUMN: message`,
/// lines counted from 1 in `body`.
#[track_caller]
fn check(body: &str, expected: &[&str]) {
    assert_eq!(
        outcome(&format!("{body}\nEND")),
        expected,
        "program: {body}"
    );
}

/// Checks a program like [`check`], without the END added.
#[track_caller]
fn check_whole(body: &str, expected: &[&str]) {
    assert_eq!(outcome(body), expected, "program: {body}");
}

fn outcome(body: &str) -> Vec<String> {
    let text = format!("3.1\ntitle\n{body}");
    let (source, bad) = Source::decode("test.prg", text.as_bytes(), Encoding::Utf8);
    assert_eq!(bad, None);
    let (module, diagnostics) = parse(&source, Some(3.1));
    let statements = module
        .statements
        .iter()
        .map(|one| dump::statement(&source, one));
    let found = diagnostics.iter().map(|diagnostic| {
        let (line, column) = source.line_column(diagnostic.span.start);
        format!("{}:{column}: {}", line - 2, diagnostic.message())
    });
    statements
        .filter(|line| line != "end")
        .chain(found)
        .collect()
}

mod dump {
    //! Statements in a short form of their own.

    use crate::source::Source;
    use crate::syntax::{
        Arithmetic, Condition, Counting, Expression, Jump, Operand, OperandKind, Relation,
        Statement, StatementKind, Then,
    };

    pub(super) fn statement(source: &Source, statement: &Statement) -> String {
        match &statement.kind {
            StatementKind::Define { kind, names, .. } => {
                let names: Vec<&str> = names.iter().map(|name| name.node.as_str()).collect();
                format!("define {kind:?} {}", names.join(" "))
            }
            StatementKind::Label(name) => format!("label {}", name.node),
            StatementKind::Equation(one) => format!(
                "set {} {}= {}",
                operand(&one.target),
                one.update.map_or("", arithmetic),
                expression(&one.value)
            ),
            StatementKind::If {
                condition: one,
                then,
                ..
            } => match then {
                Then::Block => format!("if {} then", condition(one)),
                Then::Goto(to) => format!("if {} goto {}", condition(one), jump(to)),
                Then::Gosub(to) => format!("if {} gosub {}", condition(one), jump(to)),
            },
            StatementKind::ElseIf { condition: one, .. } => format!("elseif {}", condition(one)),
            StatementKind::While { condition: one, .. } => format!("while {}", condition(one)),
            StatementKind::Until { condition: one, .. } => format!("until {}", condition(one)),
            StatementKind::For { counting, .. } => {
                let Counting {
                    variable,
                    from,
                    to,
                    step,
                } = counting.as_ref();
                let step = step.as_ref().map_or("-".to_owned(), operand);
                format!(
                    "for {} {} {} {step}",
                    operand(variable),
                    operand(from),
                    operand(to)
                )
            }
            StatementKind::Next { variable, .. } => {
                format!("next {}", variable.as_ref().map_or("-".to_owned(), operand))
            }
            StatementKind::Subroutine { name, .. } => format!("subroutine {}", name.node),
            StatementKind::Call(to) => format!("call {}", jump(to)),
            StatementKind::Goto(to) => format!("goto {}", jump(to)),
            StatementKind::Gosub(to) => format!("gosub {}", jump(to)),
            StatementKind::Message { text } => format!("message [{}]", text.node),
            StatementKind::Command {
                name,
                arguments,
                malformed,
            } => {
                let mut out = format!("command {}", name.node);
                for one in arguments {
                    out += &format!(" {}", operand(one));
                }
                if let Some(fault) = malformed {
                    let (_, column) = source.line_column(fault.span.start);
                    out += &format!(" ?{column}");
                }
                out
            }
            StatementKind::Broken(shape) => format!("broken {shape:?}"),
            other => format!("{other:?}").to_lowercase(),
        }
    }

    fn operand(one: &Operand) -> String {
        let sign = if one.negative { "-" } else { "" };
        match &one.kind {
            OperandKind::Number(number) => format!("{number:?}"),
            OperandKind::Name(name) => format!("{sign}{name}"),
            OperandKind::Member(words) => format!("{sign}{}.{}", words.0, words.1),
        }
    }

    fn arithmetic(operation: Arithmetic) -> &'static str {
        match operation {
            Arithmetic::Add => "+",
            Arithmetic::Sub => "-",
            Arithmetic::Mul => "*",
            Arithmetic::Div => "/",
        }
    }

    fn expression(value: &Expression) -> String {
        match value {
            Expression::Operand(one) => operand(one),
            Expression::Binary {
                left,
                operation,
                right,
            } => {
                format!(
                    "({} {} {})",
                    operand(left),
                    arithmetic(*operation),
                    operand(right)
                )
            }
            Expression::Function { name, operands } => {
                let operands: Vec<String> = operands.iter().map(operand).collect();
                format!("{}({})", name.node, operands.join(", "))
            }
        }
    }

    fn condition(condition: &Condition) -> String {
        match condition {
            Condition::Compare {
                left,
                relation,
                right,
            } => {
                let relation = match relation {
                    Relation::Eq => "==",
                    Relation::Ne => "<>",
                    Relation::Lt => "<",
                    Relation::Gt => ">",
                    Relation::Le => "<=",
                    Relation::Ge => ">=",
                };
                format!("({} {relation} {})", operand(left), operand(right))
            }
            Condition::Flag { name, negated } => {
                format!("{}{}", if *negated { "!" } else { "" }, name.node)
            }
        }
    }

    fn jump(jump: &Jump) -> String {
        jump.label
            .as_ref()
            .map_or("-".to_owned(), |label| label.node.to_string())
    }
}

/// Checks an `IF` that is wrong at `column` and keeps opening its block.
#[track_caller]
fn wrong_condition(condition: &str, column: u32) {
    let location = format!("1:{column}: Wrong argument");
    check(&format!("IF {condition} THEN"), &["broken If", &location]);
}

// clauses: 5.1 1.11
#[test]
fn every_relation_reads_with_and_without_blanks() {
    check("IF A==B THEN", &["if (A == B) then"]);
    check("IF A <> -1 THEN", &["if (A <> -1.0) then"]);
    check("IF A<-1 THEN", &["if (A < -1.0) then"]);
    check("IF -A>B THEN", &["if (-A > B) then"]);
    check("IF P.X<=Q.J1 THEN", &["if (P.X <= Q.J1) then"]);
    check("if a>=b then", &["if (A >= B) then"]);
}

// clauses: 5.1
#[test]
fn flags_stand_alone_or_negated() {
    check("WHILE KB_HIT", &["while KB_HIT"]);
    check("UNTIL !INPOS_F1", &["until !INPOS_F1"]);
    check("UNTIL ! INPOS_F1", &["broken Until", "1:7: Wrong argument"]);
    check("UNTIL -KB_HIT", &["broken Until", "1:7: Wrong argument"]);
    check("UNTIL !", &["broken Until", "1:7: Wrong argument"]);
}

// clauses: 5.1
#[test]
fn relations_of_other_languages_are_read_as_intended() {
    let fault = "1:6: Wrong argument";
    check("IF A = B THEN", &["if (A == B) then", fault]);
    check("IF A != B THEN", &["if (A <> B) then", fault]);
    check("IF A => B THEN", &["if (A >= B) then", fault]);
    check("IF A < > B THEN", &["if (A <> B) then", fault]);
    // So what is wrong after it is found as well.
    check("IF A = B", &["broken If", fault, "1:9: Wrong argument"]);
    // A flag is compared with nothing.
    check("IF KB_HIT = B THEN", &["broken If", "1:11: Wrong argument"]);
}

// clauses: 5.1
#[test]
fn malformed_conditions_are_shown_at_their_location() {
    wrong_condition("A >< B", 7);
    wrong_condition("A ==", 9);
    wrong_condition("== A", 4);
    wrong_condition("A + 1 == B", 6);
    wrong_condition("A == B + 1", 11);
    wrong_condition("5", 4);
    wrong_condition("P.X", 4);
    wrong_condition("", 5);
    check("WHILE", &["broken While", "1:6: Wrong argument"]);
    check(
        "WHILE A == B C",
        &["while (A == B)", "1:14: Wrong argument"],
    );
    check(
        "WHILE A == B == C",
        &["broken While", "1:14: Wrong argument"],
    );
}

// clauses: 7.20 6.6
#[test]
fn if_leads_to_a_block_or_a_label() {
    check("IF A<>B GOTO L1:", &["if (A <> B) goto L1"]);
    check("IF KB_HIT GOTO", &["if KB_HIT goto -"]);
    check("IF KB_HIT GOSUB L1:", &["if KB_HIT gosub L1"]);
    check(
        "IF KB_HIT THEN A = 1",
        &["broken OneLineIf", "1:16: Wrong argument"],
    );
    check("IF KB_HIT THEN ; A = 1", &["if KB_HIT then", "set A = 1.0"]);
    check("IF KB_HIT", &["broken If", "1:10: Wrong argument"]);
    check("IF KB_HIT L1:", &["broken Plain", "1:11: Wrong argument"]);
    check(
        "IF KB_HIT CALL L1:",
        &["broken Plain", "1:11: Wrong argument"],
    );
    check("IF KB_HIT GOSUB", &["broken Plain", "1:16: Wrong argument"]);
    check(
        "IF KB_HIT GOTO L1: A = 1",
        &["if KB_HIT goto L1", "1:20: Wrong argument"],
    );
}

// clauses: 7.20
#[test]
fn elseif_needs_its_then() {
    check("ELSEIF A == 1 THEN", &["elseif (A == 1.0)"]);
    check(
        "ELSEIF A == 1",
        &["elseif (A == 1.0)", "1:14: Wrong argument"],
    );
    check("ELSEIF THEN", &["broken ElseIf", "1:8: Wrong argument"]);
}

// clauses: 6.1
#[test]
fn a_jump_names_its_label_with_the_colon() {
    check("GOTO L1:", &["goto L1"]);
    check("GOTO 10:", &["goto 10"]);
    check("goto", &["goto -"]);
    check("GOSUB l1:", &["gosub L1"]);
    check("CALL SUB1:", &["call SUB1"]);
    // One without its colon leads there all the same.
    check("GOTO L1", &["goto L1", "1:6: Wrong argument"]);
    check("CALL SUB1 X = 1", &["call SUB1", "1:6: Wrong argument"]);
    check("GOTO L1 :", &["goto L1", "1:8: Wrong argument"]);
    check("GOSUB", &["broken Plain", "1:6: Wrong argument"]);
    check("CALL -5", &["broken Plain", "1:6: Wrong argument"]);
}

// clauses: 6.3
#[test]
fn nothing_stands_behind_a_label() {
    check("GOTO L1: A = 1", &["goto L1", "1:10: Wrong argument"]);
    check("CALL S1: FOO", &["call S1", "1:10: Wrong argument"]);
    check("GOSUB L1: L2:", &["gosub L1", "1:11: Wrong argument"]);
    check("GOTO L1: ; A = 1", &["goto L1", "set A = 1.0"]);
}

// clauses: 7.20
#[test]
fn for_has_two_or_three_operands() {
    check("FOR I=1 TO 3", &["for I 1.0 3.0 -"]);
    check("FOR I = N TO -P.X STEP -1", &["for I N -P.X -1.0"]);
    check("FOR I 1 TO 3", &["broken For", "1:7: Wrong argument"]);
    check("FOR I = 1 3", &["broken For", "1:11: Wrong argument"]);
    check("FOR I = TO 3", &["broken For", "1:9: Wrong argument"]);
    check("FOR I = 1 TO", &["broken For", "1:13: Wrong argument"]);
    check(
        "FOR I = 1 TO 3 STEP",
        &["broken For", "1:20: Wrong argument"],
    );
    check(
        "FOR I = 1 TO 3 4",
        &["for I 1.0 3.0 -", "1:16: Wrong argument"],
    );
    check("FOR 5 = 1 TO 3", &["broken For", "1:5: Wrong argument"]);
    check(
        "FOR I = 1 + 2 TO 3",
        &["broken For", "1:11: Wrong argument"],
    );
    check("FOR I += 1 TO 3", &["broken For", "1:7: Wrong argument"]);
}

// clauses: 7.20
#[test]
fn next_may_name_its_variable() {
    check("NEXT", &["next -"]);
    check("NEXT I", &["next I"]);
    check(
        "NEXT I J",
        &["broken Next", "broken Next", "1:8: Wrong argument"],
    );
    check("NEXT I 5", &["next I", "1:8: Wrong argument"]);
    check("NEXT -I", &["broken Next", "1:6: Wrong argument"]);
    check("NEXT 5", &["broken Next", "1:6: Wrong argument"]);
}

// clauses: 2.1 7.20
#[test]
fn subroutine_declares_one_label() {
    check("SUBROUTINE S1:", &["subroutine S1"]);
    check("SUBROUTINE S1 :", &["subroutine S1"]);
    check("SUBROUTINE S1", &["subroutine S1", "1:12: Wrong argument"]);
    check(
        "SUBROUTINE S1: A = 1",
        &["subroutine S1", "1:16: Wrong argument"],
    );
    check("SUBROUTINE", &["broken Subroutine", "1:11: Wrong argument"]);
}

// clauses: 7.20 7.39
#[test]
fn words_without_arguments_take_none() {
    check("SUBEND", &["subend"]);
    check("RETURN", &["return"]);
    check("EXIT", &["exit"]);
    check("SUBEND S1:", &["subend", "1:8: Wrong argument"]);
    check("RETURN 5", &["return", "1:8: Wrong argument"]);
    check("EXIT 0", &["exit", "1:6: Wrong argument"]);
}

// clauses: 3.1
#[test]
fn declarations_keep_the_names_as_written() {
    check("DEF_VAR A, b  C_1", &["define Var A B C_1"]);
    check("DEF_POS P", &["define Pos P"]);
    check("DEF_JOINT 5Q P.X", &["define Joint 5Q P.X"]);
    check("DEF_VAR", &["define Var ", "1:1: Wrong argument"]);
    check("DEF_VAR A = 5", &["define Var A", "1:11: Wrong argument"]);
}

/// Checks an equation that is wrong at `column`.
#[track_caller]
fn wrong(equation: &str, column: u32) {
    let location = format!("1:{column}: Wrong equation format");
    check(equation, &["broken Plain", &location]);
}

// clauses: 4.1 1.11
#[test]
fn every_assignment_and_operation_reads_with_and_without_blanks() {
    check("A=B", &["set A = B"]);
    check("A = B + C", &["set A = (B + C)"]);
    check("A=B-C", &["set A = (B - C)"]);
    check("a,=,b\t*\tc", &["set A = (B * C)"]);
    check("A=B/C", &["set A = (B / C)"]);
    check(
        "A+=1;A-=1;A*=2;A/=2",
        &[
            "set A += 1.0",
            "set A -= 1.0",
            "set A *= 2.0",
            "set A /= 2.0",
        ],
    );
    check("P.X += Q.J2 / -R.Y", &["set P.X += (Q.J2 / -R.Y)"]);
}

// clauses: 4.1
#[test]
fn the_left_side_is_a_name_without_sign() {
    wrong("-A = 5", 1);
    wrong("5 = A", 1);
    wrong("= 5", 1);
    wrong("* A = 5", 1);
    check("FOO = 5", &["set FOO = 5.0"]);
    check("PTP = 5", &["set PTP = 5.0"]);
}

// clauses: 3.6
#[test]
fn behind_an_operand_minus_is_the_operator() {
    check("A = 5 -3", &["set A = (5.0 - 3.0)"]);
    check("A = B - -C", &["set A = (B - -C)"]);
    check("A = B--C", &["set A = (B - -C)"]);
    check("A = B*-C", &["set A = (B * -C)"]);
    check("A=-B", &["set A = -B"]);
    check("A-=-1", &["set A -= -1.0"]);
    wrong("A = - B", 5);
    wrong("A = B - - C", 9);
}

// clauses: 3.6 4.5
#[test]
fn behind_an_operand_of_a_function_minus_is_a_sign() {
    check("A = ATAN2 B -C", &["set A = ATAN2(B, -C)"]);
    check("A = ATAN2 -B, -2", &["set A = ATAN2(-B, -2.0)"]);
    check("P = ROT_X P -90", &["set P = ROT_X(P, -90.0)"]);
    wrong("A = ATAN2 B-C", 12);
    wrong("A = ATAN2 B - C", 13);
}

// clauses: 3.6
#[test]
fn constants_are_decimal_and_finite() {
    check("A = 5.", &["set A = 5.0"]);
    check("A = .5", &["set A = 0.5"]);
    check("A = 1E3", &["set A = 1000.0"]);
    check("A = 1.5e-3", &["set A = 0.0015"]);
    check("A = 2E+1*3", &["set A = (20.0 * 3.0)"]);
    check("A = 5-3", &["set A = (5.0 - 3.0)"]);
    check("A = +5", &["set A = 5.0"]);
    check("A = 1E308", &["set A = 1e308"]);
    wrong("A = 1E309", 5);
    wrong("A = .", 5);
    wrong("A = 1.2.3", 5);
    wrong("A = 0x10", 5);
    wrong("A = 12AB", 5);
    wrong("A = 1E", 5);
}

// clauses: 3.5
#[test]
fn plus_stands_before_constants_only() {
    check("A = B + +2", &["set A = (B + 2.0)"]);
    wrong("A = +B", 5);
}

// clauses: 3.5
#[test]
fn members_have_one_point() {
    check("A = -p.x", &["set A = -P.X"]);
    wrong("A = P.", 5);
    wrong("A = P.X.Y", 5);
}

// clauses: 4.9
#[test]
fn there_is_one_operation() {
    wrong("A = B + C + D", 11);
    wrong("A = B C", 7);
    wrong("A = B +", 8);
    wrong("A =", 4);
    wrong("A = = B", 5);
    wrong("A = B == C", 7);
    wrong("A = SIN B + 1", 11);
    wrong("A = B + SIN C", 9);
    wrong("A = -SIN C", 5);
    wrong("A = SIN COS C", 9);
    wrong("A = (B + C)", 5);
    wrong("A = SIN(B)", 8);
    wrong("A = B: C = 2", 6);
}

// clauses: 4.4 4.9
#[test]
fn functions_take_the_operands_that_stand_there() {
    check("A = SQRT B", &["set A = SQRT(B)"]);
    check("A += sin -30", &["set A += SIN(-30.0)"]);
    check("A = NORM P Q", &["set A = NORM(P, Q)"]);
    check("A = NORM", &["set A = NORM()"]);
}

// clauses: 8.1
#[test]
fn faulty_arguments_wait_for_the_command_to_be_known() {
    check("PTP F1 10, -20 .5", &["command PTP F1 10.0 -20.0 0.5"]);
    check("FOO A + B", &["command FOO A ?7"]);
    check("GOTOO L1:", &["command GOTOO L1 ?9"]);
    check("PTP F1 10-5", &["command PTP F1 10.0 ?10"]);
    check("PTP F1 - 5", &["command PTP F1 ?8"]);
    check("SLEEP 1E999", &["command SLEEP ?7"]);
    check("PTP HS F1 R 10 0 0", &["command PTP HS F1 R 10.0 0.0 0.0"]);
    check("* 5", &["command * 5.0"]);
    check("5 6", &["command 5 6.0"]);
}

/// Checks for a `Format error` at `column` of line 1, besides `statements`.
#[track_caller]
fn format_error(body: &str, statements: &[&str], column: u32) {
    let location = format!("1:{column}: Format error");
    let expected: Vec<&str> = statements
        .iter()
        .copied()
        .chain([location.as_str()])
        .collect();
    check(body, &expected);
}

// clauses: 1.5
#[test]
fn the_first_end_ends_the_program() {
    check_whole("A = 1; END ; PTP ＆\nelse garbage = = \n", &["set A = 1.0"]);
    check_whole("END 5 garbage 全角", &[]);
    check_whole("end // done", &[]);
    // A word that is near to END was to be the END.
    check_whole("ENDE", &["1:1: Unknown command \"ENDE\""]);
    check_whole("STOP", &["broken Plain", "1:1: Not exist END"]);
    check_whole(
        "A = 1\n\n  B = 2  \n",
        &["set A = 1.0", "set B = 2.0", "3:3: Not exist END"],
    );
    check_whole("A = 1 // END\n\n", &["set A = 1.0", "2:1: Not exist END"]);
    check_whole("REM END", &["rem", "1:1: Not exist END"]);
}

// clauses: 1.9 1.10
#[test]
fn comments_go_first_and_semicolons_separate() {
    check("A = 1 // B = 2 ; C = 3", &["set A = 1.0"]);
    check("A = 1 ;; B = 2 ;", &["set A = 1.0", "set B = 2.0"]);
    check("; ,; //", &[]);
    check("REM text; A = 1", &["rem", "set A = 1.0"]);
    check("MESSAGE a; A = 1", &["message [a]", "set A = 1.0"]);
    check("A = 4/ /2", &["broken Plain", "1:8: Wrong equation format"]);
}

// clauses: 1.9
#[test]
fn a_comment_in_a_message_is_warned_of() {
    let warning = "the comment cuts this MESSAGE text";
    check(
        "MESSAGE see http://x",
        &["message [see http:]", &format!("1:18: {warning}")],
    );
    check("MESSAGE // x", &["message []", &format!("1:9: {warning}")]);
    check("MESSAGE// x", &["message []"]);
    check("MESSAGE a; A = 1 // x", &["message [a]", "set A = 1.0"]);
    check("REM see http://x", &["rem"]);
}

// clauses: 2.1
#[test]
fn labels_may_share_the_line() {
    check("L1:", &["label L1"]);
    check("l1: A = 1", &["label L1", "set A = 1.0"]);
    check("L1: L2:A = 1", &["label L1", "label L2", "set A = 1.0"]);
    check("L1 : A = 1", &["label L1", "set A = 1.0"]);
    check("10:", &["label 10"]);
    check(
        ": A = 1",
        &["broken Plain", "set A = 1.0", "1:1: Wrong argument"],
    );
    check("MESSAGE : a", &["message [: a]"]);
    check("MESSAGE: a", &["broken Plain", "1:1: Wrong argument"]);
    check("REM : a", &["rem"]);
}

// clauses: 1.10
#[test]
fn lone_words_want_their_line() {
    check(
        "ELSE\nENDIF // x\nL1: WEND\n; REPEAT ;",
        &["else", "endif", "label L1", "wend", "repeat"],
    );
    format_error("ELSE X = 1", &["else"], 1);
    format_error("ELSE = 1", &["else"], 1);
    format_error("ELSE ; X = 1", &["else", "set X = 1.0"], 1);
    format_error("X = 1; ENDIF", &["set X = 1.0", "endif"], 8);
    format_error("WEND ; L1:", &["wend", "label L1"], 1);
    format_error("ELSE X = 1 ; Y = 1", &["else", "set Y = 1.0"], 1);
    check(
        "ENDIF ; ENDIF",
        &["endif", "endif", "1:1: Format error", "1:9: Format error"],
    );
    check_whole("ENDIF ; END", &["endif", "1:1: Format error"]);
    check("SUBEND ; RETURN", &["subend", "return"]);
}

// clauses: 1.6 1.11
#[test]
fn full_width_spaces_are_blanks() {
    check("　PTP　F1　1,2,3　", &["command PTP F1 1.0 2.0 3.0"]);
    check("MESSAGE　a　b　", &["message [a  b]"]);
    check(
        "L1　: A = -　B",
        &["label L1", "broken Plain", "1:10: Wrong equation format"],
    );
}

// clauses: 1.8
#[test]
fn other_wide_characters_are_refused_in_words() {
    format_error("PTP Ｆ1", &["broken Plain"], 5);
    format_error("A = ｱ", &["broken Plain"], 5);
    format_error("あ: A = 1", &["broken Plain", "set A = 1.0"], 1);
    format_error("IF あ THEN", &["broken If"], 4);
    format_error("DEF_VAR A あ B", &["define Var A B"], 11);
    format_error("ELSE あ", &["else"], 6);
    format_error("A = 1\u{C}", &["broken Plain"], 6);
    check("A = 1 // ｱあ", &["set A = 1.0"]);
    check("REM ｱあ\nMESSAGE ｱあ", &["rem", "message [ｱあ]"]);
}

// clauses: 1.7
#[test]
fn case_is_folded_but_in_texts() {
    check(
        "message Ab\nptp f1 p.x",
        &["message [Ab]", "command PTP F1 P.X"],
    );
}

// clauses: 1.12
#[test]
fn blank_lines_are_nothing() {
    check("\n  \t\n　\nA = 1\n\n", &["set A = 1.0"]);
}

// clauses: 1.2
#[test]
fn names_have_at_most_32_bytes() {
    let (fits, long) = ("A".repeat(32), "A".repeat(33));
    check(&format!("{fits}:"), &[&format!("label {fits}")]);
    format_error(&format!("{long}:"), &[&format!("label {long}")], 1);
    check(&format!("DEF_VAR {fits}"), &[&format!("define Var {fits}")]);
    format_error(
        &format!("DEF_VAR {long}"),
        &[&format!("define Var {long}")],
        9,
    );
    format_error(
        &format!("SUBROUTINE {long}:"),
        &[&format!("subroutine {long}")],
        12,
    );
}

// clauses: 1.2
#[test]
fn lines_have_at_most_1023_bytes() {
    check(&format!("REM {}", "a".repeat(1019)), &["rem"]);
    check("REM 1", &["rem"]);
    format_error_first(&format!("REM {}", "a".repeat(1020)), 1024);
    check(&format!("// {}", "あ".repeat(510)), &[]);
    format_error_first(&format!("//  {}", "あ".repeat(510)), 514);
    check_whole(&format!("END\n{}", "a".repeat(2000)), &[]);
}

/// Checks a line whose length is wrong from `column` on; its statements are not looked at.
#[track_caller]
fn format_error_first(body: &str, column: u32) {
    let statements: &[&str] = if body.starts_with("REM") {
        &["rem"]
    } else {
        &[]
    };
    format_error(body, statements, column);
}

// clauses: 7.47 1.2
#[test]
fn message_texts_are_checked() {
    let fits = "あ".repeat(35);
    check(&format!("MESSAGE {fits}"), &[&format!("message [{fits}]")]);
    check(
        &format!("MESSAGE {fits}a"),
        &[&format!("message [{fits}a]"), "1:44: too much long string"],
    );
    check(
        &format!("MESSAGE {}", "¥t".repeat(35)),
        &[&format!("message [{}]", "¥t".repeat(35))],
    );
    check("MESSAGE a\\nb", &["message [a\\nb]", "1:10: Format error"]);
    check("MESSAGE a¥nb", &["message [a¥nb]", "1:10: Format error"]);
    check("MESSAGE a\\\\nb \\N", &["message [a\\\\nb \\N]"]);
    check("MESSAGE", &["message []"]);
    check("MESSAGE, a, ", &["message [a,]"]);
    check("MESSAGE=5", &["broken Plain", "1:8: Wrong argument"]);
}

/// Checks whether a compiler of version `wanted` reads a program whose first line is `line`; if not, nothing else is
/// reported.
#[track_caller]
fn check_version(line: &str, wanted: f64, expected: bool) {
    let text = format!("{line}\n　two　words ;\t\nFOO");
    let (source, _) = Source::decode("test.prg", text.as_bytes(), Encoding::Utf8);
    let (module, diagnostics) = parse(&source, Some(wanted));
    let messages: Vec<String> = diagnostics.iter().map(|one| one.message()).collect();
    if expected {
        assert_eq!(module.title, "two  words ;");
        assert_eq!(messages, ["Not exist END"]);
    } else {
        assert_eq!(module.statements.len(), 0);
        assert_eq!(messages, ["Wrong version number"]);
    }
}

// clauses: 1.3 1.4 1.6
#[test]
fn versions_are_compared_as_numbers() {
    check_version("3.1", 3.1, true);
    check_version("3.10", 3.1, true);
    check_version("　3.1 \t// comment", 3.1, true);
    check_version("3.1//", 3.1, true);
    check_version("2", 2.0, true);
    check_version("3.1", 3.0, false);
    check_version("3.01", 3.1, false);
    check_version("3.1 beta", 3.1, false);
    check_version("3.1;", 3.1, false);
    check_version("3.1 3.1", 3.1, false);
    check_version("", 3.1, false);
    check_version("// 3.1", 3.1, false);
    check_version("inf", f64::INFINITY, false);
    check_version("３.１", 3.1, false);
}
