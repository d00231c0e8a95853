//! Results do not depend on which end of a joint is the first one.

use ancf::model::{End, Joint, Place};
use ancf::nalgebra::Vector3;

use super::law::{Check, EQUAL, Law, check_motion};
use crate::compare::{Case, TimeSteps};
use crate::frames::scale;
use crate::random::Random;
use crate::run::Run;

/// Exchange of the ends of all joints between two bodies whose kind is symmetric.
///
/// The axis changes its sign, so that angles and displacements keep theirs. Reactions change their sign. States that
/// satisfy the equations of the joint are the same, others have other residuals. The start values of a motion contain
/// such states, hence their errors differ.
pub(super) struct Exchange;

/// Effect of an exchange on the moment of a joint.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Moment {
    /// Changes its sign.
    Reversed,
    /// Refers to another point.
    Moved,
}

impl Law for Exchange {
    fn name(&self) -> &'static str {
        "exchange"
    }

    fn check(&self, case: &Case, _: &mut Random) -> Check {
        let mut twin = case.model.clone();
        let exchanged: Vec<(String, Moment)> = twin
            .joints
            .iter_mut()
            .filter_map(|joint| {
                let moment = exchange(joint)?;
                Some((joint.name().to_owned(), moment))
            })
            .collect();
        let back = |run: &mut Run| {
            for (joint, moment) in &exchanged {
                for name in ["fx", "fy", "fz", "mx", "my", "mz"] {
                    scale(run, joint, name, -1.0);
                }
                if *moment == Moment::Moved {
                    run.columns.retain(|column| !column.name.starts_with(&format!("{joint}.m")));
                }
            }
        };
        let twin = (!exchanged.is_empty()).then_some(twin);
        check_motion(self.name(), case, twin, back, (EQUAL, TimeSteps::Other))
    }
}

fn reversed(axis: &mut [f64; 3]) {
    *axis = (-Vector3::from(*axis)).into();
}

fn swap(a: &mut Place, b: &mut End) -> Option<()> {
    let End::Place(b) = b else { return None };
    std::mem::swap(a, b);
    Some(())
}

/// Exchanges the ends of a joint between two bodies; `None` if its kind is not symmetric.
fn exchange(joint: &mut Joint) -> Option<Moment> {
    match joint {
        Joint::Clamp(joint) => swap(&mut joint.a, &mut joint.b)?,
        Joint::Spherical(joint) => swap(&mut joint.a, &mut joint.b)?,
        Joint::Distance(joint) => swap(&mut joint.a, &mut joint.b)?,
        Joint::Spring(joint) => swap(&mut joint.a, &mut joint.b)?,
        Joint::Sensor(joint) if joint.axis.is_none() => swap(&mut joint.a, &mut joint.b)?,
        Joint::Revolute(joint) => {
            swap(&mut joint.a, &mut joint.b)?;
            reversed(&mut joint.axis);
        }
        Joint::Universal(joint) => {
            swap(&mut joint.a, &mut joint.b)?;
            std::mem::swap(&mut joint.axis_a, &mut joint.axis_b);
        }
        Joint::Cylindrical(joint) => {
            swap(&mut joint.a, &mut joint.b)?;
            reversed(&mut joint.axis);
            return Some(Moment::Moved);
        }
        Joint::Prismatic(joint) => {
            swap(&mut joint.a, &mut joint.b)?;
            reversed(&mut joint.axis);
            return Some(Moment::Moved);
        }
        // The slip is that of the first place in the plane of the second body.
        Joint::Planar(joint) if joint.friction.is_none() => {
            swap(&mut joint.a, &mut joint.b)?;
            return Some(Moment::Moved);
        }
        Joint::Drive(_)
        | Joint::Planar(_)
        | Joint::PointOnLine(_)
        | Joint::Slide(_)
        | Joint::Bushing(_)
        | Joint::Generic(_)
        | Joint::MatrixBushing(_)
        | Joint::Support(_)
        | Joint::Seam(_)
        | Joint::Bond(_)
        | Joint::Custom(_)
        | Joint::Sensor(_) => {
            return None;
        }
    }
    Some(Moment::Reversed)
}
