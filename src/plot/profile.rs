//! Curvature profiles in panels: graphs, events, combs.

use crate::analysis::certify::Certified;
use crate::analysis::events::{Event, EventKind};
use crate::analysis::measure::Sample;
use crate::analysis::profile::CurvatureProfile;
use crate::error::Result;
use crate::plot::panel::Panel;
use crate::plot::style::{Color, Marker, Style};
use nalgebra::SVector;

/// How the kinds of events are marked, and what the legend calls them.
const MARKS: [(EventKind, Marker, &str); 8] = [
    (EventKind::Inflection, Marker::Circle, "inflection"),
    (EventKind::Maximum, Marker::Up, "maximum"),
    (EventKind::Minimum, Marker::Down, "minimum"),
    (EventKind::Jump, Marker::Cross, "jump of κ"),
    (EventKind::Cusp, Marker::Diamond, "cusp"),
    (EventKind::Corner, Marker::Square, "corner"),
    (EventKind::Stationary, Marker::Tick, "stationary"),
    (EventKind::Gap, Marker::Tick, "gap"),
];

impl Panel {
    /// Draws the curvature over the parameter; where it jumps the line is broken. A label names the whole of it.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::plot::{Color, Figure, Panel};
    /// use symspline::{Analyse, ellipse};
    /// let profile = ellipse(&vector![0.0, 0.0], &vector![2.0, 0.0], &vector![0.0, 1.0])?.profile()?;
    /// let panel = Panel::new().curvature(&profile, Color::BLUE).label("ellipse").events(&profile, Color::BLUE, true);
    /// assert!(Figure::new(480.0).panel(panel).to_svg()?.contains("maximum"));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn curvature<T: Certified>(self, profile: &CurvatureProfile<T>, style: impl Into<Style>) -> Self {
        let style = style.into();
        let points = |run: &[Sample]| run.iter().map(|s| (s.parameter, s.curvature)).collect::<Vec<_>>();
        // Samples at one parameter are the two sides of a knot.
        let breaks = |one: &Sample, other: &Sample| {
            let size = one.curvature.abs().max(other.curvature.abs());
            one.parameter == other.parameter && (one.curvature - other.curvature).abs() > 1e-6 * size
        };
        let runs = profile.samples().chunk_by(|one, other| !breaks(one, other));
        runs.fold(self, |panel, run| panel.polyline(points(run), style))
    }

    /// Marks the events of a profile on its graph, those of one kind alike; with `named` the legend says what the marks
    /// mean.
    pub fn events<T: Certified>(self, profile: &CurvatureProfile<T>, color: Color, named: bool) -> Self {
        let place = |event: &Event<T>| {
            let value = event.curvature[0].middle();
            Ok(vec![(middle(event), value), (middle(event), event.curvature[1].middle())])
        };
        self.marked(profile, color, named, place).expect("every event has a place on the graph")
    }

    /// Marks the events of a profile on the curve, whose points `at` gives.
    ///
    /// # Errors
    /// Those of `at`.
    pub fn events_along<T: Certified>(
        self,
        profile: &CurvatureProfile<T>,
        color: Color,
        named: bool,
        at: impl Fn(f64) -> Result<SVector<f64, 2>>,
    ) -> Result<Self> {
        self.marked(profile, color, named, |event| at(middle(event)).map(|point| vec![(point[0], point[1])]))
    }

    /// Draws the logarithmic curvature graph, `log10 ρ` against `log10 |ρ ds/dρ|`, as dots.
    pub fn log_curvature<T: Certified>(self, profile: &CurvatureProfile<T>, color: Color) -> Self {
        let dot = Style::area(color).marker_radius(1.2);
        self.markers(profile.log_log().into_iter().map(|[x, y]| (x, y)), Marker::Circle, dot)
            .x_label("log ρ")
            .y_label("log |ρ ds/dρ|")
    }

    fn marked<T: Certified>(
        self,
        profile: &CurvatureProfile<T>,
        color: Color,
        named: bool,
        places: impl Fn(&Event<T>) -> Result<Vec<(f64, f64)>>,
    ) -> Result<Self> {
        MARKS.into_iter().try_fold(self, |panel, (kind, marker, name)| {
            let of_kind = profile.events().iter().filter(|event| event.kind == kind);
            let mut points = Vec::new();
            for event in of_kind {
                points.extend(places(event)?);
            }
            points.dedup();
            if points.is_empty() {
                return Ok(panel);
            }
            let panel = panel.markers(points, marker, Style::line(color).width(1.2));
            Ok(if named { panel.label(name) } else { panel })
        })
    }
}

/// The middle of the place of an event.
fn middle<T: Certified>(event: &Event<T>) -> f64 {
    let (low, high) = event.place.bounds();
    low.ball().middle() * 0.5 + high.ball().middle() * 0.5
}
