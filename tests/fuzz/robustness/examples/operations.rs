//! Counts the instructions of each reader for each repeated form, at n and 4 n repetitions. `tests/external/operations/run` runs it
//! under callgrind, which writes the count of each call of [`counted`] to a file. The first argument is the common part of the names
//! of these files. The second selects the pairs whose name contains it, such as `lsp of 3.2`.

use robustness::repetitions::{ALL, Reader, Unit, forms, long_programs, pieces};
use std::env;
use std::error::Error;
use std::fs;
use std::process::ExitCode;

/// The most that four times the text may take.
const LIMIT: f64 = 5.0;

/// Runs a reader; returns false if it has nothing to do with a program.
#[inline(never)]
fn counted(reader: Reader, text: &str) -> bool {
    (reader.1)(text)
}

/// The files of callgrind, one for each call.
struct Dumps {
    prefix: String,
    calls: u32,
}

impl Dumps {
    /// Returns the instructions of a reader; `None` if it has nothing to do.
    fn count(&mut self, reader: Reader, text: &str) -> Result<Option<u64>, Box<dyn Error>> {
        let is_read = counted(reader, text);
        self.calls += 1;
        let path = format!("{}.{}", self.prefix, self.calls);
        let dump = fs::read_to_string(&path).map_err(|error| format!("{path}: {error}"))?;
        fs::remove_file(&path)?;
        let total = dump.lines().find_map(|line| line.strip_prefix("totals: "));
        let total = total.ok_or("a dump has no totals")?.trim().parse()?;
        Ok(is_read.then_some(total))
    }

    /// Prints the instructions at `count` and four times as many repetitions, and returns their ratio.
    fn ratio(
        &mut self,
        unit: &Unit,
        reader: Reader,
        count: usize,
    ) -> Result<Option<f64>, Box<dyn Error>> {
        let Some(short) = self.count(reader, &unit.program(count))? else {
            return Ok(None);
        };
        let Some(long) = self.count(reader, &unit.program(4 * count))? else {
            return Ok(None);
        };
        let ratio = long as f64 / short as f64;
        let name = unit.name();
        println!(
            "{ratio:.2}\t{count}\t{short}\t{long}\t{} of {name}",
            reader.0
        );
        Ok(Some(ratio))
    }
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let mut arguments = env::args().skip(1);
    let prefix = arguments.next().ok_or("the prefix of callgrind's files")?;
    let selection = arguments.next().unwrap_or_default();
    let mut dumps = Dumps { prefix, calls: 0 };
    // What is set up once does not belong to the first pair.
    for reader in ALL {
        dumps.count(reader, "3.1\nT\nEND\n")?;
    }
    let (mut pairs, mut excesses) = (0, 0);
    println!("ratio\tn\tat n\tat 4 n\treader and form");
    for (unit, reader) in [forms(), pieces(), long_programs()].concat() {
        if !format!("{} of {}", reader.0, unit.name()).contains(&selection) {
            continue;
        }
        let Some(ratio) = dumps.ratio(&unit, reader, unit.count)? else {
            continue;
        };
        pairs += 1;
        // Work that has a bound, such as the trial of fixes, grows faster until it reaches the bound: a square stays.
        if ratio > LIMIT {
            let larger = dumps.ratio(&unit, reader, 4 * unit.count)?;
            excesses += usize::from(larger.is_some_and(|it| it > LIMIT));
        }
    }
    println!("{pairs} pairs, {excesses} exceed {LIMIT}");
    Ok(match (pairs, excesses) {
        (1.., 0) => ExitCode::SUCCESS,
        _ => ExitCode::FAILURE,
    })
}
