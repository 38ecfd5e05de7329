//! Laws of constraints: what is asked for is met exactly, by the least movement, and clashes are named.

use crate::rational_strategies::{nurbs, nurbs_surface};
use crate::strategies::{ANY, Kind, cases, curve, indices, number, point, probes, surface};
use nalgebra::{SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{
    Coeff, Constrained, Constraints, Controlled, CurvatureHandle, Curve, Error, Excess, Function, Q, Relief,
    Scalar, ShapeError, SparseRow, SplineSpace, with_tangent,
};

const SMALL: Kind = ANY.of_degree(0, 3);
const FEW: Kind = SMALL.few(2);

/// What is wished for: places and orders of derivatives, control points held, weights of movement.
#[derive(Clone, Debug)]
struct Wishes {
    derivatives: Vec<(Index, Index, usize, usize)>,
    held: Vec<Index>,
    weights: Vec<(Index, i64)>,
    numbers: Vec<Q>,
}

fn wishes(most: usize) -> impl Strategy<Value = Wishes> {
    let index = any::<Index>;
    let derivatives = vec((index(), index(), 0_usize..=2, 0_usize..=1), 1..=most);
    (derivatives, vec(index(), 0..=2), vec((index(), 1_i64..=5), 0..=2), vec(number(), 64))
        .prop_map(|(derivatives, held, weights, numbers)| Wishes { derivatives, held, weights, numbers })
}

/// A curve or surface, with the means to name its places and control points.
trait Wished: Controlled<Q> {
    fn place(&self, at: (&Index, &Index)) -> Self::Parameter;
    fn order(of: (usize, usize)) -> Self::Order;
    fn index(&self, index: &Index) -> Self::Index;
    fn vector(numbers: &[Q]) -> Self::Point;

    fn wish(&self, wishes: &Wishes) -> Result<Constraints<'_, Q, Self>, Error> {
        let mut wanted = Constraints::on(self);
        for (u, v, k, l) in &wishes.derivatives {
            wanted = wanted.derivative(&self.place((u, v)), Self::order((*k, *l)))?;
        }
        let held: Vec<Self::Index> = wishes.held.iter().map(|i| self.index(i)).collect();
        wanted = wanted.holding(&held)?;
        for (i, weight) in &wishes.weights {
            wanted = wanted.weighing(self.index(i), Q::int(*weight))?;
        }
        Ok(wanted)
    }

    fn vectors(wishes: &Wishes, count: usize) -> Vec<Self::Point> {
        (0..count).map(|i| Self::vector(&wishes.numbers[i..])).collect()
    }
}

macro_rules! wished {
    ($kind:ty, $n:literal, curve) => {
        impl Wished for $kind {
            fn place(&self, at: (&Index, &Index)) -> Q {
                at.0.get(&probes(self.space())).clone()
            }
            fn order(of: (usize, usize)) -> usize {
                of.0
            }
            fn index(&self, index: &Index) -> usize {
                index.index(self.control_count())
            }
            fn vector(numbers: &[Q]) -> SVector<Q, $n> {
                SVector::from_fn(|i, _| numbers[i].clone())
            }
        }
    };
    ($kind:ty, $n:literal, surface) => {
        impl Wished for $kind {
            fn place(&self, at: (&Index, &Index)) -> (Q, Q) {
                (at.0.get(&probes(self.u())).clone(), at.1.get(&probes(self.v())).clone())
            }
            fn order(of: (usize, usize)) -> (usize, usize) {
                of
            }
            fn index(&self, index: &Index) -> (usize, usize) {
                let flat = index.index(self.control_count());
                (flat / self.v().dim(), flat % self.v().dim())
            }
            fn vector(numbers: &[Q]) -> SVector<Q, $n> {
                SVector::from_fn(|i, _| numbers[i].clone())
            }
        }
    };
}
wished!(Curve<Q, 2>, 2, curve);
wished!(symspline::NurbsCurve<Q, 3>, 3, curve);
wished!(symspline::Surface<Q, 3>, 3, surface);
wished!(symspline::NurbsSurface<Q, 2>, 2, surface);

/// `Σ w_i d_i e_i` of two movements, each coordinate by itself.
fn inner<S: Wished>(wishes: &Wishes, shape: &S, d: &[S::Point], e: &[Q]) -> Result<S::Point, Error> {
    let mut sum = d[0].zero_like();
    let mut weights = vec![Q::int(1); d.len()];
    for (i, weight) in &wishes.weights {
        weights[shape.flat(shape.index(i))?] = Q::int(*weight);
    }
    d.iter().zip(e).zip(&weights).for_each(|((d, e), w)| sum.add_scaled(&(e.clone() * w), d));
    Ok(sum)
}

/// Constraints are met; held control points stay; the movement is across all that leave the constraints alone.
fn is_met<S: Wished>(shape: &S, wishes: &Wishes) -> Result<(), TestCaseError> {
    let wanted = shape.wish(wishes)?;
    let held: Constrained<Q, S> = match wanted.prepare() {
        Ok(held) => held,
        Err(Error::Shape(refused)) => return names_the_clash(shape, wishes, &refused),
        Err(other) => return Err(other.into()),
    };
    let changes = S::vectors(wishes, wishes.derivatives.len());
    let moved = held.dragged(shape, &changes)?;
    for ((u, v, k, l), change) in wishes.derivatives.iter().zip(&changes) {
        let (at, order) = (shape.place((u, v)), S::order((*k, *l)));
        let expected = shape.derivative_of(&at, order)?.plus_scaled(&Q::int(1), change);
        prop_assert_eq!(moved.derivative_of(&at, order)?, expected);
    }
    for i in &wishes.held {
        let i = shape.flat(shape.index(i))?;
        prop_assert_eq!(moved.control_point(i), shape.control_point(i));
    }
    // Any movement e that keeps the constraints and the held points is orthogonal to ours.
    let count = shape.control_count();
    let mut d = vec![changes[0].zero_like(); count];
    for (i, by) in held.matrix().moves(&changes)? {
        d[i] = by;
    }
    let mut e: Vec<Q> = wishes.numbers.iter().rev().cycle().take(count).cloned().collect();
    for i in &wishes.held {
        e[shape.flat(shape.index(i))?] = Q::int(0);
    }
    // Take out of e what meets the constraints: e - A B e.
    let values: Vec<Q> = held.rows().map(|row| row.apply(&e).unwrap_or_else(|| Q::int(0))).collect();
    for (i, by) in held.matrix().moves(&values)? {
        e[i] -= by;
    }
    for row in held.rows() {
        prop_assert_eq!(row.apply(&e).unwrap_or_else(|| Q::int(0)), Q::int(0));
    }
    prop_assert!(inner(wishes, shape, &d, &e)?.vanishes());
    // And the same by targets.
    let mut met = shape.clone();
    let targets = wishes
        .derivatives
        .iter()
        .map(|(u, v, k, l)| moved.derivative_of(&shape.place((u, v)), S::order((*k, *l))));
    match held.meet(&mut met, &targets.collect::<Result<Vec<_>, _>>()?) {
        Ok(()) => {
            for i in 0..count {
                prop_assert_eq!(met.control_point(i), moved.control_point(i));
            }
        }
        Err(Error::Weight { .. }) => {}
        Err(other) => return Err(other.into()),
    }
    Ok(())
}

/// The constraints named depend on each other when held control points do not count, and without the last they do not.
fn names_the_clash<S: Wished>(shape: &S, wishes: &Wishes, refused: &ShapeError) -> Result<(), TestCaseError> {
    let named = match refused {
        ShapeError::Overdetermined { conditions, free, clashing } => {
            prop_assert!(conditions > free);
            clashing.clone()
        }
        ShapeError::Dependent { condition, on } => on.iter().copied().chain([*condition]).collect(),
        other => return Err(TestCaseError::fail(other.to_string())),
    };
    let only = |kept: &[usize]| Wishes {
        derivatives: kept.iter().map(|i| wishes.derivatives[*i]).collect(),
        ..wishes.clone()
    };
    prop_assert!(shape.wish(&only(&named))?.prepare().is_err());
    for left_out in 0..named.len() {
        let mut fewer = named.clone();
        fewer.remove(left_out);
        if !fewer.is_empty() {
            prop_assert!(shape.wish(&only(&fewer))?.prepare().is_ok(), "{:?} of {:?}", fewer, named);
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn constraints_on_curves_are_met_by_the_least_movement(
        c in curve::<2>(SMALL), r in nurbs::<3>(SMALL), wishes in wishes(6),
    ) {
        is_met(&c, &wishes)?;
        is_met(&r, &wishes)?;
    }

    #[test]
    fn constraints_on_surfaces_are_met_by_the_least_movement(
        s in surface::<3>(FEW, FEW), r in nurbs_surface::<2>(FEW), wishes in wishes(5),
    ) {
        is_met(&s, &wishes)?;
        is_met(&r, &wishes)?;
    }

    #[test]
    fn least_squares_leave_no_better_way(c in curve::<2>(SMALL), wishes in wishes(7)) {
        let held = c.wish(&wishes)?.with_excess(Excess::LeastSquares).prepare()?;
        let changes = Curve::<Q, 2>::vectors(&wishes, wishes.derivatives.len());
        let moved = held.matrix().moves(&changes)?;
        let mut d = vec![vector![Q::int(0), Q::int(0)]; c.control_count()];
        moved.into_iter().for_each(|(i, by)| d[i] = by);
        // The residual is across every change that the free control points can make: B_i · (B d - b) = 0.
        let rows: Vec<&SparseRow<Q>> = held.rows().collect();
        let residuals: Vec<SVector<Q, 2>> = rows.iter().zip(&changes).map(|(row, b)| {
            row.apply(&d).unwrap_or_else(|| vector![Q::int(0), Q::int(0)]) - b
        }).collect();
        let fixed: Vec<usize> = wishes.held.iter().map(|i| c.index(i)).collect();
        for i in (0..c.control_count()).filter(|i| !fixed.contains(i)) {
            let mut sum = vector![Q::int(0), Q::int(0)];
            for (row, residual) in rows.iter().zip(&residuals) {
                if let Some(w) = row.weight(i) {
                    sum.add_scaled(w, residual);
                }
            }
            prop_assert!(sum.vanishes());
        }
        // Where the constraints can be met, they are.
        if let Ok(exact) = c.wish(&wishes)?.prepare() {
            prop_assert_eq!(exact.matrix(), held.matrix());
        }
    }

    #[test]
    fn orders_do_not_matter(c in curve::<2>(SMALL), wishes in wishes(5), turn in 0_usize..5) {
        // The matrix of one to three constraints is written down, of more it is computed: four with one more of three agree.
        let Ok(held) = c.wish(&wishes)?.prepare() else { return Ok(()) };
        let mut turned = wishes.clone();
        let n = wishes.derivatives.len();
        turned.derivatives.rotate_left(turn % n);
        let again = c.wish(&turned)?.prepare()?;
        let changes = Curve::<Q, 2>::vectors(&wishes, n);
        let mut other = changes.clone();
        other.rotate_left(turn % n);
        prop_assert_eq!(held.dragged(&c, &changes)?, again.dragged(&c, &other)?);
    }

    #[test]
    fn floats_are_near(c in curve::<2>(ANY.of_degree(1, 4)), wishes in wishes(5)) {
        let Ok(exact) = c.wish(&wishes)?.prepare() else { return Ok(()) };
        let f = c.to_f64()?;
        let mut wanted = Constraints::on(&f);
        for (u, v, k, _) in &wishes.derivatives {
            wanted = wanted.derivative(&c.place((u, v)).to_f64(), *k)?;
        }
        let held: Vec<usize> = wishes.held.iter().map(|i| c.index(i)).collect();
        wanted = wanted.holding(&held)?;
        for (i, weight) in &wishes.weights {
            wanted = wanted.weighing(c.index(i), *weight as f64)?;
        }
        // Tiny and huge spans make constraints that floating point cannot tell from dependent ones.
        let Ok(near) = wanted.prepare() else { return Ok(()) };
        // B A = I, in units of the lengths of a row of B and a column of A.
        let a: Vec<(usize, &[f64])> = near.matrix().indices().iter().copied().zip(near.matrix().rows()).collect();
        for (i, row) in near.rows().enumerate() {
            for j in 0..near.rows().len() {
                let sum: f64 = a.iter().filter_map(|(k, entries)| row.weight(*k).map(|w| w * entries[j])).sum();
                let length = |squares: f64| squares.sqrt();
                let size = length(row.terms().iter().map(|(_, w)| w * w).sum())
                    * length(a.iter().map(|(_, entries)| entries[j] * entries[j]).sum());
                let expected = if i == j { 1.0 } else { 0.0 };
                prop_assert!((sum - expected).abs() <= 1e-12 * (1.0 + size), "{i} {j}: {sum} of {size}");
            }
        }
        prop_assert_eq!(near.rows().len(), exact.rows().len());
    }

    #[test]
    fn rows_and_coupled_rows_are_met(
        c in curve::<2>(ANY.of_degree(1, 3)), x in any::<Index>(), to in point::<2>(), area in number(), n in point::<2>(),
    ) {
        let x = x.get(&probes(c.space())).clone();
        let mean = SparseRow::from_functional(&c.space().moment(0)?, c.space().dim());
        let wanted = Constraints::on(&c).row(mean)?.coupled().along(&x, 0, &n)?.area();
        // A curve that may jump has no area of this kind.
        let Ok(wanted) = wanted else { return Ok(()) };
        let Ok(held) = wanted.prepare() else { return Ok(()) };
        let moved = held.dragged(&c, std::slice::from_ref(&to), &[Q::int(2), area.clone()])?;
        let delta = moved.difference(&c)?;
        prop_assert_eq!(delta.integral()?, to);
        prop_assert_eq!(Q::dot(n.iter().zip(delta.at(&x)?.iter())), Q::int(2));
        // ½ ∫ (C × C'), and that of the change: quadratic, so the linear part is what remains.
        let swept = |f: &Curve<Q, 2>| -> Result<Q, Error> {
            Ok(f.cross(&f.derivative()?)?.integral()? * Q::frac(1, 2))
        };
        prop_assert_eq!(swept(&moved)? - swept(&c)? - swept(&delta)?, area);
    }

    #[test]
    fn coordinates_one_by_one_are_vectors(c in curve::<2>(SMALL), s in nurbs_surface::<2>(FEW), wishes in wishes(4)) {
        one_by_one(&c, &wishes)?;
        one_by_one(&s, &wishes)?;
    }

    #[test]
    fn tangents_turn_about_their_points(c in curve::<3>(SMALL), r in nurbs::<2>(SMALL), x in any::<Index>(), to in point::<3>()) {
        turns(&c, x.get(&probes(c.space())), &to)?;
        turns(&r, x.get(&probes(r.space())), &vector![to[0].clone(), to[1].clone()])?;
    }

    #[test]
    fn curvature_handles_bend_and_slide(c in curve::<3>(ANY.of_degree(2, 3)), x in any::<Index>(), by in number()) {
        let x = x.get(&probes(c.space())).clone();
        let Ok(handle) = CurvatureHandle::prepare(&c, &x) else { return Ok(()) };
        let bend = |c: &Curve<Q, 3>| -> Result<[SVector<Q, 3>; 3], Error> {
            let [p, d, e] = &c.derivatives_at(&x, 2)?[..] else { unreachable!("three derivatives") };
            let cross = |i: usize, j: usize| d[i].clone() * &e[j] - d[j].clone() * &e[i];
            Ok([p.clone(), d.clone(), vector![cross(1, 2), cross(2, 0), cross(0, 1)]])
        };
        let [p, d, k] = bend(&c)?;
        let mut slid = c.clone();
        handle.slide(&mut slid, &by)?;
        prop_assert_eq!(bend(&slid)?, [p.clone(), d.clone(), k.clone()]);
        let mut bent = c;
        match handle.scale(&mut bent, &by) {
            Ok(()) => prop_assert_eq!(bend(&bent)?, [p, d, k.scaled(&by)]),
            Err(Error::Stationary { .. }) => prop_assert!(d.vanishes()),
            Err(other) => return Err(other.into()),
        }
    }

    #[test]
    fn room_is_made_for_constraints(c in curve::<2>(ANY.of_degree(0, 3).few(2)), places in indices(7), to in vec(point::<2>(), 7)) {
        let mut picked: Vec<Q> = places.iter().map(|place| place.get(&probes(c.space())).clone()).collect();
        picked.sort();
        picked.dedup();
        let mut wanted = Constraints::on(&c);
        for x in &picked {
            wanted = wanted.point(x)?;
        }
        prop_assume!(!picked.is_empty());
        for relief in [Relief::Knots, Relief::Degree] {
            // The ends of a ring are one point.
            let (finer, held) = match wanted.relieved(relief) {
                Err(Error::Shape(_)) if c.space().is_periodic() => continue,
                made => made?,
            };
            let moved = held.dragged(&finer, &to[..picked.len()])?;
            for (x, to) in picked.iter().zip(&to) {
                prop_assert_eq!(moved.at(x)?, c.at(x)? + to);
            }
        }
    }
}

/// Vector constraints, coupled or taken apart into their coordinates, with what is held and the weights of movement.
fn one_by_one<S: Wished<Point = SVector<Q, 2>>>(shape: &S, wishes: &Wishes) -> Result<(), TestCaseError> {
    let wanted = shape.wish(wishes)?;
    let Ok(held) = wanted.prepare() else {
        prop_assert!(wanted.coupled().prepare().is_err());
        return Ok(());
    };
    let changes = S::vectors(wishes, wishes.derivatives.len());
    let expected = held.dragged(shape, &changes)?.control_points();
    let coupled = wanted.clone().coupled().prepare()?.dragged(shape, &changes, &[])?;
    prop_assert_eq!(&coupled.control_points(), &expected);
    let first = Wishes { derivatives: wishes.derivatives[..1].to_vec(), ..wishes.clone() };
    let mut apart = shape.wish(&first)?.coupled();
    let mut numbers = Vec::new();
    for ((u, v, k, l), change) in wishes.derivatives.iter().zip(&changes).skip(1) {
        for axis in 0..2 {
            let n = SVector::<Q, 2>::from_fn(|i, _| Q::int(i64::from(i == axis)));
            apart = apart.along(&shape.place((u, v)), S::order((*k, *l)), &n)?;
            numbers.push(change[axis].clone());
        }
    }
    let apart = apart.prepare()?.dragged(shape, &changes[..1], &numbers)?;
    prop_assert_eq!(apart.control_points(), expected);
    Ok(())
}

/// The tangent has the direction, and the point is the same.
fn turns<S, const N: usize>(c: &S, x: &Q, to: &SVector<Q, N>) -> Result<(), TestCaseError>
where
    S: Controlled<Q, Parameter = Q, Order = usize, Point = SVector<Q, N>>,
{
    let turned = match with_tangent(c, x, to) {
        Ok(turned) => turned,
        Err(Error::NoLength) => {
            prop_assert!(to.vanishes());
            return Ok(());
        }
        Err(Error::Shape(ShapeError::TangentReversed)) => {
            let old = c.derivative_of(x, 1)?;
            prop_assert!(
                Q::dot(old.iter().zip(to.iter())) <= Q::int(0)
                    || c.space_along(symspline::Direction::U).degree() < 2
            );
            return Ok(());
        }
        Err(Error::Shape(_)) => return Ok(()),
        Err(other) => return Err(other.into()),
    };
    prop_assert_eq!(turned.derivative_of(x, 0)?, c.derivative_of(x, 0)?);
    let tangent = turned.derivative_of(x, 1)?;
    for i in 0..N {
        for j in 0..N {
            prop_assert_eq!(tangent[i].clone() * &to[j], tangent[j].clone() * &to[i]);
        }
    }
    prop_assert!(Q::dot(tangent.iter().zip(to.iter())) > Q::int(0));
    Ok(())
}

fn cubic() -> Function<Q> {
    Function::constant(SplineSpace::clamped(3, [0, 1, 2, 3].map(Q::int)).expect("a space"), Q::int(0))
        .expect("a number")
}

#[test]
fn clashes_are_named() {
    let f = cubic();
    let twice =
        Constraints::on(&f).point(&Q::int(0)).unwrap().point(&Q::int(1)).unwrap().point(&Q::int(0)).unwrap();
    let refused = ShapeError::Dependent { condition: 2, on: vec![0] };
    assert_eq!(twice.prepare().unwrap_err(), refused.into());
    // The third derivative beyond the degree is zero whatever moves.
    let none = Constraints::on(&f).point(&Q::int(1)).unwrap().derivative(&Q::int(1), 4).unwrap();
    assert_eq!(none.prepare().unwrap_err(), ShapeError::Dependent { condition: 1, on: vec![] }.into());
    let x = Q::frac(1, 2);
    let held = Constraints::on(&f).point(&x).unwrap().derivative(&x, 1).unwrap().freeing(&[1]).unwrap();
    let refused = ShapeError::Overdetermined { conditions: 2, free: 1, clashing: vec![0, 1] };
    assert_eq!(held.prepare().unwrap_err(), refused.into());
    let all = Constraints::on(&f).point(&x).unwrap().holding(&[0, 1, 2, 3]).unwrap();
    assert_eq!(all.prepare().unwrap_err(), ShapeError::Dependent { condition: 0, on: vec![] }.into());
}

#[test]
fn bad_wishes_are_refused() {
    let f = cubic();
    assert_eq!(Constraints::on(&f).prepare().unwrap_err(), Error::CoefficientCount { expected: 1, found: 0 });
    assert!(matches!(Constraints::on(&f).point(&Q::int(4)), Err(Error::OutsideDomain { .. })));
    assert!(matches!(Constraints::on(&f).holding(&[6]), Err(Error::IndexOutOfRange { index: 6, length: 6 })));
    assert!(matches!(Constraints::on(&f).freeing(&[9]), Err(Error::IndexOutOfRange { .. })));
    let weight = Constraints::on(&f).weighing(0, Q::int(0));
    assert!(matches!(weight, Err(Error::Shape(ShapeError::MovementWeight { index: 0, .. }))));
    let row = Constraints::on(&f).row(SparseRow::new([(6, Q::int(1))]));
    assert!(matches!(row, Err(Error::IndexOutOfRange { index: 6, .. })));
    let carried =
        Constraints::on(&f).point(&Q::int(0)).unwrap().holding(&[0]).unwrap().relieved(Relief::Knots);
    assert!(matches!(carried, Err(Error::Shape(ShapeError::NotCarried))));
    let beyond = Constraints::on(&f).derivative(&Q::int(0), 4).unwrap();
    assert!(matches!(beyond.relieved(Relief::Knots), Err(Error::Shape(ShapeError::Dependent { .. }))));
    assert!(beyond.relieved(Relief::Degree).is_ok());
    let held = Constraints::on(&f).point(&Q::int(0)).unwrap().prepare().unwrap();
    let mut g = f.clone();
    assert_eq!(held.drag(&mut g, &[]), Err(Error::CoefficientCount { expected: 1, found: 0 }));
    assert_eq!(
        held.meet(&mut g, &[Q::int(1), Q::int(2)]),
        Err(Error::CoefficientCount { expected: 1, found: 2 })
    );
    assert_eq!(g, f);
}
