//! Simulated servos on a bus that can fail. They see bytes and a clock, so that they work in memory and on a pseudo-terminal.
//!
//! A servo turns towards its goal with the lag and the speed of its model, and warms up under load. Nothing loads it but its own
//! motion.

use crate::bus::{Port, Timing};
use crate::model::Model;
use crate::moteus;
use core::convert::Infallible;
use frame::{BROADCAST, Decoder, Frame, Protocol, Reads, instruction};
use moteus_protocol::{
    CanFdFrame, Mode, REPLY_INT8, Resolution, Subframe, Value, WriteCanData, parse_frame,
};
use std::format;
use std::vec::Vec;
use table::Register;

/// Time constant of a servo's remaining distance, s.
const LAG: f64 = 0.02;
/// Rise of the temperature at full load, °C per s.
const HEATING: f64 = 0.5;
/// Temperature of a servo that rests, °C.
const ROOM: f64 = 30.0;
/// Temperature of a servo that was made to overheat, °C.
const HOT: f64 = 85.0;

/// Probabilities of what can happen to an answer.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Faults {
    /// Bytes are damaged.
    pub corrupt: f64,
    /// It is lost.
    pub drop: f64,
    /// It comes twice.
    pub duplicate: f64,
    /// It comes up to 30 ms later, after the next request perhaps.
    pub delay: f64,
    /// Its end is lost.
    pub truncate: f64,
}

impl Faults {
    /// Returns the same probability for each of them, so that one of them happens to an answer with `probability`.
    pub fn evenly(probability: f64) -> Self {
        let each = probability / 5.0;
        Faults {
            corrupt: each,
            drop: each,
            duplicate: each,
            delay: each,
            truncate: each,
        }
    }
}

/// Counts of the faults that happened.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Happened {
    /// Damaged answers.
    pub corrupt: u64,
    /// Lost answers.
    pub dropped: u64,
    /// Answers that came twice.
    pub duplicated: u64,
    /// Late answers.
    pub delayed: u64,
    /// Answers without their end.
    pub truncated: u64,
}

/// A simulated servo.
#[derive(Clone, Debug)]
pub struct Servo {
    model: &'static Model,
    memory: [u8; 256],
    /// counts
    position: f64,
    /// counts/s
    velocity: f64,
    temperature: f64,
    is_gone: bool,
    is_hot: bool,
    /// Something holds it: it does not turn, with all its torque.
    is_blocked: bool,
    /// V
    voltage: f64,
    /// A moteus without commands for too long, which only a stop ends.
    is_timed_out: bool,
    /// Time of the last instruction, µs.
    heard: u64,
    /// The position that it reported last, counts.
    reported: Option<i32>,
}

impl Servo {
    /// Creates a servo of a model with an identity, at rest at a position, without torque.
    pub fn new(model: &'static Model, id: u8, position: f64) -> Self {
        let family = table::of(model);
        let mut servo = Servo {
            model,
            memory: [0; 256],
            position,
            velocity: 0.0,
            temperature: ROOM,
            is_gone: false,
            is_hot: false,
            is_blocked: false,
            voltage: 12.0,
            is_timed_out: false,
            heard: 0,
            reported: None,
        };
        servo.set(family.model, model.number.unwrap_or_default().into());
        servo.set(family.id, id.into());
        if let Some((mode, _, value)) = family.mode {
            servo.set(mode, value);
        }
        // The settings that the master compares.
        for (register, value) in family.settings {
            servo.set(*register, *value);
        }
        if let "ax" = model.family.key() {
            servo.set(table::register(8, 2), model.largest);
        }
        servo.power_on();
        servo
    }

    fn power_on(&mut self) {
        let family = table::of(self.model);
        self.set(family.torque_enable, 0);
        self.set(family.goal_speed, 0);
        self.set(
            family.torque_limit,
            self.model.full_torque.unwrap_or_default().into(),
        );
        self.set(family.goal_position, self.position as i32);
        if let Some(lock) = family.lock {
            self.set(lock, 1);
        }
        if let Some(watchdog) = family.watchdog {
            self.set(watchdog, 0);
        }
    }

    fn get(&self, register: Register) -> i32 {
        register.decode(0, &self.memory).unwrap_or_default()
    }

    fn set(&mut self, register: Register, value: i32) {
        let first = usize::from(register.address);
        let bytes = register.encode(value);
        let width = usize::from(register.width);
        self.memory[first..first + width].copy_from_slice(&bytes[..width]);
    }

    /// Returns its identity.
    pub fn id(&self) -> u8 {
        self.get(table::of(self.model).id) as u8
    }

    /// Returns its position, counts.
    pub fn position(&self) -> f64 {
        self.position
    }

    /// Returns its speed, counts/s.
    pub fn velocity(&self) -> f64 {
        self.velocity
    }

    /// Returns the position of its last answer as it was sent, counts.
    pub fn reported(&self) -> Option<i32> {
        self.reported
    }

    /// Returns true if it holds with torque.
    pub fn has_torque(&self) -> bool {
        self.get(table::of(self.model).torque_enable) == 1
    }

    /// Returns its torque limit, from 0 to 1.
    pub fn torque_limit(&self) -> f64 {
        let family = table::of(self.model);
        f64::from(self.get(family.torque_limit))
            / f64::from(self.model.full_torque.unwrap_or_default())
    }

    /// Moves for some time, s.
    fn advance(&mut self, time: f64, now: u64) {
        let family = table::of(self.model);
        let sleeps = family.watchdog.is_some_and(|watchdog| {
            let after = self.get(watchdog) as u8;
            after > 0 && now.saturating_sub(self.heard) > u64::from(after) * 20_000
        });
        if sleeps {
            self.set(family.goal_position, self.position as i32);
            if family.protocol == Protocol::Moteus {
                self.set(family.torque_enable, 0);
                self.is_timed_out = true;
            }
        }
        let limit = self.torque_limit();
        let (from, most) = (self.position, self.model.speed * self.model.turn / 360.0);
        if self.has_torque() && limit > 0.02 && !self.is_blocked {
            let own = f64::from(self.get(family.goal_speed)) * self.model.speed_unit.unwrap_or(1.0);
            let most = match own * self.model.turn / 360.0 {
                speed if speed > 0.0 => speed.min(most),
                _ => most,
            };
            let goal = f64::from(self.get(family.goal_position));
            let share = time / (time + LAG);
            let step = ((goal - from) * share).clamp(-most * time, most * time);
            self.position = (from + step).clamp(0.0, self.model.largest.into());
        }
        if time > 0.0 {
            self.velocity = (self.position - from) / time;
        }
        let load = match self.is_blocked && self.has_torque() {
            true => 1.0,
            false => 0.5 * (self.velocity / most).clamp(-1.0, 1.0),
        };
        let target = if self.is_hot {
            HOT
        } else {
            ROOM + 40.0 * load.abs().min(0.5)
        };
        let rate = if self.is_hot { 20.0 } else { HEATING };
        self.temperature += (target - self.temperature).clamp(-rate * time, rate * time);
        self.set(family.position, libm::round(self.position) as i32);
        self.set(
            family.load,
            (load * self.model.full_load.unwrap_or_default()) as i32,
        );
        self.set(family.voltage, (self.voltage * 10.0) as i32);
        self.set(family.temperature, self.temperature as i32);
        let is_alarmed = self.temperature > 70.0;
        if is_alarmed {
            self.set(family.torque_enable, 0);
        }
        if let Some(status) = family.alarm_status {
            let bits = if is_alarmed { family.alarm_bits[1] } else { 0 };
            self.set(status, bits.into());
        }
    }

    /// Returns the error byte of its answers.
    fn error(&self) -> u8 {
        let family = table::of(self.model);
        match (self.temperature > 70.0, family.alarm_status) {
            (false, _) => 0,
            (true, Some(_)) => family.alarms,
            (true, None) => family.alarm_bits[1],
        }
    }

    /// Executes a request to a moteus, and returns its answer.
    fn serve(&mut self, payload: &[u8], now: u64) -> CanFdFrame {
        let family = table::of(self.model);
        let mut answer = CanFdFrame::new();
        let mut mode = None;
        for part in parse_frame(payload) {
            let Subframe::Register {
                register,
                resolution,
                value,
                ..
            } = part
            else {
                continue;
            };
            let Some(register) = moteus_protocol::Register::from_address(register) else {
                continue;
            };
            let Some(value) = value else {
                self.tell(register, resolution, &mut answer);
                continue;
            };
            let float = f64::from(match value {
                Value::Float(float) => float,
                other => other.to_i32() as f32,
            });
            use moteus_protocol::Register as R;
            match register {
                R::Mode => mode = Mode::try_from(value.to_i32() as u8).ok(),
                R::CommandPosition if !self.is_timed_out => {
                    let counts = libm::round(float * moteus::TURN) as i32 + moteus::MIDDLE;
                    self.set(family.goal_position, counts);
                }
                R::CommandVelocityLimit => {
                    self.set(family.goal_speed, libm::round(float * 360.0) as i32);
                }
                R::CommandPositionMaxTorque => {
                    let full = self.model.full_torque.unwrap_or_default();
                    let torque = libm::round(float * 100.0).min(full.into()) as i32;
                    self.set(family.torque_limit, torque);
                }
                R::CommandTimeout => {
                    // NAN gives 0.
                    let units = libm::round(float / 0.02) as u8;
                    if let Some(watchdog) = family.watchdog {
                        self.set(watchdog, units.into());
                    }
                }
                _ => {}
            }
        }
        if mode.is_some() {
            self.heard = now;
        }
        match mode {
            Some(Mode::Stopped) => {
                self.is_timed_out = false;
                self.set(family.torque_enable, 0);
            }
            Some(Mode::Position) if !self.is_timed_out => self.set(family.torque_enable, 1),
            _ => {}
        }
        answer
    }

    /// Adds a register of a moteus to its answer.
    fn tell(
        &mut self,
        register: moteus_protocol::Register,
        resolution: Resolution,
        answer: &mut CanFdFrame,
    ) {
        use moteus_protocol::Register as R;
        let family = table::of(self.model);
        let mode = match (
            self.temperature > 70.0,
            self.is_timed_out,
            self.has_torque(),
        ) {
            (true, ..) => Mode::Fault,
            (_, true, _) => Mode::Timeout,
            (_, _, true) => Mode::Position,
            _ => Mode::Stopped,
        };
        let counts = self.get(family.position);
        // The units of numbers of 8, 16 and 32 bits.
        let (value, units) = match register {
            R::Mode => (f64::from(i8::from(mode)), [1.0; 3]),
            R::Position => {
                self.reported = Some(counts);
                let turns = f64::from(counts - moteus::MIDDLE) / moteus::TURN;
                (turns, [0.01, 1e-4, 1e-5])
            }
            R::Velocity => (self.velocity / moteus::TURN, [0.1, 0.000_25, 1e-5]),
            R::Torque => (f64::from(self.get(family.load)) / 100.0, [0.5, 0.01, 0.001]),
            R::Voltage => (
                f64::from(self.get(family.voltage)) / 10.0,
                [0.5, 0.1, 0.001],
            ),
            R::Temperature => (self.temperature, [1.0, 0.1, 0.001]),
            R::Fault if mode == Mode::Fault => (family.alarm_bits[1].into(), [1.0; 3]),
            R::MultiplexId => (self.id().into(), [1.0; 3]),
            _ => (0.0, [1.0; 3]),
        };
        let mut writer = WriteCanData::new(answer);
        writer.write_u8(REPLY_INT8 | resolution.type_code() | 1);
        writer.write_varuint(register.address().into());
        match resolution {
            Resolution::Float => writer.write_f32(value as f32),
            _ => {
                let unit = units[resolution.size() / 2];
                writer.write_int(libm::round(value / unit) as i32, resolution);
            }
        }
    }

    fn write(&mut self, address: u16, bytes: &[u8]) {
        let family = table::of(self.model);
        let first = usize::from(address);
        let touches_id = (first..first + bytes.len()).contains(&family.id.address.into());
        let is_locked = family.lock.is_some_and(|lock| self.get(lock) != 0);
        if let (false, Some(memory)) = (
            touches_id && is_locked,
            self.memory.get_mut(first..first + bytes.len()),
        ) {
            memory.copy_from_slice(bytes);
        }
    }
}

/// A bus of simulated servos, with everything that can go wrong.
#[derive(Clone, Debug)]
pub struct SimulatedBus {
    servos: Vec<Servo>,
    faults: Faults,
    happened: Happened,
    protocol: Protocol,
    timing: Timing,
    decoder: Decoder,
    random: u64,
    /// µs
    time: u64,
    /// Bytes on the wire to the master with their times, in order.
    answers: Vec<(u64, u8)>,
    /// Number of instructions that were understood.
    understood: u64,
}

impl SimulatedBus {
    /// Creates a bus; all servos must be of one protocol.
    pub fn new(servos: Vec<Servo>, timing: Timing) -> Self {
        let protocol = servos.first().map_or(Protocol::Dynamixel1, |servo| {
            table::of(servo.model).protocol
        });
        SimulatedBus {
            servos,
            faults: Faults::default(),
            happened: Happened::default(),
            protocol,
            timing,
            decoder: Decoder::new(protocol),
            random: 0x9E37_79B9_7F4A_7C15,
            time: 0,
            answers: Vec::new(),
            understood: 0,
        }
    }

    /// Lets faults happen, in an order that `seed` gives.
    #[must_use]
    pub fn with_faults(mut self, faults: Faults, seed: u64) -> Self {
        self.faults = faults;
        self.random ^= seed;
        self
    }

    /// Returns the servos.
    pub fn servos(&self) -> &[Servo] {
        &self.servos
    }

    /// Returns the faults that happened.
    pub fn happened(&self) -> Happened {
        self.happened
    }

    /// Returns the number of instructions that were understood.
    pub fn understood(&self) -> u64 {
        self.understood
    }

    /// Takes a servo away: it answers no more.
    pub fn unplug(&mut self, id: u8) {
        self.change(id, |servo| servo.is_gone = true);
    }

    /// Lets a servo start anew, as after a loose power connector: without torque, at its own speed.
    pub fn reset(&mut self, id: u8) {
        self.change(id, Servo::power_on);
    }

    /// Lets a servo get too hot in a few seconds.
    pub fn overheat(&mut self, id: u8) {
        self.change(id, |servo| servo.is_hot = true);
    }

    /// Lets something hold a servo, which needs all its torque then.
    pub fn block(&mut self, id: u8) {
        self.change(id, |servo| servo.is_blocked = true);
    }

    /// Lets the supply of a servo drop to 7 V.
    pub fn sag(&mut self, id: u8) {
        self.change(id, |servo| servo.voltage = 7.0);
    }

    fn change(&mut self, id: u8, change: impl FnMut(&mut Servo)) {
        let servos = self.servos.iter_mut();
        servos.filter(|servo| servo.id() == id).for_each(change);
    }

    /// Moves the servos until a time, µs.
    pub fn advance(&mut self, now: u64) {
        // Steps that are short against the lag.
        while self.time < now {
            let next = now.min(self.time + 2000);
            let time = (next - self.time) as f64 / 1e6;
            for servo in &mut self.servos {
                servo.advance(time, next);
            }
            self.time = next;
        }
    }

    /// Takes bytes from the master, the last of which arrived `now`, µs.
    pub fn receive(&mut self, bytes: &[u8], now: u64) {
        self.advance(now);
        for byte in bytes {
            self.decoder.push(*byte);
            while let Some(frame) = self.decoder.next(Reads::Requests) {
                self.understood += 1;
                self.execute(&frame);
            }
        }
    }

    /// Returns the time of the next byte to the master, µs.
    pub fn next_byte(&self) -> Option<u64> {
        self.answers.first().map(|(at, _)| *at)
    }

    /// Removes the bytes that have come to the master by now.
    pub fn take_bytes(&mut self, now: u64, most: usize) -> Vec<u8> {
        let due = self.answers.iter().take_while(|(at, _)| *at <= now);
        let count = due.take(most).count();
        self.answers.drain(..count).map(|(_, byte)| byte).collect()
    }

    /// Executes a request of an fdcanusb adapter's line.
    fn forward(&mut self, frame: &Frame) {
        self.append(b"OK\n", false);
        for place in self.addressed(frame.id) {
            let servo = &mut self.servos[place];
            let answer = servo.serve(&frame.parameters, self.time);
            if frame.code & 0x80 == 0 {
                continue;
            }
            let mut line = format!("rcv {:02x}{:02x} ", servo.id(), frame.code & 0x7F);
            for byte in answer.payload() {
                line.push_str(&format!("{byte:02X}"));
            }
            line.push_str(" B F\n");
            self.append(line.as_bytes(), true);
        }
    }

    /// Puts a line after those that are on the way.
    fn append(&mut self, line: &[u8], can_fail: bool) {
        let last = self.answers.last().map_or(0, |(at, _)| *at);
        let after = last.saturating_sub(self.time);
        match can_fail {
            true => self.transmit(line, after),
            false => self.put(line, self.time + after),
        }
    }

    fn execute(&mut self, frame: &Frame) {
        if self.protocol == Protocol::Moteus {
            return self.forward(frame);
        }
        let is_wide = self.protocol == Protocol::Dynamixel2;
        let word = |bytes: &[u8]| match bytes {
            [low, high] if is_wide => Some(u16::from_le_bytes([*low, *high])),
            [low] if !is_wide => Some(u16::from(*low)),
            _ => None,
        };
        let size = if is_wide { 2 } else { 1 };
        let parameters = &frame.parameters[..];
        let (first, rest) = parameters.split_at(size.min(parameters.len()));
        let (second, others) = rest.split_at(size.min(rest.len()));
        let now = self.time;
        for servo in &mut self.servos {
            if frame.id == BROADCAST || frame.id == servo.id() {
                servo.heard = now;
            }
        }
        match frame.code {
            instruction::PING => {
                for place in self.addressed(frame.id) {
                    let family = table::of(self.servos[place].model);
                    let number = self.servos[place].get(family.model).to_le_bytes();
                    let parameters: &[u8] = match is_wide {
                        true => &[number[0], number[1], 1],
                        false => &[],
                    };
                    self.answer(place, parameters, 0);
                }
            }
            instruction::READ => {
                if let (Some(start), Some(length)) = (word(first), word(second)) {
                    for place in self.addressed(frame.id) {
                        self.answer_read(place, start, length, 0);
                    }
                }
            }
            instruction::WRITE => {
                if let Some(start) = word(first) {
                    for place in self.addressed(frame.id) {
                        // The answer has the identity that it had.
                        if frame.id != BROADCAST {
                            self.answer(place, &[], 0);
                        }
                        self.servos[place].write(start, rest);
                    }
                }
            }
            instruction::SYNC_READ | instruction::FAST_SYNC_READ => {
                let (Some(start), Some(length)) = (word(first), word(second)) else {
                    return;
                };
                if frame.code == instruction::FAST_SYNC_READ {
                    self.answer_fast(start, length, others);
                    return;
                }
                let mut after = 0;
                for id in others {
                    for place in self.addressed(*id) {
                        after += self.answer_read(place, start, length, after);
                    }
                }
            }
            instruction::SYNC_WRITE => {
                let (Some(start), Some(length)) = (word(first), word(second)) else {
                    return;
                };
                for part in others.chunks_exact(usize::from(length) + 1) {
                    for place in self.addressed(part[0]) {
                        self.servos[place].write(start, &part[1..]);
                    }
                }
            }
            _ => {}
        }
    }

    /// Returns the places of the servos that an identity means.
    fn addressed(&self, id: u8) -> Vec<usize> {
        let servos = self.servos.iter().enumerate();
        let meant =
            servos.filter(|(_, servo)| !servo.is_gone && (id == BROADCAST || servo.id() == id));
        meant.map(|(place, _)| place).collect()
    }

    fn registers(&mut self, place: usize, start: u16, length: u16) -> Option<Vec<u8>> {
        let servo = &mut self.servos[place];
        let family = table::of(servo.model);
        let first = usize::from(start);
        let bytes = servo
            .memory
            .get(first..first + usize::from(length))?
            .to_vec();
        if let Some(position) = family.position.decode(start, &bytes) {
            servo.reported = Some(position);
        }
        Some(bytes)
    }

    /// Sends registers `after` µs, and returns how long that takes.
    fn answer_read(&mut self, place: usize, start: u16, length: u16, after: u64) -> u64 {
        let bytes = self.registers(place, start, length);
        bytes.map_or(0, |bytes| self.answer(place, &bytes, after))
    }

    fn answer_fast(&mut self, start: u16, length: u16, ids: &[u8]) {
        let mut parameters = Vec::new();
        let mut error = None;
        for id in ids {
            for place in self.addressed(*id) {
                let Some(bytes) = self.registers(place, start, length) else {
                    continue;
                };
                let own = self.servos[place].error();
                match error {
                    None => error = Some(own),
                    // The checksum up to here, which masters need not look at.
                    Some(_) => parameters.extend([0, 0, own]),
                }
                parameters.push(self.servos[place].id());
                parameters.extend(bytes);
            }
        }
        let Some(error) = error else {
            return;
        };
        if let Ok(frame) = self.protocol.answer(BROADCAST, error, &parameters) {
            self.transmit(&frame, 0);
        }
    }

    /// Sends an answer `after` µs, and returns how long that takes.
    fn answer(&mut self, place: usize, parameters: &[u8], after: u64) -> u64 {
        let servo = &self.servos[place];
        let delay = table::of(servo.model).return_delay;
        let delay = delay.map_or(0, |delay| servo.get(delay) as u64 * 2);
        let frame = self.protocol.answer(servo.id(), servo.error(), parameters);
        let Ok(frame) = frame else {
            return 0;
        };
        self.transmit(&frame, after + delay);
        delay + self.timing.bytes(frame.len())
    }

    /// Puts bytes on the wire, with a fault perhaps.
    fn transmit(&mut self, frame: &[u8], after: u64) {
        let Faults {
            corrupt,
            drop,
            duplicate,
            delay,
            truncate,
        } = self.faults;
        let mut bytes = frame.to_vec();
        let mut at = self.time + after;
        let chance = self.chance();
        let kinds = [corrupt, drop, duplicate, delay, truncate];
        let mut below = 0.0;
        let kind = kinds.iter().position(|probability| {
            below += probability;
            chance < below
        });
        match kind {
            Some(0) => {
                self.happened.corrupt += 1;
                self.damage(&mut bytes);
            }
            Some(1) => {
                self.happened.dropped += 1;
                return;
            }
            Some(2) => {
                self.happened.duplicated += 1;
                let later = at + self.timing.bytes(bytes.len());
                self.put(&bytes, later);
            }
            Some(3) => {
                self.happened.delayed += 1;
                at += (self.chance() * 30_000.0) as u64;
            }
            Some(_) => {
                self.happened.truncated += 1;
                let left = self.below(bytes.len());
                bytes.truncate(left);
            }
            None => {}
        }
        self.put(&bytes, at);
    }

    /// Damages a frame as a line does: a bit, a byte, or a burst of bytes.
    fn damage(&mut self, bytes: &mut [u8]) {
        let first = self.below(bytes.len());
        match self.below(3) {
            0 => bytes[first] ^= 1 << self.below(8),
            1 => bytes[first] ^= 1 + self.below(255) as u8,
            _ => {
                let length = 2 + self.below(3);
                for byte in bytes.iter_mut().skip(first).take(length) {
                    *byte ^= 1 + self.below(255) as u8;
                }
            }
        }
    }

    /// Puts bytes on the wire. Where two servos send, zeros win.
    fn put(&mut self, bytes: &[u8], at: u64) {
        // Times are rounded up: two bytes of a frame may be this close.
        let each = 10_000_000 / u64::from(self.timing.baud);
        for (number, byte) in bytes.iter().enumerate() {
            let at = at + self.timing.bytes(number + 1);
            let place = self
                .answers
                .partition_point(|(other, _)| other + each <= at);
            match self.answers.get_mut(place) {
                Some((other, old)) if *other < at + each => *old &= byte,
                _ => self.answers.insert(place, (at, *byte)),
            }
        }
    }

    /// Returns a number from 0 to 1.
    fn chance(&mut self) -> f64 {
        // SplitMix64.
        self.random = self.random.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.random;
        z = (z ^ z >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ z >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ z >> 31) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn below(&mut self, end: usize) -> usize {
        (self.chance() * end as f64) as usize
    }
}

/// A simulated bus as a port, with a clock of its own: bytes take their time on the wire, and waiting takes none of ours.
#[derive(Clone, Debug)]
pub struct MemoryPort {
    /// The servos at its end.
    pub bus: SimulatedBus,
    now: u64,
}

impl MemoryPort {
    /// Creates a port at time 0.
    pub fn new(bus: SimulatedBus) -> Self {
        MemoryPort { bus, now: 0 }
    }

    /// Lets time pass until a time, µs.
    pub fn pass(&mut self, until: u64) {
        self.now = self.now.max(until);
        self.bus.advance(self.now);
    }
}

impl embedded_io::ErrorType for MemoryPort {
    type Error = Infallible;
}

impl embedded_io::Read for MemoryPort {
    fn read(&mut self, into: &mut [u8]) -> Result<usize, Infallible> {
        let bytes = self.bus.take_bytes(self.now, into.len());
        into[..bytes.len()].copy_from_slice(&bytes);
        Ok(bytes.len())
    }
}

impl embedded_io::Write for MemoryPort {
    fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
        self.now += self.bus.timing.bytes(bytes.len());
        self.bus.receive(bytes, self.now);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

impl Port for MemoryPort {
    fn now(&mut self) -> u64 {
        self.now
    }

    fn wait(&mut self, until: u64) -> Result<bool, Infallible> {
        match self.bus.next_byte() {
            Some(at) if at <= until.max(self.now) => {
                self.pass(at);
                Ok(true)
            }
            _ => {
                self.pass(until);
                Ok(false)
            }
        }
    }
}

#[allow(
    missing_docs,
    dead_code,
    unreachable_pub,
    reason = "until the simulated servos have their own"
)]
mod frame {
    use super::table::request;
    use heapless::Vec;

    /// The frames that a servo understands.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Protocol {
        /// Dynamixel protocol 1: a checksum of 8 bits.
        Dynamixel1,
        /// Dynamixel protocol 2: a CRC of 16 bits.
        Dynamixel2,
        /// Feetech STS: frames of Dynamixel protocol 1, with a sync read.
        Feetech,
        /// Lines of an fdcanusb adapter, which `moteus` writes.
        Moteus,
    }

    /// The identity that every servo listens to.
    pub const BROADCAST: u8 = 0xFE;
    /// The largest identity of a servo.
    pub const LAST_ID: u8 = 252;
    /// The longest frame, bytes.
    pub const LONGEST: usize = 512;

    /// A frame to be sent.
    pub type Bytes = Vec<u8, LONGEST>;

    /// The frame does not fit.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct TooLong;

    /// Instructions of a frame. The numbers are the same in all protocols.
    pub mod instruction {
        /// Asks for an answer.
        pub const PING: u8 = 0x01;
        /// Reads registers.
        pub const READ: u8 = 0x02;
        /// Writes registers.
        pub const WRITE: u8 = 0x03;
        /// An answer, in protocol 2.
        pub const STATUS: u8 = 0x55;
        /// Reads registers of many servos.
        pub const SYNC_READ: u8 = 0x82;
        /// Writes registers of many servos.
        pub const SYNC_WRITE: u8 = 0x83;
        /// Reads registers of many servos, which answer in one frame.
        pub const FAST_SYNC_READ: u8 = 0x8A;
    }

    /// A frame without its framing.
    #[derive(Clone, Debug, PartialEq, Eq)]
    pub struct Frame {
        /// Receiver of a request, sender of an answer.
        pub id: u8,
        /// Instruction of a request, error byte of an answer.
        pub code: u8,
        /// Everything else.
        pub parameters: Vec<u8, LONGEST>,
    }

    const HEADER_1: [u8; 2] = [0xFF, 0xFF];
    const HEADER_2: [u8; 4] = [0xFF, 0xFF, 0xFD, 0x00];
    /// Bytes that may not appear in the body of a frame of protocol 2, and the one that is put after them.
    const STUFFED: [u8; 3] = [0xFF, 0xFF, 0xFD];

    impl Protocol {
        /// Returns the number of bytes of an answer with this many parameters, without stuffing.
        pub const fn answer_length(self, parameters: usize) -> usize {
            match self {
                Protocol::Dynamixel2 => parameters + 11,
                Protocol::Moteus => 130,
                _ => parameters + 6,
            }
        }

        /// Returns the bytes of a request.
        ///
        /// # Errors
        /// It has too many parameters.
        pub fn request(self, id: u8, instruction: u8, parameters: &[u8]) -> Result<Bytes, TooLong> {
            self.encode(id, &[instruction], parameters)
        }

        /// Returns the bytes of an answer, as a servo sends them.
        ///
        /// # Errors
        /// It has too many parameters.
        pub fn answer(self, id: u8, error: u8, parameters: &[u8]) -> Result<Bytes, TooLong> {
            match self {
                Protocol::Dynamixel2 => self.encode(id, &[instruction::STATUS, error], parameters),
                _ => self.encode(id, &[error], parameters),
            }
        }

        fn encode(self, id: u8, codes: &[u8], parameters: &[u8]) -> Result<Bytes, TooLong> {
            debug_assert!(
                self != Protocol::Moteus,
                "its requests are made by `moteus`"
            );
            let mut frame = Bytes::new();
            let add = |frame: &mut Bytes, bytes: &[u8]| {
                frame.extend_from_slice(bytes).map_err(|_| TooLong)
            };
            if self == Protocol::Dynamixel2 {
                add(&mut frame, &HEADER_2)?;
                add(&mut frame, &[id, 0, 0])?;
                for byte in codes.iter().chain(parameters) {
                    add(&mut frame, &[*byte])?;
                    if frame[7..].ends_with(&STUFFED) {
                        add(&mut frame, &STUFFED[2..])?;
                    }
                }
                let length = u16::try_from(frame.len() - 7 + 2).map_err(|_| TooLong)?;
                frame[5..7].copy_from_slice(&length.to_le_bytes());
                let crc = crc16(&frame).to_le_bytes();
                add(&mut frame, &crc)?;
            } else {
                let length =
                    u8::try_from(codes.len() + parameters.len() + 1).map_err(|_| TooLong)?;
                add(&mut frame, &HEADER_1)?;
                add(&mut frame, &[id, length])?;
                add(&mut frame, codes)?;
                add(&mut frame, parameters)?;
                let sum = checksum(&frame[2..]);
                add(&mut frame, &[sum])?;
            }
            Ok(frame)
        }

        /// Tries to read a frame at the beginning of `bytes`. An answer of another length is refused as soon as its length is there.
        fn parse(self, bytes: &[u8], reads: Reads) -> Parsed {
            match self {
                Protocol::Dynamixel2 => parse_2(bytes, reads),
                Protocol::Moteus => parse_line(bytes, reads),
                _ => parse_1(bytes, reads),
            }
        }
    }

    /// The frames that a decoder reads.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Reads {
        /// Requests, of any length.
        Requests,
        /// Answers with this many parameters.
        Answers(usize),
        /// Answers of a moteus to this sender.
        AnswersTo(u8),
    }

    #[allow(clippy::large_enum_variant, reason = "there is no allocator")]
    enum Parsed {
        /// A frame, and the number of its bytes.
        Frame(Frame, usize),
        /// The beginning of a frame, perhaps; more bytes decide.
        Unfinished,
        /// A line that is no frame, and the number of its bytes.
        Line(usize),
        /// No frame begins here.
        Nothing,
    }

    fn begins(bytes: &[u8], header: &[u8]) -> bool {
        bytes
            .iter()
            .zip(header)
            .all(|(byte, wanted)| byte == wanted)
    }

    fn parse_1(bytes: &[u8], reads: Reads) -> Parsed {
        let (Some(&id), Some(&length)) = (bytes.get(2), bytes.get(3)) else {
            return match begins(bytes, &HEADER_1) && bytes.get(2) != Some(&0xFF) {
                true => Parsed::Unfinished,
                false => Parsed::Nothing,
            };
        };
        let length = usize::from(length);
        let fits = match reads {
            Reads::Requests => length >= 2,
            Reads::Answers(wanted) => length == wanted + 2,
            Reads::AnswersTo(_) => false,
        };
        if !begins(bytes, &HEADER_1) || id == 0xFF || !fits {
            return Parsed::Nothing;
        }
        let Some(body) = bytes.get(2..length + 4) else {
            return Parsed::Unfinished;
        };
        let [body @ .., sum] = body else {
            return Parsed::Nothing;
        };
        let (Some(code), Ok(parameters)) = (body.get(2), Vec::from_slice(&body[3..])) else {
            return Parsed::Nothing;
        };
        if checksum(body) != *sum {
            return Parsed::Nothing;
        }
        let code = *code;
        let frame = Frame {
            id,
            code,
            parameters,
        };
        Parsed::Frame(frame, length + 4)
    }

    fn parse_2(bytes: &[u8], reads: Reads) -> Parsed {
        if !begins(bytes, &HEADER_2) {
            return Parsed::Nothing;
        }
        let Some(&[_, _, _, _, id, low, high]) = bytes.first_chunk::<7>() else {
            return Parsed::Unfinished;
        };
        let length = usize::from(u16::from_le_bytes([low, high]));
        let fits = match reads {
            Reads::Requests => (3..=LONGEST - 7).contains(&length),
            // One byte is stuffed after three at the most.
            Reads::Answers(wanted) => (wanted + 4..=wanted + 5 + wanted / 3).contains(&length),
            Reads::AnswersTo(_) => false,
        };
        if !fits {
            return Parsed::Nothing;
        }
        let Some(whole) = bytes.get(..length + 7) else {
            return Parsed::Unfinished;
        };
        let (body, crc) = whole.split_at(whole.len() - 2);
        if crc16(body).to_le_bytes() != crc {
            return Parsed::Nothing;
        }
        let mut plain = Vec::<u8, LONGEST>::new();
        let mut stuffed = false;
        for byte in &body[7..] {
            // The byte after the three is not part of the message.
            if !stuffed && plain.push(*byte).is_err() {
                return Parsed::Nothing;
            }
            stuffed = !stuffed && plain.ends_with(&STUFFED);
        }
        let (code, parameters) = match (reads, &plain[..]) {
            (Reads::Requests, [code, parameters @ ..]) => (*code, parameters),
            (Reads::Answers(wanted), [instruction::STATUS, error, parameters @ ..])
                if parameters.len() == wanted =>
            {
                (*error, parameters)
            }
            _ => return Parsed::Nothing,
        };
        let Ok(parameters) = Vec::from_slice(parameters) else {
            return Parsed::Nothing;
        };
        let frame = Frame {
            id,
            code,
            parameters,
        };
        Parsed::Frame(frame, length + 7)
    }

    /// Reads a line of an fdcanusb adapter, or one to it.
    fn parse_line(bytes: &[u8], reads: Reads) -> Parsed {
        let Some(end) = bytes.iter().position(|byte| *byte == b'\n') else {
            return match bytes.len() < LONGEST / 2 {
                true => Parsed::Unfinished,
                false => Parsed::Nothing,
            };
        };
        let line = &bytes[..end];
        let frame = match reads {
            Reads::Requests => request(line).map(|request| Frame {
                id: request.id,
                code: request.from | u8::from(request.is_answered) << 7,
                // A CAN-FD frame is shorter than the longest one.
                parameters: Vec::from_slice(&request.payload).unwrap_or_default(),
            }),
            Reads::AnswersTo(_) => None,
            Reads::Answers(_) => None,
        };
        frame.map_or(Parsed::Nothing, |frame| Parsed::Frame(frame, end + 1))
    }

    /// Returns the checksum of protocol 1 over identity, length, code and parameters.
    fn checksum(body: &[u8]) -> u8 {
        !body.iter().fold(0_u8, |sum, byte| sum.wrapping_add(*byte))
    }

    /// Returns the CRC of protocol 2: polynomial 0x8005, most significant bit first, from 0.
    fn crc16(bytes: &[u8]) -> u16 {
        bytes.iter().fold(0_u16, |crc, byte| {
            (0..8).fold(crc ^ u16::from(*byte) << 8, |crc, _| match crc >> 15 {
                0 => crc << 1,
                _ => crc << 1 ^ 0x8005,
            })
        })
    }

    /// Finds frames in a stream of bytes. After damaged bytes it looks for a frame at each of the following ones, so that an intact
    /// frame is found whatever came before it.
    #[derive(Clone, Debug)]
    pub struct Decoder {
        protocol: Protocol,
        buffer: Vec<u8, LONGEST>,
        discarded: u64,
    }

    impl Decoder {
        /// Creates a decoder with nothing in it.
        pub const fn new(protocol: Protocol) -> Self {
            Decoder {
                protocol,
                buffer: Vec::new(),
                discarded: 0,
            }
        }

        /// Adds a byte.
        pub fn push(&mut self, byte: u8) {
            if self.buffer.is_full() {
                self.drop_front(1);
            }
            // There is room now.
            let _ = self.buffer.push(byte);
        }

        /// Returns the next frame; bytes that cannot become one are discarded.
        pub fn next(&mut self, reads: Reads) -> Option<Frame> {
            loop {
                if self.buffer.is_empty() {
                    return None;
                }
                match self.protocol.parse(&self.buffer, reads) {
                    Parsed::Frame(frame, length) => {
                        self.buffer.drain(..length);
                        return Some(frame);
                    }
                    Parsed::Unfinished => return None,
                    Parsed::Line(length) => self.drop_front(length),
                    Parsed::Nothing => self.discard(1),
                }
            }
        }

        /// Returns the next frame after one that is not finished and never will be.
        pub fn next_after_silence(&mut self, reads: Reads) -> Option<Frame> {
            while !self.buffer.is_empty() {
                self.discard(1);
                if let Some(frame) = self.next(reads) {
                    return Some(frame);
                }
            }
            None
        }

        /// Forgets everything.
        pub fn clear(&mut self) {
            self.discard(self.buffer.len());
        }

        /// Returns the number of bytes that were in no frame.
        pub const fn discarded(&self) -> u64 {
            self.discarded
        }

        fn discard(&mut self, count: usize) {
            self.discarded += count as u64;
            self.drop_front(count);
        }

        fn drop_front(&mut self, count: usize) {
            self.buffer.drain(..count.min(self.buffer.len()));
        }
    }
}

#[allow(
    missing_docs,
    dead_code,
    unreachable_pub,
    reason = "until the simulated servos have their own"
)]
mod table {
    use super::frame::Protocol;
    use heapless::Vec;
    use moteus_protocol::fdcanusb::{MAX_LINE_LENGTH, parse_rcv, strip_checksum};
    use moteus_protocol::{CanFdFrame, parse_arbitration_id};

    type Line = Vec<u8, MAX_LINE_LENGTH>;

    /// Returns the table of a model's servos.
    pub fn of(model: &crate::model::Model) -> &'static Family {
        match model.family.key() {
            "ax" => &AX,
            "x" => &X,
            "sts" => &STS,
            _ => &MOTEUS,
        }
    }

    /// Addresses of the table: width in bytes after the name.
    pub mod address {
        /// 2: always 0.
        pub const MODEL: u16 = 0;
        /// 1: identity.
        pub const ID: u16 = 2;
        /// 1: 1 if it follows positions.
        pub const TORQUE_ENABLE: u16 = 3;
        /// 4: measured position.
        pub const POSITION: u16 = 4;
        /// 2: torque, 0.01 Nm.
        pub const LOAD: u16 = 8;
        /// 2: 0.1 V.
        pub const VOLTAGE: u16 = 10;
        /// 1: °C.
        pub const TEMPERATURE: u16 = 12;
        /// 1: number of the fault.
        pub const FAULT: u16 = 13;
        /// 4: commanded position.
        pub const GOAL_POSITION: u16 = 16;
        /// 4: velocity limit, deg/s.
        pub const GOAL_SPEED: u16 = 20;
        /// 2: maximum torque, 0.01 Nm.
        pub const TORQUE_LIMIT: u16 = 24;
        /// 1: time-out of a command, 20 ms; 0 for none.
        pub const WATCHDOG: u16 = 26;
    }

    /// Number of bytes of the table that an answer holds.
    pub const MEASURED: usize = 14;
    /// Encoding of negative values in a register.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Sign {
        /// There are none.
        None,
        /// Two's complement over the register's width.
        Twos,
        /// This bit is set, and the bits below are the amount.
        Bit(u8),
    }

    /// A register: its address, its width in bytes and its sign.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Register {
        /// Address of its lowest byte.
        pub address: u16,
        /// Width, bytes: 1, 2 or 4.
        pub width: u8,
        /// Encoding of negative values.
        pub sign: Sign,
    }

    pub const fn register(address: u16, width: u8) -> Register {
        Register {
            address,
            width,
            sign: Sign::None,
        }
    }

    const fn signed(address: u16, width: u8, sign: Sign) -> Register {
        Register {
            address,
            width,
            sign,
        }
    }

    impl Register {
        /// Returns the value in `bytes`, which begin at address `start`; `None` if they do not hold it.
        pub fn decode(self, start: u16, bytes: &[u8]) -> Option<i32> {
            let first = usize::from(self.address.checked_sub(start)?);
            let bytes = bytes.get(first..first + usize::from(self.width))?;
            let raw = bytes
                .iter()
                .rev()
                .fold(0_u32, |value, byte| value << 8 | u32::from(*byte));
            Some(match self.sign {
                Sign::None => raw as i32,
                Sign::Twos if self.width == 2 => i32::from(raw as u16 as i16),
                Sign::Twos => raw as i32,
                Sign::Bit(bit) => {
                    let amount = (raw & ((1 << bit) - 1)) as i32;
                    if raw >> bit & 1 == 1 { -amount } else { amount }
                }
            })
        }

        /// Returns the bytes of a value, lowest first; those beyond the width are 0.
        pub fn encode(self, value: i32) -> [u8; 4] {
            let raw = match self.sign {
                Sign::Bit(bit) if value < 0 => value.unsigned_abs() | 1 << bit,
                _ => value as u32,
            };
            let mut bytes = raw.to_le_bytes();
            bytes[usize::from(self.width).min(4)..].fill(0);
            bytes
        }
    }

    /// A part of the register table that is read in a cycle.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Window {
        /// First address.
        pub start: u16,
        /// Length, bytes.
        pub length: u8,
    }

    const fn window(start: u16, length: u8) -> Window {
        Window { start, length }
    }

    /// The register table of a family of servos.
    #[derive(Debug, PartialEq, Eq)]
    pub struct Family {
        /// Name in messages.
        pub name: &'static str,
        /// Frames that it understands.
        pub protocol: Protocol,
        /// True if one request reads many servos.
        pub reads_many: bool,
        /// Windows with position, load, voltage and temperature. Successive cycles read different ones, so that the length of
        /// an answer tells an old answer from a new one. With a checksum of 8 bits, two neighbouring bytes can be damaged unnoticed:
        /// the byte before the position must be one whose value is known.
        pub windows: [Window; 3],
        /// Number of the model; an answer of 3 bytes or more differs from the echo of its request.
        pub model: Register,
        /// Identity on the bus.
        pub id: Register,
        /// Delay of an answer, in units of 2 µs; `None` if there is none.
        pub return_delay: Option<Register>,
        /// Register with the way in which it turns, and the values with which it goes to positions; `None` if it always does.
        pub mode: Option<(Register, i32, i32)>,
        /// Register that protects the identity until it is 0; `None` if torque off is enough.
        pub lock: Option<Register>,
        /// Torque on or off.
        pub torque_enable: Register,
        /// Commanded position, counts.
        pub goal_position: Register,
        /// The fastest that it turns by itself.
        pub goal_speed: Register,
        /// The most torque that it gives.
        pub torque_limit: Register,
        /// Measured position, counts.
        pub position: Register,
        /// Measured load.
        pub load: Register,
        /// Supply voltage, 0.1 V.
        pub voltage: Register,
        /// Temperature, °C.
        pub temperature: Register,
        /// Stops the servo when no instruction comes for this many units of 20 ms; `None` if it holds its last command forever.
        pub watchdog: Option<Register>,
        /// Bits of the error byte of an answer that are alarms of the servo, not remarks on a request.
        pub alarms: u8,
        /// Register with the alarms, where the error byte only says that there are some.
        pub alarm_status: Option<Register>,
        /// Bits of an alarm that are voltage, temperature and overload; of a moteus, the numbers of the faults.
        pub alarm_bits: [u8; 3],
        /// Settings of a new servo.
        pub settings: &'static [(Register, i32)],
    }

    /// AX, RX, EX and MX servos with Dynamixel protocol 1. None of them answers a sync read.
    pub static AX: Family = Family {
        name: "Dynamixel AX/MX",
        protocol: Protocol::Dynamixel1,
        reads_many: false,
        windows: [window(36, 8), window(36, 11), window(24, 20)],
        model: register(0, 2),
        id: register(3, 1),
        return_delay: Some(register(5, 1)),
        // The largest position; 0 makes it a wheel.
        mode: Some((register(8, 2), 1, 4095)),
        lock: None,
        torque_enable: register(24, 1),
        goal_position: register(30, 2),
        goal_speed: register(32, 2),
        torque_limit: register(34, 2),
        position: register(36, 2),
        load: signed(40, 2, Sign::Bit(10)),
        voltage: register(42, 1),
        temperature: register(43, 1),
        watchdog: None,
        alarms: 0b0010_0101,
        alarm_status: None,
        alarm_bits: [1, 1 << 2, 1 << 5],
        settings: &[(register(16, 1), 2)],
    };

    /// X servos with Dynamixel protocol 2.
    pub static X: Family = Family {
        name: "Dynamixel X",
        protocol: Protocol::Dynamixel2,
        reads_many: true,
        windows: [window(126, 21), window(124, 23), window(122, 25)],
        model: register(0, 2),
        id: register(7, 1),
        return_delay: Some(register(9, 1)),
        mode: Some((register(11, 1), 3, 3)),
        lock: None,
        torque_enable: register(64, 1),
        goal_position: signed(116, 4, Sign::Twos),
        goal_speed: register(112, 4),
        torque_limit: register(100, 2),
        position: signed(132, 4, Sign::Twos),
        load: signed(126, 2, Sign::Twos),
        voltage: register(144, 2),
        temperature: register(146, 1),
        watchdog: Some(register(98, 1)),
        alarms: 0x80,
        alarm_status: Some(register(70, 1)),
        alarm_bits: [1, 1 << 2, 1 << 5],
        settings: &[(register(68, 1), 2), (register(48, 4), 4095)],
    };

    /// STS servos of Feetech.
    pub static STS: Family = Family {
        name: "Feetech STS",
        protocol: Protocol::Feetech,
        reads_many: true,
        windows: [window(56, 8), window(56, 11), window(40, 24)],
        model: register(3, 2),
        id: register(5, 1),
        return_delay: Some(register(7, 1)),
        mode: Some((register(33, 1), 0, 0)),
        lock: Some(register(55, 1)),
        torque_enable: register(40, 1),
        goal_position: signed(42, 2, Sign::Bit(15)),
        goal_speed: signed(46, 2, Sign::Bit(15)),
        torque_limit: register(48, 2),
        position: signed(56, 2, Sign::Bit(15)),
        load: signed(60, 2, Sign::Bit(10)),
        voltage: register(62, 1),
        temperature: register(63, 1),
        watchdog: None,
        alarms: 0b0010_1111,
        alarm_status: None,
        alarm_bits: [1, 1 << 2, 1 << 5 | 1 << 3],
        settings: &[
            (register(8, 1), 1),
            (register(30, 1), 1),
            (register(11, 2), 4095),
        ],
    };

    /// moteus controllers of mjbots, with the register table of [`moteus`].
    pub static MOTEUS: Family = Family {
        name: "mjbots moteus",
        protocol: Protocol::Moteus,
        reads_many: false,
        windows: [window(0, MEASURED as u8); 3],
        model: register(address::MODEL, 2),
        id: register(address::ID, 1),
        return_delay: None,
        mode: None,
        lock: None,
        torque_enable: register(address::TORQUE_ENABLE, 1),
        goal_position: signed(address::GOAL_POSITION, 4, Sign::Twos),
        goal_speed: register(address::GOAL_SPEED, 4),
        torque_limit: register(address::TORQUE_LIMIT, 2),
        position: signed(address::POSITION, 4, Sign::Twos),
        load: signed(address::LOAD, 2, Sign::Twos),
        voltage: register(address::VOLTAGE, 2),
        temperature: register(address::TEMPERATURE, 1),
        watchdog: Some(register(address::WATCHDOG, 1)),
        alarms: 0x80,
        alarm_status: Some(register(address::FAULT, 1)),
        alarm_bits: [40, 38, 0],
        settings: &[],
    };

    /// A request as a controller receives it.
    #[derive(Clone, Debug, PartialEq, Eq)]
    pub struct Request {
        /// The receiver.
        pub id: u8,
        /// The sender.
        pub from: u8,
        /// True if the controller answers.
        pub is_answered: bool,
        /// Registers to read and to write, as the frame encodes them.
        pub payload: Vec<u8, 64>,
    }

    /// Reads a line without its end as a request.
    pub fn request(line: &[u8]) -> Option<Request> {
        let mut received = Line::from_slice(b"rcv ").ok()?;
        let rest = line.strip_prefix(b"can send ")?;
        received.extend_from_slice(rest).ok()?;
        let frame = received_frame(&received)?;
        let (from, id, _) = parse_arbitration_id(frame.arbitration_id);
        Some(Request {
            id: id as u8,
            from: from as u8,
            is_answered: frame.arbitration_id & 0x8000 != 0,
            payload: Vec::from_slice(frame.payload()).ok()?,
        })
    }

    /// Reads the frame of a received line, whose checksum must be right where it has one.
    fn received_frame(line: &[u8]) -> Option<CanFdFrame> {
        let (content, has_checksum, is_valid) = strip_checksum(line);
        parse_rcv(content).filter(|_| is_valid || !has_checksum)
    }
}
