//! [Miura] sections 2.2 and 2.3, Fig. 8(a) and (b): two local steps on a quadratic curve, tangents held, a linear scale
//! function each, the degree reduced after each. The paper gives no numbers; the curve is made up.

use crate::point;
use nalgebra::SVector;
use symspline::{Coeff, Curve, Function, Hold, Q, Result, Scalar, SplineSpace};

/// An eye: a quadratic curve with simple knots 0, 1, ..., 8.
fn eye() -> Result<Curve<Q, 2>> {
    let points = [[0, 0], [2, 3], [5, 5], [9, 5], [12, 3], [13, 0], [10, -2], [6, -3], [3, -2], [1, -1]];
    Curve::new(SplineSpace::uniform(2, 8, Q::int(0), Q::int(8))?, points.map(point).to_vec())
}

fn line(a: Q, b: Q, values: [Q; 2]) -> Result<Function<Q>> {
    Function::new(SplineSpace::bezier(1, a, b)?, values.to_vec())
}

/// The squared distance of two curves at `x`.
fn gap(f: &Curve<Q, 2>, g: &Curve<Q, 2>, x: &Q) -> Result<Q> {
    let difference: SVector<Q, 2> = f.at(x)? - g.at(x)?;
    Ok(difference.squared_size())
}

#[test]
fn two_local_steps_keep_a_quadratic_curve_quadratic() -> Result<()> {
    let tolerance = Q::frac(1, 100);
    let mut curve = eye()?;
    // The second portion holds the first and a neighbouring region.
    let steps = [
        line(Q::frac(3, 2), Q::frac(9, 2), [Q::int(1), Q::frac(3, 2)])?,
        line(Q::frac(1, 2), Q::int(6), [Q::frac(3, 2), Q::int(1)])?,
    ];
    for alpha in steps {
        let (a, b) = alpha.domain();
        let local = curve.fine_tuned_on(&alpha, Hold::Tangents)?;
        let whole = local.joined()?;
        assert_eq!((local.tuned().curve.degree(), whole.degree()), (3, 3));
        let reduced = local.reduced(&tolerance)?;
        let near = reduced.spline;
        assert!(near.degree() == 2 && reduced.bound <= tolerance);
        // Simple knots at a and b, where the parabolas before and after go on with the same tangent.
        for x in [a, b] {
            let copies: Vec<usize> =
                near.space().breaks().into_iter().filter(|(t, _)| t == x).map(|(_, m)| m).collect();
            assert_eq!(copies, [1]);
            assert_eq!(near.derivatives_at(x, 1)?, curve.derivatives_at(x, 1)?);
        }
        for k in 0..=160 {
            let x = Q::frac(k, 20);
            assert!(gap(&near, &whole, &x)? <= reduced.bound.clone() * &reduced.bound);
            if x <= *a || *b <= x {
                assert_eq!(near.at(&x)?, curve.at(&x)?);
            }
        }
        curve = near;
    }
    // Knots only where the error asked for them.
    assert!(curve.space().dim() <= 24, "{} control points", curve.space().dim());
    Ok(())
}

/// Fig. 6: with more held, less changes: at the ends derivatives of orders 0, 1, 2 stay.
#[test]
fn more_held_agrees_more() -> Result<()> {
    let curve = eye()?.elevated(1)?;
    let values = [1, 3, 3, 1].map(Q::int).to_vec();
    let alpha = Function::new(SplineSpace::uniform(2, 2, Q::int(2), Q::int(5))?, values)?;
    let (a, b) = alpha.domain();
    for (order, hold) in [(0, Hold::Points), (1, Hold::Tangents), (2, Hold::Curvatures)] {
        let whole = curve.fine_tuned_on(&alpha, hold)?.joined()?;
        for x in [a, b] {
            let derivatives = [&whole, &curve].map(|c| c.derivatives_at(x, 3));
            let [new, old] = derivatives.map(|all| all.expect("parameters inside the domain"));
            let agree = new.iter().zip(&old).take_while(|(new, old)| new == old).count();
            // At b derivatives are those of the curve after it.
            assert_eq!(agree, if x == a { order + 1 } else { 4 }, "{hold:?} at {x}");
        }
    }
    Ok(())
}
