//! The text of a gait, from its template.
//!
//! A line of the template may begin with marks: `@crawl`, `@wave`, `@pairs`, `@single`, `@steady` keep it for some kinds only, `@leg` and
//! `@group` repeat it for each leg or group with its number in place of `#`.

use crate::new::fill;
use crate::new::gait::Kind;
use crate::new::gait::plan::{Plan, foot_name};
use crate::new::gait::reach::beside;
use std::fmt::Write as _;
use tip_lint::format::format;
use tip_sim::Robot;
use tipc::language::Keyword;

const TEMPLATE: &str = include_str!("../../../templates/motions/gait.prg");

/// Returns the program, formatted as by `tip fmt`. `figures` are lines of comments.
pub(super) fn text(robot: &Robot, plan: &Plan, figures: &str) -> String {
    let marked: String = TEMPLATE.lines().map(|line| expand(line, plan)).collect();
    let names = |letter: &str, count: usize| -> String {
        let names: Vec<String> = (1..=count).map(|n| format!("{letter}{n}")).collect();
        names.join(", ")
    };
    let (legs, count) = (plan.feet.len(), plan.groups.len());
    let [side, ahead, turn] = plan.top;
    let number = |value: f64| value.to_string();
    let placeholders = [
        ("title", title(robot.name(), plan.kind)),
        ("picture", picture(plan)),
        ("figures", figures.to_owned()),
        ("homes", names("H", legs)),
        ("places", names("P", legs)),
        ("groups", names("D", count)),
        ("count", count.to_string()),
        ("others", (count - 1).to_string()),
        ("swing", number(plan.swing)),
        ("stand", number(plan.pause)),
        ("shift", number(plan.pause)),
        ("lift", number(plan.lift)),
        ("delay", number(plan.delay)),
        ("sway", number(plan.sway)),
        ("reach", number(plan.reach)),
        ("weight_x", number(plan.weight[0])),
        ("weight_turn", number(plan.weight[1])),
        ("lean", number(plan.lean)),
        ("raise", number(plan.raise)),
        ("lower", number(plan.lower)),
        ("side", number(side)),
        ("ahead", number(ahead)),
        ("turn", number(turn)),
        ("move", move_feet(plan)),
        (
            "leave",
            choose(count, |group| match plan.kind {
                Kind::Crawl => {
                    let leg = plan.groups[group - 1].first().copied().unwrap_or(0);
                    let [one, other] = beside(&plan.feet, leg).map(|leg| leg + 1);
                    let leg = leg + 1;
                    format!(
                        "FROM = D{group} ; HOME = H{leg} ; SWAY_TO = P{one} - H{one} ; WAY = P{other} - H{other}"
                    )
                }
                _ => format!("FROM = D{group}"),
            }),
        ),
        (
            "swing_feet",
            choose(count, |group| format!("D{group} = AIR")),
        ),
    ];
    let placeholders: Vec<(&str, &str)> = placeholders
        .iter()
        .map(|(name, value)| (*name, &**value))
        .collect();
    let text = fill(&marked, &placeholders);
    let formatted = format("walk.prg", text.as_bytes(), &robot.options()).ok();
    formatted
        .and_then(|bytes| String::from_utf8(bytes).ok())
        .unwrap_or(text)
}

/// Returns a line of the template without its marks, as often as it is repeated.
fn expand(line: &str, plan: &Plan) -> String {
    let (marks, rest) = match line.strip_prefix('@') {
        Some(marked) => marked.split_once(' ').unwrap_or((marked, "")),
        None => ("", line),
    };
    let kind = plan.kind;
    let mut repeats = None;
    for mark in marks.split('@').filter(|mark| !mark.is_empty()) {
        let is_kept = match mark {
            "crawl" => kind == Kind::Crawl,
            "wave" => kind == Kind::Wave,
            "steady" => kind != Kind::Crawl,
            "single" => matches!(kind, Kind::Crawl | Kind::Wave),
            "pairs" => matches!(kind, Kind::Tripod | Kind::Trot),
            "leg" => {
                repeats = Some(plan.feet.len());
                true
            }
            _ => {
                repeats = Some(plan.groups.len());
                true
            }
        };
        if !is_kept {
            return String::new();
        }
    }
    match repeats {
        None => format!("{rest}\n"),
        Some(count) => {
            let numbers = (1..=count).map(|n| rest.replace('#', &n.to_string()));
            numbers.map(|line| line + "\n").collect()
        }
    }
}

/// Returns the steps that choose one of several by the group.
fn choose(count: usize, line: impl Fn(usize) -> String) -> String {
    let mut text = String::new();
    for group in 1..=count {
        let head = match group {
            1 => "IF GROUP == 1 THEN".to_owned(),
            _ if group == count => Keyword::Else.to_string(),
            _ => format!("ELSEIF GROUP == {group} THEN"),
        };
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{head}\n{}", line(group));
    }
    text + "ENDIF\n"
}

/// Returns the steps that move each foot as its group has moved.
fn move_feet(plan: &Plan) -> String {
    let mut text = String::new();
    for (group, legs) in (1..).zip(&plan.groups) {
        let from_body = match plan.kind {
            Kind::Crawl => " - BODY",
            _ => "",
        };
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "MOVE = D{group}{from_body} ; MOVE.Z = 0 ; TURN = D{group}.Z\n\
             IF GROUP == {group} THEN\nMOVE.Z = HEIGHT\nENDIF"
        );
        for leg in legs {
            let leg = leg + 1;
            let place = match plan.kind {
                Kind::Crawl => format!("P{leg}"),
                _ => "P".to_owned(),
            };
            let _ = writeln!(
                text,
                "{place} = ROT_Z H{leg} TURN ; {place} += MOVE ; PTP F{leg} {place}"
            );
        }
    }
    text
}

fn title(robot: &str, kind: Kind) -> String {
    let does = match kind {
        Kind::Crawl => "crawls",
        Kind::Wave => "walks one foot at a time",
        Kind::Tripod => "walks on half of its feet at a time",
        Kind::Trot => "trots",
    };
    format!("A {robot} {does} as sticks say: ahead, sideways, turning, or all together")
}

/// Returns the feet as seen from above, and the order of their swings, as comments.
fn picture(plan: &Plan) -> String {
    let name = |leg: &usize| foot_name(*leg);
    let names = |legs: &[usize]| legs.iter().map(name).collect::<Vec<_>>().join(" ");
    let order: Vec<String> = match plan.kind {
        Kind::Tripod | Kind::Trot => (1..)
            .zip(&plan.groups)
            .map(|(n, group)| format!("GROUP {n}  {}", names(group)))
            .collect(),
        Kind::Crawl | Kind::Wave => vec![format!("in turn {}", names(&plan.groups.concat()))],
    };
    let rows = rows(plan);
    let mut text = String::new();
    if let Some(rows) = &rows {
        text.push_str("//     front\n");
        for (n, [left, right]) in rows.iter().enumerate() {
            let beside = order.get(n).map_or("", |text| text);
            let gap = if beside.is_empty() { "" } else { "      " };
            // Writing to a String cannot fail.
            let _ = writeln!(text, "//    {} -- {}{gap}{beside}", name(left), name(right));
        }
    }
    let shown = rows.map_or(0, |rows| rows.len());
    for line in order.iter().skip(shown) {
        let _ = writeln!(text, "// {line}");
    }
    text
}

/// Returns the legs in rows of two, from front to rear; `None` if they do not stand so.
fn rows(plan: &Plan) -> Option<Vec<[usize; 2]>> {
    let feet = &plan.feet;
    let mut order: Vec<usize> = (0..feet.len()).collect();
    order.sort_by(|a, b| {
        feet[*b][1]
            .total_cmp(&feet[*a][1])
            .then(feet[*a][0].total_cmp(&feet[*b][0]))
    });
    let (rows, rest) = order.as_chunks::<2>();
    let is_row =
        |[a, b]: &[usize; 2]| (feet[*a][1] - feet[*b][1]).abs() < 1.0 && feet[*a][0] < feet[*b][0];
    (rest.is_empty() && rows.iter().all(is_row)).then(|| rows.to_vec())
}
