//! Normals of a triangle mesh, which are smooth except at creases.

use std::collections::HashMap;

use nalgebra::Vector3;

use super::triangles::Triangles;

/// Cosine of the largest angle between the normals of two triangles of a smooth surface, 40 degrees.
const SMOOTH: f64 = 0.766;
/// Number of triangles at a point above which their normals are not averaged.
const MAX_AVERAGED: usize = 256;

/// Triangles with a normal at each point. Points at creases occur once for each side.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ShadedTriangles {
    /// Points.
    pub points: Vec<[f64; 3]>,
    /// Unit normal at each point.
    pub normals: Vec<[f64; 3]>,
    /// Indices of the corners of each triangle.
    pub corners: Vec<[u32; 3]>,
}

impl Triangles {
    /// Computes the normals: at each corner the mean over the adjacent triangles, weighted by their angles at the point (Thürmer
    /// & Wüthrich 1998), without those beyond a crease. Triangles without area are omitted.
    pub fn shaded(&self) -> ShadedTriangles {
        let places = places(&self.points);
        let mut around: Vec<Vec<Adjacent>> = vec![Vec::new(); self.points.len()];
        for &corners in &self.corners {
            let Some(normal) = self.normal_of(corners) else { continue };
            for k in 0..3 {
                let angle = self.angle_of(corners, k);
                around[places[corners[k] as usize]].push(Adjacent { normal, angle });
            }
        }
        let mut shaded = ShadedTriangles::default();
        let mut known = HashMap::new();
        for &corners in &self.corners {
            let Some(own) = self.normal_of(corners) else { continue };
            let corners = corners.map(|corner| {
                let place = places[corner as usize];
                let normal = mean(own, &around[place]);
                let key = (place, normal.map(|x| (x * 1e4).round() as i32));
                *known.entry(key).or_insert_with(|| {
                    shaded.points.push(self.points[place]);
                    shaded.normals.push(normal);
                    (shaded.points.len() - 1) as u32
                })
            });
            shaded.corners.push(corners);
        }
        shaded
    }

    /// Unit normal of a triangle; `None` without area.
    fn normal_of(&self, corners: [u32; 3]) -> Option<Vector3<f64>> {
        let [a, b, c] = self.corners_of(corners).map(Vector3::from);
        (b - a).cross(&(c - a)).try_normalize(0.0)
    }

    /// Angle of a triangle at its corner `k`.
    fn angle_of(&self, corners: [u32; 3], k: usize) -> f64 {
        let points = self.corners_of(corners).map(Vector3::from);
        (points[(k + 1) % 3] - points[k]).angle(&(points[(k + 2) % 3] - points[k]))
    }
}

/// Triangle at a point: its unit normal, and its angle at the point.
#[derive(Clone, Copy)]
struct Adjacent {
    normal: Vector3<f64>,
    angle: f64,
}

/// Mean normal of the triangles around a point on the smooth side of a normal.
fn mean(own: Vector3<f64>, around: &[Adjacent]) -> [f64; 3] {
    if around.len() > MAX_AVERAGED {
        return own.into();
    }
    let smooth = around.iter().filter(|one| one.normal.dot(&own) >= SMOOTH);
    let sum: Vector3<f64> = smooth.map(|one| one.normal * one.angle).sum();
    sum.try_normalize(0.0).unwrap_or(own).into()
}

/// Index of the first point at the place of each point.
fn places(points: &[[f64; 3]]) -> Vec<usize> {
    let mut first = HashMap::new();
    // -0 and 0 are the same place.
    let key = |point: &[f64; 3]| point.map(|x| (x + 0.0).to_bits());
    points.iter().enumerate().map(|(k, point)| *first.entry(key(point)).or_insert(k)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{cuboid, cylinder, sphere};

    #[test]
    fn a_box_has_sharp_edges() {
        let shaded = cuboid([1.0, 2.0, 3.0]).shaded();
        assert_eq!((shaded.points.len(), shaded.corners.len()), (24, 12));
        for normal in &shaded.normals {
            let sizes = normal.map(f64::abs);
            assert_eq!(sizes.iter().filter(|size| **size == 1.0).count(), 1, "{normal:?}");
        }
    }

    /// Normals of the wall of a cylinder are radial, those of its ends axial.
    #[test]
    fn a_cylinder_is_smooth_around_and_sharp_at_its_ends() {
        let shaded = cylinder([0.0; 3], [0.0, 0.0, 2.0], 0.5).shaded();
        for (point, normal) in shaded.points.iter().zip(&shaded.normals) {
            let radial = [point[0] / 0.5, point[1] / 0.5, 0.0];
            let axial = [0.0, 0.0, point[2] - 1.0];
            let off = |n: [f64; 3]| (0..3).map(|k| (n[k] - normal[k]).powi(2)).sum::<f64>().sqrt();
            assert!(off(radial) < 0.02 || off(axial) < 1e-12, "{point:?}: {normal:?}");
        }
    }

    #[test]
    fn a_ball_is_smooth() {
        let shaded = sphere([0.0; 3], 2.0).shaded();
        for (point, normal) in shaded.points.iter().zip(&shaded.normals) {
            assert!((0..3).all(|k| (point[k] / 2.0 - normal[k]).abs() < 0.05), "{point:?}: {normal:?}");
        }
    }

    #[test]
    fn triangles_without_area_are_omitted() {
        let points = vec![[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let flat = Triangles { points, corners: vec![[0, 1, 2], [0, 1, 3], [0, 0, 3]] };
        let shaded = flat.shaded();
        assert_eq!(shaded.corners.len(), 1);
        assert_eq!(shaded.normals, [[0.0, 0.0, 1.0]; 3]);
    }
}
