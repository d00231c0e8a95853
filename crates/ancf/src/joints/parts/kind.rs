use std::fmt;

use nalgebra::Vector3;

use super::actions::JointActions;
use super::builder::JointBuilder;
use super::coupling::JointCoordinate;
use super::end::End;
use super::friction::JointFriction;
use crate::errors::Finding;
use crate::model::{Body, Capability, JointLaw, LawUse, Place, TimeFunction};
use crate::units::{Scaled, Scales};

/// Kind of joint between a body and the ground or another body.
///
/// An implementation states the data of the joint, the required capabilities of the two ends, its checks, its equations and its symbol in
/// drawings. Kinds of model files are registered in `joints/joint.rs`; a program adds its own by
/// [`SimulationBuilder::with`](crate::SimulationBuilder::with).
pub trait JointKind: JointObject + fmt::Debug + Send + Sync {
    /// Word of the kind in model files.
    fn word(&self) -> &'static str;

    /// Noun of the kind in messages and counts.
    fn noun(&self) -> &'static str {
        self.word()
    }

    /// Name in outputs and messages.
    fn name(&self) -> &str;

    /// First and second end. The reaction acts on the first end.
    fn ends(&self) -> (&Place, &End);

    /// Number of degrees of freedom that the joint removes between two rigid bodies, drives excluded (Grübler's count).
    fn removes(&self) -> usize;

    /// Adds the constraint equations, springs and friction of the joint.
    fn build(&self, builder: &mut JointBuilder<'_>);

    /// Capabilities that the joint requires of its ends, with a noun phrase for messages.
    fn needs(&self) -> [Option<(Capability, &'static str)>; 2] {
        [None, None]
    }

    /// Functions of time, with the suffix of the table that holds each one: `""` for the joint itself.
    fn times(&self) -> Vec<(&'static str, &TimeFunction)> {
        Vec::new()
    }

    /// Mutable functions of time, in the order of [`times`](Self::times).
    fn times_mut(&mut self) -> Vec<&mut TimeFunction> {
        Vec::new()
    }

    /// Force laws. By default those along the angle and the displacement.
    fn laws(&self) -> Vec<LawUse<'_>> {
        self.actions().into_iter().filter_map(|actions| actions.law).collect()
    }

    /// Mutable force laws, in the order of [`laws`](Self::laws).
    fn laws_mut(&mut self) -> Vec<&mut JointLaw> {
        Vec::new()
    }

    /// Directions that must not vanish, with their keys.
    fn axes(&self) -> Vec<(&'static str, [f64; 3])> {
        Vec::new()
    }

    /// Free coordinates of the joint, which couplings can use.
    fn free_coordinates(&self) -> &'static [JointCoordinate] {
        &[]
    }

    /// Drive, spring and friction along the angle of the joint.
    fn angle_actions(&self) -> JointActions<'_> {
        JointActions::default()
    }

    /// Drive, spring and friction along the displacement of the joint.
    fn displacement_actions(&self) -> JointActions<'_> {
        JointActions::default()
    }

    /// Actions along the angle and along the displacement of the joint.
    fn actions(&self) -> [JointActions<'_>; 2] {
        [self.angle_actions(), self.displacement_actions()]
    }

    /// Dry friction of the joint. By default that along its angle or displacement.
    fn friction(&self) -> Option<JointFriction> {
        self.actions().into_iter().find_map(|actions| actions.friction)
    }

    /// Lengths of the bearing on which friction by the reaction depends: keys of `friction`.
    fn bearing_keys(&self) -> &'static [&'static str] {
        &[]
    }

    /// True if a gap between the ends can be closed before the analysis, and if the second end may be a ground point.
    fn closes(&self) -> bool {
        false
    }

    /// True if the second end may be a ground point towards which the joint moves the first one.
    fn accepts_ground_point(&self) -> bool {
        self.closes()
    }

    /// True if the joint spans two distinct points.
    fn spans(&self) -> bool {
        false
    }

    /// True if the two points that the joint spans may coincide.
    fn may_coincide(&self) -> bool {
        false
    }

    /// True if the joint acts along edges or along a body: its places stand for them and need not coincide.
    fn is_distributed(&self) -> bool {
        false
    }

    /// Symbol in figures.
    fn symbol(&self) -> JointSymbol {
        JointSymbol::Marker
    }

    /// Findings of checks that the kind alone requires. `path` is the path of the joint in the model.
    fn check(&self, _path: &str, _context: &dyn JointContext) -> Vec<Finding> {
        Vec::new()
    }
}

/// Copies and conversions of joints as trait objects; implemented for every [`JointKind`] that is `Clone` and [`Scaled`].
pub trait JointObject {
    /// Copies the joint.
    fn boxed(&self) -> Box<dyn JointKind>;

    /// Copies the joint into other units.
    fn boxed_in(&self, scales: &Scales) -> Box<dyn JointKind>;
}

impl<J: JointKind + Scaled + Clone + 'static> JointObject for J {
    fn boxed(&self) -> Box<dyn JointKind> {
        Box::new(self.clone())
    }

    fn boxed_in(&self, scales: &Scales) -> Box<dyn JointKind> {
        Box::new(self.clone().scaled(scales))
    }
}

/// Properties of the model on which the checks of a joint depend.
pub trait JointContext {
    /// Body of a place.
    fn body(&self, place: &Place) -> Option<&Body>;

    /// Point of a place in the reference configuration.
    fn point(&self, place: &Place) -> Option<Vector3<f64>>;

    /// Characteristic length of the model.
    fn length(&self) -> f64;

    /// True if the analysis is a motion from the undeformed state, where drives are zero.
    fn starts_undeformed(&self) -> bool;

    /// Time at the end of a motion; 0 of other analyses.
    fn end_time(&self) -> f64;
}

/// Symbol of a joint in figures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointSymbol {
    /// Marker at the first end.
    Marker,
    /// Line between the two ends, of a style that its name states: `"spring"`, `"rod"`.
    Line(&'static str),
}
