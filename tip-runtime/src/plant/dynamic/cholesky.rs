//! Cholesky's method for symmetric, positive definite systems of equations, without a panic path.

/// The lower triangle of a matrix's Cholesky factor, row by row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CholeskyFactor<const N: usize>([[f64; N]; N]);

impl<const N: usize> CholeskyFactor<N> {
    /// Factorises a matrix, of which only the lower triangle is read; `None` if it is not positive
    /// definite.
    pub(super) fn of(mut rows: [[f64; N]; N]) -> Option<Self> {
        for i in 0..N {
            let (done, rest) = rows.split_at_mut_checked(i)?;
            let row = rest.first_mut()?;
            for (k, other) in done.iter().enumerate() {
                let known = dot(row, other, k);
                let entry = row.get_mut(k)?;
                *entry = (*entry - known) / other.get(k)?;
            }
            let known = dot(row, row, i);
            let own = row.get_mut(i)?;
            let square = *own - known;
            if square.is_nan() || square <= 0.0 {
                return None;
            }
            *own = libm::sqrt(square);
        }
        Some(CholeskyFactor(rows))
    }

    /// Solves the lower triangular system: the forward substitution of `right`.
    pub(super) fn forward_substitute(&self, mut right: [f64; N]) -> [f64; N] {
        for (i, row) in self.0.iter().enumerate() {
            let known = dot(row, &right, i);
            if let (Some(own), Some(pivot)) = (right.get_mut(i), row.get(i)) {
                *own = (*own - known) / pivot;
            }
        }
        right
    }

    /// Solves the whole system.
    pub(super) fn solve(&self, right: [f64; N]) -> [f64; N] {
        let mut half = self.forward_substitute(right);
        for (i, row) in self.0.iter().enumerate().rev() {
            let below = self.0.iter().zip(&half).skip(i + 1);
            let known: f64 = below
                .map(|(row, solved)| row.get(i).map_or(0.0, |entry| entry * solved))
                .sum();
            if let (Some(own), Some(pivot)) = (half.get_mut(i), row.get(i)) {
                *own = (*own - known) / pivot;
            }
        }
        half
    }
}

/// Returns the dot product of the first `count` entries.
pub(super) fn dot<const N: usize>(one: &[f64; N], other: &[f64; N], count: usize) -> f64 {
    let both = one.iter().zip(other).take(count);
    both.map(|(one, other)| one * other).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_solution_solves() {
        let matrix = [[4.0, 9.9, 9.9], [2.0, 5.0, 9.9], [-2.0, 1.0, 6.0]];
        let full = [[4.0, 2.0, -2.0], [2.0, 5.0, 1.0], [-2.0, 1.0, 6.0]];
        let factor = CholeskyFactor::of(matrix).expect("positive definite");
        let solved = factor.solve([1.0, -2.0, 3.0]);
        for (row, right) in full.iter().zip([1.0, -2.0, 3.0]) {
            assert!((dot(row, &solved, 3) - right).abs() < 1e-12);
        }
        assert_eq!(CholeskyFactor::of([[0.0]]), None);
        assert_eq!(CholeskyFactor::of([[1.0, 0.0], [2.0, 1.0]]), None);
    }
}
