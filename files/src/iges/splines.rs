//! The parameters of curves and surfaces.

use crate::error::Problem;
use crate::iges::parameters::{Parameters, wrong};
use crate::nurbs::shapes::{placed, segment};
use crate::nurbs::{Along, Nurbs, by_columns};
use nalgebra::{Vector2, Vector3};
use symspline::Error;
use symspline_dynamic::{AnyRational, Value};

type Read<T> = Result<T, Problem>;

/// A spline, the part of its domain that is meant, and how many parameters tell it.
pub(super) struct Told {
    pub nurbs: Nurbs,
    /// Start and end in each direction, if they are told.
    pub ends: Vec<[f64; 2]>,
    pub length: usize,
}

impl Parameters {
    /// A spline curve, 126.
    pub(super) fn curve(&self) -> Read<Told> {
        let (count, degree) = self.sizes(1, 2)?;
        let (plane, closed) = (self.whole(3)? == 1, self.whole(4)? == 1);
        let (polynomial, periodic) = (self.whole(5)? == 1, self.whole(6)? == 1);
        let knots = self.reals(7, count + degree + 1)?;
        let at = 7 + knots.len();
        let (weights, points) = (self.reals(at, count)?, self.reals(at + count, 3 * count)?);
        let at = at + 4 * count;
        let normal = [self.real(at + 2)?, self.real(at + 3)?, self.real(at + 4)?];
        let in_plane =
            plane && normal == [0.0, 0.0, 1.0] && points.chunks_exact(3).all(|point| point[2] == 0.0);
        let dim = if in_plane { 2 } else { 3 };
        let along = vec![Along { degree, knots, periodic: periodic || closed }];
        let coords = points.chunks_exact(3).flat_map(|point| &point[..dim]).copied().collect();
        let nurbs = Nurbs { along, dim, coords, weights: if_rational(weights, polynomial)? };
        Ok(Told { nurbs, ends: self.ends(at, 1)?, length: at + 5 })
    }

    /// A spline surface, 128.
    pub(super) fn surface(&self) -> Read<Told> {
        let ((rows, u_degree), (columns, v_degree)) = (self.sizes(1, 3)?, self.sizes(2, 4)?);
        let flags = (5..10).map(|i| Ok(self.whole(i)? == 1)).collect::<Read<Vec<bool>>>()?;
        let u_knots = self.reals(10, rows + u_degree + 1)?;
        let v_knots = self.reals(10 + u_knots.len(), columns + v_degree + 1)?;
        let at = 10 + u_knots.len() + v_knots.len();
        let Some(count) = rows.checked_mul(columns).filter(|count| *count < self.len()) else {
            return wrong(format!(
                "{rows} times {columns} control points are told, {} parameters are there",
                self.len()
            ));
        };
        let (weights, points) = (self.reals(at, count)?, self.reals(at + count, 3 * count)?);
        let at = at + 4 * count;
        let order = || by_columns(columns, rows);
        let along = |degree, knots, direction: usize| Along {
            degree,
            knots,
            periodic: flags[direction] || flags[direction + 3],
        };
        let weights = if_rational(weights, flags[2])?;
        let nurbs = Nurbs {
            along: vec![along(u_degree, u_knots, 0), along(v_degree, v_knots, 1)],
            dim: 3,
            coords: order().flat_map(|i| &points[3 * i..3 * i + 3]).copied().collect(),
            weights: weights.map(|weights| order().map(|i| weights[i]).collect()),
        };
        Ok(Told { nurbs, ends: self.ends(at, 2)?, length: at + 4 })
    }

    /// A line, 110.
    pub(super) fn line(&self) -> Read<Told> {
        let ends = self.reals(1, 6)?;
        let [a, b] = [0, 3].map(|i| Vector3::from_column_slice(&ends[i..i + 3]));
        Ok(Told { nurbs: Nurbs::of(&segment(a, b)?, "IGES")?, ends: Vec::new(), length: 7 })
    }

    /// The arc of a circle, 100: of its end only the direction counts, unless it lies on the circle.
    pub(super) fn arc(&self) -> Read<Told> {
        let all = self.reals(1, 7)?;
        let z = all[0];
        let [centre, from, to] = [1, 3, 5].map(|i| Vector2::new(all[i], all[i + 1]));
        let arc = match symspline::arc(&centre, &from, &to) {
            Err(Error::NotOnCircle) => {
                let [start, end] = [from, to].map(|point| point - centre).map(|arm| arm.y.atan2(arm.x));
                let sweep = (end - start).rem_euclid(std::f64::consts::TAU);
                symspline::arc_by_angles(&centre, &(from - centre).norm(), &start, &sweep)
            }
            arc => arc,
        }?;
        let value = match z == 0.0 {
            true => AnyRational::from(arc),
            false => AnyRational::from(placed(&arc, |p| Vector3::new(p.x, p.y, z))?),
        };
        Ok(Told { nurbs: Nurbs::of(&Value::from(value), "IGES")?, ends: Vec::new(), length: 8 })
    }

    fn ends(&self, at: usize, directions: usize) -> Read<Vec<[f64; 2]>> {
        if (at..at + 2 * directions).all(|i| self.is_blank(i)) {
            return Ok(Vec::new());
        }
        (0..directions).map(|i| Ok([self.real(at + 2 * i)?, self.real(at + 2 * i + 1)?])).collect()
    }
}

fn if_rational(weights: Vec<f64>, polynomial: bool) -> Read<Option<Vec<f64>>> {
    match (polynomial, weights.iter().all(|w| *w == weights[0] && *w > 0.0)) {
        (true, true) => Ok(None),
        (true, false) => wrong("the spline is called polynomial, and its weights are not equal and positive"),
        (false, _) => Ok(Some(weights)),
    }
}
