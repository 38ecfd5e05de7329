//! The laws of the library: what holds for every spline, over exact rationals and with `==`.
//!
//! One file an operator; `strategies` makes the splines, `oracle` the answers from the definitions. Laws of `f64` are
//! in `rounding` and `uneven`, with their bounds; `hostile` holds what must be refused. Those of surfaces are in `surface`.
//!
//! A case that fails is kept by proptest in `tests/proptest-regressions` and run first from then on.

mod strategies;
mod rational_strategies;
mod oracle;

mod basis;
mod evaluators;
mod evaluators_floats;
mod polar;
mod spaces;
mod containment;
mod maps;
mod insertion;
mod elevation;
mod arithmetic;
mod derivative;
mod integral;
mod product;
mod inner;
mod bound;
mod project;
mod degree_reduction;
mod removal;
mod restrict;
mod join;
mod reverse;
mod reparam;
mod seam;
mod roots;
mod zeros;
mod composition;
mod on_surface;
mod range;
mod dual;
mod fit;
mod osculate;
mod skin;
mod least_squares;
mod curvature;
mod profile;
mod length;
mod frames;
mod tuned_surface;
mod tuned_surface_held;
mod turning;
mod surface_curvature;
mod surface_scale;
mod nearest;
mod nearest_surfaces;
mod nearest_hostile;
mod meet;
mod meet_line;
mod least_change;
mod fine_tune;
mod hold;
mod local;
mod repeated;
mod segmented;
mod nearest_scale;
mod closed;
mod surface;
mod rational;
mod rational_arithmetic;
mod rational_range;
mod rational_polynomial;
mod rational_surface;
mod moebius;
mod poles;
mod conics;
mod rational_rounding;
mod rounding;
mod approximation;
mod approximation_lifted;
mod uneven;
mod hostile;
