//! Composition: a spline of a spline, again a spline.
//!
//! Between the cuts (`cuts.rs`) the outer spline `f` is one polynomial and the inner function `g` another. With `w` how far
//! `g` is through the span of `f`, the outer Bernstein polynomials of `g` follow by the recurrence
//!
//! ```text
//! B_i^0 = 1 if i = 0,  B_i^k(w) = (1 - w) B_i^(k-1)(w) + w B_(i-1)^(k-1)(w)
//! ```
//!
//! that is the algorithm of de Casteljau with polynomials for numbers: all in Bernstein form, all convex combinations. They are
//! weights for the coefficients of `f`, so composition with a fixed `g` is a linear map. Along several axes the weights multiply.
//! From the pieces the [recomposition](SplineSpace::recomposition) makes the coefficients.

use crate::bernstein::Shares;
use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::map::LinearMap;
use crate::ops::cuts::{Axis, Cuts, Piece, cuts};
use crate::roots::{Polynomial, Solvable};
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::{Function, Spline};

/// The tables that polynomials are put in for the arguments of Bernstein polynomials with, along `K` axes.
struct Substitution<T, const K: usize> {
    /// Along each axis the products of one step more with the argument.
    steps: [Vec<Shares<T>>; K],
    /// The products of what an axis gives with what those after it give.
    joints: [Shares<T>; K],
}

impl<T: Scalar, const K: usize> Substitution<T, K> {
    /// For splines of `degrees` along the axes and coordinates of degree `r`.
    fn new(degrees: [usize; K], r: usize) -> Self {
        let after = |d: usize| degrees[d + 1..].iter().sum::<usize>();
        Self {
            steps: degrees.map(|p| (0..p).map(|k| Shares::new(k * r, r)).collect()),
            joints: std::array::from_fn(|d| Shares::new(degrees[d] * r, after(d) * r)),
        }
    }

    /// Along each axis the Bernstein polynomials of the coordinate on a piece, in Bernstein form on that piece.
    fn weights(&self, piece: &Piece<T, K>) -> [Vec<Vec<T>>; K] {
        std::array::from_fn(|d| {
            let [through, left] = &piece.shares[d];
            let first = vec![vec![T::one()]];
            self.steps[d].iter().fold(first, |lower, step| {
                let times = |b: &Vec<T>, w: &[T]| step.multiply(b, w, &|x: &T, y: &T| x.clone() * y);
                let mut raised: Vec<Vec<T>> = lower.iter().map(|b| times(b, left)).collect();
                raised.push(vec![T::zero(); raised[0].len()]);
                for (sum, b) in raised[1..].iter_mut().zip(&lower) {
                    sum.iter_mut().zip(times(b, through)).for_each(|(x, y)| *x += y);
                }
                raised
            })
        })
    }

    /// The Bernstein coefficients on a piece of the composition with the patch of Bernstein coefficients `c`, those along the
    /// last axis next to each other.
    fn apply<C: Coeff<T>>(&self, weights: &[Vec<Vec<T>>; K], c: &[C]) -> Vec<C> {
        along(&self.joints, weights, c)
    }
}

/// The sums `Σ_i weights[0][i] along(..., c_i)` of polynomial products, in Bernstein form.
fn along<T: Scalar, C: Coeff<T>>(joints: &[Shares<T>], weights: &[Vec<Vec<T>>], c: &[C]) -> Vec<C> {
    let (Some((joint, joints)), Some((axis, weights))) = (joints.split_first(), weights.split_first()) else {
        return c.to_vec();
    };
    let rows: Vec<Vec<C>> = c.chunks(c.len() / axis.len()).map(|c| along(joints, weights, c)).collect();
    let coefficient = |k: usize| {
        let (mut factors, mut terms) = (Vec::new(), Vec::new());
        for (b, row) in axis.iter().zip(&rows) {
            for (i, j, share) in joint.meeting(k) {
                factors.push(share.clone() * &b[i]);
                terms.push(&row[j]);
            }
        }
        C::combine(factors.iter().zip(terms)).expect("some pair meets in every coefficient")
    };
    (0..axis[0].len() + rows[0].len() - 1).map(coefficient).collect()
}

/// The composition of what has the Bernstein coefficients `patch(spans)`, as [`Substitution::apply`] takes them, with the
/// curve of these axes.
pub(crate) fn composition<T: Solvable, C: Coeff<T>, const K: usize>(
    axes: [Axis<'_, T>; K],
    patch: impl Fn([usize; K]) -> Vec<C>,
) -> Result<Spline<T, C>> {
    let Cuts { space, pieces } = cuts(axes)?;
    let table = Substitution::new(axes.map(|(space, _)| space.degree()), axes[0].1.degree());
    let on = |piece: &Piece<T, K>| table.apply(&table.weights(piece), &patch(piece.spans));
    let bernstein: Vec<C> = pieces.iter().flat_map(on).collect();
    let coeffs = space.recomposed(&space.ends(), &bernstein, &[]);
    Spline::new(space, coeffs)
}

impl<T: Solvable> SplineSpace<T> {
    /// The composition `f -> f ∘ inner` with a fixed inner function as a map, and its target space.
    ///
    /// The target has degree `p q`, on the domain of `inner`, and is periodic if `inner` is. Its knots are those of `inner`, with
    /// `p q - (q - m)` copies for `m`, and the parameters where `inner` crosses a knot of this space, with
    /// `p q - (p - m)` copies for `m`; where both meet, the greater number.
    ///
    /// # Errors
    /// As [`Spline::composed`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// let lines = SplineSpace::clamped(1, [0.0, 0.25, 1.0])?;
    /// let (space, map) = lines.composition(&Function::monomial(2, 0.0, 1.0)?)?;
    /// assert_eq!(space, SplineSpace::clamped(2, [0.0, 0.5, 0.5, 1.0])?);
    /// assert_eq!(map.apply(&[0.0, 1.0, 4.0])?, [0.0, 0.0, 1.0, 2.0, 4.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn composition(&self, inner: &Function<T>) -> Result<(Self, LinearMap<T>)> {
        let (p, axes) = (self.degree(), [(self, inner)]);
        let Cuts { space, pieces } = cuts(axes)?;
        let (outer, table) = (self.pieces(p)?, Substitution::new([p], inner.degree()));
        let mut substitution = LinearMap::empty(outer.dim(), pieces.len() * (space.degree() + 1));
        for piece in &pieces {
            let [weights] = table.weights(piece);
            for k in 0..=space.degree() {
                let row = weights.iter().map(|b| b[k].clone());
                substitution.push(piece.spans[0] * (p + 1), |weights| weights.extend(row));
            }
        }
        let map = space.recomposition()?.after(&substitution)?.after(&self.embedding(&outer)?)?;
        Ok((space, map))
    }
}

impl<T: Solvable, C: Coeff<T>> Spline<T, C> {
    /// The composition `x -> self(inner(x))`, a spline of degree `p q` on the domain of `inner`; see
    /// [`SplineSpace::composition`] for its knots.
    ///
    /// It is periodic if `inner` is. A periodic outer spline is taken on its domain alone: `inner` has to stay there. Touching
    /// the ends of the domain is allowed. Where this spline jumps at a knot that `inner` crosses, the composition has the limit from the
    /// side that `inner` is on; where `inner` is constant at the knot, the right limit, as always.
    ///
    /// In `f64` cuts are the floats nearest to where the polynomials that `inner` is made of cross the knots. If a knot of `inner`
    /// is meant to be such a place, but rounding puts it next to it, there is a span as short as that.
    ///
    /// # Errors
    /// [`Error::LeavesDomain`]; [`Error::IrrationalPreimage`] if a knot is crossed where the field has no number for it;
    /// [`Error::DegreeTooHigh`], [`Error::TooLarge`]; in `f64` [`Error::SpanOutOfRange`] if a span of the result is too short,
    /// [`Error::NotFinite`] on overflow.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, Function, Q, Scalar, SplineSpace};
    /// let hat = Function::new(SplineSpace::clamped(1, [0, 1, 2].map(Q::int))?, [0, 1, 0].map(Q::int).to_vec())?;
    /// let square = |end| Function::monomial(2, Q::int(0), end);
    /// let irrational = Function::new(SplineSpace::bezier(2, Q::int(0), Q::int(1))?, [0, 0, 2].map(Q::int).to_vec())?;
    /// let f = hat.composed(&square(Q::frac(5, 4))?)?;
    /// assert_eq!(f.space(), &SplineSpace::clamped(2, [Q::int(0), Q::int(1), Q::int(1), Q::frac(5, 4)])?);
    /// assert_eq!(f.at(&Q::frac(1, 2))?, Q::frac(1, 4));
    /// assert!(matches!(hat.composed(&square(Q::int(2))?), Err(Error::LeavesDomain { .. })));
    /// assert!(matches!(hat.composed(&irrational), Err(Error::IrrationalPreimage { .. })));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn composed(&self, inner: &Function<T>) -> Result<Self> {
        let p = self.degree();
        let bernstein = self.bernstein(&self.space().ends())?;
        composition([(self.space(), inner)], |[i]| bernstein[i * (p + 1)..(i + 1) * (p + 1)].to_vec())
    }

    /// The same spline over another parameter: the [composition](Self::composed) with an increasing function onto its domain.
    ///
    /// The result is open, unless the change is periodic with a jump at the seam.
    ///
    /// # Errors
    /// [`Error::Discontinuous`] if the change may jump, [`Error::NotIncreasing`], [`Error::DomainMismatch`] unless it maps ends to
    /// ends, and those of [`composed`](Self::composed).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, Function};
    /// let line = Function::monomial(1, 0.0, 1.0)?;
    /// assert_eq!(line.reparametrised_by(&Function::monomial(3, 0.0, 1.0)?)?.at(&0.5)?, 0.125);
    /// let back = line.reparametrised_by(&line.reversed()?);
    /// assert_eq!(back.unwrap_err(), Error::NotIncreasing { parameter: "0".into() });
    /// # Ok::<(), Error>(())
    /// ```
    pub fn reparametrised_by(&self, change: &Function<T>) -> Result<Self> {
        check_increasing(change)?;
        let (a, b) = change.domain();
        let (start, end) = (change.at(a)?, change.at(b)?);
        if (&start, &end) != self.domain() {
            let text = |(a, b): (&T, &T)| format!("[{a}, {b}]");
            return Err(Error::DomainMismatch { left: text((&start, &end)), right: text(self.domain()) });
        }
        self.composed(change)
    }
}

/// Checks that a function increases strictly: its slope is nowhere negative, and nowhere zero over a whole span.
fn check_increasing<T: Solvable>(change: &Function<T>) -> Result<()> {
    let (q, breaks) = (change.degree(), change.space().breaks());
    if let Some((knot, _)) = breaks[1..breaks.len() - 1].iter().find(|(_, m)| *m > q) {
        return Err(Error::Discontinuous { knot: knot.to_string() });
    }
    let bernstein = change.bernstein(&change.space().ends())?;
    for (ends, c) in breaks.windows(2).zip(bernstein.chunks(q + 1)) {
        let (a, b) = (&ends[0].0, &ends[1].0);
        let flat = c.windows(2).all(|pair| pair[0] == pair[1]);
        let rises = || c.windows(2).map(|pair| pair[1].clone() - &pair[0]).collect();
        let falling = match flat {
            true => Some(a.clone()),
            false => Polynomial::new(a.clone(), b.clone(), rises())?.negative_at(),
        };
        if let Some(parameter) = falling {
            return Err(Error::NotIncreasing { parameter: parameter.to_string() });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Q;
    use crate::limits::MAX_DEGREE;

    fn q(numbers: &[i64]) -> Vec<Q> {
        numbers.iter().copied().map(Q::int).collect()
    }

    fn clamped(degree: usize, breaks: &[i64], coeffs: &[i64]) -> Function<Q> {
        Function::new(SplineSpace::clamped(degree, q(breaks)).unwrap(), q(coeffs)).unwrap()
    }

    #[test]
    fn touching_a_knot_or_an_end_needs_no_cut() {
        // 4 x (1 - x) touches 1 from below, its control value 2 is above.
        let arch = clamped(2, &[0, 1], &[0, 2, 0]);
        let hat = clamped(1, &[0, 1, 2], &[0, 1, 0]);
        assert_eq!(hat.composed(&arch).unwrap(), arch);
        assert_eq!(clamped(1, &[0, 1], &[0, 1]).composed(&arch).unwrap(), arch);
    }

    #[test]
    fn a_knot_crossed_with_a_multiple_root_is_a_cut() {
        let cube = clamped(3, &[-1, 1], &[-1, 1, -1, 1]);
        let step = clamped(0, &[-1, 0, 1], &[5, 7]);
        assert_eq!(step.composed(&cube).unwrap(), step);
        let ramp = clamped(1, &[-1, 0, 1], &[0, 0, 1]).composed(&cube).unwrap();
        assert_eq!(ramp.space().breaks()[1], (Q::int(0), 3));
    }

    #[test]
    fn jumps_are_taken_from_the_side_of_the_inner_function() {
        let step = clamped(0, &[0, 1, 2], &[5, 7]);
        // Falling through the knot 1, along it, and back up.
        let valley = clamped(1, &[0, 1, 2, 3], &[2, 1, 1, 2]);
        assert_eq!(step.composed(&valley).unwrap(), clamped(0, &[0, 3], &[7]));
        let ridge = clamped(1, &[0, 1, 2, 3], &[0, 1, 1, 0]);
        assert_eq!(step.composed(&ridge).unwrap(), clamped(0, &[0, 1, 2, 3], &[5, 7, 5]));
        let falling = step.composed(&clamped(1, &[0, 2], &[2, 0])).unwrap();
        assert_eq!(falling, clamped(0, &[0, 1, 2], &[7, 5]));
    }

    #[test]
    fn a_jump_of_the_inner_function_stays_one() {
        let jump = clamped(1, &[0, 1, 1, 2], &[0, 1, 2, 3]);
        let composed = clamped(2, &[0, 3], &[0, 0, 9]).composed(&jump).unwrap();
        assert_eq!(composed.space().breaks()[1], (Q::int(1), 3));
        assert_eq!((composed.at_left(&Q::int(1)), composed.at(&Q::int(1))), (Ok(Q::int(1)), Ok(Q::int(4))));
    }

    #[test]
    fn where_knots_meet_the_lower_continuity_counts() {
        // The knot 1 of the inner function goes to a knot of the outer one.
        let outer = |m: usize| {
            let breaks = [vec![0], vec![1; m], vec![2]].concat();
            clamped(2, &breaks, &[0, 1, 0, 1, 0][..m + 3])
        };
        let inner = clamped(2, &[0, 1, 2], &[0, 1, 1, 2]);
        let copies = |m| outer(m).composed(&inner).unwrap().space().breaks()[1].1;
        assert_eq!([1, 2].map(copies), [3, 4]);
    }

    #[test]
    fn rings_go_round_within_the_domain() {
        let ring = Function::new(SplineSpace::periodic(1, q(&[0, 1, 2]), Q::int(3)).unwrap(), q(&[2, 0, 1]));
        let hat = clamped(1, &[0, 1, 2], &[0, 1, 0]);
        let composed = hat.composed(&ring.unwrap()).unwrap();
        assert!(composed.space().is_periodic());
        let values = [0, 1, 2, 3].map(|x| composed.at(&Q::int(x)).unwrap());
        assert_eq!(values.to_vec(), q(&[0, 0, 1, 0]));
        assert_eq!(composed.space().breaks()[1], (Q::frac(1, 2), 1));
        let constant = Function::new(SplineSpace::periodic(0, q(&[0]), Q::int(1)).unwrap(), q(&[1])).unwrap();
        assert_eq!(hat.composed(&constant).unwrap().coeffs(), q(&[1]));
    }

    #[test]
    fn high_degrees_are_refused() {
        let f = |degree| Function::monomial(degree, 0.0, 1.0).unwrap();
        let refused = Error::DegreeTooHigh { degree: 30 * 20, limit: MAX_DEGREE };
        assert_eq!(f(30).composed(&f(20)), Err(refused));
    }

    #[test]
    fn a_patch_is_composed_along_a_curve() {
        // u² v on spans [0, 1] x [0, 2], along u = x², v = 2 - x.
        let (u, v) =
            (SplineSpace::bezier(2, Q::int(0), Q::int(1)), SplineSpace::bezier(1, Q::int(0), Q::int(2)));
        let (u, v) = (u.unwrap(), v.unwrap());
        let patch = q(&[0, 0, 0, 0, 0, 2]);
        let (x, y) = (
            clamped(2, &[0, 1], &[0, 0, 1]),
            clamped(2, &[0, 1], &[4, 3, 2]).scaled(&Q::frac(1, 2)).unwrap(),
        );
        let composed = composition([(&u, &x), (&v, &y)], |_| patch.clone()).unwrap();
        assert_eq!(composed.degree(), 6);
        for k in 0..=6 {
            let x = Q::frac(k, 6);
            let expected = &x * &x * &x * &x * (Q::int(2) - &x);
            assert_eq!(composed.at(&x).unwrap(), expected);
        }
    }

    #[test]
    fn both_axes_cut_the_curve() {
        let step = SplineSpace::clamped(0, q(&[0, 1, 2])).unwrap();
        let half = |c: &[i64]| clamped(1, &[0, 1, 4], c).scaled(&Q::frac(1, 2)).unwrap();
        let (x, y) = (half(&[0, 1, 4]), half(&[4, 1, 0]));
        let composed =
            composition([(&step, &x), (&step, &y)], |[i, j]| q(&[10 * i as i64 + j as i64])).unwrap();
        // y falls below 1 at 2/3, x passes 1 at 2.
        let expected = SplineSpace::clamped(0, [Q::int(0), Q::frac(2, 3), Q::int(2), Q::int(4)]).unwrap();
        assert_eq!(composed, Function::new(expected, q(&[1, 0, 10])).unwrap());
    }

    #[test]
    fn weights_along_one_axis_sum_to_one() {
        let inner = clamped(3, &[0, 1, 2], &[0, 2, 1, 1, 2]);
        let (_, map) = SplineSpace::clamped(2, q(&[0, 2])).unwrap().composition(&inner).unwrap();
        assert!(
            map.rows()
                .all(|(_, weights)| weights.iter().cloned().fold(Q::int(0), |sum, w| sum + w) == Q::int(1))
        );
    }
}
