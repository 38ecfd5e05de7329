//! Which colour a value has: a colour map with limits.
//!
//! Few values of a surface are often much larger than all others, as curvatures beside a pole are. So limits come from
//! shares: `share = 0.95` leaves one value in twenty beyond them, which get the colours of the ends. The values count as
//! many times as the vertices have area around them, so that a fine mesh at a pole does not count more than it shows.

use crate::error::{Error, Result};
use crate::plot::solid::color_map::ColorMap;
use crate::plot::solid::mesh::Mesh;

/// A colour map between two limits, the same for all pictures that are to be compared.
///
/// # Examples
/// ```
/// use symspline::plot::{ColorMap, ColorScale};
/// let scale = ColorScale::new(ColorMap::diverging(), -2.0, 2.0)?;
/// assert_eq!(scale.color(0.0), ColorMap::diverging().at(0.5));
/// assert_eq!(scale.color(100.0), scale.color(2.0));
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ColorScale {
    map: ColorMap,
    limits: (f64, f64),
    /// The least and the greatest value seen.
    extent: (f64, f64),
}

impl ColorScale {
    /// The scale between given limits.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::Drawing`] unless `low < high`, far enough apart to be told apart.
    pub fn new(map: ColorMap, low: f64, high: f64) -> Result<Self> {
        if let Some(index) = [low, high].iter().position(|limit| !limit.is_finite()) {
            return Err(Error::NotFinite { what: "limit of colours", index });
        }
        let least = 1e-12 * low.abs().max(high.abs());
        if (1e-290..=1e290).contains(&(high - low)) && high - low >= least {
            return Ok(Self { map, limits: (low, high), extent: (low, high) });
        }
        Err(Error::Drawing { message: format!("no colours between {low:?} and {high:?}") })
    }

    /// The diverging scale from `-m` to `m`, where `m` is the least number that the sizes of the given share of the values
    /// on all meshes do not exceed. Zero is white.
    ///
    /// # Errors
    /// [`Error::Drawing`] without values, or for a share outside `(0, 1]`.
    pub fn about_zero(meshes: &[&Mesh], share: f64) -> Result<Self> {
        check_share(share)?;
        let values = weighed(meshes)?;
        let sizes = values.iter().map(|(value, weight)| (value.abs(), *weight)).collect();
        let m = quantile(sizes, share);
        // Zero everywhere: any limit will do.
        let m = if m > 0.0 { m.max(1e-280) } else { 1.0 };
        Ok(Self::new(ColorMap::diverging(), -m, m)?.covering(meshes))
    }

    /// The sequential scale that leaves the same part of the values on all meshes beyond either limit, `1 - share` in sum.
    ///
    /// # Errors
    /// As [`about_zero`](Self::about_zero).
    pub fn rising(meshes: &[&Mesh], share: f64) -> Result<Self> {
        check_share(share)?;
        let values = weighed(meshes)?;
        let rest = (1.0 - share) / 2.0;
        let high = quantile(values.clone(), share + rest);
        let low =
            -quantile(values.into_iter().map(|(value, weight)| (-value, weight)).collect(), share + rest);
        let flat = high - low <= 1e-10 * low.abs().max(high.abs());
        let room = if high == 0.0 { 1.0 } else { high.abs() / 2.0 };
        let (low, high) = if flat { (low - room, high + room) } else { (low, high) };
        Ok(Self::new(ColorMap::sequential(), low, high)?.covering(meshes))
    }

    /// The same scale, which knows what values the meshes have: the colour bar shows whether any lie beyond its limits.
    #[must_use]
    pub fn covering(mut self, meshes: &[&Mesh]) -> Self {
        for value in meshes.iter().flat_map(|mesh| mesh.values()).flatten() {
            self.extent = (self.extent.0.min(*value), self.extent.1.max(*value));
        }
        self
    }

    /// The least and the greatest value with a colour of its own.
    pub fn limits(&self) -> (f64, f64) {
        self.limits
    }

    /// The colour map.
    pub fn map(&self) -> &ColorMap {
        &self.map
    }

    /// The colour of a value.
    pub fn color(&self, value: f64) -> crate::plot::Color {
        self.map.at(self.place(value))
    }

    /// Where a value lies between the limits: 0 at the lower one, 1 at the upper one.
    pub(super) fn place(&self, value: f64) -> f64 {
        (value - self.limits.0) / (self.limits.1 - self.limits.0)
    }

    /// Whether values lie below and above the limits, by more than rounding.
    #[cfg(feature = "plot")]
    pub(in crate::plot) fn clips(&self) -> (bool, bool) {
        let slack = 1e-9 * (self.limits.1 - self.limits.0);
        (self.extent.0 < self.limits.0 - slack, self.extent.1 > self.limits.1 + slack)
    }
}

/// All values, each with the area around its vertex.
fn weighed(meshes: &[&Mesh]) -> Result<Vec<(f64, f64)>> {
    let size = meshes.iter().flat_map(|mesh| mesh.positions()).flat_map(|p| p.iter());
    let size = size.fold(0.0, |size: f64, x| size.max(x.abs()));
    let mut values = Vec::new();
    for mesh in meshes {
        let mut weights = vec![0.0; mesh.positions().len()];
        for corners in mesh.triangles() {
            let [a, b, c] = corners.map(|i| mesh.positions()[i] / size);
            let area = (b - a).cross(&(c - a)).norm();
            corners.iter().for_each(|i| weights[*i] += area);
        }
        let pairs = mesh.values().iter().zip(weights);
        values.extend(pairs.filter_map(|(value, weight)| Some(((*value)?, weight))));
    }
    match values.is_empty() {
        true => Err(Error::Drawing { message: "a scale of colours needs values".into() }),
        false => Ok(values),
    }
}

fn check_share(share: f64) -> Result<()> {
    let refused =
        || Error::Drawing { message: format!("a share of {share:?} of the values is not in (0, 1]") };
    if share > 0.0 && share <= 1.0 { Ok(()) } else { Err(refused()) }
}

/// The least value that the given share of the weights does not exceed.
fn quantile(mut values: Vec<(f64, f64)>, share: f64) -> f64 {
    values.sort_by(|one, other| one.0.total_cmp(&other.0));
    let total: f64 = values.iter().map(|(_, weight)| weight).sum();
    if !(total.is_finite() && total > 0.0) {
        values.iter_mut().for_each(|(_, weight)| *weight = 1.0);
    }
    let total: f64 = values.iter().map(|(_, weight)| weight).sum();
    let mut sum = 0.0;
    let reached = values.iter().find(|(_, weight)| {
        sum += weight;
        sum >= share * total * (1.0 - 1e-12)
    });
    // Rounding may leave the sum below the total.
    let last = values.last().expect("there are values").0;
    if share == 1.0 { last } else { reached.map_or(last, |(value, _)| *value) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::vector;

    /// Twenty squares in a row, all of one value but the last corners.
    fn strip(values: impl Fn(usize) -> Option<f64>) -> Mesh {
        let points = (0..42).map(|i| vector![(i / 2) as f64, (i % 2) as f64, 0.0]).collect();
        let faces = (0..20).map(|i| [2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1]);
        Mesh::new(points, faces).unwrap().with_values((0..42).map(values)).unwrap()
    }

    #[test]
    fn outliers_are_clipped() {
        let mesh = strip(|i| Some(if i >= 40 { 1e6 } else { -(i as f64) / 40.0 }));
        let scale = ColorScale::about_zero(&[&mesh], 0.95).unwrap();
        assert!((0.9..1.0).contains(&scale.limits().1) && scale.limits().0 == -scale.limits().1);
        assert_eq!(scale.clips(), (true, true));
        assert_eq!(scale.color(1e6), scale.color(scale.limits().1));
        let whole = ColorScale::about_zero(&[&mesh], 1.0).unwrap();
        assert_eq!((whole.limits(), whole.clips()), ((-1e6, 1e6), (false, false)));
    }

    #[test]
    fn rising_scales_clip_both_ends() {
        let mesh = strip(|i| if i == 3 { None } else { Some(i as f64) });
        let scale = ColorScale::rising(&[&mesh], 0.8).unwrap();
        assert!((2.0..7.0).contains(&scale.limits().0) && (34.0..40.0).contains(&scale.limits().1));
        assert_eq!(scale.clips(), (true, true));
        let flat = ColorScale::rising(&[&strip(|_| Some(4.0))], 1.0).unwrap();
        assert_eq!(flat.limits(), (2.0, 6.0));
    }

    #[test]
    fn scales_need_values_and_limits() {
        assert!(matches!(ColorScale::about_zero(&[&strip(|_| None)], 0.9), Err(Error::Drawing { .. })));
        assert!(matches!(ColorScale::about_zero(&[], 0.9), Err(Error::Drawing { .. })));
        let mesh = strip(|_| Some(0.0));
        assert_eq!(ColorScale::about_zero(&[&mesh], 0.9).unwrap().limits(), (-1.0, 1.0));
        for share in [0.0, -1.0, 1.5, f64::NAN] {
            assert!(matches!(ColorScale::about_zero(&[&mesh], share), Err(Error::Drawing { .. })));
            assert!(matches!(ColorScale::rising(&[&mesh], share), Err(Error::Drawing { .. })));
        }
        let map = ColorMap::diverging;
        assert_eq!(
            ColorScale::new(map(), 0.0, f64::NAN),
            Err(Error::NotFinite { what: "limit of colours", index: 1 })
        );
        for (low, high) in [(1.0, 1.0), (2.0, 1.0), (-1e308, 1e308), (0.0, 1e-300)] {
            assert!(matches!(ColorScale::new(map(), low, high), Err(Error::Drawing { .. })));
        }
    }
}
