//! Basic shapes.

use super::path;
use crate::error::Problem;
use crate::outline::{Outline, Point, Segment};
use nalgebra::vector;
use roxmltree::Node;
use std::f64::consts::FRAC_1_SQRT_2;
use svgtypes::{Length, LengthUnit, NumberListParser};

/// The outlines of an element; nothing for one that is no shape.
///
/// # Errors
/// [`Problem::Syntax`].
pub(super) fn outlines(node: Node<'_, '_>) -> Result<Vec<Outline>, Problem> {
    let length = |name: &str| length(node, name);
    Ok(match node.tag_name().name() {
        "path" => node.attribute("d").map_or(Ok(Vec::new()), path::outlines)?,
        "line" => {
            let [start, end] = [["x1", "y1"], ["x2", "y2"]].map(|[x, y]| {
                Ok::<_, Problem>(vector![length(x)?.unwrap_or(0.0), length(y)?.unwrap_or(0.0)])
            });
            vec![Outline { start: start?, segments: vec![Segment::Line(end?)] }]
        }
        "polyline" => points(node)?.into_iter().collect(),
        "polygon" => {
            let mut polygon = points(node)?;
            polygon.iter_mut().for_each(Outline::close);
            polygon.into_iter().collect()
        }
        "circle" => {
            let radius = size(node, "r")?.unwrap_or(0.0);
            ellipse(node, [radius, radius])?
        }
        "ellipse" => {
            let (rx, ry) = (size(node, "rx")?, size(node, "ry")?);
            ellipse(node, [rx.or(ry).unwrap_or(0.0), ry.or(rx).unwrap_or(0.0)])?
        }
        "rect" => rectangle(node)?,
        _ => Vec::new(),
    })
}

/// A length in units of the user.
fn length(node: Node<'_, '_>, name: &str) -> Result<Option<f64>, Problem> {
    let Some(text) = node.attribute(name).filter(|text| *text != "auto") else { return Ok(None) };
    match text.trim().parse::<Length>() {
        Ok(Length { number, unit: LengthUnit::None | LengthUnit::Px }) => Ok(Some(number)),
        Ok(_) => Err(Problem::Syntax(format!("'{name}' is in units that are not read: numbers and px are"))),
        Err(error) => Err(Problem::Syntax(format!("'{name}': {error}"))),
    }
}

/// A length that is not negative.
fn size(node: Node<'_, '_>, name: &str) -> Result<Option<f64>, Problem> {
    match length(node, name)? {
        Some(size) if size < 0.0 => Err(Problem::Syntax(format!("'{name}' is negative"))),
        size => Ok(size),
    }
}

fn points(node: Node<'_, '_>) -> Result<Option<Outline>, Problem> {
    let text = node.attribute("points").unwrap_or_default();
    let numbers = NumberListParser::from(text).collect::<Result<Vec<f64>, _>>();
    let numbers = numbers.map_err(|error| Problem::Syntax(format!("'points': {error}")))?;
    if !numbers.len().is_multiple_of(2) {
        return Err(Problem::Syntax("the last point of 'points' has no y".into()));
    }
    let mut points = numbers.chunks_exact(2).map(|point| vector![point[0], point[1]]);
    Ok(points.next().map(|start| Outline { start, segments: points.map(Segment::Line).collect() }))
}

/// A quarter of an ellipse around the corner of its box.
fn quarter(corner: Point, end: Point) -> Segment {
    Segment::Conic([corner, end], FRAC_1_SQRT_2)
}

fn ellipse(node: Node<'_, '_>, [rx, ry]: [f64; 2]) -> Result<Vec<Outline>, Problem> {
    if rx == 0.0 || ry == 0.0 {
        return Ok(Vec::new());
    }
    let [x, y] = [length(node, "cx")?.unwrap_or(0.0), length(node, "cy")?.unwrap_or(0.0)];
    let at = |i: f64, j: f64| vector![x + i * rx, y + j * ry];
    let segments = vec![
        quarter(at(1.0, 1.0), at(0.0, 1.0)),
        quarter(at(-1.0, 1.0), at(-1.0, 0.0)),
        quarter(at(-1.0, -1.0), at(0.0, -1.0)),
        quarter(at(1.0, -1.0), at(1.0, 0.0)),
    ];
    Ok(vec![Outline { start: at(1.0, 0.0), segments }])
}

fn rectangle(node: Node<'_, '_>) -> Result<Vec<Outline>, Problem> {
    let (width, height) = (size(node, "width")?.unwrap_or(0.0), size(node, "height")?.unwrap_or(0.0));
    if width == 0.0 || height == 0.0 {
        return Ok(Vec::new());
    }
    let [x, y] = [length(node, "x")?.unwrap_or(0.0), length(node, "y")?.unwrap_or(0.0)];
    let (rx, ry) = (size(node, "rx")?, size(node, "ry")?);
    let rx_found = rx.or(ry).unwrap_or(0.0).min(width / 2.0);
    let ry_found = ry.or(rx).unwrap_or(0.0).min(height / 2.0);
    let (right, below) = (x + width, y + height);
    if rx_found == 0.0 || ry_found == 0.0 {
        let corners = [vector![right, y], vector![right, below], vector![x, below], vector![x, y]];
        return Ok(vec![Outline { start: vector![x, y], segments: corners.map(Segment::Line).to_vec() }]);
    }
    let (left_in, right_in) = (x + rx_found, right - rx_found);
    let (top_in, below_in) = (y + ry_found, below - ry_found);
    let sides = [
        (vector![right_in, y], vector![right, y], vector![right, top_in]),
        (vector![right, below_in], vector![right, below], vector![right_in, below]),
        (vector![left_in, below], vector![x, below], vector![x, below_in]),
        (vector![x, top_in], vector![x, y], vector![left_in, y]),
    ];
    let mut outline = Outline::at(vector![left_in, y]);
    for (side, corner, end) in sides {
        if side != outline.end() {
            outline.segments.push(Segment::Line(side));
        }
        outline.segments.push(quarter(corner, end));
    }
    Ok(vec![outline])
}
