//! A recording as bytes: a header in JSON, then columns of numbers, all of it deflated.

mod channels;
mod columns;
pub(crate) mod header;

use crate::recording::{At, Recording};
pub(crate) use channels::{Channel, channels};
pub(crate) use header::{each, event, values};

use columns::{Columns, zigzag};
use header::Header;

impl Recording {
    /// The bytes that the page unpacks (`page/src/unpack.js`): deflated (RFC 1951); first the header's length in 4 bytes,
    /// lowest first, then the header, then the columns that it lists. Motion is rounded to 0.01 mm, deg or N, or coarser
    /// where it jumps; all else is exact.
    pub fn packed(&self) -> Vec<u8> {
        let mut columns = Columns::default();
        self.pack_frames(&mut columns);
        columns.numbers("step.cycle", differences(&self.steps));
        let mut last = 0;
        let steps = self.steps.iter().map(|step| {
            let step = i64::from(step.what);
            zigzag(step - std::mem::replace(&mut last, step))
        });
        columns.numbers("step", steps);
        columns.numbers("contact.cycle", differences(&self.contacts));
        columns.numbers("contact", self.contacts.iter().map(|at| mask(&at.what)));
        columns.numbers("set.cycle", differences(&self.sets));
        columns.numbers(
            "set.scalar",
            self.sets.iter().map(|set| set.what.scalar as u64),
        );
        columns.exact("set.value", self.sets.iter().map(|set| set.what.value));
        let (listed, bytes) = columns.finish();
        let header = Header::of(self, &listed).to_json();
        let mut whole = (header.len() as u32).to_le_bytes().to_vec();
        whole.extend(header.into_bytes());
        whole.extend(bytes);
        miniz_oxide::deflate::compress_to_vec(&whole, 9)
    }

    fn pack_frames(&self, columns: &mut Columns) {
        let mut last = 0;
        let cycles = self.frames.iter();
        let cycles = cycles.map(|frame| frame.cycle - std::mem::replace(&mut last, frame.cycle));
        columns.numbers("frame", cycles);
        let Some(first) = self.frames.first() else {
            return;
        };
        for Channel { name, value } in channels(first) {
            columns.deltas(name, self.frames.iter().map(value));
        }
    }
}

/// How many cycles each is after the one before.
fn differences<T>(list: &[At<T>]) -> impl Iterator<Item = u64> {
    let mut last = 0;
    list.iter()
        .map(move |at| at.cycle - std::mem::replace(&mut last, at.cycle))
}

/// Which feet or fingertips touch something, the first one in the lowest bit.
pub(crate) fn mask(touch: &[bool]) -> u64 {
    let feet = touch.iter().rev();
    feet.fold(0, |mask, touches| mask << 1 | u64::from(*touches))
}
