//! What splines of one and of two parameters have in common, so that rational ones of both are one text.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::ops::enclose::{Enclosure, enclose};
use crate::ops::sign::{Sign, sign_of};
use crate::scalar::Scalar;
use crate::spline::Spline;
use crate::tensor::spline::TensorSpline;
use crate::weighted::Weighted;
use std::fmt::Debug;

mod sealed {
    /// Only the kinds of this file have it.
    pub trait Sealed {}
    impl Sealed for super::Interval {}
    impl Sealed for super::Rectangle {}
}

/// A kind of parameter domain, and the splines over it.
pub trait Domain<T: Scalar>: Clone + Debug + PartialEq + sealed::Sealed {
    /// The splines over such a domain.
    type Spline<C: Coeff<T>>: Clone + Debug + PartialEq;

    /// The coefficients.
    fn coeffs<C: Coeff<T>>(spline: &Self::Spline<C>) -> &[C];

    /// Puts new coefficients in the place of others. On an error nothing has changed.
    ///
    /// # Errors
    /// As [`Spline::replace_coeffs`].
    fn replace_coeffs<C: Coeff<T>>(spline: &mut Self::Spline<C>, new: Vec<(usize, C)>) -> Result<()>;

    /// The spline over the same spaces with every coefficient replaced.
    ///
    /// # Errors
    /// [`NotFinite`](crate::Error::NotFinite).
    fn map_coeffs<C: Coeff<T>, D: Coeff<T>>(
        spline: &Self::Spline<C>,
        f: impl Fn(&C) -> D,
    ) -> Result<Self::Spline<D>>;

    /// The product under a bilinear pairing of coefficients.
    ///
    /// # Errors
    /// As [`Spline::product_by`].
    fn product<A: Coeff<T>, B: Coeff<T>, C: Coeff<T>>(
        left: &Self::Spline<A>,
        right: &Self::Spline<B>,
        pair: impl Fn(&A, &B) -> C,
    ) -> Result<Self::Spline<C>>;

    /// Both written in the unions of their spaces, coefficients paired.
    ///
    /// # Errors
    /// As [`Spline::sum`].
    fn paired<A: Coeff<T>, B: Coeff<T>, C: Coeff<T>>(
        left: &Self::Spline<A>,
        right: &Self::Spline<B>,
        pair: impl Fn(&A, &B) -> C,
    ) -> Result<Self::Spline<C>>;

    /// The parameters.
    type Parameter: Debug;

    /// The extreme values of a quotient with positive weights.
    ///
    /// # Errors
    /// As [`Function::range`](crate::Function::range).
    fn range(lifted: &Self::Spline<Weighted<T>>, accuracy: &T) -> Result<Enclosure<T, Self::Parameter>>;

    /// The sign of all values of a scalar spline.
    ///
    /// # Errors
    /// [`Pole`](crate::Error::Pole) if there is a zero, [`Undecided`](crate::Error::Undecided) if bisection does not tell.
    fn sign(spline: &Self::Spline<T>) -> Result<Sign>;
}

/// The domains of curves and functions: their splines are [`Spline`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Interval;

/// The domains of surfaces: their splines are [`TensorSpline`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Rectangle;

impl<T: Scalar> Domain<T> for Interval {
    type Spline<C: Coeff<T>> = Spline<T, C>;

    fn coeffs<C: Coeff<T>>(spline: &Spline<T, C>) -> &[C] {
        spline.coeffs()
    }

    fn replace_coeffs<C: Coeff<T>>(spline: &mut Spline<T, C>, new: Vec<(usize, C)>) -> Result<()> {
        spline.replace_coeffs(new)
    }

    fn map_coeffs<C: Coeff<T>, D: Coeff<T>>(
        spline: &Spline<T, C>,
        f: impl Fn(&C) -> D,
    ) -> Result<Spline<T, D>> {
        spline.map_coeffs(f)
    }

    fn product<A: Coeff<T>, B: Coeff<T>, C: Coeff<T>>(
        left: &Spline<T, A>,
        right: &Spline<T, B>,
        pair: impl Fn(&A, &B) -> C,
    ) -> Result<Spline<T, C>> {
        left.product_by(right, pair)
    }

    fn paired<A: Coeff<T>, B: Coeff<T>, C: Coeff<T>>(
        left: &Spline<T, A>,
        right: &Spline<T, B>,
        pair: impl Fn(&A, &B) -> C,
    ) -> Result<Spline<T, C>> {
        left.paired_by(right, pair)
    }

    type Parameter = T;

    fn range(lifted: &Spline<T, Weighted<T>>, accuracy: &T) -> Result<Enclosure<T>> {
        Ok(enclose(lifted.patches()?, accuracy)?.map_parameters(|[x]| x))
    }

    fn sign(spline: &Spline<T>) -> Result<Sign> {
        sign_of(spline.patches()?)
    }
}

impl<T: Scalar> Domain<T> for Rectangle {
    type Spline<C: Coeff<T>> = TensorSpline<T, C>;

    fn coeffs<C: Coeff<T>>(spline: &TensorSpline<T, C>) -> &[C] {
        spline.coeffs()
    }

    fn replace_coeffs<C: Coeff<T>>(spline: &mut TensorSpline<T, C>, new: Vec<(usize, C)>) -> Result<()> {
        spline.replace_coeffs(new)
    }

    fn map_coeffs<C: Coeff<T>, D: Coeff<T>>(
        spline: &TensorSpline<T, C>,
        f: impl Fn(&C) -> D,
    ) -> Result<TensorSpline<T, D>> {
        spline.map_coeffs(f)
    }

    fn product<A: Coeff<T>, B: Coeff<T>, C: Coeff<T>>(
        left: &TensorSpline<T, A>,
        right: &TensorSpline<T, B>,
        pair: impl Fn(&A, &B) -> C,
    ) -> Result<TensorSpline<T, C>> {
        left.product_by(right, pair)
    }

    fn paired<A: Coeff<T>, B: Coeff<T>, C: Coeff<T>>(
        left: &TensorSpline<T, A>,
        right: &TensorSpline<T, B>,
        pair: impl Fn(&A, &B) -> C,
    ) -> Result<TensorSpline<T, C>> {
        left.paired_by(right, pair)
    }

    type Parameter = (T, T);

    fn range(lifted: &TensorSpline<T, Weighted<T>>, accuracy: &T) -> Result<Enclosure<T, (T, T)>> {
        Ok(enclose(lifted.boxes()?, accuracy)?.map_parameters(|[u, v]| (u, v)))
    }

    fn sign(spline: &TensorSpline<T>) -> Result<Sign> {
        sign_of(spline.boxes()?)
    }
}
