//! Shells of both kinds in a fluid.

use std::sync::Arc;

use ancf::mechanics::bodies::BodyTerms;
use ancf::mechanics::fluid::{FlowField, HydroSurface, SurfaceFlowLoad};
use ancf::mechanics::functions::Function;
use ancf::mechanics::shells::{Face, ShearShellMesh, ShellMesh, directors};
use ancf::solver::equations::{Term, Weights};
use nalgebra::{DMatrix, Vector3};

use super::cases::TermCase;
use super::immersed::immersed_terms;
use super::kind::TermKind;
use super::{shear_shells, shells};
use crate::common::random::Random;
use crate::common::sample::{Sample, residual, sizes, tangent};

/// Curved thin shell, and a warped quadrilateral with a triangle.
fn bodies() -> [(&'static str, BodyTerms); 2] {
    let map = |[u, v]: [f64; 2]| {
        [
            Vector3::new(2.0 * u + 0.2 * u * v, 2.3 * v, 0.3 * u * u),
            Vector3::new(2.0 + 0.2 * v, 0.0, 0.6 * u),
            Vector3::new(0.2 * u, 2.3, 0.0),
            Vector3::new(0.2, 0.0, 0.0),
        ]
    };
    let thin = ShellMesh::new(0, [1, 1], Vector3::x(), map, &shells::medium(false, [0.0; 2]));
    let nodes: Vec<Vector3<f64>> =
        [[0.0, 0.0, 0.0], [2.1, 0.1, 0.2], [2.3, 2.4, -0.1], [-0.1, 2.2, 0.1], [4.0, 1.0, 0.3]]
            .map(Vector3::from)
            .to_vec();
    let faces = vec![Face::Quad([0, 1, 2, 3]), Face::Triangle([1, 4, 2])];
    let medium = shear_shells::medium(false, [0.0; 2]);
    let thick = ShearShellMesh::new(0, &nodes, &directors(&nodes, &faces), faces, &medium);
    [("thin shell", BodyTerms::Shell(thin)), ("shell with shear", BodyTerms::ShearShell(thick))]
}

/// The fluid is at rest without drag and lift, or flows fast against all velocities below one, where both are smooth.
fn loads() -> Vec<(String, SurfaceFlowLoad, bool)> {
    let gravity = Vector3::new(0.3, -2.0, 0.7);
    let flows = [(0.0, 1.7, [0.0; 2], 0.0), (9.0, 0.1, [1.3, 0.4], 2.1)];
    let of = |(name, body): (&'static str, BodyTerms)| {
        flows.into_iter().flat_map(move |(speed, density, drag, lift)| {
            let function = Function::Sine { frequency: 0.3, phase: 0.9 };
            let current = Vector3::new(0.8, 0.3, 0.7) * speed;
            let fluid = Arc::new(FlowField { density, gravity, current, function });
            let surface = HydroSurface { thickness: 0.3, drag, lift, added_length: 0.4 };
            let terms =
                SurfaceFlowLoad::on(&body, 0..if name == "thin shell" { 1 } else { 2 }, &fluid, &surface);
            terms
                .into_iter()
                .map(|term| (format!("{name} in a fluid of speed {speed}"), term, speed > 0.0))
                .collect::<Vec<_>>()
        })
    };
    bodies().into_iter().flat_map(of).collect()
}

/// Terms under test.
pub(super) fn surface_flow_terms() -> impl Iterator<Item = TermCase> {
    loads().into_iter().map(|(name, term, flows)| {
        let kind = if flows { TermKind::NonConservative } else { TermKind::Damped };
        TermCase { name, term: Box::new(term), kind }
    })
}

/// Tangent and skew parts together are the derivatives by the coordinates and the velocities.
#[test]
fn skew_parts_complete_the_derivatives() {
    let mut random = Random(5);
    let surfaces = loads().into_iter().map(|(name, term, _)| (name, Box::new(term) as Box<dyn Term>));
    let gravity = Vector3::new(0.3, -0.4, -9.0);
    let lines =
        immersed_terms(gravity).into_iter().map(|(name, term, _)| (name, Box::new(term) as Box<dyn Term>));
    for (name, term) in surfaces.chain(lines) {
        let term = &*term;
        let (n, _) = sizes(term);
        let mut s = Sample::random(term, &mut random);
        s.q *= 0.1;
        let at = s.local();
        for w in [Weights::STIFFNESS, Weights { q: 0.0, v: 1.0, a: 0.0 }] {
            let mut complete = tangent(term, &s, w);
            let mut add = |i: usize, j: usize, value: f64| {
                complete[(i, j)] += value;
                complete[(j, i)] -= value;
            };
            if w.q == 1.0 {
                term.skew_stiffness(&at, &mut add);
            } else {
                term.skew_damping(&at, &mut add);
            }
            let column = |j: usize| {
                let mut z = nalgebra::DVector::zeros(n);
                z[j] = 1.0;
                (residual(term, &s.moved(&z, 1e-5, w)) - residual(term, &s.moved(&z, -1e-5, w))) / 2e-5
            };
            let exact = DMatrix::from_columns(&(0..n).map(column).collect::<Vec<_>>());
            let error = (&complete - &exact).amax() / exact.amax().max(1.0);
            assert!(error < 1e-8, "{name}: {error:e}");
        }
    }
}
