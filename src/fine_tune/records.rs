//! How low a descent has come, so that it ends where rounding allows no more.

/// After so many steps that come to no lower value and no smaller gradient than any before, rounding allows no more.
const IDLE: usize = 50;
/// By how much values that are equal but for rounding may differ, relatively. A sum of squares loses more digits than its own size
/// tells.
pub(crate) const ROUNDING: f64 = 1e-12;

/// The least value and gradient so far, and for how many steps there was nothing less.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Records {
    value: f64,
    square: f64,
    idle: usize,
}

impl Records {
    pub(crate) fn new() -> Self {
        Self { value: f64::INFINITY, square: f64::INFINITY, idle: 0 }
    }

    /// Counts a step, and says whether so many were in vain that more would be too. Values within rounding are equal.
    pub(crate) fn end(&mut self, value: f64, square: f64) -> bool {
        let lower = self.value == f64::INFINITY || value < self.value - ROUNDING * self.value.abs();
        let flatter = square < self.square;
        if lower {
            self.value = value;
        }
        if flatter {
            self.square = square;
        }
        self.idle = if lower || flatter { 0 } else { self.idle + 1 };
        self.idle > IDLE
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_in_vain_are_counted_until_one_is_not() {
        let mut records = Records::new();
        assert!(!records.end(1.0, 1.0));
        assert!((0..IDLE).all(|_| !records.end(1.0, 1.0)));
        // A smaller gradient, then a lower value.
        assert!(!records.end(1.0, 0.5));
        assert!((0..IDLE).all(|_| !records.end(1.0 - 1e-14, 0.5)));
        assert!(!records.end(0.9, 2.0));
        assert!((0..IDLE).all(|_| !records.end(0.9, 2.0)));
        assert!(records.end(0.9, 2.0));
    }
}
