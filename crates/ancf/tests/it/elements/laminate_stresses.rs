//! Stresses of laminated shells: those of the plies, against the classical theory of laminates.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use ancf::mechanics::shells::{Laminate, Ply, PlyElasticity, ShellMedium, ShellMesh, SurfaceStress};
use ancf::solver::equations::State;
use nalgebra::{Rotation3, Unit, Vector3};

use super::laminates::{deformed, laminate, last, strip};
use crate::common::assertions::{assert_near, assert_relative};

const THICKNESSES: [f64; 3] = [0.01, 0.025, 0.015];

/// Laminate without symmetry: plies of different materials, thicknesses and angles.
fn unlike(angles: [f64; 3]) -> Laminate {
    let carbon =
        PlyElasticity { young: [25.0, 1.0], poisson: 0.25, shear: 0.5, transverse_shear: [0.5, 0.2] };
    let glass = PlyElasticity { young: [5.0, 2.0], poisson: 0.3, shear: 0.8, transverse_shear: [0.8; 2] };
    let of = |(k, elasticity): (usize, PlyElasticity)| Ply {
        elasticity,
        density: 1.0,
        thickness: THICKNESSES[k],
        angle: angles[k],
    };
    Laminate::new([carbon, glass, carbon].into_iter().enumerate().map(of).collect())
}

/// Skew patch with a bend; `turned` is the same surface with u along −v and v along u.
fn mesh(laminate: &Laminate, axis: Option<Vector3<f64>>, turned: bool) -> ShellMesh {
    let (a, b, c) = (Vector3::new(2.0, 0.7, 0.1), Vector3::new(0.4, 1.0, 0.0), Vector3::new(0.0, 0.0, 0.3));
    let map = move |[u, v]: [f64; 2]| [a * u + b * v + c * (u * v), a + c * v, b + c * u, c];
    let other = move |[u, v]: [f64; 2]| {
        let [r, s, t, mixed] = map([v, 1.0 - u]);
        [r, -t, s, -mixed]
    };
    let medium = ShellMedium {
        section: laminate.section(),
        axis,
        retardation: 0.0,
        mass_damping: 0.0,
        gravity: Vector3::zeros(),
    };
    let divisions = [2, 2];
    if turned {
        ShellMesh::new(0, divisions, Vector3::zeros(), other, &medium)
    } else {
        ShellMesh::new(0, divisions, Vector3::zeros(), map, &medium)
    }
}

/// Displacements w(x, y, z) of the nodal vectors, which the elements represent: quadratic in the coordinates.
fn bent(mesh: &ShellMesh) -> State {
    let mut s = State::rest(mesh.coordinates(), 0);
    for (k, q) in s.q.iter_mut().enumerate() {
        *q = 0.01 * (1.7 * k as f64 + 0.3).sin();
    }
    s
}

/// Stresses of the plies at two Gauss points each are exact for forces and moments: they are linear in each ply.
fn integrated(laminate: &Laminate, thicknesses: &[f64], found: &SurfaceStress) -> [Vector3<f64>; 2] {
    let [mut force, mut moment] = [Vector3::zeros(); 2];
    let mut low = -0.5 * thicknesses.iter().sum::<f64>();
    for thickness in thicknesses {
        for part in [0.5 - 1.0 / 12.0_f64.sqrt(), 0.5 + 1.0 / 12.0_f64.sqrt()] {
            let z = low + part * thickness;
            let stress = laminate.stress(z, &found.strain, &found.curvature) * (0.5 * thickness);
            force += stress;
            moment += stress * z;
        }
        low += thickness;
    }
    [force, moment]
}

#[test]
fn stresses_of_plies_integrate_to_the_resultants_of_the_mesh() {
    let unlike = unlike([0.2, 1.1, -0.6]);
    let angled = laminate(&[FRAC_PI_4, -FRAC_PI_4]);
    for (laminate, thicknesses) in [(&unlike, &THICKNESSES[..]), (&angled, &[0.5, 0.5])] {
        let mesh = mesh(laminate, None, false);
        for at in [[0.5, 0.5], [0.2, 0.9]] {
            let found = mesh.stress(&bent(&mesh), at);
            let [force, moment] = integrated(laminate, thicknesses, &found);
            assert!((force - found.force).norm() < 1e-13 * force.norm(), "{force} {}", found.force);
            assert!((moment - found.moment).norm() < 1e-13 * moment.norm(), "{moment} {}", found.moment);
            let h: f64 = thicknesses.iter().sum();
            for (layer, part) in found.layers.iter().zip([0.5, 0.0, -0.5]) {
                let ply = laminate.stress(part * h, &found.strain, &found.curvature);
                assert!((layer - ply).norm() < 1e-13 * ply.norm(), "{part}: {layer} {ply}");
            }
        }
    }
}

/// The outer faces have the stiffness of the outer plies. A boundary in the middle has the mean of both plies.
#[test]
fn faces_have_the_stresses_of_their_plies() {
    let cross = laminate(&[0.0, FRAC_PI_2]);
    let (strain, curvature) = (Vector3::new(0.3, -0.2, 0.1), Vector3::new(-0.4, 0.7, 0.2));
    // Q of a ply: E_L/(1 − ν²/25), E_T/(1 − ν²/25), ν E_T/(1 − ν²/25), G.
    let part = 1.0 / (1.0 - 0.0625 / 25.0);
    let (along, across, coupling, shear) = (25.0 * part, part, 0.25 * part, 0.5);
    let top = strain + curvature * 0.5;
    let upper = cross.stress(0.5, &strain, &curvature);
    let expected =
        Vector3::new(across * top.x + coupling * top.y, coupling * top.x + along * top.y, shear * top.z);
    assert!((upper - expected).norm() < 1e-14 * expected.norm(), "{upper}");
    let bottom = strain - curvature * 0.5;
    let lower = cross.stress(-0.5, &strain, &curvature);
    let expected = Vector3::new(
        along * bottom.x + coupling * bottom.y,
        coupling * bottom.x + across * bottom.y,
        shear * bottom.z,
    );
    assert!((lower - expected).norm() < 1e-14 * expected.norm(), "{lower}");
    let middle = cross.stress(0.0, &strain, &curvature);
    let mean = 0.5 * (along + across);
    let expected = Vector3::new(
        mean * strain.x + coupling * strain.y,
        coupling * strain.x + mean * strain.y,
        shear * strain.z,
    );
    assert!((middle - expected).norm() < 1e-14 * expected.norm(), "{middle}");
}

/// Components refer to the direction of u also with an axis of the fibres: the axis shifts their angles only.
#[test]
fn components_do_not_depend_on_the_axis_of_the_fibres() {
    let at = [0.4, 0.7];
    let angles = [0.2, 1.1, -0.6];
    let plain = mesh(&unlike(angles), None, false);
    let [t, s] = [[1, 0], [0, 1]].map(|order| plain.derivative(at, order).reference());
    let normal = Unit::new_normalize(t.cross(&s));
    // The surface is not plane: the axis has the angle 0.4 at this point only.
    let axis = Rotation3::from_axis_angle(&normal, 0.4) * t.normalize() + normal.into_inner() * 0.8;
    let shifted = mesh(&unlike(angles.map(|angle| angle - 0.4)), Some(axis), false);
    let state = bent(&plain);
    let [found, expected] = [&shifted, &plain].map(|mesh| mesh.stress(&state, at));
    assert!((found.force - expected.force).norm() < 1e-12 * expected.force.norm(), "{found:?} {expected:?}");
    assert!(
        (found.moment - expected.moment).norm() < 1e-12 * expected.moment.norm(),
        "{found:?} {expected:?}"
    );
    for (found, expected) in found.layers.iter().zip(&expected.layers) {
        assert!((found - expected).norm() < 1e-12 * expected.norm(), "{found} {expected}");
    }
    assert_relative("energy", found.energy(), expected.energy(), 1e-12);
}

/// A patch with the direction of u along −v has the same stresses in its own components, and the same energy.
#[test]
fn stresses_do_not_depend_on_the_directions_of_the_patch() {
    let axis = Some(Vector3::new(0.3, 1.0, 0.2));
    let laminate = unlike([0.2, 1.1, -0.6]);
    let [plain, turned] = [false, true].map(|turned| mesh(&laminate, axis, turned));
    let state = bent(&plain);
    let mut other = State::rest(turned.coordinates(), 0);
    for node in 0..9 {
        // Nodal vectors (r, r_ξ, r_η, r_ξη) of u = 1 − v', v = u' are (r, −r_η', r_ξ', −r_ξη').
        let [u, v] = turned.node_place(node);
        let from = plain.node_at([v, 1.0 - u]);
        for (kind, (source, sign)) in [(0, 1.0), (2, -1.0), (1, 1.0), (3, -1.0)].into_iter().enumerate() {
            let (place, (first, _)) = (turned.nodal(node, kind).0, plain.nodal(from, source));
            for i in 0..3 {
                other.q[place + i] = sign * state.q[first + i];
            }
        }
    }
    assert_relative("energy", turned.strain_energy(&other), plain.strain_energy(&state), 1e-12);
    for at in [[0.3, 0.8], [0.5, 0.25]] {
        let (found, expected) = (turned.stress(&other, [1.0 - at[1], at[0]]), plain.stress(&state, at));
        assert_relative("energy density", found.energy(), expected.energy(), 1e-12);
        for k in 0..3 {
            assert_relative("von Mises", found.von_mises()[k], expected.von_mises()[k], 1e-12);
            for i in 0..2 {
                let size = expected.principal()[k][0].abs();
                assert_near("principal", found.principal()[k][i], expected.principal()[k][i], 1e-12 * size);
            }
        }
    }
}

/// A strip under tension has the stresses of the plies by the classical theory, with the resultants N and zero.
#[test]
fn strips_under_tension_have_the_stresses_of_the_theory() {
    let thickness = 0.1;
    for (keys, turned, angles) in [
        ("layers = [{}, { angle = 1.5707963267948966 }]", false, [0.0, FRAC_PI_2]),
        ("fibre_axis = [1, 0, 0]\nlayers = [{ angle = 0.5 }, { angle = -0.8 }]", false, [0.5, -0.8]),
        // The strip is along y: fibres at the angle from x are at this angle minus a right angle from the strip.
        (
            "fibre_axis = [1, 0, 0]\nlayers = [{ angle = 0.5 }, { angle = -0.8 }]",
            true,
            [0.5 - FRAC_PI_2, -0.8 - FRAC_PI_2],
        ),
    ] {
        let probe = "[[probes]]\nname = \"P\"\non = { body = \"s\", at = [0.8125, 0.25] }\n\
                     record = [\"resultants\", \"surface_stress\"]\n[analysis]";
        let text = strip(keys, turned).replace("[analysis]", probe);
        let names = ["suu", "svv", "suv"];
        let columns: Vec<String> = ["P.nuu", "P.nvv", "P.muu", "P.muv"]
            .map(String::from)
            .into_iter()
            .chain(
                ["top", "middle", "bottom"].iter().flat_map(|at| names.map(|name| format!("P.{name}_{at}"))),
            )
            .collect();
        let columns: Vec<&str> = columns.iter().map(String::as_str).collect();
        let found = last(&text, &columns);
        assert_relative("N", found[0], 1e-7, 2e-2);
        // Strains for the unit thickness: ε = N/h ε₁, κ = N/h² κ₁.
        let laminate = laminate(&angles);
        let unit = deformed(&laminate.section(), [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]) * (1e-7 / thickness);
        let (strain, curvature) =
            (Vector3::new(unit[0], unit[1], unit[2]), Vector3::new(unit[3], unit[4], unit[5]));
        let size = 1e-7 / thickness;
        for (k, part) in [0.5, 0.0, -0.5].into_iter().enumerate() {
            let exact = laminate.stress(part, &strain, &curvature);
            for i in 0..3 {
                assert_near(
                    &format!("{keys} {k} {i}: {found:?}"),
                    found[4 + 3 * k + i],
                    exact[i],
                    2e-2 * size,
                );
            }
        }
    }
}
