//! Upper bounds of square roots.

use crate::exact::Q;
use num_bigint::BigInt;
use num_rational::BigRational;

/// The bits that a root has at least.
const BITS: u64 = 64;

/// A number not below the square root of `square`, at most one part in `2^63` above it: the root itself if it is rational.
///
/// `√(n / d) = √(n d 4^s) / (d 2^s)`, the integer root rounded up. Zero for what is not positive.
pub(crate) fn root_above(square: &Q) -> Q {
    if *square <= Q::from(0) {
        return Q::from(0);
    }
    let square = BigRational::from(square.clone());
    let product = square.numer() * square.denom();
    let shift = BITS.saturating_sub(product.bits() / 2);
    let scaled = product << (2 * shift);
    let floor: BigInt = scaled.sqrt();
    let ceiling = if &floor * &floor == scaled { floor } else { floor + 1 };
    Q::from(BigRational::new(ceiling, square.denom() << shift))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_bounds_and_sharp() {
        for (n, d) in [(2, 1), (1, 3), (10_i64.pow(17), 7), (3, 10_i64.pow(18))] {
            let square = Q::new(n, d).unwrap();
            let root = root_above(&square);
            assert!(&root * &root >= square);
            let below = root * Q::new((1 << 53) - 1, 1 << 53).unwrap();
            assert!(&below * &below < square);
        }
        assert_eq!(root_above(&Q::new(49, 81).unwrap()), Q::new(7, 9).unwrap());
        assert_eq!(root_above(&Q::from(0)), Q::from(0));
    }
}
