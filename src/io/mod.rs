//! Files: meshes as OBJ files, behind the feature `obj`.

pub(crate) mod file;
#[cfg(feature = "obj")]
mod lines;
#[cfg(feature = "obj")]
pub mod obj;
