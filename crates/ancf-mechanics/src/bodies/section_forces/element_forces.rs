//! Forces at the ends of an element and loads between them.

use ancf_solver::equations::{LOCAL, Local, LocalState, State, Term};
use nalgebra::Vector3;

use crate::bodies::mesh::BeamMesh;
use crate::constraints::Wrench;
use crate::elements::PrestrainTerm;
use crate::kinematics::{VectorKind, gauss4};
use crate::rods::{PointLoad, RodLoads};

/// Variance of the place of a load on [0, 1] below which it acts at a point. That of a uniform load is 1/12.
const POINT: f64 = 1e-3;
/// Number of point loads within an element from which they are integration points of a distributed load.
const SAMPLES: usize = 3;

impl BeamMesh {
    /// Returns the number of coordinates of an element.
    pub fn coordinates_of(&self, element: usize) -> usize {
        self.term(element).coordinates().len()
    }

    /// Returns the number of coordinates between the starts of consecutive elements.
    pub fn coordinates_between(&self) -> usize {
        3 * self.stride()
    }

    /// Evaluates the residual of an element and the forces of its loads.
    pub(super) fn element_rows(&self, state: &State, element: usize, loads: &[&dyn Term]) -> ElementRows {
        self.rows_of(state, element, loads, Damping::Included)
    }

    /// Evaluates the residual of an element without its damping, and the forces of its loads: the strains of a rod follow from the
    /// elastic part of the section forces.
    pub(super) fn elastic_rows(&self, state: &State, element: usize, loads: &[&dyn Term]) -> ElementRows {
        self.rows_of(state, element, loads, Damping::Excluded)
    }

    fn rows_of(&self, state: &State, element: usize, loads: &[&dyn Term], damping: Damping) -> ElementRows {
        let own = residual(self.term(element), state, damping);
        let of_loads: Vec<_> = loads.iter().map(|load| self.load_rows(state, element, *load)).collect();
        let mut sum = own;
        if let Some(term) = self.prestrains.term(element) {
            let forces = match damping {
                Damping::Included => residual(term, state, damping),
                Damping::Excluded => elastic_residual(term, state),
            };
            sum.iter_mut().zip(forces).for_each(|(row, force)| *row += force);
        }
        for forces in &of_loads {
            sum.iter_mut().zip(forces).for_each(|(row, force)| *row -= force);
        }
        ElementRows { own, of_loads, sum, damping }
    }

    /// Returns the forces and moments that balance an element and its loads at its two ends.
    pub(super) fn ends(&self, state: &State, element: usize, rows: &ElementRows) -> [Wrench; 2] {
        let n = self.coordinates_of(element);
        let kinds = self.node_kinds();
        let (size, offset) = (n / 3, element * self.stride());
        let vector = |i: usize| self.vector(state, offset + i);
        let mut wrenches = [Wrench::default(); 2];
        for i in 0..size {
            let force = rows.force(i);
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

    /// Returns the section forces of an element between its ends, from the forces and moments that balance it there.
    ///
    /// Loads whose place has no variance are point loads, unless they are many: follower loads and contacts act at integration
    /// points. The sum of all others, and the body force and the inertia of the element, is fitted by a cubic or quadratic
    /// distribution with the same [`works`](Self::works).
    pub(super) fn rod_loads(
        &self,
        state: &State,
        element: usize,
        [start, end]: [Wrench; 2],
        rows: &ElementRows,
    ) -> RodLoads {
        let ElementRows { own, of_loads, damping, .. } = rows;
        let mut rows = self.body_force_rows(state, element, own, *damping);
        let couples = self.couples(state, element, &rows);
        let mut points: Vec<_> = of_loads.iter().map(|rows| self.point_load(state, element, rows)).collect();
        if points.iter().flatten().count() >= SAMPLES {
            points.fill(None);
        }
        for (more, _) in of_loads.iter().zip(&points).filter(|(_, point)| point.is_none()) {
            rows.iter_mut().zip(more).for_each(|(row, more)| *row += more);
        }
        let mut points: Vec<PointLoad> = points.into_iter().flatten().collect();
        points.sort_by(|a, b| a.xi.total_cmp(&b.xi));
        let sum: Vector3<f64> = points.iter().map(|point| point.force).sum();
        let moments: Vector3<f64> = points.iter().map(|point| point.moment).sum();
        let (forces, moment) = ([-start.force, end.force + sum], -start.moment);
        let deviations = self.deviations(element, &rows);
        let mut loads = RodLoads { forces, deviations, moment, couples, points };
        let lever = self.lever(state, element, &loads, 1.0);
        loads.couples[0] = (end.moment - moment + lever + moments) / self.length;
        loads
    }

    /// Returns r′ at ξ of an element.
    fn tangent(&self, state: &State, element: usize, xi: f64) -> Vector3<f64> {
        let (weights, offset) = (self.weights(xi), element * self.stride());
        let on_axis = |kind: VectorKind| matches!(kind, VectorKind::Position | VectorKind::Slope);
        let parts = weights.iter().enumerate().filter(|(_, (kind, ..))| on_axis(*kind));
        parts.map(|(i, (.., directors))| self.vector(state, offset + i) * directors[0]).sum()
    }

    /// Returns the virtual works of nodal forces on displacements 1, ξ, ξ² and ξ³ in each direction. They are in the space of the
    /// elements, the last one only with two nodes.
    fn works(&self, element: usize, rows: &[f64; LOCAL]) -> [Vector3<f64>; 4] {
        let kinds = self.node_kinds();
        let vectors = self.term(element).coordinates().len() / 3;
        let nodes = vectors / kinds.len();
        let mut works = [Vector3::zeros(); 4];
        for i in 0..vectors {
            let row = Vector3::from_column_slice(&rows[3 * i..3 * i + 3]);
            let xi = (i / kinds.len()) as f64 / (nodes - 1) as f64;
            let slope = self.slope / self.length;
            let values = match kinds[i % kinds.len()] {
                VectorKind::Position => [1.0, xi, xi * xi, xi * xi * xi],
                VectorKind::Slope => [0.0, slope, 2.0 * xi * slope, 3.0 * xi * xi * slope],
                VectorKind::Y | VectorKind::Z | VectorKind::Twist => [0.0; 4],
            };
            works.iter_mut().zip(values).for_each(|(work, value)| *work += row * value);
        }
        works
    }

    /// Returns the deviations from a linear section force of the loads with these nodal forces.
    fn deviations(&self, element: usize, rows: &[f64; LOCAL]) -> [Vector3<f64>; 3] {
        let works = self.works(element, rows);
        // Coefficients of p(ξ) from ∫ p ξᵏ dξ, by the inverse of the Hilbert matrix.
        let of = |row: [f64; 4]| -> Vector3<f64> { works.iter().zip(row).map(|(work, x)| work * x).sum() };
        if self.node_kinds().contains(&VectorKind::Slope) {
            let linear = of([-120.0, 1200.0, -2700.0, 1680.0]);
            let quadratic = of([240.0, -2700.0, 6480.0, -4200.0]);
            let cubic = of([-140.0, 1680.0, -4200.0, 2800.0]);
            [linear / 2.0, quadratic / 3.0, cubic / 4.0]
        } else {
            let linear = of([-36.0, 192.0, -180.0, 0.0]);
            let quadratic = of([30.0, -180.0, 180.0, 0.0]);
            [linear / 2.0, quadratic / 3.0, Vector3::zeros()]
        }
    }

    /// Returns factors of [`RodLoads::couples`] of rotary inertia. The mean is left at zero: it follows from the equilibrium.
    ///
    /// A virtual rotation of the directions y and z that varies as their interpolation is in the space of the elements.
    fn couples(&self, state: &State, element: usize, rows: &[f64; LOCAL]) -> [Vector3<f64>; 3] {
        let kinds = self.node_kinds();
        let vectors = self.term(element).coordinates().len() / 3;
        let nodes = vectors / kinds.len();
        let mut couples = [Vector3::zeros(); 3];
        for i in (0..vectors).filter(|i| matches!(kinds[i % kinds.len()], VectorKind::Y | VectorKind::Z)) {
            let row = Vector3::from_column_slice(&rows[3 * i..3 * i + 3]);
            let couple = self.vector(state, element * self.stride() + i).cross(&row) / -self.length;
            let xi = (i / kinds.len()) as f64 / (nodes - 1) as f64;
            couples[1] += couple * (3.0 * (2.0 * xi - 1.0));
            if nodes > 2 {
                couples[2] += couple * (5.0 * (6.0 * xi * xi - 6.0 * xi + 1.0));
            }
        }
        couples
    }

    /// Returns the body forces less the inertia forces of an element with the residual `own` on its coordinates.
    fn body_force_rows(
        &self,
        state: &State,
        element: usize,
        own: &[f64; LOCAL],
        damping: Damping,
    ) -> [f64; LOCAL] {
        let term = self.term(element);
        let (mut gathered, mut rows) = (LocalState::EMPTY, [0.0; LOCAL]);
        let n = term.coordinates().len();
        let at = damping.applied(gathered.gather(state, term));
        let free = Local { a: &[0.0; LOCAL][..n], load: 0.0, ..at };
        term.residual(&free, &mut rows[..n]);
        rows.iter_mut().zip(own).for_each(|(row, own)| *row -= own);
        rows
    }

    /// Returns the forces of a load on the coordinates of an element.
    fn load_rows(&self, state: &State, element: usize, term: &dyn Term) -> [f64; LOCAL] {
        let (first, n) = (self.first_coordinate_of(element), self.term(element).coordinates().len());
        let mut rows = [0.0; LOCAL];
        for (c, row) in term.coordinates().iter().zip(residual(term, state, Damping::Included)) {
            if let Some(place) = c.checked_sub(first).filter(|&place| place < n) {
                rows[place] -= row;
            }
        }
        rows
    }

    /// Returns the moment ∫ r′ × f ds of the section forces between the start of an element and ξ.
    pub(super) fn lever(&self, state: &State, element: usize, loads: &RodLoads, xi: f64) -> Vector3<f64> {
        let of_part = |[from, to]: [f64; 2]| -> Vector3<f64> {
            let share = |(x, weight): (f64, f64)| {
                let at = from + (to - from) * x;
                let tangent = self.tangent(state, element, at);
                tangent.cross(&loads.force(at)) * (weight * (to - from) * self.length)
            };
            gauss4().map(share).iter().sum()
        };
        loads.parts(xi).map(of_part).sum()
    }

    /// Returns the force and moment of a load with these nodal forces that acts at one point between the nodes of an element;
    /// `None` for distributed loads.
    ///
    /// The [`works`](Self::works) in the direction of the force give the mean and the variance of its place. Moments without a
    /// force count as distributed.
    fn point_load(&self, state: &State, element: usize, rows: &[f64; LOCAL]) -> Option<PointLoad> {
        let (mut about_origin, mut size) = (Vector3::zeros(), 0.0);
        for i in 0..self.term(element).coordinates().len() / 3 {
            let row = Vector3::from_column_slice(&rows[3 * i..3 * i + 3]);
            let vector = self.vector(state, element * self.stride() + i);
            about_origin += vector.cross(&row);
            size += row.norm() * vector.norm();
        }
        let [force, first, second, _] = self.works(element, rows);
        if force.norm() * self.length <= POINT * size {
            return None;
        }
        let [xi, square] = [first, second].map(|work| work.dot(&force) / force.norm_squared());
        if (square - xi * xi).abs() >= POINT || !(0.0..=1.0).contains(&xi) {
            return None;
        }
        let point = self.point((element as f64 + xi) * self.length).value(state) - self.origin;
        Some(PointLoad { xi, force, moment: about_origin - point.cross(&force) })
    }
}

/// Forces in the rows of the coordinates of an element.
pub(super) struct ElementRows {
    /// Residual of the element.
    own: [f64; LOCAL],
    /// Forces of each load.
    of_loads: Vec<[f64; LOCAL]>,
    /// Residual of the element with its prescribed strains, and of its loads.
    sum: [f64; LOCAL],
    damping: Damping,
}

/// Treatment of the damping of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Damping {
    Included,
    Excluded,
}

impl Damping {
    /// Returns the state in which an element is evaluated.
    fn applied(self, at: Local<'_>) -> Local<'_> {
        match self {
            Self::Included => at,
            Self::Excluded => Local { v: &[0.0; LOCAL][..at.v.len()], ..at },
        }
    }
}

impl ElementRows {
    /// Returns the residual in the rows of a vector of the element.
    pub(super) fn force(&self, vector: usize) -> Vector3<f64> {
        Vector3::from_column_slice(&self.sum[3 * vector..3 * vector + 3])
    }
}

/// Evaluates the residual of a term in a global state.
fn residual(term: &dyn Term, state: &State, damping: Damping) -> [f64; LOCAL] {
    let (mut gathered, mut r) = (LocalState::EMPTY, [0.0; LOCAL]);
    let at = damping.applied(gathered.gather(state, term));
    term.residual(&at, &mut r[..at.q.len() + at.lambda.len()]);
    r
}

/// Evaluates the residual of prescribed strains without their rates in a global state.
fn elastic_residual(term: &dyn PrestrainTerm, state: &State) -> [f64; LOCAL] {
    let (mut gathered, mut r) = (LocalState::EMPTY, [0.0; LOCAL]);
    let at = gathered.gather(state, term);
    term.add_elastic(&at, &mut r[..at.q.len()]);
    r
}

/// Adds the product of the tangent of a term with a displacement w of the coordinates from `first` to the rows of its coordinates
/// and multipliers.
///
/// The derivative by differences at ± 1 and ± 2 is exact for cubic polynomials, which the forces of most elements are.
pub(super) fn add_stiffness_product(
    term: &dyn Term,
    state: &State,
    (first, w): (usize, &[f64]),
    step: f64,
    sum: &mut [f64],
) {
    let (coordinates, multipliers) = (term.coordinates(), term.multipliers());
    let (n, size) = (coordinates.len(), coordinates.len() + multipliers.len());
    let mut gathered = LocalState::EMPTY;
    let at = gathered.gather(state, term);
    let mut product = [0.0; LOCAL];
    for (factor, weight) in [(1.0, 8.0), (-1.0, -8.0), (2.0, -1.0), (-2.0, 1.0)] {
        let [mut q, mut r] = [[0.0; LOCAL]; 2];
        q[..n].copy_from_slice(at.q);
        for (q, &c) in q.iter_mut().zip(coordinates) {
            *q += factor * step * c.checked_sub(first).and_then(|place| w.get(place)).unwrap_or(&0.0);
        }
        term.residual(&Local { q: &q[..n], ..at }, &mut r[..size]);
        product.iter_mut().zip(r).for_each(|(product, r)| *product += weight / (12.0 * step) * r);
    }
    let first_multiplier = state.q.len() + multipliers.start;
    for (i, product) in product[..size].iter().enumerate() {
        let row = if i < n { coordinates[i] } else { first_multiplier + i - n };
        sum[row] += product;
    }
}
