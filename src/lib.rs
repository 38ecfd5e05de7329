//! Exact algebra of spline curves and surfaces, polynomial and rational, fine tuning of both, shape tools, and
//! deformable splines.
//!
//! A [`SplineSpace`] is a value: a degree, knots, and how the ends meet. A [`Spline`] is a list of coefficients in a
//! space: numbers ([`Function`]) or points ([`Curve`]). Operators are maps between spaces, kept as rows of weights
//! ([`LinearMap`], [`BilinearMap`]), and run over any ordered field ([`Scalar`]): over `f64`, and exactly over the rationals
//! [`Q`]. A surface ([`TensorSpline`]) is a spline of rows, a rational spline ([`Rational`]) one of weighted points: they ride
//! through the same operators.
//!
//! # Examples
//! The integral of a product, by two routes, exactly:
//! ```
//! use symspline::{Function, Q, Scalar, SplineSpace};
//! let hat = Function::new(SplineSpace::clamped(1, [0, 1, 3].map(Q::int))?, [0, 1, 0].map(Q::int).to_vec())?;
//! let wave = Function::new(SplineSpace::clamped(2, [0, 2, 3].map(Q::int))?, [0, 3, -1, 2].map(Q::int).to_vec())?;
//! let product = (&hat * &wave).integral()?;
//! let by_gram = hat.space().gram(wave.space(), 0, 0)?.apply(wave.coeffs())?;
//! assert_eq!(product, Q::dot(hat.coeffs().iter().zip(&by_gram)));
//! # Ok::<(), symspline::Error>(())
//! ```
//!
//! # Where things are
//! - spaces: [`SplineSpace`], with its methods for finer, united and product spaces and for basis functions;
//! - operators: methods of [`Spline`], explained file by file in [`ops`];
//! - surfaces: [`tensor`]; rational curves and surfaces: [`rational`];
//! - splines from data, skins, and conics: [`build`];
//! - roots of polynomials: [`roots`];
//! - zeros, curvature profiles, lengths, frames, nearest points, meetings: [`analysis`];
//! - fine tuning: [`fine_tune`];
//! - shape tools: control points, weights, warps, bends, constraints: [`shape`];
//! - deformable splines: materials, forces, constraints at least energy: [`deform`];
//! - subdivision curves and surfaces: [`mesh`]; OBJ files of meshes: [`io::obj`];
//! - pictures: the module `plot`, behind the feature of that name; of it surfaces as faces and glTF behind the feature `solid`.

// The modules from the ground up: a module uses only what stands above it (tests/floors.rs).
pub mod error;
pub mod limits;
pub mod scalar;
pub mod exact;
pub mod coeff;
pub mod row;
mod array;
pub mod weighted;
pub mod vector;
mod linalg;
pub mod dense;
pub mod functional;
mod gather;
pub mod map;
pub mod bilinear;
pub mod knots;
mod polar;
mod window;
mod bernstein;
pub mod roots;
pub mod space;
mod locate;
mod parts;
mod derived;
mod basis;
pub mod spline;
mod eval;
pub mod ops;
pub mod tensor;
pub mod rational;
pub mod prepared;
pub mod build;
pub mod analysis;
pub mod mesh;
pub mod constrain;
pub mod fine_tune;
pub mod shape;
pub mod deform;
pub mod io;
#[cfg(feature = "solid")]
pub mod plot;

pub use analysis::analyse::Analyse;
pub use analysis::certify::Certified;
pub use analysis::crossings::Crossings;
pub use analysis::curvature::Curved;
pub use analysis::events::{Bounds, Event, EventKind};
pub use analysis::frames::Frame;
pub use analysis::length::ArcLength;
pub use analysis::measure::Sample;
pub use analysis::meet::arc::PlaneCurve;
pub use analysis::meet::report::{
    Certainty, Intersections, LineMeeting, LineMeetings, LineOverlap, Meeting, Overlap, Passage,
};
pub use analysis::nearest::foot::{Foot, Nearest};
pub use analysis::nearest::projector::Projector;
pub use analysis::profile::{CurvatureProfile, Run};
pub use analysis::surface_curvature::{PrincipalCurvatures, PrincipalDirection};
pub use analysis::turning::Turning;
pub use analysis::zeros::{Place, Zero};
pub use bilinear::{BilinearMap, BilinearRow};
pub use build::conics::{arc, arc_by_angles, circle, conic, ellipse, segment};
pub use build::fit::Ends;
pub use build::parameters::{approximation_space, chord_length, interpolation_space};
pub use build::skin::Skin;
pub use coeff::Coeff;
pub use constrain::change::LeastChange;
pub use constrain::least::Excess;
pub use constrain::norm::{CoeffSpace, Norm, SpacePair};
pub use constrain::sparse::SparseRow;
pub use deform::anchors::Anchored;
pub use deform::area::Area;
pub use deform::breadth::Breadth;
pub use deform::elastic::{Elastic, Spread};
pub use deform::forces::Forces;
pub use deform::forces_over::Cells;
pub use deform::full_energy::FullEnergy;
pub use deform::material::Material;
pub use deform::pull::Pull;
pub use deform::reach::Reach;
pub use deform::relax::Relaxation;
pub use deform::restorable::Restorable;
pub use deform::sculptor::Sculptor;
pub use deform::stiffness::Stiffness;
pub use dense::solve_dense;
pub use error::deform::DeformError;
pub use error::mesh::MeshError;
pub use error::obj::ObjError;
pub use error::shape::ShapeError;
pub use error::skin::SkinError;
pub use error::tune::TuneError;
pub use error::{Error, Result};
pub use exact::Q;
pub use fine_tune::closed::Relaxed;
pub use fine_tune::condition::Condition;
pub use fine_tune::hold::{Held, Hold};
pub use fine_tune::joint::{Jointed, Turn};
pub use fine_tune::local::LocallyTuned;
pub use fine_tune::mesh::loops::EdgeLoops;
pub use fine_tune::mesh::springs::{Descend, MeshSprings};
pub use fine_tune::mesh::tuned::{Progress, RelaxedMesh};
pub use fine_tune::nearest_scale::NearestScale;
pub use fine_tune::scale::{Scale, ScaleFunction};
pub use fine_tune::scale_space::ScaleSpace;
pub use fine_tune::springs::Springs;
pub use fine_tune::surface::condition::SurfaceCondition;
pub use fine_tune::surface::edges::{Edge, Edges, Fit};
pub use fine_tune::surface::gap::PathGap;
pub use fine_tune::surface::held::HeldSurface;
pub use fine_tune::surface::local::LocallyTunedSurface;
pub use fine_tune::surface::path::Path;
pub use fine_tune::surface::tuner::SurfaceTuner;
pub use fine_tune::tuner::FineTuner;
pub use fine_tune::turn::Turnable;
pub use functional::Functional;
pub use knots::KnotVector;
pub use map::LinearMap;
pub use mesh::boundary::Boundary;
pub use mesh::catmull_clark::CatmullClark;
pub use mesh::control_mesh::ControlMesh;
pub use mesh::control_polygon::ControlPolygon;
pub use mesh::cubic_polygon::CubicPolygon;
pub use mesh::doo_sabin::DooSabin;
pub use mesh::topology::Topology;
pub use ops::bound::Approximation;
pub use ops::dual::DualFunctional;
pub use ops::enclose::{Enclosure, Extremum};
pub use ops::power::PowerForm;
pub use ops::project::Contact;
pub use ops::reduce::Continuity;
pub use ops::remove::Dropped;
pub use ops::trial::Keep;
pub use prepared::curve::Evaluator;
pub use prepared::evaluate::Evaluate;
pub use prepared::rational::RationalEvaluator;
pub use prepared::surface::SurfaceEvaluator;
pub use rational::domain::{Domain, Interval, Rectangle};
pub use rational::spline::{NurbsCurve, NurbsSurface, Rational, RationalFunction};
pub use roots::Solvable;
pub use row::Row;
pub use scalar::{Real, Scalar};
pub use shape::assignment::Assigned;
pub use shape::bend::Bend;
pub use shape::bend_about::{Bendable, ByShare, Flat, Round, Sphere};
pub use shape::bend_centre::{Axis, BendCentre, OffsetAxis};
pub use shape::bend_ratio::{CrossRatio, bent_point};
pub use shape::bump::Bump;
pub use shape::confine::confined;
pub use shape::constraints::{Constrained, Constraints};
pub use shape::controlled::Controlled;
pub use shape::coupled::{Coupled, CoupledDrag, with_tangent};
pub use shape::cross_ratio::cross_ratio;
pub use shape::curvature_handle::CurvatureHandle;
pub use shape::drag::Drag;
pub use shape::flatten::{Flatten, Flattened};
pub use shape::flatten_region::Part;
pub use shape::gravity::{CurveGravity, Gravity, GravityPull};
pub use shape::halfway::{Halfway, Regime};
pub use shape::legs::LegPoint;
pub use shape::normals::UnitNormal;
pub use shape::onto::{Onto, Side};
pub use shape::polygon::Polygons;
pub use shape::region::Refinement;
pub use shape::relief::Relief;
pub use shape::reshape::{Region, Reshaped, Window};
pub use shape::rotation::Rotation;
pub use shape::warp::Warp;
pub use shape::weigh::Weighed;
pub use shape::weight_pair_pull::WeightPairPull;
pub use shape::weight_pull::WeightPull;
pub use shape::weight_range::WeightRange;
pub use shape::workable::Workable;
pub use space::SplineSpace;
pub use spline::{Curve, Function, Spline};
pub use tensor::along::Direction;
pub use tensor::form::QuadraticForm;
pub use tensor::spline::{Surface, TensorSpline};
pub use vector::Crossed;
pub use weighted::Weighted;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
