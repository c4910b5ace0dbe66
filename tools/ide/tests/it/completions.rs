//! Every completion that is offered passes the checker, in both editions, on every robot: some rest of the statement makes it right.

use std::collections::{BTreeMap, BTreeSet, HashSet, VecDeque};
use tip_ide::{CompletionItem, CompletionKind, Document};
use tip_sim::Robot;
use tipc::code::Level;
use tipc::language::commands::{COMMANDS, Meaning};
use tipc::language::{Edition, Keyword};
use tipc::{Options, published};

/// The robot of an example, a walker of three joints with a slider and forces, one with a single joint, and legs of four joints.
const DESCRIBED: [&str; 4] = [
    include_str!("../../../../examples/six-legs/hexapod.toml"),
    "name = \"Sliding\"\nleg = [{ base = [-100, 0, 0], mirror = \"x\" }, { base = [100, 0, 0] }]
joint = [{ axis = \"z\", link = [50, 0, 0] }, { axis = \"-y\", link = [120, 0, 0] }, { axis = \"y\", link = [140, 0, 0] }]
[body]\nx = [-10, 10]\ny = [-10, 10]\nz = [-10, 10]\n[forces]\n[slider]\ninitial = [0, 0, 0]\n",
    "name = \"Single\"\nleg = [{ base = [-10, 0, 0], mirror = \"x\" }, { base = [10, 0, 0] }]
joint = [{ axis = \"y\", link = [10, 0, 0] }]\n[body]\nx = [-10, 10]\ny = [-10, 10]\nz = [-10, 10]\n",
    "name = \"Long\"\nleg = [{ base = [-10, 0, 0], mirror = \"x\" }, { base = [10, 0, 0] }]
joint = [{ axis = \"z\", link = [10, 0, 0] }, { axis = \"y\", link = [50, 0, 0] }, { axis = \"y\", link = [50, 0, 0] }, { axis = \"y\", link = [50, 0, 0] }]
[body]\nx = [-10, 10]\ny = [-10, 10]\nz = [-10, 10]\n",
];

fn robots() -> Vec<Robot> {
    let built_in = tipc::Robot::ALL.iter().map(|robot| robot.name());
    let published = published::ALL.iter().map(|robot| robot.name);
    let named = built_in.chain(published).map(|name| {
        let robot = Robot::named(name);
        robot.unwrap_or_else(|error| panic!("{name}: {error}"))
    });
    let described = DESCRIBED
        .into_iter()
        .map(|text| Robot::from_description(text).expect("it describes a robot"));
    named.chain(described).collect()
}

/// A robot and an edition, with a program that declares a name of each type, and a label of each kind.
struct Situation {
    options: Options,
    edition: Edition,
    joints: u8,
    /// The value of the constant C.
    constant: &'static str,
}

impl Situation {
    /// Returns the lines before and behind statements.
    fn around(&self) -> [String; 2] {
        let mut head = format!(
            "{}\nT\nDEF_VAR V, W\nDEF_POS P\nDEF_JOINT Q\n",
            self.edition
        );
        let mut tail = "EXIT\nSUBROUTINE S1:\nSUBEND\n".to_owned();
        if self.edition.is_strict() {
            head += &format!("DEFINE C {}\n", self.constant);
            tail += "THREAD T1:\nTHREADEND\n";
        }
        head += "V = 1\nW = V\nKEY_IN\nP.X = V\nP.Y = V\nP.Z = V\n";
        for joint in 1..=self.joints {
            head += &format!("Q.J{joint} = V\n");
        }
        head += "L1:\nLOOP:\n";
        [head, tail + "END\n"]
    }

    /// Returns the words that are offered behind a text of several lines.
    fn offers(&self, text: &str) -> Vec<CompletionItem> {
        let [head, tail] = self.around();
        let at = head.len() + text.len();
        let document = Document::new("test.prg", &format!("{head}{text}\n{tail}"), &self.options);
        document.complete(at)
    }

    /// Returns for each group of statements whether a program of all of them has no error in it.
    fn passing(&self, groups: &[String]) -> Vec<bool> {
        let [head, tail] = self.around();
        let mut first = head.lines().count() as u32 + 1;
        let lines = groups.iter().map(|group| {
            let lines = first..first + group.lines().count() as u32;
            first = lines.end;
            lines
        });
        let lines: Vec<_> = lines.collect();
        let text = format!("{head}{}\n{tail}", groups.join("\n"));
        let loaded = tipc::load("test.prg", text.as_bytes(), &self.options);
        let is_error = |level| level == Level::Error;
        let errors = loaded.diagnostics.iter().filter(|it| is_error(it.level()));
        let wrong: BTreeSet<u32> = errors
            .map(|error| loaded.source.line_column(error.span.start).0)
            .collect();
        let passes = lines
            .into_iter()
            .map(|lines| wrong.range(lines).next().is_none());
        passes.collect()
    }

    fn loads(&self, text: &str) -> bool {
        let [head, tail] = self.around();
        let text = format!("{head}{text}\n{tail}");
        let loaded = tipc::load("test.prg", text.as_bytes(), &self.options);
        loaded.program.is_some()
    }

    /// Returns what may follow a word.
    fn rests(&self) -> Vec<String> {
        let several = |word: &str, count: u8| format!(" {word}").repeat(count.into());
        let mut operands = BTreeSet::from([0, 1, 2, 3, self.joints, self.joints - 1]);
        operands.remove(&u8::MAX);
        let mut tails: Vec<String> = operands.iter().map(|count| several("V", *count)).collect();
        tails.extend([" P", " Q", " Q Q", " P V", " F1 V V V", " F1 P"].map(str::to_owned));
        tails.extend([several("F1 V", 1), several("J11 V", 1), several("ALL V", 1)]);
        tails.extend([
            format!(" F1{}", several("V", self.joints)),
            " J13 V V V".to_owned(),
        ]);
        tails.push(" FLOOR V V V".to_owned());
        let blocks = [
            " THEN\nENDIF",
            " < V THEN\nENDIF",
            " V THEN\nENDIF",
            "\nENDIF",
            " L1:",
            " S1:",
            "\nWEND",
            " < V\nWEND",
            " < V",
            " = V TO V\nNEXT",
            " TO V\nNEXT",
            " V\nNEXT",
            "\nNEXT",
            "%",
        ];
        tails.extend(blocks.map(str::to_owned));
        let members = ["", ".X", ".J1"];
        let all = members
            .iter()
            .flat_map(|member| tails.iter().map(move |tail| format!("{member}{tail}")));
        all.collect()
    }

    /// Tries the words that are offered behind a text, and returns those with which no rest passes, and the others.
    fn try_offers(
        &mut self,
        before: &str,
        rests: &mut [String],
    ) -> (Vec<CompletionItem>, Vec<CompletionItem>) {
        let mut open = self.offers(before);
        let mut passed = Vec::new();
        let start = |item: &CompletionItem, line: usize| {
            // The word replaces its beginning.
            let word = item.span.end - item.span.start;
            let kept = before.len() - word.min(before.len());
            format!(
                "{}{}",
                before[..kept].replace("{n}", &line.to_string()),
                item.text
            )
        };
        // A constant has the value that its place needs.
        for constant in ["1", "10", "50", "0"] {
            self.constant = constant;
            for first in (0..rests.len()).step_by(FEW) {
                let tried = &rests[first..rests.len().min(first + FEW)];
                let is_tried = |item: &CompletionItem| {
                    constant == "1" || item.detail == Keyword::Define.word()
                };
                let items: Vec<CompletionItem> =
                    open.iter().filter(|it| is_tried(it)).cloned().collect();
                if items.is_empty() {
                    break;
                }
                let pairs = items
                    .iter()
                    .flat_map(|item| tried.iter().map(move |rest| (item, rest)));
                let groups = pairs.enumerate();
                let groups = groups.map(|(line, (item, rest))| start(item, line) + rest);
                let passing = self.passing(&groups.collect::<Vec<_>>());
                let mut each = passing.chunks(tried.len());
                let mut useful = vec![false; tried.len()];
                let is_right = |item: &mut CompletionItem| {
                    let passes = is_tried(item).then(|| each.next()).flatten();
                    let passes = passes.unwrap_or_default();
                    for (useful, passes) in useful.iter_mut().zip(passes) {
                        *useful |= *passes;
                    }
                    passes.contains(&true)
                };
                passed.extend(open.extract_if(.., is_right));
                if let Some(place) = useful.iter().position(|useful| *useful) {
                    // It is likely to do for the next ones.
                    rests[..=first + place].rotate_right(1);
                }
            }
        }
        self.constant = "1";
        (open, passed)
    }
}

/// Number of rests that are tried together.
const FEW: usize = 4;

/// Returns what tells words apart that are treated alike.
fn class(item: &CompletionItem) -> (u8, String) {
    let kind = match item.kind {
        CompletionKind::Target => 0,
        CompletionKind::MotionFlag => 1,
        CompletionKind::Flag => 2,
        CompletionKind::Function => 3,
        CompletionKind::Label => 4,
        _ => 5,
    };
    let word = match (item.kind, item.label.chars().next()) {
        // Joints differ by their place in the leg.
        (CompletionKind::Target, Some(first @ ('F' | 'J'))) => {
            let last = item.label.chars().last().filter(|_| first == 'J');
            format!("{first}{last:?}{}", item.label.len())
        }
        (CompletionKind::Flag, _) => String::new(),
        (CompletionKind::Variable, Some('@')) => item
            .label
            .chars()
            .filter(|it| !it.is_ascii_digit())
            .collect(),
        (CompletionKind::Variable | CompletionKind::Constant, _) => item.detail.clone(),
        _ => item.label.clone(),
    };
    (kind, word)
}

/// The beginnings of statements, besides commands.
const BEGINNINGS: &[&str] = &[
    "IF ",
    "IF !",
    "IF -",
    "IF V ",
    "IF V < ",
    "IF V < -",
    "IF V < W ",
    "IF KB_HIT ",
    "IF !KB_HIT ",
    "IF KB_HIT GOTO ",
    "IF V < W GOSUB ",
    "IF P.",
    "WHILE ",
    "WHILE V <= ",
    "REPEAT\nUNTIL ",
    "IF KB_HIT THEN\nELSEIF ",
    "IF KB_HIT THEN\nELSEIF KB_HIT ",
    "FOR ",
    "FOR V = ",
    "FOR V = 1 ",
    "FOR V = 1 TO ",
    "FOR V = 1 TO 3 ",
    "FOR V = -1 TO -3 STEP ",
    "FOR V = -1 TO -3 STEP -",
    "FOR W = 1 TO 3\nNEXT ",
    "V = ",
    "V=",
    "V = -",
    "V += ",
    "P.X = ",
    "V = W ",
    "V = W + ",
    "V = W + -",
    "V = -W*",
    "V = W + W ",
    "V = SIN ",
    "V = SIN -",
    "V = SIN W ",
    "V = NORM ",
    "V = ATAN2 V ",
    "P = ",
    "P *= ",
    "P = P ",
    "P = P - ",
    "P = UNIT_VECT ",
    "P = ROT_Z ",
    "P = ROT_Z P ",
    "Q = ",
    "Q = Q + ",
    "Q = -",
    "V = P.",
    "V = Q.",
    "V = @",
    "V = @AG",
    "GOTO ",
    "GOTO L",
    "GOSUB ",
    "CALL ",
    "START_THREAD ",
    "STOP_THREAD ",
    "WAIT_THREAD ",
    "DEFINE D{n} ",
    "DEFINE D{n} -",
    "AD_IN 0 13 ",
    "SPECIAL 1 ",
    "SPECIAL 1 V ",
    "PTP F1 -",
    "PTP F1 V -",
    "MESSAGE %",
    "F_MESSAGE a %",
];

#[test]
fn every_word_that_is_offered_passes_the_checker() {
    let mut refused: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let mut tried = 0;
    let mut explored = HashSet::new();
    for robot in robots() {
        let options = robot.options();
        // Robots that differ in their legs alone differ in the first words alone.
        let facts = options.robot.facts();
        let kind = (facts.signature.family, facts.signature.joints);
        let is_new = explored.insert((kind, facts.has_slider, facts.has_forces));
        let depth = if is_new { 3 } else { 0 };
        for edition in Edition::ALL {
            let mut situation = Situation {
                options,
                edition: *edition,
                joints: options.robot.signature().joints,
                constant: "1",
            };
            let mut rests = situation.rests();
            let exists = |keyword: &&&'static str| {
                let word = keyword.split([' ', '{']).next().unwrap_or_default();
                let row = COMMANDS.iter().find(|row| row.name == word);
                row.is_none_or(|row| row.since <= *edition && row.robots.contains(options.robot))
            };
            let commands = COMMANDS.iter().filter(|row| {
                !matches!(row.meaning, Meaning::Keyword(_))
                    && row.since <= *edition
                    && row.robots.contains(options.robot)
            });
            let commands = commands.map(|row| format!("{} ", row.name));
            let others = BEGINNINGS.iter().filter(exists).map(|it| (*it).to_owned());
            let mut open: VecDeque<(String, usize)> = commands
                .map(|it| (it, 0))
                .chain(others.map(|it| (it, depth)))
                .collect();
            while let Some((before, at)) = open.pop_front() {
                let (wrong, right) = situation.try_offers(&before, &mut rests);
                tried += wrong.len() + right.len();
                for item in wrong {
                    let words = refused.entry(format!("{edition} {before}")).or_default();
                    words.push(format!("{}: {}", options.robot.name(), item.label));
                }
                let mut classes = BTreeSet::new();
                let words = right.into_iter().filter(|item| classes.insert(class(item)));
                let words: Vec<CompletionItem> = words.collect();
                let goes_on = |item: &&CompletionItem| match at {
                    0 => true,
                    1 => item.kind != CompletionKind::Constant,
                    _ => item.detail == Keyword::DefVar.word(),
                };
                if at < depth {
                    let words = words.iter().filter(goes_on);
                    open.extend(words.map(|item| (format!("{before}{} ", item.text), at + 1)));
                }
            }
        }
    }
    assert!(tried > 30_000, "{tried}");
    assert_eq!(refused, BTreeMap::new());
}

/// Replaces the placeholders of a snippet; `choice` selects among the words that fit one.
fn filled(snippet: &str, choice: usize) -> String {
    let mut out = String::new();
    let mut rest = snippet;
    while let Some((before, after)) = rest.split_once('$') {
        out += before;
        let Some(inside) = after.strip_prefix('{') else {
            rest = after.trim_start_matches('0');
            continue;
        };
        let (inside, next) = inside.split_once('}').expect("it is closed");
        rest = next;
        let inside = inside.trim_start_matches(|it: char| it.is_ascii_digit());
        let words: Vec<&str> = match inside.strip_prefix('|') {
            Some(words) => words.trim_end_matches('|').split(',').collect(),
            None => match &inside[1..] {
                "number" | "x" | "y" | "z" | "low" | "high" | "VAR" => vec!["V"],
                "POS" => vec!["P"],
                "JOINT" => vec!["Q"],
                "condition" => vec!["KB_HIT"],
                "label" => vec!["L1", "S1", "L2"],
                "name" => vec!["N1", "T1"],
                "constant" | "0\u{2026}255" => vec!["1"],
                joint if joint.starts_with('j') => vec!["V"],
                other => vec![other],
            },
        };
        out += words[choice % words.len()];
    }
    out + rest
}

#[test]
fn every_snippet_passes_the_checker() {
    // Statements around the cursor, and a word that closes them; `|` is the cursor.
    let places: &[(&str, &[&str])] = &[
        ("|", &[]),
        ("EXIT\n|", &[]),
        ("IF KB_HIT THEN\n|\nENDIF", &[]),
        ("IF KB_HIT THEN\n|\nELSE\nENDIF", &[]),
        ("IF KB_HIT THEN\nELSE\n|\nENDIF", &[]),
        ("WHILE KB_HIT\nFOR V = 1 TO 3\n|\nNEXT\nWEND", &[]),
        ("EXIT\nSUBROUTINE S2:\nL2:\n|\nSUBEND", &[]),
        ("IF KB_HIT THEN\n|", &["ENDIF"]),
        ("IF KB_HIT THEN\nELSE\n|", &["ENDIF"]),
        ("IF KB_HIT THEN\nIF KB_HIT THEN\n|\nENDIF", &["ENDIF"]),
        ("WHILE KB_HIT\n|", &["WEND"]),
        ("REPEAT\n|", &["UNTIL"]),
        ("FOR V = 1 TO 3\n|", &["NEXT"]),
        ("EXIT\nSUBROUTINE S2:\nL2:\n|", &["SUBEND"]),
    ];
    for robot in robots() {
        for edition in Edition::ALL {
            let options = robot.options();
            let situation = Situation {
                options,
                edition: *edition,
                joints: options.robot.signature().joints,
                constant: "1",
            };
            let mut passed_somewhere: BTreeMap<String, bool> = BTreeMap::new();
            for (place, closers) in places {
                let (before, after) = place.split_once('|').expect("a cursor");
                let [head, tail] = situation.around();
                let at = head.len() + before.len();
                let text = format!("{head}{before}{after}\n{tail}");
                let offers = Document::new("test.prg", &text, &options).complete(at);
                let labels: Vec<&str> = offers.iter().map(|it| it.label.as_str()).collect();
                for closer in *closers {
                    assert!(
                        labels.contains(closer),
                        "{closer} at {place:?} among {labels:?}"
                    );
                }
                for item in &offers {
                    let is_variable = matches!(item.kind, CompletionKind::Variable);
                    let snippet = item.snippet.as_ref().unwrap_or(&item.text);
                    let rests: &[&str] = if is_variable {
                        &[" = 1", " = V", ".X = V", ".J1 = V"]
                    } else {
                        &[""]
                    };
                    let passes = rests.iter().any(|rest| {
                        let passes = |choice| {
                            let statement = filled(snippet, choice) + rest;
                            situation.loads(&format!("{before}{statement}{after}"))
                        };
                        match snippet.contains('|') {
                            true => (0..4).all(passes),
                            false => (0..3).any(passes),
                        }
                    });
                    let is_routine = [Keyword::Subroutine, Keyword::Thread]
                        .iter()
                        .any(|routine| item.label == routine.word());
                    if is_routine {
                        *passed_somewhere.entry(item.label.clone()).or_default() |= passes;
                    } else if closers.is_empty() || closers.contains(&item.label.as_str()) {
                        let name = options.robot.name();
                        assert!(passes, "{name} {edition} {place:?}: {snippet}");
                    }
                }
            }
            // Nothing may run into a routine: it passes behind EXIT.
            assert!(
                passed_somewhere.values().all(|passes| *passes),
                "{passed_somewhere:?}"
            );
        }
    }
}
