//! A topology from lists of corners, and what may be wrong with them.

use crate::error::mesh::MeshError;
use crate::error::{Error, Result};
use crate::mesh::topology::{NONE, Topology};

/// The most half-edges of a mesh.
pub(super) const MOST: usize = 1 << 28;

/// Refuses meshes with too many half-edges or vertices.
pub(super) fn check_size(count: usize) -> Result<()> {
    match count {
        0..=MOST => Ok(()),
        _ => Err(Error::TooLarge { count, limit: MOST }),
    }
}

/// Refuses `depth` steps that each make four half-edges of one, beyond the limit.
pub(super) fn check_refined(half_edges: usize, depth: usize) -> Result<()> {
    let grown = u32::try_from(2 * depth.min(64)).ok().and_then(|shift| 1_usize.checked_shl(shift));
    check_size(grown.map_or(usize::MAX, |factor| half_edges.saturating_mul(factor)))
}

impl Topology {
    /// The topology of faces given by their corners, counter-clockwise as seen from outside, over vertices `0 .. vertices`.
    ///
    /// # Errors
    /// [`MeshError::NoFaces`],
    /// [`MeshError::DegenerateFace`],
    /// [`MeshError::NoSuchVertex`],
    /// [`MeshError::NonManifoldEdge`],
    /// [`MeshError::InconsistentFaces`],
    /// [`MeshError::NonManifoldVertex`],
    /// [`MeshError::UnusedVertex`];
    /// [`Error::TooLarge`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{MeshError, Topology};
    /// let turned_over = Topology::new(4, [[0, 1, 2], [1, 2, 3]]);
    /// assert_eq!(turned_over, Err(MeshError::InconsistentFaces { from: 1, to: 2, first: 0, second: 1 }.into()));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn new<F: AsRef<[usize]>>(vertices: usize, faces: impl IntoIterator<Item = F>) -> Result<Self> {
        check_size(vertices)?;
        let (mut origins, mut starts, mut owners) = (Vec::new(), vec![0], Vec::new());
        // The face that came to a vertex last.
        let mut seen = vec![NONE; vertices];
        for (face, corners) in faces.into_iter().enumerate() {
            let corners = corners.as_ref();
            if corners.len() < 3 {
                return Err(MeshError::DegenerateFace { face }.into());
            }
            check_size(origins.len().saturating_add(corners.len()))?;
            for (corner, &vertex) in corners.iter().enumerate() {
                let last = seen.get_mut(vertex);
                let last = last.ok_or(MeshError::NoSuchVertex { face, corner, vertex, count: vertices })?;
                if std::mem::replace(last, face as u32) == face as u32 {
                    return Err(MeshError::DegenerateFace { face }.into());
                }
                origins.push(vertex as u32);
                owners.push(face as u32);
            }
            starts.push(origins.len() as u32);
        }
        if origins.is_empty() {
            return Err(MeshError::NoFaces.into());
        }
        if let Some(vertex) = seen.iter().position(|face| *face == NONE) {
            return Err(MeshError::UnusedVertex { vertex }.into());
        }
        let count = origins.len();
        let mut built = Topology {
            origins,
            starts,
            faces: owners,
            twins: vec![NONE; count],
            edges: vec![NONE; count],
            sides: Vec::with_capacity(count / 2),
            leaving: vec![NONE; vertices],
        };
        pair(&mut built)?;
        lead(&mut built)?;
        Ok(built)
    }
}

/// Finds the twins: half-edges between the same two vertices, of which there may be one, or two that run against each other.
fn pair(built: &mut Topology) -> Result<()> {
    let between = |h: usize| {
        let (v, w) = (built.origin(h), built.target(h));
        (v.min(w) as u32, v.max(w) as u32, h as u32)
    };
    let mut sides: Vec<_> = (0..built.half_edge_count()).map(between).collect();
    sides.sort_unstable();
    for same in sides.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
        match *same {
            [_] => {}
            [(.., g), (.., h)] => {
                let (first, second) = (g as usize, h as usize);
                if built.origin(first) == built.origin(second) {
                    let (from, to) = (built.origin(first), built.target(first));
                    let (first, second) = (built.face_of(first), built.face_of(second));
                    return Err(MeshError::InconsistentFaces { from, to, first, second }.into());
                }
                (built.twins[first], built.twins[second]) = (h, g);
            }
            [(from, to, _), ..] => {
                let (from, to) = (from as usize, to as usize);
                return Err(MeshError::NonManifoldEdge { from, to, faces: same.len() }.into());
            }
            [] => {}
        }
    }
    for h in 0..built.half_edge_count() {
        // The lower half-edge of two comes first.
        built.edges[h] = match built.twin(h) {
            Some(twin) if twin < h => built.edges[twin],
            _ => {
                built.sides.push(h as u32);
                built.sides.len() as u32 - 1
            }
        };
    }
    Ok(())
}

/// Finds the half-edge that leads the fan of each vertex, and refuses vertices with more than one fan.
fn lead(built: &mut Topology) -> Result<()> {
    let mut degrees = vec![0_u32; built.vertex_count()];
    for h in 0..built.half_edge_count() {
        let vertex = built.origin(h);
        degrees[vertex] += 1;
        let leading = built.leaving[vertex];
        let boundary = built.twins[h] == NONE;
        if boundary && leading != NONE && built.twins[leading as usize] == NONE {
            return Err(MeshError::NonManifoldVertex { vertex }.into());
        }
        if leading == NONE || boundary {
            built.leaving[vertex] = h as u32;
        }
    }
    let whole = |vertex: usize| built.leaving(vertex).count() == degrees[vertex] as usize;
    match (0..built.vertex_count()).find(|vertex| !whole(*vertex)) {
        Some(vertex) => Err(MeshError::NonManifoldVertex { vertex }.into()),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(vertices: usize, faces: &[&[usize]]) -> MeshError {
        match Topology::new(vertices, faces) {
            Err(Error::Mesh(error)) => error,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn what_is_no_manifold_is_named() {
        assert_eq!(refused(3, &[]), MeshError::NoFaces);
        assert_eq!(refused(3, &[&[0, 1, 2], &[0, 1]]), MeshError::DegenerateFace { face: 1 });
        assert_eq!(refused(4, &[&[0, 1, 2, 1]]), MeshError::DegenerateFace { face: 0 });
        let stray = MeshError::NoSuchVertex { face: 0, corner: 2, vertex: 3, count: 3 };
        assert_eq!(refused(3, &[&[0, 1, 3]]), stray);
        assert_eq!(refused(4, &[&[0, 1, 2]]), MeshError::UnusedVertex { vertex: 3 });
        let three = MeshError::NonManifoldEdge { from: 0, to: 1, faces: 3 };
        assert_eq!(refused(5, &[&[0, 1, 2], &[1, 0, 3], &[0, 1, 4]]), three);
        let turned = MeshError::InconsistentFaces { from: 0, to: 1, first: 0, second: 1 };
        assert_eq!(refused(4, &[&[0, 1, 2], &[0, 1, 3]]), turned);
        // Two triangles that meet in a vertex, and two closed fans.
        assert_eq!(refused(5, &[&[0, 1, 2], &[0, 3, 4]]), MeshError::NonManifoldVertex { vertex: 0 });
        let tent = |a, b, c| [[0, a, b], [0, b, c], [0, c, a], [a, c, b]];
        let tents: Vec<_> = tent(1, 2, 3).into_iter().chain(tent(4, 5, 6)).collect();
        let error = Topology::new(7, &tents).unwrap_err();
        assert_eq!(error, MeshError::NonManifoldVertex { vertex: 0 }.into());
    }

    #[test]
    fn closed_meshes_have_no_boundary() {
        let tetrahedron = Topology::new(4, [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]).unwrap();
        assert!(tetrahedron.is_closed() && tetrahedron.boundaries().is_empty());
        assert_eq!((tetrahedron.edge_count(), tetrahedron.euler_characteristic()), (6, 2));
    }
}
