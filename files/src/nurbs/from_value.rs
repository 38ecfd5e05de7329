//! Values as files of floats tell them.

use crate::error::Problem;
use crate::nurbs::{Along, Nurbs};
use crate::projected::Projected;
use symspline::SplineSpace;
use symspline_dynamic::{Any, AnySpace, Coords, Family, Over, Value};

type Told<T> = Result<T, Problem>;

impl Nurbs {
    /// What a format tells of a value: fractions are rounded to the nearest floats.
    ///
    /// # Errors
    /// [`Problem::NoRoom`] for values that are no curves and surfaces in the plane or space, for degree 0, which formats do not
    /// have, and for rational ones with a weight that is not positive, or so small that the point is beyond floats; [`Problem::Value`]
    /// where rounding makes knots fall together.
    pub(crate) fn of(value: &Value, format: &'static str) -> Told<Self> {
        let told = match value {
            Value::Spline(s) => Self::unrolled(s, None, format),
            Value::Surface(s) => Self::unrolled(s, None, format),
            Value::Rational(s) => Self::unrolled(s, Some(s.homogeneous()), format),
            Value::RationalSurface(s) => Self::unrolled(s, Some(s.homogeneous()), format),
            other => Err(Problem::NoRoom { format, value: other.kind().to_owned() }),
        }?;
        match told.along.iter().any(|along| along.degree == 0) {
            true => Err(Problem::NoRoom { format, value: format!("{} of degree 0", value.kind()) }),
            false => Ok(told),
        }
    }

    fn unrolled<F: Family>(s: &Any<F>, weighted: Option<Coords>, format: &'static str) -> Told<Self> {
        let (dim, kind) = (s.dim(), s.kind());
        if dim < 2 {
            return Err(Problem::NoRoom { format, value: kind.to_owned() });
        }
        let spaces = s.spaces().iter().map(floats_of_space).collect::<Told<Vec<_>>>()?;
        let (points, weights) = match weighted {
            None => (floats(&s.coords()?)?, None),
            Some(weighted) => {
                let far = || Problem::NoRoom {
                    format,
                    value: format!("{kind} with a weight that is zero, negative or too small"),
                };
                let found = Projected::of(&weighted, dim).ok_or_else(far)?;
                let weights = floats(&found.weights)?;
                // The nearest float of a tiny fraction is zero.
                if weights.contains(&0.0) {
                    return Err(far());
                }
                (floats(&found.points)?, Some(weights))
            }
        };
        Ok(Self {
            coords: wrapped(&points, dim, &spaces),
            weights: weights.map(|weights| wrapped(&weights, 1, &spaces)),
            along: spaces.iter().map(Along::of).collect(),
            dim,
        })
    }
}

impl Along {
    fn of(space: &SplineSpace<f64>) -> Self {
        let knots = space.knots().as_slice();
        Self {
            degree: space.degree(),
            knots: knots[..knots.len() - unused(space)].to_vec(),
            periodic: space.is_periodic(),
        }
    }
}

/// How many of the last unrolled knots, and control points, count nowhere in the domain: one for each further copy of the seam.
fn unused(space: &SplineSpace<f64>) -> usize {
    let start = space.domain().0;
    let copies = || space.knots().iter().filter(|t| *t == start).count();
    if space.is_periodic() { copies() - 1 } else { 0 }
}

/// Each thing of `size` numbers where the unrolled knots need it: those of periodic spaces come again.
fn wrapped(numbers: &[f64], size: usize, spaces: &[SplineSpace<f64>]) -> Vec<f64> {
    let unrolled = |space: &SplineSpace<f64>| space.knots().len() - space.degree() - 1 - unused(space);
    let inner: usize = spaces[1..].iter().map(SplineSpace::dim).product();
    let things = numbers.chunks_exact(size * inner).collect::<Vec<_>>();
    let picked = (0..unrolled(&spaces[0])).map(|i| things[spaces[0].slot(i)]);
    match &spaces[1..] {
        [] => picked.flatten().copied().collect(),
        rest => picked.flat_map(|row| wrapped(row, size, rest)).collect(),
    }
}

fn floats(coords: &Coords) -> Told<Vec<f64>> {
    match coords.to_float()? {
        Over::Float(all) => Ok(all),
        Over::Exact(_) => unreachable!("they were rounded to floats"),
    }
}

fn floats_of_space(space: &AnySpace) -> Told<SplineSpace<f64>> {
    match space.to_float()? {
        Over::Float(space) => Ok(space),
        Over::Exact(_) => unreachable!("it was rounded to floats"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use symspline::{Q, Scalar};
    use symspline_dynamic::{AnyRational, AnySpline, AnySurface};

    const NAME: &str = "X";

    #[test]
    fn fractions_are_told_by_the_nearest_floats() {
        let line = SplineSpace::bezier(1, Q::int(0), Q::frac(1, 10)).unwrap();
        let coords = [Q::int(0), Q::frac(1, 3), Q::int(3), Q::frac(-7, 8)].to_vec();
        let told =
            Nurbs::of(&AnySpline::new(line.into(), 2, Over::Exact(coords)).unwrap().into(), NAME).unwrap();
        assert_eq!((told.dim, told.coords), (2, vec![0.0, 1.0 / 3.0, 3.0, -0.875]));
        assert_eq!(told.along[0].knots, [0.0, 0.0, 0.1, 0.1]);
        let close = SplineSpace::new(
            1,
            ["0", "0", "1", "1", "1.00000000000000000001", "2", "2"].map(|t| t.parse::<Q>().unwrap()),
        );
        let curve = AnySpline::new(close.unwrap().into(), 2, Over::Exact(vec![Q::int(0); 10])).unwrap();
        assert!(matches!(Nurbs::of(&curve.into(), NAME), Err(Problem::Value(_))));
    }

    /// Of fractions the points themselves are rounded, not products with weights; and a weight must be a float that is positive.
    #[test]
    fn weights_and_points_stand_apart() {
        let space = || AnySpace::from(SplineSpace::bezier(1, Q::int(0), Q::int(1)).unwrap());
        let points = Over::Exact([1, 2, 3, 4].map(|n| Q::frac(n, 7)).to_vec());
        let weights = |tiny: Q| Over::Exact(vec![Q::frac(3, 11), tiny]);
        let told = |tiny| {
            Nurbs::of(&AnyRational::new(space(), 2, points.clone(), weights(tiny)).unwrap().into(), NAME)
        };
        let near = told(Q::frac(1, 13)).unwrap();
        assert_eq!(near.coords, [1.0 / 7.0, 2.0 / 7.0, 3.0 / 7.0, 4.0 / 7.0]);
        assert_eq!(near.weights, Some(vec![3.0 / 11.0, 1.0 / 13.0]));
        let tiny = format!("1/1{}", "0".repeat(400)).parse().unwrap();
        assert_eq!(
            told(tiny).unwrap_err().to_string(),
            "X files hold no rational curve with a weight that is zero, negative or too small"
        );
    }

    #[test]
    fn what_is_no_curve_in_plane_or_space_is_refused() {
        let space = || AnySpace::from(SplineSpace::bezier(1, 0.0, 1.0).unwrap());
        let function = AnySpline::new(space(), 1, Over::Float(vec![0.0, 1.0])).unwrap();
        let refused = |value: Value| Nurbs::of(&value, NAME).unwrap_err().to_string();
        assert_eq!(refused(function.into()), "X files hold no function");
        assert_eq!(refused(Over::Float(1.0).into()), "X files hold no number");
        let constant = SplineSpace::new(0, [0.0, 1.0]).unwrap().into();
        let step = AnySpline::new(constant, 2, Over::Float(vec![0.0, 1.0])).unwrap();
        assert_eq!(refused(step.into()), "X files hold no curve of degree 0");
    }

    #[test]
    fn control_points_of_periodic_spaces_come_again_in_both_directions() {
        let ring = || AnySpace::from(SplineSpace::uniform_periodic(2, 3, 0.0, 3.0).unwrap());
        let line = AnySpace::from(SplineSpace::bezier(1, 0.0, 1.0).unwrap());
        let points: Vec<f64> = (0..18).map(f64::from).collect();
        let tube =
            |u, v| Nurbs::of(&AnySurface::new(u, v, 3, Over::Float(points.clone())).unwrap().into(), NAME);
        let first = |told: Nurbs| told.points().map(|point| point[0] / 3.0).collect::<Vec<_>>();
        assert_eq!(
            first(tube(ring(), line.clone()).unwrap()),
            [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 0.0, 1.0, 2.0, 3.0]
        );
        assert_eq!(first(tube(line, ring()).unwrap()), [0.0, 1.0, 2.0, 0.0, 1.0, 3.0, 4.0, 5.0, 3.0, 4.0]);
        let weights = Over::Float(vec![1.0, 2.0, 3.0]);
        let curve = AnyRational::new(ring(), 2, Over::Float(vec![0.0; 6]), weights).unwrap();
        let told = Nurbs::of(&curve.into(), NAME).unwrap();
        assert_eq!(told.weights, Some(vec![1.0, 2.0, 3.0, 1.0, 2.0]));
        assert_eq!(told.along[0].knots, [-2.0, -1.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0]);
        assert!(told.along[0].periodic);
    }
}
