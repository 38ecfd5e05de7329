//! Powers of two that bring coordinates to unit size, so that no square leaves the range of numbers.

/// Multiplication by a power of two, and back.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scale {
    exponent: i32,
}

impl Scale {
    /// The scale in which `size`, which is not negative, is at least 1/2 and less than 1, or below that if it is not a
    /// normal number; that of zero leaves numbers as they are.
    pub(super) fn of(size: f64) -> Self {
        let exponent = match (size.to_bits() >> 52) as i32 {
            // Zero and the numbers below the normal ones.
            0 if size == 0.0 => 0,
            0 => -1022,
            biased => biased - 1022,
        };
        Self { exponent }
    }

    /// The number at unit size.
    #[inline]
    pub(super) fn down(self, x: f64) -> f64 {
        shifted(x, -self.exponent)
    }

    /// The number as it was.
    #[inline]
    pub(super) fn up(self, x: f64) -> f64 {
        shifted(x, self.exponent)
    }
}

/// `x 2^exponent` in two steps, since the power may be out of range where the product is not.
#[inline]
fn shifted(x: f64, exponent: i32) -> f64 {
    let half = exponent / 2;
    x * power_of_two(half) * power_of_two(exponent - half)
}

/// `2^exponent` for exponents of normal numbers.
#[inline]
fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_size_comes_to_one() {
        for size in [f64::MAX, 1e300, 3.0, 1.0, 0.5, 1e-300, f64::MIN_POSITIVE, 5e-324] {
            let scale = Scale::of(size);
            let unit = scale.down(size);
            assert!((0.5..1.0).contains(&unit) || size < f64::MIN_POSITIVE, "{size}: {unit}");
            assert_eq!(scale.up(unit), size);
        }
        assert_eq!(Scale::of(0.0).down(3.0), 3.0);
    }
}
