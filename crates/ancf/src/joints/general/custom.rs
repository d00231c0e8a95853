use std::fmt;

use crate::joints::parts::JointKind;
use crate::units::{Scaled, Scales};

/// Joint of a kind that a program adds. Model files do not have such joints.
pub struct CustomJoint(Box<dyn JointKind>);

impl CustomJoint {
    /// Joint of a kind that a program adds.
    pub fn new(joint: impl JointKind + 'static) -> Self {
        Self(Box::new(joint))
    }

    /// Joint as an implementation of its kind.
    pub(crate) fn kind(&self) -> &dyn JointKind {
        self.0.as_ref()
    }

    /// Joint as a mutable implementation of its kind.
    pub(crate) fn kind_mut(&mut self) -> &mut dyn JointKind {
        self.0.as_mut()
    }
}

impl fmt::Debug for CustomJoint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl Clone for CustomJoint {
    fn clone(&self) -> Self {
        Self(self.0.boxed())
    }
}

/// Two joints are equal if they are formatted equally: the data of a kind are not comparable in general.
impl PartialEq for CustomJoint {
    fn eq(&self, other: &Self) -> bool {
        format!("{self:?}") == format!("{other:?}")
    }
}

impl Scaled for CustomJoint {
    fn scaled(self, scales: &Scales) -> Self {
        Self(self.0.boxed_in(scales))
    }
}
