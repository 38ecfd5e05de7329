//! Laws of the energy of surfaces with free weights, exact.

use crate::strategies::{ANY, Kind, RING, cases, field, number, point, surface};
use nalgebra::{DMatrix, SVector};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use symspline::{
    Breadth, DeformError, Elastic, Error, FullEnergy, Material, Q, Result, Scalar, SparseRow, SplineSpace,
    Surface, TensorSpline,
};

const SHAPE: Kind = ANY.of_degree(0, 3).few(1);
const KINDS: [Kind; 2] = [SHAPE, RING.of_degree(0, 2).few(2)];

fn weight() -> impl Strategy<Value = Q> {
    select(vec![Q::int(0), Q::int(0), Q::int(1), Q::int(2), Q::frac(1, 3), Q::frac(50, 7)])
}

fn energy() -> impl Strategy<Value = FullEnergy<Q>> {
    vec(vec(weight(), 0..4), 0..4).prop_map(|rows| FullEnergy::new(rows).expect("weights from zero on"))
}

fn material() -> impl Strategy<Value = Material<Q>> {
    vec(weight(), 0..4).prop_map(|weights| Material::of_orders(weights).expect("weights from zero on"))
}

/// A surface of any two kinds of spaces.
fn sheet() -> impl Strategy<Value = TensorSpline<Q>> {
    (0..4_usize).prop_flat_map(|k| field(KINDS[k % 2], KINDS[k / 2]))
}

/// Which coefficients of a space may move.
fn breadth(space: &SplineSpace<Q>, places: &[Index], whole: bool) -> Breadth<Q> {
    if whole {
        Breadth::Whole
    } else {
        Breadth::Listed(places.iter().map(|i| i.index(space.dim())).collect())
    }
}

fn of_order(k: usize) -> Material<Q> {
    Material::of_orders((0..=k).map(|i| Q::int(i64::from(i == k)))).expect("weights from zero on")
}

fn dense(rows: &[SparseRow<Q>]) -> DMatrix<Q> {
    let mut matrix = DMatrix::from_element(rows.len(), rows.len(), Q::int(0));
    for (i, row) in rows.iter().enumerate() {
        row.terms().iter().for_each(|(j, x)| matrix[(i, *j)] = x.clone());
    }
    matrix
}

fn work(force: &[Q], way: &[Q]) -> Q {
    Q::dot(force.iter().zip(way))
}

/// The dimension of the null space by elimination.
fn defect(mut a: DMatrix<Q>) -> usize {
    let n = a.nrows();
    let mut rank = 0;
    for column in 0..n {
        let Some(pivot) = (rank..n).find(|i| !num_traits::Zero::is_zero(&a[(*i, column)])) else { continue };
        a.swap_rows(rank, pivot);
        for i in rank + 1..n {
            let factor = a[(i, column)].clone() / &a[(rank, column)];
            for j in column..n {
                let x = factor.clone() * &a[(rank, j)];
                a[(i, j)] -= x;
            }
        }
        rank += 1;
    }
    n - rank
}

proptest! {
    #![proptest_config(cases(16))]

    #[test]
    fn the_matrix_is_the_sum_of_products_of_those_along_the_directions(s in sheet(), energy in energy()) {
        let size = s.coeffs().len();
        let mut expected = DMatrix::from_element(size, size, Q::int(0));
        for k in 0..4 {
            for l in 0..4 {
                let [u, v] = [of_order(k).matrix(s.u())?, of_order(l).matrix(s.v())?];
                let product = u.to_matrix()?.kronecker(&v.to_matrix()?);
                let weight = energy.weight(k, l);
                expected.iter_mut().zip(product.iter()).for_each(|(sum, x)| *sum += weight.clone() * x);
            }
        }
        let matrix = dense(&energy.matrix(s.u(), s.v())?);
        prop_assert_eq!(&matrix.transpose(), &matrix);
        prop_assert_eq!(matrix, expected);
    }

    #[test]
    fn the_energy_is_the_work_of_its_gradient(s in sheet(), energy in energy()) {
        let gradient = energy.gradient(&s)?;
        prop_assert_eq!(energy.energy(&s)?, work(&gradient, s.coeffs()));
        let rows = energy.matrix(s.u(), s.v())?;
        for (row, x) in rows.iter().zip(&gradient) {
            prop_assert_eq!(row.apply(s.coeffs()).unwrap_or_else(|| Q::int(0)), x.clone());
        }
    }

    #[test]
    fn the_energy_is_the_integral_of_squared_derivatives(
        s in surface::<2>(ANY.of_degree(1, 3).smooth(2).few(1), RING.of_degree(1, 3).smooth(1).few(1)), energy in energy(),
    ) {
        let mut expected = Q::int(0);
        for k in 0..4 {
            for l in 0..4 {
                let weight = energy.weight(k, l);
                match s.partial(k.min(2), l.min(1)) {
                    _ if k > s.u().degree() || l > s.v().degree() => {}
                    Ok(partial) if k < 3 && l < 2 => expected += weight * partial.dot(&partial)?.integral()?,
                    // Derivatives that are no splines, left to the other laws.
                    _ => expected += weight.clone() * single(k, l)?.energy(&s)?,
                }
            }
        }
        prop_assert_eq!(energy.energy(&s)?, expected);
    }

    #[test]
    fn displacements_meet_the_load_where_they_may(
        s in sheet(), energy in energy(), load in vec(number(), 23), places in vec(any::<Index>(), 6), whole in any::<[bool; 2]>(),
    ) {
        let breadths = [breadth(s.u(), &places[..3], whole[0]), breadth(s.v(), &places[3..], whole[1])];
        let moving = [breadths[0].coeffs(s.u())?, breadths[1].coeffs(s.v())?];
        let columns = s.v().dim();
        let free: Vec<usize> =
            moving[0].iter().flat_map(|i| moving[1].iter().map(move |j| i * columns + j)).collect();
        let load: Vec<Q> = (0..s.coeffs().len()).map(|i| load[i % 23].clone()).collect();
        let matrix = dense(&energy.matrix(s.u(), s.v())?);
        let part = DMatrix::from_fn(free.len(), free.len(), |i, j| matrix[(free[i], free[j])].clone());
        match energy.solved((s.u(), s.v()), &load, [&breadths[0], &breadths[1]]) {
            Ok(moved) => {
                let back = energy.gradient(&TensorSpline::new(s.u().clone(), s.v().clone(), moved.clone())?)?;
                for i in 0..load.len() {
                    match free.binary_search(&i) {
                        Ok(_) => prop_assert_eq!(&back[i], &load[i]),
                        Err(_) => prop_assert_eq!(&moved[i], &Q::int(0)),
                    }
                }
            }
            Err(Error::Deform(DeformError::LooseSurface { dimension, point })) => {
                prop_assert_eq!(dimension, defect(part));
                prop_assert!(free.contains(&point));
            }
            Err(other) => return Err(other.into()),
        }
    }

    #[test]
    fn of_two_materials_it_is_that_of_an_elastic_surface(
        s in sheet(), materials in [material(), material()], load in vec(number(), 23), places in vec(any::<Index>(), 6),
        whole in any::<[bool; 2]>(),
    ) {
        let energy = FullEnergy::of_materials(&materials[0], &materials[1])?;
        let breadths = [breadth(s.u(), &places[..3], whole[0]), breadth(s.v(), &places[3..], whole[1])];
        let load: Vec<Q> = (0..s.coeffs().len()).map(|i| load[i % 23].clone()).collect();
        let solved = energy.solved((s.u(), s.v()), &load, [&breadths[0], &breadths[1]]);
        match Elastic::with_materials(&s, &materials, &breadths) {
            Ok(elastic) => prop_assert_eq!(solved?, elastic.solved(&load)?),
            Err(_) => {
                let loose = matches!(solved, Err(Error::Deform(DeformError::LooseSurface { .. })));
                prop_assert!(loose);
            }
        }
    }

    #[test]
    fn directions_may_be_exchanged(s in sheet(), energy in energy()) {
        let turned = FullEnergy::new((0..4).map(|k| (0..4).map(|l| energy.weight(l, k)).collect::<Vec<_>>()))?;
        prop_assert_eq!(turned.energy(&s.transposed())?, energy.energy(&s)?);
    }

    #[test]
    fn thin_plates_do_not_feel_rotations(weights in [weight(), weight()], corners in vec(point::<1>(), 9)) {
        // (x, y) -> (y, -x) of the square about the origin.
        let space = SplineSpace::bezier(2, Q::int(-1), Q::int(1))?;
        let at = |i: usize, j: usize| corners[3 * i + j].clone();
        let grid = |f: &dyn Fn(usize, usize) -> SVector<Q, 1>| {
            let points = (0..9).map(|k| f(k / 3, k % 3)).collect();
            Surface::new(space.clone(), space.clone(), points)
        };
        let plate = FullEnergy::thin_plate(weights[0].clone(), weights[1].clone())?;
        let (one, other) = (grid(&|i, j| at(i, j))?, grid(&|i, j| at(j, 2 - i))?);
        prop_assert_eq!(plate.energy(&one)?, plate.energy(&other)?);
    }
}

fn single(k: usize, l: usize) -> Result<FullEnergy<Q>> {
    FullEnergy::new([] as [Vec<Q>; 0])?.with_weight((k, l), Q::int(1))
}

#[test]
fn the_eight_weights_stand_where_the_paper_has_them() -> Result<()> {
    let energy = FullEnergy::of_eight([1, 2, 3, 4, 5, 6, 7, 8].map(Q::int))?;
    let orders = [(1, 0), (0, 1), (2, 0), (1, 1), (0, 2), (2, 1), (1, 2), (2, 2)];
    for (c, (k, l)) in (1..).zip(orders) {
        assert_eq!(energy.weight(k, l), Q::int(c));
    }
    assert_eq!(energy.weight(0, 0), Q::int(0));
    Ok(())
}

/// Rows and weights that are zero at the end make no other energy.
#[test]
fn equal_energies_are_equal() -> Result<()> {
    let value = FullEnergy::new([[Q::int(1)]])?;
    assert_eq!(FullEnergy::new([vec![Q::int(1), Q::int(0)], vec![], vec![Q::int(0)]])?, value);
    assert_eq!(value.with_weight((2, 1), Q::int(3))?.with_weight((2, 1), Q::int(0))?, value);
    Ok(())
}

#[test]
fn isotropic_to_the_corner() -> Result<()> {
    // Of x² - y² bending is 8 on the unit square of area 1, of 2 x y it is 8 too: the same function, turned by 45 degrees.
    let space = SplineSpace::bezier(2, Q::int(0), Q::int(1))?;
    let plate = FullEnergy::thin_plate(Q::int(0), Q::int(1))?;
    let surface = |points: [i64; 9]| {
        TensorSpline::new(space.clone(), space.clone(), points.map(|x| Q::frac(x, 2)).to_vec())
    };
    assert_eq!(plate.energy(&surface([0, 0, -2, 0, 0, -2, 2, 2, 0])?)?, Q::int(8));
    assert_eq!(plate.energy(&surface([0, 0, 0, 0, 1, 2, 0, 2, 4])?)?, Q::int(8));
    Ok(())
}

#[test]
fn floats_are_near_the_exact_displacements() -> Result<()> {
    let exact = SplineSpace::uniform(3, 5, Q::int(0), Q::int(1))?;
    let float = SplineSpace::uniform(3, 5, 0.0, 1.0)?;
    let energy = FullEnergy::thin_plate(1.0, 2.0)?;
    let rational = FullEnergy::thin_plate(Q::int(1), Q::int(2))?;
    let inner = [Breadth::BetweenEnds(1), Breadth::BetweenEnds(1)];
    let held = [Breadth::BetweenEnds(1), Breadth::BetweenEnds(1)];
    let load = |i: usize| i64::from(i == 27);
    let found = energy.solved(
        (&float, &float),
        &(0..64).map(|i| load(i) as f64).collect::<Vec<_>>(),
        [&inner[0], &inner[1]],
    )?;
    let expected = rational.solved(
        (&exact, &exact),
        &(0..64).map(|i| Q::int(load(i))).collect::<Vec<_>>(),
        [&held[0], &held[1]],
    )?;
    let most = expected.iter().map(|x| x.to_f64().abs()).fold(0.0, f64::max);
    for (x, y) in found.iter().zip(&expected) {
        assert!((x - y.to_f64()).abs() < 1e-12 * most, "{x} {y}");
    }
    Ok(())
}

#[test]
fn hostile_sizes_are_refused_or_finite() -> Result<()> {
    let space = SplineSpace::uniform(3, 3, 0.0, 1.0)?;
    for size in [1e-300, 1e300] {
        let energy = FullEnergy::thin_plate(size, size)?;
        let s = TensorSpline::new(
            space.clone(),
            space.clone(),
            (0..36).map(|i| size * f64::from(i % 7)).collect(),
        )?;
        match energy.energy(&s) {
            Ok(e) => assert!(e.is_finite() && e >= 0.0),
            Err(error) => assert!(matches!(error, Error::NotFinite { .. })),
        }
        match energy.gradient(&s) {
            Ok(g) => assert!(g.iter().all(|x| x.is_finite())),
            Err(error) => assert!(matches!(error, Error::NotFinite { .. })),
        }
        let inner = Breadth::BetweenEnds(1);
        let found = energy.solved((&space, &space), s.coeffs(), [&inner, &inner]);
        assert!(found.is_err() || found?.iter().all(|x| x.is_finite()));
    }
    assert!(matches!(
        FullEnergy::new([[1.0, f64::NAN]]),
        Err(Error::Deform(DeformError::SurfaceWeight { k: 0, l: 1, .. }))
    ));
    assert!(matches!(single(600, 0), Err(Error::DegreeTooHigh { .. })));
    let wide = SplineSpace::uniform(3, 6000, 0.0, 1.0)?;
    let plate = FullEnergy::thin_plate(1.0, 1.0)?;
    let whole = Breadth::Whole;
    let large = plate.solved((&wide, &wide), &vec![0.0; wide.dim() * wide.dim()], [&whole, &whole]);
    assert!(matches!(large, Err(Error::TooLarge { .. })));
    Ok(())
}
