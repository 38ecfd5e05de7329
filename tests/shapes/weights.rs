//! Laws of weights as shape tools: points go exactly where they should, nothing else changes, and what cannot be done is
//! refused with the reason.

use crate::rational_strategies::{nurbs, nurbs_surface, weight};
use crate::strategies::{ANY, Kind, cases, probes};
use nalgebra::SVector;
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{
    Coeff, Domain, Error, NurbsCurve, NurbsSurface, Q, Rational, Scalar, ShapeError, Weighed, WeightPull,
    WeightRange, Weighted, cross_ratio,
};

pub const SMALL: Kind = ANY.of_degree(0, 3).few(2);
pub const TINY: Kind = ANY.of_degree(0, 2).few(1);

pub type Law = Result<(), TestCaseError>;
pub type P<const N: usize> = SVector<Q, N>;

/// A rational curve or surface, as a law sees it.
pub trait Shape<const N: usize>: Weighed<Q, Point = P<N>> + PartialEq {
    /// Parameters where things happen.
    fn places(&self) -> Vec<Self::Parameter>;
    /// The value in homogeneous coordinates.
    fn lifted_at(&self, at: &Self::Parameter) -> Weighted<Q, P<N>>;
    /// The control points and weights as they are kept.
    fn kept(&self) -> &[Weighted<Q, P<N>>];
    /// The shape made anew from weighted points, if its denominator is positive.
    fn made(&self, coeffs: Vec<Weighted<Q, P<N>>>) -> Option<Self>;
    fn pick(&self, flat: usize) -> Self::Index;
}

fn positive<D: Domain<Q>, const N: usize>(
    made: symspline::Result<Rational<D, Q, P<N>>>,
    coeffs: &[Weighted<Q, P<N>>],
) -> Option<Rational<D, Q, P<N>>> {
    let made = made.ok()?;
    let same = D::coeffs(made.lifted()) == coeffs;
    same.then_some(made)
}

impl<const N: usize> Shape<N> for NurbsCurve<Q, N> {
    fn places(&self) -> Vec<Q> {
        probes(self.space())
    }
    fn lifted_at(&self, at: &Q) -> Weighted<Q, P<N>> {
        self.lifted().at(at).expect("inside")
    }
    fn kept(&self) -> &[Weighted<Q, P<N>>] {
        self.lifted().coeffs()
    }
    fn made(&self, coeffs: Vec<Weighted<Q, P<N>>>) -> Option<Self> {
        let mut lifted = self.lifted().clone();
        lifted.replace_coeffs(coeffs.iter().cloned().enumerate().collect()).expect("the same shape");
        positive(Self::from_lifted(lifted), &coeffs)
    }
    fn pick(&self, flat: usize) -> usize {
        flat
    }
}

impl<const N: usize> Shape<N> for NurbsSurface<Q, N> {
    fn places(&self) -> Vec<(Q, Q)> {
        crate::strategies::probe_pairs(self.lifted())
    }
    fn lifted_at(&self, (u, v): &(Q, Q)) -> Weighted<Q, P<N>> {
        self.lifted().at(u, v).expect("inside")
    }
    fn kept(&self) -> &[Weighted<Q, P<N>>] {
        self.lifted().coeffs()
    }
    fn made(&self, coeffs: Vec<Weighted<Q, P<N>>>) -> Option<Self> {
        let mut lifted = self.lifted().clone();
        lifted.replace_coeffs(coeffs.iter().cloned().enumerate().collect()).expect("the same shape");
        positive(Self::from_lifted(lifted), &coeffs)
    }
    fn pick(&self, flat: usize) -> (usize, usize) {
        (flat / self.v().dim(), flat % self.v().dim())
    }
}

/// A place and the control points with influence there, from all of which some are picked.
pub fn picked<S: Shape<N>, const N: usize>(
    shape: &S,
    place: Index,
    picks: &[Index],
) -> symspline::Result<(S::Parameter, Vec<usize>)> {
    let at = place.get(&shape.places()).clone();
    let row = shape.influence(&at, S::VALUE)?;
    Ok((at, picks.iter().map(|pick| pick.get(row.terms()).0).collect()))
}

/// That `after` is `before` but for the weights of `picks`.
pub fn only_these_changed<S: Shape<N>, const N: usize>(before: &S, after: &S, picks: &[usize]) -> Law {
    for (i, (c, d)) in before.kept().iter().zip(after.kept()).enumerate() {
        if picks.contains(&i) {
            prop_assert_eq!(c.project(), d.project());
        } else {
            prop_assert_eq!(c, d);
        }
    }
    // Outside their support nothing moves.
    for at in before.places() {
        let row = before.influence(&at, S::VALUE)?;
        if picks.iter().all(|k| row.weight(*k).is_none()) {
            prop_assert_eq!(before.derivative_of(&at, S::VALUE)?, after.derivative_of(&at, S::VALUE)?);
        }
    }
    Ok(())
}

/// That a tool succeeded just if the shape with its weights has a positive denominator, and left its input alone if not.
pub fn proved<S: Shape<N>, const N: usize>(
    before: &S,
    after: &S,
    weights: &[(usize, Q)],
    done: Result<(), Error>,
) -> Result<bool, TestCaseError> {
    let mut coeffs = before.kept().to_vec();
    for (i, w) in weights {
        coeffs[*i] = Weighted::new(&before.control_point(*i)?, w.clone());
    }
    match (done, before.made(coeffs)) {
        (Ok(()), Some(made)) => {
            prop_assert_eq!(after, &made);
            Ok(true)
        }
        (Err(Error::Pole), None) => {
            prop_assert_eq!(before, after);
            Ok(false)
        }
        (done, made) => Err(TestCaseError::fail(format!("{done:?}, and anew {made:?}"))),
    }
}

pub fn refused<T>(result: symspline::Result<T>) -> Option<ShapeError> {
    match result {
        Err(Error::Shape(error)) => Some(error),
        _ => None,
    }
}

/// The pull, or a good reason that there is none.
fn pull_of<S: Shape<N>, const N: usize>(
    shape: &S,
    at: &S::Parameter,
    k: usize,
) -> Result<Option<WeightPull<Q, P<N>>>, TestCaseError> {
    match WeightPull::new(shape, at, shape.pick(k)) {
        Ok(pull) => Ok(Some(pull)),
        Err(Error::Weight { index, .. }) => {
            prop_assert!(index == k && shape.kept()[k].weight <= Q::int(0));
            Ok(None)
        }
        Err(error) => {
            prop_assert_eq!(error, ShapeError::Fixed.into());
            prop_assert_eq!(shape.derivative_of(at, S::VALUE)?, shape.control_point(k)?);
            Ok(None)
        }
    }
}

fn one_weight_moves_the_point<S: Shape<N>, const N: usize>(
    shape: &S,
    place: Index,
    pick: Index,
    share: &Q,
) -> Law {
    let (at, picks) = picked(shape, place, &[pick])?;
    let k = picks[0];
    let Some(pull) = pull_of(shape, &at, k)? else { return Ok(()) };
    let (p, control) = (shape.derivative_of(&at, S::VALUE)?, shape.control_point(k)?);
    prop_assert_eq!(pull.share(), shape.influence(&at, S::VALUE)?.weight(k).cloned().unwrap_or_default());
    // One shape moved again and again, from far pushes to far pulls.
    let lowest = pull.push_limit().unwrap_or_else(|| Q::int(-1000));
    let mut moving = shape.clone();
    for part in [share.clone(), Q::int(1) - share, Q::frac(1, 1000), Q::frac(999, 1000)] {
        let fraction = lowest.clone() + (Q::int(1) - &lowest) * part;
        let weight = pull.weight_for(&fraction)?;
        prop_assert_eq!(pull.fraction_for(&weight)?, fraction.clone());
        let before = moving.clone();
        let done = pull.apply(&mut moving, &fraction);
        if proved(&before, &moving, &[(k, weight.clone())], done)? {
            let target = p.plus_scaled(&fraction, &(control.clone() - &p));
            prop_assert_eq!(&moving.derivative_of(&at, S::VALUE)?, &target);
            prop_assert_eq!(&pull.point_at(&fraction), &target);
            prop_assert_eq!(&pull.point_at_weight(&weight)?, &target);
            prop_assert_eq!(pull.fraction_near(&target), fraction);
            only_these_changed(shape, &moving, &[k])?;
        }
    }
    pull.apply(&mut moving, &Q::int(0))?;
    prop_assert_eq!(&moving, shape);
    Ok(())
}

fn limits_are_where_weights_end<S: Shape<N>, const N: usize>(
    shape: &S,
    place: Index,
    pick: Index,
    ends: [Q; 2],
) -> Law {
    let (at, picks) = picked(shape, place, &[pick])?;
    let Some(pull) = pull_of(shape, &at, picks[0])? else { return Ok(()) };
    let mut same = shape.clone();
    for fraction in [Q::int(1), Q::int(2)] {
        let error = refused(pull.apply(&mut same, &fraction));
        prop_assert_eq!(error, Some(ShapeError::PullTooFar { fraction: fraction.to_string() }));
    }
    let r = pull.share();
    if let Some(limit) = pull.push_limit() {
        prop_assert!(r < Q::int(1));
        prop_assert_eq!(&limit, &(-r.clone() / (Q::int(1) - &r)));
        for fraction in [limit.clone(), limit.clone() * Q::int(2)] {
            let error = refused(pull.apply(&mut same, &fraction));
            let [fraction, limit] = [&fraction, &limit].map(ToString::to_string);
            prop_assert_eq!(error, Some(ShapeError::PushTooFar { fraction, limit }));
        }
        prop_assert!(pull.weight_for(&(limit * Q::frac(999, 1000)))? > Q::int(0));
    } else {
        prop_assert!(r >= Q::int(1));
        prop_assert!(pull.weight_for(&Q::int(-1_000_000))? > Q::int(0));
    }
    // With a range its ends are reached, and not passed.
    let [least, most] = if ends[0] <= ends[1] {
        ends
    } else {
        let [x, y] = ends;
        [y, x]
    };
    let ranged = pull.clone().within(WeightRange::new(least.clone(), most.clone())?);
    for (limit, end, beyond) in [(ranged.push_limit(), &least, -1), (ranged.pull_limit(), &most, 1)] {
        let Some(limit) = limit else { continue };
        prop_assert_eq!(&ranged.weight_for(&limit)?, end);
        let fraction = limit.clone() + Q::frac(beyond, 1_000_000) * (Q::int(1) - limit);
        match refused(ranged.apply(&mut same, &fraction)) {
            Some(ShapeError::WeightOutOfRange { index, .. }) => prop_assert_eq!(index, pull.index()),
            Some(ShapeError::PushTooFar { .. }) => prop_assert!(beyond < 0),
            other => prop_assert!(false, "{:?}", other),
        }
    }
    prop_assert_eq!(&same, shape);
    Ok(())
}

fn a_weight_is_a_cross_ratio<S: Shape<N>, const N: usize>(shape: &S, place: Index, pick: Index) -> Law {
    let (at, picks) = picked(shape, place, &[pick])?;
    let Some(pull) = pull_of(shape, &at, picks[0])? else { return Ok(()) };
    let Ok(base) = pull.point_at_weight(&Q::int(0)) else { return Ok(()) };
    let unit = pull.point_at_weight(&Q::int(1))?;
    // The points of the shapes with these weights.
    for (weight, point) in [(0, &base), (1, &unit)] {
        let mut homogeneous = shape.lifted_at(&at);
        let n = shape.influence(&at, S::VALUE)?.weight(picks[0]).expect("influence").clone()
            * &homogeneous.weight
            / pull.weight();
        let growth = (Q::int(weight) - pull.weight()) * n;
        homogeneous.add_scaled(&growth, &Weighted::new(pull.control_point(), Q::int(1)));
        prop_assert_eq!(&homogeneous.project(), point);
    }
    let ratio = cross_ratio([pull.control_point(), &base, &unit, pull.point()], &Q::int(0))?;
    prop_assert_eq!(&ratio, pull.weight());
    Ok(())
}

/// Numerator and denominator are linear in the weight; the quotient rule gives the derivatives.
fn derivatives_by_a_weight_are_those_of_a_quotient<S: Shape<N>, const N: usize>(
    shape: &S,
    place: Index,
    pick: Index,
) -> Law {
    let at = place.get(&shape.places()).clone();
    let k = pick.index(shape.control_count());
    let Ok(control) = shape.control_point(k) else {
        let refused = matches!(shape.weight_derivatives(&at, k, 3), Err(Error::Weight { .. }));
        prop_assert!(refused);
        return Ok(());
    };
    let mut heavier = shape.kept().to_vec();
    heavier[k] = Weighted::new(&control, shape.weight(k)?.clone() + Q::int(1));
    let heavier = shape.made(heavier).expect("a weight grew");
    let (here, slope) = (shape.lifted_at(&at), heavier.lifted_at(&at));
    let slope = Weighted { point: slope.point - &here.point, weight: slope.weight - &here.weight };
    // The coefficients of the power series of the quotient.
    let zero = P::<N>::zeros();
    let mut series: Vec<P<N>> = Vec::new();
    for n in 0..=4 {
        let top = [&here.point, &slope.point].get(n).map_or(zero.clone(), |p| (*p).clone());
        let last = series.last().cloned().unwrap_or_else(|| zero.clone());
        let next = top.plus_scaled(&-slope.weight.clone(), &last);
        series.push(next.scaled(&(Q::int(1) / &here.weight)));
    }
    let mut factorial = Q::int(1);
    for (n, found) in shape.weight_derivatives(&at, k, 4)?.iter().enumerate() {
        factorial *= Q::int(n.max(1) as i64);
        prop_assert_eq!(found, &series[n].scaled(&factorial));
    }
    Ok(())
}

/// Setting weights in place is the shape made anew from control points and weights.
fn weights_are_set_as_if_made_anew<S: Shape<N>, const N: usize>(
    shape: &S,
    places: &[Index],
    new: &[Q],
) -> Law {
    let mut list: Vec<(usize, Q)> = Vec::new();
    for (place, weight) in places.iter().zip(new) {
        let k = place.index(shape.control_count());
        if shape.kept()[k].weight > Q::int(0) && list.iter().all(|(i, _)| *i != k) {
            list.push((k, weight.clone()));
        }
    }
    let mut changed = shape.clone();
    let done = changed.set_weights(&list);
    proved(shape, &changed, &list, done)?;
    Ok(())
}

proptest! {
    #![proptest_config(cases(100))]

    #[test]
    fn one_curve_weight_moves_the_point(c in nurbs::<2>(SMALL), at: Index, k: Index, w in weight()) {
        one_weight_moves_the_point(&c, at, k, &(w.clone() / (w + Q::int(1))))?;
    }

    #[test]
    fn one_surface_weight_moves_the_point(s in nurbs_surface::<3>(TINY), at: Index, k: Index, w in weight()) {
        one_weight_moves_the_point(&s, at, k, &(w.clone() / (w + Q::int(1))))?;
    }

    #[test]
    fn limits_are_told(c in nurbs::<2>(SMALL), s in nurbs_surface::<3>(TINY), at: Index, k: Index, ends in [weight(), weight()]) {
        limits_are_where_weights_end(&c, at, k, ends.clone())?;
        limits_are_where_weights_end(&s, at, k, ends)?;
    }

    #[test]
    fn weights_are_cross_ratios(c in nurbs::<2>(SMALL), s in nurbs_surface::<3>(TINY), at: Index, k: Index) {
        a_weight_is_a_cross_ratio(&c, at, k)?;
        a_weight_is_a_cross_ratio(&s, at, k)?;
    }

    #[test]
    fn derivatives_by_a_weight(c in nurbs::<2>(SMALL), s in nurbs_surface::<3>(TINY), at: Index, k: Index) {
        derivatives_by_a_weight_are_those_of_a_quotient(&c, at, k)?;
        derivatives_by_a_weight_are_those_of_a_quotient(&s, at, k)?;
    }

    #[test]
    fn weights_are_set_in_place(c in nurbs::<2>(SMALL), s in nurbs_surface::<3>(TINY), places: [Index; 3], new in [weight(), weight(), weight()]) {
        weights_are_set_as_if_made_anew(&c, &places, &new)?;
        weights_are_set_as_if_made_anew(&s, &places, &new)?;
    }
}
