//! Files: meshes as OBJ files.

pub(crate) mod file;
mod lines;
pub mod obj;
