//! Pieces of splines: joining, cutting, the seam of rings, powers.

use crate::error::Result;
use crate::numbers::{Array, Num};
use crate::space::Space;
use crate::spline::Spline;
use pyo3::prelude::*;
use std::borrow::Cow;
use symspline::PowerForm;
use symspline_dynamic::number::flat;
use symspline_dynamic::{
    Any, Coords, Error, Field, Meeting as _, Spaced, alike, each, together, with_points,
};

#[pymethods]
impl Spline {
    /// This and then another, which starts where this ends; a jump may be between.
    fn join(&self, py: Python<'_>, other: &Self) -> Result<Self> {
        let (s, t) = (&self.0, &other.0);
        together!(s, t);
        py.detach(|| alike!(&*s, &*t, s, t => Ok(Self(s.join(t)?.into()))))
    }

    /// As `join`, for splines that meet in value exactly: one coefficient is shared.
    fn join_continuous(&self, py: Python<'_>, other: &Self) -> Result<Self> {
        let (s, t) = (&self.0, &other.0);
        together!(s, t);
        py.detach(|| alike!(&*s, &*t, s, t => Ok(Self(s.join_continuous(t)?.into()))))
    }

    /// The same ring with its seam at another parameter.
    fn with_seam_at(&self, x: Num) -> Result<Self> {
        let (s, x) = (&self.0, &x.0);
        together!(s, x);
        each!(&*s, T, s => Ok(Self(s.with_seam_at(&T::of(&x)?)?.into())))
    }

    /// The same with single outer knots; a ring is opened.
    fn unclamped_ends(&self) -> Result<Self> {
        each!(&self.0, s => Ok(Self(s.unclamped_ends()?.into())))
    }

    /// The polynomial pieces, one a span, each on its own interval with Bernstein coefficients.
    fn bezier_pieces(&self, py: Python<'_>) -> Result<Vec<Self>> {
        py.detach(|| each!(&self.0, s => Ok(s.bezier_pieces()?.into_iter().map(|piece| Self(piece.into())).collect())))
    }

    /// The breaks, of shape `(n + 1,)`, and for each interval the coefficients of the powers of `x` less its left end, low ones
    /// first: shape `(n, degree + 1)` or `(n, degree + 1, d)`.
    fn to_power_form(&self, py: Python<'_>) -> Result<(Array, Array)> {
        py.detach(|| {
            each!(&self.0, T, s => {
                let form = s.to_power_form();
                let shape = vec![form.pieces().len(), form.degree() + 1];
                let coeffs = flat::<T, _>(&form.pieces().concat());
                Ok((Array::row::<T>(form.breaks().to_vec()), Array::points(shape, self.0.dim(), coeffs)))
            })
        })
    }

    /// The spline with this power form, in the smallest space that holds it; or in `space`, to `tolerance`, the largest distance of
    /// values.
    #[staticmethod]
    #[pyo3(signature = (breaks, pieces, space=None, tolerance=Num::int(0)))]
    fn from_power_form(
        py: Python<'_>,
        breaks: Array,
        pieces: Array,
        space: Option<Space>,
        tolerance: Num,
    ) -> Result<Self> {
        let (dim, count) = (pieces.dim(2)?, pieces.shape[1].max(1));
        let (breaks, coeffs) = (&breaks.list()?, &pieces.numbers);
        let exact = space.as_ref().is_none_or(|space| space.0.is_exact());
        let (breaks, coeffs) = (&breaks.among(exact)?, &coeffs.among(exact)?);
        let (breaks, coeffs): (&Coords, &Coords) = (breaks, coeffs);
        together!(breaks, coeffs);
        let space = space.map(|space| space.0.among(coeffs.is_exact()).map(Cow::into_owned)).transpose()?;
        py.detach(|| {
            with_points!(&*coeffs, dim, T, c => {
                let pieces = c.chunks(count).map(<[_]>::to_vec).collect();
                let form = PowerForm::new(T::all_of(&breaks)?, pieces)?;
                Ok(Self(match &space {
                    None => form.to_smallest_spline()?.into(),
                    Some(space) => form.to_spline(<T as Spaced>::space(space)?, &T::of(&tolerance.0)?)?.into(),
                }))
            })
        })
    }

    /// The indices of the control points of a plane curve that span their convex hull, in turn.
    fn control_hull(&self) -> Result<Vec<usize>> {
        match &self.0 {
            Any::F2(s) => Ok(s.control_hull()),
            Any::Q2(s) => Ok(s.control_hull()),
            other => Err(Error::Dimensions { left: 2, right: other.dim() }.into()),
        }
    }
}
