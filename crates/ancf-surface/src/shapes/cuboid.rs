use crate::mesh::Triangles;

/// Box about the origin with edges along the axes.
pub(crate) fn cuboid(edges: [f64; 3]) -> Triangles {
    let mut triangles = Triangles::default();
    for corner in 0..8 {
        let coordinate = |k: usize| if corner >> k & 1 == 0 { -0.5 * edges[k] } else { 0.5 * edges[k] };
        triangles.points.push([coordinate(0), coordinate(1), coordinate(2)]);
    }
    for axis in 0..3_usize {
        let [u, v] = [1 << ((axis + 1) % 3), 1 << ((axis + 2) % 3)];
        for (first, u, v) in [(0, v, u), (1 << axis, u, v)] {
            let [a, b, c, d] = [first, first + u, first + u + v, first + v];
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
    fn the_volume_is_the_product_of_the_edges() {
        let all = cuboid([1.0, 2.0, 3.0]);
        assert!((volume(&all) - 6.0).abs() < 1e-14);
        assert_eq!(all.bounds(), Some([[-0.5, -1.0, -1.5], [0.5, 1.0, 1.5]]));
    }
}
