//! Values from what files of floats tell.

use crate::error::Problem;
use crate::nurbs::{Along, Nurbs};
use symspline::{Direction, SplineSpace};
use symspline_dynamic::{
    AnyRational, AnyRationalSurface, AnySpace, AnySpline, AnySurface, Number, Over, Value,
};

impl Nurbs {
    /// The value that was told.
    ///
    /// # Errors
    /// Those of the library.
    pub(crate) fn into_value(mut self) -> Result<Value, Problem> {
        let open = |along: &Along| SplineSpace::new(along.degree, along.knots.iter().copied());
        let mut spaces = self.along.iter().map(open).collect::<symspline::Result<Vec<_>>>()?;
        if spaces.iter().map(SplineSpace::dim).product::<usize>() * self.dim == self.coords.len() {
            (0..spaces.len()).for_each(|direction| self.close(&mut spaces, direction));
        }
        let (dim, coords, weights) = (self.dim, Over::Float(self.coords), self.weights.map(Over::Float));
        let mut spaces = spaces.into_iter().map(AnySpace::from);
        Ok(match (spaces.next(), spaces.next(), weights) {
            (Some(space), None, None) => AnySpline::new(space, dim, coords)?.into(),
            (Some(space), None, Some(weights)) => AnyRational::new(space, dim, coords, weights)?.into(),
            (Some(u), Some(v), None) => AnySurface::new(u, v, dim, coords)?.into(),
            (Some(u), Some(v), Some(weights)) => AnyRationalSurface::new(u, v, dim, coords, weights)?.into(),
            (None, ..) => unreachable!("a spline has a parameter"),
        })
    }

    /// The part of that value between two ends in each direction; all of it if there are none.
    ///
    /// # Errors
    /// Those of the library, also for ends that are not in the domain.
    pub(crate) fn into_part(self, ends: &[[f64; 2]]) -> Result<Value, Problem> {
        let along = self.along.clone();
        let mut value = self.into_value()?;
        for ((along, part), direction) in along.iter().zip(ends).zip([Direction::U, Direction::V]) {
            if *part != along.domain() {
                value = restricted(&value, direction, part.map(Over::Float))?;
            }
        }
        Ok(value)
    }

    /// Makes the space of a direction periodic if it is called so, and if knots and control points come again to the last bit.
    fn close(&mut self, spaces: &mut [SplineSpace<f64>], direction: usize) {
        let Some(ring) = self.along[direction].periodic.then(|| ring(&spaces[direction])).flatten() else {
            return;
        };
        let inner: usize = spaces[direction + 1..].iter().map(SplineSpace::dim).product();
        let (all, once) = (spaces[direction].dim() * inner, ring.dim() * inner);
        let coords = once_round(&self.coords, all * self.dim, once * self.dim);
        let weights = self.weights.as_ref().map(|weights| once_round(weights, all, once));
        match (coords, weights) {
            (Some(coords), None) => self.coords = coords,
            (Some(coords), Some(Some(weights))) => (self.coords, self.weights) = (coords, Some(weights)),
            _ => return,
        }
        spaces[direction] = ring;
    }
}

fn restricted(value: &Value, direction: Direction, [a, b]: [Number; 2]) -> Result<Value, Problem> {
    Ok(match value {
        Value::Spline(s) => s.restricted(&a, &b)?.into(),
        Value::Rational(s) => s.restricted(&a, &b)?.into(),
        Value::Surface(s) => s.restricted(direction, &a, &b)?.into(),
        Value::RationalSurface(s) => s.restricted(direction, &a, &b)?.into(),
        _ => unreachable!("a curve or a surface was told"),
    })
}

/// The periodic space whose unrolled knots are these, if there is one.
fn ring(open: &SplineSpace<f64>) -> Option<SplineSpace<f64>> {
    let (knots, (start, end)) = (open.knots(), open.domain());
    // Where the seam is, and how often: knots and control points that count nowhere in the domain are left out. A clamped start is no
    // seam, though the ends may meet.
    let seam = knots.iter().position(|t| t == start).filter(|seam| *seam > 0)?;
    let copies = (open.degree() + 1).checked_sub(seam)?;
    let count = (open.dim() + copies).checked_sub(open.degree() + 1).filter(|count| *count > 0)?;
    let round = knots.get(seam..seam + count)?;
    let ring = SplineSpace::periodic_up_to(open.degree(), round.iter().copied(), *end).ok()?;
    (ring.knots().get(..knots.len())? == knots.as_slice() && open.dim() >= ring.dim()).then_some(ring)
}

/// The first `once` numbers of each `all`, if the others repeat them.
fn once_round(numbers: &[f64], all: usize, once: usize) -> Option<Vec<f64>> {
    let repeats = |chunk: &[f64]| {
        chunk.iter().skip(once).zip(chunk).all(|(later, number)| later.to_bits() == number.to_bits())
    };
    let mut chunks = numbers.chunks_exact(all);
    chunks.clone().all(repeats).then(|| chunks.by_ref().flat_map(|chunk| chunk[..once].to_vec()).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(periodic: bool, coords: &[f64]) -> Nurbs {
        let space = SplineSpace::periodic(2, [0.1, 0.7, 1.3, 1.3], 2.0).unwrap();
        let along = Along { degree: 2, knots: space.knots().to_vec(), periodic };
        Nurbs { along: vec![along], dim: 2, coords: coords.to_vec(), weights: None }
    }

    fn is_periodic(told: Nurbs) -> bool {
        match told.into_value().unwrap() {
            Value::Spline(s) => matches!(s.space(), Over::Float(space) if space.is_periodic()),
            other => panic!("{other}"),
        }
    }

    #[test]
    fn a_space_is_periodic_if_it_is_called_so_and_all_comes_again() {
        let ring = [0.1, 0.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 0.1, 0.0, 2.0, 3.0];
        assert!(is_periodic(told(true, &ring)));
        assert!(!is_periodic(told(false, &ring)));
        let other_sign = [0.1, 0.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 0.1, -0.0, 2.0, 3.0];
        assert!(!is_periodic(told(true, &other_sign)));
        let mut other_knot = told(true, &ring);
        *other_knot.along[0].knots.last_mut().unwrap() += 1e-9;
        assert!(!is_periodic(other_knot));
    }

    #[test]
    fn too_few_points_are_an_error_and_no_panic() {
        assert!(matches!(told(true, &[0.0; 4]).into_value(), Err(Problem::Value(_))));
        let mut short = told(true, &[0.0; 12]);
        short.along[0].knots.truncate(4);
        assert!(matches!(short.into_value(), Err(Problem::Value(_))));
    }
}
