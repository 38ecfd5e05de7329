//! Values and partial derivatives of surfaces: at a point, at many, on a grid.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::functional::weigh;
use crate::limits::{check_degree, check_dim};
use crate::row::Row;
use crate::scalar::Scalar;
use crate::tensor::spline::TensorSpline;
use crate::window::{SMALL, derivatives, small_weights};

impl<T: Scalar, C: Coeff<T>> TensorSpline<T, C> {
    /// The value at `(u, v)`: right limits, at the ends of the domain left ones.
    ///
    /// # Errors
    /// [`OutsideDomain`](crate::Error::OutsideDomain).
    ///
    /// # Examples
    /// ```
    /// use symspline::{SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let grid = TensorSpline::new(line.clone(), line, vec![0.0, 1.0, 2.0, 5.0])?;
    /// assert_eq!(grid.at(&1.0, &0.5)?, 3.5);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[inline]
    pub fn at(&self, u: &T, v: &T) -> Result<C> {
        Ok(self.on_patch((self.u().locate(u)?, self.v().locate(v)?), u, v))
    }

    /// The values at many points in any order, which shares nothing but the search for spans between neighbours.
    ///
    /// # Errors
    /// [`OutsideDomain`](crate::Error::OutsideDomain).
    ///
    /// # Examples
    /// ```
    /// use symspline::{SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let grid = TensorSpline::new(line.clone(), line, vec![0.0, 1.0, 2.0, 5.0])?;
    /// assert_eq!(grid.eval(&[(1.0, 0.5), (0.0, 0.0)])?, [3.5, 0.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn eval(&self, points: &[(T, T)]) -> Result<Vec<C>> {
        let mut values = Vec::with_capacity(points.len());
        let (mut k, mut l) = (0, 0);
        for (u, v) in points {
            (k, l) = (self.u().locate_near(u, k)?, self.v().locate_near(v, l)?);
            values.push(self.on_patch((k, l), u, v));
        }
        Ok(values)
    }

    /// The values on the grid of all pairs, row by row: `(us[i], vs[j])` at `i * vs.len() + j`.
    ///
    /// Basis functions are evaluated once for each parameter, and one direction once for each row of the grid or of the
    /// coefficients, whichever are fewer: a value costs about `p + 1` products.
    ///
    /// # Errors
    /// [`OutsideDomain`](crate::Error::OutsideDomain), [`TooLarge`](crate::Error::TooLarge).
    ///
    /// # Examples
    /// ```
    /// use symspline::{SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let grid = TensorSpline::new(line.clone(), line, vec![0.0, 1.0, 2.0, 5.0])?;
    /// assert_eq!(grid.eval_grid(&[0.0, 1.0], &[0.0, 0.5, 1.0])?, [0.0, 0.5, 1.0, 2.0, 3.5, 5.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn eval_grid(&self, us: &[T], vs: &[T]) -> Result<Vec<C>> {
        check_dim(us.len().saturating_mul(vs.len()))?;
        let (along, across) = (self.u().evaluation(us)?, self.v().evaluation(vs)?);
        let values = |row: Row<C>| across.apply(&row).map(Row);
        let mut rows = self.spline_of_rows().into_coeffs();
        let v_first = rows.len() <= us.len();
        if v_first {
            rows = rows.into_iter().map(values).collect::<Result<_>>()?;
        }
        let mut grid = Vec::with_capacity(us.len() * vs.len());
        for (first, weights) in along.rows() {
            let row = weigh(first, weights, &rows);
            grid.extend(if v_first { row.0 } else { values(row)?.0 });
        }
        Ok(grid)
    }

    /// The value at `(u, v)` of the polynomial of the spans `k` and `l`.
    #[inline]
    fn on_patch(&self, (k, l): (usize, usize), u: &T, v: &T) -> C {
        let (p, q) = (self.u().degree(), self.v().degree());
        if p < SMALL && q < SMALL {
            let left = small_weights(self.u().knots(), k, p, u);
            let right = small_weights(self.v().knots(), l, q, v);
            return self.weighed((k - p, &left[..=p]), (l - q, &right[..=q]));
        }
        let (left, right) = (self.u().basis_on(k, u), self.v().basis_on(l, v));
        self.weighed((k - p, left.weights()), (l - q, right.weights()))
    }

    /// `Σ left_i right_j c_ij` with both runs of weights at their first indices.
    #[inline]
    fn weighed(&self, left: (usize, &[T]), right: (usize, &[T])) -> C {
        let in_row = |i: usize| weigh(right.0, right.1, self.row(i));
        let mut sum = in_row(left.0);
        sum.scale(&left.1[0]);
        (left.0 + 1..).zip(&left.1[1..]).for_each(|(i, w)| sum.add_scaled(w, &in_row(i)));
        sum
    }

    /// All partial derivatives `∂^{k+l} S / ∂u^k ∂v^l` with `k, l <= order` at `(u, v)`, as `[k][l]`; right limits, beyond
    /// the degrees zero.
    ///
    /// # Errors
    /// [`OutsideDomain`](crate::Error::OutsideDomain), [`DegreeTooHigh`](crate::Error::DegreeTooHigh).
    ///
    /// # Examples
    /// ```
    /// use symspline::{SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let grid = TensorSpline::new(line.clone(), line, vec![0.0, 1.0, 2.0, 5.0])?;
    /// assert_eq!(grid.derivatives_at(&0.0, &0.5, 1)?, [[0.5, 1.0], [3.0, 2.0]]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn derivatives_at(&self, u: &T, v: &T, order: usize) -> Result<Vec<Vec<C>>> {
        check_degree(order)?;
        check_dim((order + 1) * (order + 1))?;
        let (k, l) = (self.u().locate(u)?, self.v().locate(v)?);
        let (p, q) = (self.u().degree(), self.v().degree());
        let in_row = |i: usize| {
            let window = (l - q..=l).map(|j| self.row(i)[self.v().slot(j)].clone()).collect();
            Row(derivatives(self.v().knots(), l, window, v, order))
        };
        let window: Vec<Row<C>> = (k - p..=k).map(in_row).collect();
        Ok(derivatives(self.u().knots(), k, window, u, order).into_iter().map(|row| row.0).collect())
    }

    /// The partial derivative of order `k` in `u` and `l` in `v` at a point.
    ///
    /// # Errors
    /// [`OutsideDomain`](crate::Error::OutsideDomain), [`DegreeTooHigh`](crate::Error::DegreeTooHigh).
    pub fn derivative_at(&self, u: &T, v: &T, k: usize, l: usize) -> Result<C> {
        let mut all = self.derivatives_at(u, v, k.max(l))?;
        Ok(all.swap_remove(k).swap_remove(l))
    }

    /// The value and the first derivatives along `u` and along `v` at `(u, v)`: `[S, S_u, S_v]`.
    ///
    /// Nothing is allocated for low degrees: the fast way to tangents and normals.
    ///
    /// # Errors
    /// [`OutsideDomain`](crate::Error::OutsideDomain).
    ///
    /// # Examples
    /// ```
    /// use symspline::{SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let grid = TensorSpline::new(line.clone(), line, vec![0.0, 1.0, 2.0, 5.0])?;
    /// assert_eq!(grid.tangents_at(&0.0, &0.5)?, [0.5, 3.0, 1.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn tangents_at(&self, u: &T, v: &T) -> Result<[C; 3]> {
        let (p, q) = (self.u().degree(), self.v().degree());
        if !((1..SMALL).contains(&p) && (1..SMALL).contains(&q)) {
            let mut all = self.derivatives_at(u, v, 1)?;
            let (value, along_v) = (all[0][0].clone(), all[0].swap_remove(1));
            return Ok([value, all.swap_remove(1).swap_remove(0), along_v]);
        }
        let (s, t) = (self.u().knots(), self.v().knots());
        let (k, l) = (self.u().locate(u)?, self.v().locate(v)?);
        let (wu, wv) = (small_weights(s, k, p, u), small_weights(t, l, q, v));
        let (du, dv) = (self.u().leg_weights(k, u), self.v().leg_weights(l, v));
        // Each row: its value, and its derivative from the legs of the polygon, which round less than weights of values.
        let in_row = |i: usize| {
            let row = self.row(i);
            let leg = |j: usize| row[self.v().slot(l - q + j + 1)].minus(&row[self.v().slot(l - q + j)]);
            let mut slope = leg(0).scaled(&dv[0]);
            (1..q).for_each(|j| slope.add_scaled(&dv[j], &leg(j)));
            (weigh(l - q, &wv[..=q], row), slope)
        };
        let (mut before, slope) = in_row(k - p);
        let (mut value, mut along_v) = (before.scaled(&wu[0]), slope.scaled(&wu[0]));
        let mut along_u = before.zero_like();
        for i in 1..=p {
            let (here, slope) = in_row(k - p + i);
            value.add_scaled(&wu[i], &here);
            along_v.add_scaled(&wu[i], &slope);
            along_u.add_scaled(&du[i - 1], &here.minus(&before));
            before = here;
        }
        Ok([value, along_u, along_v])
    }
}
