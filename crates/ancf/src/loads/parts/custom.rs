use std::fmt;

use super::kind::LoadKind;
use crate::units::{Scaled, Scales};

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

    /// The load as a mutable implementation of its kind.
    pub(crate) fn kind_mut(&mut self) -> &mut dyn LoadKind {
        self.0.as_mut()
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
