//! `profile`: the curvature of curves, with all its events, proved.

use crate::commands::eval::number;
use crate::failure::{Failure, Result};
use crate::input::{Input, entry_name};
use crate::{output, progress};
use clap::Args;
use nalgebra::{SVector, Vector2};
use serde_json::{Value as Json, json};
use std::path::{Path, PathBuf};
use symspline::plot::{Color, Figure, Panel, Style};
use symspline::roots::RootValue;
use symspline::{Analyse, Bounds, Crossed, CurvatureProfile, Event, EventKind, Place};
use symspline_dynamic::{Any, Field, Value};

/// Prove where the curvature of curves has extrema, inflections, jumps and corners
#[derive(Args, Debug)]
#[command(after_help = "\
Curvature has a sign in the plane, positive where the curve turns left. There are no other events than those that are told.

Examples:
  symspline profile curve.json
  symspline profile --picture curve.svg --json curve.json")]
pub struct Profile {
    #[command(flatten)]
    input: Input,
    /// Pass over corners of less than this angle in radians, and jumps of less than this part of the curvature
    #[arg(long, value_name = "ANGLE", default_value_t = 0.0)]
    smooth: f64,
    /// Draw curves with combs, and their curvature, to an SVG or PNG file
    #[arg(long, value_name = "FILE")]
    picture: Option<PathBuf>,
    /// Write JSON
    #[arg(long)]
    json: bool,
}

/// What is told of one curve.
struct Told {
    name: String,
    rows: Vec<Vec<String>>,
    json: Json,
}

impl Profile {
    /// Runs the command.
    pub fn run(&self) -> Result<()> {
        let entries = self.input.entries()?;
        let mut picture = Picture::default();
        let mut all = Vec::new();
        let bar = progress::bar(entries.len(), "proving");
        for (i, entry) in &entries {
            let name = entry_name(*i, entry);
            let place = format!("{}: {name}", self.input.label());
            let (rows, json) =
                self.profiled(&entry.value, &name, &mut picture).map_err(|failure| failure.at(&place))?;
            all.push(Told { name, rows, json });
            bar.inc(1);
        }
        bar.finish_and_clear();
        if let Some(file) = &self.picture {
            picture.write(file)?;
        }
        if self.json {
            let entry = |told: &Told| json!({"curve": told.name, "events": told.json});
            return output::json(&all.iter().map(entry).collect());
        }
        let head = || ["event", "parameter", "curvature"].map(str::to_owned).to_vec();
        let table = |told: &Told| {
            let rows: Vec<_> = std::iter::once(head()).chain(told.rows.iter().cloned()).collect();
            format!("{}\n{}", told.name, output::table(&rows))
        };
        output::text(&all.iter().map(table).collect::<Vec<_>>().join("\n"))
    }

    fn profiled(&self, value: &Value, name: &str, picture: &mut Picture) -> Result<(Vec<Vec<String>>, Json)> {
        /// One text for all kinds of curves.
        macro_rules! profiled {
            ($curve:expr) => {{
                let profile = $curve.profile_within(self.smooth)?;
                if self.picture.is_some() {
                    picture.add(value, &profile, name)?;
                }
                Ok(told(&profile))
            }};
        }
        match value {
            Value::Spline(Any::F2(c)) => profiled!(c),
            Value::Spline(Any::F3(c)) => profiled!(c),
            Value::Spline(Any::Q2(c)) => profiled!(c),
            Value::Spline(Any::Q3(c)) => profiled!(c),
            Value::Rational(Any::F2(c)) => profiled!(c),
            Value::Rational(Any::F3(c)) => profiled!(c),
            Value::Rational(Any::Q2(c)) => profiled!(c),
            Value::Rational(Any::Q3(c)) => profiled!(c),
            other => Err(Failure::refused(format!("a curve is expected, not a {}", other.kind()))),
        }
    }
}

/// The events as rows of a table, and as JSON.
fn told<T: Field>(profile: &CurvatureProfile<T>) -> (Vec<Vec<String>>, Json) {
    let events = profile.events();
    (events.iter().map(row).collect(), events.iter().map(event_json).collect())
}

fn kind(kind: EventKind) -> String {
    format!("{kind:?}").to_lowercase()
}

fn row<T: Field>(event: &Event<T>) -> Vec<String> {
    let float = |x: &T| f64::of(&x.clone().number()).unwrap_or(f64::NAN);
    let place = match &event.place {
        Place::At(RootValue::Exact(x)) => x.to_string(),
        Place::At(RootValue::Enclosed(low, high)) => {
            let (low, high) = (float(low), float(high));
            format!("{:.12} ± {:.0e}", low * 0.5 + high * 0.5, (high - low) * 0.5)
        }
        Place::Along(start, end) => format!("{start} to {end}"),
    };
    let [before, after] = event.curvature;
    let value = match event.kind {
        EventKind::Corner => format!("turns by {:.6} rad", event.turn),
        _ if (before.middle() - after.middle()).abs() <= 1e-9 * before.middle().abs() => shown(&before),
        _ => format!("{} to {}", shown(&before), shown(&after)),
    };
    vec![kind(event.kind), place, value]
}

/// A curvature for people.
fn shown(bounds: &Bounds) -> String {
    match (bounds.low.is_finite(), bounds.high.is_finite()) {
        (true, true) if bounds.low <= 0.0 && bounds.high >= 0.0 => "0".to_owned(),
        (true, true) => format!("{:.9}", bounds.middle()),
        _ => "infinite".to_owned(),
    }
}

fn event_json<T: Field>(event: &Event<T>) -> Json {
    let own = |x: &T| number(&x.clone().number());
    let place = match &event.place {
        Place::At(RootValue::Exact(x)) => json!({"at": own(x)}),
        Place::At(RootValue::Enclosed(low, high)) => json!({"between": [own(low), own(high)]}),
        Place::Along(start, end) => json!({"along": [own(start), own(end)]}),
    };
    let bounds = |b: &Bounds| json!([b.low, b.high]);
    json!({
        "kind": kind(event.kind),
        "place": place,
        "curvature": event.curvature.iter().map(bounds).collect::<Json>(),
        "turn": event.turn,
    })
}

/// About how many teeth a comb has.
const TEETH: usize = 150;

/// Curves with combs, and their curvatures.
struct Picture {
    plane: Panel,
    graph: Panel,
    curves: usize,
    in_plane: usize,
}

impl Default for Picture {
    fn default() -> Self {
        Self {
            plane: Panel::new().title("Curves, combs and events").equal_axes(),
            graph: Panel::new().title("Curvature").y_label("κ").x_label("parameter").height(260.0),
            curves: 0,
            in_plane: 0,
        }
    }
}

impl Picture {
    fn add<T: Field>(&mut self, value: &Value, profile: &CurvatureProfile<T>, name: &str) -> Result<()> {
        let color = Color::nth(self.curves);
        let first = self.curves == 0;
        self.curves += 1;
        let graph = std::mem::replace(&mut self.graph, Panel::new());
        self.graph = graph.curvature(profile, color).label(name).events(profile, color, first);
        match value.to_float()? {
            Value::Spline(Any::F2(c)) => self.add_plane(&c, |x| c.at(&x), c.domain(), profile, (name, color)),
            Value::Rational(Any::F2(c)) => {
                self.add_plane(&c, |x| c.at(&x), c.domain(), profile, (name, color))
            }
            _ => Ok(()),
        }
    }

    fn add_plane<T: Field>(
        &mut self,
        curve: &impl Analyse<f64, 2>,
        at: impl Fn(f64) -> symspline::Result<Vector2<f64>>,
        (start, end): (&f64, &f64),
        profile: &CurvatureProfile<T>,
        (name, color): (&str, Color),
    ) -> Result<()>
    where
        SVector<f64, 2>: Crossed<f64>,
    {
        let inside = |x: f64| x.clamp(*start, *end);
        let places: Vec<f64> = profile.samples().iter().map(|sample| inside(sample.parameter)).collect();
        // Four steps from sample to sample, for curves of few spans.
        let ends: Vec<f64> = std::iter::once(*start).chain(places.iter().copied()).chain([*end]).collect();
        let steps = ends.windows(2).flat_map(|pair| {
            [0.0, 0.25, 0.5, 0.75].map(|share| inside(pair[0] + share * (pair[1] - pair[0])))
        });
        let points = steps.chain([*end]).map(&at).collect::<symspline::Result<Vec<_>>>()?;
        let (low, high) =
            points.iter().fold((points[0], points[0]), |(low, high), p| (low.inf(p), high.sup(p)));
        let scale = profile.comb_scale(0.06 * (high - low).norm());
        // Where the curve stands still there is no tooth.
        let teeth = places
            .iter()
            .step_by((places.len() / TEETH).max(1))
            .filter_map(|x| curve.curvature_comb(&[*x], &scale).ok())
            .flatten();
        let plane = std::mem::replace(&mut self.plane, Panel::new());
        self.plane = plane
            .comb(
                teeth.map(|(foot, tip)| ((foot[0], foot[1]), (tip[0], tip[1]))),
                Style::line(color).width(0.7),
            )
            .polyline(points.iter().map(|p| (p[0], p[1])), Style::line(color).width(2.0))
            .label(name)
            .events_along(profile, color, self.in_plane == 0, |x| at(inside(x)))?;
        self.in_plane += 1;
        Ok(())
    }

    fn write(self, file: &Path) -> Result<()> {
        let ending =
            file.extension().map(|ending| ending.to_string_lossy().to_lowercase()).unwrap_or_default();
        let mut figure = Figure::new(1000.0).title("Curvature profile");
        if self.in_plane > 0 {
            figure = figure.panel(self.plane);
        }
        let figure = figure.panel(self.graph);
        match ending.as_str() {
            "svg" => output::write_bytes(file, figure.to_svg()?.as_bytes()),
            "png" => output::write_bytes(file, &figure.to_png(1.5)?),
            _ => Err(Failure::Usage(format!("{}: pictures are .svg or .png", file.display()))),
        }
    }
}
