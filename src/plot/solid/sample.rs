//! Meshes of spline surfaces.
//!
//! All knots are lines of the mesh. Along knots where the surface is not twice differentiable the vertices are doubled, and
//! each side has its own normals and values: creases stay sharp, and so do jumps of the curvature. A periodic surface that
//! is smooth at its seam is closed there: its last column of faces ends at the first vertices.

use crate::error::{Error, Result};
use crate::plot::solid::Point3;
use crate::plot::solid::mesh::{Mesh, check_count};
use crate::plot::solid::normals::{across, filled};
use crate::rational::spline::NurbsSurface;
use crate::space::SplineSpace;
use crate::tensor::along::Direction;
use crate::tensor::spline::Surface;

/// A surface in space that can be meshed: polynomial or rational.
pub trait Meshed: Sized {
    /// The spaces along `u` and `v`.
    fn spaces(&self) -> [&SplineSpace<f64>; 2];

    /// The part from `a` to `b` along a direction.
    ///
    /// # Errors
    /// As `restricted` of the surface.
    fn part(&self, direction: Direction, a: f64, b: f64) -> Result<Self>;

    /// Value and derivatives `[S, S_u, S_v]` at a point.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    fn tangents(&self, u: f64, v: f64) -> Result<[Point3; 3]>;
}

macro_rules! meshed {
    ($($surface:ty),*) => {$(
        impl Meshed for $surface {
            fn spaces(&self) -> [&SplineSpace<f64>; 2] {
                [self.u(), self.v()]
            }

            fn part(&self, direction: Direction, a: f64, b: f64) -> Result<Self> {
                self.restricted(direction, &a, &b)
            }

            fn tangents(&self, u: f64, v: f64) -> Result<[Point3; 3]> {
                self.tangents_at(&u, &v)
            }
        }
    )*};
}

meshed!(Surface<f64, 3>, NurbsSurface<f64, 3>);

impl Mesh {
    /// The mesh of a surface, without values: about `u_steps` by `v_steps` quadrangles, all knots among their sides.
    ///
    /// Each span gets its share of the steps by its length, one at least. Normals are those of the surface, `S_u × S_v`; where
    /// these vanish, as at a pole, they come from the faces around the point.
    ///
    /// # Errors
    /// [`Error::Drawing`] without steps; [`Error::TooLarge`]; [`Error::NotFinite`] where points or derivatives overflow.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::plot::Mesh;
    /// use symspline::{SplineSpace, Surface};
    /// let line = SplineSpace::bezier(1, 2.0, 5.0)?;
    /// let corners = vec![vector![0.0, 0.0, 0.0], vector![0.0, 1.0, 0.0], vector![1.0, 0.0, 0.0], vector![1.0, 1.0, 0.0]];
    /// let mesh = Mesh::of(&Surface::new(line.clone(), line, corners)?, 4, 2)?;
    /// assert_eq!((mesh.positions().len(), mesh.faces().count()), (15, 8));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn of<S: Meshed>(surface: &S, u_steps: usize, v_steps: usize) -> Result<Self> {
        sampled(surface, [u_steps, v_steps], |_, _, _| Ok(None))
    }

    /// The mesh of a surface with a value at each vertex, such as a curvature.
    ///
    /// `value` is asked with a part of the surface, whose values at its border are limits from inside, and the parameters. A
    /// vertex where the surface has no normal, or where the value overflows, gets none.
    ///
    /// # Errors
    /// As [`of`](Self::of), and those of `value` but for [`Error::NoNormal`] and [`Error::NotFinite`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::plot::Mesh;
    /// use symspline::{SplineSpace, Surface};
    /// // z = x y
    /// let line = SplineSpace::bezier(1, -1.0, 1.0)?;
    /// let corners = vec![vector![-1.0, -1.0, 1.0], vector![-1.0, 1.0, -1.0], vector![1.0, -1.0, -1.0], vector![1.0, 1.0, 1.0]];
    /// let saddle = Surface::new(line.clone(), line, corners)?;
    /// let mesh = Mesh::sampled(&saddle, 2, 2, Surface::gaussian_curvature_at)?;
    /// assert_eq!(mesh.values()[4], Some(-1.0));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn sampled<S: Meshed>(
        surface: &S,
        u_steps: usize,
        v_steps: usize,
        value: impl Fn(&S, &f64, &f64) -> Result<f64>,
    ) -> Result<Self> {
        let optional = |part: &S, u: f64, v: f64| match value(part, &u, &v) {
            Ok(value) => Ok(Some(value).filter(|value| value.is_finite())),
            Err(Error::NoNormal { .. } | Error::NotFinite { .. }) => Ok(None),
            Err(error) => Err(error),
        };
        sampled(surface, [u_steps, v_steps], optional)
    }
}

fn sampled<S: Meshed>(
    surface: &S,
    steps: [usize; 2],
    value: impl Fn(&S, f64, f64) -> Result<Option<f64>>,
) -> Result<Mesh> {
    if steps.contains(&0) {
        return Err(Error::Drawing { message: "a mesh needs a step at least in each direction".into() });
    }
    let [u, v] = surface.spaces();
    let (us, vs) = (Lines::new(u, steps[0])?, Lines::new(v, steps[1])?);
    check_count(us.count().saturating_mul(vs.count()))?;
    let mut meshes = Vec::new();
    for along_u in &us.runs {
        let strip = if us.runs.len() > 1 {
            Some(surface.part(Direction::U, along_u[0], last(along_u))?)
        } else {
            None
        };
        let strip = strip.as_ref().unwrap_or(surface);
        for along_v in &vs.runs {
            let part = if vs.runs.len() > 1 {
                Some(strip.part(Direction::V, along_v[0], last(along_v))?)
            } else {
                None
            };
            let part = part.as_ref().unwrap_or(strip);
            meshes.push(grid(part, [along_u, along_v], [us.closed, vs.closed], &value)?);
        }
    }
    match meshes.len() {
        1 => Ok(meshes.swap_remove(0)),
        _ => Mesh::joined(&meshes),
    }
}

/// The mesh of a part that is twice differentiable.
fn grid<S: Meshed>(
    part: &S,
    [us, vs]: [&[f64]; 2],
    [u_closed, v_closed]: [bool; 2],
    value: impl Fn(&S, f64, f64) -> Result<Option<f64>>,
) -> Result<Mesh> {
    let rows = us.len() - usize::from(u_closed);
    let columns = vs.len() - usize::from(v_closed);
    let mut positions = Vec::with_capacity(rows * columns);
    let (mut normals, mut values) = (Vec::with_capacity(rows * columns), Vec::with_capacity(rows * columns));
    for u in &us[..rows] {
        for v in &vs[..columns] {
            let [point, along_u, along_v] = part.tangents(*u, *v)?;
            positions.push(point);
            normals.push(across(&along_u, &along_v));
            values.push(value(part, *u, *v)?);
        }
    }
    let vertex = |i: usize, j: usize| (i % rows) * columns + j % columns;
    let face = |i: usize, j: usize| [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
    let faces = (0..us.len() - 1).flat_map(|i| (0..vs.len() - 1).map(move |j| (i, j)));
    let mesh = Mesh::new(positions, faces.map(|(i, j)| face(i, j)))?;
    let normals = filled(mesh.positions(), normals, mesh.faces());
    mesh.with_normals(normals)?.with_values(values)
}

/// Where the lines of a mesh lie along one direction.
struct Lines {
    /// The parameters, a run for every part that is twice differentiable.
    runs: Vec<Vec<f64>>,
    /// Whether the end is the start again.
    closed: bool,
}

impl Lines {
    fn new(space: &SplineSpace<f64>, steps: usize) -> Result<Self> {
        let breaks = space.breaks();
        let (a, b) = space.domain();
        let share =
            |start: f64, end: f64| (steps as f64 * ((end - start) / (b - a)) - 1e-9).ceil().max(1.0) as usize;
        let spans = || breaks.windows(2).map(|ends| (ends[0].0, ends[1].0));
        check_count(spans().fold(0, |count: usize, (start, end)| count.saturating_add(share(start, end))))?;
        let smooth = |multiplicity: usize| multiplicity + 1 < space.degree();
        let (mut runs, mut run) = (Vec::new(), vec![*a]);
        for ((start, end), (_, multiplicity)) in spans().zip(&breaks[1..]) {
            let count = share(start, end);
            run.extend((1..count).map(|i| start + (end - start) * (i as f64 / count as f64)));
            run.push(end);
            if !smooth(*multiplicity) && end < *b {
                runs.push(std::mem::replace(&mut run, vec![end]));
            }
        }
        runs.push(run);
        // Two rows of faces would lie upon each other.
        let enough = runs.len() == 1 && runs[0].len() > 3;
        let closed = space.is_periodic() && enough && smooth(breaks[0].1);
        Ok(Self { runs, closed })
    }

    fn count(&self) -> usize {
        self.runs.iter().map(Vec::len).sum()
    }
}

fn last(run: &[f64]) -> f64 {
    run[run.len() - 1]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::conics::circle;
    use nalgebra::vector;

    /// The surface of revolution about the z axis of a quarter circle, with a pole: a sphere's upper half.
    fn dome(radius: f64) -> NurbsSurface<f64, 3> {
        let ring = circle(&vector![0.0, 0.0], &1.0).unwrap();
        let rim = ring.restricted(&0.0, &0.25).unwrap();
        let (mut points, mut weights) = (Vec::new(), Vec::new());
        for profile in rim.lifted().coeffs() {
            let [x, z] = <[f64; 2]>::from(profile.point / profile.weight);
            for c in ring.lifted().coeffs() {
                let p = c.point / c.weight;
                points.push(vector![x * p[0], x * p[1], z] * radius);
                weights.push(profile.weight * c.weight);
            }
        }
        NurbsSurface::new(rim.space().clone(), ring.space().clone(), points, weights).unwrap()
    }

    /// A periodic tube about the z axis of degree 3.
    fn tube() -> Surface<f64, 3> {
        let ring = SplineSpace::uniform_periodic(3, 24, -2.0, 5.0).unwrap();
        let line = SplineSpace::bezier(1, 0.0, 3.0).unwrap();
        let at = |i: usize| (std::f64::consts::TAU * i as f64 / 24.0).sin_cos();
        let pair = |i: usize| [0.0, 3.0].map(|z| vector![at(i).1, at(i).0, z]);
        Surface::new(ring, line, (0..24).flat_map(pair).collect()).unwrap()
    }

    #[test]
    fn a_sphere_is_curved_alike_everywhere_but_at_its_pole() {
        let mesh = Mesh::sampled(&dome(2.0), 8, 16, NurbsSurface::gaussian_curvature_at).unwrap();
        let mean = Mesh::sampled(&dome(2.0), 8, 16, NurbsSurface::mean_curvature_at).unwrap();
        let mut poles = 0;
        for (i, p) in mesh.positions().iter().enumerate() {
            assert!((p.norm() - 2.0).abs() < 1e-12);
            let out = p / 2.0;
            match (mesh.values()[i], mean.values()[i]) {
                (Some(gaussian), Some(mean)) => {
                    assert!((gaussian - 0.25).abs() < 1e-9 && (mean.abs() - 0.5).abs() < 1e-9);
                    assert!((mesh.normals()[i].dot(&out).abs() - 1.0).abs() < 1e-9);
                }
                _ => {
                    poles += 1;
                    assert!(out[2] > 1.0 - 1e-12 && mesh.normals()[i].dot(&out).abs() > 0.99);
                }
            }
        }
        assert!((16..=24).contains(&poles), "{poles}");
    }

    #[test]
    fn a_periodic_tube_is_closed() {
        let mesh = Mesh::sampled(&tube(), 48, 2, Surface::mean_curvature_at).unwrap();
        assert_eq!((mesh.positions().len(), mesh.faces().count()), (48 * 3, 48 * 2));
        // Inner edges belong to two faces, so that only the two rims are left.
        let sides: usize = mesh.faces().map(<[usize]>::len).sum();
        assert_eq!(2 * mesh.edges().len() - sides, 2 * 48);
        let radius = mesh.positions()[0].xy().norm();
        for (value, p) in mesh.values().iter().zip(mesh.positions()) {
            assert!((value.unwrap().abs() - 0.5 / radius).abs() < 5e-3, "{value:?}");
            assert!((p.xy().norm() - radius).abs() < 1e-3);
        }
    }

    #[test]
    fn creases_stay_sharp() {
        // A roof: the ridge has a knot of multiplicity 1 at degree 1.
        let (across, along) =
            (SplineSpace::clamped(1, [0.0, 1.0, 2.0]).unwrap(), SplineSpace::bezier(1, 0.0, 1.0).unwrap());
        let points = [(0.0, 0.0), (1.0, 1.0), (2.0, 0.0)];
        let coeffs = points.iter().flat_map(|(x, z)| [0.0, 1.0].map(|y| vector![*x, y, *z])).collect();
        let mesh = Mesh::of(&Surface::new(across, along, coeffs).unwrap(), 4, 1).unwrap();
        assert_eq!(mesh.positions().len(), 12);
        let ridge: Vec<_> =
            (0..12).filter(|i| mesh.positions()[*i][0] == 1.0).map(|i| mesh.normals()[i]).collect();
        assert_eq!(ridge.len(), 4);
        assert!(ridge[0].dot(&ridge[3]).abs() < 1e-15);
    }

    #[test]
    fn impossible_steps_are_refused() {
        assert!(matches!(Mesh::of(&tube(), 0, 4), Err(Error::Drawing { .. })));
        assert!(matches!(Mesh::of(&tube(), usize::MAX, 4), Err(Error::TooLarge { .. })));
        assert!(matches!(Mesh::of(&tube(), 1 << 20, 1 << 20), Err(Error::TooLarge { .. })));
    }
}
