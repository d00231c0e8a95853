use ancf_mechanics::kinematics::VectorKind;
use ancf_solver::equations::{EquationsOfMotion, State};
use nalgebra::Vector3;

use crate::assembly::Assembly;
use crate::model::Model;

/// Largest displacement of a movement, relative to the length of the body, and largest rotation.
pub(super) fn sizes_of(assembly: &Assembly, state: &State, movement: &[f64]) -> [f64; 2] {
    let mut sizes = [0.0_f64; 2];
    for (_, body) in assembly.bodies() {
        let length = body.mesh().map_or(0.0, |mesh| mesh.length());
        for vector in body.vectors(state) {
            let change = Vector3::from_column_slice(&movement[vector.first..vector.first + 3]).norm();
            match vector.kind {
                VectorKind::Position if length > 0.0 => sizes[0] = sizes[0].max(change / length),
                VectorKind::Position | VectorKind::Twist => {}
                _ => sizes[1] = sizes[1].max(change / vector.value.norm()),
            }
        }
    }
    sizes
}

/// Size of each coordinate: the length of the model for positions, the magnitude of directions, and the length or 1 for coordinates of
/// joints.
pub(crate) fn coordinate_sizes(model: &Model, assembly: &Assembly) -> Vec<f64> {
    let rest = assembly.rest();
    let length = if model.length() > 0.0 { model.length() } else { 1.0 };
    let mut sizes = vec![length; rest.q.len()];
    let mut last = length;
    for vector in assembly.bodies().flat_map(|(_, body)| body.vectors(&rest)) {
        if vector.kind != VectorKind::Position {
            // The mixed derivative of a flat patch is zero: it has the size of the tangent before it.
            last = if vector.kind == VectorKind::Twist { last } else { vector.value.norm() };
            sizes[vector.first..vector.first + 3].fill(last);
        }
    }
    for &angle in assembly.system.counted_angles() {
        sizes[angle] = 1.0;
    }
    sizes
}

/// Returns a state that is moved by a multiple of a movement of the coordinates, and of the multipliers if it has any.
pub(crate) fn moved(state: &State, movement: &[f64], factor: f64) -> State {
    let mut moved = state.clone();
    let (q, lambda) = movement.split_at(state.q.len());
    moved.q.iter_mut().zip(q).for_each(|(x, z)| *x += factor * z);
    moved.lambda.iter_mut().zip(lambda).for_each(|(x, z)| *x += factor * z);
    moved
}
