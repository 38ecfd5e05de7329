//! What splines of one and of two parameters have in common, so that rational ones of both are one text.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::ops::enclose::{Enclosure, enclose};
use crate::ops::fraction::{FractionBound, fraction_bound};
use crate::ops::sign::{Sign, sign_of};
use crate::row::Row;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;
use crate::tensor::along::Direction;
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

    /// The derivative along the first direction, or the second.
    ///
    /// # Errors
    /// As [`Spline::derivative`].
    fn derivative<C: Coeff<T>>(spline: &Self::Spline<C>, direction: usize) -> Result<Self::Spline<C>>;

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

    /// The space of each direction.
    fn spaces<C: Coeff<T>>(spline: &Self::Spline<C>) -> Vec<SplineSpace<T>>;

    /// The same spline in larger spaces, one for each direction.
    ///
    /// # Errors
    /// As [`Spline::embedded`].
    fn embedded<C: Coeff<T>>(spline: &Self::Spline<C>, spaces: &[SplineSpace<T>]) -> Result<Self::Spline<C>>;

    /// The values at the places where a [quasi-interpolant](SplineSpace::quasi_interpolant) in `spaces` takes samples, and at the
    /// ends of clamped spaces.
    ///
    /// # Errors
    /// [`TooLarge`](crate::Error::TooLarge).
    fn samples<C: Coeff<T>>(spline: &Self::Spline<C>, spaces: &[SplineSpace<T>]) -> Result<Vec<C>>;

    /// The spline over `spaces` whose coefficients `operator` makes of `samples` inside, along one direction after the other, and
    /// that has the samples at the ends.
    ///
    /// # Errors
    /// Those of `operator`; [`NotFinite`](crate::Error::NotFinite).
    fn from_samples<C: Coeff<T>>(
        spaces: &[SplineSpace<T>],
        samples: Vec<C>,
        operator: impl Fn(&SplineSpace<T>, &[Row<C>]) -> Result<Vec<Row<C>>>,
    ) -> Result<Self::Spline<C>>;

    /// How large a quotient is on each patch; `noise` says what its coefficients may be off by, and a bound of `enough` need
    /// not be sharpened. The patches of the last direction stand next to each other.
    ///
    /// # Errors
    /// [`TooLarge`](crate::Error::TooLarge).
    fn fraction_bounds<C: Coeff<T>>(
        lifted: &Self::Spline<Weighted<T, C>>,
        noise: Option<&Self::Spline<Weighted<T>>>,
        enough: &T,
    ) -> Result<Vec<FractionBound<T>>>;
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

    fn derivative<C: Coeff<T>>(spline: &Spline<T, C>, _: usize) -> Result<Spline<T, C>> {
        spline.derivative()
    }

    type Parameter = T;

    fn range(lifted: &Spline<T, Weighted<T>>, accuracy: &T) -> Result<Enclosure<T>> {
        Ok(enclose(lifted.patches()?, accuracy)?.map_parameters(|[x]| x))
    }

    fn sign(spline: &Spline<T>) -> Result<Sign> {
        sign_of(spline.patches()?)
    }

    fn spaces<C: Coeff<T>>(spline: &Spline<T, C>) -> Vec<SplineSpace<T>> {
        vec![spline.space().clone()]
    }

    fn embedded<C: Coeff<T>>(spline: &Spline<T, C>, spaces: &[SplineSpace<T>]) -> Result<Spline<T, C>> {
        spline.embedded(&spaces[0])
    }

    fn samples<C: Coeff<T>>(spline: &Spline<T, C>, spaces: &[SplineSpace<T>]) -> Result<Vec<C>> {
        spline.eval(&spaces[0].places_with_ends())
    }

    fn from_samples<C: Coeff<T>>(
        spaces: &[SplineSpace<T>],
        samples: Vec<C>,
        operator: impl Fn(&SplineSpace<T>, &[Row<C>]) -> Result<Vec<Row<C>>>,
    ) -> Result<Spline<T, C>> {
        let samples: Vec<Row<C>> = samples.into_iter().map(|c| Row(vec![c])).collect();
        let coeffs = spaces[0].with_ends(&samples, |inside| operator(&spaces[0], inside))?;
        Spline::new(spaces[0].clone(), coeffs.into_iter().flat_map(|row| row.0).collect())
    }

    fn fraction_bounds<C: Coeff<T>>(
        lifted: &Spline<T, Weighted<T, C>>,
        noise: Option<&Spline<T, Weighted<T>>>,
        enough: &T,
    ) -> Result<Vec<FractionBound<T>>> {
        let noises = noise.map(Spline::patches).transpose()?;
        let noise = |i: usize| noises.as_ref().map(|noises| &noises[i]);
        let patches = lifted.patches()?.into_iter().enumerate();
        Ok(patches.map(|(i, patch)| fraction_bound(patch, noise(i), enough)).collect())
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

    fn derivative<C: Coeff<T>>(spline: &TensorSpline<T, C>, direction: usize) -> Result<TensorSpline<T, C>> {
        spline.derivative(if direction == 0 { Direction::U } else { Direction::V })
    }

    type Parameter = (T, T);

    fn range(lifted: &TensorSpline<T, Weighted<T>>, accuracy: &T) -> Result<Enclosure<T, (T, T)>> {
        Ok(enclose(lifted.boxes()?, accuracy)?.map_parameters(|[u, v]| (u, v)))
    }

    fn sign(spline: &TensorSpline<T>) -> Result<Sign> {
        sign_of(spline.boxes()?)
    }

    fn spaces<C: Coeff<T>>(spline: &TensorSpline<T, C>) -> Vec<SplineSpace<T>> {
        vec![spline.u().clone(), spline.v().clone()]
    }

    fn embedded<C: Coeff<T>>(
        spline: &TensorSpline<T, C>,
        spaces: &[SplineSpace<T>],
    ) -> Result<TensorSpline<T, C>> {
        spline.embedded(&spaces[0], &spaces[1])
    }

    fn samples<C: Coeff<T>>(spline: &TensorSpline<T, C>, spaces: &[SplineSpace<T>]) -> Result<Vec<C>> {
        spline.eval_grid(&spaces[0].places_with_ends(), &spaces[1].places_with_ends())
    }

    fn from_samples<C: Coeff<T>>(
        spaces: &[SplineSpace<T>],
        samples: Vec<C>,
        operator: impl Fn(&SplineSpace<T>, &[Row<C>]) -> Result<Vec<Row<C>>>,
    ) -> Result<TensorSpline<T, C>> {
        let [u, v] = [&spaces[0], &spaces[1]];
        let width = samples.len() / u.places_with_ends().len();
        let rows: Vec<Row<C>> = samples.chunks(width).map(|row| Row(row.to_vec())).collect();
        let rows = u.with_ends(&rows, |inside| operator(u, inside))?;
        let column = |j: usize| Row(rows.iter().map(|row| row[j].clone()).collect());
        let columns: Vec<Row<C>> = (0..width).map(column).collect();
        let columns = v.with_ends(&columns, |inside| operator(v, inside))?;
        let columns = Spline::new(v.clone(), columns)?;
        Ok(TensorSpline::from_spline_of_rows(columns, u.clone())?.transposed())
    }

    fn fraction_bounds<C: Coeff<T>>(
        lifted: &TensorSpline<T, Weighted<T, C>>,
        noise: Option<&TensorSpline<T, Weighted<T>>>,
        enough: &T,
    ) -> Result<Vec<FractionBound<T>>> {
        let noises = noise.map(TensorSpline::boxes).transpose()?;
        let noise = |i: usize| noises.as_ref().map(|noises| &noises[i]);
        let patches = lifted.boxes()?.into_iter().enumerate();
        Ok(patches.map(|(i, patch)| fraction_bound(patch, noise(i), enough)).collect())
    }
}
