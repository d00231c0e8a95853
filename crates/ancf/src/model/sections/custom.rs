use std::any::Any;
use std::fmt;
use std::sync::Arc;

use super::shape::SectionShape;
use crate::units::{Scaled, Scales};

/// Sections as trait objects; implemented for every [`SectionShape`] that is `Clone`, `Debug` and [`Scaled`].
pub trait SectionObject: Any + fmt::Debug + Send + Sync {
    /// Section as an implementation of its kind.
    fn shape(&self) -> &dyn SectionShape;

    /// Copies the section into other units.
    fn shared_in(&self, scales: &Scales) -> Arc<dyn SectionObject>;

    /// Section at a fraction of the way to another one; `None` if the kinds differ.
    fn shared_towards(&self, end: &dyn SectionObject, fraction: f64) -> Option<Arc<dyn SectionObject>>;
}

impl<S: SectionShape + Scaled + Clone + fmt::Debug + Send + Sync + 'static> SectionObject for S {
    fn shape(&self) -> &dyn SectionShape {
        self
    }

    fn shared_in(&self, scales: &Scales) -> Arc<dyn SectionObject> {
        Arc::new(self.clone().scaled(scales))
    }

    fn shared_towards(&self, end: &dyn SectionObject, fraction: f64) -> Option<Arc<dyn SectionObject>> {
        let end: &dyn Any = end;
        Some(Arc::new(self.towards(end.downcast_ref::<S>()?, fraction)))
    }
}

/// Section of a kind that a program adds; model files have none.
#[derive(Clone)]
pub struct CustomSection(Arc<dyn SectionObject>);

impl CustomSection {
    /// A section of a kind of the program's own.
    pub fn new(section: impl SectionObject) -> Self {
        Self(Arc::new(section))
    }

    /// Section as an implementation of its kind.
    pub(crate) fn shape(&self) -> &dyn SectionShape {
        self.0.as_ref().shape()
    }

    /// Section at a fraction of the way to another one; `None` if the kinds differ.
    pub(crate) fn towards(&self, end: &Self, fraction: f64) -> Option<Self> {
        Some(Self(self.0.as_ref().shared_towards(end.0.as_ref(), fraction)?))
    }
}

impl fmt::Debug for CustomSection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// Two sections are equal if they are formatted equally: the data of a kind are not comparable in general.
impl PartialEq for CustomSection {
    fn eq(&self, other: &Self) -> bool {
        format!("{self:?}") == format!("{other:?}")
    }
}

impl Scaled for CustomSection {
    fn scaled(self, scales: &Scales) -> Self {
        Self(self.0.as_ref().shared_in(scales))
    }
}
