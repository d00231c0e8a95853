use std::collections::BTreeMap;

use ancf_mechanics::kinematics::NodalVector;
use ancf_solver::equations::{EquationsOfMotion, State, Weights, all_constraint_rows};
use ancf_solver::factor::{NullSpace, SparseRow, SparseVector, sparse_row};
use nalgebra::{Matrix3, SymmetricEigen, Vector3};

use super::free_motion::{FreeMotion, RigidMotion};
use crate::assembly::Assembly;

/// Rank tolerance, relative to the sum of magnitudes.
const RANK_TOLERANCE: f64 = 1e-9;
/// Largest number of coefficients of free motions that are determined: those of a chain of some 1000 rigid bodies.
///
/// Each joint of an open chain moves all bodies after it, so that the coefficients grow with the square of the bodies.
const MAX_COEFFICIENTS: usize = 1_000_000;
/// Tolerance of zero stiffness, in rounding errors.
const STIFFNESS_TOLERANCE: f64 = 8.0;

impl Assembly {
    /// Independent free motions in a state: rigid-body motions that satisfy all constraints and have no stiffness.
    ///
    /// x = Σ (translation + ω × arm) over the bodies, with Φ_q x = 0, and xᵀ K x = 0 within rounding. Motions that change no
    /// coordinate, such as the spin of a straight cable, are excluded. A pendulum under load has geometric stiffness and no free
    /// motion; in the reference state with λ = 0 it has one. Returns `None` if the motions have too many coefficients to be
    /// determined in seconds.
    pub fn free_motions(&self, s: &State) -> Option<Vec<FreeMotion>> {
        let rigid = RigidModel::new(self, s);
        let unknowns = 6 * rigid.bodies.len() + rigid.joint_coordinates.len();
        let motions: Vec<(usize, SparseVector)> =
            rigid.kernel(self, s)?.basis(unknowns).into_iter().collect();
        if motions.is_empty() {
            // The stiffness would take as much memory as that of the solution.
            return Some(Vec::new());
        }
        let free = self.without_stiffness(s, &rigid, &motions);
        let moves = free.iter().filter(|(leader, motion)| rigid.moves_bodies(*leader, motion));
        Some(moves.map(|(leader, motion)| rigid.describe(self, leader / 6, motion)).collect())
    }

    /// Combinations of motions without stiffness forces.
    fn without_stiffness(
        &self,
        s: &State,
        rigid: &RigidModel,
        motions: &[(usize, SparseVector)],
    ) -> Vec<(usize, SparseVector)> {
        let mut stiffness = self.system.matrix();
        self.system.tangent(s, Weights::STIFFNESS, &mut stiffness);
        let size = stiffness.pattern().size();
        let mut rows = vec![SparseVector::new(); motions.len()];
        // By coordinate: motions that change it, with the displacements.
        let mut movers = vec![Vec::new(); size];
        for (i, (_, y)) in motions.iter().enumerate() {
            rigid.displacements(y).into_iter().for_each(|(c, x)| movers[c].push((i, x)));
        }
        let mut scale = Vec::with_capacity(motions.len());
        let stiffness = stiffness.rows();
        for (j, (_, y)) in motions.iter().enumerate() {
            let displacements = rigid.displacements(y);
            // Forces and the sums of the magnitudes of their parts.
            let mut forces: BTreeMap<usize, [f64; 2]> = BTreeMap::new();
            for &(c, x) in &displacements {
                for &(i, k) in &stiffness[c] {
                    let sums = forces.entry(i).or_default();
                    *sums = [sums[0] + k * x, sums[1] + (k * x).abs()];
                }
            }
            let rounding = |size: f64| STIFFNESS_TOLERANCE * f64::EPSILON * size;
            let size_at = |c: usize| forces.get(&c).map_or(0.0, |sums| sums[1]);
            let of_all: f64 = displacements.iter().map(|&(c, x)| rounding(size_at(c)) * x.abs()).sum();
            scale.push(if of_all > 0.0 { 1.0 / of_all.sqrt() } else { 0.0 });
            // Rotations without stress have rounding errors only, which are excluded from the products.
            for (&c, &[force, _]) in forces.iter().filter(|(_, [force, size])| force.abs() > rounding(*size))
            {
                for &(i, x) in &movers[c] {
                    *rows[i].entry(j).or_default() += x * force;
                }
            }
        }
        let mut kernel = NullSpace::default();
        for (i, row) in rows.into_iter().enumerate() {
            let scaled = row.into_iter().map(|(j, x)| (j, x * scale[i] * scale[j]));
            kernel.add_row(scaled.collect(), 1.0, |_| false);
        }
        let combine = |(leader, parts): (usize, SparseVector)| {
            let mut sum = SparseVector::new();
            for (k, part) in parts {
                // Undoes the scaling of the products.
                let part = if scale[leader] > 0.0 { part * scale[k] / scale[leader] } else { part };
                motions[k].1.iter().for_each(|(&at, y)| *sum.entry(at).or_default() += part * y);
            }
            (motions[leader].0, sum)
        };
        kernel.basis(motions.len()).into_iter().map(combine).collect()
    }
}

/// Bodies of an assembly as rigid bodies.
///
/// Unknowns of body b: 6 b + 0, 1, 2 translations; 6 b + 3, 4, 5 rotations about global axes through its origin, times its
/// length. The coordinates of joints are the unknowns after these.
struct RigidModel {
    bodies: Vec<RigidBodyModel>,
    /// Coordinates of joints.
    joint_coordinates: Vec<usize>,
    /// Body and nodal vector of each coordinate.
    owner: Vec<Option<(usize, usize)>>,
}

struct RigidBodyModel {
    vectors: Vec<NodalVector>,
    /// Node near the first joint, otherwise the centre.
    origin: Vector3<f64>,
    length: f64,
}

impl RigidModel {
    fn new(assembly: &Assembly, s: &State) -> Self {
        let mut owner = vec![None; s.q.len()];
        let mut bodies = Vec::new();
        for (b, (_, body)) in assembly.bodies().enumerate() {
            let vectors = body.vectors(s);
            for (k, vector) in vectors.iter().enumerate() {
                owner[vector.first..vector.first + 3].fill(Some((b, k)));
            }
            bodies.push(RigidBodyModel { vectors, origin: Vector3::zeros(), length: 1.0 });
        }
        let mut joint = vec![None; bodies.len()];
        for term in assembly.system.terms().iter().filter(|term| !term.multipliers().is_empty()) {
            for (b, k) in term.coordinates().iter().filter_map(|&c| owner[c]) {
                let vector = bodies[b].vectors[k];
                if vector.is_position() {
                    joint[b].get_or_insert(vector.value);
                }
            }
        }
        for (body, joint) in bodies.iter_mut().zip(joint) {
            body.locate(joint);
        }
        let joint_coordinates = (0..owner.len()).filter(|&c| owner[c].is_none()).collect();
        Self { bodies, joint_coordinates, owner }
    }

    /// Kernel of all constraints and of rotations without effect; `None` if it has too many coefficients.
    fn kernel(&self, assembly: &Assembly, s: &State) -> Option<NullSpace> {
        let mut kernel = NullSpace::default();
        let translation = |unknown: usize| unknown >= 6 * self.bodies.len() || unknown % 6 < 3;
        for (b, body) in self.bodies.iter().enumerate() {
            for axis in body.null_rotations() {
                let row = (0..3).map(|k| (6 * b + 3 + k, axis[k])).collect();
                kernel.add_row(row, RANK_TOLERANCE, translation);
            }
        }
        let terms = assembly.system.terms().iter().map(AsRef::as_ref);
        for row in self.rows(all_constraint_rows(terms, s.lambda.len(), s)) {
            kernel.add_row(row, RANK_TOLERANCE, translation);
            if kernel.entries() > MAX_COEFFICIENTS {
                return None;
            }
        }
        Some(kernel)
    }

    /// Rows Φ_q for rigid motions, relative to the sum of magnitudes.
    fn rows(&self, constraints: Vec<SparseRow>) -> impl Iterator<Item = SparseRow> {
        let on_rigid = |of_term: SparseRow| {
            let products: Vec<(usize, f64)> = of_term
                .into_iter()
                .flat_map(|(c, entry)| self.motions_of(c).map(move |(j, x)| (j, entry * x)))
                .collect();
            let magnitude = sparse_row(products.iter().map(|(j, x)| (*j, x.abs())).collect());
            let size = magnitude.iter().fold(0.0, |max: f64, (_, x)| max.max(*x));
            let mut row = sparse_row(products);
            row.iter_mut().for_each(|(_, x)| *x /= if size > 0.0 { size } else { 1.0 });
            row
        };
        constraints.into_iter().map(on_rigid)
    }

    /// Derivatives of a coordinate with respect to the six unknowns of its body, or to its own.
    fn motions_of(&self, coordinate: usize) -> impl Iterator<Item = (usize, f64)> {
        let motions = self.owner[coordinate].map(|(b, k)| {
            let (body, vector) = (&self.bodies[b], self.bodies[b].vectors[k]);
            let component = coordinate - vector.first;
            body.motions(&vector)
                .map(|x| x[component])
                .into_iter()
                .enumerate()
                .map(move |(j, x)| (6 * b + j, x))
        });
        let own =
            self.joint_coordinates.binary_search(&coordinate).ok().map(|k| (6 * self.bodies.len() + k, 1.0));
        motions.into_iter().flatten().chain(own)
    }

    /// True if a motion, identified by its free unknown, moves bodies.
    fn moves_bodies(&self, leader: usize, motion: &SparseVector) -> bool {
        let bodies = 6 * self.bodies.len();
        leader < bodies || motion.keys().any(|&unknown| unknown < bodies)
    }

    /// Coordinates that a motion changes, with their displacements.
    fn displacements(&self, motion: &SparseVector) -> Vec<(usize, f64)> {
        let mut moved = Vec::new();
        let mut bodies: Vec<usize> = motion.range(..6 * self.bodies.len()).map(|(j, _)| j / 6).collect();
        bodies.dedup();
        for b in bodies {
            let body = &self.bodies[b];
            let part: Vec<(usize, f64)> = motion.range(6 * b..6 * b + 6).map(|(j, y)| (j % 6, *y)).collect();
            for vector in &body.vectors {
                let motions = body.motions(vector);
                let sum: Vector3<f64> = part.iter().map(|&(j, y)| motions[j] * y).sum();
                moved.extend((0..3).map(|k| (vector.first + k, sum[k])));
            }
        }
        let joints = motion.range(6 * self.bodies.len()..);
        moved
            .extend(joints.map(|(unknown, y)| (self.joint_coordinates[unknown - 6 * self.bodies.len()], *y)));
        moved
    }

    /// Free motion of the bodies, beginning with the leading body.
    fn describe(&self, assembly: &Assembly, leader: usize, motion: &SparseVector) -> FreeMotion {
        let mut moves: Vec<(bool, (String, RigidMotion))> = Vec::new();
        let largest = motion.values().fold(0.0, |max: f64, y| max.max(y.abs()));
        for (b, ((name, _), body)) in assembly.bodies().zip(&self.bodies).enumerate() {
            let of = |j: usize| motion.get(&(6 * b + j)).copied().unwrap_or(0.0);
            let (move_, turn) = (Vector3::from_fn(|k, _| of(k)), Vector3::from_fn(|k, _| of(3 + k)));
            if move_.amax().max(turn.amax()) > RANK_TOLERANCE * largest {
                moves.push((b != leader, (name.to_owned(), body.motion(move_, turn))));
            }
        }
        moves.sort_by_key(|(follows, _)| *follows);
        FreeMotion { moves: moves.into_iter().map(|(_, part)| part).collect() }
    }
}

impl RigidBodyModel {
    fn positions(&self) -> impl Iterator<Item = Vector3<f64>> {
        self.vectors.iter().filter(|vector| vector.is_position()).map(|vector| vector.value)
    }

    /// Sets origin and length.
    fn locate(&mut self, joint: Option<Vector3<f64>>) {
        let centre = self.positions().sum::<Vector3<f64>>() / self.positions().count().max(1) as f64;
        self.origin = joint.unwrap_or(centre);
        let reach = self.positions().map(|r| (r - self.origin).norm()).fold(0.0, f64::max);
        let vector =
            self.vectors.iter().filter(|v| !v.is_position()).map(|v| v.value.norm()).fold(0.0, f64::max);
        self.length = [reach, vector, 1.0].into_iter().find(|&length| length > 0.0).unwrap_or(1.0);
    }

    /// Vector that rotates: a position relative to the origin, or a direction.
    fn arm(&self, vector: &NodalVector) -> Vector3<f64> {
        if vector.is_position() { vector.value - self.origin } else { vector.value }
    }

    /// Derivatives of a nodal vector with respect to the six unknowns.
    fn motions(&self, vector: &NodalVector) -> [Vector3<f64>; 6] {
        let arm = self.arm(vector) / self.length;
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        std::array::from_fn(|j| match j {
            3.. => axes[j - 3].cross(&arm),
            _ if vector.is_position() => axes[j],
            _ => Vector3::zeros(),
        })
    }

    /// Axes of rotations that change no coordinate.
    fn null_rotations(&self) -> Vec<Vector3<f64>> {
        let arms = self.vectors.iter().map(|vector| {
            let (arm, size) = (self.arm(vector), if vector.is_position() { self.length } else { 1.0 });
            if vector.is_position() { arm / size } else { arm.try_normalize(0.0).unwrap_or(arm) }
        });
        let inertia: Matrix3<f64> =
            arms.map(|arm| Matrix3::identity() * arm.norm_squared() - arm * arm.transpose()).sum();
        let eigen = SymmetricEigen::new(inertia);
        // Squares of angles of 10⁻⁶.
        let idle = |k: &usize| eigen.eigenvalues[*k] <= 1e-12 * eigen.eigenvalues.amax();
        (0..3).filter(idle).map(|k| eigen.eigenvectors.column(k).into()).collect()
    }

    /// Motion with a velocity of the origin and an angular velocity times length.
    fn motion(&self, velocity: Vector3<f64>, turn: Vector3<f64>) -> RigidMotion {
        let clean =
            |x: Vector3<f64>, size: f64| x.map(|x| if x.abs() > RANK_TOLERANCE * size { x } else { 0.0 });
        let positive = |x: Vector3<f64>| if x[x.iamax()] < 0.0 { -x } else { x };
        if turn.norm() <= RANK_TOLERANCE * velocity.norm() {
            let along = positive(clean(velocity.normalize(), 1.0)).into();
            return RigidMotion::Translation { along };
        }
        let rate = turn / self.length;
        let through = self.origin + rate.cross(&velocity) / rate.norm_squared();
        let through: [f64; 3] = clean(through, self.length + self.origin.norm()).into();
        let pitch = rate.dot(&velocity) / rate.norm_squared();
        let along = positive(clean(rate.normalize(), 1.0)).into();
        if pitch.abs() > RANK_TOLERANCE * (self.length + velocity.norm() / rate.norm()) {
            RigidMotion::Screw { through, along, pitch }
        } else {
            RigidMotion::Rotation { through, along }
        }
    }
}
