//! Time on this machine: waiting for a deadline, priority, and a histogram of how late cycles start; `tip jitter`.

use crate::choices::LangName;
use crate::commands::Action;
use crate::error::Error;
use crate::message::{Driving, Using, Weight};
use crate::{Status, choices, interrupt, output, report};
use clap::Args;
use std::fmt::Write as _;
use std::time::{Duration, Instant};
use tip_runtime::realtime::Pacer;
use tipc::message::Lang;

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
fn sleep(time: Duration) {
    use nix::sys::time::TimeSpec;
    use nix::time::{ClockId, ClockNanosleepFlags, clock_gettime, clock_nanosleep};
    let clock = ClockId::CLOCK_MONOTONIC;
    let Ok(now) = clock_gettime(clock) else {
        return std::thread::sleep(time);
    };
    let due = now + TimeSpec::from_duration(time);
    // After an interrupt the caller looks at the time again.
    let _ = clock_nanosleep(clock, ClockNanosleepFlags::TIMER_ABSTIME, &due);
}

#[cfg(not(target_os = "linux"))]
fn sleep(time: Duration) {
    std::thread::sleep(time);
}

/// Priority of the control loop among real-time threads, 1 to 99.
const PRIORITY: u8 = 50;

/// Gives this thread real-time priority and keeps its memory in place; returns messages about what was not possible.
pub(crate) fn prioritise() -> Vec<Driving> {
    let mut refused = Vec::new();
    #[cfg(unix)]
    {
        use thread_priority::{
            RealtimeThreadSchedulePolicy, ThreadPriority, ThreadSchedulePolicy,
            set_thread_priority_and_policy, thread_native_id,
        };
        let policy = ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::Fifo);
        let priority = PRIORITY
            .try_into()
            .map_or(ThreadPriority::Max, ThreadPriority::Crossplatform);
        if let Err(error) = set_thread_priority_and_policy(thread_native_id(), priority, policy) {
            let error = match error {
                thread_priority::Error::OS(code) => {
                    std::io::Error::from_raw_os_error(code).to_string()
                }
                other => format!("{other:?}"),
            };
            refused.push(Driving::NoFifo {
                error: error.into(),
            });
        }
        let all = nix::sys::mman::MlockAllFlags::all();
        if let Err(error) = nix::sys::mman::mlockall(all) {
            let error = error.desc().to_owned().into();
            refused.push(Driving::NoLock { error });
        }
    }
    refused
}

/// The longest lateness that is counted by itself, µs.
const LONGEST: usize = 20_000;

/// Number of cycles that started so many µs late.
#[derive(Debug)]
pub(crate) struct Histogram {
    counts: Vec<u64>,
    worst: Duration,
}

impl Default for Histogram {
    fn default() -> Self {
        Histogram {
            counts: vec![0; LONGEST + 1],
            worst: Duration::ZERO,
        }
    }
}

impl Histogram {
    pub(crate) fn add(&mut self, late: Duration) {
        let place = usize::try_from(late.as_micros()).unwrap_or(LONGEST);
        self.counts[place.min(LONGEST)] += 1;
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
        self.counts.iter().position(within).unwrap_or(LONGEST)
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
        for to in [10, 20, 50, 100, 200, 500, 1000, 2000, 5000, LONGEST + 1] {
            let count: u64 = self.counts[from..to].iter().sum();
            if count > 0 {
                let share = count as f64 / total as f64;
                let bar = "#".repeat((share * 50.0).ceil() as usize);
                // Writing to a String cannot fail.
                let _ = writeln!(text, "{from:6} µs {:8.3} % {count:8}  {bar}", share * 100.0);
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
        warn(&prioritise(), choices::lang(arguments.lang));
    }
    let (mut pacer, mut histogram) = (Pacer::start(), Histogram::default());
    let cycles = (arguments.seconds * 1000.0 / arguments.period).ceil() as u64;
    while pacer.cycles() < cycles && !interrupt::is_requested() {
        let due = pacer.due(arguments.period);
        histogram.add(wait_until(due));
    }
    let mut text = histogram.table();
    let [p50, p99, p999] = [0.5, 0.99, 0.999].map(|part| histogram.quantile(part));
    let (worst, overruns) = (histogram.worst(), pacer.overruns());
    // Writing to a String cannot fail.
    let _ = writeln!(
        text,
        "p50 {p50} µs, p99 {p99} µs, p99.9 {p999} µs, max {worst} µs; {overruns} overruns / {cycles}"
    );
    output::print(text)?;
    Ok(Status::Success)
}

/// Reports messages as warnings.
pub(crate) fn warn(messages: &[Driving], lang: Lang) {
    for message in messages {
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
        assert_eq!(histogram.quantile(1.0), LONGEST);
        assert_eq!(histogram.worst(), 3_000_000);
    }
}
