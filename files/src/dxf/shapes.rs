//! Lines, arcs and polylines as exact splines.

use crate::dxf::entity::Entity;
use crate::error::{Problem, Result};
use crate::nurbs::shapes::{Made, placed, polyline, segment};
use nalgebra::{Vector2, Vector3};
use std::f64::consts::TAU;
use symspline::{NurbsCurve, SplineSpace};
use symspline_dynamic::{AnyRational, AnySpline, Value};

/// Where the plane of a shape lies in space.
struct Frame {
    axes: [Vector3<f64>; 3],
    elevation: f64,
}

impl Frame {
    /// The frame that a normal gives by the rule of the arbitrary axis.
    fn of(entity: &Entity<'_>, elevation: f64) -> Result<Self> {
        let given = entity.vector(210)?.unwrap_or_else(Vector3::z);
        if given == Vector3::z() {
            return Ok(Self { axes: [Vector3::x(), Vector3::y(), given], elevation });
        }
        let zero = || entity.wrong("the normal (group 210) has no direction");
        let normal = given.try_normalize(0.0).filter(|n| n.iter().all(|x| x.is_finite())).ok_or_else(zero)?;
        let near = normal.x.abs() < 1.0 / 64.0 && normal.y.abs() < 1.0 / 64.0;
        let x = if near { Vector3::y() } else { Vector3::z() }.cross(&normal);
        let x = x.try_normalize(0.0).ok_or_else(zero)?;
        Ok(Self { axes: [x, normal.cross(&x), normal], elevation })
    }

    /// Whether it is the plane of the drawing.
    fn is_plane(&self) -> bool {
        self.axes[2] == Vector3::z() && self.elevation == 0.0
    }

    fn point(&self, p: &Vector2<f64>) -> Vector3<f64> {
        self.axes[0] * p.x + self.axes[1] * p.y + self.axes[2] * self.elevation
    }

    fn rational(&self, curve: NurbsCurve<f64, 2>) -> Made<Value> {
        if self.is_plane() {
            return Ok(AnyRational::from(curve).into());
        }
        Ok(AnyRational::from(placed(&curve, |p| self.point(p))?).into())
    }
}

impl Entity<'_> {
    /// The curve of a LINE.
    pub(super) fn line(&self) -> Result<Value> {
        let end = |code| self.vector(code)?.ok_or_else(|| self.wrong("an end is missing"));
        let (a, b): (Vector3<f64>, Vector3<f64>) = (end(10)?, end(11)?);
        segment(a, b).map_err(|error| self.failed(error))
    }

    /// The curve of an ARC or a CIRCLE.
    pub(super) fn arc(&self) -> Result<Value> {
        let centre = self.vector(10)?.ok_or_else(|| self.wrong("the centre is missing"))?;
        let (frame, radius) = (Frame::of(self, centre.z)?, self.needed(40, "the radius")?);
        if radius <= 0.0 {
            return Err(self.wrong(&format!("a radius of {radius} is not possible")));
        }
        let curve = if self.kind == "CIRCLE" {
            symspline::circle(&centre.xy(), &radius)
        } else {
            let (start, end) = (self.needed(50, "an angle")?, self.needed(51, "an angle")?);
            let degrees = match (end - start).rem_euclid(360.0) {
                0.0 => 360.0,
                sweep => sweep,
            };
            symspline::arc_by_angles(&centre.xy(), &radius, &start.to_radians(), &degrees.to_radians())
        };
        curve.and_then(|curve| frame.rational(curve)).map_err(|error| self.failed(error))
    }

    /// The curve of an ELLIPSE.
    pub(super) fn ellipse(&self) -> Result<Value> {
        let centre = self.vector(10)?.ok_or_else(|| self.wrong("the centre is missing"))?;
        let a = self.vector(11)?.ok_or_else(|| self.wrong("the major axis is missing"))?;
        let (ratio, normal) = (self.needed(40, "the ratio")?, Frame::of(self, 0.0)?.axes[2]);
        let b = normal.cross(&a) * ratio;
        let (start, end) = (self.real(41)?.unwrap_or(0.0), self.real(42)?.unwrap_or(TAU));
        let plane = normal == Vector3::z() && centre.z == 0.0 && a.z == 0.0;
        let made = || {
            if start == 0.0 && end == TAU {
                return Ok(match plane {
                    true => AnyRational::from(symspline::ellipse(&centre.xy(), &a.xy(), &b.xy())?),
                    false => AnyRational::from(symspline::ellipse(&centre, &a, &b)?),
                });
            }
            let sweep = match (end - start).rem_euclid(TAU) {
                0.0 => TAU,
                sweep => sweep,
            };
            let unit = symspline::arc_by_angles(&Vector2::zeros(), &1.0, &start, &sweep)?;
            let point = |p: &Vector2<f64>| centre + a * p.x + b * p.y;
            Ok(match plane {
                true => AnyRational::from(placed(&unit, |p| point(p).xy())?),
                false => AnyRational::from(placed(&unit, point)?),
            })
        };
        made().map(Value::from).map_err(|error: symspline::Error| self.failed(error))
    }

    /// The curve of a LWPOLYLINE.
    pub(super) fn polyline(&self) -> Result<Value> {
        let vertices = self.points(10, 42)?;
        self.counted(90, vertices.len(), "vertices")?;
        let frame = Frame::of(self, self.real(38)?.unwrap_or(0.0))?;
        let mut corners: Vec<Vector2<f64>> = vertices.iter().map(|(point, _)| point.xy()).collect();
        let mut bulges: Vec<f64> = vertices.iter().map(|(_, bulge)| bulge.unwrap_or(0.0)).collect();
        match self.whole(70)?.unwrap_or(0) & 1 {
            1 => corners.extend(corners.first().copied()),
            _ => drop(bulges.pop()),
        }
        if corners.len() < 2 {
            return Err(self.wrong("there are fewer than two vertices"));
        }
        let made = || {
            if bulges.iter().any(|bulge| *bulge != 0.0) {
                return frame.rational(bulged(&corners, &bulges)?);
            }
            Ok(match frame.is_plane() {
                true => AnySpline::from(polyline(corners.clone())?),
                false => AnySpline::from(polyline(corners.iter().map(|p| frame.point(p)).collect())?),
            }
            .into())
        };
        made().map_err(|error| self.failed(Problem::from(error)))
    }
}

/// Lines and arcs in a row: a bulge is the tangent of a quarter of the angle by which its edge turns to the left.
fn bulged(corners: &[Vector2<f64>], bulges: &[f64]) -> Made<NurbsCurve<f64, 2>> {
    let (mut points, mut weights, mut breaks) = (vec![corners[0]], vec![1.0], vec![0.0]);
    for (i, (pair, bulge)) in corners.windows(2).zip(bulges).enumerate() {
        let (a, b) = (pair[0], pair[1]);
        let chord = b - a;
        if *bulge == 0.0 || chord == Vector2::zeros() {
            points.extend([a + chord * 0.5, b]);
            weights.extend([1.0; 2]);
            breaks.extend([(i + 1) as f64; 2]);
            continue;
        }
        let left = Vector2::new(-chord.y, chord.x);
        // (1 - b²) / 4 b, without squares that overflow.
        let centre = a + chord * 0.5 + left * ((1.0 / bulge - bulge) / 4.0);
        let arm = a - centre;
        let arc = symspline::arc_by_angles(&centre, &arm.norm(), &arm.y.atan2(arm.x), &(4.0 * bulge.atan()))?;
        let pieces = arc.space().dim() / 2;
        points.extend(&arc.points()?[1..]);
        weights.extend(arc.weights().skip(1));
        breaks.extend((1..=2 * pieces).map(|j| i as f64 + j.div_ceil(2) as f64 / pieces as f64));
        // The corner is what was given, not a rounded sum.
        let last = points.len() - 1;
        points[last] = b;
    }
    breaks.pop();
    NurbsCurve::new(SplineSpace::clamped(2, breaks)?, points, weights)
}
