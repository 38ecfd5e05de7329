//! `sculpt`: curves and surfaces as elastic bodies.

use crate::commands::shapes::{Argued, Tool, apply};
use crate::failure::Result;
use crate::input::Input;
use crate::numbers::{List, One, Place};
use crate::output::{self, Output};
use clap::{Args, ValueEnum};
use symspline::{Elastic, Material, Reach, Spread};
use symspline_dynamic::Field;

/// Pull a point of a deformable curve or surface
#[derive(Args, Debug)]
#[command(after_help = "\
The ends stay, unless the shape is closed. The force that acts is told on standard error.

Examples:
  symspline sculpt --at 1/2 --target 3,2 curve.json
  symspline sculpt --at 0.5:0.5 --force 0,0,1 --stretching 1 --bending 10 --reach 8 surface.json")]
pub struct Sculpt {
    #[command(flatten)]
    input: Input,
    #[command(flatten)]
    grip: Grip,
    #[command(flatten)]
    output: Output,
}

/// What is pulled, and how.
#[derive(Args, Debug)]
struct Grip {
    /// The point: `u`, or `u:v` of a surface
    #[arg(long, allow_hyphen_values = true)]
    at: Place,
    /// Where it goes
    #[arg(
        long,
        value_name = "POINT",
        allow_hyphen_values = true,
        required_unless_present = "force",
        conflicts_with = "force"
    )]
    target: Option<List>,
    /// The force that acts
    #[arg(long, value_name = "VECTOR", allow_hyphen_values = true)]
    force: Option<List>,
    /// How much the material resists stretching
    #[arg(long, default_value = "1")]
    stretching: One,
    /// How much it resists bending
    #[arg(long, default_value = "1")]
    bending: One,
    /// How hard it is: deformations become narrow
    #[arg(long, default_value = "0")]
    hardness: One,
    /// So many control points move, those nearest to the point, along each direction
    #[arg(long, value_name = "N")]
    reach: Option<usize>,
    /// Nothing moves farther away than this, a distance of parameters
    #[arg(long, value_name = "DISTANCE", conflicts_with = "reach")]
    within: Option<One>,
    /// How the force is spread about the point
    #[arg(long, value_enum, default_value_t = About::Hat)]
    spread: About,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum About {
    /// By hat functions of the knots
    Hat,
    /// By the basis functions: the least energy
    Point,
}

impl Sculpt {
    /// Runs the command.
    pub fn run(&self) -> Result<()> {
        self.output.write(&self.input.changed(|value| apply(&self.grip, value))?)
    }
}

impl Tool for Grip {
    fn applied<T: Field, const N: usize, S: Argued<T, N>>(&self, shape: &S) -> Result<S> {
        let at = S::parameter(&self.at)?;
        let material = Material::new(self.stretching.of()?, self.bending.of()?)?;
        let material = material.with_hardness(self.hardness.of::<T>()?)?;
        let reach = match (&self.within, self.reach) {
            (Some(distance), _) => Reach::Within(distance.of::<T>()?),
            (_, Some(count)) => Reach::Nearest(count),
            _ => Reach::All,
        };
        let breadth = |direction| reach.breadth(shape.space_along(direction), S::coordinate(&at, direction));
        let breadths = S::DIRECTIONS.iter().map(|d| breadth(*d)).collect::<symspline::Result<Vec<_>>>()?;
        let spread = match self.spread {
            About::Hat => Spread::Hat,
            About::Point => Spread::Point,
        };
        let elastic = Elastic::of(shape, &material, &breadths)?.with_spread(spread);
        let (pull, mut sculpted) = (elastic.pull(shape, &at)?, shape.clone());
        let force = match (&self.target, &self.force) {
            (Some(target), _) => pull.move_to(&mut sculpted, &S::vector(target)?)?,
            (_, force) => {
                let force = S::vector(force.as_ref().unwrap_or(&List(Vec::new())))?;
                pull.push(&mut sculpted, &force)?;
                force
            }
        };
        let force: Vec<String> = force.iter().map(ToString::to_string).collect();
        output::note(format_args!("force: ({})", force.join(", ")));
        Ok(sculpted)
    }
}
