//! Forces at many places, along curves and over areas: sums of single forces, however they are added up.

use crate::strategies::*;
use nalgebra::{SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::{
    Area, Breadth, Cells, Curve, Direction, Elastic, Error, Forces, Function, Material, Polygons, Q, Scalar,
    Spline, SplineSpace, Spread, Surface, segment,
};

type Sheet = Surface<Q, 3>;
type Vector = SVector<Q, 3>;
type Load<'a, 'b> = &'a mut Forces<'b, Q, Sheet>;

const SMALL: Kind = ANY.of_degree(0, 3).few(2);
/// With tangents.
const BENT: Kind = SMOOTH.of_degree(1, 3).few(2);

/// Hard, so that all control points may move.
fn hard() -> symspline::Result<Material<Q>> {
    Material::new(Q::int(2), Q::int(1))?.with_hardness(Q::int(3))
}

fn body(sheet: &Sheet) -> symspline::Result<Elastic<Q>> {
    Elastic::of(sheet, &hard()?, &[Breadth::Whole, Breadth::Whole])
}

/// A place by its shares of the domain in twelfths.
fn place(sheet: &Sheet, (i, j): (i64, i64)) -> (Q, Q) {
    let along = |space: &SplineSpace<Q>, i: i64| {
        let (a, b) = space.domain();
        a.clone() + (b.clone() - a) * Q::frac(i, 12)
    };
    (along(sheet.u(), i), along(sheet.v(), j))
}

/// Places by shares, and forces there.
fn pushes(count: std::ops::Range<usize>) -> impl Strategy<Value = Vec<((i64, i64), Vector)>> {
    vec(((0_i64..=12, 0_i64..=12), point::<3>()), count)
}

/// A path over any space: shares of a domain that is yet to be seen.
fn shares(kind: Kind) -> impl Strategy<Value = Curve<Q, 2>> {
    let share = (0_i64..=12, 0_i64..=12).prop_map(|(i, j)| vector![Q::frac(i, 12), Q::frac(j, 12)]);
    (space(kind), coeffs(share.boxed())).prop_map(|(space, c)| {
        let coeffs = c[..space.dim()].to_vec();
        Curve::new(space, coeffs).expect("as many coefficients as the space has")
    })
}

fn path(sheet: &Sheet, shares: &Curve<Q, 2>) -> symspline::Result<Curve<Q, 2>> {
    let points = shares.coeffs().iter().map(|c| {
        let (low, high) = (place(sheet, (0, 0)), place(sheet, (12, 12)));
        vector![low.0.clone() + (high.0 - low.0) * &c[0], low.1.clone() + (high.1 - low.1) * &c[1]]
    });
    Curve::new(shares.space().clone(), points.collect())
}

/// A rectangle by shares of the domain.
fn rectangle(sheet: &Sheet, from: (i64, i64), to: (i64, i64)) -> symspline::Result<Polygons<Q>> {
    let corners = [from, (to.0, from.1), to, (from.0, to.1)];
    Polygons::new([corners.map(|corner| place(sheet, corner))])
}

fn pushed(sheet: &Sheet, add: impl Fn(Load<'_, '_>) -> symspline::Result<()>) -> symspline::Result<Sheet> {
    let mut pushed = sheet.clone();
    let elastic = body(sheet)?;
    let mut forces = Forces::new(&elastic, sheet)?;
    add(&mut forces)?;
    forces.push(&mut pushed)?;
    Ok(pushed)
}

fn load(
    sheet: &Sheet,
    add: impl Fn(Load<'_, '_>) -> symspline::Result<()>,
) -> symspline::Result<Vec<Vector>> {
    let elastic = body(sheet)?;
    let mut forces = Forces::new(&elastic, sheet)?;
    add(&mut forces)?;
    forces.load()
}

/// What the hat functions of the breaks integrate to, linear between breaks: half the spans beside a break.
fn hat_integral(space: &SplineSpace<Q>, x: &Q) -> Q {
    let breaks: Vec<Q> = space.breaks().into_iter().map(|(t, _)| t).collect();
    let lengths: Vec<Q> = breaks.windows(2).map(|ends| ends[1].clone() - &ends[0]).collect();
    let k = (breaks.partition_point(|t| t <= x) - 1).min(lengths.len() - 1);
    let ring = space.is_periodic();
    let at = |i: usize| {
        let before = if i > 0 { lengths[i - 1].clone() } else { Q::int(0) };
        let after = if i < lengths.len() { lengths[i].clone() } else { Q::int(0) };
        let wrapped = match i {
            0 if ring => lengths[lengths.len() - 1].clone(),
            i if ring && i == lengths.len() => lengths[0].clone(),
            _ => Q::int(0),
        };
        (before + after + wrapped) * Q::frac(1, 2)
    };
    let share = (x.clone() - &breaks[k]) / &lengths[k];
    at(k) * (Q::int(1) - &share) + at(k + 1) * share
}

fn turned(x: &Vector) -> Vector {
    let (c, s) = (Q::frac(3, 5), Q::frac(4, 5));
    vector![c.clone() * &x[0] - s.clone() * &x[1], s * &x[0] + c * &x[1], x[2].clone()]
}

fn moved(sheet: &Sheet) -> symspline::Result<Sheet> {
    let shift = vector![Q::int(5), Q::frac(-1, 3), Q::int(2)];
    let points = sheet.coeffs().iter().map(|c| turned(c) + &shift).collect();
    Sheet::new(sheet.u().clone(), sheet.v().clone(), points)
}

proptest! {
    #![proptest_config(cases(4))]

    #[test]
    fn many_forces_are_the_sum_of_single_answers(s in surface::<3>(SMALL, SMALL), f in pushes(5..8)) {
        let at_once = pushed(&s, |forces| {
            forces.at_all(f.iter().map(|(at, force)| (place(&s, *at), force.clone()))).map(|_| ())
        })?;
        let elastic = body(&s)?;
        let (mut one_by_one, mut together) = (s.clone(), s.clone());
        let mut all = Forces::new(&elastic, &s)?;
        for (at, force) in &f {
            let at = place(&s, *at);
            Forces::new(&elastic, &s)?.at(&at, force.clone())?.push(&mut one_by_one)?;
            all.at(&at, force.clone())?;
        }
        all.push(&mut together)?;
        prop_assert_eq!(&at_once, &one_by_one);
        prop_assert_eq!(&together, &one_by_one);
    }

    #[test]
    fn forces_of_all_kinds_add_up(
        s in surface::<3>(SMALL, SMALL),
        c in shares(SMALL),
        f in pushes(1..3),
    ) {
        let (path, force) = (path(&s, &c)?, f[0].1.clone());
        let area = rectangle(&s, (2, 3), (9, 11))?;
        let single = |forces: Load<'_, '_>| {
            f.iter().try_for_each(|(at, force)| forces.at(&place(&s, *at), force.clone()).map(|_| ()))
        };
        let along = |forces: Load<'_, '_>| forces.along_by(&path, 3, |_, _| Ok(force.clone())).map(|_| ());
        let over =
            |forces: Load<'_, '_>| forces.over(&area, &Cells::Counts(2, 3), |_| Ok(force.clone())).map(|_| ());
        let together = pushed(&s, |forces| {
            single(forces)?;
            along(forces)?;
            over(forces)
        })?;
        prop_assert_eq!(together, pushed(&pushed(&pushed(&s, over)?, along)?, single)?);
    }

    #[test]
    fn a_force_along_a_curve_is_its_samples(
        s in surface::<3>(SMALL, SMALL),
        c in shares(SMALL),
        n in 1_i64..6,
        g in coeffs(point::<3>().boxed()),
    ) {
        let path = path(&s, &c)?;
        let force = Spline::new(c.space().clone(), g[..c.space().dim()].to_vec())?;
        let (a, b) = path.domain();
        let step = (b.clone() - a) / Q::int(n);
        let middles: Vec<Q> = (0..n).map(|k| a.clone() + Q::frac(2 * k + 1, 2) * &step).collect();
        let along = load(&s, |forces| forces.along(&path, &force, n as usize).map(|_| ()))?;
        let single = load(&s, |forces| middles.iter().try_for_each(|t| {
            let at = path.at(t)?;
            forces.at(&(at[0].clone(), at[1].clone()), force.at(t)? * step.clone()).map(|_| ())
        }))?;
        prop_assert_eq!(&along, &single);
        // The loads of all control points are the forces, times the integrals of the hat functions.
        let total = along.iter().fold(Vector::zeros(), |sum, x| sum + x);
        let expected = middles.iter().try_fold(Vector::zeros(), |sum, t| {
            let at = path.at(t)?;
            let hats = hat_integral(s.u(), &at[0]) * hat_integral(s.v(), &at[1]);
            symspline::Result::Ok(sum + force.at(t)? * (hats * &step))
        })?;
        prop_assert_eq!(total, expected);
    }

    #[test]
    fn a_straight_line_along_a_direction_is_a_row_of_forces(
        s in surface::<3>(SMALL, SMALL),
        v in 0_i64..=12,
        n in 1_usize..6,
        f in point::<3>(),
    ) {
        let ends = [(0, v), (12, v)].map(|share| place(&s, share));
        let [from, to] = ends.clone().map(|(u, v)| vector![u, v]);
        let line = segment(&from, &to)?;
        let along = load(&s, |forces| forces.along_by(&line, n, |_, _| Ok(f.clone())).map(|_| ()))?;
        let (a, b) = s.u().domain();
        let row = (0..n as i64).map(|k| {
            let u = a.clone() + (b.clone() - a) * Q::frac(2 * k + 1, 2 * n as i64);
            ((u, ends[0].1.clone()), f.clone() * Q::frac(1, n as i64))
        });
        prop_assert_eq!(along, load(&s, |forces| forces.at_all(row.clone()).map(|_| ()))?);
    }

    #[test]
    fn a_force_over_a_rectangle_is_a_grid_of_forces(
        s in surface::<3>(SMALL, SMALL),
        (m, n) in (1_i64..4, 1_i64..4),
        point_spread in any::<bool>(),
        f in point::<3>(),
    ) {
        let spread = if point_spread { Spread::Point } else { Spread::Hat };
        let elastic = body(&s)?.with_spread(spread);
        let (low, high) = (place(&s, (1, 2)), place(&s, (11, 8)));
        let (width, height) = (high.0 - &low.0, high.1 - &low.1);
        let force = |at: &(Q, Q)| f.clone() * at.0.clone() + f.clone() * (at.1.clone() * &at.1);
        let mut grid = Forces::new(&elastic, &s)?;
        for (i, j) in (0..m).flat_map(|i| (0..n).map(move |j| (i, j))) {
            let at = (
                low.0.clone() + Q::frac(2 * i + 1, 2 * m) * &width,
                low.1.clone() + Q::frac(2 * j + 1, 2 * n) * &height,
            );
            let share = width.clone() * &height * Q::frac(1, m * n);
            grid.at(&at, force(&at) * share)?;
        }
        let mut over = Forces::new(&elastic, &s)?;
        let (area, cells) = (rectangle(&s, (1, 2), (11, 8))?, Cells::Counts(m as usize, n as usize));
        over.over(&area, &cells, |at| Ok(force(at)))?;
        prop_assert_eq!(over.load()?, grid.load()?);
    }

    #[test]
    fn an_area_is_the_sum_of_its_parts(s in surface::<3>(SMALL, SMALL), f in point::<3>(), n in 1_usize..4) {
        // Cells of the halves are those of the whole.
        let part = |from, to, m| {
            let area = rectangle(&s, from, to)?;
            load(&s, |forces| forces.over(&area, &Cells::Counts(m, n), |_| Ok(f.clone())).map(|_| ()))
        };
        let (left, right) = (part((0, 1), (4, 12), 2)?, part((4, 1), (12, 12), 4)?);
        let sum: Vec<Vector> = left.iter().zip(&right).map(|(x, y)| x + y).collect();
        prop_assert_eq!(part((0, 1), (12, 12), 6)?, sum);
        // A hole, and what fills it.
        let (whole, hole) = (rectangle(&s, (0, 0), (12, 12))?, rectangle(&s, (4, 4), (8, 8))?);
        let corners = |from: (i64, i64), to: (i64, i64)| [from, (to.0, from.1), to, (from.0, to.1)];
        let framed = [corners((0, 0), (12, 12)), corners((4, 4), (8, 8))];
        let frame = Polygons::new(framed.map(|all| all.map(|at| place(&s, at))))?;
        let over = |area: &dyn Area<Q>, m| {
            load(&s, |forces| forces.over(&Dyn(area), &Cells::Counts(m, m), |_| Ok(f.clone())).map(|_| ()))
        };
        let (all, inner, outer) = (over(&whole, 3)?, over(&hole, 1)?, over(&frame, 3)?);
        let sum: Vec<Vector> = inner.iter().zip(&outer).map(|(x, y)| x + y).collect();
        prop_assert_eq!(&all, &sum);
        prop_assert_eq!(outer, load(&s, |forces| {
            let both = [whole.clone(), hole.clone()];
            forces.over(&both[..], &Cells::Counts(3, 3), |_| Ok(f.clone())).map(|_| ())
        })?);
    }

    #[test]
    fn mirrored_forces_give_mirrored_shapes(
        s in surface::<3>(SMALL, SMALL),
        c in shares(SMALL),
        f in point::<3>(),
    ) {
        let mirrored = s.reversed(Direction::U)?;
        let flip = |at: &(Q, Q)| {
            let (a, b) = s.u().domain();
            (a.clone() + b - &at.0, at.1.clone())
        };
        let path = path(&s, &c)?;
        let points = path.coeffs().iter().map(|x| {
            let (u, v) = flip(&(x[0].clone(), x[1].clone()));
            vector![u, v]
        });
        let back = Curve::new(c.space().clone(), points.collect())?;
        let triangle = [(1, 2), (11, 5), (4, 12)].map(|share| place(&s, share));
        let areas = [Polygons::new([triangle.clone()])?, Polygons::new([triangle.map(|at| flip(&at))])?];
        let all = |sheet: &Sheet, path: &Curve<Q, 2>, area: &Polygons<Q>| pushed(sheet, |forces| {
            forces.along_by(path, 3, |t, _| Ok(f.clone() * t.clone()))?;
            forces.over(area, &Cells::Counts(5, 3), |at| Ok(f.clone() * at.1.clone()))?;
            Ok(())
        });
        let answer = all(&mirrored, &back, &areas[1])?;
        prop_assert_eq!(answer.reversed(Direction::U)?, all(&s, &path, &areas[0])?);
    }

    #[test]
    fn rigid_motions_commute_with_forces(
        s in surface::<3>(BENT, BENT),
        c in shares(SMALL),
        f in pushes(2..3),
    ) {
        let (path, area) = (path(&s, &c)?, rectangle(&s, (2, 2), (7, 11))?);
        let all = |sheet: &Sheet, turn: &dyn Fn(&Vector) -> Vector| pushed(sheet, |forces| {
            forces.at(&place(&s, f[0].0), turn(&f[0].1))?;
            forces.along_by(&path, 2, |_, _| Ok(turn(&f[1].1)))?;
            forces.pressure(sheet, &area, &Cells::Counts(2, 2), |at| Ok(at.0.clone()))?;
            Ok(())
        });
        prop_assert_eq!(all(&moved(&s)?, &turned)?, moved(&all(&s, &Vector::clone)?)?);
    }

    #[test]
    fn a_ring_of_forces_may_start_anywhere(
        s in surface::<3>(SMALL, SMALL),
        c in shares(RING.of_degree(0, 3).few(2)),
        f in point::<3>(),
        n in 2_usize..6,
        by in 1_usize..5,
    ) {
        // The seam of a path is moved by whole samples.
        let path = path(&s, &c)?;
        let (a, b) = path.domain();
        let seam = a.clone() + (b.clone() - a) * Q::frac((by % n) as i64, n as i64);
        let along = |path: &Curve<Q, 2>| {
            load(&s, |forces| forces.along_by(path, n, |_, _| Ok(f.clone())).map(|_| ()))
        };
        prop_assert_eq!(along(&path.with_seam_at(&seam)?)?, along(&path)?);
    }

    #[test]
    fn what_fails_adds_nothing(s in surface::<3>(SMALL, SMALL), f in pushes(1..3), n in 1_usize..6) {
        let elastic = body(&s)?;
        let mut forces = Forces::new(&elastic, &s)?;
        forces.at_all(f.iter().map(|(at, force)| (place(&s, *at), force.clone())))?;
        let before = forces.load()?;
        let (low, high) = (place(&s, (6, 6)), place(&s, (18, 6)));
        let line = segment(&vector![low.0, low.1], &vector![high.0, high.1])?;
        let one = f[0].1.clone();
        let left = forces.along_by(&line, 2 * n, |_, _| Ok(one.clone())).map(|_| ()).unwrap_err();
        // The first sample beyond the middle.
        let t = Q::frac(2 * n as i64 + 1, 4 * n as i64);
        let named = matches!(left, Error::LeavesDomain { parameter, .. } if parameter == t.to_string());
        prop_assert!(named);
        let beyond = rectangle(&s, (6, 6), (18, 12))?;
        let left = forces.over(&beyond, &Cells::Counts(2, n), |_| Ok(one.clone())).map(|_| ()).unwrap_err();
        let outside = matches!(left, Error::OutsideDomain { .. });
        prop_assert!(outside);
        let failing = forces.at_all([(place(&s, (3, 3)), one.clone()), (high_place(&s), one)]).map(|_| ());
        prop_assert!(failing.is_err());
        prop_assert_eq!(forces.load()?, before);
    }
}

fn high_place(sheet: &Sheet) -> (Q, Q) {
    place(sheet, (13, 0))
}

struct Dyn<'a>(&'a dyn Area<Q>);

impl Area<Q> for Dyn<'_> {
    fn bounds(&self) -> symspline::Result<[(Q, Q); 2]> {
        self.0.bounds()
    }
    fn inside(&self, us: &[Q], v: &Q) -> symspline::Result<Vec<bool>> {
        self.0.inside(us, v)
    }
}

/// On a plane of 2 x 3 with `S_u × S_v = 6 e_z` a pressure is a force of six times as much per unit of the parameters.
#[test]
fn pressure_counts_the_area_of_the_surface() -> symspline::Result<()> {
    let space = SplineSpace::uniform(2, 3, Q::int(0), Q::int(1))?;
    let nodes = space.greville();
    let point = |u: &Q, v: &Q| vector![Q::int(2) * u, Q::int(3) * v, Q::int(7)];
    let points = nodes.iter().flat_map(|u| nodes.iter().map(move |v| point(u, v))).collect();
    let sheet = Sheet::new(space.clone(), space, points)?;
    let area = rectangle(&sheet, (1, 2), (8, 7))?;
    let cells = Cells::Counts(3, 2);
    let pressed =
        load(&sheet, |forces| forces.pressure(&sheet, &area, &cells, |at| Ok(at.1.clone())).map(|_| ()))?;
    let up = |at: &(Q, Q)| Ok(vector![Q::int(0), Q::int(0), Q::int(6) * &at.1]);
    assert_eq!(pressed, load(&sheet, |forces| forces.over(&area, &cells, up).map(|_| ()))?);
    assert!(pressed.iter().any(|load| load[2] > Q::int(0)));
    Ok(())
}

/// On curves too many forces are answered as single ones are.
#[test]
fn forces_on_a_curve_add_up() -> symspline::Result<()> {
    let space = SplineSpace::clamped(3, [0, 1, 3, 4, 4, 6].map(Q::int))?;
    let rod = Function::constant(space, Q::int(0))?;
    let elastic = Elastic::of(&rod, &hard()?, &[Breadth::BetweenEnds(1)])?;
    let forces: Vec<(Q, Q)> = (0..9).map(|k| (Q::frac(2 * k, 3), Q::int(k * k - 5))).collect();
    let (mut together, mut single) = (rod.clone(), rod.clone());
    Forces::new(&elastic, &rod)?.at_all(forces.clone())?.push(&mut together)?;
    for (at, force) in forces {
        Forces::new(&elastic, &rod)?.at(&at, force)?.push(&mut single)?;
    }
    assert_eq!(together, single);
    Ok(())
}
