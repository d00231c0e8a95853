use ancf::nalgebra::{Matrix3, Vector3};

/// Map of points x → M x + c with an orthogonal matrix M.
///
/// Polar vectors (forces, velocities) map by M, axial vectors (moments, angular velocities) by det(M) M.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// Orthogonal matrix M.
    pub matrix: Matrix3<f64>,
    /// Translation c.
    pub shift: Vector3<f64>,
}

impl Frame {
    /// Rotation or reflection about the origin.
    pub fn linear(matrix: Matrix3<f64>) -> Self {
        Self { matrix, shift: Vector3::zeros() }
    }

    /// Translation.
    pub fn translation(shift: Vector3<f64>) -> Self {
        Self { matrix: Matrix3::identity(), shift }
    }

    /// Sign of the determinant: −1 for reflections.
    pub fn sign(&self) -> f64 {
        self.matrix.determinant().signum()
    }

    /// Maps a polar vector.
    pub fn polar(&self, x: [f64; 3]) -> [f64; 3] {
        (self.matrix * Vector3::from(x)).into()
    }

    /// Maps an axial vector.
    pub fn axial(&self, x: [f64; 3]) -> [f64; 3] {
        (self.sign() * self.matrix * Vector3::from(x)).into()
    }

    /// Maps a point.
    pub fn point(&self, x: [f64; 3]) -> [f64; 3] {
        (self.matrix * Vector3::from(x) + self.shift).into()
    }

    /// Maps the three numbers of a diagonal tensor in global axes; `None` if the result is not diagonal.
    pub fn diagonal(&self, x: [f64; 3]) -> Option<[f64; 3]> {
        let tensor = self.matrix * Matrix3::from_diagonal(&Vector3::from(x)) * self.matrix.transpose();
        let size = x.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let is_diagonal = (0..3).all(|i| (0..3).all(|j| i == j || tensor[(i, j)].abs() <= 1e-13 * size));
        is_diagonal.then(|| [tensor[(0, 0)], tensor[(1, 1)], tensor[(2, 2)]])
    }
}
