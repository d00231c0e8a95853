//! Constraints of orientation between rigid bodies, sections of beams and tangents of cables.

use ancf_mechanics::bodies::normals_to;
use ancf_mechanics::kinematics::Directions::{Line, None, Rigid, Section};
use ancf_mechanics::kinematics::{Attachment, Marker};
use nalgebra::Vector3;

use super::builder::JointBuilder;
use super::clamped_gradients::{ClampedGradients, reference};

/// Cosine of the angle beyond which sections or lines that meet form a corner: 5°.
const CORNER: f64 = 0.996;

impl JointBuilder<'_> {
    /// Constrains the orientations of both ends, by the default of the bodies if `fix` is not stated.
    pub fn clamp(&mut self, fix: Option<ClampedGradients>) {
        let fix = self.fixed(fix);
        clamp(self, fix);
    }
}

/// Constrains the orientations of the two ends of a joint.
fn clamp(builder: &mut JointBuilder<'_>, fix: ClampedGradients) {
    let (here, there) = (builder.a(), builder.b());
    match (&here.directions, &there.directions) {
        (None, _) | (_, None) => {}
        (Rigid(_), Rigid(_)) => {
            let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
            for k in 0..3 {
                keep_angle(builder, &here.direction(axes[k]), &there.direction(axes[(k + 1) % 3]));
            }
        }
        (Section(a), Section(b)) if fix == ClampedGradients::Section && corner(a, b) => {
            clamp_corner(builder, a, b);
        }
        (Section(_), Section(_) | Rigid(_)) => builder.coincide_directions(fix.of(&reference(here))),
        (Rigid(_), Section(_)) => builder.coincide_directions(fix.of(&reference(there))),
        // A line has a tangent only: it stays normal to the directions across it at the other end.
        (Line(tangent), Line(other)) if lines_corner(tangent, other) => keep_angle(builder, tangent, other),
        (Line(tangent), Line(_)) => builder.coincide_directions(&[tangent.reference()]),
        (Line(tangent), Section(_) | Rigid(_)) => {
            if fix == ClampedGradients::All {
                return builder.coincide_directions(&[tangent.reference()]);
            }
            keep_normal(builder, [here, there], tangent);
        }
        (Section(_) | Rigid(_), Line(tangent)) => keep_normal(builder, [there, here], tangent),
    }
}

fn keep_angle(builder: &mut JointBuilder<'_>, a: &Marker, b: &Marker) {
    builder.keep_angle(a, b, Option::None);
}

/// Constrains the tangent of a line to stay normal to two directions of the other end.
fn keep_normal(builder: &mut JointBuilder<'_>, [line, other]: [&Attachment; 2], tangent: &Marker) {
    let tangent = tangent.reference().normalize();
    for normal in normals_to(tangent) {
        keep_angle(builder, &line.direction(tangent), &other.direction(normal));
    }
}

/// Constrains the angles between the section directions of two beams that meet at an angle: the rotations are equal, and each
/// section may change its size.
///
/// Three of the four products of r_y, r_z of one beam with r_y, r_z of the other are constrained: those whose rates separate
/// rotations best.
fn clamp_corner(builder: &mut JointBuilder<'_>, [_, d, e]: &[Marker; 3], [_, y, z]: &[Marker; 3]) {
    let pairs = [(d, y), (d, z), (e, y), (e, z)];
    let turns = pairs.map(|(a, b)| a.reference().cross(&b.reference()));
    let volume = |left: usize| {
        let kept: Vec<_> = (0..4).filter(|&k| k != left).map(|k| turns[k]).collect();
        kept[0].dot(&kept[1].cross(&kept[2])).abs()
    };
    let left = (0..4).max_by(|&i, &j| volume(i).total_cmp(&volume(j))).unwrap_or(0);
    for (_, (a, b)) in pairs.iter().enumerate().filter(|(k, _)| *k != left) {
        keep_angle(builder, a, b);
    }
}

/// True if the sections of two beams are not parallel.
fn corner(a: &[Marker; 3], b: &[Marker; 3]) -> bool {
    let [a, b] = [a, b].map(|axes| axes[1].reference().cross(&axes[2].reference()).normalize());
    a.dot(&b).abs() < CORNER
}

/// True if two lines are not parallel.
fn lines_corner(a: &Marker, b: &Marker) -> bool {
    a.reference().normalize().dot(&b.reference().normalize()).abs() < CORNER
}
