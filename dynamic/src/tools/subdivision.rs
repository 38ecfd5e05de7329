//! Subdivision: meshes with their rules, and polygons.

use crate::both;
use crate::error::{Error, Result};
use crate::family::AnySpline;
use crate::number::{Field, Number, flat};
use crate::over::{AnyMesh, Coords, Over};
use crate::tools::shape::all_points;
use nalgebra::SVector;
use std::fmt::Debug;
use std::ops::ControlFlow;
use symspline::{
    Boundary, CatmullClark, ControlMesh, ControlPolygon, CubicPolygon, Curve, DooSabin, MeshSprings,
    Progress, Q, RelaxedMesh,
};

/// A mesh of points and faces.
///
/// # Errors
/// [`Error::Torn`], and those of [`ControlMesh::new`].
pub fn mesh(coords: &Coords, faces: &[Vec<usize>]) -> Result<AnyMesh> {
    Ok(match coords {
        Over::Float(_) => ControlMesh::<f64, 3>::new(all_points::<f64, _>(coords)?, faces)?.into(),
        Over::Exact(_) => ControlMesh::<Q, 3>::new(all_points::<Q, _>(coords)?, faces)?.into(),
    })
}

/// A Catmull-Clark surface; see [`CatmullClark`].
pub type AnyCatmullClark = Over<CatmullClark<f64, 3>, CatmullClark<Q, 3>>;

/// A Doo-Sabin surface; see [`DooSabin`].
pub type AnyDooSabin = Over<DooSabin<f64, 3>, DooSabin<Q, 3>>;

/// One text over both fields, whose result is over the same.
macro_rules! same {
    ($over:expr, $x:ident => $body:expr) => {
        match $over {
            Over::Float($x) => Ok(Over::Float($body)),
            Over::Exact($x) => Ok(Over::Exact($body)),
        }
    };
}

impl AnyCatmullClark {
    /// The surface of a mesh, with a knot interval an edge if they are not all equal.
    ///
    /// # Errors
    /// Those of [`CatmullClark::with_intervals`].
    pub fn new(mesh: &AnyMesh, intervals: Option<&Coords>, boundary: Boundary) -> Result<Self> {
        fn of<T: Field>(
            mesh: &ControlMesh<T, 3>,
            intervals: Option<&Coords>,
            boundary: Boundary,
        ) -> Result<CatmullClark<T, 3>> {
            Ok(match intervals {
                Some(all) => CatmullClark::with_intervals(mesh.clone(), T::all_of(all)?, boundary)?,
                None => CatmullClark::new(mesh.clone(), boundary),
            })
        }
        same!(mesh, m => of(m, intervals, boundary)?)
    }

    /// The control mesh.
    pub fn mesh(&self) -> AnyMesh {
        both!(self, s => s.mesh().clone().into())
    }

    /// The knot interval of each edge, if they are not all equal.
    pub fn intervals(&self) -> Option<Coords> {
        both!(self, s => s.intervals().map(|all| Field::coords(all.to_vec())))
    }

    /// The surface after steps of subdivision.
    ///
    /// # Errors
    /// Those of [`CatmullClark::refined`].
    pub fn refined(&self, depth: usize) -> Result<Self> {
        same!(self, s => s.refined(depth)?)
    }

    /// The points of the surface at the vertices, where there are any.
    ///
    /// # Errors
    /// Those of [`CatmullClark::limit_points`].
    pub fn limit_points(&self) -> Result<Vec<Option<Coords>>> {
        both!(self, T, s => Ok(each_point::<T>(s.limit_points()?)))
    }

    /// The unit normals at the vertices, over floats.
    ///
    /// # Errors
    /// [`Error::Fields`] for an exact surface, and those of [`CatmullClark::limit_normals`].
    pub fn limit_normals(&self) -> Result<Vec<Option<Coords>>> {
        Ok(each_point::<f64>(float(self)?.limit_normals()?))
    }

    /// The surface with all knot intervals at least so long; see [`CatmullClark::with_least_interval`].
    ///
    /// # Errors
    /// Those of [`CatmullClark::with_least_interval`].
    pub fn with_least_interval(&self, least: &Number) -> Result<Self> {
        Ok(match self {
            Over::Float(s) => Over::Float(s.with_least_interval(f64::of(least)?)?),
            Over::Exact(s) => Over::Exact(s.with_least_interval(Q::of(least)?)?),
        })
    }

    /// The mesh with its vertices moved to the surface.
    ///
    /// # Errors
    /// Those of [`CatmullClark::limit_mesh`].
    pub fn limit_mesh(&self) -> Result<AnyMesh> {
        both!(self, s => Ok(s.limit_mesh()?.into()))
    }
}

fn each_point<T: Field>(points: Vec<Option<SVector<T, 3>>>) -> Vec<Option<Coords>> {
    points.into_iter().map(|p| p.map(|p| T::coords(p.iter().cloned().collect()))).collect()
}

fn float<A, B>(over: &Over<A, B>) -> Result<&A> {
    match over {
        Over::Float(inside) => Ok(inside),
        Over::Exact(_) => Err(Error::Fields { left: "float", right: "exact" }),
    }
}

impl AnyDooSabin {
    /// The surface of a mesh, with two knot intervals an edge if they are not all equal.
    ///
    /// # Errors
    /// [`Error::Torn`], and those of [`DooSabin::with_intervals`].
    pub fn new(mesh: &AnyMesh, intervals: Option<&Coords>, boundary: Boundary) -> Result<Self> {
        fn of<T: Field>(
            mesh: &ControlMesh<T, 3>,
            intervals: Option<&Coords>,
            boundary: Boundary,
        ) -> Result<DooSabin<T, 3>> {
            let Some(all) = intervals else { return Ok(DooSabin::new(mesh.clone(), boundary)) };
            let pairs =
                all_points::<T, SVector<T, 2>>(all)?.into_iter().map(|p| [p[0].clone(), p[1].clone()]);
            Ok(DooSabin::with_intervals(mesh.clone(), pairs.collect(), boundary)?)
        }
        same!(mesh, m => of(m, intervals, boundary)?)
    }

    /// The control mesh.
    pub fn mesh(&self) -> AnyMesh {
        both!(self, s => s.mesh().clone().into())
    }

    /// The two knot intervals of each edge, one after the other, if they are not all equal.
    pub fn intervals(&self) -> Option<Coords> {
        both!(self, s => s.intervals().map(|all| Field::coords(all.iter().flatten().cloned().collect())))
    }

    /// The surface after steps of subdivision.
    ///
    /// # Errors
    /// Those of [`DooSabin::refined`].
    pub fn refined(&self, depth: usize) -> Result<Self> {
        same!(self, s => s.refined(depth)?)
    }

    /// The points of the surface that the faces shrink to, one after the other.
    ///
    /// # Errors
    /// Those of [`DooSabin::limit_points`].
    pub fn limit_points(&self) -> Result<Coords> {
        both!(self, T, s => Ok(flat::<T, _>(&s.limit_points()?)))
    }

    /// The unit normals there, over floats.
    ///
    /// # Errors
    /// [`Error::Fields`] for an exact surface, and those of [`DooSabin::limit_normals`].
    pub fn limit_normals(&self) -> Result<Vec<Option<Coords>>> {
        Ok(each_point::<f64>(float(self)?.limit_normals()?))
    }

    /// The mesh of the limit points.
    ///
    /// # Errors
    /// Those of [`DooSabin::limit_mesh`].
    pub fn limit_mesh(&self) -> Result<AnyMesh> {
        both!(self, s => Ok(s.limit_mesh()?.into()))
    }

    /// The surface as a Catmull-Clark surface with knot intervals 0 and 1.
    ///
    /// # Errors
    /// Those of [`DooSabin::converted`].
    pub fn converted(&self) -> Result<AnyCatmullClark> {
        same!(self, s => s.converted()?)
    }

    /// The surface fine-tuned by control values on edges, over floats; see [`DooSabin::fine_tuned`].
    ///
    /// # Errors
    /// [`Error::Fields`] for an exact surface, and those of [`DooSabin::fine_tuned`].
    pub fn fine_tuned(&self, alpha: &[f64], springs: &MeshSprings) -> Result<RelaxedMesh> {
        Ok(float(self)?.fine_tuned(alpha, springs)?)
    }

    /// The same, watched; see [`DooSabin::fine_tuned_watched`].
    ///
    /// # Errors
    /// As [`fine_tuned`](Self::fine_tuned).
    pub fn fine_tuned_watched(
        &self,
        alpha: &[f64],
        springs: &MeshSprings,
        watch: impl FnMut(&Progress) -> ControlFlow<()>,
    ) -> Result<RelaxedMesh> {
        Ok(float(self)?.fine_tuned_watched(alpha, springs, watch)?)
    }
}

/// A polygon that controls a quadratic or a cubic curve; see [`ControlPolygon`] and [`CubicPolygon`].
pub trait Polygon: Debug + Send + Sync {
    /// The degree of the curve.
    fn degree(&self) -> usize;
    /// How many coordinates points have.
    fn dim(&self) -> usize;
    /// The vertices.
    fn points(&self) -> Coords;
    /// The knot intervals.
    fn intervals(&self) -> Coords;
    /// Whether it is closed.
    fn is_closed(&self) -> bool;
    /// The polygon after steps of subdivision.
    ///
    /// # Errors
    /// Those of [`ControlPolygon::chaikin`].
    fn refined(&self, depth: usize) -> Result<Box<dyn Polygon>>;
    /// The points where segments of the curve meet.
    fn joints(&self) -> Coords;
    /// The curve.
    ///
    /// # Errors
    /// Those of [`ControlPolygon::curve`].
    fn curve(&self) -> Result<AnySpline>;
    /// The polygon of degree 3 of the same curve.
    ///
    /// # Errors
    /// Those of [`ControlPolygon::converted`].
    fn converted(&self) -> Result<Box<dyn Polygon>>;
}

macro_rules! polygon {
    ($polygon:ident, $degree:expr, $refine:ident, $joints:ident, $s:ident => $converted:expr) => {
        impl<T: Field, const N: usize> Polygon for $polygon<T, N>
        where
            AnySpline: From<Curve<T, N>>,
            SVector<T, N>: Send + Sync,
        {
            fn degree(&self) -> usize {
                $degree
            }

            fn dim(&self) -> usize {
                N
            }

            fn points(&self) -> Coords {
                flat::<T, _>(Self::points(self))
            }

            fn intervals(&self) -> Coords {
                T::coords(Self::intervals(self).to_vec())
            }

            fn is_closed(&self) -> bool {
                Self::is_closed(self)
            }

            fn refined(&self, depth: usize) -> Result<Box<dyn Polygon>> {
                Ok(Box::new(self.$refine(depth)?))
            }

            fn joints(&self) -> Coords {
                flat::<T, _>(&self.$joints())
            }

            fn curve(&self) -> Result<AnySpline> {
                Ok(Self::curve(self)?.into())
            }

            fn converted(&self) -> Result<Box<dyn Polygon>> {
                let $s = self;
                Ok(Box::new($converted))
            }
        }
    };
}

polygon!(ControlPolygon, 2, chaikin, joints, s => Self::converted(s)?);
polygon!(CubicPolygon, 3, refined, limit_points, s => s.clone());

/// A polygon that controls a curve of degree 2 or 3; `boundary` is nothing for a closed one.
///
/// # Errors
/// [`Error::Dimension`], [`Error::Torn`], and those of [`ControlPolygon::closed`], [`ControlPolygon::open`] and
/// [`ControlPolygon::with_intervals`]; [`Error::NoSuch`] for another degree.
pub fn polygon(
    degree: usize,
    dim: usize,
    coords: &Coords,
    intervals: Option<&Coords>,
    boundary: Option<Boundary>,
) -> Result<Box<dyn Polygon>> {
    fn of<T: Field, const N: usize>(
        degree: usize,
        coords: &Coords,
        intervals: Option<&Coords>,
        boundary: Option<Boundary>,
    ) -> Result<Box<dyn Polygon>>
    where
        AnySpline: From<Curve<T, N>>,
        SVector<T, N>: Send + Sync + crate::number::Flat<T>,
    {
        let points: Vec<SVector<T, N>> = all_points(coords)?;
        macro_rules! of {
            ($kind:ident) => {{
                let found = match boundary {
                    Some(boundary) => $kind::open(points, boundary)?,
                    None => $kind::closed(points)?,
                };
                Ok(match intervals {
                    Some(all) => Box::new(found.with_intervals(T::all_of(all)?)?) as Box<dyn Polygon>,
                    None => Box::new(found),
                })
            }};
        }
        match degree {
            2 => of!(ControlPolygon),
            3 => of!(CubicPolygon),
            _ => Err(Error::NoSuch {
                operation: "control polygon",
                left: format!("a curve of degree {degree}: degrees 2 and 3 are possible"),
                right: String::new(),
            }),
        }
    }
    match (coords, dim) {
        (Over::Float(_), 2) => of::<f64, 2>(degree, coords, intervals, boundary),
        (Over::Float(_), 3) => of::<f64, 3>(degree, coords, intervals, boundary),
        (Over::Exact(_), 2) => of::<Q, 2>(degree, coords, intervals, boundary),
        (Over::Exact(_), 3) => of::<Q, 3>(degree, coords, intervals, boundary),
        (_, found) => Err(Error::Dimension { found, least: 2 }),
    }
}
