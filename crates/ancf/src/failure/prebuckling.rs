//! Deformation before linear buckling. A large one becomes a warning.

use ancf_mechanics::kinematics::{NodalVector, VectorKind};
use ancf_solver::eigen::CriticalLoads;
use ancf_solver::equations::State;
use nalgebra::Vector3;

use crate::assembly::Assembly;
use crate::errors::short;
use crate::units::Scales;

/// Largest change of a direction before buckling, in rad. Larger ones change critical loads by percents.
const SMALL_ROTATION: f64 = 0.1;

/// True for slopes and directors.
fn is_direction(vector: &NodalVector) -> bool {
    !matches!(vector.kind, VectorKind::Position | VectorKind::Twist)
}

/// Warning of critical loads before which the loads deform the structure.
///
/// Linear buckling neglects the deformation before buckling. Its measure is the largest change |s δd|/|d| of the slopes and
/// directors d of a body, by rotation and strain, for the first-order displacement δd of the loads and the factor s.
pub(crate) fn prebuckling_warning(
    assembly: &Assembly,
    s: &State,
    found: &CriticalLoads,
    scales: Scales,
) -> Option<String> {
    let mut worst = (0.0, None);
    for (name, terms) in &assembly.bodies {
        for vector in terms.vectors(s).into_iter().filter(is_direction) {
            let Some(change) = found.response.get(vector.first..vector.first + 3) else { continue };
            let change = Vector3::from_column_slice(change).norm() / vector.value.norm();
            if change > worst.0 {
                worst = (change, Some((name, terms, vector.first)));
            }
        }
    }
    let (change, Some((name, terms, first))) = worst else { return None };
    let rotation = |factor: f64| change * factor.abs();
    let factor =
        found.loads.iter().map(|load| load.factor).find(|factor| rotation(*factor) > SMALL_ROTATION)?;
    let node = terms.locate_coordinate(first).and_then(|(node, _)| node);
    let at = node.map(|node| match terms.shell() {
        None if terms.is_shell() => format!(" at node {node}"),
        Some(mesh) => {
            format!(" at [u, v] = [{}, {}]", short(mesh.node_place(node)[0]), short(mesh.node_place(node)[1]))
        }
        None => format!(" at s = {}", short(scales.length * terms.arc_length(node))),
    });
    let place = format!("body `{name}`{}", at.unwrap_or_default());
    Some(format!(
        "linear buckling neglects the deformation before buckling, which is not small: at the critical load factor {} and above, \
         the loads turn or strain the directions of {place} by {} or more; follow the equilibria with `kind = \"path\"`",
        short(factor),
        short(rotation(factor))
    ))
}
