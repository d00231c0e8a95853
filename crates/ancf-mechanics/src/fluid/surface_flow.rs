use std::sync::Arc;

use ancf_solver::equations::{Energy, Local, LocalMatrix, Term, Weights};
use nalgebra::{Matrix3, SMatrix, Vector3};

use super::blocks::{Blocks, each_entry, entry, visit_skew};
use super::flow_field::{FlowField, FluidMotion, HydroCoefficients, HydroSurface, RelativeFlow};
use crate::bodies::BodyTerms;
use crate::kinematics::Marker;
use crate::shells::VECTORS;

/// Hydrodynamic or aerodynamic load of one element of a shell: drag, lift, added mass and buoyancy.
///
/// Per undeformed area, with the normal n of the surface, the relative velocity of the fluid w = u − ṙ, its normal part w_n = n·w, its
/// part w_t = w − n w_n in the surface, and the thickness h:
///
/// f = ½ρ (C_n |w_n| + C_l |w_t|) w_n n + ½ρ C_t |w_t| w_t + ρh u̇ + ρ a (n·(u̇ − r̈)) n − ρh g.
///
/// A plate at the angle of attack α thus has the normal force ½ρ w² (C_n sin²α + C_l sin α cos α), with C_l = 2π of a thin airfoil in
/// attached flow. C_t is the friction of both faces. The added mass ρ a of a strip of the width b has the mean a = π b/4. Drag, lift,
/// buoyancy and the terms of u̇ are loads, which the load factor multiplies. Energies are those of
/// [`MorisonLoad`](super::MorisonLoad).
///
/// The tangent contains the symmetric parts of the derivatives; the skew parts are stated.
///
/// Source: Morison et al. (1950); Sarpkaya & Isaacson (1981) for plates.
#[derive(Clone, Debug)]
pub struct SurfaceFlowLoad {
    coordinates: Vec<usize>,
    fluid: Arc<FlowField>,
    stations: Vec<SurfaceStation>,
    /// Weights of the vectors of the element in r, r_ξ and r_η, station by station.
    weights: Vec<[f64; 3]>,
}

/// Quadrature point of a surface.
#[derive(Clone, Debug)]
struct SurfaceStation {
    point: Marker,
    tangents: [Marker; 2],
    coefficients: HydroCoefficients,
}

/// State of the surface at a point.
struct StationState {
    tangents: [Vector3<f64>; 2],
    flow: RelativeFlow,
}

impl SurfaceStation {
    fn state(&self, at: &Local<'_>, fluid: &FluidMotion) -> StationState {
        let tangents = self.tangents.each_ref().map(|t| t.reference() + t.sum(at.q));
        let normal = tangents[0].cross(&tangents[1]);
        let stretch = normal.norm();
        let flow = RelativeFlow {
            tangent: normal / stretch,
            stretch,
            relative: fluid.velocity - self.point.sum(at.v),
            relative_acceleration: fluid.acceleration * at.load - self.point.sum(at.a),
            load: at.load,
        };
        StationState { tangents, flow }
    }

    fn markers(&self) -> [&Marker; 3] {
        let [a, b] = &self.tangents;
        [&self.point, a, b]
    }

    /// Returns the derivative of the force by r, r_ξ and r_η along dq = w_q z, dv = w_v z, da = w_a z.
    fn derivative(&self, at: &Local<'_>, fluid: &FluidMotion, w: Weights) -> SMatrix<f64, 9, 9> {
        let StationState { tangents: [a, b], flow } = self.state(at, fluid);
        let by = self.coefficients.derivatives(&flow);
        let mut h = SMatrix::<f64, 9, 9>::zeros();
        // n = m/|m| with m = r_ξ × r_η.
        h.fixed_view_mut::<3, 3>(0, 3).copy_from(&(by.gradient * b.cross_matrix() * -w.q));
        h.fixed_view_mut::<3, 3>(0, 6).copy_from(&(by.gradient * a.cross_matrix() * w.q));
        h.fixed_view_mut::<3, 3>(0, 0).copy_from(&-(by.velocity * w.v + by.acceleration * w.a));
        h
    }
}

impl SurfaceFlowLoad {
    /// Creates the load of an element from its points, tangents and areas.
    fn new(fluid: &Arc<FlowField>, surface: &HydroSurface, points: Vec<([Marker; 3], [f64; 2])>) -> Self {
        let coordinates = Marker::union_coordinates(points.iter().flat_map(|(markers, _)| markers));
        let station = |(markers, [area, scale]): ([Marker; 3], [f64; 2])| {
            let [point, a, b] = markers.map(|marker| marker.within(&coordinates));
            let surface = HydroSurface { thickness: scale * surface.thickness, ..*surface };
            let coefficients = HydroCoefficients::of_surface(fluid, &surface, area);
            SurfaceStation { point, tangents: [a, b], coefficients }
        };
        let stations: Vec<SurfaceStation> = points.into_iter().map(station).collect();
        let weight = |marker: &Marker, vector: usize| {
            marker.parts().iter().find(|(first, _)| *first == 3 * vector).map_or(0.0, |(_, weight)| *weight)
        };
        let of = |station: &SurfaceStation| {
            let markers = station.markers();
            (0..coordinates.len() / 3)
                .map(|vector| markers.map(|marker| weight(marker, vector)))
                .collect::<Vec<_>>()
        };
        let weights = stations.iter().flat_map(of).collect();
        Self { coordinates, fluid: Arc::clone(fluid), stations, weights }
    }

    /// Creates the loads of the given elements of a shell; none for another body.
    pub fn on(
        body: &BodyTerms,
        elements: impl IntoIterator<Item = usize>,
        fluid: &Arc<FlowField>,
        surface: &HydroSurface,
    ) -> Vec<Self> {
        let points = |element: usize| match body {
            BodyTerms::Shell(mesh) => Some(mesh.flow_points(element)),
            BodyTerms::ShearShell(mesh) => Some(mesh.flow_points(element)),
            BodyTerms::Flexible(_) | BodyTerms::Rigid(_) => None,
        };
        elements.into_iter().filter_map(points).map(|points| Self::new(fluid, surface, points)).collect()
    }

    /// Computes the derivative of the residual along dq = w_q z, dv = w_v z, da = w_a z, in blocks of vectors.
    fn blocks(&self, at: &Local<'_>, w: Weights) -> Box<Blocks<VECTORS>> {
        let (fluid, n) = (self.fluid.motion(at.t), self.coordinates.len() / 3);
        let mut blocks = Box::new([[Matrix3::zeros(); VECTORS]; VECTORS]);
        for (station, weights) in self.stations.iter().zip(self.weights.chunks_exact(n)) {
            let h = station.derivative(at, &fluid, w);
            let [direct, of_a, of_b] = [0, 3, 6].map(|j| -h.fixed_view::<3, 3>(0, j));
            for (j, [value, a, b]) in weights.iter().enumerate() {
                let column = direct * *value + of_a * *a + of_b * *b;
                for (i, [value, ..]) in weights.iter().enumerate() {
                    blocks[i][j] += column * *value;
                }
            }
        }
        blocks
    }

    /// Visits the lower entries of the skew part of the derivative.
    fn visit_skew(&self, at: &Local<'_>, w: Weights, visit: &mut dyn FnMut(usize, usize, f64)) {
        visit_skew(&self.blocks(at, w), self.coordinates.len(), visit);
    }

    /// Calls `visit` with each station and its state.
    fn visit(&self, at: &Local<'_>, mut visit: impl FnMut(&SurfaceStation, &RelativeFlow, &FluidMotion)) {
        let fluid = self.fluid.motion(at.t);
        self.stations.iter().for_each(|station| visit(station, &station.state(at, &fluid).flow, &fluid));
    }
}

impl Term for SurfaceFlowLoad {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        self.visit(at, |SurfaceStation { point, coefficients, .. }, flow, fluid| {
            let force = coefficients.drag(flow)
                + coefficients.added(flow, &flow.relative_acceleration)
                + self.fluid.displaced(fluid, coefficients) * at.load;
            point.add(-force, r);
        });
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        self.visit(at, |station, flow, fluid| {
            let SurfaceStation { point, tangents: [a, b], coefficients } = station;
            let sides = [a, b].map(|tangent| tangent.size(at.q));
            let sizes = [
                2.0 * sides[0] * sides[1],
                fluid.velocity.norm() + point.sum_of_sizes(at.v),
                (fluid.acceleration * at.load).norm() + point.sum_of_sizes(at.a),
            ];
            let displaced = (self.fluid.displaced(fluid, coefficients) * at.load).norm() * f64::EPSILON;
            let bound = coefficients.rounding(flow, sizes) + displaced;
            for &(first, weight) in point.parts() {
                floor[first..first + 3].iter_mut().for_each(|floor| *floor += weight.abs() * bound);
            }
        });
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let blocks = self.blocks(at, w);
        each_entry(self.coordinates.len(), |row, column| {
            k.add(row, column, 0.5 * (entry(&blocks, row, column) + entry(&blocks, column, row)));
        });
    }

    fn skew_stiffness(&self, at: &Local<'_>, visit: &mut dyn FnMut(usize, usize, f64)) {
        self.visit_skew(at, Weights::STIFFNESS, visit);
    }

    fn skew_damping(&self, at: &Local<'_>, visit: &mut dyn FnMut(usize, usize, f64)) {
        self.visit_skew(at, Weights::DAMPING, visit);
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let mut energy = Energy::default();
        self.visit(at, |SurfaceStation { point, coefficients, .. }, flow, _| {
            let (v, buoyancy) = (point.sum(at.v), self.fluid.gravity * (-at.load * coefficients.displaced()));
            energy += Energy {
                kinetic: 0.5 * v.dot(&coefficients.added(flow, &v)),
                potential: -buoyancy.dot(&point.sum(at.q)),
                ..Energy::default()
            };
        });
        energy
    }

    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        let mut power = 0.0;
        let fluid = self.fluid.motion(at.t);
        for station in &self.stations {
            let StationState { tangents: [a, b], flow } = station.state(at, &fluid);
            let [rate_a, rate_b] = station.tangents.each_ref().map(|tangent| tangent.sum(at.v));
            let (coefficients, v) = (&station.coefficients, station.point.sum(at.v));
            let force = fluid.acceleration * coefficients.displaced()
                + coefficients.added(&flow, &fluid.acceleration);
            let turning = rate_a.cross(&b) + a.cross(&rate_b);
            power += force.dot(&v) * at.load + coefficients.rotation_power(&flow, &v, &turning);
        }
        power
    }

    fn damping_forces(&self, at: &Local<'_>, r: &mut [f64]) {
        self.visit(at, |SurfaceStation { point, coefficients, .. }, flow, _| {
            point.add(-coefficients.drag(flow), r);
        });
    }

    fn flow_power(&self, at: &Local<'_>) -> f64 {
        let mut power = 0.0;
        self.visit(at, |station, flow, fluid| {
            power += station.coefficients.drag(flow).dot(&fluid.velocity);
        });
        power
    }
}
