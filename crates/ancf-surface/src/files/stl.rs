//! STL files, binary or as text.

use std::io::{self, Cursor};

use stl_io::{Normal, Triangle, Vertex, read_stl, write_stl};

use crate::mesh::Triangles;

/// Reads an STL file.
pub(super) fn from_stl(bytes: &[u8]) -> Result<Triangles, String> {
    let mesh = read_stl(&mut Cursor::new(bytes)).map_err(|error| error.to_string())?;
    Ok(Triangles {
        points: mesh.vertices.iter().map(|vertex| vertex.0.map(f64::from)).collect(),
        corners: mesh.faces.iter().map(|face| face.vertices.map(|corner| corner as u32)).collect(),
    })
}

/// Returns a binary STL file, in single precision.
pub(crate) fn to_stl(triangles: &Triangles) -> io::Result<Vec<u8>> {
    // Readers compute the normals from the corners.
    let normal = Normal::new([0.0; 3]);
    let triangle = |corners: &[u32; 3]| Triangle {
        normal,
        vertices: triangles.corners_of(*corners).map(|point| Vertex::new(point.map(|x| x as f32))),
    };
    let mut bytes = Vec::new();
    write_stl(&mut bytes, triangles.corners.iter().map(triangle))?;
    Ok(bytes)
}
