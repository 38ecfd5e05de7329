//! Fine tuning of a car body profile: the derivative is scaled by α, so the curvature becomes κ / α.
#![allow(clippy::print_stdout, reason = "the example reports on standard output")]
//!
//! Reads measured points, fits a cubic by banded least squares, and computes D = C(a) + ∫ α C' as an exact spline
//! product and integral: once with the end free, once with both ends held by a rotation and a scaling.

use clap::Parser;
use nalgebra::{SVector, vector};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};
use symspline::plot::{Color, Figure, Marker, Panel, Style, curve_path, graph_path};
use symspline::{Analyse, Curve, Ends, Function, Hold, SplineSpace, chord_length};

/// Fine-tune a plane curve: scale its derivative by a function, and so its curvature by the inverse.
#[derive(Parser)]
struct Arguments {
    /// Points of the profile: a CSV file with a header and two columns, or three of which the last two count (side view)
    #[arg(long, default_value = concat!(env!("CARGO_MANIFEST_DIR"), "/data/car_prius_profile_3.csv"))]
    input: PathBuf,
    /// Control points of the cubic that is fitted to them, at least four
    #[arg(long, default_value_t = 72, value_parser = at_least_four)]
    controls: usize,
    /// Control values of the quadratic scale function α, at least three
    #[arg(long, value_delimiter = ',', default_value = "1,1,0.5,2,1,1")]
    alpha: Vec<f64>,
    /// Where to write the picture; .svg and .png are put after it
    #[arg(long, default_value = "target/fine_tune")]
    output: PathBuf,
}

fn at_least_four(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(count) if count >= 4 => Ok(count),
        Ok(count) => Err(format!("a cubic has at least 4 control points, not {count}")),
        Err(error) => Err(format!("{error}")),
    }
}

/// A tuned curve and what is said of it.
struct Tuned {
    name: &'static str,
    color: Color,
    curve: Curve<f64, 2>,
    /// The factor by which holding the ends scaled the curve.
    scale: f64,
    time: Option<Duration>,
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("fine_tune: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let points = read_points(&arguments.input)?;
    let parameters = chord_length(&points)?;
    let spans = arguments.controls.saturating_sub(3);
    let space = SplineSpace::uniform(3, spans, 0.0, 1.0)?;
    let curve = Curve::least_squares(&space, &parameters, &points, Ends::Held)?;

    let spans = arguments.alpha.len().saturating_sub(2);
    if spans == 0 {
        return Err("a quadratic α has at least 3 control values".into());
    }
    let alpha = Function::new(SplineSpace::uniform(2, spans, 0.0, 1.0)?, arguments.alpha.clone())?;

    let free = curve.fine_tuned(&alpha)?;
    let held = curve.fine_tuned_holding(&alpha, Hold::Points)?.curve;
    let scale = chord(&held) / chord(&free);
    let time = median_time(|| curve.fine_tuned(&alpha).map(drop))?;
    let tuned = [
        Tuned { name: "tuned, end free", color: Color::BLUE, curve: free, scale: 1.0, time: Some(time) },
        Tuned { name: "tuned, ends held", color: Color::VERMILLION, curve: held, scale, time: None },
    ];

    let residual = curve.largest_squared_residual(&parameters, &points)?.sqrt();
    println!("{} points, fitted to {residual:.3} mm", points.len());
    print_table(&curve, &alpha, &tuned)?;
    let figure = draw(&curve, &alpha, &tuned)?;
    for extension in ["svg", "png"] {
        let mut path = arguments.output.clone().into_os_string();
        path.push(format!(".{extension}"));
        let path = PathBuf::from(path);
        match extension {
            "svg" => figure.write_svg(&path)?,
            _ => figure.write_png(&path, 1.0)?,
        }
        println!("wrote {}", path.display());
    }
    Ok(())
}

/// The points of a CSV file, its last two columns.
fn read_points(path: &Path) -> Result<Vec<SVector<f64, 2>>, Box<dyn Error>> {
    let place = |line: u64| format!("{}, line {line}", path.display());
    let mut reader = csv::Reader::from_path(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let mut points = Vec::new();
    for record in reader.records() {
        let record = record?;
        let line = record.position().map_or(0, csv::Position::line);
        let number = |i: usize| -> Result<f64, String> {
            let text = record[record.len() - i].trim();
            text.parse().map_err(|_| format!("{}: '{text}' is not a number", place(line)))
        };
        if !(2..=3).contains(&record.len()) {
            return Err(format!("{}: {} columns, 2 or 3 are needed", place(line), record.len()).into());
        }
        points.push(vector![number(2)?, number(1)?]);
    }
    Ok(points)
}

/// The distance of the ends.
fn chord(curve: &Curve<f64, 2>) -> f64 {
    let points = curve.coeffs();
    (points[points.len() - 1] - points[0]).norm()
}

/// The median of many runs.
fn median_time(work: impl Fn() -> symspline::Result<()>) -> symspline::Result<Duration> {
    let mut times = Vec::new();
    for _ in 0..101 {
        let start = Instant::now();
        work()?;
        times.push(start.elapsed());
    }
    times.sort_unstable();
    Ok(times[times.len() / 2])
}

/// Evenly spaced parameters in every span, and the end.
fn samples(space: &SplineSpace<f64>, per_span: u32) -> Vec<f64> {
    let breaks: Vec<f64> = space.breaks().into_iter().map(|(t, _)| t).collect();
    let inside = |ends: &[f64]| {
        (0..per_span)
            .map(|i| ends[0] + (ends[1] - ends[0]) * f64::from(i) / f64::from(per_span))
            .collect::<Vec<_>>()
    };
    breaks.windows(2).flat_map(inside).chain(breaks.last().copied()).collect()
}

fn print_table(curve: &Curve<f64, 2>, alpha: &Function<f64>, tuned: &[Tuned]) -> symspline::Result<()> {
    println!();
    println!(
        "{:<18}{:>7}{:>7}{:>10}{:>26}{:>14}{:>14}{:>12}",
        "", "degree", "spans", "controls", "max |κ_D α - κ|/max|κ|", "start moved", "end moved", "time"
    );
    let row = |name: &str, curve: &Curve<f64, 2>| {
        print!(
            "{name:<18}{:>7}{:>7}{:>10}",
            curve.degree(),
            curve.space().spans().count(),
            curve.coeffs().len()
        );
    };
    row("original", curve);
    println!();
    let (first, last) = (curve.coeffs()[0], curve.coeffs()[curve.coeffs().len() - 1]);
    for Tuned { name, curve: d, scale, time, .. } in tuned {
        let at = samples(d.space(), 16);
        let kappa = curve.curvature_profile(&at)?;
        let largest = kappa.iter().fold(0.0_f64, |m, k| m.max(k.abs()));
        let deviation = at
            .iter()
            .zip(&kappa)
            .map(|(x, k)| Ok((d.curvature_at(x)? * alpha.at(x)?.abs() * scale - k).abs()));
        let deviation = deviation.collect::<symspline::Result<Vec<f64>>>()?.into_iter().fold(0.0, f64::max);
        row(name, d);
        let (start, end) = ((d.coeffs()[0] - first).norm(), (d.coeffs()[d.coeffs().len() - 1] - last).norm());
        let time = time.map_or(String::new(), |time| format!("{:.1} µs", time.as_secs_f64() * 1e6));
        println!("{:>26.1e}{start:>11.3} mm{end:>11.3} mm{time:>12}", deviation / largest);
    }
    println!();
    println!(
        "Holding both ends scales by {:.6}, so that κ_D α = κ / {0:.6} there: the column is of that.",
        tuned[1].scale
    );
    println!("The time is that of differentiation, product and integration (median of 101 runs).");
    Ok(())
}

/// The curves with combs, α, and the curvature profiles.
fn draw(curve: &Curve<f64, 2>, alpha: &Function<f64>, tuned: &[Tuned]) -> symspline::Result<Figure> {
    let mut plane =
        Panel::new().title("Profile with curvature combs").x_label("y [mm]").y_label("z [mm]").equal_axes();
    let mut profiles =
        Panel::new().title("Curvature").x_label("parameter").y_label("κ [1/mm]").x_from_above();
    let original =
        Tuned { name: "original", color: Color::GRAY, curve: curve.clone(), scale: 1.0, time: None };
    let all = || std::iter::once(&original).chain(tuned);

    // The tooth of the mean curvature of the original has this part of the chord.
    let kappa = curve.curvature_profile(&samples(curve.space(), 16))?;
    let comb_scale = 0.05 * chord(curve) / (kappa.iter().map(|k| k.abs()).sum::<f64>() / kappa.len() as f64);
    for Tuned { color, curve, .. } in all() {
        let comb = curve.curvature_comb(&samples(curve.space(), 4), &comb_scale)?;
        plane = plane.comb(
            comb.into_iter().map(|(foot, tip)| (pair(foot), pair(tip))),
            Style::line(*color).width(0.8),
        );
    }
    for Tuned { name, color, curve, .. } in all() {
        plane = plane.path(curve_path(curve, 0.01)?, Style::line(*color).width(2.5)).label(*name);
        let at = samples(curve.space(), 16);
        let values = curve.curvature_profile(&at)?;
        profiles = profiles.polyline(at.into_iter().zip(values), Style::line(*color).width(1.5)).label(*name);
    }
    // What the theory says of the free curve, on top of what it has.
    let at = samples(curve.space(), 16);
    let predicted =
        at.iter().zip(curve.curvature_profile(&at)?).map(|(x, k)| Ok((*x, k / alpha.at(x)?.abs())));
    let predicted = predicted.collect::<symspline::Result<Vec<_>>>()?;
    profiles = profiles
        .polyline(predicted, Style::line(Color::BLACK).width(1.2).dotted())
        .label("κ / α of the original");
    let controls = alpha.space().greville().into_iter().zip(alpha.coeffs().iter().copied());
    let scale = Panel::new()
        .title("Scale function")
        .y_label("α")
        .marked_polyline(controls, Marker::Circle, Style::line(Color::GRAY).width(1.0))
        .label("control values")
        .path(graph_path(alpha, 1e-4)?, Style::line(Color::GREEN).width(2.0))
        .label("α")
        .knots(curve.space().breaks().into_iter().map(|(t, _)| t), Color::GRAY)
        .label("knots of the curve");
    Ok(Figure::new(1100.0).title("Fine tuning a car body profile").panel(plane).panel(scale).panel(profiles))
}

fn pair(point: SVector<f64, 2>) -> (f64, f64) {
    (point[0], point[1])
}
