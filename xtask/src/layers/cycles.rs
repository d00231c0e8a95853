//! Strongly connected components of the import graph.

/// Returns the strongly connected components with more than one node, each sorted. Algorithm: Tarjan (1972), with an
/// explicit stack.
pub(super) fn components(successors: &[Vec<usize>]) -> Vec<Vec<usize>> {
    let mut search = Search { successors, ..Search::new(successors.len()) };
    for node in 0..successors.len() {
        if search.order[node].is_none() {
            search.visit(node);
        }
    }
    search.found.sort();
    search.found
}

struct Search<'a> {
    successors: &'a [Vec<usize>],
    /// Order of discovery.
    order: Vec<Option<usize>>,
    /// Lowest order reachable within the component.
    low: Vec<usize>,
    is_open: Vec<bool>,
    open: Vec<usize>,
    next: usize,
    found: Vec<Vec<usize>>,
}

impl Search<'_> {
    fn new(nodes: usize) -> Self {
        Self {
            successors: &[],
            order: vec![None; nodes],
            low: vec![0; nodes],
            is_open: vec![false; nodes],
            open: Vec::new(),
            next: 0,
            found: Vec::new(),
        }
    }

    fn enter(&mut self, node: usize) {
        self.order[node] = Some(self.next);
        self.low[node] = self.next;
        self.next += 1;
        self.is_open[node] = true;
        self.open.push(node);
    }

    fn visit(&mut self, start: usize) {
        self.enter(start);
        let mut path = vec![(start, 0)];
        while let Some(&(node, at)) = path.last() {
            if let Some(&next) = self.successors[node].get(at) {
                path.last_mut().expect("the path has a last node").1 += 1;
                match self.order[next] {
                    None => {
                        self.enter(next);
                        path.push((next, 0));
                    }
                    Some(order) if self.is_open[next] => self.low[node] = self.low[node].min(order),
                    Some(_) => {}
                }
            } else {
                path.pop();
                if let Some(&(above, _)) = path.last() {
                    self.low[above] = self.low[above].min(self.low[node]);
                }
                self.close(node);
            }
        }
    }

    /// Removes the component of a node that reaches nothing older.
    fn close(&mut self, node: usize) {
        if self.order[node] != Some(self.low[node]) {
            return;
        }
        let at = self.open.iter().rposition(|&open| open == node).expect("the node is open");
        let mut component = self.open.split_off(at);
        component.iter().for_each(|&node| self.is_open[node] = false);
        component.sort_unstable();
        if component.len() > 1 {
            self.found.push(component);
        }
    }
}
