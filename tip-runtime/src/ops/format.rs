//! Number formatting. The floats of `core::fmt` would do, except for bounds checks: a MESSAGE would
//! bring panic paths into a control cycle.

use core::fmt::{self, Write};

/// Maximum number of decimals.
const DECIMALS: u8 = 7;
/// Maximum number of groups of nine decimal digits: the largest number has 309 digits.
const GROUPS: usize = 35;
/// Groups of nine decimal digits, the least significant first.
type Digits = [u32; GROUPS];
/// The base of a group of nine digits.
const BASE: u64 = 1_000_000_000;
/// Number of bits by which nine digits can be shifted within 64 bits.
const SHIFT: u32 = 32;

/// A value in the format of MESSAGE: truncated without decimals, otherwise rounded (T.I.P. 3.1
/// §7-9-4).
#[derive(Clone, Copy, Debug)]
pub struct FormattedNumber {
    /// The value.
    pub value: f64,
    /// Digits after the point, 0…7.
    pub decimals: u8,
}

impl fmt::Display for FormattedNumber {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.decimals == 0 {
            // Adding zero turns −0 into 0.
            write_fixed(f, libm::trunc(self.value) + 0.0, 0)
        } else {
            write_fixed(f, self.value, self.decimals.min(DECIMALS))
        }
    }
}

/// A part of a line that MESSAGE shows.
#[derive(Clone, Copy, Debug)]
pub enum Part<'a> {
    /// Literal text.
    Text(&'a str),
    /// A value and its number of decimals.
    Number(f64, u8),
}

/// The line of a MESSAGE. Generated code has one function for all of them, where `format_args!`
/// would make several for each.
#[derive(Clone, Copy, Debug)]
pub struct Message<'a>(pub &'a [Part<'a>]);

impl fmt::Display for Message<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for part in self.0 {
            match *part {
                Part::Text(text) => f.write_str(text)?,
                Part::Number(value, decimals) => FormattedNumber { value, decimals }.fmt(f)?,
            }
        }
        Ok(())
    }
}

/// Formats like `printf("%.*f")`: from the exact binary value, ties to even.
fn write_fixed(f: &mut fmt::Formatter<'_>, value: f64, decimals: u8) -> fmt::Result {
    if value.is_nan() {
        return f.write_str("NaN");
    }
    if value.is_sign_negative() {
        f.write_char('-')?;
    }
    if value.is_infinite() {
        return f.write_str("inf");
    }
    // IEEE 754: value = mantissa · 2^(exponent − 1075), with a hidden bit unless subnormal.
    let (mantissa, exponent) = match (value.to_bits() & (u64::MAX >> 12), exponent(value)) {
        (mantissa, 0) => (mantissa, 1),
        (mantissa, exponent) => (mantissa | 1 << 52, exponent),
    };
    match exponent.checked_sub(1075) {
        Some(doublings) => {
            write_whole(f, mantissa, doublings)?;
            write_fraction(f, 0, decimals)
        }
        None => {
            let (whole, fraction) = split(mantissa, 1075 - exponent, decimals);
            write_whole(f, whole, 0)?;
            write_fraction(f, fraction, decimals)
        }
    }
}

const fn exponent(value: f64) -> u32 {
    (value.to_bits() >> 52) as u32 & 0x7FF
}

/// Returns the whole part of `mantissa` / 2^`halvings`, and the rest in units of the last decimal,
/// rounded.
fn split(mantissa: u64, halvings: u32, decimals: u8) -> (u64, u64) {
    let whole = mantissa.checked_shr(halvings).unwrap_or(0);
    let rest = mantissa ^ whole.checked_shl(halvings).unwrap_or(0);
    let unit = 10_u64.pow(u32::from(decimals));
    let fraction = halved(u128::from(rest) * u128::from(unit), halvings) as u64;
    if fraction == unit {
        (whole + 1, 0)
    } else {
        (whole, fraction)
    }
}

/// Returns `number` / 2^`halvings`, rounded, ties to even; `number` is below 2^127, `halvings` is
/// not 0.
fn halved(number: u128, halvings: u32) -> u128 {
    let Some(half) = 1_u128.checked_shl(halvings - 1) else {
        return 0;
    };
    let whole = number.checked_shr(halvings).unwrap_or(0);
    let rest = number & (half | (half - 1));
    if rest > half || (rest == half && whole & 1 == 1) {
        whole + 1
    } else {
        whole
    }
}

/// Writes `mantissa` · 2^`doublings` in full.
fn write_whole(f: &mut fmt::Formatter<'_>, mantissa: u64, mut doublings: u32) -> fmt::Result {
    let mut digits = in_decimal(mantissa);
    while doublings > 0 {
        let bits = doublings.min(SHIFT);
        shift(&mut digits, bits);
        doublings -= bits;
    }
    let mut groups = digits.iter().rev().skip_while(|digits| **digits == 0);
    write!(f, "{}", groups.next().unwrap_or(&0))?;
    groups.try_for_each(|digits| write!(f, "{digits:09}"))
}

fn in_decimal(mut number: u64) -> Digits {
    [(); GROUPS].map(|()| {
        let digits = (number % BASE) as u32;
        number /= BASE;
        digits
    })
}

/// Multiplies by 2^`bits`, at most 2^`SHIFT`.
fn shift(digits: &mut Digits, bits: u32) {
    let mut carry = 0;
    for digits in digits {
        let shifted = (u64::from(*digits) << bits) + carry;
        *digits = (shifted % BASE) as u32;
        carry = shifted / BASE;
    }
}

/// Writes the decimal point and the decimals; nothing without decimals.
fn write_fraction(f: &mut fmt::Formatter<'_>, fraction: u64, decimals: u8) -> fmt::Result {
    if decimals == 0 {
        return Ok(());
    }
    f.write_char('.')?;
    let mut rest = fraction * 10_u64.pow(u32::from(DECIMALS - decimals));
    for _ in 0..decimals {
        f.write_char(char::from(b'0' + (rest / 1_000_000) as u8))?;
        rest = rest % 1_000_000 * 10;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;
    extern crate std;
    use std::format;
    use std::string::{String, ToString};

    fn shown(value: f64, decimals: u8) -> String {
        FormattedNumber { value, decimals }.to_string()
    }

    #[test]
    fn ties_go_to_even_and_only_true_ties_are_ties() {
        assert_eq!(shown(0.125, 2), "0.12");
        assert_eq!(shown(0.375, 2), "0.38");
        // 0.15 is a little less in binary, 0.45 a little more.
        assert_eq!(shown(0.15, 1), "0.1");
        assert_eq!(shown(0.45, 1), "0.5");
    }

    #[test]
    fn rounding_carries_into_the_whole_part() {
        assert_eq!(shown(9.999_999_96, 7), "10.0000000");
        assert_eq!(shown(-0.96, 1), "-1.0");
        assert_eq!(shown(-0.96, 0), "0");
    }

    #[test]
    fn every_digit_of_a_large_number_is_exact() {
        assert_eq!(shown(1e23, 0), "99999999999999991611392");
        assert_eq!(shown(2.0_f64.powi(70), 1), "1180591620717411303424.0");
    }

    /// `core::fmt` rounds as the language asks for, but has bounds checks.
    #[test]
    fn it_is_the_text_of_core() {
        let mut random = Random::new(1);
        for _ in 0..20_000 {
            // Any bits, and numbers of a robot's size.
            let bits = random.next_u64();
            for value in [f64::from_bits(bits), (bits as i32) as f64 / 65536.0] {
                assert_eq!(shown(value, 3), format!("{value:.3}"));
                assert_eq!(shown(value, 7), format!("{value:.7}"));
                assert_eq!(shown(value, 0), format!("{:.0}", libm::trunc(value) + 0.0));
            }
        }
    }
}
