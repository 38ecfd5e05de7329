//! Projectors: curves and surfaces prepared for the nearest points of many points.

use crate::analysis::nearest::foot::{Foot, Nearest, Place};
use crate::analysis::nearest::islands::{Isle, groups};
use crate::analysis::nearest::jet;
use crate::analysis::nearest::pieces::{Axis, Lifted, Pieces};
use crate::analysis::nearest::ratio::Slopes;
use crate::analysis::nearest::search::{Ground, Room, Site, Spot, epsilon, least, within};
use crate::analysis::nearest::split::count;
use crate::analysis::nearest::square::Squaring;
use crate::analysis::nearest::tree::Tree;
use crate::error::{Error, Result};
use crate::ops::patch::Patch;
use crate::vector::length;
use nalgebra::SVector;
use std::marker::PhantomData;

/// The accuracy of [`Projector::foot`], relative to the sizes of coordinates: `2^-36`.
const FINE: f64 = 1.0 / (1_u64 << 36) as f64;

/// A point that is so many times farther away than all is large has no nearest point in floating point: `2^100`.
const FAR: f64 = (1_u128 << 100) as f64;

/// A curve (`X = f64`) or surface (`X = (f64, f64)`) prepared for the nearest points of many points.
///
/// It holds the Bernstein pieces, those that bend much in parts, and a tree of boxes around them.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::circle;
/// let projector = circle(&vector![0.0, 0.0], &2.0)?.projector()?;
/// let feet = projector.feet(&[vector![3.0, 0.0], vector![0.0, 0.5]])?;
/// assert!((feet[0].distance - 1.0).abs() < 1e-14 && (feet[1].distance - 1.5).abs() < 1e-14);
/// assert!((feet[1].point - vector![0.0, 2.0]).norm() < 1e-14);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Projector<X, const N: usize> {
    ground: Ground<N>,
    parameter: PhantomData<X>,
}

/// The size of rounding and the accuracy for one point, at unit size.
struct Question<const N: usize> {
    point: SVector<f64, N>,
    noise: f64,
    /// What is asked for.
    accuracy: f64,
    /// To what feet are found: at least to `FINE`, whatever is asked for, so that they are feet.
    fine: f64,
}

impl<X: Place, const N: usize> Projector<X, N> {
    pub(super) fn new<C: Lifted<N>, const D: usize>(
        patches: Vec<Patch<f64, D, C>>,
        axes: [Axis; 2],
    ) -> Result<Self> {
        let pieces = Pieces::new(patches, axes)?;
        let n = count(pieces.degrees);
        let quotient = |k: usize| match pieces.weights.get(k) {
            Some(weight) => pieces.points[k] / *weight,
            None => pieces.points[k],
        };
        let empty: (SVector<f64, N>, SVector<f64, N>) =
            (SVector::repeat(f64::INFINITY), SVector::repeat(f64::NEG_INFINITY));
        let around = |root: usize| {
            let points = (root * n..(root + 1) * n).map(quotient);
            points.fold(empty, |(low, high), c| (low.inf(&c), high.sup(&c)))
        };
        let boxes: Vec<_> = (0..pieces.roots.len()).map(around).collect();
        let (tree, squaring) = (Tree::new(&boxes), Squaring::new(pieces.degrees));
        let slopes = if pieces.weights.is_empty() { None } else { Slopes::new(pieces.degrees) };
        Ok(Self { ground: Ground { pieces, tree, squaring, slopes }, parameter: PhantomData })
    }

    /// A foot of `point`: no point is nearer by more than `2^-36` times the largest coordinates, of the spline and of
    /// `point`.
    ///
    /// Of several feet it is any one. After very much work, which takes adversaries, it may be farther.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a point that is not finite, or farther away than numbers go.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, SplineSpace};
    /// let points = vec![vector![-1.0, 1.0], vector![0.0, -1.0], vector![1.0, 1.0]];
    /// let parabola = Curve::new(SplineSpace::bezier(2, -1.0, 1.0)?, points)?; // y = x²
    /// let foot = parabola.projector()?.foot(&vector![0.0, -3.0])?;
    /// assert_eq!((foot.parameter, foot.distance), (0.0, 3.0));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn foot(&self, point: &SVector<f64, N>) -> Result<Foot<X, N>> {
        self.foot_in(&mut Room::default(), point)
    }

    /// A foot of each point, as [`foot`](Self::foot), in memory that is kept from one to the next.
    ///
    /// # Errors
    /// As [`foot`](Self::foot), for the first point that has an error.
    pub fn feet(&self, points: &[SVector<f64, N>]) -> Result<Vec<Foot<X, N>>> {
        let mut room = Room::default();
        points.iter().map(|point| self.foot_in(&mut room, point)).collect()
    }

    /// All feet of `point` within `accuracy` of the least distance, and a bound of that.
    ///
    /// - `feet[0].distance - bound <= accuracy`, if that is above rounding: about `4 (p + N)` units in the last place
    ///   of the largest coordinate, for surfaces with `p + q`. With spans so short that parameters are too coarse, or
    ///   after too much work, which takes adversaries, it may be more; the bound holds.
    /// - Feet are local minima of the distance, corners, both sides of jumps and ends of the domain included; at the
    ///   seam of a periodic spline there is one, at its start.
    /// - Where there are no single feet, [`Nearest::along`] tells where they are.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a point that is not finite, or farther away than numbers go; [`Error::BadTolerance`]
    /// unless the accuracy is positive and finite.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, SplineSpace, circle};
    /// let points = vec![vector![-1.0, 1.0], vector![0.0, -1.0], vector![1.0, 1.0]];
    /// let parabola = Curve::new(SplineSpace::bezier(2, -1.0, 1.0)?, points)?; // y = x²
    /// // On its axis: x² + (x² - 1)² is least for x² = 1/2.
    /// let nearest = parabola.projector()?.nearest(&vector![0.0, 1.0], 1e-9)?;
    /// assert_eq!(nearest.feet.len(), 2);
    /// assert!(nearest.feet.iter().all(|foot| (foot.parameter.abs() - 0.5_f64.sqrt()).abs() < 1e-9));
    ///
    /// let nearest = circle(&vector![0.0, 0.0], &2.0)?.projector()?.nearest(&vector![0.0, 0.0], 1e-9)?;
    /// assert_eq!((nearest.feet.len(), nearest.along), (1, vec![(0.0, 1.0)]));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn nearest(&self, point: &SVector<f64, N>, accuracy: f64) -> Result<Nearest<X, N>> {
        check_tolerance(accuracy)?;
        let Some(question) = self.question(point, Some(accuracy))? else { return self.seen_from_afar(point) };
        let mut room = Room::default();
        let (best, bound) =
            least(&self.ground, &mut room, question.point, (question.fine, question.accuracy));
        let level = best.distance + question.accuracy;
        let sites = within(&self.ground, &mut room, question.point, question.fine, level);
        let (feet, along) = self.told_apart(&question, best, sites, level)?;
        let scale = self.ground.pieces.scale;
        let bound = scale.up((bound.min(best.distance) - question.noise).max(0.0)).min(feet[0].distance);
        Ok(Nearest { feet, along, bound })
    }

    /// The parameters at which the spline passes within `tolerance` of `point`: of local minima of the distance,
    /// nearest first.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::BadTolerance`] as [`nearest`](Self::nearest); [`Error::TooFar`] if it does not
    /// come that near.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, Error, SplineSpace};
    /// // A loop through its start.
    /// let points = vec![vector![0.0, 0.0], vector![2.0, 2.0], vector![-2.0, 2.0], vector![0.0, 0.0]];
    /// let projector = Curve::new(SplineSpace::bezier(3, 0.0, 1.0)?, points)?.projector()?;
    /// assert_eq!(projector.parameters_of(&vector![0.0, 0.0], 1e-9)?, [0.0, 1.0]);
    /// assert!(matches!(projector.parameters_of(&vector![0.0, -1.0], 1e-9), Err(Error::TooFar { .. })));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn parameters_of(&self, point: &SVector<f64, N>, tolerance: f64) -> Result<Vec<X>> {
        check_tolerance(tolerance)?;
        let mut feet = match self.question(point, None)? {
            Some(question) => {
                let mut room = Room::default();
                let (best, _) =
                    least(&self.ground, &mut room, question.point, (question.fine, question.fine));
                let level = self.ground.pieces.scale.down(tolerance) + question.noise;
                let sites = if best.distance <= level {
                    within(&self.ground, &mut room, question.point, question.fine, level)
                } else {
                    Vec::new()
                };
                self.told_apart(&question, best, sites, level)?.0
            }
            None => self.seen_from_afar(point)?.feet,
        };
        let distance = feet[0].distance;
        if distance > tolerance {
            return Err(Error::TooFar { distance: distance.to_string(), tolerance: tolerance.to_string() });
        }
        feet.retain(|foot| foot.distance <= tolerance);
        Ok(feet.into_iter().map(|foot| foot.parameter).collect())
    }

    fn foot_in(&self, room: &mut Room<N>, point: &SVector<f64, N>) -> Result<Foot<X, N>> {
        let Some(question) = self.question(point, None)? else {
            return Ok(self.seen_from_afar(point)?.feet.remove(0));
        };
        let (best, _) = least(&self.ground, room, question.point, (question.fine, question.fine));
        self.foot_at(&question.point, best)
    }

    /// The point at unit size with an accuracy, if it is not too far away.
    fn question(&self, point: &SVector<f64, N>, accuracy: Option<f64>) -> Result<Option<Question<N>>> {
        if let Some(index) = point.iter().position(|x| !x.is_finite()) {
            return Err(Error::NotFinite { what: "coordinate", index });
        }
        let Pieces { scale, degrees, .. } = &self.ground.pieces;
        let point = point.map(|x| scale.down(x));
        let size = 1.0 + point.amax();
        if size.is_nan() || size > FAR {
            return Ok(None);
        }
        let noise = 2.0 * epsilon::<N>(*degrees) * size;
        let asked = accuracy.map_or(FINE * size, |accuracy| scale.down(accuracy)).max(4.0 * noise);
        Ok(Some(Question { point, noise, accuracy: asked, fine: asked.min(FINE * size).max(4.0 * noise) }))
    }

    /// From very far away all points are at the same distance.
    fn seen_from_afar(&self, point: &SVector<f64, N>) -> Result<Nearest<X, N>> {
        let Pieces { axes, scale, points, weights, .. } = &self.ground.pieces;
        let start = points[0] / weights.first().copied().unwrap_or(1.0);
        let start = start.map(|x| scale.up(x));
        let parameter = X::at(axes.each_ref().map(|axis| axis.domain.0));
        let foot = Foot { parameter, point: start, distance: finite(length(&(start - point)))? };
        let whole = (parameter, X::at(axes.each_ref().map(|axis| axis.domain.1)));
        Ok(Nearest { feet: vec![foot], along: vec![whole], bound: foot.distance * (1.0 - FINE) })
    }

    /// The feet among what was found, nearest first, and where there are no single ones.
    #[allow(clippy::type_complexity, reason = "the two lists of a value of `Nearest`")]
    fn told_apart(
        &self,
        question: &Question<N>,
        best: Spot,
        sites: Vec<Site>,
        level: f64,
    ) -> Result<(Vec<Foot<X, N>>, Vec<(X, X)>)> {
        let pieces = &self.ground.pieces;
        let own = [0, 1].map(|axis| (best.at[axis], best.at[axis]));
        let sites = [Site { spot: best, basin: own, sides: own }].into_iter().chain(sites);
        let isle = |site: Site| {
            let root = &pieces.roots[site.spot.root];
            let global = |sides: [(f64, f64); 2]| {
                [0, 1].map(|axis| (root.global(axis, sides[axis].0), root.global(axis, sides[axis].1)))
            };
            let at = self.parameter(site.spot);
            Isle {
                at,
                point: question.point + self.difference(&question.point, site.spot.root, at),
                distance: site.spot.distance,
                basin: global(site.basin),
                sides: global(site.sides),
                widths: [root.width(0), root.width(1)],
            }
        };
        let (spots, isles): (Vec<Spot>, Vec<Isle<N>>) = sites.map(|site| (site.spot, isle(site))).unzip();
        let groups = groups(&isles, &pieces.axes, 16.0 * question.noise);
        let near = groups.feet.iter().filter(|foot| spots[**foot].distance <= level || **foot == 0);
        let with_place = |foot: &usize| Ok((isles[*foot].at, self.foot_at(&question.point, spots[*foot])?));
        let mut feet = near.map(with_place).collect::<Result<Vec<_>>>()?;
        // Where the work did not suffice, the best point met may stand for a group after all.
        let best = with_place(&0)?;
        if feet.iter().all(|(_, foot)| foot.distance > best.1.distance) {
            feet.push(best);
        }
        // Of feet at the same distance those with smaller parameters come first.
        feet.sort_by(|(a, one), (b, other)| {
            one.distance.total_cmp(&other.distance).then(a[0].total_cmp(&b[0])).then(a[1].total_cmp(&b[1]))
        });
        let feet = feet.into_iter().map(|(_, foot)| foot).collect();
        let corners =
            |sides: [(f64, f64); 2]| (X::at(sides.map(|side| side.0)), X::at(sides.map(|side| side.1)));
        Ok((feet, groups.along.into_iter().map(corners).collect()))
    }

    /// The parameters of a spot, rounded to numbers of the domain.
    fn parameter(&self, spot: Spot) -> [f64; 2] {
        [0, 1].map(|axis| self.ground.pieces.roots[spot.root].global(axis, spot.at[axis]))
    }

    /// What has to be added to `point` to come to the point of piece `root` at parameters `at`.
    fn difference(&self, point: &SVector<f64, N>, root: usize, at: [f64; 2]) -> SVector<f64, N> {
        let pieces = &self.ground.pieces;
        let n = count(pieces.degrees);
        let own = root * n..(root + 1) * n;
        let t = [0, 1].map(|axis| pieces.roots[root].local(axis, at[axis]));
        let weights = pieces.weights.get(own.clone()).unwrap_or(&[]);
        let weight = |k: usize| weights.get(k).copied().unwrap_or(1.0);
        let points: Vec<_> =
            pieces.points[own].iter().enumerate().map(|(k, c)| c - point * weight(k)).collect();
        let value = jet::Room::default().jet(&points, pieces.degrees, t).value;
        if weights.is_empty() {
            return value;
        }
        value / jet::Room::default().jet(weights, pieces.degrees, t).value
    }

    /// The foot at a spot; the distance is the one at the parameter as it is rounded.
    fn foot_at(&self, point: &SVector<f64, N>, spot: Spot) -> Result<Foot<X, N>> {
        let Pieces { axes, scale, .. } = &self.ground.pieces;
        let at = self.parameter(spot);
        let difference = self.difference(point, spot.root, at);
        let distance = finite(scale.up(length(&difference)))?;
        let start = |axis: usize| {
            let Axis { domain: (a, b), periodic, torn } = &axes[axis];
            if *periodic && at[axis] == *b && !torn.contains(b) { *a } else { at[axis] }
        };
        let own = self.difference(&SVector::zeros(), spot.root, at).map(|x| scale.up(x));
        Ok(Foot { parameter: X::at([start(0), start(1)]), point: own, distance })
    }
}

fn check_tolerance(tolerance: f64) -> Result<()> {
    if tolerance.is_finite() && tolerance > 0.0 {
        return Ok(());
    }
    Err(Error::BadTolerance { tolerance: tolerance.to_string() })
}

fn finite(distance: f64) -> Result<f64> {
    if distance.is_finite() { Ok(distance) } else { Err(Error::NotFinite { what: "distance", index: 0 }) }
}
