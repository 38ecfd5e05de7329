//! The rows as Markdown and as JSON, and the machine they were measured on.

use crate::measure::{Column, Outcome, Row};
use serde_json::{Value, json};
use std::fmt::Write;
use std::process::Command;

const LEGEND: &str = "\
The first column is the least time of symspline, the others are the least time of the candidate divided by it: above 1
symspline is faster. `-`: not offered. `†`: the result is right but has more coefficients than needed. `wrong`: the
error beside it is above the tolerance. `fails`: it panicked or returned an error. `> 4 s`: not run, as a smaller size
foretells. Rows without symspline show times.";

/// The machine, the versions, the legend and the table.
pub fn section(rows: &[Row]) -> String {
    format!("{}.\n{}.\n\n{LEGEND}\n{}", machine(), versions(), markdown(rows))
}

/// The table, group by group. Cells are ratios to symspline's time; a row it has no part in shows times.
fn markdown(rows: &[Row]) -> String {
    let taken = |column: &Column| rows.iter().any(|row| row.cells.iter().any(|(other, _)| other == column));
    let columns: Vec<Column> = Column::ALL.into_iter().filter(taken).collect();
    let mut text = String::new();
    let mut group = "";
    for row in rows {
        if row.group != group {
            group = row.group;
            let names: Vec<_> = columns.iter().map(|column| column.name()).collect();
            let rule: Vec<_> = columns.iter().map(|_| "--:").collect();
            _ = write!(text, "\n| {group} | {} |\n| :-- | {} |\n", names.join(" | "), rule.join(" | "));
        }
        let cells: Vec<_> = columns.iter().map(|column| cell(row, *column)).collect();
        let size = if row.unit == "point" && row.count == 100_000 {
            String::new()
        } else {
            let plural = if row.unit.ends_with("ch") { "es" } else { "s" };
            format!(", {} {}{plural}", row.count, row.unit)
        };
        _ = writeln!(text, "| {}{size} | {} |", row.name, cells.join(" | "));
    }
    text
}

fn outcome(row: &Row, column: Column) -> Option<Outcome> {
    row.cells.iter().find(|(other, _)| *other == column).map(|(_, outcome)| *outcome)
}

fn cell(row: &Row, column: Column) -> String {
    let base = match outcome(row, Column::Symspline) {
        Some(Outcome::Time { least, .. }) => Some(least),
        _ => None,
    };
    match outcome(row, column) {
        None => "-".into(),
        Some(Outcome::Wrong { error }) => format!("wrong ({error:.0e})"),
        Some(Outcome::Fails) => "fails".into(),
        Some(Outcome::Slow) => "> 4 s".into(),
        Some(Outcome::Time { least, larger, .. }) => {
            let mark = if larger { "†" } else { "" };
            match base {
                Some(base) if column != Column::Symspline => format!("{}{mark}", ratio(least / base)),
                _ => format!("{} / {}{mark}", time(least / row.count as f64), row.unit),
            }
        }
    }
}

/// Three digits.
fn ratio(x: f64) -> String {
    match x {
        x if x < 0.0995 => format!("{x:.3}"),
        x if x < 9.995 => format!("{x:.2}"),
        x if x < 99.95 => format!("{x:.1}"),
        x => format!("{x:.0}"),
    }
}

fn time(seconds: f64) -> String {
    match seconds * 1e9 {
        ns if ns < 1e3 => format!("{} ns", ratio(ns)),
        ns if ns < 1e6 => format!("{} µs", ratio(ns / 1e3)),
        ns => format!("{} ms", ratio(ns / 1e6)),
    }
}

/// All figures: seconds a thing.
pub fn json(rows: &[Row]) -> Value {
    let cells = |row: &Row| -> Value {
        let count = row.count as f64;
        let entry = |(column, outcome): &(Column, Outcome)| {
            let value = match outcome {
                Outcome::Time { least, median, error, larger } => json!({
                    "least": least / count, "median": median / count, "error": error, "larger": larger
                }),
                Outcome::Wrong { error } => {
                    json!({ "wrong": if error.is_finite() { json!(error) } else { Value::Null } })
                }
                Outcome::Fails => json!("fails"),
                Outcome::Slow => json!("slow"),
            };
            (column.name().to_string(), value)
        };
        row.cells.iter().map(entry).collect()
    };
    let rows: Vec<Value> = rows
        .iter()
        .map(|row| {
            json!({
                "group": row.group, "name": row.name, "count": row.count, "unit": row.unit,
                "tolerance": row.tolerance, "seconds": cells(row)
            })
        })
        .collect();
    json!({ "machine": machine(), "versions": versions(), "rows": rows })
}

/// The crates with their versions, from the lock file.
fn versions() -> String {
    let locked = include_str!("../Cargo.lock").split("[[package]]");
    let field = |package: &str, name: &str| {
        let line = package.lines().find(|line| line.starts_with(name))?;
        line.split('"').nth(1).map(str::to_string)
    };
    let version = |column: &Column| {
        let name = format!("\"{}\"", column.name());
        let package =
            locked.clone().find(|package| package.lines().any(|line| line == format!("name = {name}")))?;
        Some(format!("{} {}", column.name(), field(package, "version")?))
    };
    Column::ALL.iter().filter_map(version).collect::<Vec<_>>().join(", ")
}

/// Processor, compiler, date.
fn machine() -> String {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = info.lines().find(|line| line.starts_with("model name"));
    let model = model.and_then(|line| line.split(": ").nth(1)).unwrap_or("an unknown processor");
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let run = |program: &str, arguments: &[&str]| {
        let output = Command::new(program).args(arguments).output().ok()?;
        Some(String::from_utf8_lossy(&output.stdout).trim().to_string())
    };
    let rustc = run("rustc", &["--version"]).unwrap_or_else(|| "an unknown compiler".into());
    let date = run("date", &["-u", "+%Y-%m-%d"]).unwrap_or_else(|| "an unknown day".into());
    format!("{model}, {cores} cores; {rustc}; {date}")
}
