use ancf_solver::equations::Batch;

/// Elements that can be evaluated side by side.
pub(crate) trait Batched: Sized {
    /// Batches of elements, each with the number of its first one.
    fn batches(elements: &[Self]) -> Vec<(usize, Box<dyn Batch>)>;
}
