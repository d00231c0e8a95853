//! Results of models in another frame, mapped back.

use ancf::Model;
use ancf::model::Joint;
use ancf::nalgebra::{Complex, Vector3};

use super::frame::Frame;
use crate::run::Run;

/// Vectors of columns: names of the components after the owner, true for axial vectors.
const VECTORS: [([&str; 3], bool); 6] = [
    (["vx", "vy", "vz"], false),
    (["ax", "ay", "az"], false),
    (["wx", "wy", "wz"], true),
    (["e1", "e2", "e3"], true),
    (["fx", "fy", "fz"], false),
    (["mx", "my", "mz"], true),
];

/// Components in the frame of a section that change their sign with a reflection.
const REFLECTED: [&str; 7] = ["Qz", "T", "My", "exz", "eyz", "sxz", "syz"];

impl Frame {
    /// Maps the results of a model in this frame back to the frame of the model. Modes have no vectors to map.
    pub fn back(&self, model: &Model, run: &mut Run) {
        let mut owners: Vec<String> = run
            .columns
            .iter()
            .filter_map(|column| Some(column.name.rsplit_once('.')?.0.to_owned()))
            .collect();
        owners.sort();
        owners.dedup();
        let inverse = self.matrix.transpose();
        for owner in &owners {
            self.vector(run, owner, ["x", "y", "z"], |x| inverse * (x - self.shift));
            for (names, is_axial) in VECTORS {
                let sign = if is_axial { self.sign() } else { 1.0 };
                self.vector(run, owner, names, |x| sign * inverse * x);
            }
            for name in REFLECTED {
                scale(run, owner, name, self.sign());
            }
        }
        for joint in &model.joints {
            if matches!(joint, Joint::Cylindrical(_)) {
                scale(run, joint.name(), "displacement", self.sign());
                scale(run, joint.name(), "speed", self.sign());
            }
        }
    }

    fn vector(
        &self,
        run: &mut Run,
        owner: &str,
        names: [&str; 3],
        map: impl Fn(Vector3<f64>) -> Vector3<f64>,
    ) {
        let names = names.map(|name| format!("{owner}.{name}"));
        let [Some(x), Some(y), Some(z)] =
            names.each_ref().map(|name| run.column(name).map(|c| c.values.clone()))
        else {
            return;
        };
        let mapped: Vec<_> = (0..x.len()).map(|row| map(Vector3::new(x[row], y[row], z[row]))).collect();
        for (k, name) in names.iter().enumerate() {
            if let Some(values) = run.values_mut(name) {
                *values = mapped.iter().map(|x| x[k]).collect();
            }
        }
    }
}

/// Multiplies a column by a factor.
pub(crate) fn scale(run: &mut Run, owner: &str, name: &str, factor: f64) {
    if let Some(values) = run.values_mut(&format!("{owner}.{name}")) {
        values.iter_mut().for_each(|x| *x *= factor);
    }
}

/// Rotates section forces about the tangent such that they agree best with a base, in each row.
///
/// For frames that differ by an unknown rotation about the tangent. The magnitudes of Q and M and the angle between them are
/// compared all the same.
pub(crate) fn align(base: &Run, run: &mut Run, owner: &str) {
    const PAIRS: [[&str; 2]; 2] = [["Qy", "Qz"], ["My", "Mz"]];
    let pair = |run: &Run, names: [&str; 2], row: usize| {
        let value = |name: &str| run.column(&format!("{owner}.{name}"))?.values.get(row).copied();
        Some(Complex::new(value(names[0])?, value(names[1])?))
    };
    for row in 0..run.rows().min(base.rows()) {
        let mut sum = Complex::new(0.0, 0.0);
        for names in PAIRS {
            let (Some(a), Some(b)) = (pair(base, names, row), pair(run, names, row)) else { return };
            let largest = |name: &str| base.largest(&format!("{owner}.{name}"));
            let size = largest(names[0]).max(largest(names[1])).max(f64::MIN_POSITIVE);
            sum += (a / size) * (b / size).conj();
        }
        if sum.norm() == 0.0 || !sum.norm().is_finite() {
            continue;
        }
        let turn = sum / sum.norm();
        for names in PAIRS {
            let Some(turned) = pair(run, names, row).map(|x| turn * x) else { return };
            for (name, x) in names.into_iter().zip([turned.re, turned.im]) {
                if let Some(values) = run.values_mut(&format!("{owner}.{name}")) {
                    values[row] = x;
                }
            }
        }
    }
}
