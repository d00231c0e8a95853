//! Bounds of the rounding errors of the forces of a cable element.

use nalgebra::Vector3;

use super::cable_profile::{CableProfile, CableStation};
use crate::kinematics::AxialStretch;

/// Bounds the rounding error of N t.
pub(super) fn axial_rounding(
    profile: &CableProfile,
    station: &CableStation,
    stretch: &AxialStretch,
    [q, v]: [&[Vector3<f64>; 4]; 2],
) -> f64 {
    let (rigidity, tau) = (profile.section().axial, profile.damping().stretch);
    let (u, rate) = (station.first(q).norm(), station.first(v));
    let ([du, _], [drate, _]) = (station.rounding(q), station.rounding(v));
    let dt = du / stretch.length + f64::EPSILON;
    let dstrain = du + f64::EPSILON * (2.0 + u) * u / (stretch.length + 1.0);
    let retarded = tau * (drate + (dt + f64::EPSILON) * rate.norm());
    rigidity * (dstrain + retarded) + profile.axial_force(stretch, &rate).abs() * (dt + f64::EPSILON)
}

/// Bounds the rounding errors of EI Lᵀ(β + τβ°) of a cable with a reference direction.
pub(super) fn bending_rounding(
    profile: &CableProfile,
    station: &CableStation,
    direction: &Vector3<f64>,
    [q, v]: [&[Vector3<f64>; 4]; 2],
) -> [f64; 2] {
    let (rigidity, tau) = (profile.section().bending, profile.damping().bending);
    let ([du, db], [da_rate, db_rate]) = (station.rounding(q), station.rounding(v));
    let (a, b) = ((direction + station.first(q)).norm(), station.second(q).norm());
    let [a_rate, b_rate] = station.both(v).map(|x| x.norm());
    // The error of a is relative, the others are absolute. β depends on b, and β° on ḃ and b ȧ/|a|, all divided by
    // |a|.
    let da = du / a + f64::EPSILON;
    let (strain, dstrain) = (b / a, (db + 4.0 * b * da) / a);
    let rate = (b_rate + 4.0 * b * a_rate / a) / a;
    let drate = (db_rate + 4.0 * (db * a_rate + b * da_rate) / a) / a + 6.0 * rate * da;
    let (m, dm) = (strain + tau * rate, dstrain + tau * drate);
    let of_a = 2.0 * (b * dm + db * m + 4.0 * b * m * da) / (a * a);
    [rigidity * of_a, rigidity * (dm + 2.0 * m * da) / a]
}
