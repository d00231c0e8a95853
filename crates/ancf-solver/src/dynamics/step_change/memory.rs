use super::SAME;
use super::auxiliary::Auxiliary;
use super::reference::StepReference;
use crate::dynamics::scheme::SchemeCoefficients;
use crate::equations::State;

/// Quantities that depend on the size of the last step.
pub(crate) struct StepMemory<'a> {
    pub(crate) state: &'a mut State,
    /// Auxiliary acceleration a.
    pub(crate) auxiliary: &'a mut [f64],
    /// Damping forces. Their auxiliary values are their share in M a.
    pub(crate) damping: Auxiliary<'a>,
    /// Step size to which the quantities belong; 0 at a start.
    pub(crate) h: &'a mut f64,
    /// Last longer step.
    pub(crate) reference: &'a mut Option<Box<StepReference>>,
}

/// Copy of [`StepMemory`], of the state with the velocities only.
#[derive(Debug)]
pub(crate) struct SavedMemory {
    v: Vec<f64>,
    auxiliary: Vec<f64>,
    damping: Vec<f64>,
    h: f64,
    reference: Option<Box<StepReference>>,
}

impl StepMemory<'_> {
    /// Returns true if a step h differs from the last one so that the memory has to be adapted.
    pub(crate) fn changes_with(&self, h: f64, scheme: SchemeCoefficients) -> bool {
        let is_affected = !scheme.is_conservative() || !self.state.lambda.is_empty();
        let is_changed = *self.h > 0.0 && (h / *self.h - 1.0).abs() > SAME;
        is_changed && is_affected && scheme.averaging.is_none()
    }

    /// Returns a copy.
    pub(crate) fn save(&self) -> Box<SavedMemory> {
        Box::new(SavedMemory {
            v: self.state.v.clone(),
            auxiliary: self.auxiliary.to_vec(),
            damping: self.damping.auxiliary.to_vec(),
            h: *self.h,
            reference: self.reference.clone(),
        })
    }

    /// Restores a copy.
    pub(crate) fn restore(self, saved: SavedMemory) {
        self.state.v = saved.v;
        self.auxiliary.copy_from_slice(&saved.auxiliary);
        self.damping.auxiliary.copy_from_slice(&saved.damping);
        (*self.h, *self.reference) = (saved.h, saved.reference);
    }
}
