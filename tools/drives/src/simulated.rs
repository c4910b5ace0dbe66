//! Simulated servos on a bus that can fail. They see bytes and a clock, so that they work in memory and on a pseudo-terminal.
//!
//! A servo turns towards its goal with the lag and the speed of its model, and warms up under load. Nothing loads it but its own
//! motion.

use crate::bus::{Port, Timing};
use crate::frame::{BROADCAST, Decoder, Frame, Protocol, Reads, instruction};
use crate::model::{Model, Register};
use crate::moteus;
use core::convert::Infallible;
use moteus_protocol::{
    CanFdFrame, Mode, REPLY_INT8, Resolution, Subframe, Value, WriteCanData, parse_frame,
};
use std::format;
use std::vec::Vec;

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
        let family = model.family;
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
        servo.set(family.model, model.number.into());
        servo.set(family.id, id.into());
        if let Some((mode, _, value)) = family.mode {
            servo.set(mode, value);
        }
        servo.power_on();
        servo
    }

    fn power_on(&mut self) {
        let family = self.model.family;
        self.set(family.torque_enable, 0);
        self.set(family.goal_speed, 0);
        self.set(family.torque_limit, self.model.full_torque.into());
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
        self.get(self.model.family.id) as u8
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
        self.get(self.model.family.torque_enable) == 1
    }

    /// Returns its torque limit, from 0 to 1.
    pub fn torque_limit(&self) -> f64 {
        let family = self.model.family;
        f64::from(self.get(family.torque_limit)) / f64::from(self.model.full_torque)
    }

    /// Moves for some time, s.
    fn advance(&mut self, time: f64, now: u64) {
        let family = self.model.family;
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
            let own = f64::from(self.get(family.goal_speed)) * self.model.speed_unit;
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
        self.set(family.load, (load * self.model.full_load) as i32);
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
        let family = self.model.family;
        match (self.temperature > 70.0, family.alarm_status) {
            (false, _) => 0,
            (true, Some(_)) => family.alarms,
            (true, None) => family.alarm_bits[1],
        }
    }

    /// Executes a request to a moteus, and returns its answer.
    fn serve(&mut self, payload: &[u8], now: u64) -> CanFdFrame {
        let family = self.model.family;
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
                    let full = self.model.full_torque;
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
        let family = self.model.family;
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
        let family = self.model.family;
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
        let protocol = servos
            .first()
            .map_or(Protocol::Dynamixel1, |servo| servo.model.family.protocol);
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
                    let family = self.servos[place].model.family;
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
        let family = servo.model.family;
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
        let delay = servo.model.family.return_delay;
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
