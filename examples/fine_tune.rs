//! Fine tuning of a car body profile: the derivative is scaled by α, so the curvature becomes κ / α.
#![allow(clippy::print_stdout, reason = "the example reports on standard output")]
//!
//! Reads measured points, fits a cubic by banded least squares, and computes D = C(a) + ∫ α C' as an exact spline
//! product and integral: with the end free; with ends, tangents and curvatures held by a rotation and a scaling; and by the
//! nearest scale with which the end stays by itself, so that every tangent keeps its direction.

mod support;

use clap::Parser;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{Duration, Instant};
use support::{Outcome, Plane, pair};
use symspline::plot::{Color, Figure, Marker, Panel, Style, curve_path, graph_path};
use symspline::{
    Analyse, Condition, Ends, EventKind, Function, Hold, NearestScale, Norm, SplineSpace, chord_length,
};

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
    curve: Plane,
    /// What the derivative was scaled by.
    alpha: Function<f64>,
    /// The factor by which holding the ends scaled the curve.
    scale: f64,
    time: Option<Duration>,
    drawn: bool,
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

fn run(arguments: &Arguments) -> Outcome<()> {
    let points = support::points(&arguments.input)?;
    let parameters = chord_length(&points)?;
    let spans = arguments.controls.saturating_sub(3);
    let space = SplineSpace::uniform(3, spans, 0.0, 1.0)?;
    let curve = Plane::least_squares(&space, &parameters, &points, Ends::Held)?;

    let spans = arguments.alpha.len().saturating_sub(2);
    if spans == 0 {
        return Err("a quadratic α has at least 3 control values".into());
    }
    let alpha = Function::new(SplineSpace::uniform(2, spans, 0.0, 1.0)?, arguments.alpha.clone())?;

    let time = median_time(|| curve.fine_tuned(&alpha).map(drop))?;
    let free = Tuned {
        name: "end free",
        color: Color::BLUE,
        curve: curve.fine_tuned(&alpha)?,
        alpha: alpha.clone(),
        scale: 1.0,
        time: Some(time),
        drawn: true,
    };
    let mut tuned = vec![free];
    for (name, color, hold) in [
        ("ends held", Color::VERMILLION, Hold::Points),
        ("tangents held", Color::PURPLE, Hold::Tangents),
        ("curvatures held", Color::ORANGE, Hold::Curvatures),
    ] {
        let held = curve.fine_tuned_holding(&alpha, hold)?;
        let scale = held.scale();
        let (curve, alpha, drawn) = (held.curve, alpha.clone(), hold == Hold::Points);
        tuned.push(Tuned { name, color, curve, alpha, scale, time: None, drawn });
    }
    let nearest = NearestScale::prepare(&curve, alpha.space(), &[Condition::End], Norm::L2)?.to(&alpha)?;
    tuned.push(Tuned {
        name: "nearest scale",
        color: Color::GREEN,
        curve: curve.fine_tuned(&nearest)?,
        alpha: nearest,
        scale: 1.0,
        time: None,
        drawn: true,
    });

    let residual = curve.largest_squared_residual(&parameters, &points)?.sqrt();
    println!("{} points, fitted to {residual:.3} mm", points.len());
    print_table(&curve, &tuned)?;
    let figure = draw(&curve, &alpha, &tuned)?;
    support::write(&figure, &arguments.output)
}

/// The distance of the ends.
fn chord(curve: &Plane) -> f64 {
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

/// What is said of each tuned curve. With the ends held by a similarity of scale `s` curvature is `κ / (α s)`.
fn print_table(curve: &Plane, tuned: &[Tuned]) -> symspline::Result<()> {
    println!();
    println!(
        "{:<16}{:>7}{:>10}{:>10}{:>24}{:>14}{:>12}{:>9}{:>10}",
        "",
        "degree",
        "controls",
        "s",
        "|κ_D α s - κ| / |κ|max",
        "tangent turns",
        "end moved",
        "extrema",
        "time"
    );
    let extrema = |curve: &Plane| -> symspline::Result<usize> {
        let profile = curve.profile()?;
        Ok(profile.count(EventKind::Maximum) + profile.count(EventKind::Minimum))
    };
    let (degree, controls) = (curve.degree(), curve.coeffs().len());
    println!("{:<16}{degree:>7}{controls:>10}{:>69}", "original", extrema(curve)?);
    let at = samples(curve.space(), 16);
    let kappa = at.iter().map(|x| curve.curvature_at(x)).collect::<symspline::Result<Vec<f64>>>()?;
    let largest = kappa.iter().fold(0.0_f64, |m, k| m.max(k.abs()));
    for Tuned { name, curve: d, alpha, scale, time, .. } in tuned {
        let (mut off, mut turn) = (0.0_f64, 0.0_f64);
        for (x, k) in at.iter().zip(&kappa) {
            off = off.max((d.curvature_at(x)? * alpha.at(x)? * scale - k).abs());
            turn = turn.max(curve.derivative_at(x, 1)?.angle(&d.derivative_at(x, 1)?).to_degrees());
        }
        let moved = (d.coeffs()[d.coeffs().len() - 1] - curve.coeffs()[controls - 1]).norm();
        let time = time.map_or(String::new(), |time| format!("{:.1} µs", time.as_secs_f64() * 1e6));
        println!(
            "{name:<16}{:>7}{:>10}{scale:>10.4}{:>24.1e}{turn:>13.4}°{moved:>9.3} mm{:>9}{time:>10}",
            d.degree(),
            d.coeffs().len(),
            off / largest,
            extrema(d)?
        );
    }
    println!();
    println!("The time is that of differentiation, product and integration (median of 101 runs).");
    println!(
        "The nearest scale holds the end without a similarity: no tangent turns, and its own α is what κ_D is of."
    );
    Ok(())
}

/// The curves with combs, the scale functions, and the curvature profiles.
fn draw(curve: &Plane, alpha: &Function<f64>, tuned: &[Tuned]) -> symspline::Result<Figure> {
    let mut plane =
        Panel::new().title("Profile with curvature combs").x_label("y [mm]").y_label("z [mm]").equal_axes();
    let mut profiles =
        Panel::new().title("Curvature").x_label("parameter").y_label("κ [1/mm]").x_from_above();
    let shown = tuned.iter().filter(|tuned| tuned.drawn);
    let curves: Vec<(&str, Color, &Plane)> = std::iter::once(("original", Color::GRAY, curve))
        .chain(shown.clone().map(|tuned| (tuned.name, tuned.color, &tuned.curve)))
        .collect();
    let scale = curve.profile()?.comb_scale(0.08 * chord(curve));
    for (_, color, curve) in &curves {
        let comb = curve.curvature_comb(&samples(curve.space(), 4), &scale)?;
        let comb = comb.into_iter().map(|(foot, tip)| (pair(foot), pair(tip)));
        plane = plane.comb(comb, Style::line(*color).width(0.8));
    }
    for (name, color, curve) in curves {
        plane = plane.path(curve_path(curve, 0.01)?, Style::line(color).width(2.5)).label(name);
        profiles = profiles.curvature(&curve.profile()?, Style::line(color).width(1.5)).label(name);
    }
    // What the theory says of the free curve, on top of what it has.
    let at = samples(curve.space(), 16);
    let predicted = at.iter().map(|x| Ok((*x, curve.curvature_at(x)? / alpha.at(x)?)));
    let predicted = predicted.collect::<symspline::Result<Vec<_>>>()?;
    profiles = profiles
        .polyline(predicted, Style::line(Color::BLACK).width(1.2).dotted())
        .label("κ / α of the original");
    let mut scales = Panel::new().title("Scale functions").y_label("α");
    for (name, color, alpha) in shown.filter(|tuned| tuned.scale == 1.0).map(|t| (t.name, t.color, &t.alpha))
    {
        let controls = alpha.space().greville().into_iter().zip(alpha.coeffs().iter().copied());
        scales = scales
            .marked_polyline(controls, Marker::Circle, Style::line(color).width(0.7))
            .path(graph_path(alpha, 1e-4)?, Style::line(color).width(2.0))
            .label(format!("α, {name}"));
    }
    scales = scales
        .knots(curve.space().breaks().into_iter().map(|(t, _)| t), Color::GRAY)
        .label("knots of the curve");
    Ok(Figure::new(1100.0).title("Fine tuning a car body profile").panel(plane).panel(scales).panel(profiles))
}
