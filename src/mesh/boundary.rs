//! What becomes of a boundary.

/// What becomes of the boundary of a mesh when it is subdivided.
///
/// # Examples
/// ```
/// use symspline::Boundary;
/// assert_eq!(Boundary::default(), Boundary::Smooth);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Boundary {
    /// The surface ends where the rules for inner points end, well inside the boundary: of a grid this is the surface over an
    /// unclamped spline space.
    Open,
    /// The boundary of the surface is the B-spline curve that the boundary of the mesh controls, quadratic or cubic.
    #[default]
    Smooth,
    /// As [`Boundary::Smooth`], but vertices in one face alone stay: the boundary has corners there.
    Corners,
}
