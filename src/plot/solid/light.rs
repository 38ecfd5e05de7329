//! The light on a surface.
//!
//! With `n` the unit normal turned to the eye, a lamp at the upper left behind the eye, a weaker one at the right, and light
//! from all around, more from above:
//!
//! ```text
//! light = colour (around + lamp max(0, n·l) + weak max(0, n·k)) + gloss max(0, n·h)^40
//! ```
//!
//! The parts are chosen so that no face is so dark or so bright that its colour could not be read.

use crate::plot::solid::Point3;
use nalgebra::vector;

const AROUND: f64 = 0.36;
const ABOVE: f64 = 0.07;
const LAMP: f64 = 0.52;
const WEAK: f64 = 0.15;
const GLOSS: f64 = 0.10;

/// The lamps, as unit vectors in coordinates of the view.
#[derive(Clone, Copy, Debug)]
pub(super) struct Light {
    lamp: Point3,
    weak: Point3,
    /// Halfway between lamp and eye: where the surface faces it, it shines.
    shine: Point3,
}

impl Light {
    pub(super) fn new() -> Self {
        let lamp = vector![-0.45, 0.62, 0.65].normalize();
        let shine = (lamp + vector![0.0, 0.0, 1.0]).normalize();
        Self { lamp, weak: vector![0.75, -0.05, 0.45].normalize(), shine }
    }

    /// The light from a surface of a colour with a normal of any length, in coordinates of the view. Both sides are lit.
    pub(super) fn on(&self, color: [f64; 3], normal: &Point3) -> [f64; 3] {
        let length = normal.norm();
        let facing = if normal[2] < 0.0 { -length } else { length };
        // Where opposite normals meet there is none: as if it faced the eye.
        let n = if length > 0.0 { normal / facing } else { vector![0.0, 0.0, 1.0] };
        let part = |lamp: &Point3| n.dot(lamp).max(0.0);
        let plain = AROUND + ABOVE * n[1] + LAMP * part(&self.lamp) + WEAK * part(&self.weak);
        let gloss = GLOSS * part(&self.shine).powi(40);
        color.map(|x| x * plain + gloss)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_sides_are_lit_and_none_is_black() {
        let light = Light::new();
        for i in 0..200 {
            let (sin, cos) = (f64::from(i) * 0.37).sin_cos();
            let normal = vector![cos, sin * 0.6, sin * 0.8];
            let [red, ..] = light.on([0.8; 3], &normal);
            assert!((0.2..=0.95).contains(&red), "{red}");
            if normal[2] != 0.0 {
                assert_eq!(light.on([0.8; 3], &-normal), light.on([0.8; 3], &normal));
            }
        }
        assert!(light.on([0.5; 3], &vector![0.0, 0.0, 0.0])[0].is_finite());
    }

    #[test]
    fn faces_towards_the_lamp_are_brighter() {
        let light = Light::new();
        let bright = light.on([0.5; 3], &vector![-0.45, 0.62, 0.65])[1];
        assert!(bright > 1.5 * light.on([0.5; 3], &vector![0.6, -0.6, 0.5])[1]);
    }
}
