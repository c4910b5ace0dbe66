//! A motion that was sampled in each control cycle, as few set points: the algorithm of Ramer, Douglas and Peucker over all joints at
//! once.

/// A sample of a motion.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Sample {
    /// Time, ms.
    pub(super) time: f64,
    /// Joint angles, deg.
    pub(super) angles: Vec<f64>,
}

/// Returns the angles at each control cycle from the first sample to the last, between samples by linear interpolation: set points
/// can be at whole cycles only.
pub(super) fn on_cycles(samples: &[Sample], period: f64) -> Vec<Vec<f64>> {
    let (Some(first), Some(last)) = (samples.first(), samples.last()) else {
        return vec![];
    };
    let cycles = ((last.time - first.time) / period).floor() as usize;
    let mut left = samples;
    let at = |cycle| {
        let time = first.time + cycle as f64 * period;
        while let [_, second, _, ..] = left
            && second.time < time
        {
            left = &left[1..];
        }
        match left {
            [from, to, ..] => {
                let part = (time - from.time) / (to.time - from.time).max(f64::MIN_POSITIVE);
                between(&from.angles, &to.angles, part.clamp(0.0, 1.0))
            }
            _ => first.angles.clone(),
        }
    };
    (0..=cycles).map(at).collect()
}

/// Returns the angles at a part of the way from one pose to another.
pub(super) fn between(from: &[f64], to: &[f64], part: f64) -> Vec<f64> {
    let pairs = from.iter().zip(to);
    pairs.map(|(from, to)| from + (to - from) * part).collect()
}

/// Returns the cycles whose angles, as they are `played`, keep every joint within `error` deg of each cycle, by linear interpolation
/// between them. The first and the last are among them.
pub(super) fn thin(cycles: &[Vec<f64>], played: &[Vec<f64>], error: f64) -> Vec<usize> {
    let Some(last) = cycles.len().checked_sub(1) else {
        return vec![];
    };
    let mut kept = vec![0, last];
    let mut open = vec![(0, last)];
    while let Some((from, to)) = open.pop() {
        let away = |cycle: usize| {
            let part = (cycle - from) as f64 / (to - from) as f64;
            let line = between(&played[from], &played[to], part);
            let joints = line.iter().zip(&cycles[cycle]);
            joints
                .map(|(line, own)| (line - own).abs())
                .fold(0.0, f64::max)
        };
        let inside = (from + 1..to).map(|cycle| (cycle, away(cycle)));
        let farthest = inside.max_by(|(_, one), (_, other)| one.total_cmp(other));
        if let Some((cycle, _)) = farthest.filter(|(_, away)| *away > error) {
            kept.push(cycle);
            open.extend([(from, cycle), (cycle, to)]);
        }
    }
    kept.sort_unstable();
    kept.dedup();
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use tip_runtime::random::Random;

    /// Returns the largest distance of a joint from the lines between the kept cycles, deg.
    fn distance(cycles: &[Vec<f64>], played: &[Vec<f64>], kept: &[usize]) -> f64 {
        let mut most: f64 = 0.0;
        for pair in kept.windows(2) {
            let (from, to) = (&played[pair[0]], &played[pair[1]]);
            let way = &cycles[pair[0]..=pair[1]];
            for (number, cycle) in way.iter().enumerate() {
                let part = number as f64 / (way.len() - 1) as f64;
                for (joint, angle) in cycle.iter().enumerate() {
                    let line = from[joint] * (1.0 - part) + to[joint] * part;
                    most = most.max((line - angle).abs());
                }
            }
        }
        most
    }

    /// A hand that trembles: three joints on waves, with noise.
    fn waves(seed: u64, length: usize) -> Vec<Vec<f64>> {
        let mut random = Random::new(seed);
        let speeds = [random.within(1.0, 9.0), random.within(1.0, 9.0), 0.0];
        let at = |cycle| {
            let angle = |speed: f64| 40.0 * (speed * cycle as f64 / 100.0).sin();
            speeds
                .map(|speed| angle(speed) + random.within(-0.2, 0.2))
                .to_vec()
        };
        (0..length).map(at).collect()
    }

    #[test]
    fn every_sample_is_within_the_error() {
        for seed in 0..40 {
            let cycles = waves(seed, 300);
            let mut played = cycles.clone();
            for angle in played.iter_mut().flatten() {
                *angle = (*angle * 10.0).round() / 10.0;
            }
            for error in [0.3, 1.0, 5.0] {
                let kept = thin(&cycles, &played, error);
                assert!(
                    distance(&cycles, &played, &kept) <= error + 1e-9,
                    "{seed}: {error}"
                );
                assert_eq!((kept[0], *kept.last().expect("some")), (0, 299));
                if error == 5.0 {
                    assert!(kept.len() < 60, "{seed}: {} are kept", kept.len());
                }
            }
        }
    }

    /// A straight line needs its ends, a corner one point more, a motion without length one.
    #[test]
    fn nothing_is_kept_that_a_line_replaces() {
        let line: Vec<Vec<f64>> = (0..100)
            .map(|n| vec![f64::from(n), -0.5 * f64::from(n)])
            .collect();
        assert_eq!(thin(&line, &line, 0.1), [0, 99]);
        let corner: Vec<Vec<f64>> = (0..=100i32)
            .map(|n| vec![f64::from((n - 40).abs())])
            .collect();
        assert_eq!(thin(&corner, &corner, 0.5), [0, 40, 100]);
        assert_eq!(thin(&line[..1], &line[..1], 1.0), [0]);
        assert_eq!(thin(&[], &[], 1.0), [0; 0]);
    }

    /// Samples at 0, 15 and 40 ms, of a cycle of 10 ms: at 10 ms two thirds of the way to 30, at 30 ms three fifths from there to 0.
    #[test]
    fn cycles_lie_between_samples() {
        let sample = |time: f64, angle: f64| Sample {
            time,
            angles: vec![angle],
        };
        let samples = [sample(5.0, 0.0), sample(20.0, 30.0), sample(45.0, 0.0)];
        let cycles: Vec<f64> = on_cycles(&samples, 10.0).concat();
        let wanted = [0.0, 20.0, 24.0, 12.0, 0.0];
        assert_eq!(cycles.len(), wanted.len());
        for (found, wanted) in cycles.iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-9, "{cycles:?}");
        }
        assert_eq!(on_cycles(&samples[..1], 10.0), [[0.0]]);
    }
}
