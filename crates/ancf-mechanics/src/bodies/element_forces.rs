//! Forces at the ends of an element and loads between them.

use ancf_solver::equations::{LOCAL, Local, LocalMatrix, State, Term, Weights};
use nalgebra::Vector3;

use super::mesh::BeamMesh;
use crate::constraints::Wrench;
use crate::kinematics::VectorKind;
use crate::rods::{PointLoad, RodLoads};

/// Points and weights of the Gauss rule on [0, 1] that is exact to degree three.
const GAUSS: [(f64, f64); 2] = [(0.211_324_865_405_187_1, 0.5), (0.788_675_134_594_812_9, 0.5)];
/// Variance of the place of a load on [0, 1] below which it acts at a point. That of a uniform load is 1/12.
const POINT: f64 = 1e-3;

impl BeamMesh {
    /// Returns the residual of an element and its loads in the rows of the element.
    pub(super) fn element_rows(&self, state: &State, element: usize, loads: &[&dyn Term]) -> [f64; LOCAL] {
        let term = self.term(element);
        let first = term.coordinates()[0];
        let (n, mut rows) = (term.coordinates().len(), residual(term, state));
        for load in loads {
            for (c, row) in load.coordinates().iter().zip(residual(*load, state)) {
                if let Some(place) = c.checked_sub(first).filter(|&place| place < n) {
                    rows[place] += row;
                }
            }
        }
        rows
    }

    /// Returns the forces and moments that balance an element and its loads at its two ends.
    pub(super) fn ends(&self, state: &State, element: usize, loads: &[&dyn Term]) -> [Wrench; 2] {
        let rows = self.element_rows(state, element, loads);
        let n = self.term(element).coordinates().len();
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

    /// Returns the section forces of an element between its ends, from the forces and moments that balance it there.
    ///
    /// Loads whose place has no variance are point loads. All others count as uniform.
    pub(super) fn rod_loads(
        &self,
        state: &State,
        element: usize,
        [start, end]: [Wrench; 2],
        loads: &[&dyn Term],
    ) -> RodLoads {
        let mut points: Vec<PointLoad> =
            loads.iter().filter_map(|load| self.point_load(state, element, *load)).collect();
        points.sort_by(|a, b| a.xi.total_cmp(&b.xi));
        let sum: Vector3<f64> = points.iter().map(|point| point.force).sum();
        let moments: Vector3<f64> = points.iter().map(|point| point.moment).sum();
        let (forces, moment) = ([-start.force, end.force + sum], -start.moment);
        let mut loads = RodLoads { forces, moment, couple: Vector3::zeros(), points };
        let lever = self.lever(state, element, &loads, 1.0);
        loads.couple = (end.moment - moment + lever + moments) / self.length;
        loads
    }

    /// Returns the moment ∫ r′ × f ds of the section forces between the start of an element and ξ.
    pub(super) fn lever(&self, state: &State, element: usize, loads: &RodLoads, xi: f64) -> Vector3<f64> {
        let of_part = |[from, to]: [f64; 2]| -> Vector3<f64> {
            let share = |(x, weight): (f64, f64)| {
                let at = from + (to - from) * x;
                let [tangent, ..] = self.axes((element as f64 + at) * self.length);
                tangent.value(state).cross(&loads.force(at)) * (weight * (to - from) * self.length)
            };
            GAUSS.map(share).iter().sum()
        };
        loads.parts(xi).map(of_part).sum()
    }

    /// Returns the force and moment of a term that acts at one point between the nodes of an element; `None` for distributed
    /// loads.
    ///
    /// The virtual displacements F ξ and F ξ², with the force F, are in the space of the elements. The virtual work of the load
    /// on them gives the mean and the variance of its place. A load without force is placed by the rotations M ξ and M ξ².
    fn point_load(&self, state: &State, element: usize, term: &dyn Term) -> Option<PointLoad> {
        let (first, kinds) = (self.first_coordinate_of(element), self.node_kinds());
        let (n, mut rows) = (self.term(element).coordinates().len(), [0.0; LOCAL]);
        for (c, row) in term.coordinates().iter().zip(residual(term, state)) {
            if let Some(place) = c.checked_sub(first).filter(|&place| place < n) {
                rows[place] -= row;
            }
        }
        let (vectors, nodes) = (n / 3, n / 3 / kinds.len());
        let offset = element * self.stride();
        let value = |i: usize| self.reference[offset + i] + self.displacement(state, offset + i);
        let at = |i: usize| (i / kinds.len()) as f64 / (nodes - 1) as f64;
        let row = |i: usize| Vector3::from_column_slice(&rows[3 * i..3 * i + 3]);
        let (mut force, mut about_origin) = (Vector3::zeros(), Vector3::zeros());
        let mut size = 0.0;
        for i in 0..vectors {
            if kinds[i % kinds.len()] == VectorKind::Position {
                force += row(i);
            }
            about_origin += value(i).cross(&row(i));
            size += row(i).norm() * value(i).norm();
        }
        let work = |displacement: &dyn Fn(usize) -> Vector3<f64>| -> f64 {
            (0..vectors).map(|i| row(i).dot(&displacement(i))).sum()
        };
        let slope = self.slope / self.length;
        // Work of the displacement F ξᵖ, relative to F².
        let of_force = |power: i32| {
            work(&|i| match kinds[i % kinds.len()] {
                VectorKind::Position => force * at(i).powi(power),
                VectorKind::Slope => force * (f64::from(power) * at(i).powi(power - 1) * slope),
                VectorKind::Y | VectorKind::Z => Vector3::zeros(),
            }) / force.norm_squared()
        };
        let moment_at = |xi: f64| {
            let point = self.point((element as f64 + xi) * self.length).value(state) - self.origin;
            about_origin - point.cross(&force)
        };
        let (mean, square) = if force.norm() * self.length > POINT * size {
            (of_force(1), of_force(2))
        } else {
            let moment = about_origin;
            let axis = moment.try_normalize(0.0)?;
            let tangent = (value(vectors - kinds.len()) - value(0)) / self.length;
            let of_moment = |power: i32| {
                work(&|i| {
                    let turn = axis * at(i).powi(power);
                    match kinds[i % kinds.len()] {
                        VectorKind::Position => {
                            let lever = at(i).powi(power + 1) / f64::from(power + 1);
                            axis.cross(&tangent) * (lever * self.length)
                        }
                        _ => turn.cross(&value(i)),
                    }
                }) / moment.norm()
            };
            (of_moment(1), of_moment(2))
        };
        let is_point = (square - mean * mean).abs() < POINT && (0.0..=1.0).contains(&mean);
        is_point.then(|| PointLoad { xi: mean, force, moment: moment_at(mean) })
    }
}

/// State variables of a term, gathered from a global state.
struct Gathered([[f64; LOCAL]; 3]);

impl Gathered {
    fn new(term: &dyn Term, state: &State) -> Self {
        let [mut q, mut v, mut a] = [[0.0; LOCAL]; 3];
        for (i, &c) in term.coordinates().iter().enumerate() {
            (q[i], v[i], a[i]) = (state.q[c], state.v[c], state.a[c]);
        }
        Self([q, v, a])
    }

    fn at<'a>(&'a self, term: &dyn Term, state: &'a State) -> Local<'a> {
        let (n, Self([q, v, a])) = (term.coordinates().len(), self);
        let lambda = &state.lambda[term.multipliers()];
        Local { q: &q[..n], v: &v[..n], a: &a[..n], lambda, t: state.t, load: state.load }
    }
}

/// Evaluates the residual of a term in a global state.
fn residual(term: &dyn Term, state: &State) -> [f64; LOCAL] {
    let (gathered, mut r) = (Gathered::new(term, state), [0.0; LOCAL]);
    let size = term.coordinates().len() + term.multipliers().len();
    term.residual(&gathered.at(term, state), &mut r[..size]);
    r
}

/// Adds the product of the tangent of a term with a displacement w of the coordinates from `first` to the rows of its coordinates
/// and multipliers.
pub(super) fn add_stiffness_product(
    term: &dyn Term,
    state: &State,
    (first, w): (usize, &[f64]),
    sum: &mut [f64],
) {
    let (coordinates, multipliers) = (term.coordinates(), term.multipliers());
    let (n, size) = (coordinates.len(), coordinates.len() + multipliers.len());
    let (gathered, mut storage) = (Gathered::new(term, state), [0.0; LOCAL * (LOCAL + 1) / 2]);
    let mut k = LocalMatrix::zero(size, &mut storage);
    term.tangent(&gathered.at(term, state), Weights::STIFFNESS, &mut k);
    let first_multiplier = state.q.len() + multipliers.start;
    for (j, &c) in coordinates.iter().enumerate() {
        let Some(&w) = c.checked_sub(first).and_then(|place| w.get(place)) else { continue };
        for i in 0..size {
            let row = if i < n { coordinates[i] } else { first_multiplier + i - n };
            sum[row] += k.get(i.max(j), i.min(j)) * w;
        }
    }
}
