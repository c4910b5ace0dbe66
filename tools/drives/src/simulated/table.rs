//! The memory of a servo with registers: what each address holds, and what may be written there.
//!
//! The rows themselves are in the module of each family.

use std::vec;
use std::vec::Vec;

/// Form of a register's number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Coding {
    /// From 0 upwards.
    Unsigned,
    /// Two's complement.
    Signed,
    /// A magnitude; this bit is set if the number is negative.
    SignBit(u8),
}

/// A register.
#[derive(Clone, Copy, Debug)]
pub(super) struct Item {
    pub(super) address: u16,
    /// Bytes.
    pub(super) width: u8,
    pub(super) coding: Coding,
    /// The value as delivered.
    initial: i64,
    /// The values that may be written; `None` if none may.
    pub(super) range: Option<(i64, i64)>,
}

/// Returns a register that can only be read.
pub(super) const fn read_only(address: u16, width: u8, initial: i64) -> Item {
    Item {
        address,
        width,
        coding: Coding::Unsigned,
        initial,
        range: None,
    }
}

/// Returns a register that can be written, from `min` to `max`.
pub(super) const fn writable(address: u16, width: u8, initial: i64, min: i64, max: i64) -> Item {
    Item {
        range: Some((min, max)),
        ..read_only(address, width, initial)
    }
}

impl Item {
    /// Returns the register with numbers of another form.
    pub(super) const fn coded(self, coding: Coding) -> Self {
        Item { coding, ..self }
    }

    const fn end(&self) -> u16 {
        self.address + self.width as u16
    }

    fn decode(&self, bytes: &[u8]) -> i64 {
        let raw = bytes
            .iter()
            .rev()
            .fold(0_i64, |raw, byte| raw << 8 | i64::from(*byte));
        let bits = 8 * u32::from(self.width);
        match self.coding {
            Coding::Unsigned => raw,
            Coding::Signed => raw << (64 - bits) >> (64 - bits),
            Coding::SignBit(bit) if raw >> bit & 1 == 1 => -(raw & !(1 << bit)),
            Coding::SignBit(_) => raw,
        }
    }

    fn encode(&self, value: i64) -> i64 {
        match self.coding {
            Coding::SignBit(bit) if value < 0 => -value | 1 << bit,
            _ => value,
        }
    }
}

/// A reason why bytes are not written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Refusal {
    /// There is no register, or one that can only be read.
    Access,
    /// Less than a whole register.
    Length,
}

/// Registers and their values. Those before `ram` are kept without power.
#[derive(Clone, Debug)]
pub(super) struct Table {
    items: Vec<Item>,
    /// The place of the register at each address, in `items`.
    places: Vec<Option<u8>>,
    live: Vec<u8>,
    saved: Vec<u8>,
    ram: u16,
}

impl Table {
    /// Creates a table with the values as delivered.
    pub(super) fn new(items: Vec<Item>, ram: u16) -> Self {
        let end = items.iter().map(Item::end).max().unwrap_or_default();
        let mut places = vec![None; end.into()];
        for (place, item) in items.iter().enumerate() {
            for address in item.address..item.end() {
                places[usize::from(address)] = Some(place as u8);
            }
        }
        let mut table = Table {
            items,
            places,
            live: vec![0; end.into()],
            saved: vec![0; ram.into()],
            ram,
        };
        for place in 0..table.items.len() {
            let Item {
                address, initial, ..
            } = table.items[place];
            table.set(address, initial);
        }
        table.save();
        table
    }

    /// Sets everything to what it is when the power comes back.
    pub(super) fn power_on(&mut self) {
        let saved = self.saved.len();
        self.live[..saved].copy_from_slice(&self.saved);
        for place in 0..self.items.len() {
            let Item {
                address, initial, ..
            } = self.items[place];
            if address >= self.ram {
                self.set(address, initial);
            }
        }
    }

    /// Keeps the registers before `ram` for times without power.
    pub(super) fn save(&mut self) {
        let saved = self.saved.len();
        self.saved.copy_from_slice(&self.live[..saved]);
    }

    /// Returns the register that an address belongs to.
    fn item(&self, address: u16) -> Option<&Item> {
        let place = (*self.places.get(usize::from(address))?)?;
        self.items.get(usize::from(place))
    }

    /// Returns the value of the register at an address, 0 if there is none.
    pub(super) fn get(&self, address: u16) -> i64 {
        self.item(address).map_or(0, |item| {
            item.decode(&self.live[item.address.into()..item.end().into()])
        })
    }

    /// Sets the register at an address, whatever may be written there.
    pub(super) fn set(&mut self, address: u16, value: i64) {
        if let Some(item) = self.item(address).copied() {
            let bytes = item.encode(value).to_le_bytes();
            self.live[item.address.into()..item.end().into()]
                .copy_from_slice(&bytes[..item.width.into()]);
        }
    }

    /// Returns bytes from an address on.
    pub(super) fn bytes(&self, start: u16, length: u16) -> Option<&[u8]> {
        let start = usize::from(start);
        self.live.get(start..start + usize::from(length))
    }

    /// Returns the bytes at an address as one number, low byte first.
    pub(super) fn raw(&self, address: u16, width: u8) -> Option<u32> {
        let bytes = self.bytes(address, width.into())?.iter().rev();
        Some(bytes.fold(0, |raw, byte| raw << 8 | u32::from(*byte)))
    }

    /// Sets a register and keeps it without power.
    pub(super) fn preset(&mut self, address: u16, value: i64) {
        self.set(address, value);
        self.save();
    }

    /// Returns the registers that bytes would be written to, and their new values.
    ///
    /// # Errors
    /// They are not whole registers, or none that can be written.
    pub(super) fn parse(&self, start: u16, bytes: &[u8]) -> Result<Vec<(Item, i64)>, Refusal> {
        let end = start + bytes.len() as u16;
        let mut at = start;
        let mut values = Vec::new();
        while at < end {
            let item = self.item(at).ok_or(Refusal::Access)?;
            if item.range.is_none() {
                return Err(Refusal::Access);
            }
            if item.address < start || item.end() > end {
                return Err(Refusal::Length);
            }
            let first = usize::from(item.address - start);
            let own = &bytes[first..first + usize::from(item.width)];
            values.push((*item, item.decode(own)));
            at = item.end();
        }
        Ok(values)
    }

    /// Returns true if an address is kept without power.
    pub(super) const fn is_kept(&self, address: u16) -> bool {
        address < self.ram
    }
}
