use std::fmt;

use ancf_mechanics::functions::Function;
use ancf_mechanics::kinematics::Attachment;
use ancf_solver::equations::Term;

use crate::model::bodies::{Capability, Place};
use crate::model::functions::TimeFunction;
use crate::units::{Scaled, Scales};

/// A kind of load that a program adds.
///
/// The load states the place where it acts, what it requires of the body there, and its terms of the equations of motion.
pub trait LoadKind: LoadObject + fmt::Debug + Send + Sync {
    /// Noun of the kind in messages and counts.
    fn noun(&self) -> &'static str;

    /// Place where the load acts.
    fn on(&self) -> &Place;

    /// Capability that the load requires of the body, with a noun phrase for messages.
    fn needs(&self) -> Option<(Capability, &'static str)> {
        None
    }

    /// Function of time that multiplies the load.
    fn time(&self) -> Option<&TimeFunction> {
        None
    }

    /// Terms of the load at its attachment to the body. `function` is that of [`time`](Self::time); it is 1 in statics, where the
    /// load factor multiplies the load.
    fn terms(&self, on: &Attachment, function: Function) -> Vec<Box<dyn Term>>;
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

/// Load of a kind that a program adds; model files have none.
pub struct CustomLoad(Box<dyn LoadKind>);

impl CustomLoad {
    /// A load of a kind of the program's own.
    pub fn new(load: impl LoadKind + 'static) -> Self {
        Self(Box::new(load))
    }

    /// The load as an implementation of its kind.
    pub(crate) fn kind(&self) -> &dyn LoadKind {
        self.0.as_ref()
    }
}

impl fmt::Debug for CustomLoad {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl Clone for CustomLoad {
    fn clone(&self) -> Self {
        Self(self.0.boxed())
    }
}

/// Two loads are equal if they are formatted equally: the data of a kind are not comparable in general.
impl PartialEq for CustomLoad {
    fn eq(&self, other: &Self) -> bool {
        format!("{self:?}") == format!("{other:?}")
    }
}

impl Scaled for CustomLoad {
    fn scaled(self, scales: &Scales) -> Self {
        Self(self.0.boxed_in(scales))
    }
}
