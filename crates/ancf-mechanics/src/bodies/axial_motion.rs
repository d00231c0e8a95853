use ancf_solver::equations::State;
use nalgebra::Vector3;

use super::mesh::BeamMesh;
use crate::kinematics::VectorKind;

impl BeamMesh {
    /// Returns the derivatives of all nodal vectors along the axis, in the order of the coordinates.
    ///
    /// They are the rates of a motion of the material along the axis, without change of its shape. The slopes of directors jump at
    /// nodes: their derivatives are the means of both elements.
    pub fn axial_derivatives(&self, s: &State) -> Vec<Vector3<f64>> {
        let (kinds, count) = (self.node_kinds(), self.weights(0.0).len());
        let vectors: Vec<Vector3<f64>> = self.vectors(s).map(|vector| vector.value).collect();
        let mut derivatives = vec![(Vector3::zeros(), 0.0); vectors.len()];
        for element in 0..self.count() {
            let first = element * self.stride();
            let directors =
                [0.0, 0.5, 1.0].map(|xi| self.element_directors(&vectors[first..first + count], xi));
            let places = if count == 2 * kinds.len() { &[0, 2][..] } else { &[0, 1, 2] };
            for (i, derivative) in derivatives[first..first + count].iter_mut().enumerate() {
                let (place, kind) = (places[i / kinds.len()], kinds[i % kinds.len()]);
                let rate = |axis: usize| self.slope * self.slope_of(&directors.map(|all| all[axis]), place);
                derivative.0 += match kind {
                    VectorKind::Position => directors[place][0],
                    VectorKind::Slope | VectorKind::Twist => rate(0),
                    VectorKind::Y => rate(1),
                    VectorKind::Z => rate(2),
                };
                derivative.1 += 1.0;
            }
        }
        let mut derivatives: Vec<_> = derivatives.into_iter().map(|(sum, elements)| sum / elements).collect();
        self.extrapolate_to_ends(&mut derivatives);
        derivatives
    }

    /// Extrapolates the derivatives of linear directors, which are those of the middle of an element, to the ends of the axis.
    fn extrapolate_to_ends(&self, derivatives: &mut [Vector3<f64>]) {
        let (kinds, count) = (self.node_kinds(), derivatives.len());
        let node = kinds.len();
        if self.count() == 1 || self.stride() != node {
            return;
        }
        let is_linear = |(_, kind): &(usize, &VectorKind)| matches!(kind, VectorKind::Y | VectorKind::Z);
        for (i, _) in kinds.iter().enumerate().filter(is_linear) {
            for (end, next) in [(i, node + i), (count - node + i, count - 2 * node + i)] {
                derivatives[end] = derivatives[end] * 2.0 - derivatives[next];
            }
        }
    }

    /// Returns r_x, r_y and r_z of an element with some vectors at ξ.
    fn element_directors(&self, vectors: &[Vector3<f64>], xi: f64) -> [Vector3<f64>; 3] {
        let mut axes = [Vector3::zeros(); 3];
        for ((kind, value, directors), vector) in self.weights(xi).into_iter().zip(vectors) {
            match kind {
                VectorKind::Position | VectorKind::Slope | VectorKind::Twist => {
                    axes[0] += vector * directors[0];
                }
                VectorKind::Y => axes[1] += vector * value,
                VectorKind::Z => axes[2] += vector * value,
            }
        }
        axes
    }

    /// Returns the derivative along the axis of a director with values at the start, middle and end of an element. It is exact, since
    /// directors are at most quadratic.
    fn slope_of(&self, [start, middle, end]: &[Vector3<f64>; 3], place: usize) -> Vector3<f64> {
        let difference = match place {
            0 => middle * 4.0 - start * 3.0 - end,
            1 => end - start,
            _ => start - middle * 4.0 + end * 3.0,
        };
        difference / self.length
    }
}
