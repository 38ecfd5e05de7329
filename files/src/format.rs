//! The formats, and how they are told from names of files.

use crate::error::{Problem, Result};
use std::path::Path;

/// A format of files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// The form of this library: JSON, without loss, exact numbers as fractions.
    Json,
    /// The JSON of geomdl (NURBS-Python).
    Geomdl,
    /// SVG drawings.
    Svg,
    /// Fonts, whose letters [`font::outlines`](crate::font::outlines) gives.
    Font,
    /// Free-form Wavefront OBJ.
    Obj,
    /// PLY, faces only.
    Ply,
    /// STL, triangles only.
    Stl,
    /// glTF binary, triangles only.
    Gltf,
    /// DXF drawings: curves as SPLINE entities.
    Dxf,
    /// STEP, the exchange structure of ISO 10303-21: curves and surfaces.
    Step,
    /// IGES 5.3, entities 126 and 128: curves and surfaces.
    Iges,
}

/// Each format: what it is called, the endings of names, whether it is read, whether it is written.
const TABLE: [(Format, &str, &[&str], bool, bool); 11] = [
    (Format::Json, "JSON", &["json"], true, true),
    (Format::Geomdl, "geomdl JSON", &["geomdl.json", "geomdl"], true, true),
    (Format::Svg, "SVG", &["svg"], true, true),
    (Format::Font, "font", &["ttf", "otf"], true, false),
    (Format::Obj, "OBJ", &["obj"], true, true),
    (Format::Ply, "PLY", &["ply"], false, true),
    (Format::Stl, "STL", &["stl"], false, true),
    (Format::Gltf, "glTF", &["glb"], false, true),
    (Format::Dxf, "DXF", &["dxf"], true, true),
    (Format::Step, "STEP", &["step", "stp", "p21"], true, true),
    (Format::Iges, "IGES", &["iges", "igs"], true, true),
];

impl Format {
    /// The format that the ending of a file's name tells, in upper or lower case: the longest ending that fits.
    ///
    /// # Errors
    /// [`Problem::UnknownFormat`].
    pub fn of(path: &Path) -> Result<Self> {
        let name = path.file_name().map(|name| name.to_string_lossy().to_lowercase()).unwrap_or_default();
        let fits = |ending: &&&str| name.strip_suffix(**ending).is_some_and(|stem| stem.ends_with('.'));
        let longest = TABLE.iter().flat_map(|row| row.2).filter(fits).max_by_key(|ending| ending.len());
        Self::by_name(longest.copied().unwrap_or_default())
    }

    /// The format with this ending.
    ///
    /// # Errors
    /// [`Problem::UnknownFormat`].
    pub fn by_name(ending: &str) -> Result<Self> {
        match TABLE.iter().find(|row| row.2.contains(&ending)) {
            Some(row) => Ok(row.0),
            None => {
                let known: Vec<&str> = TABLE.iter().flat_map(|row| row.2).copied().collect();
                Err(Problem::UnknownFormat { known: known.join(", ") }.of_file())
            }
        }
    }

    /// All formats.
    pub fn all() -> impl Iterator<Item = Self> {
        TABLE.iter().map(|row| row.0)
    }

    /// What it is called.
    pub fn name(self) -> &'static str {
        self.row().1
    }

    /// The endings of names of its files.
    pub fn endings(self) -> &'static [&'static str] {
        self.row().2
    }

    /// Whether it is read.
    pub fn is_read(self) -> bool {
        self.row().3
    }

    /// Whether it is written.
    pub fn is_written(self) -> bool {
        self.row().4
    }

    fn row(self) -> &'static (Self, &'static str, &'static [&'static str], bool, bool) {
        TABLE.iter().find(|row| row.0 == self).expect("each format has a row")
    }
}
