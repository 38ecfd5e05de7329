//! A curve in the domain of some splines, cut where it passes from span to span.
//!
//! Along each axis there is a space, and a coordinate function that runs through its domain. The curve is cut at its own
//! knots and where a coordinate crosses a knot of its space: between two cuts, every axis has one span and every
//! coordinate is one polynomial. A piece that runs along a knot, or only touches one, belongs to the span on its
//! own side; one that is constant at a knot to the span right of it.

use crate::error::{Error, Result};
use crate::limits::{check_degree, check_dim};
use crate::parts::Parts;
use crate::roots::{Polynomial, RootValue, Roots, Solvable};
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Function;

/// A space and the coordinate function that runs through its domain.
pub(crate) type Axis<'a, T> = (&'a SplineSpace<T>, &'a Function<T>);

/// The cut curve, its coordinates along `K` axes.
pub(crate) struct Cuts<T, const K: usize> {
    /// The space of the compositions of splines along the axes with the curve.
    pub space: SplineSpace<T>,
    /// The pieces of the curve, one a span of that space.
    pub pieces: Vec<Piece<T, K>>,
}

/// A piece of the curve.
pub(crate) struct Piece<T, const K: usize> {
    /// Along each axis the place of the span among the non-empty ones.
    pub spans: [usize; K],
    /// Each coordinate in local Bernstein form: how far it is through its span, and how far from its end.
    pub shares: [[Vec<T>; 2]; K],
    start: T,
    /// How many copies the knot of the curve at the start has; none at a cut inside a span of the curve.
    copies: usize,
}

/// The distinct knots of the domain of a space with their multiplicities.
struct Ruler<T>(Vec<(T, usize)>);

impl<T: Scalar> Ruler<T> {
    /// The place of the span that holds what is right of `x`.
    fn span(&self, x: &T) -> usize {
        self.0[1..self.0.len() - 1].partition_point(|(t, _)| t <= x)
    }

    /// The knots strictly inside the domain and in `[low, high]`.
    fn between(&self, low: &T, high: &T) -> &[(T, usize)] {
        let inside = &self.0[1..self.0.len() - 1];
        let first = inside.partition_point(|(t, _)| t < low);
        &inside[first..inside.partition_point(|(t, _)| t <= high).max(first)]
    }

    /// The most copies of a knot between two spans, none if they are the same.
    fn most_copies(&self, i: usize, j: usize) -> usize {
        self.0[i.min(j) + 1..=i.max(j)].iter().map(|(_, copies)| *copies).max().unwrap_or(0)
    }

    /// How far the values of a polynomial are through span `i`, and how far from its end.
    fn shares(&self, i: usize, values: &[T]) -> [Vec<T>; 2] {
        let (a, b) = (&self.0[i].0, &self.0[i + 1].0);
        let width = b.clone() - a;
        let through = values.iter().map(|x| (x.clone() - a) / &width).collect();
        [through, values.iter().map(|x| (b.clone() - x) / &width).collect()]
    }
}

/// Cuts the curve with these coordinates, which are splines of one space.
///
/// Linear in the number of pieces, but for the search for the knots of the spaces in reach of each span of the curve.
///
/// # Errors
/// [`Error::DegreeTooHigh`], [`Error::TooLarge`], [`Error::LeavesDomain`], [`Error::IrrationalPreimage`].
pub(crate) fn cuts<T: Solvable, const K: usize>(axes: [Axis<'_, T>; K]) -> Result<Cuts<T, K>> {
    let curve = axes[0].1.space();
    let r = curve.degree();
    let degree = axes.iter().map(|(space, _)| space.degree()).sum::<usize>().saturating_mul(r);
    check_degree(degree)?;
    let rulers = axes.map(|(space, _)| Ruler(space.breaks()));
    let breaks = curve.breaks();
    let bernstein = curve.embedding(&curve.pieces(r)?)?;
    let mut coordinates = Vec::with_capacity(K);
    for (_, coordinate) in &axes {
        coordinates.push(bernstein.apply(coordinate.coeffs())?);
    }
    let mut pieces: Vec<Piece<T, K>> = Vec::with_capacity(breaks.len());
    for (i, ends) in breaks.windows(2).enumerate() {
        let on_span = |c: &Vec<T>| {
            let c = c[i * (r + 1)..(i + 1) * (r + 1)].to_vec();
            Polynomial::new(ends[0].0.clone(), ends[1].0.clone(), c)
        };
        let coordinates = coordinates.iter().map(on_span).collect::<Result<Vec<_>>>()?;
        let mut inside = cut_span(&rulers, &coordinates)?;
        inside[0].copies = ends[0].1;
        pieces.extend(inside);
        check_dim(pieces.len().saturating_mul(degree + 1))?;
    }
    let degrees = axes.map(|(space, _)| space.degree());
    // A knot of multiplicity m lets a spline of degree n have degree - (n - m) copies in a composition.
    let copies = |degree_there: usize, m: usize| (degree + m).saturating_sub(degree_there);
    let needed = |before: &Piece<T, K>, after: &Piece<T, K>| {
        if after.copies > r {
            // A jump, over any number of knots.
            return degree + 1;
        }
        let across = |d: usize| match rulers[d].most_copies(before.spans[d], after.spans[d]) {
            0 => 0,
            m => copies(degrees[d], m),
        };
        let own = if after.copies > 0 { copies(r, after.copies) } else { 0 };
        (0..K).map(across).fold(own, usize::max)
    };
    let seam = needed(&pieces[pieces.len() - 1], &pieces[0]);
    let inner: Vec<usize> = pieces.windows(2).map(|pair| needed(&pair[0], &pair[1])).collect();
    // Of degree 0 the pieces on both sides of a cut may be the same constant.
    let mut counts = [usize::MAX].iter().chain(&inner);
    pieces.retain(|_| counts.next() != Some(&0));
    let starts = pieces[1..].iter().map(|piece| piece.start.clone());
    let inner: Vec<(T, usize)> = starts.zip(inner.into_iter().filter(|count| *count > 0)).collect();
    let space = over(curve, degree, seam, inner)?;
    Ok(Cuts { space, pieces })
}

/// The space of `degree` on the domain of `curve`, clamped or periodic as it is, with these knots inside.
fn over<T: Scalar>(
    curve: &SplineSpace<T>,
    degree: usize,
    seam: usize,
    inner: Vec<(T, usize)>,
) -> Result<SplineSpace<T>> {
    let (a, b) = curve.domain();
    if curve.is_periodic() {
        let round: Vec<(T, usize)> = [(a.clone(), seam.max(1))].into_iter().chain(inner).collect();
        return SplineSpace::from_round(degree, &round, b);
    }
    let end = |t: &T| vec![t.clone(); degree + 1];
    SplineSpace::from_parts(degree, Parts { left: end(a), inner, right: end(b) })
}

/// The pieces on one span of the curve; the first one is not told its copies.
fn cut_span<T: Solvable, const K: usize>(
    rulers: &[Ruler<T>; K],
    coordinates: &[Polynomial<T>],
) -> Result<Vec<Piece<T, K>>> {
    let (a, b) = coordinates[0].domain();
    let mut points = vec![a.clone()];
    for (ruler, coordinate) in rulers.iter().zip(coordinates) {
        ruler.check_inside(coordinate)?;
        ruler.crossings(coordinate, &mut points)?;
    }
    points.push(b.clone());
    points.sort_by(|x, y| x.partial_cmp(y).expect("finite parameters are ordered"));
    points.dedup();
    let place = |d: usize, start: &T, end: &T| {
        // The mean of the coefficients is that of the values: inside the span, whatever the ends touch.
        let c = coordinates[d].restricted(start, end).into_coeffs();
        let sum = c.iter().fold(T::zero(), |sum, x| sum + x);
        rulers[d].span(&(sum / T::int(c.len() as i64)))
    };
    let mut runs: Vec<(T, T, [usize; K])> = Vec::with_capacity(points.len() - 1);
    for ends in points.windows(2) {
        let spans = std::array::from_fn(|d| place(d, &ends[0], &ends[1]));
        match runs.last_mut() {
            // Rounding may show a crossing where there is none.
            Some((_, end, same)) if *same == spans => *end = ends[1].clone(),
            _ => runs.push((ends[0].clone(), ends[1].clone(), spans)),
        }
    }
    let piece = |(start, end, spans): (T, T, [usize; K])| {
        let shares = |d: usize| rulers[d].shares(spans[d], coordinates[d].restricted(&start, &end).coeffs());
        Piece { spans, shares: std::array::from_fn(shares), start, copies: 0 }
    };
    Ok(runs.into_iter().map(piece).collect())
}

impl<T: Solvable> Ruler<T> {
    /// Checks that all values of a polynomial are in the domain.
    fn check_inside(&self, polynomial: &Polynomial<T>) -> Result<()> {
        let (a, b) = (&self.0[0].0, &self.0[self.0.len() - 1].0);
        let above = polynomial.try_map(|c| c.clone() - a)?;
        let below = polynomial.try_map(|c| b.clone() - c)?;
        let Some(x) = above.negative_at().or_else(|| below.negative_at()) else { return Ok(()) };
        Err(Error::LeavesDomain {
            value: polynomial.at(&x).to_string(),
            parameter: x.to_string(),
            start: a.to_string(),
            end: b.to_string(),
        })
    }

    /// Adds the parameters strictly inside where a polynomial crosses a knot.
    fn crossings(&self, polynomial: &Polynomial<T>, points: &mut Vec<T>) -> Result<()> {
        let ((a, b), c) = (polynomial.domain(), polynomial.coeffs());
        let low = c.iter().fold(&c[0], |low, x| if x < low { x } else { low });
        let high = c.iter().fold(&c[0], |high, x| if x > high { x } else { high });
        for (t, _) in self.between(low, high) {
            let level = polynomial.try_map(|c| c.clone() - t)?;
            let Roots::At(roots) = level.roots() else { continue };
            for root in roots.into_iter().filter(|root| root.multiplicity % 2 == 1) {
                let narrow = (b.clone() - a) * T::frac(1, 1 << 20);
                match root.value {
                    RootValue::Exact(x) if *a < x && x < *b => points.push(x),
                    RootValue::Exact(_) => {}
                    RootValue::Enclosed(..) => match root.narrowed(&level, &narrow)?.value {
                        RootValue::Exact(x) => points.push(x),
                        RootValue::Enclosed(start, end) => {
                            let [knot, start, end] = [t, &start, &end].map(T::to_string);
                            return Err(Error::IrrationalPreimage { knot, start, end });
                        }
                    },
                }
            }
        }
        Ok(())
    }
}
