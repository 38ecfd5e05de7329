//! One field for things that meet: over floats if any of them is, as with numbers.

use crate::any::{Any, Family};
use crate::error::Result;
use crate::number::Number;
use crate::over::{AnyMesh, AnySpace, Coords};
use crate::value::Value;
use std::borrow::Cow;

/// What is over one field or the other and can be taken to floats.
pub trait Meeting: Clone {
    /// Whether it is over the rationals.
    fn exact(&self) -> bool;

    /// The same rounded to floats.
    ///
    /// # Errors
    /// Those of the library: knots may fall together.
    fn rounded(&self) -> Result<Self>;

    /// As it is among things that are all exact, else over floats.
    ///
    /// # Errors
    /// As [`rounded`](Self::rounded).
    fn among(&self, all_exact: bool) -> Result<Cow<'_, Self>> {
        Ok(if self.exact() && !all_exact { Cow::Owned(self.rounded()?) } else { Cow::Borrowed(self) })
    }
}

macro_rules! meeting {
    ($($type:ty),+) => {
        $(meeting!(@ (), $type);)+
    };
    (@ ($($family:ident)?), $type:ty) => {
        impl$(<$family: Family>)? Meeting for $type {
            fn exact(&self) -> bool {
                self.is_exact()
            }

            fn rounded(&self) -> Result<Self> {
                self.to_float()
            }
        }
    };
}

meeting!(Number, Coords, AnySpace, AnyMesh, Value);
meeting!(@ (F), Any<F>);

/// One field for all these variables: each becomes a [`Cow`] of itself, over floats if any of them is.
///
/// ```
/// use symspline::{Q, Scalar};
/// use symspline_dynamic::{Number, Over, together};
/// # fn main() -> symspline_dynamic::Result<()> {
/// let (x, y) = (&Number::Exact(Q::frac(1, 2)), &Number::Float(0.25));
/// together!(x, y);
/// assert_eq!((&*x, &*y), (&Over::Float(0.5), &Over::Float(0.25)));
/// # Ok(())
/// # }
/// ```
#[macro_export]
macro_rules! together {
    ($($x:ident),+) => {
        let exact = true $(&& $crate::meeting::Meeting::exact($x))+;
        $(let $x = $crate::meeting::Meeting::among($x, exact)?;)+
    };
}
