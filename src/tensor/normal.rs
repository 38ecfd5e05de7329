//! Normals and fundamental forms of surfaces.
//!
//! ```text
//! n = S_u × S_v      I = (S_u·S_u, S_u·S_v, S_v·S_v)      II = (S_uu·n, S_uv·n, S_vv·n) / |n|
//! ```

use crate::error::{Error, Result};
use crate::scalar::{Real, Scalar};
use crate::tensor::along::Direction::{U, V};
use crate::tensor::form::{QuadraticForm, first_form, second_form};
use crate::tensor::spline::{Surface, TensorSpline};
use crate::vector::{cross3, unit_cross};
use nalgebra::SVector;

impl<T: Scalar, const N: usize> Surface<T, N> {
    /// The first fundamental form, `S_u·S_u`, `S_u·S_v`, `S_v·S_v` as scalar surfaces.
    ///
    /// # Errors
    /// As [`derivative`](TensorSpline::derivative) and [`product_by`](TensorSpline::product_by).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{SplineSpace, Surface};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let corners = vec![vector![0.0, 0.0], vector![0.0, 2.0], vector![1.0, 0.0], vector![1.0, 2.0]];
    /// let form = Surface::new(line.clone(), line, corners)?.first_form()?;
    /// assert_eq!((form.uu.at(&0.5, &0.5)?, form.uv.at(&0.5, &0.5)?, form.vv.at(&0.5, &0.5)?), (1.0, 0.0, 4.0));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn first_form(&self) -> Result<QuadraticForm<TensorSpline<T>>> {
        let (along_u, along_v) = (self.derivative(U)?, self.derivative(V)?);
        Ok(QuadraticForm {
            uu: along_u.dot(&along_u)?,
            uv: along_u.dot(&along_v)?,
            vv: along_v.dot(&along_v)?,
        })
    }

    /// The first fundamental form at a point.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    pub fn first_form_at(&self, u: &T, v: &T) -> Result<QuadraticForm<T>> {
        let [_, along_u, along_v] = self.tangents_at(u, v)?;
        Ok(first_form(&along_u, &along_v))
    }
}

impl<T: Scalar> Surface<T, 3> {
    /// The normal `S_u × S_v` as a surface, not of unit length.
    ///
    /// # Errors
    /// As [`derivative`](TensorSpline::derivative) and [`cross`](Self::cross).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{SplineSpace, Surface};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let corners = vec![vector![0.0, 0.0, 0.0], vector![0.0, 1.0, 0.0], vector![1.0, 0.0, 0.0], vector![1.0, 1.0, 1.0]];
    /// let saddle = Surface::new(line.clone(), line, corners)?;
    /// assert_eq!(saddle.normal()?.at(&0.5, &0.25)?, vector![-0.25, -0.5, 1.0]);
    /// assert_eq!(saddle.normal_at(&0.5, &0.25)?, vector![-0.25, -0.5, 1.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn normal(&self) -> Result<Self> {
        self.derivative(U)?.cross(&self.derivative(V)?)
    }

    /// The normal `S_u × S_v` at a point, not of unit length; zero where the surface is not regular.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    #[inline]
    pub fn normal_at(&self, u: &T, v: &T) -> Result<SVector<T, 3>> {
        let [_, along_u, along_v] = self.tangents_at(u, v)?;
        Ok(cross3(&along_u, &along_v))
    }

    /// The second fundamental form times `|n|`, which is free of roots: `S_uu·n`, `S_uv·n`, `S_vv·n` with
    /// `n = S_u × S_v`.
    ///
    /// # Errors
    /// As [`partial`](TensorSpline::partial) and [`product_by`](TensorSpline::product_by).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{SplineSpace, Surface};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let corners = vec![vector![0.0, 0.0, 0.0], vector![0.0, 1.0, 0.0], vector![1.0, 0.0, 0.0], vector![1.0, 1.0, 1.0]];
    /// let saddle = Surface::new(line.clone(), line, corners)?;
    /// assert_eq!(saddle.scaled_second_form()?.uv.at(&0.5, &0.25)?, 1.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn scaled_second_form(&self) -> Result<QuadraticForm<TensorSpline<T>>> {
        let normal = self.normal()?;
        let entry = |k: usize, l: usize| self.partial(k, l)?.dot(&normal);
        Ok(QuadraticForm { uu: entry(2, 0)?, uv: entry(1, 1)?, vv: entry(0, 2)? })
    }
}

impl<T: Real> Surface<T, 3> {
    /// The unit normal at a point.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::NoNormal`] where `S_u × S_v` vanishes.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Error, SplineSpace, Surface};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let corners = vec![vector![0.0, 0.0, 0.0], vector![0.0, 3.0, 0.0], vector![1.0, 0.0, 0.0], vector![1.0, 0.0, 0.0]];
    /// let triangle = Surface::new(line.clone(), line, corners)?;
    /// assert_eq!(triangle.unit_normal_at(&0.5, &0.5)?, vector![0.0, 0.0, 1.0]);
    /// assert!(matches!(triangle.unit_normal_at(&1.0, &0.5), Err(Error::NoNormal { .. })));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn unit_normal_at(&self, u: &T, v: &T) -> Result<SVector<T, 3>> {
        let [_, along_u, along_v] = self.tangents_at(u, v)?;
        unit_cross(&along_u, &along_v).ok_or_else(|| Error::no_normal(u, v))
    }

    /// The second fundamental form at a point.
    ///
    /// # Errors
    /// As [`unit_normal_at`](Self::unit_normal_at).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{SplineSpace, Surface};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let corners = vec![vector![0.0, 0.0, 0.0], vector![0.0, 1.0, 0.0], vector![1.0, 0.0, 0.0], vector![1.0, 1.0, 1.0]];
    /// let form = Surface::new(line.clone(), line, corners)?.second_form_at(&0.0, &0.0)?;
    /// assert_eq!((form.uu, form.uv, form.vv), (0.0, 1.0, 0.0));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn second_form_at(&self, u: &T, v: &T) -> Result<QuadraticForm<T>> {
        second_form(&self.derivatives_at(u, v, 2)?).ok_or_else(|| Error::no_normal(u, v))
    }
}
