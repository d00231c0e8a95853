use ancf_solver::equations::Batch;

/// Elements that can be evaluated in batches.
pub(crate) trait BatchElements: Sized {
    /// Creates batches of elements, each with the index of its first element.
    fn batches(elements: &[Self]) -> Vec<(usize, Box<dyn Batch>)>;
}
