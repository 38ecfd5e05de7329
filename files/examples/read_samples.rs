//! Prints what a file of any format holds, as JSON: `cargo run -p symspline-files --example read_samples FILE`.

use std::io::Write as _;
use std::path::Path;
use symspline_files::{Format, read, to_bytes};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let name = std::env::args().nth(1).ok_or("a file is wanted")?;
    let entries = read(Path::new(&name))?;
    std::io::stdout().write_all(&to_bytes(&entries, Format::Json)?)?;
    Ok(())
}
