//! Normals of vertices from the faces around them.
//!
//! A face with corners `p_0, ..., p_{m-1}` has the vector area `½ Σ p_i × p_{i+1}`; a vertex takes the direction of the sum
//! over its faces, so that large faces count more.

use crate::plot::solid::Point3;
use crate::vector::{unit, unit_cross};
use std::collections::HashMap;

/// The normal of a vertex where no face has an area.
const NONE: [f64; 3] = [0.0, 0.0, 1.0];

/// Twice the vector areas of all faces at each vertex, in units of the size of the mesh squared.
pub(super) fn areas<'a>(positions: &[Point3], faces: impl Iterator<Item = &'a [usize]>) -> Vec<Point3> {
    let size = positions.iter().flat_map(|p| p.iter()).fold(0.0, |size: f64, x| size.max(x.abs()));
    let size = if size > 0.0 { size } else { 1.0 };
    let mut areas = vec![Point3::zeros(); positions.len()];
    for face in faces {
        // From the first corner, so that far from the origin nothing cancels.
        let leg = |i: usize| (positions[i] / size) - (positions[face[0]] / size);
        let legs: Vec<Point3> = face[1..].iter().map(|i| leg(*i)).collect();
        let area = legs.windows(2).fold(Point3::zeros(), |sum, pair| sum + pair[0].cross(&pair[1]));
        face.iter().for_each(|i| areas[*i] += area);
    }
    areas
}

/// Unit normals of vertices from the areas around them.
pub(super) fn from_areas(areas: &[Point3]) -> Vec<Point3> {
    areas.iter().map(|area| direction(area).unwrap_or(Point3::from(NONE))).collect()
}

/// Fills in the normals that are missing: from the faces at the vertex and at all others without normals in its place, as
/// at a pole, where a whole side of a surface is one point.
pub(super) fn filled<'a>(
    positions: &[Point3],
    normals: Vec<Option<Point3>>,
    faces: impl Iterator<Item = &'a [usize]>,
) -> Vec<Point3> {
    if normals.iter().all(Option::is_some) {
        return normals.into_iter().flatten().collect();
    }
    let areas = areas(positions, faces);
    let size = positions.iter().flat_map(|p| p.iter()).fold(0.0, |size: f64, x| size.max(x.abs()));
    let place = |p: &Point3| <[f64; 3]>::from(*p).map(|x| (x / size * 1e9).round() as i64);
    let mut together: HashMap<[i64; 3], Point3> = HashMap::new();
    for ((normal, area), position) in normals.iter().zip(&areas).zip(positions) {
        if normal.is_none() {
            *together.entry(place(position)).or_insert_with(Point3::zeros) += area;
        }
    }
    let missing = |position: &Point3| together.get(&place(position)).and_then(direction);
    let found =
        normals.into_iter().zip(positions).map(|(normal, position)| normal.or_else(|| missing(position)));
    found.map(|normal| normal.unwrap_or(Point3::from(NONE))).collect()
}

/// The unit normal across two tangents, none where they are parallel but for rounding.
pub(super) fn across(along_u: &Point3, along_v: &Point3) -> Option<Point3> {
    let (a, b) = (unit(along_u)?.0, unit(along_v)?.0);
    if a.cross(&b).norm() < 1e-9 { None } else { unit_cross(along_u, along_v) }
}

fn direction(area: &Point3) -> Option<Point3> {
    unit(area).map(|(direction, _)| direction)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::vector;

    #[test]
    fn a_pyramid_has_an_upright_apex() {
        let positions: Vec<Point3> = vec![
            vector![1.0, 1.0, 0.0],
            vector![-1.0, 1.0, 0.0],
            vector![-1.0, -1.0, 0.0],
            vector![1.0, -1.0, 0.0],
            vector![0.0, 0.0, 5.0],
        ];
        let faces = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
        let normals = from_areas(&areas(&positions, faces.iter().map(|face| &face[..])));
        assert!((normals[4] - vector![0.0, 0.0, 1.0]).norm() < 1e-15);
        assert!(normals[0][0] > 0.0 && normals[0][1] > 0.0);
    }

    #[test]
    fn without_area_a_normal_is_upright() {
        let positions = vec![Point3::zeros(); 3];
        assert_eq!(
            filled(&positions, vec![None; 3], [&[0, 1, 2][..]].into_iter()),
            vec![Point3::from(NONE); 3]
        );
        let huge = vec![vector![1e300, 0.0, 0.0], vector![0.0, 1e300, 0.0], vector![0.0, 0.0, 1e300]];
        let normal = from_areas(&areas(&huge, [&[0, 1, 2][..]].into_iter()))[0];
        assert!((normal - vector![1.0, 1.0, 1.0].normalize()).norm() < 1e-15);
    }
}
