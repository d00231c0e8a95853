use super::graph::IndexLists;
use super::ordering::Ranks;
use super::symbolic::{NO_PARENT, Segments};

/// Number of rows from which supernodes are merged. Below it a front remains in the cache.
const LARGE: u32 = 96;
/// Largest fraction of zeros in a merged supernode.
const ZEROS: f64 = 0.1;

/// Merges large supernodes with their parents where this adds few zeros. Returns `None` if there are none.
///
/// The update matrix of a child with about the rows of its parent is as large as the front of the parent. It is neither
/// stored nor assembled if both are eliminated together.
///
/// Source: Ashcraft & Grimes (1989), relaxed supernodes; Duff & Reid (1983).
pub(super) fn merged(
    segments: &Segments,
    rows: &IndexLists,
    parent: &[u32],
    labels: &[u32],
) -> Option<Ranks> {
    let length = |list: &[u32]| list.iter().map(|&segment| segments.length(segment)).sum::<u32>();
    // Columns and zeros of each supernode with its merged descendants, and the child that is merged with it.
    let mut columns: Vec<u32> = (0..rows.len() as u32).map(|s| segments.columns(s)).collect();
    let (mut zeros, mut child) = (vec![0.0; rows.len()], vec![None; rows.len()]);
    let mut is_merged = vec![false; rows.len()];
    for at in 0..rows.len() {
        let below = length(&rows[at]);
        // All children of a supernode precede it, so its own columns are complete.
        if let Some(of) = child[at] {
            let of: usize = of;
            zeros[at] +=
                zeros[of] + f64::from(columns[of]) * f64::from(columns[at] + below - length(&rows[of]));
            columns[at] += columns[of];
            is_merged[of] = true;
        }
        if parent[at] == NO_PARENT {
            continue;
        }
        let up = parent[at] as usize;
        let height = columns[up] + length(&rows[up]);
        let all = columns[at] + height;
        let added = zeros[at] + f64::from(columns[at]) * f64::from(height - below);
        let size = f64::from(columns[at] + columns[up]) * f64::from(all);
        let is_best = child[up].is_none_or(|other: usize| below > length(&rows[other]));
        if all >= LARGE && added <= ZEROS * size && is_best {
            child[up] = Some(at);
        }
    }
    is_merged.contains(&true).then(|| {
        let chain = |at: usize| {
            let mut chain: Vec<usize> = std::iter::successors(Some(at), |&at| child[at]).collect();
            chain.reverse();
            chain
        };
        let roots = (0..rows.len()).filter(|&at| !is_merged[at]);
        let unknowns = roots.map(|root| {
            let segments_of = chain(root).into_iter().flat_map(|at| segments.of_supernode(at as u32));
            segments_of.flat_map(|segment| segments.unknowns(segment).iter().copied()).collect::<Vec<_>>()
        });
        Ranks { unknowns: unknowns.collect(), labels: labels.to_vec() }
    })
}
