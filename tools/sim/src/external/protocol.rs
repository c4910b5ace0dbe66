//! What an external plant answers.

use super::line::{
    ANGLES, LOADS, Layout, NUMBER, POSE, PROTOCOL, READY, SLIDER, STATE, TORQUES, VERSION,
};
use super::trouble::{Head, Trouble};
use tip_runtime::command::Target;
use tip_runtime::plant::Pose;

/// What a process measures of its robot. Lists that it does not measure are empty.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Measured {
    /// deg.
    pub(super) angles: Vec<f64>,
    /// N·m.
    pub(super) torques: Vec<f64>,
    /// N.
    pub(super) loads: Vec<f64>,
    /// mm.
    pub(super) slider: [f64; 3],
    /// Whether it says where the body is.
    has_pose: bool,
}

/// An answer that is right.
pub(super) struct Answer {
    pub(super) measured: Measured,
    pub(super) pose: Option<Pose>,
}

/// Reads the answer to a line. What the first one measures all others have to measure.
pub(super) fn read(
    line: &str,
    to: Head,
    layout: &Layout,
    before: &Measured,
) -> Result<Answer, Trouble> {
    let begins = match to {
        Head::Hello => READY,
        Head::Cycle(_) => STATE,
    };
    let mut words = line.split_ascii_whitespace();
    if words.next() != Some(begins) {
        let line = line.to_owned();
        return Err(Trouble::Garbage { to, line, begins });
    }
    let mut fields = Fields::default();
    for word in words {
        fields.add(word, to)?;
    }
    match to {
        Head::Hello => version(fields.of(PROTOCOL, to)?)?,
        Head::Cycle(number) => cycle(fields.of(NUMBER, to)?, number, to)?,
    }
    let numbers = Numbers {
        fields: &fields,
        to,
        layout,
    };
    let joints = layout.legs * layout.joints;
    let is_first = to == Head::Hello;
    let torques = layout.has_torques || !is_first && !before.torques.is_empty();
    let loads = !is_first && !before.loads.is_empty();
    let pose = !is_first && before.has_pose;
    let slider = numbers.of(
        SLIDER,
        if layout.has_slider { 3 } else { 0 },
        layout.has_slider,
    )?;
    let pose = numbers.of(POSE, 6, pose)?;
    let pose = <[f64; 6]>::try_from(pose)
        .ok()
        .map(|[x, y, z, roll, pitch, yaw]| Pose {
            position: [x, y, z],
            roll,
            pitch,
            yaw,
        });
    let measured = Measured {
        angles: numbers.of(ANGLES, joints, true)?,
        torques: numbers.of(TORQUES, joints, torques)?,
        loads: numbers.of(LOADS, layout.soles, loads)?,
        slider: slider.try_into().unwrap_or_default(),
        has_pose: pose.is_some(),
    };
    Ok(Answer { measured, pose })
}

fn version(found: &str) -> Result<(), Trouble> {
    match found.parse::<u32>() {
        Ok(VERSION) => Ok(()),
        _ => Err(Trouble::Version {
            found: found.to_owned(),
        }),
    }
}

fn cycle(found: &str, number: u64, to: Head) -> Result<(), Trouble> {
    match found.parse::<u64>() {
        Ok(found) if number == found => Ok(()),
        _ => Err(Trouble::Cycle {
            to,
            found: found.to_owned(),
        }),
    }
}

/// The words of an answer by their keys.
#[derive(Default)]
struct Fields<'a>(Vec<(&'static str, &'a str)>);

impl<'a> Fields<'a> {
    fn add(&mut self, word: &'a str, to: Head) -> Result<(), Trouble> {
        let unknown = || Trouble::Word {
            to,
            word: word.to_owned(),
        };
        let (key, values) = word.split_once('=').ok_or_else(unknown)?;
        let own = match to {
            Head::Hello => PROTOCOL,
            Head::Cycle(_) => NUMBER,
        };
        let mut keys = [own, ANGLES, TORQUES, LOADS, SLIDER, POSE].into_iter();
        let key = keys.find(|known| *known == key).ok_or_else(unknown)?;
        if self.get(key).is_some() {
            return Err(Trouble::Twice { to, key });
        }
        self.0.push((key, values));
        Ok(())
    }

    fn get(&self, key: &str) -> Option<&'a str> {
        let found = self.0.iter().find(|(known, _)| *known == key);
        found.map(|(_, values)| *values)
    }

    fn of(&self, key: &'static str, to: Head) -> Result<&'a str, Trouble> {
        self.get(key).ok_or(Trouble::Missing { to, key })
    }
}

/// The numbers of an answer.
struct Numbers<'a> {
    fields: &'a Fields<'a>,
    to: Head,
    layout: &'a Layout,
}

impl Numbers<'_> {
    /// So many finite numbers; none if the key is not there and not needed.
    fn of(&self, key: &'static str, wanted: usize, is_needed: bool) -> Result<Vec<f64>, Trouble> {
        let to = self.to;
        let Some(values) = self.fields.get(key) else {
            return if is_needed {
                Err(Trouble::Missing { to, key })
            } else {
                Ok(Vec::new())
            };
        };
        let words: Vec<&str> = values.split(',').filter(|_| !values.is_empty()).collect();
        if words.len() != wanted {
            let found = words.len();
            return Err(Trouble::Count {
                to,
                key,
                wanted,
                found,
            });
        }
        let numbers = words.iter().enumerate().map(|(index, word)| {
            let place = || place(self.layout, key, index);
            let word = (*word).to_owned();
            match word.parse::<f64>() {
                Ok(number) if number.is_finite() => Ok(number),
                Ok(_) => Err(Trouble::NotFinite {
                    to,
                    key,
                    place: place(),
                }),
                Err(_) => Err(Trouble::NotNumber {
                    to,
                    key,
                    place: place(),
                    word,
                }),
            }
        });
        numbers.collect()
    }
}

/// What a number of a list is about.
fn place(layout: &Layout, key: &str, index: usize) -> String {
    let at = |names: &[&str]| names.get(index).copied().unwrap_or_default().to_owned();
    let joints = layout.joints.max(1);
    let number = |number: usize| u8::try_from(number + 1).unwrap_or(u8::MAX);
    match key {
        SLIDER => at(&["x", "y", "z"]),
        POSE => at(&["x", "y", "z", "roll", "pitch", "yaw"]),
        LOADS => Target::Foot(number(index)).to_string(),
        _ => Target::Joint(number(index / joints), number(index % joints)).to_string(),
    }
}
