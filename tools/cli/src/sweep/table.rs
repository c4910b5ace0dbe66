//! The table of a sweep: a file that grows and can be gone on with, or standard output; and the figures of its summary, gathered
//! row by row.

use crate::error::{Error, is_closed};
use crate::message::{Figure, Sweeping, Using};
use crate::output;
use crate::run::line;
use crate::usage::quoted;
use serde::{Deserialize, Serialize};
use std::cmp::Ordering;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufRead, BufReader, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;
use tip_sweep::{Columns, LIMIT, Spec};
use tipc::language::Keyword;
use tipc::message::Lang;

/// The specification of a table, in a file next to it.
#[derive(Debug, PartialEq, Deserialize, Serialize)]
pub(crate) struct Saved {
    /// The version of the command that has written the table.
    tip: String,
    pub(crate) spec: Spec,
}

impl Saved {
    pub(super) fn new(spec: Spec) -> Self {
        Saved {
            tip: env!("CARGO_PKG_VERSION").to_owned(),
            spec,
        }
    }

    /// Reads the specification of a table.
    ///
    /// # Errors
    /// There is none.
    pub(crate) fn of(table: &Path, lang: Lang) -> Result<Self, Error> {
        let path = specification(table);
        let failed = |error: String| {
            let file = path.display().to_string().into();
            let error = error.into();
            Error::failed(Sweeping::NoSpecification { file, error }, lang)
        };
        let text = fs::read_to_string(&path).map_err(|error| failed(error.to_string()))?;
        serde_json::from_str(&text).map_err(|error| failed(error.to_string()))
    }

    fn text(&self) -> String {
        // The specification has string keys and no values that JSON lacks.
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }
}

/// Returns true for the table of a sweep, complete or not.
pub(crate) fn is_table(path: &Path) -> bool {
    let name = path.to_string_lossy();
    name.ends_with(".csv") || name.ends_with(".csv.part")
}

/// Returns the path of the specification of a table.
pub(crate) fn specification(table: &Path) -> PathBuf {
    match table.extension() {
        Some(end) if end == "part" => table.with_extension("").with_extension("sweep.json"),
        _ => table.with_extension("sweep.json"),
    }
}

/// Returns the path of an unfinished table.
pub(super) fn part(table: &Path) -> PathBuf {
    let mut name = table.as_os_str().to_owned();
    name.push(".part");
    name.into()
}

/// A table that grows.
pub(super) struct Table {
    out: Out,
    has_header: bool,
}

enum Out {
    Stream,
    /// The complete table is there.
    Complete,
    Part {
        file: File,
        path: PathBuf,
    },
}

impl Table {
    /// Returns the table on standard output.
    pub(super) fn stream() -> Self {
        Table {
            out: Out::Stream,
            has_header: false,
        }
    }

    /// Starts a table, or resumes one if there is a `header`, the first line of the sweep's table. Counts the rows of a
    /// resumed table.
    ///
    /// # Errors
    /// A file cannot be written, or there is something that must not be lost: an unfinished table, a device, another
    /// file in the place of the specification.
    pub(super) fn open(
        path: &Path,
        saved: &Saved,
        header: Option<&str>,
        lang: Lang,
    ) -> Result<(Self, Tally), Error> {
        let refuse = |why: Using| Err(Error::failed(why, lang));
        // A new table takes the place of a file, not of a link to it.
        let path = &fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        if fs::metadata(path).is_ok_and(|found| !found.is_file()) {
            let file = path.display().to_string().into();
            return refuse(Using::NotAFile { file });
        }
        let unfinished = part(path);
        let failed = |error| Error::cannot_write(&unfinished, error);
        let (has_part, is_there) = (unfinished.exists(), path.exists());
        if has_part && header.is_none() {
            let part = unfinished.display().to_string().into();
            return refuse(Using::HasPart { part });
        }
        let other_sweep = || {
            let file = path.display().to_string().into();
            refuse(Using::OtherSweep { file })
        };
        if let Some(header) = header.filter(|_| has_part || is_there) {
            if Saved::of(path, lang)? != *saved {
                return other_sweep();
            }
            let mut tally = Tally::default();
            let out = if has_part {
                let options = OpenOptions::new().read(true).write(true).open(&unfinished);
                let mut file = options.map_err(failed)?;
                let (end, is_whole) = count(&file, header, &mut tally).map_err(failed)?;
                if end == 0 && !is_whole {
                    return other_sweep();
                }
                // A kill may have left a piece of a row, and a power failure rows of zeros.
                let cut = file.set_len(end).and_then(|()| file.seek(SeekFrom::End(0)));
                cut.map_err(failed)?;
                let path = unfinished;
                Out::Part { file, path }
            } else {
                let file = File::open(path).map_err(failed)?;
                let (_, is_whole) = count(&file, header, &mut tally).map_err(failed)?;
                if !is_whole {
                    return other_sweep();
                }
                Out::Complete
            };
            let has_header = tally.has_header();
            return Ok((Table { out, has_header }, tally));
        }
        let specified = specification(path);
        if specified.exists() && Saved::of(path, lang).is_err() {
            let file = specified.display().to_string().into();
            return refuse(Using::NoSweep { file });
        }
        // The name that the user gave says more than that of the unfinished table.
        let file = File::create(&unfinished).map_err(|error| Error::cannot_write(path, error))?;
        output::replace(&specified, saved.text())?;
        let path = unfinished;
        let table = Table {
            out: Out::Part { file, path },
            has_header: false,
        };
        Ok((table, Tally::default()))
    }

    pub(super) fn is_stream(&self) -> bool {
        matches!(self.out, Out::Stream)
    }

    /// Adds rows; `false` if nobody reads them.
    pub(super) fn add(&mut self, columns: &Columns, tally: &mut Tally) -> Result<bool, Error> {
        if columns.is_empty() {
            return Ok(true);
        }
        let mut text = String::new();
        if !self.has_header {
            self.has_header = true;
            text = columns.csv_header();
        }
        text.push_str(&columns.csv_rows());
        text.lines().for_each(|line| tally.add(line));
        match &mut self.out {
            Out::Stream => {
                let mut out = io::stdout().lock();
                match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
                    Err(error) if is_closed(&error) => Ok(false),
                    Err(error) => Err(Error::cannot_write(Path::new("standard output"), error)),
                    Ok(()) => Ok(true),
                }
            }
            Out::Complete => Ok(true),
            Out::Part { file, path } => match file.write_all(text.as_bytes()) {
                Err(error) => Err(Error::cannot_write(path, error)),
                Ok(()) => Ok(true),
            },
        }
    }

    /// Gives the complete table its name.
    pub(super) fn finish(&mut self) -> Result<(), Error> {
        if let Out::Part { file, path } = &self.out {
            let table = path.with_extension("");
            let renamed = file.sync_all().and_then(|()| fs::rename(path, &table));
            renamed.map_err(|error| Error::cannot_write(&table, error))?;
        }
        Ok(())
    }
}

/// Counts the complete rows of a table up to the first line that is not the next one of the sweep. Returns their end,
/// and true if there is no such line.
fn count(file: &File, header: &str, tally: &mut Tally) -> io::Result<(u64, bool)> {
    let (mut end, mut line) = (0, Vec::new());
    let mut reader = BufReader::new(file);
    loop {
        line.clear();
        let length = reader.read_until(b'\n', &mut line)?;
        if !line.ends_with(b"\n") {
            return Ok((end, true));
        }
        let text = String::from_utf8_lossy(&line);
        let is_next = match tally.has_header() {
            false => text == header,
            true => tally.takes(text.trim_end()),
        };
        if !is_next {
            return Ok((end, false));
        }
        end += length as u64;
        tally.add(text.trim_end());
    }
}

/// The figures of a table.
#[derive(Debug, Default)]
pub(super) struct Tally {
    places: Option<Places>,
    /// Number of rows.
    pub(super) runs: u64,
    /// Number of runs in which the robot fell.
    pub(super) fell: u64,
    /// Number of emergency stops.
    stopped: u64,
    /// Number of runs that were cut off.
    cut_off: u64,
    best: Option<Row>,
    worst: Option<Row>,
}

/// The places of columns in a row.
#[derive(Debug)]
struct Places {
    /// Number of columns.
    columns: usize,
    /// The names of the axes, which are after the number of the case.
    axes: Vec<String>,
    end: usize,
    time: usize,
    falls: Option<usize>,
    first_fall: Option<usize>,
    /// The purpose of the robot: it walks forward, or lifts the first object.
    aim: Option<(usize, Aim)>,
}

#[derive(Clone, Copy, Debug)]
enum Aim {
    Forward,
    Lift,
}

/// A row that stands out.
#[derive(Clone, Debug)]
struct Row {
    fate: Fate,
    /// Time until the fall or stop, s, or else the distance, mm; the greater, the better.
    figure: f64,
    case: String,
    values: String,
}

/// The end of a robot, the worst first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Fate {
    Fell,
    Stopped,
    Worked,
}

impl Row {
    fn order(&self, other: &Row) -> Ordering {
        let order = self.fate.cmp(&other.fate);
        order.then(self.figure.total_cmp(&other.figure))
    }
}

impl Places {
    fn of(header: &str) -> Self {
        let names: Vec<String> = fields(header).collect();
        let place = |wanted: &str| {
            let rest = |name: &String| name.strip_prefix(wanted).map(str::to_owned);
            let is_it = |rest: String| rest.is_empty() || rest.starts_with(" [");
            names.iter().position(|name| rest(name).is_some_and(is_it))
        };
        let end = place("end").unwrap_or(1);
        let axes = names.get(1..end).unwrap_or_default();
        let name = |axis: &String| axis.split(" [").next().unwrap_or_default().to_owned();
        let aim = place("forward").map(|place| (place, Aim::Forward));
        Places {
            columns: names.len(),
            axes: axes.iter().map(name).collect(),
            end,
            time: place("time").unwrap_or_default(),
            falls: place("falls"),
            first_fall: place("first_fall"),
            aim: aim.or_else(|| place("object1_highest").map(|place| (place, Aim::Lift))),
        }
    }
}

/// Returns the fields of a line of CSV.
fn fields(line: &str) -> impl Iterator<Item = String> {
    let mut rest = Some(line);
    std::iter::from_fn(move || {
        let line = rest?;
        let Some(mut quoted) = line.strip_prefix('"') else {
            let (field, after) = line.split_once(',').unzip();
            rest = after;
            return Some(field.unwrap_or(line).to_owned());
        };
        let mut field = String::new();
        loop {
            let (part, after) = quoted.split_once('"').unwrap_or((quoted, ""));
            field.push_str(part);
            match after.strip_prefix('"') {
                Some(more) => {
                    field.push('"');
                    quoted = more;
                }
                None => {
                    rest = after.strip_prefix(',');
                    return Some(field);
                }
            }
        }
    })
}

impl Tally {
    /// Returns true if it has a header.
    pub(super) fn has_header(&self) -> bool {
        self.places.is_some()
    }

    /// Returns true if a line has the number of the next case, and a value in each column.
    pub(super) fn takes(&self, line: &str) -> bool {
        let case = fields(line).next();
        case == Some(self.runs.to_string())
            && self.places.as_ref().map(|places| places.columns) == Some(fields(line).count())
    }

    /// Adds a line of the table: the header, then rows.
    pub(super) fn add(&mut self, line: &str) {
        let Some(places) = &self.places else {
            self.places = Some(Places::of(line));
            return;
        };
        let fields: Vec<String> = fields(line).collect();
        let number = |place: usize| fields.get(place)?.parse::<f64>().ok();
        let end = fields.get(places.end).map_or("", String::as_str);
        let has_fallen = places
            .falls
            .and_then(number)
            .is_some_and(|falls| falls > 0.0);
        let is_stopped = ![Keyword::End.word(), Keyword::Exit.word(), LIMIT].contains(&end);
        self.runs += 1;
        self.fell += u64::from(has_fallen);
        self.stopped += u64::from(is_stopped);
        self.cut_off += u64::from(end == LIMIT);
        let (fate, figure) = match (has_fallen, is_stopped) {
            (true, _) => (Fate::Fell, places.first_fall.and_then(number)),
            (false, true) => (Fate::Stopped, number(places.time)),
            (false, false) => (Fate::Worked, places.aim.and_then(|(aim, _)| number(aim))),
        };
        let Some(figure) = figure else { return };
        let mut row = Row {
            fate,
            figure,
            case: String::new(),
            values: String::new(),
        };
        let is_worst = self
            .worst
            .as_ref()
            .is_none_or(|worst| row.order(worst).is_lt());
        let is_best = self
            .best
            .as_ref()
            .is_none_or(|best| row.order(best).is_gt());
        if !is_worst && !is_best {
            return;
        }
        row.case.clone_from(&fields[0]);
        for (name, value) in places.axes.iter().zip(&fields[1..]) {
            row.values += &format!(", {name}={value}");
        }
        if is_worst {
            self.worst = Some(row.clone());
        }
        if is_best {
            self.best = Some(row);
        }
    }

    /// Returns the summary of the table `name`; `made` is the number of runs that were made now, and their time.
    pub(super) fn summary(
        &self,
        name: &str,
        is_stream: bool,
        until: f64,
        (made, elapsed): (u64, Duration),
        lang: Lang,
    ) -> String {
        let all = || self.runs.to_string();
        let share = |count: u64| Sweeping::Share {
            count: count.to_string(),
            all: all(),
            share: format!("{:.1}", 100.0 * count as f64 / self.runs.max(1) as f64),
        };
        let seconds = elapsed.as_secs_f64();
        let rate = made as f64 / seconds.max(1e-9);
        let digits = usize::from(rate < 10.0);
        let made = Sweeping::Made {
            file: name.to_owned().into(),
            runs: all(),
            made: made.to_string(),
            time: format!("{seconds:.1}"),
            rate: format!("{rate:.digits$}"),
        };
        let mut text = format!("{}\n", made.in_lang(lang));
        let mut add = |figure, value: Sweeping| text += &line(figure, value.in_lang(lang), lang);
        let has_falls = |places: &Places| places.falls.is_some();
        if self.places.as_ref().is_some_and(has_falls) {
            add(Figure::Falls, share(self.fell));
        }
        if self.stopped > 0 {
            add(Figure::Stops, share(self.stopped));
        }
        if self.cut_off > 0 {
            let (count, time) = (self.cut_off.to_string(), until.to_string());
            let all = all();
            add(Figure::CutOff, Sweeping::CutOff { count, all, time });
        }
        let best = self.best.iter().filter(|best| best.fate == Fate::Worked);
        let best = best.map(|row| (Figure::Best, row));
        for (figure, row) in best.chain(self.worst.iter().map(|row| (Figure::Worst, row))) {
            let outstanding = Sweeping::Outstanding {
                result: self.result(row).in_lang(lang).to_string().into(),
                case: row.case.clone(),
                values: row.values.clone().into(),
            };
            text += &line(figure, outstanding.in_lang(lang), lang);
            if !is_stream {
                text += &format!("          tip view {} --case {}\n", quoted(name), row.case);
            }
        }
        text
    }

    fn result(&self, row: &Row) -> Sweeping {
        let time = || format!("{:.3}", row.figure);
        let length = || format!("{:.1}", row.figure);
        match (row.fate, self.places.as_ref().and_then(|places| places.aim)) {
            (Fate::Fell, _) => Sweeping::FellAfter { time: time() },
            (Fate::Stopped, _) => Sweeping::StoppedAfter { time: time() },
            (Fate::Worked, Some((_, Aim::Lift))) => Sweeping::Lifted { length: length() },
            (Fate::Worked, _) => Sweeping::Walked { length: length() },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_may_be_quoted() {
        let split = |line| fields(line).collect::<Vec<_>>();
        assert_eq!(split("1,a,,2"), ["1", "a", "", "2"]);
        assert_eq!(split(r#"1,"a, ""b""",2"#), ["1", r#"a, "b""#, "2"]);
        assert_eq!(split(r#""a""#), ["a"]);
    }

    #[test]
    fn a_fall_is_worse_than_a_stop_and_a_stop_than_a_short_way() {
        let mut tally = Tally::default();
        tally.add("case,A,end,time [s],forward [mm],falls,first_fall [s]");
        for row in [
            "0,1,END,9,500,0,",
            "1,2,END,9,900,0,",
            "2,3,E205,4,100,0,",
            "3,4,END,9,2000,1,5",
            "4,5,limit,9,2000,2,3",
        ] {
            tally.add(row);
        }
        let text = tally.summary(
            "t.csv",
            false,
            9.0,
            (5, Duration::from_secs(1)),
            Lang::English,
        );
        assert_eq!(
            text,
            "t.csv: 5 runs, 5 of them now in 1.0 s, 5.0 a second\n  falls   2 of 5, 40.0 %\n  stops   1 of 5, 20.0 %\n  \
             cut off 1 of 5, after 9 s or --cycles; --until sets another limit\n  best    900.0 mm forward: case 1, A=2\n          \
             tip view t.csv --case 1\n  worst   a fall after 3.000 s: case 4, A=5\n          tip view t.csv --case 4\n"
        );
    }
}
