//! From a layout to SVG: axes, series, legends.

use kurbo::{Point, Rect};

use crate::error::Result;
use crate::plot::header::{Entry, Placed};
use crate::plot::layout::{Frame, Layout, TICK};
use crate::plot::panel::Panel;
use crate::plot::scale::{KNOT, KNOT_GAP};
use crate::plot::series::{Data, Series, multiplicities};
use crate::plot::style::{Color, Dash, Marker, Style};
use crate::plot::svg::{Anchor, Face, Svg, number, outline, polyline};
use crate::plot::text::{SMALL, width};

const INK: Color = Color::new(38, 38, 38);
const FRAME: Style = Style::line(Color::new(120, 120, 120)).width(1.0);
const GRID: Style = Style::line(Color::new(230, 230, 230)).width(1.0);
const ZERO: Style = Style::line(Color::new(175, 175, 175)).width(1.0);

/// The SVG text of a figure.
///
/// # Errors
/// [`Error::Drawing`](crate::Error::Drawing) if there is no memory for a picture.
pub(super) fn drawn(layout: &Layout, panels: &[Panel]) -> Result<String> {
    let mut svg = Svg::new(layout.width, layout.height);
    block(&mut svg, &layout.title, Anchor::Middle, false);
    for (i, (panel, frame)) in panels.iter().zip(&layout.frames).enumerate() {
        if !panel.gallery.is_empty() {
            let hung = panel.gallery.hung(frame.area.width(), panel.height);
            hung.draw(&mut svg, frame.area.origin(), &format!("colors-{i}"))?;
            block(&mut svg, &frame.title, Anchor::Start, false);
            block(&mut svg, &frame.x_label, Anchor::Middle, false);
            continue;
        }
        grid(&mut svg, frame, !panel.equal_axes);
        svg.open_clipped(&format!("plot-{i}"), frame.area);
        for series in &panel.series {
            draw(&mut svg, frame, series);
        }
        svg.close();
        around(&mut svg, frame);
        for entry in &frame.legend {
            legend_entry(&mut svg, entry, &panel.series[entry.series]);
        }
        for series in &panel.series {
            annotation(&mut svg, frame, series);
        }
    }
    Ok(svg.finish())
}

/// Lines at the ticks, that of `y = 0` darker if asked.
fn grid(svg: &mut Svg, frame: &Frame, zero: bool) {
    let area = frame.area;
    let x_at = |value: f64| frame.place(Point::new(value, 0.0)).x;
    let y_at = |value: f64| frame.place(Point::new(0.0, value)).y;
    let upright = |x: f64| line(Point::new(x, area.y0), Point::new(x, area.y1));
    let level = |y: f64| line(Point::new(area.x0, y), Point::new(area.x1, y));
    let lines: String = frame.x_ticks.iter().map(|tick| upright(x_at(tick.value))).collect();
    svg.path(&lines, &GRID);
    let lines: String = frame.y_ticks.iter().map(|tick| level(y_at(tick.value))).collect();
    svg.path(&lines, &GRID);
    if zero && frame.y_ticks.iter().any(|tick| tick.value == 0.0) {
        svg.path(&level(y_at(0.0)), &ZERO);
    }
}

/// The frame, its ticks with numbers, title and labels.
fn around(svg: &mut Svg, frame: &Frame) {
    let area = frame.area;
    svg.path(&rectangle(area), &FRAME);
    let small = Face { size: SMALL, color: INK, anchor: Anchor::Middle, upright: false, rim: false };
    let mut marks = String::new();
    for tick in &frame.x_ticks {
        let x = frame.place(Point::new(tick.value, 0.0)).x;
        marks += &line(Point::new(x, area.y1), Point::new(x, area.y1 + TICK));
        if frame.numbered {
            let at = Point::new(x, area.y1 + TICK + 3.0 + 0.8 * SMALL);
            svg.line_of_text(at, &tick.label, &small);
        }
    }
    for tick in &frame.y_ticks {
        let y = frame.place(Point::new(0.0, tick.value)).y;
        marks += &line(Point::new(area.x0 - TICK, y), Point::new(area.x0, y));
        let at = Point::new(area.x0 - TICK - 4.0, y + 0.36 * SMALL);
        svg.line_of_text(at, &tick.label, &Face { anchor: Anchor::End, ..small });
    }
    svg.path(&marks, &FRAME);
    block(svg, &frame.title, Anchor::Start, false);
    block(svg, &frame.x_label, Anchor::Middle, false);
    block(svg, &frame.y_label, Anchor::Middle, true);
}

/// The lines of a text below each other, or to the right of each other if they run upwards.
fn block(svg: &mut Svg, text: &Placed, anchor: Anchor, upright: bool) {
    let face = Face { size: text.block.size, color: INK, anchor, upright, rim: false };
    for (i, words) in text.block.lines.iter().enumerate() {
        let step = i as f64 * text.block.leading();
        let (dx, dy) = if upright { (step, 0.0) } else { (0.0, step) };
        svg.line_of_text(Point::new(text.at.x + dx, text.at.y + dy), words, &face);
    }
}

/// A series inside its plot area; texts come later, on top.
fn draw(svg: &mut Svg, frame: &Frame, series: &Series) {
    let (style, area) = (&series.style, frame.area);
    let place = |point: &Point| frame.place(*point);
    match &series.data {
        Data::Path(path) => svg.path(&outline(path, |point| frame.place(point)), style),
        Data::Chain(points, None) => svg.path(&polyline(points.iter().map(place)), style),
        Data::Chain(points, Some(marker)) => {
            svg.path(&polyline(points.iter().map(place)), &Style { fill: None, ..*style });
            points.iter().for_each(|point| mark(svg, frame.place(*point), *marker, style));
        }
        Data::Markers(points, marker) => {
            points.iter().for_each(|point| mark(svg, frame.place(*point), *marker, style));
        }
        Data::Segments(pairs) => {
            let lines: String = pairs.iter().map(|(a, b)| line(place(a), place(b))).collect();
            svg.path(&lines, style);
        }
        Data::Comb(teeth) => {
            let lines: String = teeth.iter().map(|(foot, tip)| line(place(foot), place(tip))).collect();
            comb(svg, &lines, &polyline(teeth.iter().map(|(_, tip)| place(tip))), style);
        }
        Data::VLines(values) => {
            let at = |x: &f64| frame.place(Point::new(*x, 0.0)).x;
            let upright = |x: f64| line(Point::new(x, area.y1), Point::new(x, area.y0));
            svg.path(&values.iter().map(at).map(upright).collect::<String>(), style);
        }
        Data::HLines(values) => {
            let at = |y: &f64| frame.place(Point::new(0.0, *y)).y;
            let level = |y: f64| line(Point::new(area.x0, y), Point::new(area.x1, y));
            svg.path(&values.iter().map(at).map(level).collect::<String>(), style);
        }
        Data::Knots(values) => svg.path(&knots(frame, values), style),
        Data::Text(..) => {}
    }
}

/// Teeth thin and pale, the line along the tips as it is.
fn comb(svg: &mut Svg, teeth: &str, tips: &str, style: &Style) {
    let pale = Style { dash: Dash::Solid, fill: None, ..*style };
    svg.path(teeth, &pale.width(0.55 * style.width).opacity(0.55 * style.opacity));
    svg.path(tips, &Style { fill: None, ..*style });
}

/// Marks on the x axis, one above the other where a value repeats; a high stack is pressed together.
fn knots(frame: &Frame, values: &[f64]) -> String {
    let stacks = multiplicities(values);
    let highest = stacks.iter().map(|(_, m)| *m).max().unwrap_or(0) as f64 * (KNOT + KNOT_GAP);
    let press = (0.5 * frame.area.height() / highest).min(1.0);
    let mark = |x: f64, j: usize| {
        let foot = frame.area.y1 - j as f64 * press * (KNOT + KNOT_GAP);
        line(Point::new(x, foot), Point::new(x, foot - press * KNOT))
    };
    let stack = |(value, m): (f64, usize)| {
        let x = frame.place(Point::new(value, 0.0)).x;
        (0..m).map(|j| mark(x, j)).collect::<String>()
    };
    stacks.into_iter().map(stack).collect()
}

/// A marker at a pixel.
fn mark(svg: &mut Svg, at: Point, marker: Marker, style: &Style) {
    let r = style.marker_radius;
    let (x, y, n) = (at.x, at.y, number);
    let corner = |dx: f64, dy: f64| Point::new(x + dx, y + dy);
    let data = match marker {
        Marker::Circle => {
            let (r, d) = (n(r), n(2.0 * r));
            format!("M{},{}a{r},{r} 0 1 0 {d},0a{r},{r} 0 1 0 -{d},0Z", n(x - style.marker_radius), n(y))
        }
        Marker::Square => rectangle(Rect::new(x - 0.9 * r, y - 0.9 * r, x + 0.9 * r, y + 0.9 * r)),
        Marker::Diamond => {
            let r = 1.2 * r;
            polyline([corner(-r, 0.0), corner(0.0, -r), corner(r, 0.0), corner(0.0, r)]) + "Z"
        }
        Marker::Up | Marker::Down => {
            // Its centre of mass is the point.
            let (r, up) = (1.15 * r, if marker == Marker::Up { -1.15 * r } else { 1.15 * r });
            polyline([corner(-r, -0.6 * up), corner(0.0, up), corner(r, -0.6 * up)]) + "Z"
        }
        Marker::Cross => line(corner(-r, -r), corner(r, r)) + &line(corner(-r, r), corner(r, -r)),
        Marker::Tick => line(corner(0.0, r), corner(0.0, -r)),
    };
    let fill = Some(style.fill.unwrap_or(Color::WHITE));
    svg.path(&data, &Style { fill, dash: Dash::Solid, ..*style });
}

/// A sample of a series, and its name.
fn legend_entry(svg: &mut Svg, entry: &Entry, series: &Series) {
    let (style, left, wide) = (&series.style, entry.swatch, entry.swatch_width);
    let at = |dx: f64, dy: f64| Point::new(left.x + dx, left.y + dy);
    let middle = at(wide / 2.0, 0.0);
    let level = line(at(0.0, 0.0), at(wide, 0.0));
    let upright = line(at(wide / 2.0, 6.0), at(wide / 2.0, -6.0));
    match &series.data {
        Data::Path(_) | Data::Chain(_, None) if style.fill.is_some() => {
            svg.path(&rectangle(Rect::new(left.x, left.y - 5.0, left.x + wide, left.y + 5.0)), style);
        }
        Data::Path(_) | Data::Chain(_, None) | Data::HLines(_) | Data::Segments(_) => svg.path(&level, style),
        Data::Chain(_, Some(marker)) => {
            svg.path(&level, &Style { fill: None, ..*style });
            mark(svg, middle, *marker, style);
        }
        Data::Markers(_, marker) => mark(svg, middle, *marker, style),
        Data::Comb(_) => {
            let foot = |i: i32| at(wide * f64::from(i) / 6.0, 6.0);
            let tip = |i: i32| at(wide * f64::from(i) / 6.0, -1.0 - f64::from(i * (6 - i)) / 1.8);
            let teeth: String = (0..=6).map(|i| line(foot(i), tip(i))).collect();
            comb(svg, &teeth, &polyline((0..=6).map(tip)), style);
        }
        Data::VLines(_) => svg.path(&upright, style),
        Data::Knots(_) => svg.path(&line(at(wide / 2.0, 4.0), at(wide / 2.0, 4.0 - KNOT)), style),
        Data::Text(..) => {}
    }
    block(svg, &entry.text, Anchor::Start, false);
}

/// A text beside its point: right of it and above, unless the frame is too near.
fn annotation(svg: &mut Svg, frame: &Frame, series: &Series) {
    let Data::Text(at, text) = &series.data else { return };
    let (at, area) = (frame.place(*at), frame.area);
    if !area.inflate(0.5, 0.5).contains(at) {
        return;
    }
    let (long, gap) = (width(text, SMALL), 5.0);
    let (x, anchor) = if at.x + gap + long <= area.x1 {
        (at.x + gap, Anchor::Start)
    } else if at.x - gap - long >= area.x0 {
        (at.x - gap, Anchor::End)
    } else {
        (area.center().x, Anchor::Middle)
    };
    let y = if at.y - gap - SMALL - 2.0 >= area.y0 { at.y - gap } else { at.y + gap + 0.8 * SMALL };
    let color = series.style.stroke.unwrap_or(INK);
    svg.line_of_text(Point::new(x, y), text, &Face { size: SMALL, color, anchor, upright: false, rim: true });
}

fn line(a: Point, b: Point) -> String {
    polyline([a, b])
}

fn rectangle(area: Rect) -> String {
    let corners = [(area.x0, area.y0), (area.x1, area.y0), (area.x1, area.y1), (area.x0, area.y1)];
    polyline(corners.map(Point::from)) + "Z"
}
