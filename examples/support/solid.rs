//! The surfaces of the repository, and shaded pictures of surfaces.

use super::{Outcome, data};
use nalgebra::{SVector, vector};
use serde_json::Value;
use symspline::{Q, SplineSpace, Surface};

pub type Sheet = Surface<f64, 3>;

fn json(file: &str) -> Outcome<Value> {
    Ok(serde_json::from_str(&std::fs::read_to_string(data(file))?)?)
}

fn point(json: &Value) -> Outcome<SVector<f64, 3>> {
    let x = |i: usize| json[i].as_f64().ok_or("a point has three numbers");
    Ok(vector![x(0)?, x(1)?, x(2)?])
}

fn list(json: &Value) -> Outcome<&Vec<Value>> {
    json.as_array().ok_or_else(|| "a list is missing".into())
}

/// The 32 bicubic patches of the Utah teapot. All have `S_u × S_v` inwards, so that convex parts have positive mean
/// curvature.
pub fn teapot() -> Outcome<Vec<Sheet>> {
    let json = json("utah_teapot_bicubic.json")?;
    let points = list(&json["vertices"])?.iter().map(point).collect::<Outcome<Vec<_>>>()?;
    let space = SplineSpace::bezier(3, 0.0, 1.0)?;
    let corner = |i: &Value| -> Outcome<SVector<f64, 3>> {
        let i = i.as_u64().ok_or("indices are whole numbers")?;
        Ok(*points.get(usize::try_from(i)?).ok_or("no such point")?)
    };
    let patch = |corners: &Value| {
        let corners = list(corners)?.iter().map(corner).collect::<Outcome<Vec<_>>>()?;
        Ok(Sheet::new(space.clone(), space.clone(), corners)?)
    };
    list(&json["patches_4x4_row_major"])?.iter().map(patch).collect()
}

/// One half of the Wigley hull, `y = (1 - (2x/L)²) (1 - (z/T)²) B/2 >= 0`: `x` along `u`, `z` upwards along `v`.
pub fn hull() -> Outcome<Sheet> {
    let json = json("hull_wigley_biquadratic.json")?;
    let knots = |name: &str| -> Outcome<Vec<f64>> {
        list(&json[name])?.iter().map(|t| t.as_f64().ok_or_else(|| "knots are numbers".into())).collect()
    };
    let (u, v) = (SplineSpace::new(2, knots("knots_u")?)?, SplineSpace::new(2, knots("knots_v")?)?);
    let row = |row: &Value| list(row)?.iter().map(point).collect::<Outcome<Vec<_>>>();
    let rows = list(&json["points_xyz"])?.iter().map(row).collect::<Outcome<Vec<_>>>()?;
    Ok(Sheet::from_rows(u, v, rows)?)
}

/// The same over the rationals: its numbers have few binary digits, so nothing is rounded.
pub fn exact_hull() -> Outcome<Surface<Q, 3>> {
    Ok(hull()?.to_exact()?)
}

/// The mirror image across the plane `y = 0`, its normals on the same side as before: `u` runs the other way.
pub fn mirrored(sheet: &Sheet) -> Outcome<Sheet> {
    let flip = |p: &SVector<f64, 3>| vector![p[0], -p[1], p[2]];
    let points = sheet.coeffs().iter().map(flip).collect();
    let mirrored = Sheet::new(sheet.u().clone(), sheet.v().clone(), points)?;
    Ok(mirrored.reversed(symspline::Direction::U)?)
}
