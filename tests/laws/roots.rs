//! Laws of roots: of products of known factors, and of whatever coefficients there are.

use crate::strategies::cases;
use proptest::collection::{btree_map, vec};
use proptest::prelude::*;
use proptest::sample::select;
use symspline::roots::{Polynomial, Root, RootValue, Roots, Solvable};
use symspline::{Error, Function, Q, Result, Scalar, SplineSpace};

/// Places that polynomials on `[-1, 2]` may have roots at: the ends, near each other, with long denominators.
fn places() -> impl Strategy<Value = Q> {
    let near = |n: i64| Q::frac(1, 3) + Q::frac(n, 1_000_000_000);
    let fixed = vec![Q::int(-1), Q::int(2), Q::int(0), Q::frac(1, 2), near(0), near(1), near(2)];
    prop_oneof![
        3 => select(fixed),
        1 => (-7_i64..=14, Just(7)).prop_map(|(n, d)| Q::frac(n, d)),
        1 => (0_i64..=1_000_000_007).prop_map(|n| Q::frac(n, 1_000_000_007)),
    ]
}

/// Places with multiplicities.
fn factors() -> impl Strategy<Value = Vec<(Q, usize)>> {
    btree_map(places(), 1_usize..=4, 0..=3).prop_map(|map| map.into_iter().collect())
}

/// The product of the powers of `x - root` and of the factors with these Bernstein coefficients, on `[-1, 2]`.
fn product(roots: &[(Q, usize)], others: &[&[Q]]) -> Result<Polynomial<Q>> {
    let (a, b) = (Q::int(-1), Q::int(2));
    let factor = |c: &[Q]| Function::new(SplineSpace::bezier(c.len() - 1, a.clone(), b.clone())?, c.to_vec());
    let mut product = factor(&[Q::int(1)])?;
    for (root, multiplicity) in roots {
        for _ in 0..*multiplicity {
            product = product.times(&factor(&[a.clone() - root, b.clone() - root])?)?;
        }
    }
    for c in others {
        product = product.times(&factor(c)?)?;
    }
    Polynomial::new(a.clone(), b.clone(), product.into_coeffs())
}

fn known<T: Solvable>(roots: Roots<T>) -> Vec<Root<T>> {
    let Roots::At(roots) = roots else { panic!("the polynomial is not zero") };
    roots
}

/// `x² - n` on `[-1, 2]`.
fn square_less(n: &Q) -> [Q; 3] {
    [Q::int(1) - n, Q::int(-2) - n, Q::int(4) - n]
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn all_roots_of_a_product_are_found(roots in factors(), positive: bool) {
        // x² + 1 has no root.
        let other = square_less(&Q::int(-1));
        let polynomial = product(&roots, &[&other[..]][..usize::from(positive)])?;
        let root = |(x, multiplicity): &(Q, usize)| Root { value: RootValue::Exact(x.clone()), multiplicity: *multiplicity };
        prop_assert_eq!(known(polynomial.roots()), roots.iter().map(root).collect::<Vec<_>>());
    }

    #[test]
    fn irrational_roots_are_enclosed_alone(roots in factors(), n in 2_i64..4, twice: bool) {
        let other = square_less(&Q::int(n));
        let polynomial = product(&roots, &[&other[..]; 2][..1 + usize::from(twice)])?;
        let found = known(polynomial.roots());
        let enclosed = |root: &&Root<Q>| matches!(root.value, RootValue::Enclosed(..));
        let Some(root) = found.iter().find(enclosed) else { return Err(TestCaseError::fail("not found")) };
        prop_assert_eq!((found.len(), root.multiplicity), (roots.len() + 1, 1 + usize::from(twice)));
        for width in [Q::int(1), Q::frac(1, 1 << 40)] {
            let narrow = root.narrowed(&polynomial, &width)?;
            let (low, high) = narrow.value.bounds();
            prop_assert!(low * low < Q::int(n) && Q::int(n) < high * high && high - low <= width);
            prop_assert!(roots.iter().all(|(x, _)| x <= low || high <= x));
        }
        for bad in [Q::int(0), Q::int(-1)] {
            prop_assert!(matches!(root.narrowed(&polynomial, &bad), Err(Error::BadTolerance { .. })), "{}", bad);
        }
    }

    #[test]
    fn roots_are_between_changes_of_sign(c in vec(-9_i64..=9, 1..10), (a, n) in (-3_i64..3, 1_i64..5)) {
        let polynomial = Polynomial::new(Q::int(a), Q::int(a + n), c.iter().map(|c| Q::int(*c)).collect())?;
        let Roots::At(found) = polynomial.roots() else {
            prop_assert!(c.iter().all(|c| *c == 0));
            return Ok(());
        };
        // Enclosures are in order and apart; signs change at odd roots and nowhere else.
        let ends: Vec<&Q> = found.iter().flat_map(|root| [root.value.bounds().0, root.value.bounds().1]).collect();
        prop_assert!(ends.windows(2).all(|pair| pair[0] <= pair[1]));
        for root in &found {
            match &root.value {
                RootValue::Exact(x) => prop_assert_eq!(polynomial.at(x), Q::int(0)),
                RootValue::Enclosed(low, high) => {
                    let signs = polynomial.at(low) * polynomial.at(high);
                    let ends = polynomial.domain();
                    // An end of the interval may be a root itself.
                    prop_assert!(low < high && (signs == Q::int(0) && (low == ends.0 || high == ends.1)
                        || signs.is_negative() == (root.multiplicity % 2 == 1)));
                }
            }
        }
        let inside = found.iter().filter(|root| {
            let (low, high) = root.value.bounds();
            low != high || (low != polynomial.domain().0 && low != polynomial.domain().1)
        });
        let count: usize = inside.map(|root| root.multiplicity).sum();
        prop_assert!(count <= polynomial.variations() && (polynomial.variations() - count).is_multiple_of(2));
        let first = c.iter().find(|c| **c != 0).expect("the polynomial is not zero");
        for i in 1..40 {
            let x = Q::int(a) + Q::frac(n * i, 40);
            let known = found.iter().all(|root| *root.value.bounds().1 < x || x < *root.value.bounds().0);
            if known {
                let before = found.iter().filter(|root| {
                    *root.value.bounds().1 < x && *root.value.bounds().1 != Q::int(a)
                });
                let flips: usize = before.map(|root| root.multiplicity).sum();
                prop_assert_eq!(polynomial.at(&x).is_negative(), (*first < 0) != (flips % 2 == 1));
            }
        }
    }

    #[test]
    fn floats_are_the_nearest_to_the_exact_roots(
        c in vec(prop_oneof![4 => -1.0_f64..1.0, 1 => Just(0.0), 1 => (-4_i8..4).prop_map(f64::from)], 1..9),
        a in prop_oneof![Just(0.0), -10.0_f64..10.0],
        width in prop_oneof![Just(1.0), 1e-3_f64..1e3],
    ) {
        let polynomial = Polynomial::new(a, a + width, c.clone())?;
        let image = |x: &f64| Q::try_from(*x);
        let exact = c.iter().map(image).collect::<Result<Vec<Q>>>()?;
        let exact = Polynomial::new(image(&a)?, image(&(a + width))?, exact)?;
        let (Roots::At(floats), Roots::At(roots)) = (polynomial.roots(), exact.roots()) else {
            prop_assert!(c.iter().all(|c| *c == 0.0));
            return Ok(());
        };
        prop_assert_eq!(floats.len(), roots.len());
        for (float, root) in floats.iter().zip(&roots) {
            prop_assert_eq!(float.multiplicity, root.multiplicity);
            let narrow = root.narrowed(&exact, &Q::frac(1, 1 << 62))?;
            let narrow = narrow.narrowed(&exact, &(Q::frac(1, 1 << 62) * Q::frac(1, 1 << 62)))?;
            let (low, high) = narrow.value.bounds();
            let RootValue::Exact(x) = float.value else { return Err(TestCaseError::fail("floats are values")) };
            prop_assert!(x == low.to_f64() || x == high.to_f64(), "{x} is not {low} or {high}");
        }
    }

    #[test]
    fn elevation_keeps_the_roots(roots in factors(), raise in 1_usize..4, n in 2_i64..4) {
        let polynomial = product(&roots, &[&square_less(&Q::int(n))])?;
        let raised = product(&roots, &[&square_less(&Q::int(n)), &vec![Q::int(1); raise + 1]])?;
        let width = Q::frac(1, 1 << 50);
        let all = |p: &Polynomial<Q>| -> Result<Vec<Root<Q>>> {
            known(p.roots()).iter().map(|root| root.narrowed(p, &width)).collect()
        };
        let (found, again) = (all(&polynomial)?, all(&raised)?);
        prop_assert_eq!(found.len(), again.len());
        for (one, two) in found.iter().zip(&again) {
            let ((a, b), (c, d)) = (one.value.bounds(), two.value.bounds());
            prop_assert!(one.multiplicity == two.multiplicity && a <= d && c <= b);
        }
    }
}

#[test]
fn zero_vanishes_everywhere() {
    let zero = Polynomial::new(Q::int(0), Q::int(1), vec![Q::int(0); 3]).unwrap();
    assert_eq!(zero.roots(), Roots::Everywhere);
    assert_eq!(Polynomial::new(0.0, 1.0, vec![0.0]).unwrap().roots(), Roots::Everywhere);
    assert_eq!(Polynomial::new(0.0, 1.0, vec![2.0]).unwrap().roots(), Roots::At(vec![]));
}

#[test]
fn what_is_no_polynomial_is_refused() {
    let make = |a: f64, b: f64, c: &[f64]| Polynomial::new(a, b, c.to_vec()).unwrap_err();
    assert!(matches!(make(1.0, 1.0, &[1.0]), Error::EmptyDomain { .. }));
    assert!(matches!(make(0.0, f64::NAN, &[1.0]), Error::NotFinite { what: "parameter", index: 1 }));
    assert!(matches!(make(0.0, 1.0, &[]), Error::CoefficientCount { .. }));
    assert!(matches!(
        make(0.0, 1.0, &[1.0, f64::INFINITY]),
        Error::NotFinite { what: "coefficient", index: 1 }
    ));
    assert!(matches!(make(0.0, 1.0, &[1.0; 600]), Error::DegreeTooHigh { .. }));
}

/// `Π (x - k / n)` for `k = 1 .. n`, Wilkinson's polynomial: ill-conditioned, and yet in exact arithmetic like any other.
#[test]
fn roots_of_wilkinsons_polynomial() {
    let roots: Vec<(Q, usize)> = (1..=16).map(|k| (Q::frac(k, 16), 1)).collect();
    let found = known(product(&roots, &[]).unwrap().roots());
    assert_eq!(
        found.iter().map(|root| root.value.bounds().0.clone()).collect::<Vec<_>>(),
        roots.iter().map(|r| r.0.clone()).collect::<Vec<_>>()
    );
}

/// The extremes of `f64`: nothing overflows on the way to a root.
#[test]
fn roots_of_extreme_floats() {
    let line = |a: f64, b: f64, c: f64, d: f64| {
        let found = known(Polynomial::new(a, b, vec![c, d]).unwrap().roots());
        found.iter().map(|root| *root.value.bounds().0).collect::<Vec<_>>()
    };
    assert_eq!(line(-1.0, 1.0, -f64::MAX, f64::MAX), [0.0]);
    assert_eq!(line(0.0, 1e-300, -5e-324, 5e-324), [5e-301]);
    assert_eq!(line(-1e308, 1e307, -1.0, 1.0), [-4.5e307]);
    let [c, d] = [1e-320, 1e300].map(|c| Q::try_from(c).unwrap());
    let root = Q::try_from(1e308).unwrap() * &c / (c + d);
    assert_eq!(line(0.0, 1e308, -1e-320, 1e300), [root.to_f64()]);
}
