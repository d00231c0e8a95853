use std::any::Any;

use ancf_solver::equations::Term;

use crate::batch::{BatchTerm, TermBatch};
use crate::constraints::ConstraintGroup;
use crate::elements::{Beam24, Beam27, Cable12, RigidTerm};

/// Forms the batches of one kind of terms.
type FormBatches = fn(&[&dyn Term]) -> Vec<TermBatch>;

/// Kinds of terms that are evaluated in batches.
const KINDS: [FormBatches; 5] = [
    batches_of::<Beam24>,
    batches_of::<Beam27>,
    batches_of::<Cable12>,
    batches_of::<RigidTerm>,
    batches_of::<ConstraintGroup>,
];

/// Returns batches of the terms of a system, each with the indices of its terms. Terms of other kinds are in no batch.
pub fn term_batches<T: AsRef<dyn Term>>(terms: &[T]) -> Vec<TermBatch> {
    let terms: Vec<&dyn Term> = terms.iter().map(AsRef::as_ref).collect();
    KINDS.iter().flat_map(|of| of(&terms)).collect()
}

fn batches_of<T: BatchTerm>(terms: &[&dyn Term]) -> Vec<TermBatch> {
    let own = terms.iter().map(|term| (*term as &dyn Any).downcast_ref::<T>()).enumerate();
    let (indices, own): (Vec<usize>, Vec<&T>) = own.filter_map(|(index, term)| Some((index, term?))).unzip();
    let placed =
        |(places, batch): TermBatch| (places.into_iter().map(|place| indices[place]).collect(), batch);
    T::batches(&own).into_iter().map(placed).collect()
}
