//! Exact spline algebra and fine tuning of curves and surfaces on the command line.
//!
//! A thin layer over the library: commands read files, call it, and write what it gives. Data goes to standard output, and everything
//! else to standard error.
#![allow(clippy::clone_on_copy, reason = "one text for both fields; the numbers of one are copied")]

// From the ground up: a module uses only what stands above it.
mod numbers;
mod measure;
mod calc;
mod failure;
mod input;
mod output;
mod progress;
mod commands;
mod cli;

use clap::Parser;
use failure::Failure;
use std::process::ExitCode;

fn main() -> ExitCode {
    match cli::Cli::parse().command.run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            if !matches!(failure, Failure::Closed) {
                output::note(format_args!("symspline: {failure}"));
            }
            if let Failure::Expression(complaint) = &failure {
                output::note(complaint.marked());
            }
            ExitCode::from(failure.code())
        }
    }
}
