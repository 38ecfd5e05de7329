//! `info`: what a file holds.

use crate::failure::Result;
use crate::input::{Input, visible};
use crate::{measure, output};
use clap::Args;
use serde_json::{Map, Value as Json, json};
use symspline_dynamic::{AnySpace, Value, both};
use symspline_files::Entry;

/// Tell what a file holds: kinds, degrees, knots, boxes, lengths
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  symspline info curves.json
  symspline info --name C --json curves.json")]
pub struct Info {
    #[command(flatten)]
    input: Input,
    /// Write JSON
    #[arg(long)]
    json: bool,
}

impl Info {
    /// Runs the command.
    pub fn run(&self) -> Result<()> {
        let entries = self.input.entries()?;
        let told: Vec<Json> = entries.iter().map(|(i, entry)| facts(*i, entry)).collect();
        if self.json {
            return output::json(&Json::Array(told));
        }
        output::text(&told.iter().map(lines).collect::<Vec<_>>().join("\n"))
    }
}

/// What there is to tell of an entry.
fn facts(index: usize, entry: &Entry) -> Json {
    let value = &entry.value;
    let mut facts = Map::new();
    let mut tell = |name: &str, fact: Json| drop(facts.insert(name.to_owned(), fact));
    tell("item", json!(index));
    if let Some(name) = &entry.name {
        tell("name", json!(name));
    }
    tell("kind", json!(value.kind()));
    tell("field", json!(value.field()));
    tell("dimension", json!(value.dim()));
    let spaces = match value {
        Value::Spline(s) => s.spaces(),
        Value::Surface(s) => s.spaces(),
        Value::Rational(s) => s.spaces(),
        Value::RationalSurface(s) => s.spaces(),
        _ => Vec::new(),
    };
    match value {
        Value::Number(x) => tell("value", json!(x.to_string())),
        Value::Point(p) => {
            tell("value", both!(p, p => p.iter().map(|x| json!(x.to_string())).collect()));
        }
        Value::Mesh(mesh) => {
            let t = both!(mesh, mesh => mesh.topology());
            tell("vertices", json!(t.vertex_count()));
            tell("edges", json!(t.edge_count()));
            tell("faces", json!(t.face_count()));
            tell("closed", json!(t.is_closed()));
        }
        _ => tell("parameters", spaces.iter().map(space).collect()),
    }
    // What is not found, such as the length of a curve that goes to infinity, keeps nothing else from being told.
    match measure::bounding_box(value).transpose() {
        Some(Ok(ranges)) => tell("box", json!(ranges)),
        Some(Err(error)) => tell("box_problem", json!(error.to_string())),
        None => {}
    }
    match measure::length(value) {
        Some(Ok(length)) => {
            tell("length", json!(length.total));
            tell("length_error", json!(length.bound));
        }
        Some(Err(error)) => tell("length_problem", json!(error.to_string())),
        None => {}
    }
    facts.into()
}

/// What there is to tell of a space.
fn space(space: &AnySpace) -> Json {
    both!(space, s => {
        let (start, end) = s.domain();
        let knots: Json = s.breaks().iter().map(|(t, copies)| json!([t.to_string(), copies])).collect();
        json!({
            "degree": s.degree(),
            "coefficients": s.dim(),
            "domain": [start.to_string(), end.to_string()],
            "periodic": s.is_periodic(),
            "clamped": s.is_clamped(),
            "knots": knots,
        })
    })
}

/// The same for people.
fn lines(facts: &Json) -> String {
    let text = |name: &str| match &facts[name] {
        Json::String(text) => text.clone(),
        other => other.to_string(),
    };
    let name = facts.get("name").map(|_| format!(" ({})", visible(&text("name")))).unwrap_or_default();
    let mut lines = format!("item {}{name}: {} {}", facts["item"], text("field"), text("kind"));
    let dimension = facts["dimension"].as_u64().unwrap_or(1);
    if dimension > 1 {
        lines += &format!(" in {dimension} dimensions");
    }
    lines += "\n";
    if facts.get("value").is_some() {
        lines += &format!("  value: {}\n", text("value").replace('"', ""));
    }
    if facts.get("vertices").is_some() {
        let closed = if facts["closed"] == true { "closed" } else { "with a boundary" };
        lines += &format!(
            "  {} vertices, {} edges, {} faces, {closed}\n",
            facts["vertices"], facts["edges"], facts["faces"]
        );
    }
    for (space, direction) in facts["parameters"].as_array().into_iter().flatten().zip(["u", "v"]) {
        lines += &space_lines(space, direction);
    }
    if let Some(ranges) = facts.get("box").and_then(Json::as_array) {
        let range = |range: &Json| format!("[{}, {}]", range[0], range[1]);
        lines += &format!("  box: {}\n", ranges.iter().map(range).collect::<Vec<_>>().join(" x "));
    }
    if facts.get("length").is_some() {
        let error = facts["length_error"].as_f64().unwrap_or(0.0);
        lines += &format!("  length: {} (within {error:.1e})\n", facts["length"]);
    }
    for name in ["box", "length"] {
        if let Some(problem) = facts[format!("{name}_problem")].as_str() {
            lines += &format!("  {name}: not found: {problem}\n");
        }
    }
    lines
}

fn space_lines(space: &Json, direction: &str) -> String {
    let text = |json: &Json| json.as_str().unwrap_or_default().to_owned();
    let ends = [("periodic", "periodic"), ("clamped", "clamped")];
    let ends = ends.iter().find(|(fact, _)| space[fact] == true).map_or("unclamped", |(_, word)| word);
    let knot = |knot: &Json| match knot[1].as_u64() {
        Some(copies) if copies != 1 => format!("{} ({copies})", text(&knot[0])),
        _ => text(&knot[0]),
    };
    let knots: Vec<String> = space["knots"].as_array().into_iter().flatten().map(knot).collect();
    format!(
        "  {direction}: degree {}, {} coefficients on [{}, {}], {ends}\n  {direction} knots: {}\n",
        space["degree"],
        space["coefficients"],
        text(&space["domain"][0]),
        text(&space["domain"][1]),
        knots.join(", ")
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use symspline::{Q, Scalar, SplineSpace};
    use symspline_dynamic::{AnySpline, Over};

    #[test]
    fn the_box_of_an_arch_is_tight() {
        // (t, 4 t (1 - t)) reaches 1, its control point 2.
        let space = SplineSpace::bezier(2, Q::int(0), Q::int(1)).unwrap();
        let coords = [Q::int(0), Q::int(0), Q::frac(1, 2), Q::int(2), Q::int(1), Q::int(0)];
        let arch = AnySpline::new(space.into(), 2, Over::Exact(coords.to_vec())).unwrap();
        let facts = facts(0, &Entry::named("C", arch));
        let top = facts["box"][1][1].as_f64().unwrap();
        assert!((1.0..1.0 + 1e-9).contains(&top));
        // The length of y = 4 x (1 - x) over [0, 1]: √17/2 + asinh(4)/8.
        let length = 17_f64.sqrt() / 2.0 + 4_f64.asinh() / 8.0;
        assert!((facts["length"].as_f64().unwrap() - length).abs() < 1e-11);
        assert_eq!(facts["parameters"][0]["knots"], json!([["0", 3], ["1", 3]]));
    }
}
