//! Laws of seams put elsewhere.

use crate::strategies::{RING, cases, curve, probes};
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{Error, Function, Q, Scalar, SplineSpace};

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn a_seam_can_be_anywhere(c in curve::<2>(RING.of_degree(0, 4)), place in any::<Index>()) {
        let x = place.get(&probes(c.space())).clone();
        let turned = c.with_seam_at(&x)?;
        let ((start, end), period) = (c.domain(), c.domain().1.clone() - c.domain().0);
        prop_assert_eq!(turned.domain(), (&x, &(x.clone() + &period)));
        prop_assert!(turned.space().is_periodic());
        for (s, t) in [(start, &x), (&x, end)].into_iter().filter(|(s, t)| s < t) {
            let shift = if *t == x { period.clone() } else { Q::int(0) };
            let there = turned.restricted(&(s.clone() + &shift), &(t.clone() + &shift))?;
            prop_assert!(there.reparametrised(s, t)?.same_function(&c.restricted(s, t)?)?);
        }
        // Back again, and knots have the copies they had.
        let back = turned.with_seam_at(end)?.reparametrised(start, end)?;
        let inserted = if c.space().breaks().iter().any(|(t, _)| *t == x) { c.clone() } else { c.inserted(&[x])? };
        prop_assert_eq!(back, inserted);
    }
}

#[test]
fn the_old_seam_goes_to_the_old_end_without_rounding() -> symspline::Result<()> {
    // 0.8 + (3.6 - 0.8) is no 3.6 in floating point.
    let space = SplineSpace::periodic(2, [0.0, 1.0, 2.0], 4.0)?.reparametrised(&0.8, &3.6)?;
    let ring = Function::new(space, vec![1.0, 2.0, 4.0])?;
    assert_eq!(ring.with_seam_at(&0.8)?, ring);
    let turned = ring.with_seam_at(&2.0)?;
    assert!(turned.space().breaks().iter().any(|(t, _)| *t == 3.6));
    assert!((turned.at(&3.6)? - ring.at(&0.8)?).abs() < 1e-15);
    assert!(matches!(ring.with_seam_at(&4.0), Err(Error::OutsideDomain { .. })));
    assert_eq!(ring.clamped_ends()?.with_seam_at(&2.0).unwrap_err(), Error::NotPeriodic);
    Ok(())
}
