use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::amd;

use super::index_lists::IndexLists;

/// Computes the approximate minimum degree order of a graph, given the neighbours of each vertex.
pub(crate) fn minimum_degree(graph: &IndexLists) -> Vec<u32> {
    let count = graph.len();
    if count == 0 {
        return Vec::new();
    }
    let (mut columns, mut rows) = (vec![0], Vec::new());
    for (at, others) in graph.iter().enumerate() {
        let start = rows.len();
        rows.push(at);
        rows.extend(others.iter().map(|&other| other as usize));
        rows[start..].sort_unstable();
        columns.push(rows.len());
    }
    let graph = SymbolicSparseColMatRef::new_checked(count, count, &columns, None, &rows);
    let (mut order, mut inverse) = (vec![0; count], vec![0; count]);
    let mut memory = MemBuffer::new(amd::order_scratch::<usize>(count, rows.len()));
    let done =
        amd::order(&mut order, &mut inverse, graph, amd::Control::default(), MemStack::new(&mut memory));
    // AMD fails only on index overflow. The natural order is then used.
    let order = if done.is_ok() { order } else { (0..count).collect() };
    order.into_iter().map(|vertex| vertex as u32).collect()
}
