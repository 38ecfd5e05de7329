//! The figure: panels below each other, as SVG or PNG.

use std::path::Path;

use crate::error::{Error, Result};
use crate::io::file::write;
use crate::plot::draw::drawn;
use crate::plot::layout::layout;
use crate::plot::panel::Panel;
use crate::plot::png::png;

/// Panels below each other, with plot areas that begin and end at the same x.
///
/// The height follows from the panels. See the [module](crate::plot) for an example.
#[derive(Clone, Debug)]
#[must_use]
pub struct Figure {
    width: f64,
    title: String,
    panels: Vec<Panel>,
}

impl Figure {
    /// A figure without panels, `width` pixels wide at scale 1. 640 to 800 suit the sizes of the letters.
    pub fn new(width: f64) -> Self {
        Self { width, title: String::new(), panels: Vec::new() }
    }

    /// Sets the title, centred at the top.
    pub fn title(self, title: impl Into<String>) -> Self {
        Self { title: title.into(), ..self }
    }

    /// Adds a panel below the others.
    pub fn panel(mut self, panel: Panel) -> Self {
        self.panels.push(panel);
        self
    }

    /// The figure as SVG text.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if a coordinate is NaN or infinite, with its place in its series.
    /// [`Error::Drawing`] if a range is empty, a size or a style impossible, or the figure too narrow for its
    /// labels.
    ///
    /// # Examples
    /// ```
    /// # use symspline::{error::Error, plot::{Color, Figure, Panel}};
    /// let panel = Panel::new().polyline([(0.0, 0.0), (1.0, f64::NAN)], Color::BLUE);
    /// let refused = Figure::new(640.0).panel(panel).to_svg();
    /// assert_eq!(refused, Err(Error::NotFinite { what: "polyline point", index: 1 }));
    /// ```
    pub fn to_svg(&self) -> Result<String> {
        if !(1.0..=16384.0).contains(&self.width) {
            let message = format!("a figure cannot be {:?} px wide: 1 to 16384 can", self.width);
            return Err(Error::Drawing { message });
        }
        self.panels.iter().try_for_each(Panel::check)?;
        let layout = layout(&self.title, self.width, &self.panels)?;
        drawn(&layout, &self.panels)
    }

    /// The figure as the bytes of a PNG file, `scale` pixels for each pixel of the figure.
    ///
    /// # Errors
    /// Those of [`Figure::to_svg`], and [`Error::Drawing`] if the picture had no pixels, a side longer than
    /// 16384 pixels, or more than 100 million pixels.
    pub fn to_png(&self, scale: f64) -> Result<Vec<u8>> {
        png(&self.to_svg()?, scale)
    }

    /// Writes the SVG text to a file and creates its folder if need be.
    ///
    /// # Errors
    /// Those of [`Figure::to_svg`], and [`Error::Io`] if the file cannot be written.
    pub fn write_svg(&self, path: impl AsRef<Path>) -> Result<()> {
        write(path.as_ref(), self.to_svg()?.as_bytes())
    }

    /// Writes the PNG file and creates its folder if need be.
    ///
    /// # Errors
    /// Those of [`Figure::to_png`], and [`Error::Io`] if the file cannot be written.
    pub fn write_png(&self, path: impl AsRef<Path>, scale: f64) -> Result<()> {
        write(path.as_ref(), &self.to_png(scale)?)
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use resvg::{tiny_skia, usvg};

    use super::*;
    use crate::plot::solid::{ColorMap, ColorScale, Image};
    use crate::plot::style::{Color, Marker, Style};
    use crate::plot::text::options;
    use kurbo::BezPath;

    fn rich() -> Figure {
        let wave = |i: i32| (f64::from(i) / 10.0, (f64::from(i) / 5.0).sin());
        let teeth = (0..40).map(|i| (wave(i), (wave(i).0, 1.5 * wave(i).1)));
        let panel = Panel::new()
            .comb(teeth, Color::PURPLE)
            .path(BezPath::from_svg("M0 0C0 4 4 4 4 0L2 -3Z").unwrap(), Style::line(Color::BLUE))
            .marked_polyline((0..5).map(wave), Marker::Square, Color::GRAY)
            .markers([(4.0, 3.0), (-1.0, -3.0)], Marker::Diamond, Style::area(Color::GREEN))
            .markers([(4.2, 3.1)], Marker::Circle, Color::GREEN)
            .segments([((0.0, 0.0), (4.3, -3.2))], Color::SKY)
            .knots([0.0, 0.0, 0.0, 1.0, 4.4], Color::BLACK)
            .text((4.0, 3.0), "a < b & c", Color::BLACK)
            .label("text");
        Figure::new(600.0).title("<Title> & \"more\"").panel(panel.clone()).panel(panel.equal_axes())
    }

    fn parsed(svg: &str) -> usvg::Tree {
        usvg::Tree::from_str(svg, &options()).unwrap()
    }

    fn clipped_groups(tree: &usvg::Tree) -> Vec<&usvg::Group> {
        let nodes = tree.root().children().iter();
        let groups = nodes.filter_map(|node| match node {
            usvg::Node::Group(group) => Some(&**group),
            _ => None,
        });
        groups.filter(|group| group.clip_path().is_some()).collect()
    }

    #[test]
    fn every_series_lies_inside_its_plot_area() {
        let svg = rich().to_svg().unwrap();
        let tree = parsed(&svg);
        let groups = clipped_groups(&tree);
        assert_eq!(groups.len(), 2);
        for group in groups {
            let area = group.clip_path().unwrap().root().abs_bounding_box();
            assert!(group.children().len() >= 14);
            for child in group.children() {
                let drawn = child.abs_stroke_bounding_box();
                // Knots stand on the frame; half of it lies outside.
                assert!(drawn.left() > area.left() && drawn.right() < area.right());
                assert!(drawn.top() > area.top() && drawn.bottom() < area.bottom() + 0.01, "{drawn:?}");
            }
        }
    }

    #[test]
    fn paths_keep_their_coordinates() {
        let path = BezPath::from_svg("M0 0C0.25 1 0.75 1 1 0").unwrap();
        let panel = Panel::new().path(path, Color::BLUE).x_range(0.0, 1.0).y_range(0.0, 1.0).height(100.0);
        let layout = layout("", 600.0, std::slice::from_ref(&panel)).unwrap();
        let (area, n) = (layout.frames[0].area, crate::plot::svg::number);
        let at = |x: f64, y: f64| format!("{},{}", n(area.x0 + x * area.width()), n(area.y1 - y * 100.0));
        let expected =
            format!("d=\"M{}C{} {} {}\"", at(0.0, 0.0), at(0.25, 1.0), at(0.75, 1.0), at(1.0, 0.0));
        let svg = Figure::new(600.0).panel(panel).to_svg().unwrap();
        assert!(svg.contains(&expected), "{expected} in {svg}");
    }

    #[test]
    fn texts_are_escaped() {
        let svg = rich().to_svg().unwrap();
        assert!(svg.contains("&lt;Title&gt; &amp; &quot;more&quot;") && svg.contains("a &lt; b &amp; c"));
    }

    #[test]
    fn nothing_unfinite_is_drawn() {
        let bad = Panel::new().knots([0.0, 1.0, f64::INFINITY], Color::BLUE);
        let refused = rich().panel(bad).to_png(1.0);
        assert_eq!(refused, Err(Error::NotFinite { what: "knot", index: 2 }));
        assert!(matches!(Figure::new(f64::NAN).to_svg(), Err(Error::Drawing { .. })));
    }

    #[test]
    fn png_has_the_promised_size() {
        let svg = rich().to_svg().unwrap();
        let size = parsed(&svg).size();
        let png = rich().to_png(1.5).unwrap();
        let side = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
        assert_eq!(&png[1..4], b"PNG");
        assert_eq!((side(16), side(20)), (900, (size.height() * 1.5).round() as u32));
        for scale in [0.0, -1.0, f64::NAN, f64::INFINITY, 100.0] {
            assert!(matches!(rich().to_png(scale), Err(Error::Drawing { .. })));
        }
    }

    fn pictures() -> Panel {
        let image = |color| Image::new(40, vec![color; 40 * 30]).unwrap();
        let scale = ColorScale::new(ColorMap::diverging(), -2.0, 2.0).unwrap();
        let panel = Panel::new().title("Pictures").x_label("below");
        let panel = panel.picture("one", image(Color::BLUE)).picture("two", image(Color::GREEN));
        panel.color_bar(&scale, "value")
    }

    #[test]
    fn pictures_and_color_bars_are_drawn() {
        let figure = Figure::new(500.0).panel(rich().panels[0].clone()).panel(pictures().x_from_above());
        let pixels = tiny_skia::Pixmap::decode_png(&figure.to_png(1.0).unwrap()).unwrap();
        // A gradient meets the colours of its ends only nearly.
        let count = |color: Color| {
            let near = |p: &&tiny_skia::PremultipliedColorU8| {
                let off = |found: u8, wanted: u8| found.abs_diff(wanted) <= 16;
                off(p.red(), color.red) && off(p.green(), color.green) && off(p.blue(), color.blue)
            };
            pixels.pixels().iter().filter(near).count()
        };
        // Each takes about a third of the width.
        assert!(count(Color::BLUE) > 12_000 && count(Color::GREEN) > 12_000);
        assert!(count(ColorMap::diverging().at(0.0)) > 5 && count(ColorMap::diverging().at(1.0)) > 5);
        let svg = figure.to_svg().unwrap();
        for text in ["one", "two", "value", "Pictures", "below", "−2"] {
            assert!(svg.contains(&format!(">{text}</text>")), "{text}");
        }
    }

    #[test]
    fn pictures_are_not_drawn_on_axes() {
        let mixed = pictures().polyline([(0.0, 0.0), (1.0, 1.0)], Color::BLUE);
        assert!(matches!(Figure::new(500.0).panel(mixed).to_svg(), Err(Error::Drawing { .. })));
        let bar =
            Panel::new().color_bar(&ColorScale::new(ColorMap::sequential(), 0.0, 1.0).unwrap(), "alone");
        assert!(Figure::new(300.0).panel(bar).panel(pictures().height(60.0)).to_png(1.0).is_ok());
    }

    #[test]
    fn empty_figures_are_fine() {
        assert!(Figure::new(300.0).to_png(1.0).is_ok());
        let dots = Panel::new().markers([(2.0, 3.0)], Marker::Tick, Color::BLUE);
        assert!(Figure::new(300.0).panel(Panel::new()).panel(dots).panel(Panel::new()).to_png(1.0).is_ok());
    }

    #[test]
    fn odd_data_are_drawn_or_refused() {
        let odd = [0.0, -0.0, 1.0, 1.0 + 1e-15, -3e-9, 1e-320, 1e-300, 1e17, -1e300, f64::MAX, f64::MIN];
        for (a, b) in odd.into_iter().flat_map(|a| odd.map(|b| (a, b))) {
            let plane = Panel::new().polyline([(a, b), (b, 1.0), (a, -a)], Color::BLUE);
            for panel in [plane.clone(), plane.equal_axes()] {
                match Figure::new(400.0).panel(panel).to_svg() {
                    Ok(svg) => assert!(!svg.contains("NaN") && !svg.contains("inf") && svg.len() < 20_000),
                    Err(error) => assert!(matches!(error, Error::Drawing { .. }), "{a:?} {b:?}: {error}"),
                }
            }
        }
    }

    #[test]
    fn folders_are_created() {
        let folder = std::env::temp_dir().join(format!("symspline-plot-{}", std::process::id()));
        let file = folder.join("deep/figure.svg");
        rich().write_svg(&file).unwrap();
        assert_eq!(fs::read_to_string(&file).unwrap(), rich().to_svg().unwrap());
        assert!(matches!(rich().write_svg(file.join("below a file.svg")), Err(Error::Io { .. })));
        fs::remove_dir_all(folder).unwrap();
    }
}
