//! `tip drives scan` and `tip drives id`: the servos that answer on a port, without a robot.

use super::port::open_serial;
use crate::choices::{self, LangName};
use crate::error::Error;
use crate::message::Driving;
use crate::{Status, input, interrupt, output, report};
use clap::Args;
use std::fmt::Write as _;
use tip_drives::bus::{Bus, BusError, Timing, Wire};
use tip_drives::family::{Family, Query, Reading};
use tip_drives::model::{self, FAMILIES, Model};
use tip_drives::port::AnyPort;
use tip_runtime::model::Range;
use tipc::message::Lang;

/// A port without a robot.
#[derive(Debug, Args)]
struct PortArguments {
    /// The serial port
    #[arg(long, value_name = "PORT")]
    port: String,

    /// The speed of the bus, bit/s
    #[arg(long, default_value_t = 1_000_000, value_parser = clap::value_parser!(u32).range(9600..=4_500_000))]
    baud: u32,

    /// The delay of adapter and driver, ms
    #[arg(long, value_name = "MS", default_value_t = 4, value_parser = clap::value_parser!(u32).range(1..=1000))]
    latency: u32,

    /// The language of messages; else the locale's
    #[arg(long, value_enum, value_name = "en|ja")]
    lang: Option<LangName>,
}

impl PortArguments {
    fn lang(&self) -> Lang {
        choices::lang(self.lang)
    }

    fn bus(&self) -> Result<Bus<AnyPort>, Error> {
        let port = open_serial(&self.port, self.baud, self.lang())?;
        let timing = Timing {
            baud: self.baud,
            return_delay: 500,
            latency: self.latency * 1000,
        };
        Ok(Bus::new(port, timing))
    }
}

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip drives scan --port /dev/ttyUSB0                 all families, at 1 Mbaud
  tip drives scan --port /dev/ttyUSB0 --family x --baud 57600

Exit status: 0 if a servo answers, 1 otherwise.")]
pub(crate) struct Scan {
    #[command(flatten)]
    port: PortArguments,

    /// The family: ax, x, sts, lx or moteus; else all
    #[arg(long, value_parser = family)]
    family: Option<&'static dyn Family>,

    /// The largest identity that is tried
    #[arg(long, default_value_t = 252, value_parser = clap::value_parser!(u8).range(0..=252))]
    to: u8,
}

#[derive(Debug, Args)]
#[command(after_long_help = "Example:
  tip drives id 1 12 --family sts --port /dev/ttyACM0   new servos have the identity 1: name one at a time

Exit status: 0 if the servo answers with its new identity, 1 otherwise.")]
pub(crate) struct Id {
    /// The identity that the servo has
    #[arg(value_parser = clap::value_parser!(u8).range(0..=252))]
    from: u8,

    /// Its new one
    #[arg(value_parser = clap::value_parser!(u8).range(0..=252))]
    to: u8,

    /// The family of the servo: ax, x, sts, lx or moteus
    #[arg(long, value_parser = family)]
    family: &'static dyn Family,

    #[command(flatten)]
    port: PortArguments,
}

/// Reads the name of a family.
fn family(name: &str) -> Result<&'static dyn Family, String> {
    model::family_named(name).ok_or_else(|| {
        let known: Vec<&str> = FAMILIES.iter().map(|family| family.key()).collect();
        format!("one of {}", known.join(", "))
    })
}

/// The supply voltage, V, and the temperature, °C, that a servo can have.
const VOLTAGE: Range = Range::new(3.0, 60.0);
const TEMPERATURE: Range = Range::new(1.0, 100.0);

/// The servo that answers to requests of a family.
enum Found {
    /// A model of the family.
    Known(&'static Model),
    /// A model of another family, which understands some requests of this one.
    Other(&'static Model),
    /// A model that nobody has described yet, whose values make sense; the number that it reports.
    New(Option<u16>),
    /// It answers with values that no servo of the family can have.
    Doubtful(Option<u16>),
}

impl Found {
    /// Judges a servo by the number that it reports as a member of a family, and by its values.
    fn of(
        family: &'static dyn Family,
        bus: &mut Bus<AnyPort>,
        id: u8,
        number: Option<u16>,
        reading: Option<&Reading>,
    ) -> Self {
        let model = |family, number: Option<u16>| Model::numbered(family, number?);
        if let Some(model) = model(family, number) {
            return Found::Known(model);
        }
        // Those that report no number have frames of their own, which nobody else answers.
        if number.is_some() {
            for other in FAMILIES.into_iter().filter(|other| *other != family) {
                let wire: &mut dyn Wire = bus;
                let own = wire.repeat(|wire| other.identify(wire, id)).ok().flatten();
                if let Some(model) = model(other, own) {
                    return Found::Other(model);
                }
            }
        }
        let is_real = |reading: &Reading| {
            let voltage = reading.voltage.is_none_or(|it| VOLTAGE.contains(it));
            voltage
                && reading
                    .temperature
                    .is_none_or(|it| TEMPERATURE.contains(it))
        };
        match reading.is_some_and(is_real) {
            true => Found::New(number),
            false => Found::Doubtful(number),
        }
    }

    /// Returns the name in a table.
    fn name(&self) -> String {
        let numbered = |number: &Option<u16>| match number {
            Some(number) => format!("#{number}"),
            None => "?".to_owned(),
        };
        match self {
            Found::Known(model) => model.name.to_owned(),
            Found::Other(model) => format!("{}?", model.name),
            Found::New(number) => numbered(number),
            Found::Doubtful(number) => format!("{}?", numbered(number)),
        }
    }

    /// Returns a remark about a servo that is not a known one.
    fn remark(&self, id: u8, family: &'static dyn Family) -> Option<Driving> {
        let (id, family) = (id.into(), family.name());
        match self {
            Found::Known(_) | Found::New(None) => None,
            Found::New(Some(number)) => Some(Driving::NewModel {
                id,
                number: (*number).into(),
            }),
            Found::Other(model) => Some(Driving::OtherFamily {
                id,
                model: model.name,
                key: model.family.key(),
            }),
            Found::Doubtful(_) => Some(Driving::Doubtful { id, family }),
        }
    }
}

pub(super) fn scan(arguments: &Scan) -> Result<Status, Error> {
    interrupt::catch();
    let lang = arguments.port.lang();
    let families = arguments
        .family
        .as_ref()
        .map_or(&FAMILIES[..], std::slice::from_ref);
    let (mut text, mut count, mut remarks) = (String::new(), 0, Vec::new());
    for family in families.iter().copied() {
        let mut bus = arguments.port.bus()?;
        bus.set_tries(2);
        let last = arguments.to.min(family.last_id());
        let scans = Driving::Scans {
            family: family.name(),
            last: last.into(),
        };
        report::say(scans, lang);
        for id in 0..=last {
            if interrupt::is_requested() {
                break;
            }
            let wire: &mut dyn Wire = &mut bus;
            let number = match twice(wire, |wire| wire.repeat(|wire| family.identify(wire, id))) {
                Ok(number) => number,
                Err(BusError::NoAnswer) => continue,
                Err(error) => return Err(Error::Failed(error.to_string())),
            };
            let reading = values(family, &mut bus, id);
            let found = Found::of(family, &mut bus, id, number, reading.as_ref());
            // It has a line of its own where its family is asked for.
            if matches!(found, Found::Other(_)) && arguments.family.is_none() {
                continue;
            }
            let shown = |value: Option<String>| value.unwrap_or_else(|| "?".to_owned());
            let delay = twice(&mut bus, |wire| family.return_delay(wire, id)).ok();
            let volts = reading.and_then(|it| it.voltage);
            let celsius = reading.and_then(|it| it.temperature);
            // Writing to a String cannot fail.
            let _ = writeln!(
                text,
                "{id:3}  {:13}  {:>6}  {:>4.4} V  {:>3} °C  {:>3} µs  {}",
                found.name(),
                shown(reading.map(|it| it.position.to_string())),
                shown(volts.map(|it| it.to_string())),
                shown(celsius.map(|it| it.to_string())),
                shown(delay.map(|it| it.to_string())),
                family.name()
            );
            remarks.extend(found.remark(id, family));
            count += 1;
        }
    }
    let is_interrupted = interrupt::is_requested();
    if count == 0 && !is_interrupted {
        let reason = match arguments.family {
            Some(family) => Driving::NoneOfFamily {
                family: family.name(),
                others: keys_besides(family),
            },
            None => Driving::NothingFound,
        };
        return Err(Error::failed(reason, lang));
    }
    text.insert_str(
        0,
        " id  model          counts  supply    temp   delay  family\n",
    );
    let found = Driving::Found { servos: count };
    let _ = writeln!(text, "{}", found.in_lang(lang));
    output::print(text)?;
    super::realtime::warn(remarks, lang);
    Ok(match is_interrupted {
        true => Status::Interrupted,
        false => Status::Success,
    })
}

/// Number of times that a servo is asked for two equal answers in a row.
const READINGS: u32 = 8;

/// Asks until two answers in a row are equal: a checksum of 8 bits lets some damaged ones pass, and what is read here leads people to
/// write registers. The last answer counts if no two are equal.
fn twice<T: PartialEq>(
    wire: &mut dyn Wire,
    ask: impl Fn(&mut dyn Wire) -> Result<T, BusError>,
) -> Result<T, BusError> {
    let mut answer = ask(wire)?;
    for _ in 1..READINGS {
        // A servo that is silent now has answered before.
        let Ok(again) = ask(wire) else { continue };
        let is_equal = again == answer;
        answer = again;
        if is_equal {
            break;
        }
    }
    Ok(answer)
}

/// Reads what a servo measures; a few times, because some do not tell everything in one answer.
fn values(family: &dyn Family, bus: &mut Bus<AnyPort>, id: u8) -> Option<Reading> {
    let mut found: Option<Reading> = None;
    for turn in 0..3 {
        let query = Query {
            id,
            turn,
            is_late: false,
        };
        // A servo that is silent now has answered before.
        let _ = family.read(bus, &[query], u64::MAX, false, &mut |_, reading| {
            let old = found.unwrap_or(reading);
            found = Some(Reading {
                voltage: reading.voltage.or(old.voltage),
                temperature: reading.temperature.or(old.temperature),
                ..reading
            });
        });
    }
    found
}

/// Returns the other family as whose member a servo answers, at the speed of this bus; the one that has its model, if several do.
fn family_that_answers(
    bus: &mut Bus<AnyPort>,
    asked: &'static dyn Family,
    id: u8,
) -> Option<&'static dyn Family> {
    let wire: &mut dyn Wire = bus;
    let mut heard = Vec::new();
    for other in FAMILIES.into_iter().filter(|other| *other != asked) {
        if id <= other.last_id()
            && let Ok(number) = wire.repeat(|wire| other.identify(wire, id))
        {
            heard.push((other, number));
        }
    }
    let is_known = |(family, number): &&(&'static dyn Family, Option<u16>)| {
        number.is_some_and(|number| Model::numbered(*family, number).is_some())
    };
    let best = heard.iter().find(is_known).or(heard.first());
    best.map(|(family, _)| *family)
}

/// Returns the names of the other families on the command line.
fn keys_besides(asked: &'static dyn Family) -> String {
    let others = FAMILIES.into_iter().filter(|other| *other != asked);
    others.map(Family::key).collect::<Vec<_>>().join(", ")
}

pub(super) fn id(arguments: &Id) -> Result<Status, Error> {
    interrupt::catch();
    let (lang, family) = (arguments.port.lang(), arguments.family);
    let (from, to) = (arguments.from, arguments.to);
    let mut bus = arguments.port.bus()?;
    let failed = |error: BusError| Error::Failed(error.to_string());
    let wire: &mut dyn Wire = &mut bus;
    let identify = |wire: &mut dyn Wire| wire.repeat(|wire| family.identify(wire, from));
    let number = match twice(wire, identify) {
        Err(BusError::NoAnswer) => {
            let heard = family_that_answers(&mut bus, family, from);
            let (id, name) = (from.into(), family.name());
            let reason = match heard {
                Some(other) => Driving::AnswersOtherwise {
                    id,
                    family: name,
                    other: other.name(),
                    key: other.key(),
                },
                None => Driving::NoServo {
                    id,
                    family: name,
                    others: keys_besides(family),
                },
            };
            return Err(Error::failed(reason, lang));
        }
        number => number.map_err(failed)?,
    };
    if from != to {
        match wire.repeat(|wire| family.identify(wire, to)) {
            Err(BusError::NoAnswer) => {}
            Err(error) => return Err(failed(error)),
            Ok(_) => return Err(Error::failed(Driving::IdTaken { id: to.into() }, lang)),
        }
    }
    // Nothing is written to a servo of another family: its registers mean something else.
    let reading = values(family, &mut bus, from);
    let found = Found::of(family, &mut bus, from, number, reading.as_ref());
    let remark = found.remark(from, family);
    match (found, remark) {
        (Found::Other(_) | Found::Doubtful(_), Some(remark)) => {
            return Err(Error::failed(remark, lang));
        }
        (_, remark) => super::realtime::warn(remark, lang),
    }
    // A servo that gets a number loses its torque.
    if family.is_stiff(&mut bus, from) == Ok(true) {
        let id = from.into();
        input::forget_typed();
        report::say(Driving::IdReleases { id }, lang);
        if !input::is_confirmed()? {
            return match interrupt::is_requested() {
                true => Ok(Status::Interrupted),
                false => Err(Error::failed(Driving::IdKept { id }, lang)),
            };
        }
    }
    family.set_id(&mut bus, from, to).map_err(|error| {
        let (id, to) = (from.into(), to.into());
        match error {
            BusError::Unsupported => Error::failed(Driving::OwnTool { id, to }, lang),
            error => failed(error),
        }
    })?;
    let renamed = Driving::Renamed {
        id: from.into(),
        to: to.into(),
    };
    output::say(renamed, lang)?;
    Ok(Status::Success)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::RefCell;
    use tip_drives::simulated::{MemoryPort, SimulatedBus};

    /// An answer counts when it comes twice in a row; silence between them does not part them.
    #[test]
    fn an_answer_counts_when_it_is_repeated() {
        let timing = Timing {
            baud: 1_000_000,
            return_delay: 0,
            latency: 0,
        };
        let mut bus = Bus::new(
            MemoryPort::new(SimulatedBus::new(Vec::new(), timing)),
            timing,
        );
        for (answers, answer, left) in [
            (&[Some(500), Some(0), Some(0), Some(9)][..], Ok(0), 1),
            (&[Some(7), None, Some(7), Some(9)], Ok(7), 1),
            (&[None, Some(7), Some(7)], Err(BusError::NoAnswer), 2),
            (&[Some(1), Some(2)], Ok(2), 0),
        ] {
            let answers = RefCell::new(answers.iter());
            let ask = |_: &mut dyn Wire| {
                let next = answers.borrow_mut().next().copied().flatten();
                next.ok_or(BusError::NoAnswer)
            };
            assert_eq!(twice(&mut bus, ask), answer);
            assert_eq!(answers.borrow().len(), left, "{answer:?}");
        }
    }
}
