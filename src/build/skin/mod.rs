//! Skins: surfaces through sections.
//!
//! Sections are brought into one space: affinely to the domain of the first, then into the union of their spaces. That changes
//! none of them, so that control points with the same index stand for the same parameters. Then a skin is a spline across, in `v`,
//! of rows of control points:
//!
//! ```text
//! S(u, v_k) = C_k(u)       ∂S/∂v (u, v_0) = A(u),   ∂S/∂v (u, v_n) = B(u)   if asked for
//! ```
//! is one banded system for all rows together [NURBS, section 10.3], whose cost is linear in the number of sections. Knots across
//! are means of parameters, those of ends with a tangent taken twice. Over an exact field sections and tangents are met exactly.

pub mod chords;
pub mod neighbour;

use crate::build::parameters::interpolation_space;
use crate::coeff::Coeff;
use crate::error::skin::SkinError;
use crate::error::{Error, Result};
use crate::knots::KnotVector;
use crate::limits::check_dim;
use crate::row::Row;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;
use crate::tensor::spline::TensorSpline;
use std::cmp::Ordering;
use std::iter::{once, repeat_n};

/// A surface through sections, as it is asked for: `u` runs along the sections, `v` across.
///
/// Sections may have any degrees and knots. If all are periodic the surface is periodic in `u`, otherwise it is open, with clamped
/// ends unless all outer knots agree. Parameters across are uniform at first, others can be [given](Self::with_parameters) or
/// [measured](Self::by_chord_length). The sections of a [closed](Self::closed_through) skin come round again.
///
/// Sections with many different knots make a surface that has all of them.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{Curve, Direction, Q, Scalar, Skin, SplineSpace};
/// let q = |x: i64, y: i64, z: i64| vector![Q::int(x), Q::int(y), Q::int(z)];
/// let line = Curve::new(SplineSpace::bezier(1, Q::int(0), Q::int(1))?, vec![q(0, 0, 0), q(4, 0, 0)])?;
/// let arch = Curve::new(SplineSpace::clamped(2, [0, 1, 2].map(Q::int))?, vec![q(0, 1, 0), q(1, 1, 2), q(3, 1, 2), q(4, 1, 0)])?;
/// let end = line.translated(&q(0, 3, 0))?;
/// let skin = Skin::through(&[line, arch, end])?.with_parameters(&[0, 1, 3].map(Q::int))?;
/// let surface = skin.surface(2)?;
/// assert_eq!(surface.isocurve(Direction::V, &Q::int(1))?, skin.sections()[1]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[doc(alias = "loft")]
#[derive(Clone, Debug, PartialEq)]
pub struct Skin<T, C = T> {
    /// Over one space.
    sections: Vec<Spline<T, C>>,
    /// One for each section; of a closed skin one more, where the first section comes again.
    parameters: Vec<T>,
    closed: bool,
    start: Option<Spline<T, C>>,
    end: Option<Spline<T, C>>,
}

impl<T: Scalar, C: Coeff<T>> Skin<T, C> {
    /// A skin from the first to the last of the sections, at parameters that divide `[0, 1]` evenly.
    ///
    /// # Errors
    /// [`SkinError::TooFewSections`] for less than two; [`SkinError::Section`] with the section that cannot be brought into one
    /// space with the others; [`Error::TooLarge`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, Function, Skin, SkinError};
    /// let [line, square] = [1, 2].map(|power| Function::monomial(power, 0.0, 1.0));
    /// let (line, square) = (line?, square?);
    /// let ruled = Skin::through(&[line.clone(), square])?.surface(1)?;
    /// assert_eq!(ruled.at(&0.5, &0.5)?, 0.375);
    /// let alone = Skin::through(&[line]).unwrap_err();
    /// assert_eq!(alone, Error::Skin(SkinError::TooFewSections { expected: 2, found: 1 }));
    /// # Ok::<(), Error>(())
    /// ```
    #[doc(alias = "ruled surface")]
    pub fn through(sections: &[Spline<T, C>]) -> Result<Self> {
        Self::over(sections, false)
    }

    /// A skin through the sections and back to the first, periodic in `v`.
    ///
    /// # Errors
    /// As [`through`](Self::through).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Skin};
    /// let sections = [0.0, 1.0, 3.0].map(|c| Function::monomial(1, 0.0, 1.0).and_then(|f| f.translated(&c)));
    /// let [a, b, c] = sections;
    /// let ring = Skin::closed_through(&[a?, b?, c?])?.surface(3)?;
    /// assert!(ring.v().is_periodic());
    /// assert!((ring.at(&0.5, &1.0)? - 0.5).abs() < 1e-14);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn closed_through(sections: &[Spline<T, C>]) -> Result<Self> {
        Self::over(sections, true)
    }

    fn over(sections: &[Spline<T, C>], closed: bool) -> Result<Self> {
        let (first, count) = match sections {
            [first, _, ..] => (first, sections.len()),
            _ => return Err(SkinError::TooFewSections { expected: 2, found: sections.len() }.into()),
        };
        let moved = |section: &Spline<T, C>| onto(first.space(), section);
        let sections = each(sections, moved)?;
        let mut space = first.space().clone();
        for (index, section) in sections.iter().enumerate() {
            space = space.union(section.space()).map_err(|error| named(index, error))?;
        }
        check_dim(space.dim().saturating_mul(count))?;
        let sections = each(&sections, |section| section.embedded(&space))?;
        let last = (count - usize::from(!closed)) as i64;
        let parameters = (0..=last).map(|k| T::frac(k, last)).collect();
        Ok(Self { sections, parameters, closed, start: None, end: None })
    }

    /// The sections in one space, those that the surface meets.
    pub fn sections(&self) -> &[Spline<T, C>] {
        &self.sections
    }

    /// The parameters of the sections; of a closed skin one more, where the first section comes again.
    pub fn parameters(&self) -> &[T] {
        &self.parameters
    }

    /// The same with other parameters, in ascending order: one for each section, of a closed skin one more for the end of the
    /// period.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`]; [`Error::NotFinite`]; [`SkinError::NotAfter`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, Function, Skin, SkinError};
    /// let sections = [Function::monomial(1, 0.0, 1.0)?, Function::monomial(2, 0.0, 1.0)?];
    /// let refused = Skin::through(&sections)?.with_parameters(&[1.0, 1.0]).unwrap_err();
    /// assert_eq!(refused, Error::Skin(SkinError::NotAfter { index: 1, parameter: "1".into(), before: "1".into() }));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn with_parameters(mut self, parameters: &[T]) -> Result<Self> {
        let (expected, found) = (self.parameters.len(), parameters.len());
        if found != expected {
            return Err(Error::CoefficientCount { expected, found });
        }
        if let Some(index) = parameters.iter().position(|v| !v.is_finite()) {
            return Err(Error::NotFinite { what: "parameter", index });
        }
        let rises = |pair: &[T]| pair[0].partial_cmp(&pair[1]) == Some(Ordering::Less);
        if let Some(before) = parameters.windows(2).position(|pair| !rises(pair)) {
            let [before, index] = [before, before + 1];
            let (parameter, before) = (parameters[index].to_string(), parameters[before].to_string());
            return Err(SkinError::NotAfter { index, parameter, before }.into());
        }
        self.parameters = parameters.to_vec();
        Ok(self)
    }

    /// The same with `∂S/∂v` given at the first section, as a spline along it.
    ///
    /// # Errors
    /// [`SkinError::ClosedHasNoEnds`]; those of [`reparametrised`](Spline::reparametrised) to the domain of the sections.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, Scalar, Skin, SplineSpace};
    /// let level = |c: i64| Function::constant(SplineSpace::bezier(1, Q::int(0), Q::int(1))?, Q::int(c));
    /// let surface = Skin::through(&[level(0)?, level(1)?])?.start_tangents(&level(0)?)?.surface(2)?;
    /// assert_eq!(surface.at(&Q::int(0), &Q::frac(1, 3))?, Q::frac(1, 9));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn start_tangents(mut self, tangents: &Spline<T, C>) -> Result<Self> {
        self.start = Some(self.tangents(tangents)?);
        Ok(self)
    }

    /// The same with `∂S/∂v` given at the last section, as a spline along it.
    ///
    /// # Errors
    /// As [`start_tangents`](Self::start_tangents).
    pub fn end_tangents(mut self, tangents: &Spline<T, C>) -> Result<Self> {
        self.end = Some(self.tangents(tangents)?);
        Ok(self)
    }

    fn tangents(&self, tangents: &Spline<T, C>) -> Result<Spline<T, C>> {
        if self.closed {
            return Err(SkinError::ClosedHasNoEnds.into());
        }
        onto(self.sections[0].space(), tangents)
    }

    /// The surface, of `degree` across, as smooth there as simple knots allow.
    ///
    /// Open skins have clamped ends and the knots of [`interpolation_space`]. Knots of closed ones are the parameters if the degree
    /// is odd, and halfway between them if it is even, where the domain begins before the first section.
    ///
    /// # Errors
    /// [`SkinError::TooFewSections`] unless there are, tangents included, more than `degree`; [`Error::DegreeTooLow`] if tangents
    /// are given and the degree is below 2; [`Error::TooLarge`], [`Error::DegreeTooHigh`]; [`Error::Singular`] for a closed skin of
    /// even degree above 2 on uneven parameters that leave a freedom; in `f64` [`Error::SpanOutOfRange`], [`Error::Multiplicity`] or
    /// [`Error::KnotsDecrease`] if parameters are so near that knots fall together.
    ///
    /// # Examples
    /// See [`Skin`].
    pub fn surface(&self, degree: usize) -> Result<TensorSpline<T, C>> {
        self.surface_in(&if self.closed { self.ring(degree)? } else { self.averaged(degree)? })
    }

    /// The surface with a given space across, which has as many coefficients as there are sections and tangents.
    ///
    /// # Errors
    /// Those of [`Spline::osculating`], [`Error::Undetermined`] among them, where data are sections and tangents;
    /// [`SkinError::SpaceNotClosed`] for a closed skin unless the space is periodic.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, Function, Skin, SplineSpace};
    /// let sections = [Function::monomial(1, 0.0, 1.0)?, Function::monomial(2, 0.0, 1.0)?];
    /// let late = SplineSpace::bezier(1, 0.5, 1.0)?;
    /// assert!(matches!(Skin::through(&sections)?.surface_in(&late), Err(Error::OutsideDomain { .. })));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn surface_in(&self, space: &SplineSpace<T>) -> Result<TensorSpline<T, C>> {
        if self.closed && !space.is_periodic() {
            return Err(SkinError::SpaceNotClosed.into());
        }
        let tangents = self.start.iter().chain(&self.end);
        let along = tangents
            .clone()
            .try_fold(self.sections[0].space().clone(), |along, tangents| along.union(tangents.space()))?;
        check_dim(along.dim().saturating_mul(self.sections.len() + 2))?;
        let row = |spline: &Spline<T, C>| Ok(Row(spline.embedded(&along)?.into_coeffs()));
        let mut rows = each(&self.sections, row)?;
        if let Some(start) = &self.start {
            rows.insert(1, row(start)?);
        }
        if let Some(end) = &self.end {
            rows.push(row(end)?);
        }
        let across = Spline::osculating(space, &self.listed(), &rows)?;
        Ok(TensorSpline::from_spline_of_rows(across, along)?.transposed())
    }

    /// The parameters of all data: those of ends with tangents twice, without the end of a period.
    fn listed(&self) -> Vec<T> {
        let last = self.sections.len() - 1;
        let copies = |k: usize| {
            1 + usize::from(k == 0 && self.start.is_some()) + usize::from(k == last && self.end.is_some())
        };
        let repeated = |(k, v): (usize, &T)| repeat_n(v.clone(), copies(k));
        self.parameters[..=last].iter().enumerate().flat_map(repeated).collect()
    }

    /// The clamped space across.
    fn averaged(&self, degree: usize) -> Result<SplineSpace<T>> {
        let (listed, found) = (self.listed(), self.sections.len());
        let tangents = listed.len() - found;
        if tangents > 0 && degree < 2 {
            return Err(Error::DegreeTooLow { degree, needed: 2 });
        }
        let expected = degree.saturating_add(1).saturating_sub(tangents);
        if found < expected {
            return Err(SkinError::TooFewSections { expected, found }.into());
        }
        interpolation_space(degree, &listed)
    }

    /// The periodic space across.
    fn ring(&self, degree: usize) -> Result<SplineSpace<T>> {
        let (v, last) = (&self.parameters, self.sections.len());
        if degree % 2 == 1 {
            return SplineSpace::joined(
                degree,
                &KnotVector::new(v[..last].iter().cloned())?,
                v[last].clone(),
            );
        }
        let middle = |pair: &[T]| pair[0].clone() + (pair[1].clone() - &pair[0]) / T::int(2);
        let middles: Vec<T> = v.windows(2).map(middle).collect();
        let seam = v[0].clone() - (v[last].clone() - &middles[last - 1]);
        let round = KnotVector::new(once(seam).chain(middles[..last - 1].iter().cloned()))?;
        SplineSpace::joined(degree, &round, middles[last - 1].clone())
    }
}

/// The spline moved to the domain of `space`.
fn onto<T: Scalar, C: Coeff<T>>(space: &SplineSpace<T>, spline: &Spline<T, C>) -> Result<Spline<T, C>> {
    let (a, b) = space.domain();
    if spline.domain() == (a, b) { Ok(spline.clone()) } else { spline.reparametrised(a, b) }
}

/// What `f` makes of each section, or the first error with the section it belongs to.
fn each<S, R>(sections: &[S], f: impl Fn(&S) -> Result<R>) -> Result<Vec<R>> {
    let numbered = |(index, section)| f(section).map_err(|error| named(index, error));
    sections.iter().enumerate().map(numbered).collect()
}

/// The error of section `index`.
fn named(index: usize, error: Error) -> Error {
    SkinError::Section { index, reason: Box::new(error) }.into()
}
