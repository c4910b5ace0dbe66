//! A simulated robot and a desk where things go wrong.

use crate::defect::{Defect, Reading};
use crate::place::Place;
use crate::script::INPUTS_READ;
use core::fmt::Display;
use std::collections::VecDeque;
use tip_runtime::console::Console;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, HardwareFault, JointCommand, Outputs, Sensors};
use tip_runtime::machine::Report;
use tip_runtime::model::Model;
use tip_runtime::record::{Sample, TitanLog};

/// Angles that differ by less than this come from rounding: deg.
const ROUNDING: f64 = 1e-6;

#[derive(Clone)]
pub(crate) struct Faulty<H, const L: usize, const J: usize> {
    pub(crate) plant: H,
    pub(crate) model: &'static Model<L, J>,
    pub(crate) defect: Option<Defect>,
    pub(crate) last: Sensors<L, J>,
    /// Writes so far.
    pub(crate) writes: u32,
    /// Stops so far.
    pub(crate) stops: u32,
}

impl<H: Hardware<L, J>, const L: usize, const J: usize> Faulty<H, L, J> {
    pub(crate) fn new(model: &'static Model<L, J>, plant: H) -> Self {
        Faulty {
            plant,
            model,
            defect: None,
            last: Sensors::ZERO,
            writes: 0,
            stops: 0,
        }
    }

    fn spoil(&self, defect: Defect, sensors: &mut Sensors<L, J>) {
        let Defect::Sensor(place, reading) = defect else {
            return;
        };
        let stuck = *place.of(&mut { self.last });
        *place.of(sensors) = match (reading, place) {
            (Reading::NotANumber, _) => f64::NAN,
            (Reading::Infinite(sign), _) => sign * f64::INFINITY,
            (Reading::JustBeyond(sign), Place::Angle(n, m)) => {
                let outer = self.model.legs[n].joints[m].outer;
                if sign > 0.0 {
                    outer.max + 1.0
                } else {
                    outer.min - 1.0
                }
            }
            (Reading::Absurd(value), _) => value,
            (Reading::JustBeyond(_), _) => unreachable!("angles only"),
            (Reading::Stuck, _) => stuck,
        };
    }

    /// Checks that hold for every command that is sent, whatever the fault.
    fn require_within_limits(&self, outputs: &Outputs<L, J>) {
        let joints = self.model.legs.iter().flat_map(|leg| &leg.joints);
        for (joint, command) in joints.zip(outputs.joints.iter().flatten()) {
            let within = match *command {
                JointCommand::Angle { angle, .. } => joint.limits.widened(ROUNDING).contains(angle),
                JointCommand::Torque(torque) => {
                    let forces = self.model.forces.expect("torques on such a robot only");
                    torque.abs() <= forces.torque_max
                }
            };
            assert!(within, "{:?} sends {command:?}", self.defect);
        }
        let travel = self.model.slider.map(|slider| slider.travel);
        for (at, travel) in outputs.slider.iter().zip(travel.into_iter().flatten()) {
            let within = travel.widened(ROUNDING).contains(*at);
            assert!(within, "{:?} sends the slider to {at}", self.defect);
        }
        assert_eq!(outputs.period, self.model.standards.period);
    }
}

impl<H: Hardware<L, J>, const L: usize, const J: usize> Hardware<L, J> for Faulty<H, L, J> {
    fn read(&mut self, into: &mut Sensors<L, J>) -> Result<(), HardwareFault> {
        self.plant.read(into)?;
        if let Some(Defect::ReadError) = self.defect {
            into.angles = [[f64::NAN; J]; L];
            return Err(HardwareFault::new("bus"));
        }
        if let Some(defect) = self.defect {
            self.spoil(defect, into);
        }
        self.last = *into;
        Ok(())
    }

    fn write(&mut self, outputs: &Outputs<L, J>) -> Result<(), HardwareFault> {
        self.require_within_limits(outputs);
        self.writes += 1;
        match self.defect {
            Some(Defect::WriteError) => Err(HardwareFault::new("bus")),
            Some(Defect::LostCommand) => {
                self.defect = None;
                Ok(())
            }
            Some(Defect::LateCycles) => {
                self.plant.write(outputs)?;
                self.plant.write(outputs)
            }
            Some(Defect::Jitter) => {
                // Multiples of the golden ratio spread evenly over 0…1.
                let spread = (f64::from(self.writes) * 0.618_033_988_75).fract();
                let period = outputs.period * (0.5 + spread);
                self.plant.write(&Outputs { period, ..*outputs })
            }
            _ => self.plant.write(outputs),
        }
    }

    fn stop(&mut self, why: &Fault) -> Result<(), HardwareFault> {
        self.stops += 1;
        self.plant.stop(why)
    }
}

/// Keyboard, log and screen.
#[derive(Clone)]
pub(crate) struct Desk {
    pub(crate) keys: VecDeque<u8>,
    pub(crate) log: TitanLog,
    pub(crate) emergencies: u32,
    pub(crate) endings: u32,
    /// The program has read its inputs.
    pub(crate) inputs_read: bool,
}

impl Desk {
    pub(crate) fn new() -> Self {
        Desk {
            keys: VecDeque::new(),
            log: TitanLog::default(),
            emergencies: 0,
            endings: 0,
            inputs_read: false,
        }
    }
}

impl Console for Desk {
    fn key(&mut self, _cycle: u64) -> Option<u8> {
        self.keys.pop_front()
    }
    fn message(&mut self, text: &dyn Display) {
        self.inputs_read |= text.to_string() == INPUTS_READ;
    }
    fn sample(&mut self, sample: &Sample<'_>) {
        self.log.push(sample);
    }
    fn emergency(&mut self, _report: &Report<'_>) {
        self.emergencies += 1;
    }
    fn ended(&mut self) {
        self.endings += 1;
    }
}
