//! Lines, quadratics, cubics and conics one after the other, as one spline.
//!
//! The spline has the highest degree among them and one span `[k, k + 1]` for each, with knots of full multiplicity between: it is
//! continuous, and each piece is what it was. Pieces of a lower degree are elevated.

use crate::error::Problem;
use nalgebra::Vector2;
use symspline::{Coeff, NurbsCurve, Spline, SplineSpace, Weighted};
use symspline_dynamic::{AnyRational, AnySpline, Value};

/// A point of the plane.
pub(crate) type Point = Vector2<f64>;

/// A piece that goes on from where the one before ended, by its further control points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Segment {
    /// A line.
    Line(Point),
    /// A parabola.
    Quadratic([Point; 2]),
    /// A cubic.
    Cubic([Point; 3]),
    /// A conic with the weights `1, w, 1`.
    Conic([Point; 2], f64),
}

impl Segment {
    /// Where it ends.
    pub fn end(&self) -> Point {
        *self.points().last().expect("a segment has an end")
    }

    fn points(&self) -> &[Point] {
        match self {
            Self::Line(end) => std::slice::from_ref(end),
            Self::Quadratic(points) | Self::Conic(points, _) => points,
            Self::Cubic(points) => points,
        }
    }

    /// The same after a map of points that is affine.
    pub fn mapped(&self, map: impl Fn(Point) -> Point) -> Self {
        match *self {
            Self::Line(end) => Self::Line(map(end)),
            Self::Quadratic(points) => Self::Quadratic(points.map(map)),
            Self::Cubic(points) => Self::Cubic(points.map(map)),
            Self::Conic(points, weight) => Self::Conic(points.map(map), weight),
        }
    }
}

/// A start and the pieces from there on.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Outline {
    pub start: Point,
    pub segments: Vec<Segment>,
}

impl Outline {
    /// One that starts here.
    pub fn at(start: Point) -> Self {
        Self { start, segments: Vec::new() }
    }

    /// Where it ends so far.
    pub fn end(&self) -> Point {
        self.segments.last().map_or(self.start, Segment::end)
    }

    /// Goes back to the start by a line, unless it is there.
    pub fn close(&mut self) {
        if self.end() != self.start {
            self.segments.push(Segment::Line(self.start));
        }
    }

    /// The same after a map of points that is affine.
    pub fn mapped(&self, map: impl Fn(Point) -> Point) -> Self {
        let segments = self.segments.iter().map(|segment| segment.mapped(&map)).collect();
        Self { start: map(self.start), segments }
    }

    /// The spline, rational if there are conics; none without pieces.
    ///
    /// # Errors
    /// [`symspline::Error::NotFinite`] and others of the library.
    pub fn value(&self) -> Result<Option<Value>, Problem> {
        if self.segments.is_empty() {
            return Ok(None);
        }
        let is_rational = self.segments.iter().any(|segment| matches!(segment, Segment::Conic(..)));
        let starts = std::iter::once(self.start).chain(self.segments.iter().map(Segment::end));
        let pieces = starts.zip(&self.segments);
        Ok(Some(if is_rational {
            let lifted = joined(pieces.map(|(start, segment)| {
                let weight = |i: usize| match segment {
                    Segment::Conic(_, weight) if i == 0 => *weight,
                    _ => 1.0,
                };
                let lifted = |(i, point): (usize, &Point)| Weighted::new(point, weight(i));
                let rest = segment.points().iter().enumerate().map(lifted);
                std::iter::once(Weighted::new(&start, 1.0)).chain(rest).collect()
            }))?;
            AnyRational::from(NurbsCurve::from_lifted(lifted)?).into()
        } else {
            let all = pieces.map(|(start, segment)| [&[start], segment.points()].concat());
            AnySpline::from(joined(all)?).into()
        }))
    }
}

/// The spline of Bezier pieces, each of which starts where the one before ends.
fn joined<C: Coeff<f64>>(pieces: impl Iterator<Item = Vec<C>>) -> Result<Spline<f64, C>, Problem> {
    let pieces: Vec<Vec<C>> = pieces.collect();
    let degree = pieces.iter().map(Vec::len).max().unwrap_or(2) - 1;
    let count = pieces.len();
    let mut coeffs = Vec::with_capacity(degree * count + 1);
    for mut piece in pieces {
        if piece.len() <= degree {
            let space = SplineSpace::bezier(piece.len() - 1, 0.0, 1.0)?;
            let raise = degree + 1 - piece.len();
            piece = Spline::new(space, piece)?.elevated(raise)?.into_coeffs();
        }
        // The first point of all others is the last one before.
        coeffs.extend(piece.into_iter().skip(usize::from(!coeffs.is_empty())));
    }
    let inner = (1..count).flat_map(|k| std::iter::repeat_n(k as f64, degree));
    let breaks = std::iter::once(0.0).chain(inner).chain([count as f64]);
    Ok(Spline::new(SplineSpace::clamped(degree, breaks)?, coeffs)?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::vector;
    use symspline_dynamic::Over;

    #[test]
    fn pieces_stay_what_they_were() {
        let [a, b, c, d] = [vector![0.0, 0.0], vector![3.0, 0.0], vector![3.0, 6.0], vector![0.0, 6.0]];
        let mut outline = Outline { start: a, segments: vec![Segment::Line(b), Segment::Cubic([c, d, d])] };
        outline.close();
        let Value::Spline(curve) = outline.value().unwrap().unwrap() else { panic!() };
        assert_eq!((curve.dim(), curve.domain()), (2, (Over::Float(0.0), Over::Float(3.0))));
        let at = |x: f64| curve.at(&Over::Float(x)).unwrap();
        assert_eq!(at(1.0 / 3.0), Over::Float(vec![1.0, 0.0]));
        // (3,0) (3,6) (0,6) (0,6) in the middle.
        assert_eq!(at(1.5), Over::Float(vec![1.5, 5.25]));
        assert_eq!(at(3.0), at(0.0));
    }

    #[test]
    fn conics_are_exact() {
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let corner = [vector![1.0, 1.0], vector![0.0, 1.0]];
        let segments = vec![Segment::Conic(corner, half), Segment::Cubic([vector![-1.0, 1.0]; 3])];
        let outline = Outline { start: vector![1.0, 0.0], segments };
        let Value::Rational(curve) = outline.value().unwrap().unwrap() else { panic!() };
        for i in 0..=16 {
            let Over::Float(point) = curve.at(&Over::Float(f64::from(i) / 16.0)).unwrap() else { panic!() };
            assert!((point[0].hypot(point[1]) - 1.0).abs() < 1e-15);
        }
    }
}
