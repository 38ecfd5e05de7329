//! Shape tools: points moved by one and by two weights, derivatives by a weight, knots halfway between nodes.

use crate::check::{Answer, Golden, check, for_each, in_dimension, largest, row};
use crate::data::{Case, Field};
use nalgebra::SVector;
use symspline::{
    NurbsCurve, NurbsSurface, Q, Regime, Result, Weighed, WeightPairPull, WeightPull, cross_ratio,
};

fn curve<T: Field, const N: usize>(case: Case) -> Result<NurbsCurve<T, N>> {
    NurbsCurve::new(case.space("p", "U")?, case.get("P").points(), case.get("w").numbers())
}

fn expected_move(case: Case, share: &str) -> Answer<Q> {
    let numbers = ["w_new", share].map(|key| vec![case.get(key).number()]);
    let points = ["point", "point_new"].map(|key| case.get(key).numbers());
    Answer::rows(numbers.into_iter().chain(points).collect())
}

/// Weight and share, the point before, the point after.
fn moved<T: Field, S, const N: usize>(
    shape: &S,
    pull: &WeightPull<T, SVector<T, N>>,
    at: &S::Parameter,
    by: &T,
) -> Result<Answer<T>>
where
    S: Weighed<T, Point = SVector<T, N>>,
{
    let after = pull.applied(shape, by)?;
    assert_eq!(&pull.weight_for(by)?, after.weight(pull.index())?);
    let points = [shape, &after].map(|shape| shape.derivative_of(at, S::VALUE).map(row));
    let numbers = [pull.weight_for(by)?, pull.share()].map(|x| Ok(vec![x]));
    Ok(Answer::rows(numbers.into_iter().chain(points).collect::<Result<_>>()?))
}

struct One;

impl Golden for One {
    const CATEGORY: &'static str = "weight_one";
    const CASES: usize = 6;
    const FACTOR: f64 = 16.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        fn one<T: Field, const N: usize>(case: Case) -> Result<Answer<T>> {
            let (curve, u) = (curve::<T, N>(case)?, case.get("u_bar").number());
            let pull = WeightPull::new(&curve, &u, case.get("k").integer())?;
            if T::EXACT && pull.weight() != &T::one() {
                let [r, m] = [0, 1].map(|w| pull.point_at_weight(&T::int(w)));
                let ratio = cross_ratio([pull.control_point(), &r?, &m?, pull.point()], &T::zero())?;
                assert_eq!(&ratio, pull.weight(), "{}", case.id());
            }
            moved(&curve, &pull, &u, &case.get("lam").number())
        }
        in_dimension!(one::<T>(case))
    }

    fn expected(case: Case) -> Answer<Q> {
        expected_move(case, "R_k")
    }
}

struct Surface;

impl Golden for Surface {
    const CATEGORY: &'static str = "weight_surface";
    const CASES: usize = 1;
    const FACTOR: f64 = 16.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let points = case.get("P").list().flat_map(Case::points::<T, 3>).collect();
        let weights = case.get("w").rows().concat();
        let surface = NurbsSurface::new(case.space("p", "U")?, case.space("q", "V")?, points, weights)?;
        let at = (case.get("u").number(), case.get("v").number());
        let pull = WeightPull::new(&surface, &at, (case.get("k").integer(), case.get("l").integer()))?;
        moved(&surface, &pull, &at, &case.get("lam").number())
    }

    fn expected(case: Case) -> Answer<Q> {
        expected_move(case, "R_kl")
    }
}

/// The new weights, the shares, the target reached, and the factors.
struct Two;

impl Golden for Two {
    const CATEGORY: &'static str = "weight_two";
    const CASES: usize = 3;
    const FACTOR: f64 = 64.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        fn two<T: Field, const N: usize>(case: Case) -> Result<Answer<T>> {
            let (mut curve, u, k) =
                (curve::<T, N>(case)?, case.get("u_bar").number(), case.get("k").integer());
            let pull = WeightPairPull::new(&curve, &u, [k, k + 1])?;
            let target = SVector::<T, N>::from_vec(case.get("target").numbers());
            let weights = pull.weights_for(&target, &T::zero())?;
            let coordinates = pull.coordinates(&target, &T::zero())?;
            pull.apply_to(&mut curve, &target, &T::zero())?;
            let factors = [0, 1].map(|i| weights[i].clone() / &pull.weights()[i]);
            let rows = [weights, pull.shares().clone(), coordinates, factors].map(Vec::from);
            Ok(Answer::rows(rows.into_iter().chain([row(pull.base().clone()), row(curve.at(&u)?)]).collect()))
        }
        in_dimension!(two::<T>(case))
    }

    fn expected(case: Case) -> Answer<Q> {
        let shares = ["a_k", "a_k1"].map(|key| case.get(key).number()).to_vec();
        let [weights, coordinates, factors, base, target] =
            ["w_new", "target_bary", "beta", "R", "target"].map(|key| case.get(key).numbers());
        Answer::rows(vec![weights, shares, coordinates, factors, base, target])
    }
}

struct Derivatives;

impl Golden for Derivatives {
    const CATEGORY: &'static str = "weight_derivatives";
    const CASES: usize = 2;
    const FACTOR: f64 = 64.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        fn derivatives<T: Field, const N: usize>(case: Case) -> Result<Answer<T>> {
            let orders = case.get("ders").list().len();
            let all = curve::<T, N>(case)?.weight_derivatives(
                &case.get("u").number(),
                case.get("k").integer(),
                orders,
            )?;
            Ok(Answer::rows(all.into_iter().skip(1).map(row).collect()))
        }
        in_dimension!(derivatives::<T>(case))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::rows(case.get("ders").rows())
    }
}

/// The node before and after, the regime and leg, and the knots and nodes with the knot inserted.
struct HalfwayKnot;

impl Golden for HalfwayKnot {
    const CATEGORY: &'static str = "halfway_knot";
    const CASES: usize = 6;
    const FACTOR: f64 = 8.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let (space, x) = (case.space::<T>("p", "U")?, case.get("u_bar").number());
        let found = space.halfway_knot(&x)?;
        let knot = found.knot.expect("no case is halfway already");
        let finer = space.refined(std::slice::from_ref(&knot))?;
        let regime = [Regime::Central, Regime::LeftGap, Regime::RightGap]
            .iter()
            .position(|regime| *regime == found.regime)
            .expect("a regime with a knot");
        Ok(Answer {
            integers: vec![space.nearest_node(&x)?, regime, found.leg, found.leg + 1],
            knots: Vec::new(),
            rows: vec![vec![knot], finer.knots().to_vec(), finer.greville()],
        })
    }

    fn expected(case: Case) -> Answer<Q> {
        let regimes = ["central", "left_gap", "right_gap"];
        let regime = regimes.iter().position(|name| *name == case.get("regime").text());
        let leg = case.get("leg").list().map(Case::integer);
        let integers = [case.get("k").integer(), regime.expect("a known regime")].into_iter().chain(leg);
        let rows = ["U_out", "nodes_out"].map(|key| case.get(key).numbers());
        Answer {
            integers: integers.collect(),
            knots: Vec::new(),
            rows: [vec![case.get("u_hat").number()]].into_iter().chain(rows).collect(),
        }
    }
}

#[test]
fn weight_one() {
    check::<One>();
}

#[test]
fn weight_surface() {
    check::<Surface>();
}

#[test]
fn weight_two() {
    check::<Two>();
}

#[test]
fn weight_derivatives() {
    check::<Derivatives>();
}

#[test]
fn halfway_knot() {
    check::<HalfwayKnot>();
}

/// Exactly by the fraction that the distance is, and over `f64` by the distance.
#[test]
fn weight_one_distance() {
    for_each("weight_one_distance", 2, |case| {
        let k = case.get("k").integer();
        let [length, by] = ["PkP", "signed_d"].map(|key| case.get(key).number::<Q>());
        let (exact, u) = (curve::<Q, 2>(case)?, case.get("u_bar").number());
        let pull = WeightPull::new(&exact, &u, k)?;
        let answer = moved(&exact, &pull, &u, &(by.clone() / &length))?;
        assert_eq!(answer, expected_move(case, "R_k"), "{}", case.id());

        let (mut rounded, u) = (curve::<f64, 2>(case)?, case.get("u_bar").number());
        let pull = WeightPull::new(&rounded, &u, k)?;
        let accuracy = 16.0 * f64::EPSILON * largest(&answer.rows.concat());
        assert!((pull.distance() - length.to_f64()).abs() <= accuracy, "{}", case.id());
        let by = by.to_f64();
        let weight = case.get("w_new").number::<f64>();
        assert!((pull.weight_for_distance(&by)? - weight).abs() <= accuracy, "{}", case.id());
        pull.apply(&mut rounded, &pull.fraction_of(&by))?;
        let target = SVector::<f64, 2>::from_vec(case.get("point_new").numbers());
        assert!((rounded.at(&u)? - target).norm() <= accuracy, "{}", case.id());
        Ok(())
    });
}
