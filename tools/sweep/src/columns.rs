//! Columns and rows of results, and their CSV form. How a cell is measured is in `measure`.

use crate::error::Texts;
use crate::spec::hash_bytes;
use serde::Serialize;
use std::cmp::Ordering;
use std::fmt;
use std::sync::Arc;
use tipc::language::Keyword;

/// The word for the end of a run that was cut off at its limit.
pub const LIMIT: &str = "limit";

tipc::message_table! {
    /// The meaning of a column.
    Meaning;

    Case "number of the case, from 0", "ケースの番号(0から)";
    Variable "value of the program's variable", "プログラムの変数の値";
    Force "force on the body along an axis of the world", "胴体に加える力(ワールド座標系の軸方向)";
    ForceStart "start of the force on the body", "胴体に力を加え始める時刻";
    ForceTime "duration of the force on the body", "胴体に力を加える時間";
    AngleNoise "standard deviation of measured joint angles", "関節角度の測定値の標準偏差";
    SoleNoise "standard deviation of measured soles", "足裏センサーの測定値の標準偏差";
    Reading "reading of the input", "入力の値";
    End "END, EXIT, limit (the longest time or number of cycles), or the fault of an emergency stop", "END、EXIT、limit(時間または周期数の上限)、または非常停止の原因";
    Line "line of the program where the run ended", "実行が終わったプログラムの行";
    Cycles "number of control cycles", "制御周期の数";
    Time "time on the robot", "ロボットの時間";
    Forward "travel of the body forward", "胴体の前への移動";
    Right "travel of the body to the right", "胴体の右への移動";
    Up "travel of the body upward", "胴体の上への移動";
    Turn "turn of the body to the left", "胴体の左への旋回";
    Speed "travel of the body forward, divided by the time of the run", "胴体の前への移動を実行時間で割った値";
    Falls "number of falls", "転倒の回数";
    UprightFalls "number of these falls that left the body upright", "そのうち胴体が倒れなかった回数";
    FirstFall "time of the first fall", "最初の転倒の時刻";
    Slip "greatest slip of a foot in one stance", "1回の接地中の足の滑りの最大値";
    LeastMargin "least stability margin", "安定余裕の最小値";
    Clearance "least distance of two links, or of a link and the body; negative where they overlap", "リンクどうし、またはリンクと胴体の距離の最小値(重なると負)";
    Collisions "number of cycles after which two parts of the robot overlapped", "ロボットの部分どうしが重なった周期の数";
    Tilt "greatest angle of the body from upright", "胴体の傾きの最大値";
    PeakSpeed "greatest speed of a joint", "関節の最大速度";
    PeakTorque "greatest torque of a joint", "関節の最大トルク";
    Energy "sum of |torque × rotation| over joints and cycles", "関節と周期にわたる|トルク×回転|の和";
    Cost "cost of transport: energy, divided by the weight and the travel along the floor", "移動コスト: エネルギーを重量と床に沿った移動距離で割った値";
    ObjectX "x of the object", "物体のx";
    ObjectY "y of the object", "物体のy";
    ObjectAngle "angle of the object", "物体の角度";
    ObjectHighest "greatest height of the object", "物体の最大の高さ";
    Final "last value of the program's variable", "プログラムの変数の最後の値";
    Hash "hash over the commands and measurements of each joint in each cycle", "各周期の各関節の指令と測定値のハッシュ";
    Check "hash over the row and the specification", "この行と仕様のハッシュ";
}

impl From<Meaning> for Texts {
    fn from(meaning: Meaning) -> Self {
        Texts::of(|lang| meaning.in_lang(lang).to_string())
    }
}

/// The type of a column's cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// Numbers; NaN for a missing one.
    Number,
    /// Counts.
    Count,
    /// Words, none of which reads as a number.
    Text,
}

/// A column: its name, unit, type and meaning.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Column {
    /// Its name.
    pub name: String,
    /// Its unit; empty if it has none.
    pub unit: &'static str,
    /// The type of its cells.
    #[serde(rename = "type")]
    pub kind: Kind,
    /// Its meaning.
    pub meaning: Texts,
    #[serde(skip)]
    pub(crate) measure: Measure,
}

impl Column {
    /// Returns the name with the unit in brackets, as the first line of a CSV file has it.
    fn title(&self) -> String {
        match self.unit {
            "" => self.name.clone(),
            unit => format!("{} [{unit}]", self.name),
        }
    }
}

/// The source of a column's cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Measure {
    Case,
    /// An axis of the sweep, by its index.
    Axis(usize),
    End,
    Line,
    Cycles,
    Time,
    Forward,
    Right,
    Up,
    Turn,
    Speed,
    Falls,
    UprightFalls,
    FirstFall,
    Slip,
    LeastMargin,
    Tilt,
    Clearance,
    Collisions,
    PeakSpeed,
    PeakTorque,
    Energy,
    Cost,
    /// A measure of an object under a hand, by the index of the object.
    Object(usize, ObjectMeasure),
    /// A recorded scalar, by its index in `record`.
    Final(usize),
    Hash,
    Check,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ObjectMeasure {
    X,
    Y,
    Angle,
    Highest,
}

impl ObjectMeasure {
    pub(crate) const ALL: [Self; 4] = [Self::X, Self::Y, Self::Angle, Self::Highest];
}

impl Measure {
    /// Returns the column of the measure. `name` is the name of an axis or a recorded scalar.
    pub(crate) fn column(self, name: &str) -> Column {
        use Kind::{Count, Number, Text};
        let object = |of: &str| match self {
            Measure::Object(index, _) => format!("object{}_{of}", index + 1),
            _ => String::new(),
        };
        let (name, unit, kind, meaning) = match self {
            Measure::Case => ("case".to_owned(), "", Count, Meaning::Case),
            Measure::Axis(_) => (name.to_owned(), "", Number, Meaning::Variable),
            Measure::End => ("end".to_owned(), "", Text, Meaning::End),
            Measure::Line => ("line".to_owned(), "", Count, Meaning::Line),
            Measure::Cycles => ("cycles".to_owned(), "", Count, Meaning::Cycles),
            Measure::Time => ("time".to_owned(), "s", Number, Meaning::Time),
            Measure::Forward => ("forward".to_owned(), "mm", Number, Meaning::Forward),
            Measure::Right => ("right".to_owned(), "mm", Number, Meaning::Right),
            Measure::Up => ("up".to_owned(), "mm", Number, Meaning::Up),
            Measure::Turn => ("turn".to_owned(), "deg", Number, Meaning::Turn),
            Measure::Speed => ("speed".to_owned(), "mm/s", Number, Meaning::Speed),
            Measure::Falls => ("falls".to_owned(), "", Count, Meaning::Falls),
            Measure::UprightFalls => {
                let name = "upright_falls".to_owned();
                (name, "", Count, Meaning::UprightFalls)
            }
            Measure::FirstFall => ("first_fall".to_owned(), "s", Number, Meaning::FirstFall),
            Measure::Slip => ("slip".to_owned(), "mm", Number, Meaning::Slip),
            Measure::LeastMargin => {
                let name = "least_margin".to_owned();
                (name, "mm", Number, Meaning::LeastMargin)
            }
            Measure::Tilt => ("tilt".to_owned(), "deg", Number, Meaning::Tilt),
            Measure::Clearance => ("clearance".to_owned(), "mm", Number, Meaning::Clearance),
            Measure::Collisions => ("collisions".to_owned(), "", Count, Meaning::Collisions),
            Measure::PeakSpeed => ("peak_speed".to_owned(), "deg/s", Number, Meaning::PeakSpeed),
            Measure::PeakTorque => ("peak_torque".to_owned(), "N·m", Number, Meaning::PeakTorque),
            Measure::Energy => ("energy".to_owned(), "J", Number, Meaning::Energy),
            Measure::Cost => ("cost".to_owned(), "", Number, Meaning::Cost),
            Measure::Object(_, ObjectMeasure::X) => (object("x"), "mm", Number, Meaning::ObjectX),
            Measure::Object(_, ObjectMeasure::Y) => (object("y"), "mm", Number, Meaning::ObjectY),
            Measure::Object(_, ObjectMeasure::Angle) => {
                (object("angle"), "deg", Number, Meaning::ObjectAngle)
            }
            Measure::Object(_, ObjectMeasure::Highest) => {
                (object("highest"), "mm", Number, Meaning::ObjectHighest)
            }
            Measure::Final(_) => (format!("final_{name}"), "", Number, Meaning::Final),
            Measure::Hash => ("hash".to_owned(), "", Text, Meaning::Hash),
            Measure::Check => ("check".to_owned(), "", Text, Meaning::Check),
        };
        Column {
            name,
            unit,
            kind,
            meaning: meaning.into(),
            measure: self,
        }
    }
}

/// A cell of a row. JSON has null for a missing number.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Cell {
    /// A number; NaN if there is none.
    Number(f64),
    /// A count.
    Count(u64),
    /// A word.
    Text(String),
}

impl Cell {
    /// Reads a field of a CSV file.
    fn read(field: &str, kind: Kind) -> Option<Self> {
        match kind {
            Kind::Number if field.is_empty() => Some(Cell::Number(f64::NAN)),
            Kind::Number => field.parse().ok().map(Cell::Number),
            Kind::Count => field.parse().ok().map(Cell::Count),
            Kind::Text => Some(Cell::Text(field.to_owned())),
        }
    }
}

impl fmt::Display for Cell {
    /// Writes the field of a CSV file. A number reads back to the same bits; a missing one is empty.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Cell::Number(value) if value.is_nan() => Ok(()),
            Cell::Number(value) => value.fmt(f),
            Cell::Count(value) => value.fmt(f),
            Cell::Text(text) => f.write_str(text),
        }
    }
}

/// The result of a case.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    columns: Arc<[Column]>,
    cells: Vec<Cell>,
}

/// The outcome of a run, the worst first.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub enum Outcome {
    /// The robot fell after this time, s.
    Fell(f64),
    /// It stopped in an emergency after this time, s.
    Stopped(f64),
    /// It travelled forward at this speed, mm/s.
    Walked(f64),
    /// It lifted the first object to this height, mm.
    Lifted(f64),
    /// It neither walks nor lifts.
    Ended,
}

impl Outcome {
    /// Compares two outcomes of a table; the worse is less.
    pub fn order(&self, other: &Outcome) -> Ordering {
        self.partial_cmp(other).unwrap_or(Ordering::Equal)
    }
}

impl Row {
    /// Creates a row, and adds its last cell, the check.
    pub(crate) fn new(columns: &Arc<[Column]>, mut cells: Vec<Cell>, spec_hash: u64) -> Self {
        cells.push(Cell::Text(check(&cells, spec_hash)));
        Row {
            columns: Arc::clone(columns),
            cells,
        }
    }

    /// Reads a line of a CSV file. Returns `None` if it is not an unchanged row of the sweep with these columns and
    /// this specification.
    pub(crate) fn read(columns: &Arc<[Column]>, line: &str, spec_hash: u64) -> Option<Self> {
        let mut reader = csv::ReaderBuilder::new();
        let mut reader = reader.has_headers(false).from_reader(line.as_bytes());
        let record = reader.records().next()?.ok()?;
        if record.len() != columns.len() {
            return None;
        }
        let cells = columns.iter().zip(&record);
        let cells = cells.map(|(column, field)| Cell::read(field, column.kind));
        let mut cells: Vec<Cell> = cells.collect::<Option<_>>()?;
        cells.pop();
        let row = Row::new(columns, cells, spec_hash);
        (row.line().trim_end() == line.trim_end_matches('\n')).then_some(row)
    }

    /// Returns the columns.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// Returns the cells, in the order of the columns.
    pub fn cells(&self) -> &[Cell] {
        &self.cells
    }

    /// Returns the line of a CSV file, with its end.
    pub fn line(&self) -> String {
        csv_line(self.cells.iter().map(Cell::to_string))
    }

    /// Returns the number of the case.
    pub fn case(&self) -> u64 {
        self.count(Measure::Case).unwrap_or_default()
    }

    /// Returns the names of the axes and their values.
    pub fn values(&self) -> impl Iterator<Item = (&str, f64)> {
        let cells = self.columns.iter().zip(&self.cells);
        cells.filter_map(|(column, cell)| match (column.measure, cell) {
            (Measure::Axis(_), Cell::Number(value)) => Some((column.name.as_str(), *value)),
            _ => None,
        })
    }

    /// Returns true if falls are counted: the robot walks.
    pub fn counts_falls(&self) -> bool {
        self.cell(Measure::Falls).is_some()
    }

    /// Returns true if the robot fell, or without mass would have fallen.
    pub fn has_fallen(&self) -> bool {
        self.count(Measure::Falls).is_some_and(|falls| falls > 0)
    }

    /// Returns true if two parts of the robot overlapped.
    pub fn has_collided(&self) -> bool {
        let collisions = self.count(Measure::Collisions);
        collisions.is_some_and(|collisions| collisions > 0)
    }

    /// Returns true if the run ended in an emergency stop.
    pub fn is_stopped(&self) -> bool {
        let end = self.end();
        ![Keyword::End.word(), Keyword::Exit.word(), LIMIT].contains(&end)
    }

    /// Returns true if the run was cut off.
    pub fn is_cut_off(&self) -> bool {
        self.end() == LIMIT
    }

    /// Returns true if the robot fell or the run ended in an emergency stop: its numbers are no results.
    pub fn has_failed(&self) -> bool {
        self.has_fallen() || self.is_stopped()
    }

    /// Returns the number in the column of this name, NaN where it is missing; `None` if there is no such column of numbers.
    pub fn named(&self, name: &str) -> Option<f64> {
        let mut columns = self.columns.iter();
        let index = columns.position(|column| column.name == name)?;
        match self.cells.get(index)? {
            Cell::Number(number) => Some(*number),
            Cell::Count(count) => Some(*count as f64),
            Cell::Text(_) => None,
        }
    }

    /// Returns the outcome of the run.
    pub fn outcome(&self) -> Outcome {
        let object = Measure::Object(0, ObjectMeasure::Highest);
        let number = |measure| self.number(measure);
        let missing = f64::NAN;
        if self.has_fallen() {
            Outcome::Fell(number(Measure::FirstFall).unwrap_or(missing))
        } else if self.is_stopped() {
            Outcome::Stopped(number(Measure::Time).unwrap_or(missing))
        } else if let Some(speed) = number(Measure::Speed) {
            Outcome::Walked(speed)
        } else {
            number(object).map_or(Outcome::Ended, Outcome::Lifted)
        }
    }

    fn cell(&self, measure: Measure) -> Option<&Cell> {
        let mut columns = self.columns.iter();
        let index = columns.position(|column| column.measure == measure)?;
        self.cells.get(index)
    }

    fn count(&self, measure: Measure) -> Option<u64> {
        match self.cell(measure)? {
            Cell::Count(count) => Some(*count),
            _ => None,
        }
    }

    fn number(&self, measure: Measure) -> Option<f64> {
        match self.cell(measure)? {
            Cell::Number(number) => Some(*number),
            _ => None,
        }
    }

    fn end(&self) -> &str {
        match self.cell(Measure::End) {
            Some(Cell::Text(end)) => end,
            _ => "",
        }
    }
}

/// Returns the check of a row: it binds the cells to one another and to the specification. Its first letter keeps a reader of tables
/// from taking it for a number.
fn check(cells: &[Cell], spec_hash: u64) -> String {
    let fields = cells.iter().map(Cell::to_string);
    let hash = hash_bytes(csv_line(fields).as_bytes(), spec_hash);
    format!("c{:08x}", hash >> 32)
}

/// Some rows of a sweep, in the order of cases.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// The columns.
    pub columns: Arc<[Column]>,
    /// The rows.
    pub rows: Vec<Row>,
}

impl fmt::Display for Table {
    /// Writes a CSV file.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&header(&self.columns))?;
        self.rows
            .iter()
            .try_for_each(|row| f.write_str(&row.line()))
    }
}

/// Returns the first line of a CSV file: names, with units in brackets.
pub(crate) fn header(columns: &[Column]) -> String {
    csv_line(columns.iter().map(Column::title))
}

/// Returns a line of a CSV file, with its end.
fn csv_line(fields: impl Iterator<Item = String>) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    // Writing to memory cannot fail, and all fields are UTF-8.
    let _ = writer.write_record(fields);
    let bytes = writer.into_inner().unwrap_or_default();
    String::from_utf8(bytes).unwrap_or_default()
}
