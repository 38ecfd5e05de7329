//! Surfaces and meshes as faces: PLY, STL and glTF, which are written only.
//!
//! A surface becomes quadrangles between [`STEPS`] equal steps in each direction and all its knots. They have its own normals,
//! `S_u x S_v`; along creases vertices are doubled and each side has its own. Meshes keep their faces. PLY has them as they are, with
//! numbers of 64 bits; STL and glTF have triangles and numbers of 32 bits.
//! These files are pictures: what they show is off by the square of a step, and no spline comes back from them.

use crate::entry::Entry;
use crate::error::{Place, Problem, Result};
use symspline::plot::{Color, Mesh, Paint, glb};
use symspline_dynamic::{Any, Over, Value};

/// Between so many steps in each direction a surface is cut, and at its knots.
pub const STEPS: usize = 48;

/// What is written, for messages.
type Made<T> = std::result::Result<T, Problem>;

/// The PLY file of surfaces and meshes: binary, with numbers of 64 bits, normals, and faces with any number of corners.
///
/// # Errors
/// [`Problem::NoRoom`] for what has no faces; [`Problem::Value`] where numbers overflow.
pub fn ply(entries: &[Entry]) -> Result<Vec<u8>> {
    let mesh = joined(entries, "PLY")?;
    let too_many = || Problem::NoRoom { format: "PLY", value: "face with more than 255 corners".into() };
    let mut bytes = format!(
        "ply\nformat binary_little_endian 1.0\ncomment symspline\nelement vertex {}\n\
         property double x\nproperty double y\nproperty double z\n\
         property double nx\nproperty double ny\nproperty double nz\nelement face {}\n\
         property list uchar int vertex_indices\nend_header\n",
        mesh.positions().len(),
        mesh.faces().count(),
    )
    .into_bytes();
    for (position, normal) in mesh.positions().iter().zip(mesh.normals()) {
        position.iter().chain(normal.iter()).for_each(|x| bytes.extend(x.to_le_bytes()));
    }
    for face in mesh.faces() {
        bytes.push(u8::try_from(face.len()).map_err(|_| too_many().of_file())?);
        for corner in face {
            bytes.extend(i32::try_from(*corner).expect("a mesh has fewer vertices").to_le_bytes());
        }
    }
    Ok(bytes)
}

/// The STL file of surfaces and meshes: binary, triangles with their own normals.
///
/// # Errors
/// As [`ply`], and [`Problem::NoRoom`] for coordinates beyond numbers of 32 bits.
pub fn stl(entries: &[Entry]) -> Result<Vec<u8>> {
    let mesh = joined(entries, "STL")?;
    let too_large = || Problem::NoRoom { format: "STL", value: "coordinate beyond 32 bits".into() };
    let mut bytes = vec![b' '; 80];
    bytes[..9].copy_from_slice(b"symspline");
    let count = u32::try_from(mesh.triangles().count()).expect("a mesh has fewer triangles");
    bytes.extend(count.to_le_bytes());
    for corners in mesh.triangles() {
        let [a, b, c] = corners.map(|corner| mesh.positions()[corner]);
        // Scaled, so that no square overflows; without an area the normal is zero, as readers expect.
        let size = (b - a).amax().max((c - a).amax());
        let across = ((b - a) / size).cross(&((c - a) / size));
        let normal =
            across.try_normalize(0.0).filter(|n| n.iter().all(|x| x.is_finite())).unwrap_or_default();
        for point in [normal, a, b, c] {
            for x in point.iter() {
                let x = *x as f32;
                if !x.is_finite() {
                    return Err(too_large().of_file());
                }
                bytes.extend(x.to_le_bytes());
            }
        }
        bytes.extend([0, 0]);
    }
    Ok(bytes)
}

/// The glTF binary file of surfaces and meshes, each a node of its own, with normals. Its y axis points up and that of the
/// values is z: the file turns them.
///
/// # Errors
/// As [`ply`]; [`symspline::Error::Drawing`] for coordinates beyond numbers of 32 bits, or without anything to show.
pub fn gltf(entries: &[Entry]) -> Result<Vec<u8>> {
    let meshes = meshes(entries, "glTF")?;
    let painted: Vec<_> = meshes.iter().map(|mesh| (mesh, Paint::from(Color::LIGHT_GRAY))).collect();
    glb(&painted).map_err(|error| Problem::from(error).of_file())
}

fn joined(entries: &[Entry], format: &'static str) -> Result<Mesh> {
    Mesh::joined(&meshes(entries, format)?).map_err(|error| Problem::from(error).of_file())
}

fn meshes(entries: &[Entry], format: &'static str) -> Result<Vec<Mesh>> {
    let one = |(i, entry): (usize, &Entry)| {
        mesh(&entry.value, format).map_err(|problem| problem.at(Place::Entry(format!("item {i}"))))
    };
    entries.iter().enumerate().map(one).collect()
}

fn mesh(value: &Value, format: &'static str) -> Made<Mesh> {
    let no_room = || Problem::NoRoom { format, value: value.kind().into() };
    Ok(match value {
        Value::Surface(any) => match any.to_float()? {
            Any::F3(surface) => Mesh::of(&surface, STEPS, STEPS)?,
            _ => return Err(no_room()),
        },
        Value::RationalSurface(any) => match any.to_float()? {
            Any::F3(surface) => Mesh::of(&surface, STEPS, STEPS)?,
            _ => return Err(no_room()),
        },
        Value::Mesh(any) => match any.to_float()? {
            Over::Float(mesh) => Mesh::new(mesh.points().to_vec(), mesh.topology().faces())?,
            Over::Exact(_) => unreachable!("it was rounded to floats"),
        },
        _ => return Err(no_room()),
    })
}
