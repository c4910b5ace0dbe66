//! Errors of a specification, found before the first run, and of cases; and their messages: reasons why a sweep cannot run, each
//! with a way out.

use serde::Serialize;
use std::fmt;
use tipc::diagnostic::Diagnostic;
use tipc::message::say::Say;
use tipc::message::{Lang, Text};
use tipc::{Loaded, render};

tipc::message_table! {
    /// A reason why a sweep cannot run.
    Sweeping;

    NoValues { text: String }
        "`{text}` is not a quantity with values: write NAME=FROM..TO/STEP, NAME=A,B,C, NAME=uniform(LOW,HIGH) or NAME=normal(MEAN,DEVIATION)",
        "`{text}` は量と値の指定ではありません。NAME=FROM..TO/STEP、NAME=A,B,C、NAME=uniform(LOW,HIGH)、NAME=normal(MEAN,DEVIATION) のように書いてください";
    NotANumber { word: String, text: String }
        "`{word}` in `{text}` is not a number: write NAME=FROM..TO/STEP, NAME=A,B,C, NAME=uniform(LOW,HIGH) or NAME=normal(MEAN,DEVIATION)",
        "`{text}` の `{word}` は数値ではありません。NAME=FROM..TO/STEP、NAME=A,B,C、NAME=uniform(LOW,HIGH)、NAME=normal(MEAN,DEVIATION) のように書いてください";
    CannotVary { axis: String, reason: Text }
        "cannot vary '{axis}': {reason}",
        "'{axis}' を変えられません: {reason}";
    InCase { case: String, values: Text, reason: Text }
        "case {case} ({values}): {reason}",
        "ケース{case} ({values}): {reason}";
    UnknownQuantity
        "this is neither a variable of the program nor one of friction, scene.KEY, robot.KEY, push.x, push.y, push.z, push.at, push.for, noise.angle, noise.sole and sensor.NAME",
        "プログラムの変数でも、friction、scene.キー、robot.キー、push.x、push.y、push.z、push.at、push.for、noise.angle、noise.sole、sensor.名前 のどれでもありません";
    IsConstant
        "DEFINE makes it a constant: declare it with DEF_VAR and assign its value",
        "DEFINEで定義した定数です。DEF_VARで宣言し、値を代入してください";
    UnknownVariable { name: String }
        "cannot record '{name}': this is not a variable of the program",
        "'{name}' を記録できません: プログラムの変数ではありません";
    UnknownColumn { name: String, known: String }
        "the table has no numbers `{name}`; it has {known}",
        "表に数の列 `{name}` はありません。あるのは {known} です";
    NotACondition { text: String }
        "`{text}` is not a condition: write the name of a column, one of < <= > >= or =, and a number, as in `falls=0`",
        "`{text}` は条件ではありません。列の名前、< <= > >= = のどれか、数を `falls=0` のように書いてください";
    NotAnInput { input: String }
        "'{input}' is not an input",
        "'{input}' は入力ではありません";
    Unused
        "the program does not use it",
        "プログラムで使われていません";
    ComputedFirst { line: u32 }
        "line {line} computes it before its first use; vary what it is computed from",
        "{line}行目で、最初に使う前に計算されます。計算の元になる量を変えてください";
    VariedTwice
        "it is varied twice",
        "2回指定されています";
    NoDescription { robot: String }
        "{robot} has no description; use a robot that has one, such as a1, or --robot FILE.toml",
        "{robot} には記述ファイルがありません。a1 など記述ファイルのあるロボットか、--robot FILE.toml を使ってください";
    NoSceneFile { scene: String }
        "the scene {scene} has no file whose numbers could vary; write one and use --scene FILE.toml",
        "シーン {scene} には値を変えられるファイルがありません。ファイルを書いて --scene FILE.toml を使ってください";
    NoElement { index: String }
        "there is no element {index}; elements count from 1",
        "{index}番目の要素はありません。要素は1から数えます";
    NoKey { key: String }
        "there is no {key} in a number",
        "数値の中に {key} はありません";
    RobotRefuses { errors: Texts }
        "the robot does not allow a value: {errors}",
        "ロボットがこの値を受け付けません: {errors}";
    SceneRefuses { errors: Texts }
        "the scene does not allow a value: {errors}",
        "シーンがこの値を受け付けません: {errors}";
    EmptyList
        "the list of values is empty",
        "値のリストが空です";
    NotFinite
        "a value is not a finite number",
        "有限の数でない値があります";
    TooLarge
        "the numbers are too large: computing with them exceeds the largest number, 1.8e308",
        "数が大きすぎます: 計算の途中で最大の数1.8e308を超えます";
    EmptyRange
        "the range is empty: the step leads away from its end",
        "範囲が空です: 刻みが終わりから遠ざかる向きです";
    NoStep
        "the step is 0",
        "刻みが0です";
    Negative
        "no time or deviation is below 0",
        "時間や標準偏差は0より小さくできません";
    LongRange
        "the range has more than 1,000,000 values",
        "範囲に1,000,000を超える値があります";
    UpsideDown
        "the lower bound is above the upper one",
        "下限が上限より大きくなっています";
    NegativeDeviation
        "the standard deviation is negative or no number",
        "標準偏差が負か、数ではありません";
    NoRepeat
        "the number of repeats is 0",
        "繰り返しの数が0です";
    ManyCases { count: String, limit: String }
        "these are {count} cases, more than {limit}; take wider steps, or random values: NAME=uniform(LOW,HIGH)",
        "ケースの数が{count}で、上限の{limit}を超えます。刻みを広げるか、乱数 NAME=uniform(LOW,HIGH) を使ってください";
    NoCase { case: String, count: String }
        "there is no case {case}; the sweep has {count}, which count from 0",
        "ケース{case}はありません。ケースは0から数えて{count}個です";
    NoTime
        "the longest time of a run must be above 0 s",
        "実行時間の上限は0 sより大きくしてください";
    OtherProgram
        "the compiled program was not compiled from the text of the specification",
        "コンパイル済みのプログラムは、指定のテキストからコンパイルされたものではありません";
    Suggests { reason: Text, near: String }
        "{reason}; did you mean {near}?",
        "{reason}。{near} のことですか?";
    Says { text: Texts }
        "{text}",
        "{text}";
}

/// A text in each language.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Texts {
    #[serde(rename = "en")]
    english: String,
    #[serde(rename = "ja")]
    japanese: String,
}

impl Texts {
    /// Returns the text that a function gives in each language.
    pub(crate) fn of(text: impl Fn(Lang) -> String) -> Self {
        let of = |lang| text(lang).trim_end().to_owned();
        Texts {
            english: of(Lang::English),
            japanese: of(Lang::Japanese),
        }
    }

    /// Returns the text in a language.
    pub fn text(&self, lang: Lang) -> &str {
        lang.pick(&self.english, &self.japanese)
    }

    /// Returns the errors of a file, one line each.
    pub(crate) fn found(loaded: &Loaded) -> Self {
        let short = |one, lang| render::short(&loaded.source, one, lang);
        let lines = |lang| loaded.diagnostics.iter().map(move |one| short(one, lang));
        Texts::of(|lang| lines(lang).collect())
    }

    /// Returns the errors of a file that the sweep has made: each reason with its line.
    pub(crate) fn reasons(loaded: &Loaded) -> Self {
        let text = loaded.source.text();
        let line = |place: usize| {
            let (before, after) = text.split_at_checked(place).unwrap_or((text, ""));
            let start = before.rfind('\n').map_or(0, |end| end + 1);
            let end = place + after.find('\n').unwrap_or(after.len());
            text.get(start..end).unwrap_or_default().trim()
        };
        let said = |one: &Diagnostic, lang| {
            let reason = one.reason.in_lang(lang).to_string();
            format!("{reason} (`{}`)", line(one.span.start))
        };
        let all = |lang| loaded.diagnostics.iter().map(move |one| said(one, lang));
        Texts::of(|lang| all(lang).collect::<Vec<_>>().join("; "))
    }
}

impl Say for Texts {
    fn say(&self, lang: Lang, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.text(lang))
    }
}

/// A reason why a sweep cannot run.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepError(Box<Parts>);

#[derive(Clone, Debug, PartialEq)]
struct Parts {
    reason: Sweeping,
    /// The nearest known name.
    near: Option<String>,
    axis: Option<String>,
    /// The number of the case whose values are not allowed, and the values.
    case: Option<(u64, String)>,
}

impl SweepError {
    /// Returns the error of an axis.
    pub(crate) fn axis(axis: &str, reason: impl Into<SweepError>) -> Self {
        let mut error = reason.into();
        error.0.axis = Some(axis.to_owned());
        error
    }

    /// Returns the error that the values of a case cause.
    pub(crate) fn in_case(mut self, number: u64, values: String) -> Self {
        self.0.case = Some((number, values));
        self
    }

    /// Returns an error of another crate.
    pub(crate) fn says(error: impl fmt::Display) -> Self {
        let text = Texts::of(|_| error.to_string());
        Sweeping::Says { text }.into()
    }

    /// Returns the errors of a file.
    pub(crate) fn found(loaded: &Loaded) -> Self {
        let text = Texts::found(loaded);
        Sweeping::Says { text }.into()
    }

    /// Adds the name that was probably meant.
    pub(crate) fn near(mut self, name: String) -> Self {
        self.0.near = Some(name);
        self
    }

    /// Adds the nearest of the known names, if one is near.
    pub(crate) fn suggest<'a>(mut self, name: &str, known: impl Iterator<Item = &'a str>) -> Self {
        let wanted = name.to_ascii_lowercase();
        let distance =
            |known: &str| strsim::damerau_levenshtein(&known.to_ascii_lowercase(), &wanted);
        let near = known.map(|known| (distance(known), known));
        let near = near.filter(|(distance, _)| *distance <= 1 + name.len() / 4);
        self.0.near = near.min().map(|(_, near)| near.to_owned());
        self
    }

    /// Returns the message in a language.
    pub fn text(&self, lang: Lang) -> String {
        let say = |message: Sweeping| message.in_lang(lang).to_string();
        let mut text = say(self.0.reason.clone());
        if let Some(near) = self.0.near.clone() {
            let reason = text.into();
            text = say(Sweeping::Suggests { reason, near });
        }
        if let Some(axis) = self.0.axis.clone() {
            let reason = text.into();
            text = say(Sweeping::CannotVary { axis, reason });
        }
        if let Some((case, values)) = self.0.case.clone() {
            let (case, values, reason) = (case.to_string(), values.into(), text.into());
            text = say(Sweeping::InCase {
                case,
                values,
                reason,
            });
        }
        text
    }
}

impl From<Sweeping> for SweepError {
    fn from(reason: Sweeping) -> Self {
        SweepError(Box::new(Parts {
            reason,
            near: None,
            axis: None,
            case: None,
        }))
    }
}

impl fmt::Display for SweepError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text(Lang::English))
    }
}

impl std::error::Error for SweepError {}
