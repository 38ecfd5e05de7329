//! What the examples share: the data of the repository as curves, and pictures as files.
#![allow(dead_code, reason = "no example needs all of it")]

pub mod solid;
pub mod subdivided;

use nalgebra::{SVector, vector};
use std::error::Error;
use std::path::{Path, PathBuf};
use symspline::plot::{Color, Figure, Marker, Panel, Style, curve_path};
use symspline::{Curve, SplineSpace, Surface};

pub type Plane = Curve<f64, 2>;
pub type Point = SVector<f64, 2>;
pub type Outcome<T> = Result<T, Box<dyn Error>>;

/// The path of a file in `data`.
pub fn data(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("data").join(file)
}

/// The points of a CSV file with a header, its last two columns.
pub fn points(path: &Path) -> Outcome<Vec<Point>> {
    let mut reader = csv::Reader::from_path(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let mut points = Vec::new();
    for record in reader.records() {
        let record = record?;
        let place = format!("{}, line {}", path.display(), record.position().map_or(0, csv::Position::line));
        let number = |i: usize| -> Result<f64, String> {
            let text = record[record.len() - i].trim();
            text.parse().map_err(|_| format!("{place}: '{text}' is not a number"))
        };
        if !(2..=3).contains(&record.len()) {
            return Err(format!("{place}: {} columns, 2 or 3 are needed", record.len()).into());
        }
        points.push(vector![number(2)?, number(1)?]);
    }
    Ok(points)
}

/// The outline of a letter: one quadratic piece a unit of the parameter.
pub fn letter(name: &str) -> Outcome<Plane> {
    let path = data("glyphs_dejavu_serif_quadratic.json");
    let font: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(path)?)?;
    let point = |p: &serde_json::Value| Some(vector![p[0].as_f64()?, p[1].as_f64()?]);
    let mut points: Vec<Point> = Vec::new();
    for command in font["glyphs"][name].as_array().ok_or("no such letter")? {
        let given = command[1].as_array().ok_or("a command has points")?;
        let given =
            given.iter().map(point).collect::<Option<Vec<_>>>().ok_or("points are pairs of numbers")?;
        match (command[0].as_str(), given.as_slice()) {
            (Some("moveTo"), [start]) if points.is_empty() => points.push(*start),
            (Some("lineTo"), [end]) => line(&mut points, *end),
            (Some("qCurveTo"), [off @ .., end]) => {
                let between = off.windows(2).map(|pair| (pair[0] + pair[1]) * 0.5).chain([*end]);
                off.iter().zip(between).for_each(|(off, on)| points.extend([*off, on]));
            }
            (Some("closePath"), []) => {
                let start = points[0];
                if points[points.len() - 1] != start {
                    line(&mut points, start);
                }
            }
            _ => return Err("only letters of one outline are read".into()),
        }
    }
    let pieces = points.len() / 2;
    let inner = (1..pieces).flat_map(|t| [t as f64; 2]);
    let space = SplineSpace::clamped(2, std::iter::once(0.0).chain(inner).chain([pieces as f64]))?;
    Ok(Plane::new(space, points)?)
}

/// Adds a line as a quadratic piece.
fn line(points: &mut Vec<Point>, end: Point) {
    let start = points[points.len() - 1];
    points.extend([(start + end) * 0.5, end]);
}

/// A point as a plot takes it.
pub fn pair(point: Point) -> (f64, f64) {
    (point[0], point[1])
}

/// Writes a picture as SVG and as PNG, and says where.
#[allow(clippy::print_stdout, reason = "examples report on standard output")]
pub fn write(figure: &Figure, output: &Path) -> Outcome<()> {
    for extension in ["svg", "png"] {
        let mut path = output.to_path_buf().into_os_string();
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

/// The path of a picture in `target`, without extension.
pub fn target(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("target").join(name)
}

/// The control polygon of a plane curve, marked.
pub fn polygon(panel: Panel, curve: &Plane, color: Color) -> Outcome<Panel> {
    let points = curve.coeffs().iter().map(|p| pair(*p));
    Ok(panel.marked_polyline(points, Marker::Circle, Style::line(color).width(0.8)))
}

/// A panel with a curve and its control polygon.
pub fn before(title: &str, curve: &Plane) -> Outcome<Panel> {
    let panel = Panel::new().title(title).equal_axes().height(250.0);
    let panel = polygon(panel, curve, Color::GRAY)?;
    Ok(panel.path(curve_path(curve, 1e-4)?, Style::line(Color::BLACK).width(1.8)).label("before"))
}

/// The panel with a changed curve, its control polygon, and where a point came to lie.
pub fn after(panel: Panel, curve: &Plane, at: f64, color: Color, name: &str) -> Outcome<Panel> {
    let panel = panel.path(curve_path(curve, 1e-4)?, Style::line(color).width(1.8)).label(name);
    Ok(panel.markers([pair(curve.at(&at)?)], Marker::Circle, Style::line(color)))
}

/// Space on paper.
pub fn seen(p: SVector<f64, 3>) -> (f64, f64) {
    (p[0] + 0.45 * p[1], 0.5 * p[1] + 0.9 * p[2])
}

/// A surface as quadrangles, the farther ones first, each the lighter the more it faces the light.
pub fn shaded(mut panel: Panel, surface: &Surface<f64, 3>, count: usize) -> Outcome<Panel> {
    let places: Vec<f64> = (0..=count).map(|i| i as f64 / count as f64).collect();
    let points = surface.eval_grid(&places, &places)?;
    let light = vector![0.5, -0.5, 0.8].normalize();
    for j in (0..count).rev() {
        for i in 0..count {
            let corners =
                [(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)].map(|(k, l)| points[(i + k) * (count + 1) + j + l]);
            let normal = (corners[2] - corners[0]).cross(&(corners[3] - corners[1]));
            let shade = if normal.norm() > 0.0 { normal.normalize().dot(&light).abs() } else { 1.0 };
            let tone = |dark: f64, bright: f64| (dark + (bright - dark) * shade) as u8;
            let color = Color::new(tone(60.0, 225.0), tone(75.0, 235.0), tone(110.0, 245.0));
            let line = Color::new(tone(40.0, 150.0), tone(50.0, 165.0), tone(80.0, 185.0));
            panel = panel.polyline(corners.map(seen), Style::line(line).width(0.25).filled(color, 1.0));
        }
    }
    Ok(panel)
}

/// The control net of a surface, marked.
pub fn net(mut panel: Panel, surface: &Surface<f64, 3>, color: Color) -> Panel {
    let columns = surface.transposed();
    for (lines, marker) in [(surface, Marker::Circle), (&columns, Marker::Circle)] {
        for row in lines.rows() {
            panel =
                panel.marked_polyline(row.iter().map(|p| seen(*p)), marker, Style::line(color).width(0.7));
        }
    }
    panel
}
