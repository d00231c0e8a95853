//! Equations of bonds: points of a beam move with the points of the shell below them.

use ancf_mechanics::bodies::ShellPlace;

use super::bond_feet::feet;
use crate::joints::parts::JointBuilder;

/// Length of an arm, relative to the length of the beam, that counts as zero.
const NO_ARM: f64 = 1e-9;

/// Adds the equations of a bond of the first body, a beam, to the second one, a shell.
///
/// x, t and l are a point of the axis, its direction, and the direction of the section across it along the shell. S, n
/// and R are the point, the normal or director, and the rotation of the shell below it, d = x − S − R (x₀ − S₀) is the gap.
///
/// Thin shell: d = 0 at two Gauss points of each element and at both ends. These are as many equations as the cubic displacements of the
/// axis have coordinates. With the nodes alone the beam would slip between them.
///
/// Shear-deformable shell:
///
/// * d = 0 at the nodes
/// * t · n constant for the sections of a beam: they rotate with the director
///
/// Both: l · n constant, the section of a beam rotates with the shell about the axis.
pub(super) fn add_equations(builder: &mut JointBuilder<'_>) {
    let Some([beam, shell]) = builder.bodies() else { return };
    let Some(mesh) = beam.terms.mesh() else { return };
    let feet = feet(beam.data, shell.data).expect("checked bonds have points below the beam");
    for (k, foot) in feet.iter().enumerate() {
        let own = mesh.attachment(foot.s);
        let below = shell.terms.attachment(0.0, foot.place.parameters());
        let arm = own.point.reference() - below.point.reference();
        let below = if arm.norm() > NO_ARM * beam.data.length() { below.offset(arm) } else { below };
        let normal = below.direction(foot.normal);
        let [axis, ..] = mesh.axes(foot.s);
        let tangent = axis.reference().normalize();
        let across = foot.normal.cross(&tangent).normalize();
        let is_patch = matches!(foot.place, ShellPlace::Patch(_));
        if !is_patch || !foot.is_node || k == 0 || k + 1 == feet.len() {
            builder.bond_points(&own, &below);
        }
        if !foot.is_node || own.frame().is_none() {
            continue;
        }
        if !is_patch {
            builder.keep_angle(own.direction(tangent), normal.clone(), Some("normal of the section"));
        }
        builder.keep_angle(own.direction(across), normal, Some("rotation about the axis"));
    }
}
