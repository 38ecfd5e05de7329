//! The commands and their arguments, as clap sees them.

use crate::commands::{calc, completions, convert, eval, info, profile, sculpt, shape, subdivide, tune};
use crate::failure::Result;
use clap::{CommandFactory, Parser, Subcommand};
use symspline_files::Format;

/// Exact spline algebra and fine tuning of curves and surfaces.
#[derive(Debug, Parser)]
#[command(name = "symspline", version, about, after_help = after_help(), max_term_width = 100)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    Info(info::Info),
    Eval(eval::Eval),
    Calc(calc::Calc),
    Profile(profile::Profile),
    Tune(tune::Tune),
    #[command(subcommand)]
    Shape(shape::Shape),
    Sculpt(sculpt::Sculpt),
    Subdivide(subdivide::Subdivide),
    Convert(convert::Convert),
    Completions(completions::Completions),
}

impl Command {
    /// Runs the command.
    pub fn run(&self) -> Result<()> {
        match self {
            Self::Info(command) => command.run(),
            Self::Eval(command) => command.run(),
            Self::Calc(command) => command.run(),
            Self::Profile(command) => command.run(),
            Self::Tune(command) => command.run(),
            Self::Shape(command) => command.run(),
            Self::Sculpt(command) => command.run(),
            Self::Subdivide(command) => command.run(),
            Self::Convert(command) => command.run(),
            Self::Completions(command) => command.run(&mut Cli::command()),
        }
    }
}

/// The formats, and what exit codes mean.
fn after_help() -> String {
    let names = |chosen: fn(Format) -> bool| {
        let chosen: Vec<String> = Format::all()
            .filter(|format| chosen(*format))
            .map(|format| format!("{} ({})", format.name(), format.endings().join(", ")))
            .collect();
        chosen.join(", ")
    };
    format!(
        "Formats that are read: {}.\nFormats that are written: {}.\n\n\
         Numbers are read exactly: 1/3, 0.1, 1e-3. Numbers of entries and of control points count from 0.\n\
         Exit codes: 0 done, 1 the library refused, 2 usage, 3 input or output, 4 contents of a file or grammar.",
        names(Format::is_read),
        names(Format::is_written)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_arguments_fit_together() {
        Cli::command().debug_assert();
    }
}
