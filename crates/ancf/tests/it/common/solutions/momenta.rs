//! Linear and angular momentum.

use ancf::assembly::Assembly;
use ancf::solver::equations::{EquationsOfMotion, State, Weights};
use nalgebra::Vector3;

/// Returns ∑ M x and ∑ r × M x over the nodal vectors: the momenta about the origin for x = v.
///
/// Translations move positions only, rotations all nodal vectors.
pub(crate) fn momenta(assembly: &Assembly, s: &State, x: &[f64]) -> [Vector3<f64>; 2] {
    let system = &assembly.system;
    let mut mass = system.matrix();
    system.tangent(s, Weights::MASS, &mut mass);
    let mut full = x.to_vec();
    full.resize(s.q.len() + s.lambda.len(), 0.0);
    let p = mass.times(&full);
    let vectors: Vec<_> = assembly.bodies().flat_map(|(_, body)| body.vectors(s)).collect();
    let of = |first: usize| Vector3::from_column_slice(&p[first..first + 3]);
    let linear = vectors.iter().filter(|vector| vector.is_position()).map(|vector| of(vector.first)).sum();
    [linear, vectors.iter().map(|vector| vector.value.cross(&of(vector.first))).sum()]
}
