use std::f64::consts::{PI, TAU};

use crate::mesh::Triangles;

/// Number of meridians and of parts of a meridian.
const MERIDIANS: u32 = 32;
const PARTS: u32 = 16;

/// Ball.
pub(crate) fn sphere(center: [f64; 3], radius: f64) -> Triangles {
    let point = |part: u32, meridian: u32| {
        let (rho, z) = (PI * f64::from(part) / f64::from(PARTS)).sin_cos();
        let (sin, cos) = (TAU * f64::from(meridian) / f64::from(MERIDIANS)).sin_cos();
        let direction = [rho * cos, rho * sin, z];
        [0, 1, 2].map(|k| center[k] + radius * direction[k])
    };
    let mut triangles = Triangles { points: vec![point(0, 0), point(PARTS, 0)], corners: Vec::new() };
    // Rings between the poles, from the upper one to the lower one.
    let at = |ring: u32, meridian: u32| 2 + ring * MERIDIANS + meridian % MERIDIANS;
    for ring in 0..PARTS - 1 {
        triangles.points.extend((0..MERIDIANS).map(|meridian| point(ring + 1, meridian)));
    }
    for i in 0..MERIDIANS {
        triangles.corners.push([0, at(0, i), at(0, i + 1)]);
        triangles.corners.push([1, at(PARTS - 2, i + 1), at(PARTS - 2, i)]);
        for ring in 0..PARTS - 2 {
            let [a, b, c, d] = [at(ring, i), at(ring + 1, i), at(ring + 1, i + 1), at(ring, i + 1)];
            triangles.corners.extend([[a, b, c], [a, c, d]]);
        }
    }
    triangles
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::volume;

    #[test]
    fn the_volume_is_that_of_a_ball() {
        let all = sphere([1.0, 2.0, 3.0], 0.5);
        let ball = 4.0 / 3.0 * PI * 0.125;
        assert!((0.96..1.0).contains(&(volume(&all) / ball)), "{}", volume(&all) / ball);
        assert!(all.points.iter().all(|[x, y, z]| {
            ((x - 1.0).powi(2) + (y - 2.0).powi(2) + (z - 3.0).powi(2) - 0.25).abs() < 1e-14
        }));
    }
}
