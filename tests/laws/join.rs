//! Laws of joining.

use crate::strategies::{ANY, SMOOTH, cases, curve, function, number, probes, space};
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{Error, Function, Q, Scalar, Spline};

/// A place strictly inside the domain, if the chosen one is.
fn inside(f: &Function<Q>, place: &Index) -> Option<Q> {
    let (a, b) = f.domain();
    Some(place.get(&probes(f.space())).clone()).filter(|x| a < x && x < b)
}

/// The spline moved so that it starts at the end of `f`.
fn behind(f: &Function<Q>, g: &Function<Q>) -> Result<Function<Q>, Error> {
    let ((_, b), (c, d)) = (f.domain(), g.domain());
    g.reparametrised(b, &(b.clone() + d - c))
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn what_is_split_joins(f in function(ANY), place in any::<Index>()) {
        let Some(x) = inside(&f, &place) else { return Ok(()) };
        let (left, right) = f.split(&x)?;
        prop_assert!(left.join(&right)?.same_function(&f)?);
    }

    #[test]
    fn what_is_split_joins_continuously(c in curve::<2>(SMOOTH.of_degree(1, 10)), place in any::<Index>()) {
        let Some(x) = inside(&c.coordinate(0)?, &place) else { return Ok(()) };
        let (left, right) = c.split(&x)?;
        let joined = left.join_continuous(&right)?;
        prop_assert!(joined.same_function(&c)?);
        let copies = joined.space().breaks().into_iter().find(|(t, _)| *t == x);
        prop_assert_eq!(copies, Some((x, c.degree())));
    }

    #[test]
    fn a_joined_spline_is_one_and_then_the_other(f in function(ANY), g in function(ANY)) {
        let g = behind(&f, &g)?;
        let joined = f.join(&g)?;
        prop_assert_eq!(joined.domain(), (f.domain().0, g.domain().1));
        prop_assert_eq!(joined.degree(), f.degree().max(g.degree()));
        let x = f.domain().1;
        prop_assert_eq!(joined.at(x)?, g.at(x)?);
        prop_assert_eq!(joined.at_left(x)?, f.at(x)?);
        prop_assert!(joined.restricted(f.domain().0, x)?.same_function(&f)?);
        prop_assert!(joined.restricted(x, g.domain().1)?.same_function(&g)?);
    }

    #[test]
    fn joining_associates(
        f in function(ANY.of_degree(0, 4)),
        g in function(ANY.of_degree(0, 4)),
        h in function(ANY.of_degree(0, 4)),
    ) {
        let g = behind(&f, &g)?;
        let h = behind(&g, &h)?;
        prop_assert!(f.join(&g)?.join(&h)?.same_function(&f.join(&g.join(&h)?)?)?);
    }

    #[test]
    fn only_ends_that_meet_join_continuously(f in function(ANY), g in function(ANY), level in number()) {
        let g = behind(&f, &g)?;
        let x = f.domain().1;
        let gap = f.at(x)? - g.at(x)? + &level;
        let near = g.translated(&gap)?;
        let joined = f.join_continuous(&near);
        if f.degree().max(g.degree()) == 0 {
            prop_assert!(matches!(joined, Err(Error::DegreeTooLow { degree: 0, needed: 1 })), "{joined:?}");
        } else if level == Q::int(0) {
            prop_assert!(joined?.same_function(&f.join(&near)?)?);
        } else {
            prop_assert!(matches!(joined, Err(Error::EndsDoNotMeet { .. })), "{joined:?}");
        }
    }

    #[test]
    fn domains_that_do_not_meet_are_refused(f in function(ANY), gap in (1_i64..9, 1_i64..9)) {
        let (a, b) = f.domain();
        let gap = Q::frac(gap.0, gap.1);
        let far = f.reparametrised(&(b.clone() + &gap), &(b.clone() + b - a + gap))?;
        for joined in [f.join(&far), f.join_continuous(&far), f.join(&f)] {
            prop_assert!(matches!(joined, Err(Error::DomainMismatch { .. })), "{joined:?}");
        }
    }

    #[test]
    fn constants_join_to_a_constant(space in space(ANY.of_degree(1, 10)), level in number()) {
        let f = Spline::constant(space, level.clone())?;
        let joined = f.join_continuous(&behind(&f, &f)?)?;
        prop_assert!(joined.coeffs().iter().all(|c| *c == level));
    }
}
