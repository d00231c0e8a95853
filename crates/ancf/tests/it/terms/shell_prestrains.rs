//! Prescribed strains of shell elements: strains, curvatures and tensions about several axes.

use ancf::mechanics::functions::Function;
use ancf::mechanics::shells::{MembraneEnergy, MembraneLaw, ShellMesh, SurfacePrestrain};
use nalgebra::Vector3;

use super::cases::TermCase;
use super::kind::TermKind;
use super::shear_shells::{SHAPES, mesh_of, mesh_with, with_law};
use super::shells::{map, medium};

/// Two sources that vary in time or have an axis of their own.
fn sources() -> Vec<SurfacePrestrain> {
    let first = SurfacePrestrain {
        strain: Vector3::new(0.1, -0.05, 0.08),
        curvature: Vector3::new(0.3, -0.2, 0.4),
        tension: Vector3::zeros(),
        axis: None,
        elements: None,
        function: Function::Sine { frequency: 0.4, phase: 0.3 },
    };
    let second = SurfacePrestrain {
        strain: Vector3::new(0.05, 0.1, 0.0),
        tension: Vector3::new(0.2, 0.1, -0.1),
        axis: Some(Vector3::new(0.3, 1.0, 0.2)),
        function: Function::ONE,
        ..first.clone()
    };
    vec![first, second]
}

/// Prescribed strains of an element of each kind, without and with coupling, and of rubber.
pub(super) fn shell_prestrain_terms() -> impl Iterator<Item = TermCase> {
    let cases = [("", false), (", laminate", true)];
    let linear = cases.into_iter().flat_map(|(name, is_laminate)| {
        let case = |shape: &str, mut terms: Vec<_>| TermCase {
            name: format!("preloaded by prestrain, {shape}{name}"),
            term: terms.pop().expect("the term after the element"),
            kind: TermKind::Smooth,
        };
        let thin = ShellMesh::new(0, [1, 1], Vector3::x(), map, &medium(is_laminate, [0.0; 2]));
        let thin = case("shell", thin.with_prestrains(sources()).terms());
        let thick = SHAPES.map(|(corners, shape)| {
            case(shape, mesh_of(corners, is_laminate, [0.0; 2]).with_prestrains(sources()).terms())
        });
        thick.into_iter().chain([thin])
    });
    linear.chain(rubber_terms())
}

/// Prescribed strains of an element of each kind of rubber.
fn rubber_terms() -> impl Iterator<Item = TermCase> {
    let case = |shape: &str, mut terms: Vec<_>| TermCase {
        name: format!("preloaded by prestrain, {shape}, rubber"),
        term: terms.pop().expect("the term after the element"),
        kind: TermKind::Smooth,
    };
    let law = MembraneLaw { energy: MembraneEnergy::NeoHookean { stiffness: 1.3 }, tension_field: None };
    let mut thin = medium(false, [0.0; 2]);
    thin.section.law = Some(law);
    let thin = ShellMesh::new(0, [1, 1], Vector3::x(), map, &thin);
    let thick = SHAPES.map(|(corners, shape)| {
        let mesh = mesh_with(corners, &with_law(law, [0.0; 2]));
        case(shape, mesh.with_prestrains(sources()).terms())
    });
    thick.into_iter().chain([case("shell", thin.with_prestrains(sources()).terms())])
}
