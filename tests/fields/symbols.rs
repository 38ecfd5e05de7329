//! Operators over fractions in a symbol: whether a number takes its place before or after makes no difference.

use crate::fraction::Fraction;
use nalgebra::SVector;
use symspline::{Curve, Error, Function, Q, Result, Scalar, Scale, Spline, SplineSpace};

/// `a + b x`.
fn line(a: i64, b: i64) -> Fraction {
    Fraction::int(a) + Fraction::int(b) * Fraction::symbol()
}

/// Spaces of every kind on `[0, 4 + x]` whose knots contain the symbol.
fn spaces() -> Result<Vec<SplineSpace<Fraction>>> {
    let (a, b) = (line(0, 0), line(4, 1));
    let inner = [line(1, 1), line(2, 0), line(2, 0), line(3, -1)];
    let knots = |inner: &[Fraction]| -> Vec<Fraction> {
        std::iter::once(&a).chain(inner).chain([&b]).cloned().collect()
    };
    let outer = [[line(-3, 0), line(-1, -1)], [line(4, 2), line(5, 0)]];
    Ok(vec![
        SplineSpace::clamped(0, knots(&inner[..2]))?,
        SplineSpace::clamped(1, knots(&inner))?,
        SplineSpace::clamped(2, knots(&inner[..1]))?,
        SplineSpace::clamped(2, knots(&inner[1..3]))?,
        SplineSpace::clamped(2, knots(&inner[..2]))?.with_outer_knots(&outer[0], &outer[1])?,
        SplineSpace::periodic(2, [a.clone(), inner[0].clone(), inner[1].clone()], b.clone())?,
    ])
}

/// A coefficient for each place, some of them fractions.
fn coeff(i: usize) -> Fraction {
    let i = i as i64;
    line(2 * i % 7 - 3, i % 3) / line(1 + i % 2, i % 4)
}

fn functions() -> Result<Vec<Function<Fraction>>> {
    let fill = |space: SplineSpace<Fraction>| {
        let coeffs = (0..space.dim()).map(coeff).collect();
        Function::new(space, coeffs)
    };
    spaces()?.into_iter().map(fill).collect()
}

/// Numbers for the symbol that leave the knots in their order.
fn numbers() -> [Q; 3] {
    [Q::frac(1, 1000), Q::frac(1, 3), Q::frac(2, 5)]
}

/// Runs an operator before and after a number is put in place of the symbol.
macro_rules! commutes {
    ($($f:ident = $given:expr),*; $operator:expr) => {{
        let symbolic = {
            $(let $f = $given.clone();)*
            $operator
        };
        for x in numbers() {
            let expected = {
                $(let $f = $given.map_scalars(|c| c.at(&x))?;)*
                $operator
            };
            assert_eq!(symbolic.map_scalars(|c| c.at(&x))?, expected);
        }
    }};
}

#[test]
fn derivatives_commute_with_substitution() -> Result<()> {
    for f in functions()?.into_iter().filter(|f| f.space().derivative_space().is_ok()) {
        commutes!(f = f; f.derivative()?);
    }
    Ok(())
}

#[test]
fn elevation_and_insertion_commute_with_substitution() -> Result<()> {
    for f in functions()? {
        commutes!(f = f; f.elevated(2)?);
        commutes!(f = f; f.clamped_ends()?);
        // A number, the middle of a span that contains the symbol, and over again.
        commutes!(f = f; f.inserted(&[Scalar::frac(1, 2)])?);
        commutes!(f = f; f.embedded(&f.space().bisected()?.bisected()?)?);
    }
    Ok(())
}

#[test]
fn sums_and_products_commute_with_substitution() -> Result<()> {
    for f in functions()? {
        for g in functions()? {
            commutes!(f = f, g = g; f.sum(&g)?);
            commutes!(f = f, g = g; f.times(&g)?);
        }
    }
    Ok(())
}

#[test]
fn integrals_commute_with_substitution() -> Result<()> {
    for f in functions()? {
        let integral = f.integral()?;
        for x in numbers() {
            assert_eq!(integral.at(&x)?, f.map_scalars(|c| c.at(&x))?.integral()?);
        }
        if !f.space().is_periodic() {
            commutes!(f = f; f.antiderivative()?);
        }
    }
    Ok(())
}

#[test]
fn fine_tuning_commutes_with_substitution() -> Result<()> {
    for (c, alpha) in functions()?.into_iter().zip(functions()?.into_iter().rev()) {
        let lift = |f: &Function<Fraction>| -> Result<Curve<Fraction, 2>> {
            let point = |(i, c): (usize, &Fraction)| SVector::from([c.clone(), line(i as i64, 0)]);
            Spline::new(f.space().clone(), f.coeffs().iter().enumerate().map(point).collect())
        };
        let curve = lift(&c)?;
        if curve.space().derivative_space().is_ok() {
            commutes!(curve = curve, alpha = alpha; curve.fine_tuned(Scale::Signed(&alpha))?);
        }
    }
    Ok(())
}

#[test]
fn the_integral_of_a_hat_over_a_symbol_is_a_formula() -> Result<()> {
    // The hat over 0, 1 + x, 3 has the area 3/2 wherever its top is; its square one of 1; times the line x its moment
    // is (0 + (1 + x) + 3) / 3 times the area, that is 2 + x / 2.
    let hat = Function::new(
        SplineSpace::clamped(1, [line(0, 0), line(1, 1), line(3, 0)])?,
        [0, 1, 0].map(Fraction::int).to_vec(),
    )?;
    assert_eq!(hat.integral()?, Fraction::frac(3, 2));
    assert_eq!(hat.times(&hat)?.integral()?, Fraction::int(1));
    let identity = Function::monomial(1, line(0, 0), line(3, 0))?;
    assert_eq!(hat.times(&identity)?.integral()?, Fraction::int(2) + Fraction::symbol() / Fraction::int(2));
    Ok(())
}

#[test]
fn ranges_are_enclosed_over_symbols_too_but_not_to_the_infinitely_small() -> Result<()> {
    for f in functions()? {
        let range = f.range(&Fraction::frac(1, 100))?;
        assert!(range.least.value.clone() - &range.least.bound <= Fraction::frac(1, 100));
        for x in numbers().into_iter().take(1) {
            let exact = f.map_scalars(|c| c.at(&x))?.range(&Q::frac(1, 100))?;
            assert!(range.least.bound.at(&x)? <= exact.least.value);
        }
    }
    // The least value is at 1/3, which halving never meets.
    let parabola = Function::new(
        SplineSpace::bezier(2, line(0, 0), line(1, 0))?,
        vec![line(0, 0), line(-3, 0), line(3, 0)],
    )?;
    assert!(matches!(parabola.range(&Fraction::symbol()), Err(Error::BadTolerance { .. })));
    Ok(())
}
