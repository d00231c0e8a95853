use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::amd;

use super::index_lists::IndexLists;

/// Computes the approximate minimum degree order of a part of a graph.
pub(crate) fn minimum_degree(graph: &IndexLists, part: &[u32]) -> Vec<usize> {
    let count = part.len();
    if count == 0 {
        return Vec::new();
    }
    let mut place = vec![usize::MAX; graph.len()];
    part.iter().enumerate().for_each(|(at, &g)| place[g as usize] = at);
    let (mut columns, mut rows) = (vec![0], Vec::new());
    for (at, &g) in part.iter().enumerate() {
        let others = graph[g as usize].iter().map(|&other| place[other as usize]);
        let start = rows.len();
        rows.push(at);
        rows.extend(others.filter(|&other| other != usize::MAX));
        rows[start..].sort_unstable();
        columns.push(rows.len());
    }
    let graph = SymbolicSparseColMatRef::new_checked(count, count, &columns, None, &rows);
    let (mut order, mut inverse) = (vec![0; count], vec![0; count]);
    let mut memory = MemBuffer::new(amd::order_scratch::<usize>(count, rows.len()));
    let done =
        amd::order(&mut order, &mut inverse, graph, amd::Control::default(), MemStack::new(&mut memory));
    // AMD fails only on index overflow. The natural order is then used.
    if done.is_ok() { order } else { (0..count).collect() }
}
