//! Bodies of all axis interpolations in a fluid.

use std::sync::Arc;

use ancf::mechanics::bodies::{BeamMesh, MeshParameters};
use ancf::mechanics::elements::{BeamMaterial, TwoNodeLaw};
use ancf::mechanics::fluid::{FlowField, HydroSection, MorisonLoad};
use ancf::mechanics::functions::Function;
use ancf::mechanics::kinematics::ReferenceNode;
use ancf::mechanics::sections::DeformationFactors;
use ancf::model::{Material, Section};
use nalgebra::{Rotation3, Vector3};

/// Length of an element, large against the displacements, so that no tangent vector is close to zero.
const LENGTH: f64 = 2.0;

/// Builds rotated bodies of two elements each: two-node beam, three-node beam, cable.
pub(super) fn meshes() -> Vec<(&'static str, BeamMesh)> {
    let section = Section::circle(0.3).cross_section(0.3);
    let medium = BeamMaterial {
        lame: Material::elastic(2.0, 30.0, 0.3).lame(),
        neo_hookean: false,
        density: 2.0,
        retardation: DeformationFactors::default(),
        mass_damping: 0.0,
        gravity: Vector3::zeros(),
    };
    let rotation = Rotation3::from_euler_angles(0.4, -1.1, 2.3);
    let frame = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| rotation * axis);
    let nodes = |parts: usize| -> Vec<ReferenceNode> {
        let at = |k: usize| frame[0] * (2.0 * LENGTH * k as f64 / parts as f64);
        (0..=parts).map(|k| ReferenceNode { position: at(k), frame }).collect()
    };
    let blueprint = MeshParameters {
        first: 0,
        origin: Vector3::new(0.1, -0.2, 0.3),
        length: LENGTH,
        slope: LENGTH,
        medium: &medium,
        section: &|_| section.clone(),
        prismatic: true,
    };
    vec![
        ("two nodes", BeamMesh::two_node(&blueprint, &nodes(2), TwoNodeLaw::Linked)),
        ("three nodes", BeamMesh::three_node(&blueprint, &nodes(4))),
        ("cable", BeamMesh::cable(&blueprint, &nodes(2))),
    ]
}

/// Returns terms of the second element of each body with their names, and whether the fluid flows.
///
/// The fluid is at rest without drag, or flows fast against all velocities below one, where drag is smooth.
pub(super) fn immersed_terms(gravity: Vector3<f64>) -> Vec<(String, MorisonLoad, bool)> {
    let mut terms = Vec::new();
    for (name, mesh) in meshes() {
        let [tangent, across, _] = mesh.reference_axes(0.5);
        let across = if across.norm() > 0.0 { across } else { tangent.cross(&Vector3::x()).normalize() };
        for (speed, density, drag) in [(0.0, 1.7, [0.0; 2]), (12.0, 0.1, [1.3, 0.4])] {
            let function = Function::Sine { frequency: 0.3, phase: 0.9 };
            let current = (tangent + across) * speed;
            let fluid = Arc::new(FlowField { density, gravity, current, function });
            let hull =
                |s: f64| HydroSection { diameter: 0.4 + 0.1 * s, area: 0.2, drag, added_mass: [1.1, 0.3] };
            let term = mesh.hydrodynamic_loads(&fluid, hull).remove(1);
            terms.push((format!("{name} in a fluid of speed {speed}"), term, speed > 0.0));
        }
    }
    terms
}
