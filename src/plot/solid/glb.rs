//! glTF 2.0 in one binary file: meshes for viewers.
//!
//! A header, a JSON text that says what is where, and the numbers: for each mesh positions, normals and colours as `f32`,
//! then triangles as `u32`. Colours are parts of light, as the format wants them. Its y axis points upwards and ours is z:
//! the node of the scene turns everything.

use crate::error::{Error, Result};
use crate::io::file::write;
use crate::plot::solid::Point3;
use crate::plot::solid::color_map::linear;
use crate::plot::solid::mesh::Mesh;
use crate::plot::solid::paint::{GREY, Paint};
use std::path::Path;

/// Types of numbers by their names in the format.
const FLOAT: u32 = 5126;
const UNSIGNED: u32 = 5125;
/// What a part of the buffer is for.
const VERTICES: u32 = 34962;
const INDICES: u32 = 34963;

/// The bytes of a glTF binary file (`.glb`) with meshes in their colours.
///
/// # Errors
/// [`Error::Drawing`] for no mesh or one without faces, and for coordinates that `f32` does not hold;
/// [`Error::TooLarge`] beyond 4 GB.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::plot::{Color, Mesh, glb};
/// let triangle = Mesh::new(vec![vector![0.0, 0.0, 0.0], vector![1.0, 0.0, 0.0], vector![0.0, 1.0, 0.0]], [[0, 1, 2]])?;
/// assert!(glb(&[(&triangle, Color::BLUE.into())])?.starts_with(b"glTF"));
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn glb(meshes: &[(&Mesh, Paint)]) -> Result<Vec<u8>> {
    if meshes.is_empty() {
        return Err(Error::Drawing { message: "a file of meshes needs one at least".into() });
    }
    let mut file = Buffer::default();
    let mut primitives = Vec::new();
    for (mesh, paint) in meshes {
        let positions = file.vectors(mesh.positions(), true)?;
        let normals = file.vectors(mesh.normals(), false)?;
        let colors = file.vectors(&colors(mesh, paint), false)?;
        let triangles = file.triangles(mesh)?;
        primitives.push(format!(
            "{{\"attributes\":{{\"POSITION\":{positions},\"NORMAL\":{normals},\"COLOR_0\":{colors}}},\
             \"indices\":{triangles},\"material\":0,\"mode\":4}}"
        ));
    }
    file.finished(&primitives)
}

/// Writes a glTF binary file and creates its folder if need be.
///
/// # Errors
/// Those of [`glb`], and [`Error::Io`] if the file cannot be written.
pub fn write_glb(path: impl AsRef<Path>, meshes: &[(&Mesh, Paint)]) -> Result<()> {
    write(path.as_ref(), &glb(meshes)?)
}

fn colors(mesh: &Mesh, paint: &Paint) -> Vec<Point3> {
    let color = |value: &Option<f64>| match paint {
        Paint::Plain(color) => linear(*color),
        Paint::Values(scale) => value.map_or(linear(GREY), |value| scale.map().linear_at(scale.place(value))),
    };
    mesh.values().iter().map(|value| Point3::from(color(value))).collect()
}

/// The numbers of a file, and what is where in them.
#[derive(Default)]
struct Buffer {
    bytes: Vec<u8>,
    views: Vec<String>,
    accessors: Vec<String>,
}

impl Buffer {
    /// Adds vectors, with their bounds if asked for; returns their number.
    fn vectors(&mut self, vectors: &[Point3], bounded: bool) -> Result<usize> {
        let start = self.bytes.len();
        let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        for vector in vectors {
            for (k, x) in vector.iter().enumerate() {
                let x = *x as f32;
                low[k] = low[k].min(x);
                high[k] = high[k].max(x);
                self.bytes.extend(x.to_le_bytes());
            }
        }
        let fits = low.iter().chain(&high).all(|bound| bound.is_finite());
        // What was apart must stay apart.
        let apart = vectors.iter().any(|vector| vector != &vectors[0]);
        if !fits || bounded && apart && low == high {
            return Err(Error::Drawing {
                message: "no vertices, or coordinates too large or too small for f32".into(),
            });
        }
        let bounds = if bounded { format!(",\"min\":{low:?},\"max\":{high:?}") } else { String::new() };
        Ok(self.entered(start, VERTICES, FLOAT, vectors.len(), "VEC3", &bounds))
    }

    /// Adds the corners of all triangles; returns their number.
    fn triangles(&mut self, mesh: &Mesh) -> Result<usize> {
        let start = self.bytes.len();
        for corner in mesh.triangles().flatten() {
            let corner = u32::try_from(corner).expect("a mesh has fewer vertices");
            self.bytes.extend(corner.to_le_bytes());
        }
        match (self.bytes.len() - start) / 4 {
            0 => Err(Error::Drawing { message: "a mesh without faces has nothing to show".into() }),
            count => Ok(self.entered(start, INDICES, UNSIGNED, count, "SCALAR", "")),
        }
    }

    /// Enters what was added from `start` on.
    fn entered(
        &mut self,
        start: usize,
        target: u32,
        kind: u32,
        count: usize,
        shape: &str,
        bounds: &str,
    ) -> usize {
        let (length, i) = (self.bytes.len() - start, self.views.len());
        self.views.push(format!(
            "{{\"buffer\":0,\"byteOffset\":{start},\"byteLength\":{length},\"target\":{target}}}"
        ));
        self.accessors.push(format!(
            "{{\"bufferView\":{i},\"componentType\":{kind},\"count\":{count},\"type\":\"{shape}\"{bounds}}}"
        ));
        i
    }

    fn finished(self, primitives: &[String]) -> Result<Vec<u8>> {
        let meshes: Vec<String> = primitives.iter().map(|p| format!("{{\"primitives\":[{p}]}}")).collect();
        let nodes: Vec<String> = (0..meshes.len()).map(|i| format!("{{\"mesh\":{i}}}")).collect();
        let children: Vec<String> = (1..=meshes.len()).map(|i| i.to_string()).collect();
        // A quarter turn about x takes z to y.
        let half = std::f32::consts::FRAC_1_SQRT_2;
        let mut json = format!(
            "{{\"asset\":{{\"version\":\"2.0\",\"generator\":\"symspline\"}},\"scene\":0,\"scenes\":[{{\"nodes\":[0]}}],\
             \"nodes\":[{{\"rotation\":[-{half},0.0,0.0,{half}],\"children\":[{}]}},{}],\"meshes\":[{}],\
             \"materials\":[{{\"doubleSided\":true,\"pbrMetallicRoughness\":{{\"metallicFactor\":0.0,\"roughnessFactor\":0.6}}}}],\
             \"accessors\":[{}],\"bufferViews\":[{}],\"buffers\":[{{\"byteLength\":{}}}]}}",
            children.join(","),
            nodes.join(","),
            meshes.join(","),
            self.accessors.join(","),
            self.views.join(","),
            self.bytes.len()
        );
        // Chunks end at multiples of four; that of numbers does.
        json.push_str(&" ".repeat(json.len().next_multiple_of(4) - json.len()));
        let total = 12 + 8 + json.len() + 8 + self.bytes.len();
        let number = |count: usize| {
            let refused = Error::TooLarge { count: total, limit: u32::MAX as usize };
            u32::try_from(count).map(u32::to_le_bytes).map_err(|_| refused)
        };
        let mut file = Vec::with_capacity(total);
        file.extend(b"glTF");
        file.extend(2_u32.to_le_bytes());
        file.extend(number(total)?);
        for (kind, content) in [(b"JSON", json.as_bytes()), (b"BIN\0", &self.bytes)] {
            file.extend(number(content.len())?);
            file.extend(kind);
            file.extend(content);
        }
        Ok(file)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::solid::color_map::ColorMap;
    use crate::plot::solid::color_scale::ColorScale;
    use crate::plot::style::Color;
    use nalgebra::vector;
    use serde_json::Value;

    fn square() -> Mesh {
        let corners = vec![
            vector![0.0, 0.0, 0.1],
            vector![2.0, 0.0, 0.1],
            vector![2.0, 1.0, 0.1],
            vector![0.0, 1.0, 0.1],
        ];
        Mesh::new(corners, [[0, 1, 2, 3]])
            .unwrap()
            .with_values([Some(-1.0), Some(1.0), None, Some(9.0)])
            .unwrap()
    }

    /// The JSON text and the numbers.
    fn opened(file: &[u8]) -> (Value, &[u8]) {
        let number = |at: usize| u32::from_le_bytes(file[at..at + 4].try_into().unwrap()) as usize;
        assert_eq!((&file[..4], number(4), number(8)), (&b"glTF"[..], 2, file.len()));
        let length = number(12);
        assert_eq!((&file[16..20], length % 4), (&b"JSON"[..], 0));
        let numbers = 20 + length;
        assert_eq!(
            (&file[numbers + 4..numbers + 8], number(numbers)),
            (&b"BIN\0"[..], file.len() - numbers - 8)
        );
        (serde_json::from_slice(&file[20..numbers]).unwrap(), &file[numbers + 8..])
    }

    /// The numbers of an accessor, each as four bytes.
    fn words(json: &Value, numbers: &[u8], accessor: &Value) -> Vec<[u8; 4]> {
        let accessor = &json["accessors"][accessor.as_u64().unwrap() as usize];
        let view = &json["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
        let [start, length] = ["byteOffset", "byteLength"].map(|key| view[key].as_u64().unwrap() as usize);
        let parts = if accessor["type"] == "VEC3" { 3 } else { 1 };
        assert_eq!(length, accessor["count"].as_u64().unwrap() as usize * parts * 4);
        numbers[start..start + length].chunks(4).map(|word| word.try_into().unwrap()).collect()
    }

    #[test]
    fn what_is_written_is_read() {
        let (mesh, plain) = (square(), square());
        let scale = ColorScale::new(ColorMap::diverging(), -1.0, 1.0).unwrap();
        let file = glb(&[(&mesh, (&scale).into()), (&plain, Color::BLUE.into())]).unwrap();
        let (json, numbers) = opened(&file);
        assert_eq!(json["asset"]["version"], "2.0");
        assert_eq!(json["buffers"][0]["byteLength"].as_u64().unwrap() as usize, numbers.len());
        assert_eq!(json["nodes"].as_array().unwrap().len(), 3);
        let primitive = &json["meshes"][0]["primitives"][0];
        let floats = |key: &str, json: &Value| {
            let all = words(json, numbers, &json["meshes"][0]["primitives"][0]["attributes"][key]);
            all.into_iter().map(f32::from_le_bytes).collect::<Vec<_>>()
        };
        let positions: Vec<f32> = mesh.positions().iter().flat_map(|p| p.iter().map(|x| *x as f32)).collect();
        assert_eq!(floats("POSITION", &json), positions);
        assert_eq!(floats("NORMAL", &json), [0.0, 0.0, 1.0].repeat(4));
        let colors = floats("COLOR_0", &json);
        let expected = [0.0, 1.0].map(|x| ColorMap::diverging().linear_at(x));
        let grey = linear(GREY);
        for (found, expected) in colors.chunks(3).zip([expected[0], expected[1], grey, expected[1]]) {
            assert!(found.iter().zip(expected).all(|(a, b)| (f64::from(*a) - b).abs() < 1e-6));
        }
        let triangles = words(&json, numbers, &primitive["indices"]).into_iter().map(u32::from_le_bytes);
        assert_eq!(triangles.collect::<Vec<_>>(), [0, 1, 2, 0, 2, 3]);
        let bounds = &json["accessors"][primitive["attributes"]["POSITION"].as_u64().unwrap() as usize];
        let numbers = |key: &str| bounds[key].as_array().unwrap().iter().map(|x| x.as_f64().unwrap() as f32);
        assert_eq!(numbers("min").collect::<Vec<_>>(), [0.0, 0.0, 0.1]);
        assert_eq!(numbers("max").collect::<Vec<_>>(), [2.0, 1.0, 0.1]);
    }

    #[test]
    fn what_f32_does_not_hold_is_refused() {
        for size in [1e300, 1e-300] {
            let corners: Vec<Point3> = square().positions().iter().map(|p| p * size).collect();
            let mesh = Mesh::new(corners, [[0, 1, 2, 3]]).unwrap();
            assert!(matches!(glb(&[(&mesh, Color::BLUE.into())]), Err(Error::Drawing { .. })));
        }
    }

    #[test]
    fn empty_files_are_refused() {
        assert!(matches!(glb(&[]), Err(Error::Drawing { .. })));
        let points = Mesh::new(vec![vector![0.0, 0.0, 0.0]], Vec::<Vec<usize>>::new()).unwrap();
        for empty in [Mesh::default(), points] {
            assert!(matches!(glb(&[(&empty, Color::BLUE.into())]), Err(Error::Drawing { .. })));
        }
    }
}
