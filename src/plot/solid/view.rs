//! From where a scene is seen: a direction, and what part of space fills the picture.

use crate::error::{Error, Result};
use crate::plot::solid::Point3;
use crate::plot::solid::mesh::Mesh;
use crate::vector::unit;
use nalgebra::vector;

/// The part of the width and height of a picture that stays free on each side.
const MARGIN: f64 = 0.03;

/// A parallel projection. Without a [frame](View::framing) a picture shows all of its scene.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::plot::View;
/// // From the front and from above, the z axis upwards.
/// assert!((View::new(-90.0, 30.0).eye() - vector![0.0, -0.75_f64.sqrt(), 0.5]).norm() < 1e-15);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    right: Point3,
    up: Point3,
    /// Towards the eye.
    eye: Point3,
    frame: Option<Frame>,
}

/// A box in coordinates of the view: to the right, up.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Frame {
    low: [f64; 2],
    high: [f64; 2],
}

impl View {
    /// The view from an eye at `azimuth` degrees about the z axis, counted from the x axis towards y, and `elevation` degrees
    /// above the xy plane. The z axis points upwards in the picture.
    pub fn new(azimuth: f64, elevation: f64) -> Self {
        let ((sin_a, cos_a), (sin_e, cos_e)) =
            (azimuth.to_radians().sin_cos(), elevation.to_radians().sin_cos());
        Self {
            right: vector![-sin_a, cos_a, 0.0],
            up: vector![-sin_e * cos_a, -sin_e * sin_a, cos_e],
            eye: vector![cos_e * cos_a, cos_e * sin_a, sin_e],
            frame: None,
        }
    }

    /// The view from an eye in a direction, with `up` upwards in the picture.
    ///
    /// # Errors
    /// [`Error::Drawing`] if the two are parallel, zero, or no numbers.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::plot::View;
    /// let above = View::from(&vector![0.0, 0.0, 2.0], &vector![0.0, 1.0, 0.0])?;
    /// assert_eq!(above.eye(), vector![0.0, 0.0, 1.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn from(eye: &Point3, up: &Point3) -> Result<Self> {
        let axes = || {
            let (eye, up) = (unit(eye)?.0, unit(up)?.0);
            let right = up.cross(&eye);
            let (right, length) = unit(&right)?;
            (length > 1e-9).then(|| Self { right, up: eye.cross(&right), eye, frame: None })
        };
        axes().ok_or_else(|| Error::Drawing { message: "the view has no direction".into() })
    }

    /// The same view filled by the given meshes, for all pictures alike: before and after a change, say.
    ///
    /// # Errors
    /// [`Error::Drawing`] without vertices, or where they are too far apart.
    pub fn framing(self, meshes: &[&Mesh]) -> Result<Self> {
        let frame = self.frame_of(meshes.iter().flat_map(|mesh| mesh.positions()))?;
        Ok(Self { frame: Some(frame), ..self })
    }

    /// The unit vector towards the eye.
    pub fn eye(&self) -> Point3 {
        self.eye
    }

    /// A direction in coordinates of the view: right, up, towards the eye.
    pub(super) fn turned(&self, d: &Point3) -> Point3 {
        vector![self.right.dot(d), self.up.dot(d), self.eye.dot(d)]
    }

    fn frame_of<'a>(&self, points: impl Iterator<Item = &'a Point3>) -> Result<Frame> {
        let mut frame = Frame { low: [f64::INFINITY; 2], high: [f64::NEG_INFINITY; 2] };
        for p in points {
            for (k, x) in [self.right.dot(p), self.up.dot(p)].into_iter().enumerate() {
                frame.low[k] = frame.low[k].min(x);
                frame.high[k] = frame.high[k].max(x);
            }
        }
        match (0..2).all(|k| (frame.high[k] - frame.low[k]).is_finite()) {
            true => Ok(frame),
            false => Err(Error::Drawing { message: "nothing to see, or too far apart for f64".into() }),
        }
    }

    /// The projection to a picture, of the frame or else of all `points`.
    pub(super) fn projection<'a>(
        &self,
        (width, height): (usize, usize),
        points: impl Iterator<Item = &'a Point3>,
    ) -> Result<Projection> {
        let frame = self.frame.map_or_else(|| self.frame_of(points), Ok)?;
        let spans = [frame.high[0] - frame.low[0], frame.high[1] - frame.low[1]];
        let sides = [width, height].map(|side| side as f64 * (1.0 - 2.0 * MARGIN));
        let scale = (sides[0] / spans[0]).min(sides[1] / spans[1]);
        // A single point has no size.
        let scale = if spans == [0.0; 2] { 1.0 } else { scale };
        let centre = [0, 1].map(|k| frame.low[k] + spans[k] / 2.0);
        let projection = Projection { view: self.clone(), centre, scale, width, height };
        match scale.is_finite() && scale > 0.0 && scale.recip().is_finite() {
            true => Ok(projection),
            false => Err(Error::Drawing { message: "the scene is too small or too large for f64".into() }),
        }
    }
}

/// A view with a scale in pixels.
#[derive(Clone, Debug)]
pub(super) struct Projection {
    view: View,
    centre: [f64; 2],
    scale: f64,
    width: usize,
    height: usize,
}

impl Projection {
    /// The pixel of a point, from the upper left corner, and how near the point is, in pixels as well.
    pub(super) fn place(&self, p: &Point3) -> [f64; 3] {
        let [x, y, z] = <[f64; 3]>::from(self.view.turned(p));
        [
            self.width as f64 / 2.0 + (x - self.centre[0]) * self.scale,
            self.height as f64 / 2.0 - (y - self.centre[1]) * self.scale,
            z * self.scale,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_are_orthonormal_and_right_handed() {
        for (azimuth, elevation) in [(0.0, 0.0), (30.0, 20.0), (-130.0, -80.0), (12.0, 90.0)] {
            let view = View::new(azimuth, elevation);
            assert!((view.right.cross(&view.up) - view.eye).norm() < 1e-15);
            assert!((view.up.norm() - 1.0).abs() < 1e-15 && view.right[2] == 0.0);
        }
        let same = View::from(&View::new(30.0, 20.0).eye(), &vector![0.0, 0.0, 7.0]).unwrap();
        assert!((same.up - View::new(30.0, 20.0).up).norm() < 1e-15);
    }

    #[test]
    fn what_has_no_direction_is_refused() {
        let up = vector![0.0, 0.0, 1.0];
        for eye in [up, up * -2.0, vector![0.0, 0.0, 0.0], vector![f64::NAN, 0.0, 0.0]] {
            assert!(matches!(View::from(&eye, &up), Err(Error::Drawing { .. })));
        }
        assert!(matches!(View::new(0.0, 0.0).framing(&[]), Err(Error::Drawing { .. })));
    }

    #[test]
    fn a_scene_fills_its_picture() {
        let points = [vector![5.0, 10.0, -1.0], vector![5.0, 14.0, 1.0]];
        let projection = View::new(0.0, 0.0).projection((400, 300), points.iter()).unwrap();
        let [low, high] = points.map(|p| projection.place(&p));
        assert!((low[0] - 12.0).abs() < 1e-9 && (high[0] - 388.0).abs() < 1e-9);
        assert!((low[1] - 244.0).abs() < 1e-9 && (high[1] - 56.0).abs() < 1e-9);
        let huge = [vector![0.0, 1e308, 0.0], vector![0.0, -1e308, 0.0]];
        assert!(matches!(View::new(0.0, 0.0).projection((9, 9), huge.iter()), Err(Error::Drawing { .. })));
    }
}
