use nalgebra::Vector3;

/// Box with faces parallel to the axes.
#[derive(Clone, Copy, Debug)]
pub(in crate::contact) struct AlignedBox {
    lower: Vector3<f64>,
    upper: Vector3<f64>,
}

impl AlignedBox {
    /// Creates the smallest box of some points, enlarged by a margin.
    pub(in crate::contact) fn around(points: &[Vector3<f64>], margin: f64) -> Self {
        let (lower, upper) = (points[0], points[0]);
        let all = points
            .iter()
            .fold(Self { lower, upper }, |all, &point| all.with(&Self { lower: point, upper: point }));
        Self { lower: all.lower.add_scalar(-margin), upper: all.upper.add_scalar(margin) }
    }

    /// Returns the smallest box that contains both.
    pub(in crate::contact) fn with(&self, other: &Self) -> Self {
        Self { lower: self.lower.inf(&other.lower), upper: self.upper.sup(&other.upper) }
    }

    /// Returns true if a point is in the box.
    pub(in crate::contact) fn contains(&self, point: &Vector3<f64>) -> bool {
        (0..3).all(|i| self.lower[i] <= point[i] && point[i] <= self.upper[i])
    }

    fn overlaps(&self, other: &Self) -> bool {
        (0..3).all(|i| self.lower[i] <= other.upper[i] && other.lower[i] <= self.upper[i])
    }
}

/// Binary tree of boxes.
///
/// It is built in each search, in O(n log n). A tree that follows the motion would be faster to update, but would depend on the
/// history.
pub(in crate::contact) struct BoxTree<'a> {
    boxes: &'a [AlignedBox],
    /// Indices of the boxes. Those of a node are consecutive.
    order: Vec<u32>,
    nodes: Vec<BoxNode>,
}

struct BoxNode {
    hull: AlignedBox,
    /// First index in the order and number of boxes.
    first: usize,
    count: usize,
    /// Second child. The first one follows its parent. 0 for a leaf.
    second: usize,
}

/// Maximum number of boxes of a leaf.
const LEAF: usize = 4;

impl<'a> BoxTree<'a> {
    /// Creates a tree. Nodes are halved along the longest edge of their boxes' centres.
    pub(in crate::contact) fn new(boxes: &'a [AlignedBox]) -> Self {
        let order = (0..boxes.len() as u32).collect();
        let mut tree = Self { boxes, order, nodes: Vec::with_capacity(2 * boxes.len() / LEAF + 1) };
        if !boxes.is_empty() {
            tree.build(0, boxes.len());
        }
        tree
    }

    fn build(&mut self, first: usize, count: usize) {
        let (boxes, own) = (self.boxes, &mut self.order[first..first + count]);
        let of = |i: &u32| &boxes[*i as usize];
        let hull = own[1..].iter().fold(*of(&own[0]), |hull, i| hull.with(of(i)));
        let node = self.nodes.len();
        self.nodes.push(BoxNode { hull, first, count, second: 0 });
        if count <= LEAF {
            return;
        }
        let edge = (hull.upper - hull.lower).imax();
        let centre = |i: &u32| of(i).lower[edge] + of(i).upper[edge];
        own.select_nth_unstable_by(count / 2, |a, b| centre(a).total_cmp(&centre(b)));
        self.build(first, count / 2);
        self.nodes[node].second = self.nodes.len();
        self.build(first + count / 2, count - count / 2);
    }

    /// Calls `visit` once for each pair of boxes that overlap, smaller index first.
    pub(in crate::contact) fn visit_pairs(&self, mut visit: impl FnMut(usize, usize)) {
        if !self.nodes.is_empty() {
            self.visit_within(0, &mut visit);
        }
    }

    fn visit_within(&self, node: usize, visit: &mut impl FnMut(usize, usize)) {
        let BoxNode { second, .. } = self.nodes[node];
        if second == 0 {
            let own = self.boxes_of(node);
            own.iter().enumerate().for_each(|(k, &a)| own[..k].iter().for_each(|&b| self.test(a, b, visit)));
        } else {
            self.visit_within(node + 1, visit);
            self.visit_within(second, visit);
            self.visit_between(node + 1, second, visit);
        }
    }

    fn visit_between(&self, one: usize, other: usize, visit: &mut impl FnMut(usize, usize)) {
        let (a, b) = (&self.nodes[one], &self.nodes[other]);
        if !a.hull.overlaps(&b.hull) {
            return;
        }
        match (a.second, b.second) {
            (0, 0) => {
                let pairs = self
                    .boxes_of(one)
                    .iter()
                    .flat_map(|a| self.boxes_of(other).iter().map(move |b| (*a, *b)));
                pairs.for_each(|(a, b)| self.test(a, b, visit));
            }
            (second, of_other) if of_other == 0 || (second != 0 && a.count >= b.count) => {
                self.visit_between(one + 1, other, visit);
                self.visit_between(second, other, visit);
            }
            (_, second) => {
                self.visit_between(one, other + 1, visit);
                self.visit_between(one, second, visit);
            }
        }
    }

    fn boxes_of(&self, node: usize) -> &[u32] {
        let BoxNode { first, count, .. } = self.nodes[node];
        &self.order[first..first + count]
    }

    fn test(&self, a: u32, b: u32, visit: &mut impl FnMut(usize, usize)) {
        let (a, b) = (a.min(b) as usize, a.max(b) as usize);
        if self.boxes[a].overlaps(&self.boxes[b]) {
            visit(a, b);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All overlapping pairs of random boxes are visited once, as by comparison of all pairs.
    #[test]
    fn each_overlapping_pair_once() {
        let mut seed = 5_u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 33) as f64 / f64::from(1_u32 << 31)
        };
        for count in [0, 1, 2, 5, 400] {
            let corner =
                |scale: f64, random: &mut dyn FnMut() -> f64| Vector3::from_fn(|_, _| scale * random());
            let boxes: Vec<AlignedBox> = (0..count)
                .map(|_| {
                    let (a, edge) = (corner(1.0, &mut random), corner(0.2, &mut random));
                    AlignedBox::around(&[a, a + edge], 0.01)
                })
                .collect();
            let mut found = Vec::new();
            BoxTree::new(&boxes).visit_pairs(|a, b| found.push((a, b)));
            found.sort_unstable();
            let all = (0..count).flat_map(|a| (a + 1..count).map(move |b| (a, b)));
            let expected: Vec<_> = all.filter(|&(a, b)| boxes[a].overlaps(&boxes[b])).collect();
            assert_eq!(found, expected);
        }
    }
}
