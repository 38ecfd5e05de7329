//! Values as CAD files tell them.

use crate::error::Problem;
use crate::nurbs::{Along, Nurbs};
use symspline::{Q, SplineSpace};
use symspline_dynamic::{Any, AnySpace, Coords, Family, Over, Value};

type Told<T> = Result<T, Problem>;

impl Nurbs {
    /// What a format tells of a value.
    ///
    /// # Errors
    /// [`Problem::NoRoom`] for values that are no curves and surfaces, for fractions that are no floats, and for degree 0, which CAD
    /// formats do not have; [`Problem::Value`] for a rational spline with a weight that is not positive, which has no control point.
    pub(crate) fn of(value: &Value, format: &'static str) -> Told<Self> {
        let told = match value {
            Value::Spline(s) => Self::unrolled(s, format),
            Value::Surface(s) => Self::unrolled(s, format),
            Value::Rational(s) => Self::unrolled(s, format),
            Value::RationalSurface(s) => Self::unrolled(s, format),
            other => Err(Problem::NoRoom { format, value: other.to_string() }),
        }?;
        match told.along.iter().any(|along| along.degree == 0) {
            true => Err(Problem::NoRoom { format, value: format!("{} of degree 0", value.kind()) }),
            false => Ok(told),
        }
    }

    fn unrolled<F: Family>(s: &Any<F>, format: &'static str) -> Told<Self> {
        if s.dim() < 2 {
            return Err(Problem::NoRoom { format, value: s.kind().to_owned() });
        }
        let spaces =
            s.spaces().iter().map(|space| floats_of_space(space, format)).collect::<Told<Vec<_>>>()?;
        let points = floats(&s.coords()?, format)?;
        let weights = s.weights().map(|weights| floats(&weights, format)).transpose()?;
        let dim = s.dim();
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
        Self {
            degree: space.degree(),
            knots: space.knots().as_slice().to_vec(),
            periodic: space.is_periodic(),
        }
    }
}

/// Each thing of `size` numbers where the unrolled knots need it: those of periodic spaces come again.
fn wrapped(numbers: &[f64], size: usize, spaces: &[SplineSpace<f64>]) -> Vec<f64> {
    let unrolled = |space: &SplineSpace<f64>| space.knots().len() - space.degree() - 1;
    let inner: usize = spaces[1..].iter().map(SplineSpace::dim).product();
    let things = numbers.chunks_exact(size * inner).collect::<Vec<_>>();
    let picked = (0..unrolled(&spaces[0])).map(|i| things[spaces[0].slot(i)]);
    match &spaces[1..] {
        [] => picked.flatten().copied().collect(),
        rest => picked.flat_map(|row| wrapped(row, size, rest)).collect(),
    }
}

fn floats(coords: &Coords, format: &'static str) -> Told<Vec<f64>> {
    match coords {
        // The quotient by a tiny weight may be too large.
        Over::Float(all) => match all.iter().position(|x| !x.is_finite()) {
            Some(index) => Err(symspline::Error::NotFinite { what: "control point", index }.into()),
            None => Ok(all.clone()),
        },
        Over::Exact(all) => all.iter().map(|x| float(x, format)).collect(),
    }
}

fn floats_of_space(space: &AnySpace, format: &'static str) -> Told<SplineSpace<f64>> {
    match space {
        Over::Float(space) => Ok(space.clone()),
        Over::Exact(exact) => {
            let knots = exact.knots().iter().map(|t| float(t, format)).collect::<Told<Vec<f64>>>()?;
            let rounded = exact.map_scalars(|t| Ok(t.to_f64()))?;
            // Of a periodic space those beyond the domain are rounded sums.
            match rounded.knots().as_slice() == knots {
                true => Ok(rounded),
                false => {
                    Err(Problem::NoRoom { format, value: "period that is no float, exactly".to_owned() })
                }
            }
        }
    }
}

/// The float that a fraction is.
fn float(x: &Q, format: &'static str) -> Told<f64> {
    let near = x.to_f64();
    match Q::try_from(near).is_ok_and(|back| back == *x) {
        true => Ok(near),
        false => Err(Problem::NoRoom {
            format,
            value: format!("exact number {x}: it is no float; convert the value with `to_float`"),
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use symspline::Scalar;
    use symspline_dynamic::{AnyRational, AnySpline, AnySurface};

    const NAME: &str = "X";

    fn line(points: [[Q; 2]; 2]) -> Value {
        let space = SplineSpace::bezier(1, Q::int(0), Q::int(1)).unwrap();
        AnySpline::new(space.into(), 2, Over::Exact(points.into_iter().flatten().collect())).unwrap().into()
    }

    #[test]
    fn fractions_are_told_if_they_are_floats() {
        let told = Nurbs::of(&line([[Q::int(0), Q::frac(1, 8)], [Q::int(3), Q::int(-4)]]), NAME).unwrap();
        assert_eq!((told.dim, told.coords), (2, vec![0.0, 0.125, 3.0, -4.0]));
        let refused =
            Nurbs::of(&line([[Q::int(0), Q::frac(1, 3)], [Q::int(3), Q::int(-4)]]), NAME).unwrap_err();
        let text = "X files hold no exact number 1/3: it is no float; convert the value with `to_float`";
        assert_eq!(refused.to_string(), text);
    }

    #[test]
    fn what_is_no_curve_in_plane_or_space_is_refused() {
        let space = || AnySpace::from(SplineSpace::bezier(1, 0.0, 1.0).unwrap());
        let function = AnySpline::new(space(), 1, Over::Float(vec![0.0, 1.0])).unwrap();
        let refused = |value: Value| Nurbs::of(&value, NAME).unwrap_err().to_string();
        assert_eq!(refused(function.into()), "X files hold no function");
        assert_eq!(refused(Over::Float(1.0).into()), "X files hold no float number 1");
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
