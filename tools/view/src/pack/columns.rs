//! Columns of numbers.

use serde::Serialize;

/// The finest grid of what is rounded.
const FINEST: f64 = 0.01;

/// A column among the others.
#[derive(Debug, Serialize)]
pub(super) struct Column {
    name: String,
    kind: &'static str,
    count: usize,
    bytes: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    first: Option<i64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    grid: Option<f64>,
}

/// Columns one after the other.
#[derive(Debug, Default)]
pub(super) struct Columns {
    listed: Vec<Column>,
    bytes: Vec<u8>,
}

impl Columns {
    pub(super) fn finish(self) -> (Vec<Column>, Vec<u8>) {
        (self.listed, self.bytes)
    }

    fn add(&mut self, name: String, kind: &'static str, count: usize, bytes: &[u8]) -> &mut Column {
        self.bytes.extend_from_slice(bytes);
        self.listed.push(Column {
            name,
            kind,
            count,
            bytes: bytes.len(),
            first: None,
            grid: None,
        });
        let last = self.listed.len() - 1;
        &mut self.listed[last]
    }

    /// Whole numbers of 7 bits a byte, lowest first; all but the last byte of one have the highest bit.
    pub(super) fn numbers(&mut self, name: &str, values: impl Iterator<Item = u64>) {
        let mut bytes = Vec::new();
        let mut count = 0;
        for mut value in values {
            count += 1;
            while value > 0x7F {
                bytes.push(value as u8 | 0x80);
                value >>= 7;
            }
            bytes.push(value as u8);
        }
        self.add(name.to_owned(), "numbers", count, &bytes);
    }

    /// Numbers to the bit; the first bytes of all, then the second ones.
    pub(super) fn exact(&mut self, name: &str, values: impl Iterator<Item = f64>) {
        let values: Vec<_> = values.map(f64::to_le_bytes).collect();
        let planes = (0..8).flat_map(|plane| values.iter().map(move |value| value[plane]));
        let bytes: Vec<u8> = planes.collect();
        self.add(name.to_owned(), "exact", values.len(), &bytes);
    }

    /// Numbers rounded to a grid, as differences of 16 bits: all low bytes, then all high ones. The grid is as fine as
    /// the largest difference allows. What is not there, or not a number, is as before.
    pub(super) fn deltas(&mut self, name: String, values: impl Iterator<Item = Option<f64>>) {
        let mut last = 0.0;
        let values: Vec<f64> = values
            .map(|value| {
                last = value.filter(|value| value.is_finite()).unwrap_or(last);
                last
            })
            .collect();
        let (grid, first, deltas) = on_grid(&values);
        let low = deltas.iter().map(|delta| delta.to_le_bytes()[0]);
        let high = deltas.iter().map(|delta| delta.to_le_bytes()[1]);
        let bytes: Vec<u8> = low.chain(high).collect();
        let column = self.add(name, "deltas", deltas.len(), &bytes);
        (column.first, column.grid) = (Some(first), Some(grid));
    }
}

/// The finest grid on which all differences have 16 bits, the first number on it, and the differences.
fn on_grid(values: &[f64]) -> (f64, i64, Vec<i16>) {
    let mut grid = FINEST;
    loop {
        let places = || values.iter().map(|value| (value / grid).round() as i64);
        let first = places().next().unwrap_or(0);
        let mut last = first;
        let deltas =
            places().map(|place| i16::try_from(place - std::mem::replace(&mut last, place)));
        if let Ok(deltas) = deltas.collect() {
            return (grid, first, deltas);
        }
        grid *= 10.0;
    }
}

/// 0, -1, 1, -2, … as 0, 1, 2, 3, …
pub(super) const fn zigzag(value: i64) -> u64 {
    ((value << 1) ^ (value >> 63)) as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn jumps_make_the_grid_coarser_and_nothing_drifts() {
        let ramp: Vec<f64> = (0..1000).map(|n| f64::from(n) * 0.003).collect();
        for (values, expected) in [
            (ramp, 0.01),
            (vec![0.0, 327.0, 0.0], 0.01),
            (vec![0.0, 400.0], 0.1),
        ] {
            let (grid, first, deltas) = on_grid(&values);
            assert!((grid - expected).abs() < 1e-12, "{grid}");
            let mut place = first;
            for (value, delta) in values.iter().zip(deltas) {
                place += i64::from(delta);
                assert!((place as f64 * grid - value).abs() <= grid / 2.0 + 1e-9);
            }
        }
    }

    #[test]
    fn signs_alternate() {
        assert_eq!([0, -1, 1, -2, 2].map(zigzag), [0, 1, 2, 3, 4]);
        assert_eq!(zigzag(i64::MIN), u64::MAX);
    }
}
