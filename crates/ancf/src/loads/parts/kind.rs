use std::fmt;

use super::axis_part::AxisPart;
use super::builder::LoadBuilder;
use super::context::LoadContext;
use crate::errors::Finding;
use crate::model::{Capability, Place, TimeFunction};
use crate::units::{Scaled, Scales};

/// A kind of load on bodies.
///
/// An implementation states the data of the load, where it acts, its demands on the body there, its checks and its terms of the
/// equations of motion. Kinds of model files are registered in `loads/load.rs`; a program adds its own by
/// [`SimulationBuilder::with`](crate::SimulationBuilder::with).
pub trait LoadKind: LoadObject + fmt::Debug + Send + Sync {
    /// Noun of the kind in messages and counts.
    fn noun(&self) -> &'static str;

    /// Noun of the load in drawings.
    fn label(&self) -> &'static str {
        self.noun()
    }

    /// Adds the terms of the load.
    fn build(&self, builder: &mut LoadBuilder<'_>);

    /// Point of application of a concentrated load.
    fn on(&self) -> Option<&Place> {
        None
    }

    /// Loaded part of a body, of a load per length.
    fn along(&self) -> Option<AxisPart<'_>> {
        None
    }

    /// Name of a load that has one.
    fn name(&self) -> Option<&str> {
        None
    }

    /// Bodies that the load names other than by its place, with their keys.
    fn bodies(&self) -> Vec<(String, &str)> {
        Vec::new()
    }

    /// Capability that the load requires of its body, with a noun phrase for messages.
    fn needs(&self) -> Option<(Capability, &'static str)> {
        None
    }

    /// Function of time that multiplies the load.
    fn time(&self) -> Option<&TimeFunction> {
        None
    }

    /// Mutable function of time.
    fn time_mut(&mut self) -> Option<&mut TimeFunction> {
        None
    }

    /// True if the load depends on the rates of its function of time.
    fn uses_rates(&self) -> bool {
        false
    }

    /// True for a load that rotates with the section or the rigid body.
    fn is_follower(&self) -> bool {
        false
    }

    /// True if the section forces within an element follow from the forces of the load at its nodes. Estimates of the error of the
    /// mesh are rough otherwise.
    fn is_known_within_elements(&self) -> bool {
        false
    }

    /// True for moments that vary within an element or act at a point there: the nodal forces do not state their places, and estimates
    /// of the error of the mesh are not known.
    fn has_unknown_moments(&self) -> bool {
        false
    }

    /// Findings of checks that the kind alone requires. `path` is that of the load in the model.
    fn check(&self, _path: &str, _context: &dyn LoadContext) -> Vec<Finding> {
        Vec::new()
    }
}

/// Copies and conversions of loads as trait objects; implemented for every [`LoadKind`] that is `Clone` and [`Scaled`].
pub trait LoadObject {
    /// Copies the load.
    fn boxed(&self) -> Box<dyn LoadKind>;

    /// Copies the load into other units.
    fn boxed_in(&self, scales: &Scales) -> Box<dyn LoadKind>;
}

impl<L: LoadKind + Scaled + Clone + 'static> LoadObject for L {
    fn boxed(&self) -> Box<dyn LoadKind> {
        Box::new(self.clone())
    }

    fn boxed_in(&self, scales: &Scales) -> Box<dyn LoadKind> {
        Box::new(self.clone().scaled(scales))
    }
}
