//! `completions`: what shells need to complete commands.

use crate::failure::Result;
use crate::output;
use clap::Args;
use clap_complete::{Shell, generate};

/// Write a script that completes commands in a shell
#[derive(Args, Debug)]
#[command(
    after_help = "Example: symspline completions bash > ~/.local/share/bash-completion/completions/symspline"
)]
pub struct Completions {
    /// The shell
    shell: Shell,
}

impl Completions {
    /// Runs the command.
    pub fn run(&self, command: &mut clap::Command) -> Result<()> {
        let mut script = Vec::new();
        generate(self.shell, command, "symspline", &mut script);
        output::bytes_out(&script)
    }
}
