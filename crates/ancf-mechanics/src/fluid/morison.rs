use std::sync::Arc;

use ancf_solver::equations::{Energy, Local, LocalMatrix, Term, Weights};
use nalgebra::{Matrix3, Vector3};

use super::blocks::{each_entry, entry, visit_skew};
use super::flow_field::{FlowField, FluidMotion, HydroCoefficients, RelativeFlow};
use crate::kinematics::ElementAxis;

/// Hydrodynamic load of one element of a slender line: drag, added mass and buoyancy.
///
/// Per undeformed length, with the tangent t, the relative velocity of the fluid w = u − ṙ, its tangential part w_t =
/// t·w and normal part w_n = w − t w_t, a displaced area A and a diameter d (Morison et al. 1950; coefficients as in
/// MoorDyn, Hall & Goupee 2015):
///
/// f = ½ρ d C_n |w_n| w_n + ½ρ π d C_t |w_t| w_t t + ρA u̇ + M (u̇ − r̈) − ρA g,  M = ρA (C_an (I − t tᵀ) + C_at t tᵀ).
///
/// The buoyancy −ρA g assumes fluid all around the line, including its ends. Axial forces are then effective tensions:
/// true force plus pressure times area. Drag, buoyancy and ρA u̇ + M u̇ are loads, which the load factor s multiplies.
/// −M r̈ is inertia and independent of s.
///
/// Energies: ½ ṙ·M ṙ is the kinetic energy of the accelerated fluid, and buoyancy has a potential. The supplied power
/// is F·u of the drag F, the power of a time-dependent current, and ½ ṙ·Ṁ ṙ. The last term occurs since Morison's
/// formula has no forces that rotate the momentum of the fluid with the line. The dissipated power is F·w ≥ 0.
///
/// The mass and the derivative by v are exact. The derivative by q is not symmetric: the tangent contains its symmetric part, and
/// the skew part is stated.
#[derive(Clone, Debug)]
pub struct MorisonLoad {
    coordinates: Vec<usize>,
    fluid: Arc<FlowField>,
    stations: [MorisonStation; 5],
}

/// Quadrature point of the axis.
#[derive(Clone, Copy, Debug)]
struct MorisonStation {
    /// Weights of the vectors in r and in p = dr/ds.
    values: [f64; 4],
    slopes: [f64; 4],
    /// Reference value of p.
    tangent: Vector3<f64>,
    coefficients: HydroCoefficients,
}

impl MorisonLoad {
    /// Creates the load from the weights, the tangent and the section properties at five points of an axis.
    pub(crate) fn new(
        axis: &ElementAxis,
        fluid: Arc<FlowField>,
        points: [([[f64; 4]; 3], Vector3<f64>, HydroCoefficients); 5],
    ) -> Self {
        let stations = points.map(|([values, slopes, _], tangent, coefficients)| MorisonStation {
            values,
            slopes,
            tangent,
            coefficients,
        });
        Self { coordinates: axis.coordinates().collect(), fluid, stations }
    }
}

impl MorisonStation {
    fn flow(&self, at: &Local<'_>, fluid: &FluidMotion) -> RelativeFlow {
        let p = self.tangent + sum(&self.slopes, at.q);
        let stretch = p.norm();
        RelativeFlow {
            tangent: p / stretch,
            stretch,
            relative: fluid.velocity - sum(&self.values, at.v),
            relative_acceleration: fluid.acceleration * at.load - sum(&self.values, at.a),
            load: at.load,
        }
    }

    /// Returns the magnitudes in p, w and b.
    fn sizes(&self, at: &Local<'_>, fluid: &FluidMotion) -> [f64; 3] {
        [
            self.tangent.norm() + size(&self.slopes, at.q),
            fluid.velocity.norm() + size(&self.values, at.v),
            (fluid.acceleration * at.load).norm() + size(&self.values, at.a),
        ]
    }
}

fn vectors(x: &[f64]) -> impl Iterator<Item = Vector3<f64>> + '_ {
    x.chunks_exact(3).map(Vector3::from_column_slice)
}

fn sum(weights: &[f64; 4], x: &[f64]) -> Vector3<f64> {
    vectors(x).zip(weights).map(|(x, w)| x * *w).sum()
}

fn size(weights: &[f64; 4], x: &[f64]) -> f64 {
    vectors(x).zip(weights).map(|(x, w)| x.norm() * w.abs()).sum()
}

impl Term for MorisonLoad {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let fluid = self.fluid.motion(at.t);
        for station in &self.stations {
            let (flow, coefficients) = (station.flow(at, &fluid), &station.coefficients);
            let force = coefficients.drag(&flow)
                + coefficients.added(&flow, &flow.relative_acceleration)
                + self.fluid.displaced(&fluid, coefficients) * at.load;
            for (row, value) in r.chunks_exact_mut(3).zip(station.values) {
                (0..3).for_each(|k| row[k] -= value * force[k]);
            }
        }
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let fluid = self.fluid.motion(at.t);
        for station in &self.stations {
            let (flow, coefficients) = (station.flow(at, &fluid), &station.coefficients);
            let displaced = (self.fluid.displaced(&fluid, coefficients) * at.load).norm() * f64::EPSILON;
            let bound = coefficients.rounding(&flow, station.sizes(at, &fluid)) + displaced;
            for (row, value) in floor.chunks_exact_mut(3).zip(station.values) {
                row.iter_mut().for_each(|floor| *floor += value.abs() * bound);
            }
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let (fluid, n) = (self.fluid.motion(at.t), self.coordinates.len() / 3);
        let mut blocks = [[Matrix3::zeros(); 4]; 4];
        for station in &self.stations {
            let (values, slopes) = (&station.values, &station.slopes);
            let by = station.coefficients.derivatives(&station.flow(at, &fluid));
            let inertia = by.velocity * w.v + by.acceleration * w.a;
            let stiffness = by.gradient * (-0.5 * w.q);
            for i in 0..n {
                for j in 0..=i {
                    blocks[i][j] += inertia * (values[i] * values[j])
                        + stiffness * (values[i] * slopes[j])
                        + stiffness.transpose() * (slopes[i] * values[j]);
                }
            }
        }
        each_entry(3 * n, |i, j| k.add(i, j, entry(&blocks, i, j)));
    }

    fn skew_stiffness(&self, at: &Local<'_>, visit: &mut dyn FnMut(usize, usize, f64)) {
        let (fluid, mut blocks) = (self.fluid.motion(at.t), [[Matrix3::zeros(); 4]; 4]);
        for station in &self.stations {
            let by = station.coefficients.derivatives(&station.flow(at, &fluid)).gradient;
            for (row, value) in blocks.iter_mut().zip(station.values) {
                row.iter_mut().zip(station.slopes).for_each(|(block, slope)| *block -= by * (value * slope));
            }
        }
        visit_skew(&blocks, self.coordinates.len(), visit);
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let fluid = self.fluid.motion(at.t);
        let of = |station: &MorisonStation| {
            let (flow, v) = (station.flow(at, &fluid), sum(&station.values, at.v));
            let buoyancy = self.fluid.gravity * (-at.load * station.coefficients.displaced());
            Energy {
                kinetic: 0.5 * v.dot(&station.coefficients.added(&flow, &v)),
                potential: -buoyancy.dot(&sum(&station.values, at.q)),
                ..Energy::default()
            }
        };
        let mut energy = Energy::default();
        self.stations.iter().map(of).for_each(|share| energy += share);
        energy
    }

    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        let fluid = self.fluid.motion(at.t);
        let of = |station: &MorisonStation| {
            let (flow, coefficients) = (station.flow(at, &fluid), &station.coefficients);
            let (v, rate) = (sum(&station.values, at.v), sum(&station.slopes, at.v));
            let force = fluid.acceleration * coefficients.displaced()
                + coefficients.added(&flow, &fluid.acceleration);
            force.dot(&v) * at.load + coefficients.rotation_power(&flow, &v, &rate)
        };
        self.stations.iter().map(of).sum()
    }

    fn damping_forces(&self, at: &Local<'_>, r: &mut [f64]) {
        let fluid = self.fluid.motion(at.t);
        for station in &self.stations {
            let drag = station.coefficients.drag(&station.flow(at, &fluid));
            for (row, value) in r.chunks_exact_mut(3).zip(station.values) {
                (0..3).for_each(|k| row[k] -= value * drag[k]);
            }
        }
    }

    fn flow_power(&self, at: &Local<'_>) -> f64 {
        let fluid = self.fluid.motion(at.t);
        let of = |station: &MorisonStation| {
            station.coefficients.drag(&station.flow(at, &fluid)).dot(&fluid.velocity)
        };
        self.stations.iter().map(of).sum()
    }
}
