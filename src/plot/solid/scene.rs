//! Scenes: meshes and lines in space, and their pictures.

use crate::error::{Error, Result};
use crate::plot::solid::Point3;
use crate::plot::solid::color_map::linear;
use crate::plot::solid::image::{Image, check_size};
use crate::plot::solid::light::Light;
use crate::plot::solid::mesh::Mesh;
use crate::plot::solid::paint::{GREY, Paint};
use crate::plot::solid::raster::Raster;
use crate::plot::solid::view::{Projection, View};
use crate::plot::style::Color;

/// No picture may have more pixels.
const LARGEST: usize = 1 << 24;
/// So many pixels are drawn at a time, since each takes much more memory while it is.
const BAND: usize = 1 << 20;
/// By how much of the longer side of the picture lines are lifted towards the eye, to lie on surfaces and not in them.
const LIFT: f64 = 2e-3;
/// Colours are looked up in this many steps.
const STEPS: usize = 1024;

/// Meshes and lines to be looked at. See the [module](crate::plot::solid) for an example.
#[derive(Clone, Debug, Default)]
#[must_use]
pub struct Scene<'a> {
    meshes: Vec<(&'a Mesh, Paint)>,
    lines: Vec<Line>,
}

#[derive(Clone, Debug)]
struct Line {
    points: Vec<Point3>,
    color: Color,
    width: f64,
    /// In units of [`LIFT`]: the same for all lines, more for what lies on them.
    lift: f64,
}

impl<'a> Scene<'a> {
    /// A scene with nothing in it.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a mesh: painted in a [`Color`], or by the values of its vertices in a `&`[`ColorScale`](crate::plot::ColorScale).
    pub fn mesh(mut self, mesh: &'a Mesh, paint: impl Into<Paint>) -> Self {
        self.meshes.push((mesh, paint.into()));
        self
    }

    /// Adds a line through points, `width` pixels of the picture wide. It is hidden where a mesh is in front of it.
    pub fn line(mut self, points: impl IntoIterator<Item = Point3>, color: Color, width: f64) -> Self {
        self.lines.push(Line { points: points.into_iter().collect(), color, width, lift: 1.0 });
        self
    }

    /// Adds lines, as [`line`](Self::line) does.
    pub fn lines(
        self,
        lines: impl IntoIterator<Item = impl IntoIterator<Item = Point3>>,
        color: Color,
        width: f64,
    ) -> Self {
        lines.into_iter().fold(self, |scene, points| scene.line(points, color, width))
    }

    /// Adds round dots, `width` pixels of the picture wide, hidden as lines are, and in front of these.
    pub fn dots(mut self, points: impl IntoIterator<Item = Point3>, color: Color, width: f64) -> Self {
        let dot = |point| Line { points: vec![point; 2], color, width, lift: 2.0 };
        self.lines.extend(points.into_iter().map(dot));
        self
    }

    /// The picture of the scene on white.
    ///
    /// In a figure a picture is sharp if it has about twice the pixels it takes there.
    ///
    /// # Errors
    /// [`Error::Drawing`] for an empty scene, sizes or widths that are impossible, or coordinates too far apart;
    /// [`Error::NotFinite`] for a point of a line.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::plot::{Color, Mesh, Scene, View};
    /// let corners = vec![vector![0.0, 0.0, 0.0], vector![1.0, 0.0, 0.0], vector![1.0, 1.0, 0.0], vector![0.0, 1.0, 0.0]];
    /// let square = Mesh::new(corners.clone(), [[0, 1, 2, 3]])?;
    /// let scene = Scene::new().mesh(&square, Color::SKY).line(corners, Color::BLACK, 2.0);
    /// let image = scene.image(&View::new(-60.0, 40.0), 320, 200)?;
    /// assert_eq!(image.pixels()[0], Color::WHITE);
    /// assert_ne!(image.pixels()[100 * 320 + 160], Color::WHITE);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn image(&self, view: &View, width: usize, height: usize) -> Result<Image> {
        check_size(width, height)?;
        if width * height > LARGEST {
            return Err(Error::Drawing {
                message: format!("a picture of {width} x {height} px is too large"),
            });
        }
        self.check()?;
        let lines = self.lines.iter().flat_map(|line| &line.points);
        let points = self.meshes.iter().flat_map(|(mesh, _)| mesh.positions()).chain(lines);
        let projection = view.projection((width, height), points)?;
        let (rows, lift) = ((BAND / width).max(1), LIFT * width.max(height) as f64);
        let mut pixels = Vec::with_capacity(width * height);
        for first in (0..height).step_by(rows) {
            let mut raster = Raster::new(width, first..height.min(first + rows), linear(Color::WHITE));
            for (mesh, paint) in &self.meshes {
                draw(&mut raster, mesh, paint, view, &projection);
            }
            for line in &self.lines {
                let places: Vec<_> = line.points.iter().map(|p| projection.place(p)).collect();
                for ends in places.windows(2) {
                    raster.line([ends[0], ends[1]], line.width, lift * line.lift, linear(line.color));
                }
            }
            pixels.extend(raster.pixels());
        }
        Image::new(width, pixels)
    }

    fn check(&self) -> Result<()> {
        for line in &self.lines {
            if !(0.0..=1e3).contains(&line.width) {
                let message = format!("a line cannot be {:?} px wide: 0 to 1000 can", line.width);
                return Err(Error::Drawing { message });
            }
            let wrong = |p: &Point3| !p.iter().all(|x| x.is_finite());
            if let Some(index) = line.points.iter().position(wrong) {
                return Err(Error::NotFinite { what: "point of a line", index });
            }
        }
        Ok(())
    }
}

/// Draws a mesh: normals and values are interpolated, then lit and coloured sample by sample.
fn draw(raster: &mut Raster, mesh: &Mesh, paint: &Paint, view: &View, projection: &Projection) {
    let light = Light::new();
    let grey = linear(GREY);
    let places: Vec<_> = mesh.positions().iter().map(|p| projection.place(p)).collect();
    let normals: Vec<_> = mesh.normals().iter().map(|n| view.turned(n)).collect();
    let (shades, limits) = match paint {
        Paint::Plain(color) => (vec![linear(*color)], None),
        Paint::Values(scale) => {
            let shade = |i: usize| scale.map().linear_at(i as f64 / STEPS as f64);
            ((0..=STEPS).map(shade).collect(), Some(scale))
        }
    };
    // Where in the table the colour of a vertex lies.
    let spot = |value: &Option<f64>| match limits {
        Some(scale) => value.map(|value| scale.place(value).clamp(-9.0, 9.0) * STEPS as f64),
        None => Some(0.0),
    };
    let spots: Vec<_> = mesh.values().iter().map(spot).collect();
    for corners in mesh.triangles() {
        let (n, s) = (corners.map(|i| normals[i]), corners.map(|i| spots[i]));
        raster.triangle(corners.map(|i| places[i]), |weights| {
            let normal = n[0] * weights[0] + n[1] * weights[1] + n[2] * weights[2];
            let color = mixed(s, weights)
                .map_or(grey, |spot| shades[(spot.max(0.0).round() as usize).min(shades.len() - 1)]);
            light.on(color, &normal)
        });
    }
}

/// The mean of what is known, if that is at least half.
fn mixed(values: [Option<f64>; 3], weights: [f64; 3]) -> Option<f64> {
    if let [Some(a), Some(b), Some(c)] = values {
        return Some(a * weights[0] + b * weights[1] + c * weights[2]);
    }
    let known = values.into_iter().zip(weights).filter_map(|(value, weight)| Some((value?, weight)));
    let (sum, weight) =
        known.fold((0.0, 0.0), |(sum, all), (value, weight)| (sum + value * weight, all + weight));
    (weight >= 0.5).then(|| sum / weight)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::solid::color_map::ColorMap;
    use crate::plot::solid::color_scale::ColorScale;
    use nalgebra::vector;

    fn square(z: f64) -> Mesh {
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| vector![x, y, z]);
        Mesh::new(corners.to_vec(), [[0, 1, 2, 3]]).unwrap()
    }

    fn from_above() -> View {
        View::new(-90.0, 90.0)
    }

    #[test]
    fn values_are_seen() {
        let mesh = square(0.0).with_values([-1.0, 1.0, 1.0, -1.0].map(Some)).unwrap();
        let scale = ColorScale::new(ColorMap::diverging(), -1.0, 1.0).unwrap();
        let image = Scene::new().mesh(&mesh, &scale).image(&from_above(), 100, 100).unwrap();
        let at = |x: usize| image.pixels()[50 * 100 + x];
        assert!(at(8).blue > at(8).red && at(91).red > at(91).blue);
        assert!(at(50).red.abs_diff(at(50).blue) < 25);
        let grey = Scene::new().mesh(&square(0.0), &scale).image(&from_above(), 9, 9).unwrap();
        let pixel = grey.pixels()[40];
        assert!(pixel.red == pixel.green && pixel.green == pixel.blue && pixel.red < 250);
    }

    #[test]
    fn what_is_above_hides_what_is_below() {
        let (low, high) = (square(0.0), square(1.0));
        let scene = |first, second| Scene::new().mesh(first, Color::BLUE).mesh(second, Color::BLUE);
        let line = |scene: Scene<'_>, z: f64| {
            let ends = [vector![-1.0, 0.0, z], vector![1.0, 0.0, z]];
            scene.line(ends, Color::BLACK, 2.0).image(&from_above(), 60, 60).unwrap().pixels()[30 * 60 + 30]
        };
        assert_ne!(line(scene(&low, &high), 0.5), Color::BLACK);
        assert_eq!(line(scene(&high, &low), 1.0), Color::BLACK);
        assert_eq!(line(scene(&low, &high), 2.0), Color::BLACK);
    }

    #[test]
    fn impossible_pictures_are_refused() {
        let mesh = square(0.0);
        let scene = Scene::new().mesh(&mesh, Color::BLUE);
        for (width, height) in [(0, 10), (10, 0), (1 << 20, 10), (8192, 8192)] {
            assert!(matches!(scene.image(&from_above(), width, height), Err(Error::Drawing { .. })));
        }
        assert!(matches!(Scene::new().image(&from_above(), 10, 10), Err(Error::Drawing { .. })));
        let nan = scene.clone().line([vector![0.0, f64::NAN, 0.0]], Color::BLUE, 1.0);
        let refused = nan.image(&from_above(), 10, 10);
        assert_eq!(refused, Err(Error::NotFinite { what: "point of a line", index: 0 }));
        let wide = scene.line([vector![0.0, 0.0, 0.0]], Color::BLUE, f64::NAN);
        assert!(matches!(wide.image(&from_above(), 10, 10), Err(Error::Drawing { .. })));
        assert!(matches!(
            Scene::new().mesh(&mesh, Color::BLUE).image(&View::new(f64::NAN, 0.0), 9, 9),
            Err(Error::Drawing { .. })
        ));
    }

    #[test]
    fn very_large_and_very_small_scenes_are_seen() {
        for size in [1e300, 1e-300] {
            let corners: Vec<Point3> = square(0.0).positions().iter().map(|p| p * size).collect();
            let mesh = Mesh::new(corners, [[0, 1, 2, 3]]).unwrap();
            let image = Scene::new().mesh(&mesh, Color::BLUE).image(&from_above(), 20, 20).unwrap();
            assert_ne!(image.pixels()[210], Color::WHITE);
        }
    }
}
