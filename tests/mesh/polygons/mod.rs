//! Laws of polygons that control curves, over `Q` with `==`, and of meshes as OBJ files.

mod chaikin;
mod cubic;
mod drawn;
mod hostile;
mod obj;
