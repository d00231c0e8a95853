//! Triangle mesh.

/// Triangles between points. Their normals point outwards if the corners are counter-clockwise as seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Triangles {
    /// Points.
    pub points: Vec<[f64; 3]>,
    /// Indices of the corners of each triangle.
    pub corners: Vec<[u32; 3]>,
}

impl Triangles {
    /// Adds other triangles.
    pub fn extend(&mut self, other: &Self) {
        let first = self.points.len() as u32;
        self.points.extend(&other.points);
        self.corners.extend(other.corners.iter().map(|corners| corners.map(|corner| corner + first)));
    }

    /// Moves all points.
    pub fn transform(&mut self, to: impl Fn([f64; 3]) -> [f64; 3]) {
        self.points.iter_mut().for_each(|point| *point = to(*point));
    }

    /// Smallest and largest coordinates; `None` without points.
    pub fn bounds(&self) -> Option<[[f64; 3]; 2]> {
        let first = *self.points.first()?;
        let mut bounds = [first; 2];
        for point in &self.points {
            for k in 0..3 {
                bounds[0][k] = bounds[0][k].min(point[k]);
                bounds[1][k] = bounds[1][k].max(point[k]);
            }
        }
        Some(bounds)
    }

    /// Corners of a triangle.
    pub(crate) fn corners_of(&self, triangle: [u32; 3]) -> [[f64; 3]; 3] {
        triangle.map(|corner| self.points[corner as usize])
    }
}
