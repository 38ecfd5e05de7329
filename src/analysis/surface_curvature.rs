//! Curvature of surfaces.
//!
//! With `n = S_u × S_v`, the first form `E, F, G` and the second `L, M, N` (of
//! [`second_form_at`](crate::Surface::second_form_at)):
//!
//! ```text
//! Gaussian   K = k_1 k_2 = (L N - M²) / (E G - F²) = ((S_uu·n) (S_vv·n) - (S_uv·n)²) / |n|⁴
//! mean       H = (k_1 + k_2) / 2 = (E N - 2 F M + G L) / (2 (E G - F²))
//! ```
//!
//! The principal curvatures `k_1 >= k_2` are the extreme curvatures of normal sections. A section has a positive one
//! where it bends towards the normal `n`: a sphere of radius `r` has `-1/r` both times where `n` points outwards, `1/r`
//! where it points inwards. `K` does not depend on the side, and needs no square root.
//!
//! Derivatives are taken in units of `S_u` and `S_v`, so that no product overflows or vanishes where the curvature does
//! not.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::rational::domain::Rectangle;
use crate::rational::spline::{NurbsSurface, Rational};
use crate::scalar::{Real, Scalar, larger};
use crate::tensor::spline::Surface;
use crate::vector::{cross3, dot, length, unit};
use nalgebra::{SVector, vector};

/// The principal curvatures at a point of a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct PrincipalCurvatures<T> {
    /// The greatest curvature of a normal section.
    pub greatest: T,
    /// The least one.
    pub least: T,
    /// Where they are met, the greatest first: the two directions and `n = S_u × S_v` form a right-handed frame. Both
    /// might be turned round.
    ///
    /// None at an umbilic, where all sections have the same curvature: where both are equal, or differ by less than
    /// `2^-40` of the terms they are made of, so that rounding would choose the directions.
    pub directions: Option<[PrincipalDirection<T>; 2]>,
}

/// A direction on a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct PrincipalDirection<T> {
    /// The unit vector in space.
    pub space: SVector<T, 3>,
    /// The direction `(du, dv)` in the parameter plane with `S_u du + S_v dv` that unit vector.
    pub parameters: SVector<T, 2>,
}

/// The derivatives at a point, in units of the first ones: `u` and `v` are scaled so that these are of size one.
struct Scaled<T> {
    along_u: SVector<T, 3>,
    along_v: SVector<T, 3>,
    uu: SVector<T, 3>,
    uv: SVector<T, 3>,
    vv: SVector<T, 3>,
    /// `S_u × S_v`, not zero.
    normal: SVector<T, 3>,
    /// The sizes of the first derivatives.
    units: [T; 2],
}

impl<T: Scalar> Scaled<T> {
    /// From the partial derivatives `[k][l]`, if there is a normal.
    fn new(partials: &[Vec<SVector<T, 3>>]) -> Option<Self> {
        let size = |d: &SVector<T, 3>| d.iter().map(T::magnitude).reduce(larger).expect("three components");
        let units = [size(&partials[1][0]), size(&partials[0][1])];
        if units.iter().any(|unit| unit.is_zero() || !unit.is_finite()) {
            return None;
        }
        let over = |d: &SVector<T, 3>, unit: &T| d.map(|x| x / unit);
        let [a, b] = &units;
        let (along_u, along_v) = (over(&partials[1][0], a), over(&partials[0][1], b));
        let normal = cross3(&along_u, &along_v);
        let scaled = Self {
            uu: over(&over(&partials[2][0], a), a),
            uv: over(&over(&partials[1][1], a), b),
            vv: over(&over(&partials[0][2], b), b),
            along_u,
            along_v,
            normal,
            units,
        };
        (!scaled.normal.vanishes()).then_some(scaled)
    }

    fn gaussian(&self) -> T {
        let [uu, uv, vv] = [&self.uu, &self.uv, &self.vv].map(|d| dot(d, &self.normal));
        let square = dot(&self.normal, &self.normal);
        uu / &square * (vv / &square) - uv.clone() / &square * (uv / &square)
    }
}

impl<T: Real> Scaled<T> {
    /// Both forms in an orthonormal frame: the shape operator, a symmetric matrix `[h_11, h_12, h_22]`, the sizes of
    /// what its entries are made of, and the frame as `[space, parameters]`.
    fn shape(&self) -> Option<Shape<T>> {
        let (normal, area) = unit(&self.normal)?;
        let (first, speed) = unit(&self.along_u)?;
        let second = cross3(&normal, &first);
        // S_v = shear S_u + height second
        let shear = dot(&self.along_v, &first) / &speed;
        let height = area / &speed;
        let form = |d: &dyn Fn(&SVector<T, 3>) -> T, shear: T| {
            let [uu, uv, vv] = [d(&self.uu), d(&self.uv), d(&self.vv)];
            let along = uv.clone() + shear.clone() * &uu;
            let across = vv + (uv * T::int(2) + shear.clone() * &uu) * &shear;
            [uu / &speed / &speed, along / &speed / &height, across / &height / &height]
        };
        let entries = form(&|d| dot(d, &normal), -shear.clone());
        let sizes = form(&|d| length(d), shear.magnitude());
        let [a, b] = &self.units;
        let turn = -shear / &height;
        let parameters =
            [vector![T::one() / &speed / a, T::zero()], vector![turn / a, T::one() / height / b]];
        Some(Shape { entries, sizes, axes: [first, second], parameters })
    }
}

struct Shape<T> {
    entries: [T; 3],
    sizes: [T; 3],
    axes: [SVector<T, 3>; 2],
    parameters: [SVector<T, 2>; 2],
}

impl<T: Real> Shape<T> {
    fn mean(&self) -> T {
        (self.entries[0].clone() + &self.entries[2]) / T::int(2)
    }

    fn principal(&self) -> PrincipalCurvatures<T> {
        let [first, mixed, second] = &self.entries;
        let (mean, half) = (self.mean(), (first.clone() - second) / T::int(2));
        let radius = length(&vector![half.clone(), mixed.clone()]);
        let terms = self.sizes.iter().fold(T::zero(), |sum, size| sum + size);
        let umbilic = radius <= terms * T::frac(1, 1 << 40);
        let directions = || {
            // Twice its angle has cosine half / radius and sine mixed / radius: no cancellation on either side.
            let slant = radius.clone() + half.magnitude();
            let direction =
                if half < T::zero() { vector![mixed.clone(), slant] } else { vector![slant, mixed.clone()] };
            let (direction, _) = unit(&direction)?;
            let [c, s] = [direction[0].clone(), direction[1].clone()];
            let along = |c: &T, s: &T| PrincipalDirection {
                space: self.axes[0].scaled(c).plus_scaled(s, &self.axes[1]),
                parameters: self.parameters[0].scaled(c).plus_scaled(s, &self.parameters[1]),
            };
            Some([along(&c, &s), along(&-s.clone(), &c)])
        };
        PrincipalCurvatures {
            greatest: mean.clone() + &radius,
            least: mean - &radius,
            directions: if umbilic { None } else { directions() },
        }
    }
}

/// The value, if it is finite and the surface has a normal there.
fn at_normal<T: Scalar, X>(value: Option<X>, (u, v): (&T, &T), is_finite: impl Fn(&X) -> bool) -> Result<X> {
    match value {
        Some(value) if is_finite(&value) => Ok(value),
        Some(_) => Err(Error::NotFinite { what: "curvature", index: 0 }),
        None => Err(Error::no_normal(u, v)),
    }
}

fn gaussian<T: Scalar>(partials: &[Vec<SVector<T, 3>>], at: (&T, &T)) -> Result<T> {
    at_normal(Scaled::new(partials).map(|scaled| scaled.gaussian()), at, T::is_finite)
}

fn mean<T: Real>(partials: &[Vec<SVector<T, 3>>], at: (&T, &T)) -> Result<T> {
    at_normal(Scaled::new(partials).and_then(|scaled| Some(scaled.shape()?.mean())), at, T::is_finite)
}

fn principal<T: Real>(partials: &[Vec<SVector<T, 3>>], at: (&T, &T)) -> Result<PrincipalCurvatures<T>> {
    let principal = Scaled::new(partials).and_then(|scaled| Some(scaled.shape()?.principal()));
    at_normal(principal, at, |k| k.greatest.is_finite() && k.least.is_finite())
}

impl<T: Scalar> Surface<T, 3> {
    /// The Gaussian curvature at a point.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::NoNormal`] where `S_u × S_v` vanishes; [`Error::NotFinite`] where the
    /// curvature overflows.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Q, Scalar, SplineSpace, Surface};
    /// // z = x y
    /// let line = SplineSpace::bezier(1, Q::int(0), Q::int(1))?;
    /// let corners = [[0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 1]].map(|[x, y, z]| vector![Q::int(x), Q::int(y), Q::int(z)]);
    /// let saddle = Surface::new(line.clone(), line, corners.to_vec())?;
    /// assert_eq!(saddle.gaussian_curvature_at(&Q::int(0), &Q::int(0))?, Q::int(-1));
    /// assert_eq!(saddle.gaussian_curvature_at(&Q::int(1), &Q::int(1))?, Q::frac(-1, 9));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn gaussian_curvature_at(&self, u: &T, v: &T) -> Result<T> {
        gaussian(&self.derivatives_at(u, v, 2)?, (u, v))
    }

    /// The Gaussian curvature as a rational surface: the quotient of `(S_uu·n) (S_vv·n) - (S_uv·n)²` and `|n|⁴`.
    ///
    /// Of degrees up to `8p - 4` and `8q - 4` where the surface has `p` and `q`.
    ///
    /// # Errors
    /// As [`scaled_second_form`](Self::scaled_second_form) and [`product_by`](crate::TensorSpline::product_by);
    /// [`Error::Pole`] if the normal `n` vanishes somewhere, [`Error::Undecided`] if bisection does not tell.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Q, Scalar, SplineSpace, Surface};
    /// // z = x y has K = -1 / (1 + x² + y²)²
    /// let line = SplineSpace::bezier(1, Q::int(0), Q::int(1))?;
    /// let corners = [[0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 1]].map(|[x, y, z]| vector![Q::int(x), Q::int(y), Q::int(z)]);
    /// let curvature = Surface::new(line.clone(), line, corners.to_vec())?.gaussian_curvature()?;
    /// assert_eq!(curvature.at(&Q::int(1), &Q::frac(1, 2))?, Q::frac(-16, 81));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn gaussian_curvature(&self) -> Result<Rational<Rectangle, T>> {
        let (form, normal) = (self.scaled_second_form()?, self.normal()?);
        let square = normal.dot(&normal)?;
        let determinant = form.uu.times(&form.vv)?.difference(&form.uv.times(&form.uv)?)?;
        Rational::<Rectangle, T>::from_quotient(&determinant, &square.times(&square)?)
    }
}

impl<T: Real> Surface<T, 3> {
    /// The mean curvature at a point, positive where the surface bends towards `S_u × S_v` on the average.
    ///
    /// # Errors
    /// As [`gaussian_curvature_at`](Self::gaussian_curvature_at).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{SplineSpace, Surface};
    /// // z = x y is a saddle: no mean curvature in the middle.
    /// let line = SplineSpace::bezier(1, -1.0, 1.0)?;
    /// let corners = vec![vector![-1.0, -1.0, 1.0], vector![-1.0, 1.0, -1.0], vector![1.0, -1.0, -1.0], vector![1.0, 1.0, 1.0]];
    /// assert_eq!(Surface::new(line.clone(), line, corners)?.mean_curvature_at(&0.0, &0.0)?, 0.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn mean_curvature_at(&self, u: &T, v: &T) -> Result<T> {
        mean(&self.derivatives_at(u, v, 2)?, (u, v))
    }

    /// The principal curvatures and their directions at a point.
    ///
    /// # Errors
    /// As [`gaussian_curvature_at`](Self::gaussian_curvature_at).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{SplineSpace, Surface};
    /// // z = x y bends up along the diagonal and down across.
    /// let line = SplineSpace::bezier(1, -1.0, 1.0)?;
    /// let corners = vec![vector![-1.0, -1.0, 1.0], vector![-1.0, 1.0, -1.0], vector![1.0, -1.0, -1.0], vector![1.0, 1.0, 1.0]];
    /// let saddle = Surface::new(line.clone(), line, corners)?.principal_curvatures_at(&0.0, &0.0)?;
    /// assert_eq!((saddle.greatest, saddle.least), (1.0, -1.0));
    /// let [up, _] = saddle.directions.expect("no umbilic");
    /// assert!((up.space - vector![0.5_f64.sqrt(), 0.5_f64.sqrt(), 0.0]).norm() < 1e-15);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn principal_curvatures_at(&self, u: &T, v: &T) -> Result<PrincipalCurvatures<T>> {
        principal(&self.derivatives_at(u, v, 2)?, (u, v))
    }
}

impl<T: Scalar> NurbsSurface<T, 3> {
    /// The Gaussian curvature at a point, as that of a [polynomial surface](Surface::gaussian_curvature_at).
    ///
    /// # Errors
    /// As [`Surface::gaussian_curvature_at`].
    pub fn gaussian_curvature_at(&self, u: &T, v: &T) -> Result<T> {
        gaussian(&self.derivatives_at(u, v, 2)?, (u, v))
    }
}

impl<T: Real> NurbsSurface<T, 3> {
    /// The mean curvature at a point, as that of a [polynomial surface](Surface::mean_curvature_at).
    ///
    /// # Errors
    /// As [`Surface::mean_curvature_at`].
    pub fn mean_curvature_at(&self, u: &T, v: &T) -> Result<T> {
        mean(&self.derivatives_at(u, v, 2)?, (u, v))
    }

    /// The principal curvatures and their directions at a point, as those of a
    /// [polynomial surface](Surface::principal_curvatures_at).
    ///
    /// # Errors
    /// As [`Surface::principal_curvatures_at`].
    pub fn principal_curvatures_at(&self, u: &T, v: &T) -> Result<PrincipalCurvatures<T>> {
        principal(&self.derivatives_at(u, v, 2)?, (u, v))
    }
}
