//! Curvature profiles with all their events proved: of a car body profile and of a letter, before and after fine
//! tuning.
#![allow(clippy::print_stdout, reason = "the example reports on standard output")]

mod support;

use std::time::Instant;
use support::{Outcome, Plane, data, letter, points, target, write};
use symspline::plot::{Color, Figure, Panel, Style, curve_path};
use symspline::{Analyse, CurvatureProfile, Ends, EventKind, Function, Hold, SplineSpace, chord_length};

/// A font is drawn on a grid: corners of less than this angle, in radians, are meant to be smooth.
const SMOOTH: f64 = 0.02;

fn main() -> Outcome<()> {
    let car = car()?;
    let alpha = Function::new(SplineSpace::uniform(2, 4, 0.0, 1.0)?, vec![1.0, 1.0, 0.5, 2.0, 1.0, 1.0])?;
    let tuned = car.fine_tuned_holding(&alpha, Hold::Points)?.curve;
    report("car", "Car body profile", "mm", &[("before", &car), ("after", &tuned)])?;

    let letter = letter("S")?;
    let stretch = longest_smooth(&letter)?;
    let (a, b) = stretch.domain();
    let alpha = Function::new(SplineSpace::bezier(2, *a, *b)?, vec![1.0, 1.4, 1.0])?;
    let tuned = stretch.fine_tuned_holding(&alpha, Hold::Points)?.curve;
    report(
        "letter",
        "Letter S: the outline, and one of its sides fine-tuned",
        "units",
        &[("outline", &letter), ("after", &tuned)],
    )
}

/// A cubic through measured points.
fn car() -> Outcome<Plane> {
    let points = points(&data("car_prius_profile_3.csv"))?;
    let space = SplineSpace::uniform(3, 13, 0.0, 1.0)?;
    Ok(Plane::least_squares(&space, &chord_length(&points)?, &points, Ends::Held)?)
}

/// The longest part of a curve without a corner.
fn longest_smooth(curve: &Plane) -> symspline::Result<Plane> {
    let profile = curve.profile_within(SMOOTH)?;
    let corners = profile.events().iter().filter(|event| event.kind == EventKind::Corner);
    let corners: Vec<f64> = corners.map(|event| *event.place.bounds().0).chain([*curve.domain().1]).collect();
    let longest = corners.windows(2).max_by(|one, other| (one[1] - one[0]).total_cmp(&(other[1] - other[0])));
    longest.map_or(Ok(curve.clone()), |ends| curve.restricted(&ends[0], &ends[1]))
}

fn report(file: &str, title: &str, unit: &str, curves: &[(&str, &Plane)]) -> Outcome<()> {
    let mut plane = Panel::new().title("Curve, comb and events").x_label(unit).equal_axes();
    let mut graph =
        Panel::new().title("Curvature").y_label(format!("κ [1/{unit}]")).x_label("parameter").height(240.0);
    let mut log_log = Panel::new().title("Logarithmic curvature graph").height(200.0);
    for (i, (name, curve)) in curves.iter().enumerate() {
        let start = Instant::now();
        let profile = curve.profile_within(SMOOTH)?;
        println!("{title}, {name}: degree {}, proved in {:.1?}", curve.degree(), start.elapsed());
        print_events(&profile);
        let (color, thin) = (Color::nth(i), Style::line(Color::nth(i)).width(0.7));
        let (low, high) = curve.control_box();
        let scale = profile.comb_scale(0.06 * (high - low).norm());
        let at: Vec<f64> = profile.samples().iter().step_by(3).map(|sample| sample.parameter).collect();
        let comb = curve.curvature_comb(&at, &scale)?;
        plane = plane
            .comb(comb.into_iter().map(|(foot, tip)| ((foot[0], foot[1]), (tip[0], tip[1]))), thin)
            .path(curve_path(curve, 0.01)?, Style::line(color).width(2.0))
            .label(*name)
            .events_along(&profile, color, i == 0, |x| curve.at(&x))?;
        graph = graph.curvature(&profile, color).label(*name).events(&profile, color, i == 0);
        log_log = log_log.log_curvature(&profile, color).label(*name);
    }
    let (before, after) = (curves[0].1.profile_within(SMOOTH)?, curves[1].1.profile_within(SMOOTH)?);
    match before.differs_at(&after) {
        None => println!("Both have the same sequence of events.\n"),
        Some(i) => println!("The sequences of events differ from number {} on.\n", i + 1),
    }
    let figure = Figure::new(1000.0).title(title).panel(plane).panel(graph).panel(log_log);
    write(&figure, &target(&format!("curvature_{file}")))?;
    println!();
    Ok(())
}

fn print_events(profile: &CurvatureProfile<f64>) {
    println!("{:>12}  {:>24}  {:>23}", "event", "parameter", "curvature");
    for event in profile.events().iter().filter(|event| event.kind != EventKind::Jump) {
        let ((low, high), [before, after]) = (event.place.bounds(), event.curvature);
        let place = if low == high {
            format!("{low:.9}")
        } else {
            format!("{:.9} ± {:.0e}", (low + high) / 2.0, (high - low) / 2.0)
        };
        let value = match event.kind {
            EventKind::Corner => format!("turns by {:.2}°", event.turn.to_degrees()),
            _ if (before.middle() - after.middle()).abs() < 1e-9 => format!("{:.8}", before.middle()),
            _ => format!("{:.7} to {:.7}", before.middle(), after.middle()),
        };
        println!("{:>12}  {place:>24}  {value:>23}", format!("{:?}", event.kind).to_lowercase());
    }
    println!("{:>12}  {:>24}", "jumps", profile.count(EventKind::Jump));
}
