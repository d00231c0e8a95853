use std::f64::consts::TAU;

use nalgebra::Vector3;

use crate::mesh::Triangles;

/// Number of sides.
const SIDES: u32 = 48;

/// Cylinder with flat ends between two different points.
pub(crate) fn cylinder(from: [f64; 3], to: [f64; 3], radius: f64) -> Triangles {
    let [start, end] = [from, to].map(Vector3::from);
    let axis = (end - start).normalize();
    let side = Vector3::ith(axis.iamin(), 1.0);
    let y = axis.cross(&side).normalize();
    let z = axis.cross(&y);
    let mut triangles = Triangles { points: vec![from, to], corners: Vec::new() };
    for i in 0..SIDES {
        let (sin, cos) = (TAU * f64::from(i) / f64::from(SIDES)).sin_cos();
        let arm = (y * cos + z * sin) * radius;
        triangles.points.extend([start, end].map(|end| <[f64; 3]>::from(end + arm)));
        let [a, b] = [2 + 2 * i, 2 + 2 * ((i + 1) % SIDES)];
        triangles.corners.extend([[a, b, b + 1], [a, b + 1, a + 1], [0, b, a], [1, a + 1, b + 1]]);
    }
    triangles
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::volume;

    #[test]
    fn the_volume_is_that_of_the_prism_in_any_direction() {
        let sides = f64::from(SIDES);
        let area = 0.5 * sides * (TAU / sides).sin() * 0.25;
        for (from, to, length) in
            [([0.0; 3], [0.0, 0.0, 2.0], 2.0), ([1.0, 2.0, 3.0], [1.0, -1.0, -1.0], 5.0)]
        {
            let all = cylinder(from, to, 0.5);
            assert!((volume(&all) - area * length).abs() < 1e-12, "{}", volume(&all));
        }
    }
}
