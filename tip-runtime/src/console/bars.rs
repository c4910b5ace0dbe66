//! A bar graph in one line of text.

use core::fmt;

/// The bars of a graph, each as a share of the full height: −1…1. `Display` writes one character
/// for each bar, as high as the bar is long, whatever its sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bars<'a>(pub &'a [f64]);

const HEIGHTS: [char; 8] = ['▁', '▂', '▃', '▄', '▅', '▆', '▇', '█'];

impl fmt::Display for Bars<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for share in self.0 {
            let steps = libm::round(libm::fabs(*share).min(1.0) * (HEIGHTS.len() - 1) as f64);
            let height = HEIGHTS.get(steps as usize).unwrap_or(&'▁');
            write!(f, "{height}")?;
        }
        Ok(())
    }
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use super::Bars;
    use std::string::ToString;

    // clauses: 7.48
    #[test]
    fn a_bar_is_as_high_as_its_share() {
        assert_eq!(Bars(&[0.0, 0.5, -0.5, 1.0, -9.0]).to_string(), "▁▅▅██");
        assert_eq!(Bars(&[0.07, 0.08, f64::NAN]).to_string(), "▁▂█");
        assert_eq!(Bars(&[]).to_string(), "");
    }
}
