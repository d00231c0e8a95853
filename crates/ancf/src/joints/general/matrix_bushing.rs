use ancf_mechanics::forces::{self, BushingMatrices};
use nalgebra::{Matrix3, Matrix6, Vector6};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::axes::{directions, frame, rule_of_axes};
use crate::errors::{Finding, finding, number};
use crate::joints::parts::{End, JointBuilder, JointContext, JointKind, JointSymbol, measures};
use crate::model::{Capability, Place};
use crate::units::Scaled;

/// Bushing by matrices: forces and moments that are linear in the displacement d and the rotation vector φ of `a` relative to `b`.
///
/// Force −(T d + C φ + ..) and moment −(Cᵀ d + R φ + ..) in the axes of `b`, with the potential ½ dᵀ T d + dᵀ C φ + ½ φᵀ R φ.
/// The matrices are rows. Rotations are less than half a turn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct MatrixBushing {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// First end, on which the reaction acts.
    pub a: Place,
    /// Second end, to which the axes are fixed; the ground by default.
    #[serde(default)]
    pub b: End,
    /// Direction of the x-axis in the undeformed state, in the global frame; global x by default. Its magnitude has no effect.
    #[unit(none)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub x_axis: Option<[f64; 3]>,
    /// Direction of the y-axis, perpendicular to the x-axis; global y by default.
    #[unit(none)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub y_axis: Option<[f64; 3]>,
    /// Symmetric stiffness T against displacements, force/length.
    #[unit(force / length)]
    pub stiffness: [[f64; 3]; 3],
    /// Symmetric stiffness R against rotations, force length.
    #[unit(force * length / radian)]
    pub rotation_stiffness: [[f64; 3]; 3],
    /// Coupling C of displacements (rows) and rotations (columns), force; none by default.
    #[unit(force)]
    #[serde(default, skip_serializing_if = "is_zero")]
    pub coupling: [[f64; 3]; 3],
    /// Symmetric damping against displacements, force time/length; none by default.
    #[unit(force * time / length)]
    #[serde(default, skip_serializing_if = "is_zero")]
    pub damping: [[f64; 3]; 3],
    /// Symmetric damping against rotations, force length time; none by default.
    #[unit(force * length * time / radian)]
    #[serde(default, skip_serializing_if = "is_zero")]
    pub rotation_damping: [[f64; 3]; 3],
    /// Damping by coupling of displacements (rows) and rotations (columns), force time; none by default.
    #[unit(force * time)]
    #[serde(default, skip_serializing_if = "is_zero")]
    pub coupling_damping: [[f64; 3]; 3],
    /// Force on `a` in the undeformed state, in the axes of the joint, force; none by default.
    #[unit(force)]
    #[serde(default)]
    pub preload: [f64; 3],
    /// Moment on `a` in the undeformed state, in the axes of the joint, force length; none by default.
    #[unit(force * length)]
    #[serde(default)]
    pub preload_moment: [f64; 3],
}

fn is_zero(matrix: &[[f64; 3]; 3]) -> bool {
    *matrix == [[0.0; 3]; 3]
}

/// Relative asymmetry, and negative eigenvalue relative to the largest one, that count as rounding.
const ROUNDING: f64 = 1e-9;

/// Matrix of its rows.
fn rows(matrix: &[[f64; 3]; 3]) -> Matrix3<f64> {
    Matrix3::from_fn(|i, j| matrix[i][j])
}

/// Symmetric matrix of its blocks.
fn blocks(of_displacement: Matrix3<f64>, coupling: Matrix3<f64>, of_rotation: Matrix3<f64>) -> Matrix6<f64> {
    let mut matrix = Matrix6::zeros();
    let symmetric = |block: Matrix3<f64>| (block + block.transpose()) * 0.5;
    matrix.fixed_view_mut::<3, 3>(0, 0).copy_from(&symmetric(of_displacement));
    matrix.fixed_view_mut::<3, 3>(3, 3).copy_from(&symmetric(of_rotation));
    matrix.fixed_view_mut::<3, 3>(0, 3).copy_from(&coupling);
    matrix.fixed_view_mut::<3, 3>(3, 0).copy_from(&coupling.transpose());
    matrix
}

impl JointKind for MatrixBushing {
    fn word(&self) -> &'static str {
        "matrix_bushing"
    }

    fn noun(&self) -> &'static str {
        "bushing"
    }

    fn name(&self) -> &str {
        &self.name
    }

    fn ends(&self) -> (&Place, &End) {
        (&self.a, &self.b)
    }

    fn removes(&self) -> usize {
        0
    }

    fn build(&self, builder: &mut JointBuilder<'_>) {
        let axes = frame([self.x_axis, self.y_axis]);
        let (a, b) = (builder.a(), builder.b());
        let displacements = axes.map(|axis| measures::along(a, b, axis));
        let (cosine, sines) = measures::rotation_vector(a, b, axes);
        let [stiffness, damping] = self.matrices();
        let preload = self.preload.into_iter().chain(self.preload_moment);
        let preload = -Vector6::from_iterator(preload);
        let matrices = BushingMatrices { stiffness, damping, preload };
        builder.add(forces::MatrixBushing::new(displacements, cosine, sines, matrices));
    }

    fn needs(&self) -> [Option<(Capability, &'static str)>; 2] {
        [Some((Capability::Section, "a bushing")); 2]
    }

    fn axes(&self) -> Vec<(&'static str, [f64; 3])> {
        directions([self.x_axis, self.y_axis])
    }

    fn symbol(&self) -> JointSymbol {
        JointSymbol::Line("bushing")
    }

    fn check(&self, path: &str, context: &dyn JointContext) -> Vec<Finding> {
        let symmetric = [
            ("stiffness", &self.stiffness),
            ("rotation_stiffness", &self.rotation_stiffness),
            ("damping", &self.damping),
            ("rotation_damping", &self.rotation_damping),
        ];
        let asymmetric = symmetric.into_iter().filter_map(|(key, matrix)| {
            let matrix = rows(matrix);
            let difference = (matrix - matrix.transpose()).amax();
            let found = format!("a difference of {} between mirrored entries", number(difference));
            let error = || finding(format!("{path}.{key}"), found, "a symmetric matrix");
            (difference > ROUNDING * matrix.amax()).then(error)
        });
        let mut findings: Vec<Finding> = asymmetric.collect();
        for (key, matrix) in ["stiffness", "damping"].into_iter().zip(self.matrices()) {
            findings.extend(rule_of_sign(&format!("{path}.{key}"), matrix, context.length()));
        }
        findings.extend(rule_of_axes(path, [self.x_axis, self.y_axis]));
        findings
    }
}

/// Finding if a matrix has a negative eigenvalue. A length makes the units of its blocks equal.
fn rule_of_sign(path: &str, matrix: Matrix6<f64>, length: f64) -> Option<Finding> {
    let scale = Vector6::from_fn(|i, _| if i < 3 { 1.0 } else { 1.0 / length });
    let values = Matrix6::from_fn(|i, j| matrix[(i, j)] * scale[i] * scale[j]).symmetric_eigenvalues();
    let (lowest, largest) = (values.min(), values.amax());
    let expected = "blocks that are positive semi-definite together; otherwise the energy has no lower bound";
    let found = format!(
        "blocks with a negative eigenvalue, {} relative to the largest one",
        number(lowest / largest)
    );
    (lowest < -ROUNDING * largest).then(|| finding(path.to_owned(), found, expected))
}

impl MatrixBushing {
    /// Stiffness and damping.
    fn matrices(&self) -> [Matrix6<f64>; 2] {
        [
            blocks(rows(&self.stiffness), rows(&self.coupling), rows(&self.rotation_stiffness)),
            blocks(rows(&self.damping), rows(&self.coupling_damping), rows(&self.rotation_damping)),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_form_a_symmetric_matrix() {
        let coupling = [[0.0, 2.0, 0.0], [0.0; 3], [0.0; 3]];
        let matrix = blocks(Matrix3::identity(), rows(&coupling), Matrix3::identity() * 3.0);
        assert_eq!((matrix[(0, 4)], matrix[(4, 0)], matrix[(5, 5)]), (2.0, 2.0, 3.0));
        assert!(rule_of_sign("stiffness", matrix, 1.0).is_some()); // 1·3 < 2²
        assert!(rule_of_sign("stiffness", matrix, 10.0).is_some());
    }
}
