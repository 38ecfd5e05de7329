//! Laws of areas, volumes and their moments: the divergence theorem, and what maps do to a volume.
//!
//! The closed body is a box under a polynomial map of space. Its six faces are surfaces; the integral over the box of
//! the polynomials in question times the functional determinant is worked out term by term.

use super::outer;
use crate::strategies::{Kind, RING, SMOOTH, cases, point, surface};
use nalgebra::{SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use std::collections::BTreeMap;
use std::ops::{Add, Mul};
use symspline::Direction::{U, V};
use symspline::{Curve, Function, Q, Result, Scalar, Surface, TensorSpline};

/// The highest power of a variable in a map.
const MOST: usize = 2;

/// A polynomial in three variables: exponents and their factors.
#[derive(Clone, Debug, Default)]
struct Polynomial(BTreeMap<[usize; 3], Q>);

impl Polynomial {
    /// The sum of terms.
    fn of(terms: impl IntoIterator<Item = ([usize; 3], Q)>) -> Self {
        let mut sum = Self::default();
        terms.into_iter().for_each(|(powers, c)| *sum.0.entry(powers).or_insert(Q::int(0)) += c);
        sum
    }

    /// The partial derivative.
    fn derivative(&self, axis: usize) -> Self {
        Self::of(self.0.iter().filter(|(powers, _)| powers[axis] > 0).map(|(powers, c)| {
            let mut lower = *powers;
            lower[axis] -= 1;
            (lower, c.clone() * Q::int(powers[axis] as i64))
        }))
    }

    fn scaled(&self, factor: i64) -> Self {
        Self::of(self.0.iter().map(|(powers, c)| (*powers, c.clone() * Q::int(factor))))
    }

    fn raised(&self, power: usize) -> Self {
        (0..power).fold(Self::of([([0; 3], Q::int(1))]), |product, _| &product * self)
    }

    /// The integral over a box.
    fn integral(&self, sides: &[[Q; 2]; 3]) -> Q {
        let side = |[a, b]: &[Q; 2], n: usize| {
            let power = |x: &Q| (0..=n).fold(Q::int(1), |product, _| product * x);
            (power(b) - power(a)) / Q::int(n as i64 + 1)
        };
        let term = |(powers, c): (&[usize; 3], &Q)| {
            (0..3).fold(c.clone(), |product, i| product * side(&sides[i], powers[i]))
        };
        self.0.iter().map(term).sum()
    }

    /// What is left over when variable `axis` stands still at `x`; the next two in turn are `u` and `v`.
    fn face(&self, axis: usize, x: &Q, sides: &[[Q; 2]; 3]) -> Result<TensorSpline<Q>> {
        let monomial = |i: usize, power: usize| {
            Function::monomial(power, sides[i][0].clone(), sides[i][1].clone())?.elevated(MOST - power)
        };
        let (first, second) = ((axis + 1) % 3, (axis + 2) % 3);
        let zero = outer(&monomial(first, 0)?, &monomial(second, 0)?)?.scaled(&Q::int(0))?;
        self.0.iter().try_fold(zero, |sum, (powers, c)| {
            let term = outer(&monomial(first, powers[first])?, &monomial(second, powers[second])?)?;
            let factor = (0..powers[axis]).fold(c.clone(), |product, _| product * x);
            sum.plus_scaled(&factor, &term)
        })
    }
}

impl Add for &Polynomial {
    type Output = Polynomial;

    fn add(self, other: Self) -> Polynomial {
        Polynomial::of(self.0.iter().chain(&other.0).map(|(powers, c)| (*powers, c.clone())))
    }
}

impl Mul for &Polynomial {
    type Output = Polynomial;

    fn mul(self, other: Self) -> Polynomial {
        let pairs = self.0.iter().flat_map(|x| other.0.iter().map(move |y| (x, y)));
        Polynomial::of(pairs.map(|((p, c), (q, d))| ([p[0] + q[0], p[1] + q[1], p[2] + q[2]], c.clone() * d)))
    }
}

/// A box and a polynomial map of it.
#[derive(Clone, Debug)]
struct Body {
    sides: [[Q; 2]; 3],
    map: [Polynomial; 3],
}

impl Body {
    /// The six faces, their normals outwards as far as the map keeps orientation.
    fn faces(&self) -> Result<Vec<Surface<Q, 3>>> {
        let ends = (0..3).flat_map(|axis| self.sides[axis].iter().enumerate().map(move |end| (axis, end)));
        let face = |(axis, (end, x)): (usize, (usize, &Q))| {
            let [f, g, h] = [0, 1, 2].map(|i| self.map[i].face(axis, x, &self.sides));
            let (f, g, h) = (f?, g?, h?);
            let heights = g.coeffs().iter().zip(h.coeffs());
            let points =
                f.coeffs().iter().zip(heights).map(|(x, (y, z))| vector![x.clone(), y.clone(), z.clone()]);
            let face = Surface::new(f.u().clone(), f.v().clone(), points.collect())?;
            Ok(if end == 1 { face } else { face.transposed() })
        };
        ends.map(face).collect()
    }

    /// `∭ x^a y^b z^c dV` over the image, by substitution.
    fn moment(&self, powers: [usize; 3]) -> Q {
        let d = |i: usize, axis: usize| self.map[i].derivative(axis);
        let minor = |i: usize, j: usize| &(&d(1, i) * &d(2, j)) + &(&d(1, j) * &d(2, i)).scaled(-1);
        let determinant =
            &(&(&d(0, 0) * &minor(1, 2)) + &(&d(0, 1) * &minor(2, 0))) + &(&d(0, 2) * &minor(0, 1));
        let weight = (0..3).fold(determinant, |product, i| &product * &self.map[i].raised(powers[i]));
        weight.integral(&self.sides)
    }
}

fn small() -> impl Strategy<Value = Q> {
    (-4_i64..=4, 1_i64..=3).prop_map(|(n, d)| Q::frac(n, d))
}

fn body() -> impl Strategy<Value = Body> {
    let side = || (small(), 1_i64..=3).prop_map(|(a, length)| [a.clone(), a + Q::int(length)]);
    let power = || [0..=MOST, 0..=MOST, 0..=MOST];
    let coordinate = || vec((power(), small()), 1..5).prop_map(Polynomial::of);
    ([side(), side(), side()], [coordinate(), coordinate(), coordinate()])
        .prop_map(|(sides, map)| Body { sides, map })
}

fn origin() -> SVector<Q, 3> {
    SVector::zeros()
}

/// The sum of a moment of all faces.
fn total(faces: &[Surface<Q, 3>], powers: [usize; 3]) -> Result<Q> {
    faces.iter().try_fold(Q::int(0), |sum, face| Ok(sum + face.volume_moment(powers)?))
}

proptest! {
    #![proptest_config(cases(8))]

    #[test]
    fn the_divergence_theorem(body in body(), powers in [0_usize..2, 0_usize..2, 0_usize..2]) {
        let faces = body.faces()?;
        for powers in [[0, 0, 0], powers] {
            prop_assert_eq!(total(&faces, powers)?, body.moment(powers), "{:?}", powers);
        }
    }

    #[test]
    fn the_vector_area_of_a_closed_body_vanishes(body in body()) {
        let areas = body.faces()?.iter().map(Surface::vector_area).collect::<Result<Vec<_>>>()?;
        prop_assert_eq!(areas.iter().fold(origin(), |sum, area| sum + area), origin());
    }

    #[test]
    fn moved_bodies_keep_their_volume(body in body(), by in [small(), small(), small()]) {
        let faces = body.faces()?;
        let by = vector![by[0].clone(), by[1].clone(), by[2].clone()];
        let moved = faces.iter().map(|face| face.translated(&by)).collect::<Result<Vec<_>>>()?;
        let (volume, axes) = (total(&faces, [0, 0, 0])?, [[1, 0, 0], [0, 1, 0], [0, 0, 1]]);
        prop_assert_eq!(&total(&moved, [0, 0, 0])?, &volume);
        for (i, axis) in axes.into_iter().enumerate() {
            prop_assert_eq!(total(&moved, axis)?, total(&faces, axis)? + by[i].clone() * &volume);
        }
    }
}

/// Surfaces of low degree.
const SHAPE: Kind = SMOOTH.few(1).of_degree(1, 2);
const TUBE: Kind = RING.smooth(1).few(2).of_degree(1, 2);

proptest! {
    #![proptest_config(cases(12))]

    #[test]
    fn a_torus_is_closed(s in surface::<3>(TUBE, TUBE), by in point::<3>()) {
        prop_assert_eq!(s.vector_area()?, origin());
        let (volume, moved) = (s.volume_moment([0, 0, 0])?, s.translated(&by)?);
        prop_assert_eq!(&moved.volume_moment([0, 0, 0])?, &volume);
        prop_assert_eq!(s.transposed().volume_moment([0, 0, 0])?, -volume);
    }

    #[test]
    fn a_linear_map_scales_the_volume_by_its_determinant(
        s in surface::<3>(SHAPE, SHAPE),
        [a, b, c] in [point::<3>(), point::<3>(), point::<3>()],
    ) {
        let dot = |x: &SVector<Q, 3>, y: &SVector<Q, 3>| {
            x.iter().zip(y.iter()).map(|(x, y)| x.clone() * y).sum::<Q>()
        };
        let image = |p: &SVector<Q, 3>| vector![dot(&a, p), dot(&b, p), dot(&c, p)];
        let mapped = Surface::new(s.u().clone(), s.v().clone(), s.coeffs().iter().map(image).collect())?;
        let minor = |i: usize, j: usize| b[i].clone() * &c[j] - b[j].clone() * &c[i];
        let determinant = dot(&a, &vector![minor(1, 2), minor(2, 0), minor(0, 1)]);
        prop_assert_eq!(mapped.volume_moment([0, 0, 0])?, determinant * s.volume_moment([0, 0, 0])?);
    }

    #[test]
    fn an_affine_map_scales_the_area_by_its_determinant(
        s in surface::<2>(SHAPE, SHAPE),
        [a, b, shift] in [point::<2>(), point::<2>(), point::<2>()],
    ) {
        let image = |p: &SVector<Q, 2>| {
            let [x, y] = [&p[0], &p[1]];
            vector![a[0].clone() * x + b[0].clone() * y, a[1].clone() * x + b[1].clone() * y] + &shift
        };
        let mapped = Surface::new(s.u().clone(), s.v().clone(), s.coeffs().iter().map(image).collect())?;
        let determinant = a[0].clone() * &b[1] - a[1].clone() * &b[0];
        let (area, mean) = (s.area_moment([0, 0])?, [s.area_moment([1, 0])?, s.area_moment([0, 1])?]);
        prop_assert_eq!(mapped.area_moment([0, 0])?, determinant.clone() * &area);
        for (k, powers) in [[1, 0], [0, 1]].into_iter().enumerate() {
            let expected = a[k].clone() * &mean[0] + b[k].clone() * &mean[1] + shift[k].clone() * &area;
            prop_assert_eq!(mapped.area_moment(powers)?, determinant.clone() * expected);
        }
    }

    #[test]
    fn the_theorem_of_green(s in surface::<2>(SHAPE, SHAPE), (k, l) in (0_usize..3, 0_usize..3)) {
        let ((a, b), (c, d)) = (s.u().domain(), s.v().domain());
        // Once round: along u below, along v on the right, and back.
        let walk = [(V, c, 1), (U, b, 1), (V, d, -1), (U, a, -1)];
        // The field (0, x^(k+1) y^l / (k + 1)) has the curl x^k y^l.
        let along = |curve: &Curve<Q, 2>| {
            let [x, y] = [curve.coordinate(0)?, curve.coordinate(1)?];
            let field = (0..=k).map(|_| &x).chain((0..l).map(|_| &y));
            field.into_iter().try_fold(y.derivative()?, |product, factor| product.times(factor))?.integral()
        };
        let mut sum = Q::int(0);
        for (direction, x, sign) in walk {
            sum += along(&s.isocurve(direction, x)?)? * Q::int(sign);
        }
        prop_assert_eq!(s.area_moment([k, l])?, sum / Q::int(k as i64 + 1));
    }
}
