//! Meshes as Wavefront OBJ files.
//!
//! ```text
//! v x y z            a vertex
//! f i j k ...        a face by its vertices: i-th of the file, or with a minus sign of those before, from the last one back
//! ```
//! All groups and objects of a file are one mesh, and faces keep their corners, however many. A corner may tell a texture and a
//! normal as well (`i/t/n`); these, colours of vertices, groups, materials, points and lines are passed over. Numbers are written as
//! the shortest ones that are read back bit by bit.
//!
//! Of the crates that read OBJ files `tobj`, the best kept, renumbers the vertices of each group, which tears meshes apart, `obj`, `obj-rs`
//! and `wobj` round to `f32`, `wavefront_obj` makes triangles of faces, and `wavefront_rs` is a beta version since 2023. Since two kinds of lines
//! matter here, they are read by the standard library's parsers of numbers.

use crate::error::Result;
use crate::error::obj::ObjError;
use crate::io::file::{self, failed};
use crate::io::lines::{Lines, refused};
use crate::mesh::control_mesh::ControlMesh;
use nalgebra::SVector;
use std::fmt::Display;
use std::fs::File;
use std::io::{BufRead, BufReader, BufWriter, Write};
use std::path::Path;
use std::str::FromStr;

/// How much of a word errors repeat, in letters.
const REPEATED: usize = 24;

/// What is passed over: it does not change the mesh.
const PASSED: [&str; 18] = [
    "vt",
    "vn",
    "vp",
    "o",
    "g",
    "s",
    "mg",
    "l",
    "p",
    "mtllib",
    "usemtl",
    "maplib",
    "usemap",
    "bevel",
    "c_interp",
    "d_interp",
    "lod",
    "shadow_obj",
];

/// The mesh of an OBJ file.
///
/// # Errors
/// [`MeshError::Obj`](crate::MeshError::Obj) with the line for what cannot be read: see [`ObjError`]. What [`ControlMesh::new`] refuses, for faces and
/// vertices counted from 0: among it vertices in no face. [`Error::Io`](crate::Error::Io) if the reader fails.
///
/// # Examples
/// ```
/// use symspline::{MeshError, ObjError, io::obj};
/// let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5 # a comment\ng square\nf 1//1 2//1 \\\n  -2//1 -1//1\n";
/// let mesh = obj::read(text.as_bytes())?;
/// assert_eq!(mesh.topology().faces().collect::<Vec<_>>(), [[0, 1, 2, 3]]);
///
/// let beyond = obj::read("v 0 0 0\nf 1 2 3\n".as_bytes());
/// assert_eq!(beyond, Err(MeshError::Obj(ObjError::NoSuchVertex { line: 2, index: 3, count: 1 }).into()));
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn read(text: impl BufRead) -> Result<ControlMesh<f64, 3>> {
    read_named(text, "the reader")
}

/// The mesh of an OBJ file at a path.
///
/// # Errors
/// As [`read`]; [`Error::Io`](crate::Error::Io) if there is no such file.
///
/// # Examples
/// ```
/// use symspline::io::obj;
/// assert!(obj::read_file("data/subd_torus.obj")?.topology().is_closed());
/// assert!(matches!(obj::read_file("data/nothing.obj"), Err(symspline::Error::Io { .. })));
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn read_file(path: impl AsRef<Path>) -> Result<ControlMesh<f64, 3>> {
    let name = path.as_ref().display().to_string();
    let file = File::open(&path).map_err(failed(&name))?;
    read_named(BufReader::new(file), &name)
}

/// Writes a mesh as an OBJ file: [`read`] gives the same mesh, bit by bit.
///
/// # Errors
/// [`Error::Io`](crate::Error::Io) if the writer fails.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{ControlMesh, io::obj};
/// let points = vec![vector![0.0, 0.0, 0.1], vector![1e-7, -0.0, 0.0], vector![0.0, 2.0, 0.0]];
/// let mut text = Vec::new();
/// obj::write(&ControlMesh::new(points, [[0, 1, 2]])?, &mut text)?;
/// assert_eq!(text, b"v 0.0 0.0 0.1\nv 1e-7 -0.0 0.0\nv 0.0 2.0 0.0\nf 1 2 3\n");
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn write(mesh: &ControlMesh<f64, 3>, text: impl Write) -> Result<()> {
    put(mesh, text).map_err(failed("the writer"))
}

/// Writes a mesh as an OBJ file at a path, and creates the folder if need be.
///
/// # Errors
/// [`Error::Io`](crate::Error::Io) if the file cannot be written.
pub fn write_file(mesh: &ControlMesh<f64, 3>, path: impl AsRef<Path>) -> Result<()> {
    let mut text = Vec::new();
    write(mesh, &mut text)?;
    file::write(path.as_ref(), &text)
}

fn put(mesh: &ControlMesh<f64, 3>, text: impl Write) -> std::io::Result<()> {
    let mut text = BufWriter::new(text);
    for point in mesh.points() {
        // Unlike `{}` this writes exponents, not hundreds of zeros.
        writeln!(text, "v {:?} {:?} {:?}", point[0], point[1], point[2])?;
    }
    for f in 0..mesh.topology().face_count() {
        text.write_all(b"f")?;
        mesh.topology().face(f).try_for_each(|v| write!(text, " {}", v + 1))?;
        text.write_all(b"\n")?;
    }
    text.flush()
}

fn read_named(text: impl BufRead, name: &str) -> Result<ControlMesh<f64, 3>> {
    let mut lines = Lines::new(text, name);
    let mut draft = Draft::default();
    while let Some((line, text)) = lines.next()? {
        let mut words = text.split_whitespace();
        match words.next() {
            None => {}
            Some("v") => draft.vertex(line, &words.collect::<Vec<_>>())?,
            Some("f") => draft.face(line, words)?,
            Some(word) if PASSED.contains(&word) => {}
            Some(word) => return Err(refused(ObjError::Statement { line, word: repeated(word) })),
        }
    }
    draft.finished()
}

/// What was read so far.
#[derive(Default)]
struct Draft {
    points: Vec<SVector<f64, 3>>,
    /// The corners of all faces, and where each face ends in them.
    corners: Vec<usize>,
    ends: Vec<usize>,
    /// The largest index of a vertex, and the line where it is: vertices may come after faces.
    largest: Option<(i64, usize)>,
}

impl Draft {
    fn vertex(&mut self, line: usize, words: &[&str]) -> Result<()> {
        let (x, y, z, weight) = match *words {
            [x, y, z] | [x, y, z, _, _, _] => (x, y, z, None),
            [x, y, z, weight] => (x, y, z, Some(weight)),
            _ => return Err(refused(ObjError::Coordinates { line, found: words.len() })),
        };
        let mut point = SVector::zeros();
        for (axis, word) in [x, y, z].into_iter().enumerate() {
            point[axis] = number::<f64>(line, word)?;
            if !point[axis].is_finite() {
                return Err(refused(ObjError::NotFinite { line, axis }));
            }
        }
        match weight.map(|word| number::<f64>(line, word)).transpose()? {
            Some(weight) if weight != 1.0 => {
                Err(refused(ObjError::Weighted { line, weight: weight.to_string() }))
            }
            _ => {
                self.points.push(point);
                Ok(())
            }
        }
    }

    fn face<'a>(&mut self, line: usize, words: impl Iterator<Item = &'a str>) -> Result<()> {
        let start = self.corners.len();
        for word in words {
            let mut parts = word.split('/');
            let vertex = number(line, parts.next().unwrap_or_default())?;
            // Texture and normal.
            for part in parts.by_ref().take(2).filter(|part| !part.is_empty()) {
                number::<i64>(line, part)?;
            }
            if parts.next().is_some() {
                let reason = format!("'{}' has more than three parts", repeated(word));
                return Err(refused(ObjError::Syntax { line, reason }));
            }
            let corner = self.corner(line, vertex)?;
            self.corners.push(corner);
        }
        let found = self.corners.len() - start;
        if found < 3 {
            return Err(refused(ObjError::FewCorners { line, found }));
        }
        self.ends.push(self.corners.len());
        Ok(())
    }

    /// The vertex, counted from 0.
    fn corner(&mut self, line: usize, index: i64) -> Result<usize> {
        let count = self.points.len();
        let nothing = || refused(ObjError::NoSuchVertex { line, index, count });
        if index < 0 {
            let back = usize::try_from(index.unsigned_abs()).map_err(|_| nothing())?;
            return count.checked_sub(back).ok_or_else(nothing);
        }
        if self.largest.is_none_or(|(largest, _)| index > largest) {
            self.largest = Some((index, line));
        }
        usize::try_from(index).ok().and_then(|index| index.checked_sub(1)).ok_or_else(nothing)
    }

    fn finished(self) -> Result<ControlMesh<f64, 3>> {
        let count = self.points.len();
        if let Some((index, line)) = self.largest.filter(|(index, _)| *index as u64 > count as u64) {
            return Err(refused(ObjError::NoSuchVertex { line, index, count }));
        }
        let start = |i: usize| if i == 0 { 0 } else { self.ends[i - 1] };
        let faces = self.ends.iter().enumerate().map(|(i, end)| &self.corners[start(i)..*end]);
        ControlMesh::new(self.points, faces)
    }
}

/// A number, written as a word.
fn number<T: FromStr<Err: Display>>(line: usize, word: &str) -> Result<T> {
    word.parse().map_err(|error: T::Err| {
        refused(ObjError::Syntax { line, reason: format!("'{}': {error}", repeated(word)) })
    })
}

/// A word, or how it begins.
fn repeated(word: &str) -> String {
    word.chars().take(REPEATED).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Error;
    use crate::error::mesh::MeshError;
    use crate::io::lines::LONGEST;

    fn error(text: &[u8]) -> ObjError {
        match read(text) {
            Err(Error::Mesh(MeshError::Obj(error))) => error,
            other => panic!("{other:?}"),
        }
    }

    const VERTICES: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

    fn after_vertices(text: &str) -> ObjError {
        error(format!("{VERTICES}{text}").as_bytes())
    }

    #[test]
    fn what_no_face_has_is_named_with_its_line() {
        let nothing = |line, index, count| ObjError::NoSuchVertex { line, index, count };
        assert_eq!(after_vertices("f 1 2 0\n"), nothing(4, 0, 3));
        assert_eq!(after_vertices("\nf 1 2 3\nf 1 2 4\nf 2 1 3"), nothing(6, 4, 3));
        assert_eq!(after_vertices("f -1 -2 -4"), nothing(4, -4, 3));
        assert_eq!(after_vertices(&format!("f 1 2 {}", i64::MAX)), nothing(4, i64::MAX, 3));
        assert_eq!(after_vertices(&format!("f 1 2 {}", i64::MIN)), nothing(4, i64::MIN, 3));
        assert_eq!(after_vertices("f 1 2"), ObjError::FewCorners { line: 4, found: 2 });
        assert_eq!(after_vertices("f"), ObjError::FewCorners { line: 4, found: 0 });
        for face in
            ["f 1 2 x", "f 1 2 99999999999999999999", "f 1 2 3.0", "f 1 2 /1", "f 1 2 3/a", "f 1 2 3/1/1/1"]
        {
            assert!(matches!(after_vertices(face), ObjError::Syntax { line: 4, .. }), "{face}");
        }
    }

    #[test]
    fn what_no_vertex_has_is_named_with_its_line() {
        let not_finite = |axis| ObjError::NotFinite { line: 4, axis };
        assert_eq!(after_vertices("v 0 NaN 0"), not_finite(1));
        assert_eq!(after_vertices("v 0 0 1e999"), not_finite(2));
        assert_eq!(after_vertices("v -inf 0 0"), not_finite(0));
        for (numbers, found) in [("", 0), ("1 2", 2), ("1 2 3 4 5", 5), ("1 2 3 4 5 6 7", 7)] {
            assert_eq!(after_vertices(&format!("v {numbers}")), ObjError::Coordinates { line: 4, found });
        }
        assert_eq!(after_vertices("v 0 0 0 2"), ObjError::Weighted { line: 4, weight: "2".into() });
        assert!(matches!(after_vertices("v 0 0 0 nan"), ObjError::Weighted { line: 4, .. }));
        for vertex in ["v 0 0 o", "v 0 0 1,5", "v 0 0 0 x", "v 0 0 0x1"] {
            assert!(matches!(after_vertices(vertex), ObjError::Syntax { line: 4, .. }), "{vertex}");
        }
    }

    #[test]
    fn what_is_no_line_of_a_mesh_is_refused() {
        let statement = |line, word: &str| ObjError::Statement { line, word: word.into() };
        assert_eq!(after_vertices("\ncurv 0 1 1 2 3"), statement(5, "curv"));
        assert_eq!(error(b"V 0 0 0"), statement(1, "V"));
        assert_eq!(error(&[b'x'; 100]), statement(1, &"x".repeat(REPEATED)));
        assert_eq!(error(b"\xff\xfe\x00"), statement(1, "\u{fffd}\u{fffd}\0"));
        assert_eq!(after_vertices("f 1 2 \\\n"), ObjError::Unfinished { line: 4 });
        assert_eq!(error(&vec![b' '; LONGEST + 1]), ObjError::LongLine { line: 1, limit: LONGEST });
        let endless = BufReader::new(std::io::repeat(b'1'));
        assert!(matches!(read(endless), Err(Error::Mesh(MeshError::Obj(ObjError::LongLine { .. })))));
        let continued = BufReader::new(Endless);
        assert!(matches!(read(continued), Err(Error::Mesh(MeshError::Obj(ObjError::LongLine { .. })))));
    }

    /// A line that is continued for ever.
    struct Endless;

    impl std::io::Read for Endless {
        fn read(&mut self, bytes: &mut [u8]) -> std::io::Result<usize> {
            let whole = bytes.len() / 64 * 64;
            bytes[..whole].iter_mut().enumerate().for_each(|(i, byte)| {
                *byte = match i % 64 {
                    62 => b'\\',
                    63 => b'\n',
                    _ => b'1',
                }
            });
            Ok(whole)
        }
    }

    #[test]
    fn what_does_not_change_the_mesh_is_passed_over() {
        let plain = read(format!("{VERTICES}f 1 2 3").as_bytes()).unwrap();
        for text in [
            "\u{feff}v 0 0 0 1\r\nv 1 0 0 1.0\r\n\r\n  v\t0 1 0\r\nf 1 2 3\r\n",
            "# \\\nv 0 0 0 .1 .2 .3#\nv 1e0 0 0 0 1 1\nv +0 1 0\nvt 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1",
            "mtllib a\no b\nv 0 0 0\ng c\nv 1 0 0\ns 1\nf 1// 2//7 3/7\nv 0 1 0\nl 1 9\np x",
            "v 0 \\\n0 \\ \r\n 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1",
        ] {
            assert_eq!(read(text.as_bytes()).unwrap(), plain, "{text}");
        }
        let latin = [b"# \xe9\no \xe9\n", VERTICES.as_bytes(), b"f 1 2 3"].concat();
        assert_eq!(read(latin.as_slice()).unwrap(), plain);
    }

    #[test]
    fn what_is_no_manifold_is_refused_as_a_mesh() {
        assert_eq!(read(&b""[..]), Err(MeshError::NoFaces.into()));
        let unused = read(format!("{VERTICES}v 1 1 1\nf 1 2 3").as_bytes());
        assert_eq!(unused, Err(MeshError::UnusedVertex { vertex: 3 }.into()));
        let twice = read(format!("{VERTICES}f 1 2 3 2").as_bytes());
        assert_eq!(twice, Err(MeshError::DegenerateFace { face: 0 }.into()));
    }

    #[test]
    fn failing_readers_and_writers_are_reported() {
        struct Failing;
        impl std::io::Read for Failing {
            fn read(&mut self, _: &mut [u8]) -> std::io::Result<usize> {
                Err(std::io::Error::other("worn out"))
            }
        }
        impl Write for Failing {
            fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
                Err(std::io::Error::other("full"))
            }
            fn flush(&mut self) -> std::io::Result<()> {
                Ok(())
            }
        }
        let io = |path: &str, message: &str| Error::Io { path: path.into(), message: message.into() };
        assert_eq!(read(BufReader::new(Failing)), Err(io("the reader", "worn out")));
        let mesh = read(format!("{VERTICES}f 1 2 3").as_bytes()).unwrap();
        assert_eq!(write(&mesh, Failing), Err(io("the writer", "full")));
        assert!(matches!(write_file(&mesh, "/dev/null/mesh.obj"), Err(Error::Io { .. })));
    }
}
