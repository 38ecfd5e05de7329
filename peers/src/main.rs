//! Times of symspline beside other spline crates and beside hand-written lower bounds, as one table.
//!
//! ```text
//! peers [--quick] [--only TEXT] [--json FILE] [--write FILE]
//! ```

mod bounds;
mod candidates;
mod data;
mod measure;
mod peers;
mod rows;
mod table;

use measure::Session;
use std::error::Error;
use std::fs;
use std::process::Command;
use std::time::Duration;

const USAGE: &str = "usage: peers [--quick] [--only TEXT] [--json FILE] [--write FILE]
  --quick        small sizes and few rounds: a look at the table, no figures to keep
  --only TEXT    the groups whose name contains the text
  --json FILE    write all figures
  --write FILE   replace what stands between the two marks of a Markdown file";

const MARKS: [&str; 2] = ["<!-- peers: begin -->", "<!-- peers: end -->"];

#[derive(Default)]
struct Arguments {
    quick: bool,
    only: Option<String>,
    json: Option<String>,
    write: Option<String>,
}

fn arguments() -> Result<Arguments, String> {
    let mut found = Arguments::default();
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let mut value = || words.next().ok_or_else(|| format!("{word} needs a value\n{USAGE}"));
        match word.as_str() {
            "--quick" => found.quick = true,
            "--only" => found.only = Some(value()?),
            "--json" => found.json = Some(value()?),
            "--write" => found.write = Some(value()?),
            _ => return Err(USAGE.into()),
        }
    }
    Ok(found)
}

/// Errors of some crates take a backtrace each if the environment asks for it, which costs more than what is measured:
/// then the program starts itself anew without.
fn without_backtraces() -> Result<(), Box<dyn Error>> {
    let asked = |name: &str| std::env::var_os(name).is_some_and(|value| value != "0");
    if asked("RUST_BACKTRACE") || asked("RUST_LIB_BACKTRACE") {
        let mut command = Command::new(std::env::current_exe()?);
        command.args(std::env::args_os().skip(1)).env("RUST_BACKTRACE", "0").env("RUST_LIB_BACKTRACE", "0");
        std::process::exit(command.status()?.code().unwrap_or(1));
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = arguments()?;
    without_backtraces()?;
    let text = arguments.write.as_ref().map(fs::read_to_string).transpose()?;
    if text.as_ref().is_some_and(|text| between(text).is_none()) {
        return Err(format!("no marks {} and {}", MARKS[0], MARKS[1]).into());
    }

    let budget = Duration::from_millis(if arguments.quick { 100 } else { 2400 });
    let mut session = Session { rows: Vec::new(), budget };
    let sizes: &[usize] = if arguments.quick { &[100] } else { &[100, 1000, 10_000] };
    let wanted = |group: &str| arguments.only.as_ref().is_none_or(|text| group.contains(text.as_str()));
    if wanted("Curve") {
        rows::curves::rows(&mut session);
    }
    if wanted("Surface") {
        rows::surfaces::rows(&mut session);
    }
    if wanted("Operators") {
        rows::operators::rows(&mut session, sizes);
    }
    if wanted("Products") {
        rows::products::rows(&mut session, sizes);
    }

    let section = table::section(&session.rows);
    println!("{section}");
    if let Some(path) = arguments.json {
        fs::write(path, serde_json::to_string_pretty(&table::json(&session.rows))?)?;
    }
    if let (Some(path), Some(text)) = (arguments.write, text) {
        let (before, after) = between(&text).expect("the marks were found above");
        fs::write(path, format!("{before}\n{section}\n{after}"))?;
    }
    Ok(())
}

/// The text up to the first mark and from the second one on.
fn between(text: &str) -> Option<(&str, &str)> {
    let begin = text.find(MARKS[0])? + MARKS[0].len();
    let end = text.find(MARKS[1]).filter(|end| *end >= begin)?;
    Some((&text[..begin], &text[end..]))
}
