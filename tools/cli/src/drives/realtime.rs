//! Time on this machine: waiting for a deadline, priority, and a histogram of how late cycles start; `tip jitter`.

use crate::Action;
use crate::choices::LangName;
use crate::error::Error;
use crate::message::{Driving, Using, Weight};
use crate::{Status, choices, interrupt, output, report};
use clap::Args;
use std::fmt::Write as _;
use std::io;
use std::time::{Duration, Instant};
use tip_runtime::realtime::Pacer;
use tipc::message::{Lang, Message};

/// The longest sleep in one piece: an interrupt is noticed after it.
const NAP: Duration = Duration::from_millis(50);

/// Waits until a deadline, or an interrupt; returns how late it was noticed.
pub(crate) fn wait_until(due: Instant) -> Duration {
    loop {
        let now = Instant::now();
        let left = due.saturating_duration_since(now);
        if left.is_zero() || interrupt::is_requested() {
            return now.saturating_duration_since(due);
        }
        sleep(left.min(NAP));
    }
}

/// Sleeps until a time of the system's clock: a signal or a delay before the call does not make it longer.
#[cfg(target_os = "linux")]
pub(super) fn sleep(time: Duration) {
    use rustix::thread::{ClockId, clock_nanosleep_absolute};
    use rustix::time::{Timespec, clock_gettime};
    let clock = ClockId::Monotonic;
    let due = Timespec::try_from(time).ok();
    let due = due.and_then(|time| clock_gettime(clock).checked_add(time));
    match due {
        // After an interrupt the caller looks at the time again.
        Some(due) => drop(clock_nanosleep_absolute(clock, &due)),
        None => std::thread::sleep(time),
    }
}

#[cfg(not(target_os = "linux"))]
pub(super) fn sleep(time: Duration) {
    std::thread::sleep(time);
}

/// Priority of the control loop among real-time threads, 1 to 99.
#[cfg(unix)]
const PRIORITY: u8 = 50;

/// Gives this thread real-time priority and keeps its memory in place; returns messages about what was not possible.
pub(crate) fn prioritise() -> Vec<Driving> {
    let priority = set_priority().err().map(|error| Driving::NoFifo {
        error: error.to_string().into(),
    });
    let memory = lock_memory().err().map(|error| Driving::NoLock {
        error: error.to_string().into(),
    });
    priority.into_iter().chain(memory).collect()
}

#[cfg(unix)]
fn set_priority() -> io::Result<()> {
    use thread_priority::{
        Error, RealtimeThreadSchedulePolicy, ThreadPriority, ThreadSchedulePolicy,
        set_thread_priority_and_policy, thread_native_id,
    };
    let policy = ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::Fifo);
    let priority = PRIORITY
        .try_into()
        .map_or(ThreadPriority::Max, ThreadPriority::Crossplatform);
    let set = set_thread_priority_and_policy(thread_native_id(), priority, policy);
    set.map_err(|error| match error {
        Error::OS(code) => io::Error::from_raw_os_error(code),
        other => io::Error::other(format!("{other:?}")),
    })
}

#[cfg(not(unix))]
fn set_priority() -> io::Result<()> {
    Err(io::ErrorKind::Unsupported.into())
}

#[cfg(target_os = "linux")]
fn lock_memory() -> io::Result<()> {
    use rustix::mm::{MlockAllFlags, mlockall};
    Ok(mlockall(MlockAllFlags::CURRENT | MlockAllFlags::FUTURE)?)
}

#[cfg(not(target_os = "linux"))]
fn lock_memory() -> io::Result<()> {
    Err(io::ErrorKind::Unsupported.into())
}

/// The longest lateness that is counted by itself, µs.
const MAX_LATENESS: usize = 20_000;

/// Number of cycles that started so many µs late.
#[derive(Debug)]
pub(crate) struct Histogram {
    counts: Vec<u64>,
    worst: Duration,
}

impl Default for Histogram {
    fn default() -> Self {
        Histogram {
            counts: vec![0; MAX_LATENESS + 1],
            worst: Duration::ZERO,
        }
    }
}

impl Histogram {
    pub(crate) fn add(&mut self, late: Duration) {
        let place = usize::try_from(late.as_micros()).unwrap_or(MAX_LATENESS);
        self.counts[place.min(MAX_LATENESS)] += 1;
        self.worst = self.worst.max(late);
    }

    fn total(&self) -> u64 {
        self.counts.iter().sum()
    }

    /// Returns the lateness that a part of the cycles does not exceed, µs.
    pub(crate) fn quantile(&self, part: f64) -> usize {
        let wanted = (self.total() as f64 * part).ceil() as u64;
        let mut sum = 0;
        let within = |count: &u64| {
            sum += count;
            sum >= wanted
        };
        self.counts.iter().position(within).unwrap_or(MAX_LATENESS)
    }

    /// Returns the greatest lateness, µs.
    pub(crate) fn worst(&self) -> u128 {
        self.worst.as_micros()
    }

    /// Returns the share of cycles in each range, with bars.
    fn table(&self) -> String {
        let mut text = String::new();
        let total = self.total().max(1);
        let mut from = 0;
        for to in [
            10,
            20,
            50,
            100,
            200,
            500,
            1000,
            2000,
            5000,
            MAX_LATENESS + 1,
        ] {
            let count: u64 = self.counts[from..to].iter().sum();
            if count > 0 {
                let share = count as f64 / total as f64;
                let bar = "#".repeat((share * 50.0).ceil() as usize);
                // Writing to a String cannot fail.
                let _ = writeln!(text, "{from:6} µs {:6.3} % {count:8}  {bar}", share * 100.0);
            }
            from = to;
        }
        text
    }
}

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip jitter                        how late cycles of 20 ms start on this machine, for 5 s
  tip jitter --period 10 --fifo     with SCHED_FIFO and locked memory, as 'tip run --hardware --fifo' has them

Exit status: 0, also without the rights for --fifo: a warning says so.")]
pub(crate) struct Jitter {
    /// The sampling time, ms
    #[arg(long, value_name = "MS", default_value_t = 20.0, value_parser = positive)]
    period: f64,

    /// The length of the measurement, s
    #[arg(long, value_name = "S", default_value_t = 5.0, value_parser = positive)]
    seconds: f64,

    /// Use SCHED_FIFO and lock the memory
    #[arg(long)]
    fifo: bool,

    /// The language of messages; else the locale's
    #[arg(long, value_enum, value_name = "en|ja")]
    lang: Option<LangName>,
}

fn positive(text: &str) -> Result<f64, Using> {
    let number = text.parse().ok();
    let number = number.filter(|it: &f64| (0.1..=86_400_000.0).contains(it));
    number.ok_or_else(|| Using::NotAPeriod {
        text: text.to_owned(),
    })
}

impl Action for Jitter {
    fn execute(&self) -> Result<Status, Error> {
        jitter(self)
    }
}

/// Measures how late cycles start.
fn jitter(arguments: &Jitter) -> Result<Status, Error> {
    interrupt::catch();
    if arguments.fifo {
        warn(prioritise(), choices::lang(arguments.lang));
    }
    let (mut pacer, mut histogram) = (Pacer::start(), Histogram::default());
    let cycles = (arguments.seconds * 1000.0 / arguments.period).ceil() as u64;
    while pacer.cycles() < cycles {
        let due = pacer.due(arguments.period);
        let late = wait_until(due);
        // The cycle that Ctrl-C ends has not started.
        if interrupt::is_requested() {
            break;
        }
        histogram.add(late);
    }
    let lang = choices::lang(arguments.lang);
    output::print(report_text(
        &histogram,
        pacer.overruns(),
        arguments.period,
        lang,
    ))?;
    Ok(Status::Success)
}

/// Largest part of a period by which a cycle may start late without servos moving unevenly.
const EVEN: f64 = 0.1;

/// Returns the table of a measurement, its figures, and the verdict on the period, ms.
fn report_text(histogram: &Histogram, missed: u64, period: f64, lang: Lang) -> String {
    let cycles = histogram.total();
    if cycles == 0 {
        return format!("{}\n", Driving::NoCycles.in_lang(lang));
    }
    let [p50, p99, p999] = [0.5, 0.99, 0.999].map(|part| histogram.quantile(part));
    let figures = Driving::JitterFigures {
        p50,
        p99,
        p999,
        worst: histogram.worst().to_string(),
        missed: missed.to_string(),
        cycles: cycles.to_string(),
    };
    let part = histogram.worst.as_secs_f64() * 1000.0 / period;
    let (share, name) = (format!("{:.1}", part * 100.0), period.to_string());
    let verdict = match (missed, part <= EVEN) {
        (0, true) => Driving::KeepsPeriod {
            period: name,
            share,
        },
        (0, false) => Driving::KeepsPeriodUnevenly {
            period: name,
            share,
        },
        _ => Driving::MissesPeriod {
            period: name,
            missed: missed.to_string(),
            cycles: cycles.to_string(),
        },
    };
    let columns = [
        (Driving::LateFrom, 9),
        (Driving::CycleShare, 9),
        (Driving::CycleCount, 9),
    ];
    let columns: String = columns
        .into_iter()
        .map(|(name, columns)| {
            let name = name.in_lang(lang).to_string();
            " ".repeat(columns - output::width(&name)) + &name
        })
        .collect();
    let (table, figures, verdict) = (
        histogram.table(),
        figures.in_lang(lang),
        verdict.in_lang(lang),
    );
    format!("{columns}\n{table}{figures}\n{verdict}\n")
}

/// Reports messages as warnings.
pub(crate) fn warn(messages: impl IntoIterator<Item = impl Into<Message>>, lang: Lang) {
    for message in messages {
        let message: Message = message.into();
        let warning = Weight::Warning;
        let text = format!("{}: {}\n", warning.in_lang(lang), message.in_lang(lang));
        report::complain(&text);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_the_cycles() {
        let mut histogram = Histogram::default();
        for late in 0..1000 {
            histogram.add(Duration::from_micros(late));
        }
        histogram.add(Duration::from_secs(3));
        assert_eq!(histogram.quantile(0.5), 500);
        assert_eq!(histogram.quantile(0.99), 990);
        assert_eq!(histogram.quantile(1.0), MAX_LATENESS);
        assert_eq!(histogram.worst(), 3_000_000);
    }

    /// The text counts the cycles that were measured, whatever number was asked for, and ends with a verdict.
    #[test]
    fn a_measurement_has_columns_and_a_verdict() {
        let text = |late: &[u64], missed| {
            let mut histogram = Histogram::default();
            for late in late {
                histogram.add(Duration::from_micros(*late));
            }
            report_text(&histogram, missed, 20.0, Lang::English)
        };
        let kept = text(&[5, 5, 5, 500], 0);
        let lines: Vec<&str> = kept.lines().collect();
        assert_eq!(
            lines[0].split_whitespace().collect::<Vec<_>>(),
            ["late", "share", "cycles"]
        );
        assert!(lines[1].contains(" 75.000 % "), "{kept}");
        assert!(lines[3].ends_with("all 500 µs; 0 of 4 missed"), "{kept}");
        assert_eq!(
            lines[4],
            "a period of 20 ms is kept: cycles start late by 2.5 % of it at most"
        );
        assert!(text(&[5, 5000], 0).contains("is kept unevenly: a cycle starts late by 25.0 %"));
        assert!(text(&[5, 50_000], 1).contains("is not kept: 1 of 2 cycles are missed"));
        assert_eq!(text(&[], 0), "no cycle was measured\n");
    }
}
