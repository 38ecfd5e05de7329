//! The knots of free-form elements.

use crate::error::Problem;
use symspline::SplineSpace;

/// The types of curves that are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// All knots are told.
    Bspline,
    /// The breaks between the pieces are told.
    Bezier,
}

/// The space of one parameter: from all knots, or from the breaks of Bezier pieces.
///
/// # Errors
/// Those of [`SplineSpace::new`].
pub(super) fn space(kind: Kind, degree: usize, values: &[f64]) -> Result<SplineSpace<f64>, Problem> {
    Ok(match kind {
        Kind::Bspline => SplineSpace::new(degree, values.iter().copied())?,
        Kind::Bezier => {
            // A degree is a word of the file: nothing is made of it before it is checked.
            if degree > symspline::limits::MAX_DEGREE {
                let limit = symspline::limits::MAX_DEGREE;
                return Err(symspline::Error::DegreeTooHigh { degree, limit }.into());
            }
            if degree == 0 || values.len() < 2 {
                return Err(Problem::Syntax("Bezier pieces need a degree and two breaks at least".into()));
            }
            if let Some(index) = values.windows(2).position(|pair| pair[0] >= pair[1]) {
                return Err(Problem::Syntax(format!("break {} is not above the one before", index + 2)));
            }
            let inner = &values[1..values.len() - 1];
            let copies = inner.iter().flat_map(|t| std::iter::repeat_n(*t, degree));
            let (first, last) = (values[0], values[values.len() - 1]);
            SplineSpace::clamped(degree, [first].into_iter().chain(copies).chain([last]))?
        }
    })
}
