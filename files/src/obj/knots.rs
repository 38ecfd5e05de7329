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

/// The full knots of one parameter: as they are told, or from the breaks of Bezier pieces.
///
/// # Errors
/// For breaks that do not increase, and those of [`SplineSpace::clamped`].
pub(super) fn full_knots(kind: Kind, degree: usize, values: &[f64]) -> Result<Vec<f64>, Problem> {
    Ok(match kind {
        Kind::Bspline => values.to_vec(),
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
            SplineSpace::clamped(degree, [first].into_iter().chain(copies).chain([last]))?.knots().to_vec()
        }
    })
}
