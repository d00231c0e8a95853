//! Thin shell elements of a doubly curved, skew patch.

use ancf::mechanics::constraints::{ConstrainedVector, LinearConstraint};
use ancf::mechanics::functions::Function;
use ancf::mechanics::kinematics::Marker;
use ancf::mechanics::shells::{
    ElementPatch, LocalSection, MembraneEnergy, MembraneLaw, SectionField, Shell48, ShellMedium, ShellMesh,
    ShellSection,
};
use ancf::solver::equations::Local;
use nalgebra::{Matrix3, Rotation3, Vector3};

use super::cases::TermCase;
use super::kind::TermKind;
use crate::common::assertions::assert_near;
use crate::common::random::Random;

/// Nodal vectors of r = (x + 0.2 x y, 1.3 y + 0.1 x, 0.3 x² − 0.2 y² + 0.1 x y) at the corners of the unit square.
pub(super) fn reference() -> [Vector3<f64>; 16] {
    std::array::from_fn(|i| {
        let (node, kind) = (i / 4, i % 4);
        let (x, y) = ((node % 2) as f64, (node / 2) as f64);
        match kind {
            0 => Vector3::new(x + 0.2 * x * y, 1.3 * y + 0.1 * x, 0.3 * x * x - 0.2 * y * y + 0.1 * x * y),
            1 => Vector3::new(1.0 + 0.2 * y, 0.1, 0.6 * x + 0.1 * y),
            2 => Vector3::new(0.2 * x, 1.3, -0.4 * y + 0.1 * x),
            _ => Vector3::new(0.2, 0.0, 0.1),
        }
    })
}

/// Section of a thick plate, with bending-stretching coupling if stated.
pub(super) fn medium(coupled: bool, damping: [f64; 2]) -> ShellMedium {
    let mut section = ShellSection::isotropic(7.0, 0.3, 2.0, 1.1);
    if coupled {
        section.coupling = Matrix3::new(0.7, 0.1, 0.2, 0.1, -0.5, 0.1, 0.2, 0.1, 0.3);
    }
    let [retardation, mass_damping] = damping;
    ShellMedium { section, axis: None, retardation, mass_damping, gravity: Vector3::new(0.3, -2.0, 0.7) }
}

/// Element whose thickness and fibres vary over the surface.
fn varying(damping: [f64; 2]) -> Shell48 {
    let section = |[x, y]: [f64; 2]| LocalSection {
        scale: 1.0 + 0.5 * x - 0.3 * y * y,
        axis: Some(Vector3::new(1.0, x, 0.2)),
        turn: 0.4 * y,
    };
    let field = SectionField::new(move |_, at| section(at));
    Shell48::all([((0..48).collect(), reference())], &medium(true, damping), Some(&field)).swap_remove(0)
}

pub(super) fn element(coupled: bool, damping: [f64; 2]) -> Shell48 {
    Shell48::all([((0..48).collect(), reference())], &medium(coupled, damping), None).swap_remove(0)
}

/// Values of r = (u + 0.2 u v, 1.3 v, 0.3 u²) and of r_u, r_v, r_uv.
pub(super) fn map([u, v]: [f64; 2]) -> [Vector3<f64>; 4] {
    [
        Vector3::new(u + 0.2 * u * v, 1.3 * v, 0.3 * u * u),
        Vector3::new(1.0 + 0.2 * v, 0.0, 0.6 * u),
        Vector3::new(0.2 * u, 1.3, 0.0),
        Vector3::new(0.2, 0.0, 0.0),
    ]
}

/// Pressure on an element and a support of two nodal vectors.
fn pressure_and_support() -> [TermCase; 2] {
    let mesh = ShellMesh::new(0, [1, 1], Vector3::x(), map, &medium(false, [0.0; 2]));
    let pressure = ElementPatch::thin(&mesh, 0, Vector3::zeros()).pressure(1.7, &Function::ONE);
    let vector = |first, is_position| ConstrainedVector {
        first,
        reference: Vector3::new(0.3, 1.0, -0.4),
        direction: Vector3::new(0.2, -0.7, 0.4),
        is_position,
    };
    let about = Marker::fixed(Vector3::y());
    let support = LinearConstraint::new(vec![vector(0, true), vector(6, false)], &about, 0, "support");
    [
        TermCase { name: "pressure".into(), term: pressure, kind: TermKind::NonConservative },
        TermCase { name: "support of a shell".into(), term: Box::new(support), kind: TermKind::Polynomial },
    ]
}

/// Smooth laws of the membrane with names and damping.
pub(super) const MEMBRANES: [(&str, MembraneLaw, [f64; 2]); 3] = {
    let linear = MembraneEnergy::Linear { stiffness: 7.7, poisson: 0.3 };
    let rubber = MembraneEnergy::NeoHookean { stiffness: 2.6 };
    [
        ("membrane, linear", MembraneLaw { energy: linear, tension_field: None }, [0.0; 2]),
        ("membrane, NeoHookean", MembraneLaw { energy: rubber, tension_field: None }, [0.0; 2]),
        ("membrane, NeoHookean, damped", MembraneLaw { energy: rubber, tension_field: None }, [0.2, 0.7]),
    ]
};

/// Elements with other laws of the membrane.
fn membranes() -> impl Iterator<Item = TermCase> {
    MEMBRANES.into_iter().map(|(name, law, damping)| {
        let medium = medium(false, damping);
        let medium = ShellMedium { section: medium.section.with_law(Some(law)), ..medium };
        let term = Shell48::all([((0..48).collect(), reference())], &medium, None).swap_remove(0);
        let kind = if damping[0] == 0.0 { TermKind::Smooth } else { TermKind::Retarded };
        TermCase { name: format!("shell {name}"), term: Box::new(term), kind }
    })
}

/// Elements without and with coupling and damping, their loads and supports.
pub(super) fn shell_terms() -> impl Iterator<Item = TermCase> {
    let cases = [
        ("shell", false, [0.0; 2], TermKind::Smooth),
        ("shell, coupled", true, [0.0; 2], TermKind::Smooth),
        ("shell, damped", true, [0.2, 0.7], TermKind::Retarded),
    ];
    let elements = cases.into_iter().map(|(name, coupled, damping, kind)| TermCase {
        name: name.into(),
        term: Box::new(element(coupled, damping)),
        kind,
    });
    let varying = TermCase {
        name: "shell, varying".into(),
        term: Box::new(varying([0.2, 0.7])),
        kind: TermKind::Retarded,
    };
    elements.chain([varying]).chain(membranes()).chain(pressure_and_support())
}

/// A finite rigid motion of the deformed element changes no energy, and rotates its forces.
#[test]
fn shells_are_objective() {
    use ancf::solver::equations::Term;
    let (shell, reference, mut random) = (element(true, [0.0; 2]), reference(), Random(48));
    let turn = Rotation3::from_axis_angle(&nalgebra::Unit::new_normalize(Vector3::new(1.0, -2.0, 0.5)), 1.0);
    let moved = |deformed: &[Vector3<f64>; 16]| -> Vec<f64> {
        let vector = |i: usize| {
            let shift = if i.is_multiple_of(4) { Vector3::new(3.0, 1.0, -2.0) } else { Vector3::zeros() };
            turn * (reference[i] + deformed[i]) + shift - reference[i]
        };
        (0..16).flat_map(|i| <[f64; 3]>::from(vector(i))).collect()
    };
    let zeros = [0.0; 48];
    let at = |q: &[f64]| {
        let local = Local { q, v: &zeros, a: &zeros, lambda: &[], t: 0.0, load: 0.0 };
        let mut r = [0.0; 48];
        shell.residual(&local, &mut r);
        (shell.energy(&local).strain, r)
    };
    let (rigid, _) = at(&moved(&[Vector3::zeros(); 16]));
    let deformed: [Vector3<f64>; 16] = std::array::from_fn(|_| random.vector3() * 0.1);
    let straight: Vec<f64> = deformed.iter().flat_map(|x| <[f64; 3]>::from(*x)).collect();
    let ((before, forces), (after, turned)) = (at(&straight), at(&moved(&deformed)));
    assert!(rigid < 1e-26 * before, "rigid motion: {rigid:e} of {before:e}");
    assert_near("energy", after, before, 1e-13);
    for i in 0..16 {
        let [own, other] = [&forces, &turned].map(|r| Vector3::from_column_slice(&r[3 * i..3 * i + 3]));
        assert!((turn * own - other).norm() < 1e-12 * (1.0 + own.norm()), "force {i}");
    }
}
