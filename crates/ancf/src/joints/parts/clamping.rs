//! Constraints of orientation between rigid bodies, sections of beams and tangents of cables.

use ancf_mechanics::bodies::normals_to;
use ancf_mechanics::constraints::{BilinearMeasure, MeasureFactor, MeasureTarget};
use ancf_mechanics::kinematics::Directions::{Line, None, Rigid, Section, Surface};
use ancf_mechanics::kinematics::{Attachment, BodyVector, Marker, SectionFrame};
use nalgebra::Vector3;

use super::builder::JointBuilder;
use super::end::{ClampedGradients, reference};

/// Cosine of the angle beyond which lines that meet form a corner: 5°.
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
                builder.keep_angle(here.direction(axes[k]), there.direction(axes[(k + 1) % 3]), Option::None);
            }
            builder.expect_aligned(&axes);
        }
        (Section(..), Section(..) | Rigid(_)) if fix == ClampedGradients::All => {
            builder.coincide_directions(&reference(here));
        }
        (Rigid(_), Section(..)) if fix == ClampedGradients::All => {
            builder.coincide_directions(&reference(there));
        }
        (Section(_, frame) | Surface(frame), Section(..) | Surface(_) | Rigid(_)) => {
            clamp_section(builder, frame, there, true);
        }
        (Rigid(_), Section(_, frame) | Surface(frame)) => clamp_section(builder, frame, here, false),
        // A line has a tangent only: it stays normal to the directions across it at the other end.
        (Line(tangent), Line(other)) if lines_corner(tangent, other) => {
            builder.keep_angle(tangent, other, Option::None);
        }
        (Line(tangent), Line(_)) => builder.coincide_directions(&[tangent.reference()]),
        (Line(tangent), Section(..) | Rigid(_)) | (Section(..) | Rigid(_), Line(tangent))
            if fix == ClampedGradients::All =>
        {
            builder.coincide_directions(&[tangent.reference()]);
        }
        (Line(_), Section(..) | Surface(_) | Rigid(_)) => keep_normal(builder, here, there, true),
        (Section(..) | Surface(_) | Rigid(_), Line(_)) => keep_normal(builder, there, here, false),
    }
}

/// Constrains the tangent of a line to stay normal to two directions of the other end.
///
/// The order of the ends decides the sign of the reaction. `first` is true if the line is the first end.
fn keep_normal(builder: &mut JointBuilder<'_>, line: &Attachment, other: &Attachment, first: bool) {
    let Line(tangent) = &line.directions else { return };
    let tangent = tangent.reference().normalize();
    for normal in normals_to(tangent) {
        let (along, across) = (line.direction(tangent), other.direction(normal));
        let [a, b] = if first { [along, across] } else { [across, along] };
        builder.keep_angle(a, b, Option::None);
    }
}

/// Constrains the frame of a section to the frame X, Y, Z of the other end: X·d = 0, X·e = 0, w_y Z·d = w_z Y·e.
///
/// The section may change its size and shape, and r_x is free. The equations also hold half a turn away. These states are
/// inadmissible. `first` is true if the section belongs to the first end.
fn clamp_section(builder: &mut JointBuilder<'_>, frame: &SectionFrame, other: &Attachment, first: bool) {
    let [d, e] = frame.directors().each_ref().map(BodyVector::from);
    let [x, y, z] = frame.reference().map(|axis| other.direction(axis));
    let normal = BodyVector::turned(frame, frame.reference()[0]);
    let [w_y, w_z] = frame.weights();
    let sum = |products: &[(f64, &BodyVector, &BodyVector)]| {
        BilinearMeasure::new(products.iter().map(|&(factor, own, other)| match first {
            true => (factor, MeasureFactor::Direction(own), MeasureFactor::Other(other)),
            false => (factor, MeasureFactor::Other(own), MeasureFactor::Direction(other)),
        }))
    };
    let name = "normal of the section";
    builder.keep_where(name, sum(&[(1.0, &d, &x)]), &sum(&[(1.0, &normal, &x)]));
    builder.prescribe(name, sum(&[(1.0, &e, &x)]), MeasureTarget::NONE);
    let (rotation, positive) = (sum(&[(w_y, &d, &z), (-w_z, &e, &y)]), sum(&[(w_y, &d, &y), (w_z, &e, &z)]));
    builder.keep_where("rotation about the normal", rotation, &positive);
}

/// True if two lines are not parallel.
fn lines_corner(a: &Marker, b: &Marker) -> bool {
    a.reference().normalize().dot(&b.reference().normalize()).abs() < CORNER
}
