//! Triangles of boxes, cylinders and balls.

mod cuboid;
mod cylinder;
mod sphere;

pub(crate) use cuboid::cuboid;
pub(crate) use cylinder::cylinder;
pub(crate) use sphere::sphere;

/// Volume inside closed triangles whose normals point outwards.
#[cfg(test)]
fn volume(triangles: &crate::mesh::Triangles) -> f64 {
    use nalgebra::Vector3;
    let of = |corners: &[u32; 3]| {
        let [a, b, c] = triangles.corners_of(*corners).map(Vector3::from);
        a.dot(&b.cross(&c)) / 6.0
    };
    triangles.corners.iter().map(of).sum()
}
