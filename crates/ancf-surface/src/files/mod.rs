//! Mesh files.

mod glb;
mod gltf;
mod stl;

use std::fs;
use std::io::ErrorKind;
use std::path::Path;

use crate::mesh::Triangles;

pub(crate) use stl::to_stl;

/// Largest size of a mesh file in bytes.
const MAX_BYTES: u64 = 500_000_000;
/// Largest number of triangles of a mesh file.
const MAX_TRIANGLES: usize = 1_000_000;

/// Mesh that cannot be read: what was found, and what is expected.
#[derive(Debug)]
pub(crate) struct MeshFault {
    pub found: String,
    pub expected: &'static str,
}

/// Reads a mesh in the coordinates of its file.
pub(crate) fn read_mesh(path: &Path) -> Result<Triangles, MeshFault> {
    let fault = |found: String, expected| MeshFault { found, expected };
    let unreadable = |error: std::io::Error| match error.kind() {
        ErrorKind::NotFound => fault(format!("no file {}", path.display()), "an STL or glTF file"),
        _ => fault(format!("{} cannot be read: {error}", path.display()), "an STL or glTF file"),
    };
    let about = fs::metadata(path).map_err(unreadable)?;
    if !about.is_file() || about.len() > MAX_BYTES {
        return Err(fault(
            format!("{}, which is no file or has more than 500 MB", path.display()),
            "a smaller file",
        ));
    }
    let bytes = fs::read(path).map_err(unreadable)?;
    let is_stl = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("stl"));
    let (read, expected) = if is_stl {
        (stl::from_stl(&bytes), "an STL file, binary or as text")
    } else {
        (gltf::from_gltf(&bytes, path.parent().unwrap_or(Path::new(""))), "a glTF 2.0 file")
    };
    let triangles = read.map_err(|reason| fault(format!("{}: {reason}", path.display()), expected))?;
    if triangles.corners.is_empty() {
        return Err(fault(format!("{} without triangles", path.display()), "a mesh of triangles"));
    }
    if triangles.corners.len() > MAX_TRIANGLES {
        let found = format!("{} with {} triangles", path.display(), triangles.corners.len());
        return Err(fault(found, "at most 1000000; simplify the mesh"));
    }
    if triangles.points.iter().flatten().any(|x| !x.is_finite()) {
        return Err(fault(
            format!("{} with points that are not finite", path.display()),
            "finite coordinates",
        ));
    }
    Ok(triangles)
}
