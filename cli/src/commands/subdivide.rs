//! `subdivide`: meshes refined by subdivision.

use crate::failure::{Failure, Result};
use crate::input::Input;
use crate::output::Output;
use crate::progress;
use clap::{Args, ValueEnum};
use symspline::{Boundary, CatmullClark, ControlMesh, DooSabin};
use symspline_dynamic::{AnyMesh, Field, Value, both};

/// Refine a mesh by subdivision
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  symspline subdivide cube.obj --depth 3 -o ball.obj
  symspline subdivide --exact --scheme doo-sabin --limit cube.obj")]
pub struct Subdivide {
    #[command(flatten)]
    input: Input,
    /// The rules
    #[arg(long, value_enum, default_value_t = Scheme::CatmullClark)]
    scheme: Scheme,
    /// The number of steps
    #[arg(long, default_value_t = 1)]
    depth: usize,
    /// What becomes of the boundary
    #[arg(long, value_enum, default_value_t = Edge::Smooth)]
    boundary: Edge,
    /// In the end the points of the surface itself
    #[arg(long)]
    limit: bool,
    #[command(flatten)]
    output: Output,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Scheme {
    CatmullClark,
    DooSabin,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Edge {
    /// The surface ends inside the boundary
    Open,
    /// It ends in the spline curve of the boundary
    Smooth,
    /// It does, with corners where one face alone meets a vertex
    Corners,
}

/// With more steps than this a mesh of one triangle is beyond what memory holds.
const MOST_SHOWN: usize = 14;

impl Subdivide {
    /// Runs the command.
    pub fn run(&self) -> Result<()> {
        let refined = self.input.changed(|value| match value {
            Value::Mesh(mesh) => Ok(both!(mesh, mesh => AnyMesh::from(self.refined(mesh.clone())?)).into()),
            other => Err(Failure::refused(format!("a mesh is expected, not a {}", other.kind()))),
        });
        self.output.write(&refined?)
    }

    fn refined<T: Field>(&self, mesh: ControlMesh<T, 3>) -> symspline::Result<ControlMesh<T, 3>> {
        let boundary = match self.boundary {
            Edge::Open => Boundary::Open,
            Edge::Smooth => Boundary::Smooth,
            Edge::Corners => Boundary::Corners,
        };
        /// One text for both schemes.
        macro_rules! refined {
            ($surface:expr) => {{
                let surface = $surface;
                let bar = progress::bar(self.depth, "subdividing");
                // Asked for at once where nobody sees the steps; too many steps are then refused before the first is made.
                let surface = match bar.is_hidden() || self.depth > MOST_SHOWN {
                    true => surface.refined(self.depth)?,
                    false => (0..self.depth).try_fold(surface, |surface, _| {
                        bar.inc(1);
                        surface.refined(1)
                    })?,
                };
                bar.finish_and_clear();
                if self.limit { surface.limit_mesh() } else { Ok(surface.mesh().clone()) }
            }};
        }
        match self.scheme {
            Scheme::CatmullClark => refined!(CatmullClark::new(mesh, boundary)),
            Scheme::DooSabin => refined!(DooSabin::new(mesh, boundary)),
        }
    }
}
