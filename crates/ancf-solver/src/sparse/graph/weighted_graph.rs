use super::index_lists::IndexLists;

/// Undirected graph with weights of vertices and edges.
#[derive(Clone, Debug)]
pub(crate) struct WeightedGraph {
    /// Neighbours of each vertex.
    neighbours: IndexLists,
    /// Weights of the edges in the order of the neighbours.
    edges: Vec<u32>,
    /// Weights of the vertices.
    weights: Vec<u32>,
}

impl WeightedGraph {
    /// Creates a graph without vertices.
    pub(super) fn new() -> Self {
        Self { neighbours: IndexLists::new(), edges: Vec::new(), weights: Vec::new() }
    }

    /// Creates the part of a graph with the given vertices, of unit edges.
    pub(crate) fn part_of(graph: &IndexLists, weights: &[u32], vertices: &[u32]) -> Self {
        let edges = |vertex: u32| graph[vertex as usize].iter().map(|&other| (other, 1));
        Self::induced(vertices, &mut vec![None; graph.len()], |vertex| weights[vertex as usize], edges)
    }

    /// Returns the part with the given vertices. `place` is working storage, one `None` for each vertex.
    pub(super) fn part(&self, vertices: &[u32], place: &mut [Option<u32>]) -> Self {
        Self::induced(vertices, place, |vertex| self.weight(vertex), |vertex| self.edges(vertex))
    }

    /// Creates the graph of some vertices with the edges between them.
    fn induced<E: Iterator<Item = (u32, u32)>>(
        vertices: &[u32],
        place: &mut [Option<u32>],
        weight: impl Fn(u32) -> u32,
        edges: impl Fn(u32) -> E,
    ) -> Self {
        vertices.iter().zip(0..).for_each(|(&vertex, at)| place[vertex as usize] = Some(at));
        let mut part = Self::new();
        for &vertex in vertices {
            let own = edges(vertex).filter_map(|(other, edge)| Some((place[other as usize]?, edge)));
            part.push(weight(vertex), own);
        }
        vertices.iter().for_each(|&vertex| place[vertex as usize] = None);
        part
    }

    /// Appends a vertex with its edges, as pairs of a neighbour and a weight.
    pub(super) fn push(&mut self, weight: u32, edges: impl Iterator<Item = (u32, u32)>) {
        let Self { neighbours, edges: own, weights } = self;
        neighbours.push(edges.map(|(other, edge)| {
            own.push(edge);
            other
        }));
        weights.push(weight);
    }

    /// Returns the number of vertices.
    pub(crate) fn len(&self) -> usize {
        self.weights.len()
    }

    /// Returns the neighbours of each vertex.
    pub(crate) fn lists(&self) -> &IndexLists {
        &self.neighbours
    }

    /// Returns the neighbours of a vertex.
    pub(super) fn neighbours(&self, vertex: u32) -> &[u32] {
        &self.neighbours[vertex as usize]
    }

    /// Returns the neighbours of a vertex with the weights of the edges.
    pub(super) fn edges(&self, vertex: u32) -> impl Iterator<Item = (u32, u32)> {
        let weights = &self.edges[self.neighbours.range(vertex as usize)];
        self.neighbours(vertex).iter().copied().zip(weights.iter().copied())
    }

    /// Returns the weight of a vertex.
    pub(super) fn weight(&self, vertex: u32) -> u32 {
        self.weights[vertex as usize]
    }

    /// Returns the sum of the weights of all vertices.
    pub(super) fn total(&self) -> u64 {
        self.weights.iter().map(|&weight| u64::from(weight)).sum()
    }
}
