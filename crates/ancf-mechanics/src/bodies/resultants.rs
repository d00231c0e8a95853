use ancf_solver::equations::{LOCAL, Local, State, Term};
use nalgebra::Vector3;

use super::mesh::BeamMesh;
use crate::constraints::Wrench;
use crate::kinematics::VectorKind;

/// Points and weights of the Gauss rule on [0, 1] that is exact to degree three.
const GAUSS: [(f64, f64); 2] = [(0.211_324_865_405_187_1, 0.5), (0.788_675_134_594_812_9, 0.5)];

impl BeamMesh {
    /// Returns the force and the moment about the section centre at an arc length, in the global frame.
    ///
    /// They are exerted by the part at greater arc length on the other part. Resolved in
    /// [`section_frame`](Self::section_frame), a positive first component of the force is tension.
    ///
    /// `loads` are the terms of other loads and reactions within the element of the arc length
    /// ([`acts_within`](Self::acts_within)). At the nodes, the resultants balance these loads, inertia, body force and damping of the
    /// element. They are exact on any mesh. Within an element, the force is interpolated linearly, and the moment m
    /// satisfies dm/ds = −r′ × f − c with a constant c. This is exact for loads that are uniform in the element.
    pub fn resultants(&self, state: &State, s: f64, loads: &[&dyn Term]) -> Wrench {
        let (element, xi) = self.locate(s);
        let [start, end] = self.ends(state, element, loads);
        let start = Wrench { force: -start.force, moment: -start.moment };
        if xi == 0.0 || xi == 1.0 {
            return if xi == 0.0 { start } else { end };
        }
        let force = |xi: f64| start.force * (1.0 - xi) + end.force * xi;
        // Moment of the forces between the start and ξ.
        let lever = |to: f64| -> Vector3<f64> {
            let share = |(x, weight): (f64, f64)| {
                let [tangent, ..] = self.axes((element as f64 + x * to) * self.length);
                tangent.value(state).cross(&force(x * to)) * (weight * to * self.length)
            };
            GAUSS.map(share).iter().sum()
        };
        let rest = end.moment - start.moment + lever(1.0);
        Wrench { force: force(xi), moment: start.moment - lever(xi) + rest * xi }
    }

    /// Returns N, Qy, Qz and T, My, Mz: the [`resultants`](Self::resultants) in the
    /// [`section_frame`](Self::section_frame).
    pub fn section_forces(&self, state: &State, s: f64, loads: &[&dyn Term]) -> Wrench {
        self.resultants(state, s, loads).seen_from(&self.section_frame(state, s))
    }

    /// Returns the element of an arc length. At a node it is the element that starts there.
    pub fn element_of(&self, s: f64) -> usize {
        self.locate(s).0
    }

    /// True if an arc length is that of an end node of an element.
    pub fn is_node(&self, s: f64) -> bool {
        let (_, xi) = self.locate(s);
        xi == 0.0 || xi == 1.0
    }

    /// Returns the elements with a node among the coordinates.
    pub fn elements_near<'a>(&'a self, coordinates: &'a [usize]) -> impl Iterator<Item = usize> + 'a {
        let own = self.first..self.first + self.coordinates();
        let inside = coordinates.iter().filter(move |c| own.contains(c));
        let stride = 3 * self.stride();
        let near = inside.flat_map(move |c| {
            let element = (c - self.first) / stride;
            element.saturating_sub(1)..=element
        });
        near.filter(|&element| element < self.count())
    }

    /// True if a term with these coordinates acts between the end nodes of an element.
    ///
    /// It then has a vector of the middle node, or directions of both end nodes. Forces between the end nodes themselves
    /// have only their positions.
    pub fn acts_within(&self, coordinates: &[usize], element: usize) -> bool {
        let (stride, kinds) = (self.stride(), self.node_kinds());
        let first = self.first + 3 * stride * element;
        let has = |vector: usize| coordinates.contains(&(first + 3 * vector));
        let directions = (0..kinds.len()).filter(|&k| kinds[k] != VectorKind::Position);
        (kinds.len()..stride).any(has) || directions.into_iter().any(|k| has(k) && has(k + stride))
    }

    /// Returns the forces and moments that balance an element and its loads at its two ends.
    fn ends(&self, state: &State, element: usize, loads: &[&dyn Term]) -> [Wrench; 2] {
        let term = self.term(element);
        let coordinates = term.coordinates();
        let (n, mut rows) = (coordinates.len(), residual(term, state));
        for load in loads {
            for (c, row) in load.coordinates().iter().zip(residual(*load, state)) {
                if let Some(place) = c.checked_sub(coordinates[0]).filter(|&place| place < n) {
                    rows[place] += row;
                }
            }
        }
        let kinds = self.node_kinds();
        let (size, offset) = (n / 3, element * self.stride());
        let vector = |i: usize| self.reference[offset + i] + self.displacement(state, offset + i);
        let mut wrenches = [Wrench::default(); 2];
        for i in 0..size {
            let force = Vector3::from_column_slice(&rows[3 * i..3 * i + 3]);
            let end = usize::from(i >= size - kinds.len());
            // Rows of middle nodes are zero in equilibrium.
            if end == 0 && i >= kinds.len() {
                continue;
            }
            if kinds[i % kinds.len()] == VectorKind::Position {
                wrenches[end].force += force;
            } else {
                wrenches[end].moment += vector(i).cross(&force);
            }
        }
        wrenches
    }

    /// Returns the displacement of a vector.
    pub(super) fn displacement(&self, state: &State, vector: usize) -> Vector3<f64> {
        let first = self.first + 3 * vector;
        Vector3::from_column_slice(&state.q[first..first + 3])
    }
}

/// Evaluates the residual of a term in a global state.
fn residual(term: &dyn Term, state: &State) -> [f64; LOCAL] {
    let (coordinates, multipliers) = (term.coordinates(), term.multipliers());
    let (n, m) = (coordinates.len(), multipliers.len());
    let [mut q, mut v, mut a, mut r] = [[0.0; LOCAL]; 4];
    for (i, &c) in coordinates.iter().enumerate() {
        (q[i], v[i], a[i]) = (state.q[c], state.v[c], state.a[c]);
    }
    let lambda = &state.lambda[multipliers];
    let at = Local { q: &q[..n], v: &v[..n], a: &a[..n], lambda, t: state.t, load: state.load };
    term.residual(&at, &mut r[..n + m]);
    r
}
