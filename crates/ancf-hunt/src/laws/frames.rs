//! Results do not depend on the frame of reference.

use ancf::nalgebra::Matrix3;

use super::law::{Check, EQUAL, Law, check_twin};
use crate::compare::Case;
use crate::frames::Frame;
use crate::random::Random;

fn check(law: &'static str, case: &Case, frame: &Frame) -> Check {
    let back = |run: &mut crate::run::Run| frame.back(&case.model, run);
    check_twin(law, case, frame.model(&case.model), back, EQUAL)
}

/// Rotated frame without special angles.
pub(super) struct Rotation;

impl Law for Rotation {
    fn name(&self) -> &'static str {
        "rotation"
    }

    fn check(&self, case: &Case, random: &mut Random) -> Check {
        check(self.name(), case, &Frame::linear(*random.rotation().matrix()))
    }
}

/// Cyclic exchange of the axes, which maps global axes to global axes.
pub(super) struct QuarterTurn;

impl Law for QuarterTurn {
    fn name(&self) -> &'static str {
        "axes"
    }

    fn check(&self, case: &Case, _: &mut Random) -> Check {
        let cycle = Matrix3::new(0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0);
        check(self.name(), case, &Frame::linear(cycle))
    }
}

/// Reflection in a coordinate plane.
pub(super) struct Reflection;

impl Law for Reflection {
    fn name(&self) -> &'static str {
        "reflection"
    }

    fn check(&self, case: &Case, random: &mut Random) -> Check {
        let mut matrix = Matrix3::identity();
        let k = random.index(3);
        matrix[(k, k)] = -1.0;
        check(self.name(), case, &Frame::linear(matrix))
    }
}

/// Translation by a few lengths.
pub(super) struct Translation;

impl Law for Translation {
    fn name(&self) -> &'static str {
        "translation"
    }

    fn check(&self, case: &Case, random: &mut Random) -> Check {
        let shift = random.direction() * (3.0 * case.model.length());
        check(self.name(), case, &Frame::translation(shift))
    }
}
