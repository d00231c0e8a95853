//! Resultants and stresses of shells against closed forms.

use std::f64::consts::{PI, TAU};

use ancf::mechanics::shells::{ShellMedium, ShellMesh, ShellSection, SurfaceStress};
use ancf::record::Series;
use ancf::solver::equations::State;
use ancf::{Model, simulate};
use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::common::assertions::{assert_near, assert_relative};

const YOUNG: f64 = 2e5;
const POISSON: f64 = 0.3;
const THICKNESS: f64 = 0.05;

fn medium() -> ShellMedium {
    let section = ShellSection::isotropic(YOUNG, POISSON, 1.0, THICKNESS);
    ShellMedium { section, axis: None, retardation: 0.0, mass_damping: 0.0, gravity: Vector3::zeros() }
}

/// Map of a surface: r, ∂r/∂u, ∂r/∂v, ∂²r/∂u∂v.
type Map = fn([f64; 2]) -> [Vector3<f64>; 4];

/// Parallelogram whose sides are neither orthogonal nor along the global axes.
fn skew([u, v]: [f64; 2]) -> [Vector3<f64>; 4] {
    let [a, b] = [Vector3::new(2.0, 0.7, 0.0), Vector3::new(0.4, 1.0, 0.0)];
    [a * u + b * v, a, b, Vector3::zeros()]
}

/// Quarter of a cylinder of radius 3 about the z-axis.
fn cylinder([u, v]: [f64; 2]) -> [Vector3<f64>; 4] {
    let (angle, radius) = (0.5 * PI * u, 3.0);
    let out = Vector3::new(angle.cos(), angle.sin(), 0.0) * radius;
    [
        out + Vector3::z() * (2.0 * v),
        Vector3::z().cross(&out) * (0.5 * PI),
        Vector3::z() * 2.0,
        Vector3::zeros(),
    ]
}

fn mesh(divisions: [usize; 2], map: Map) -> ShellMesh {
    ShellMesh::new(0, divisions, Vector3::zeros(), map, &medium())
}

/// State whose nodal vectors are those of the map after a deformation with a constant gradient.
fn deformed(mesh: &ShellMesh, gradient: &Matrix3<f64>) -> State {
    let mut s = State::rest(mesh.coordinates(), 0);
    for node in 0..mesh.coordinates() / 12 {
        for kind in 0..4 {
            let (first, reference) = mesh.nodal(node, kind);
            let moved = gradient * reference - reference;
            s.q[first..first + 3].copy_from_slice(moved.as_slice());
        }
    }
    s
}

/// Rotated state: r → R r.
fn rotated(mesh: &ShellMesh, s: &State, turn: &Rotation3<f64>) -> State {
    let mut turned = s.clone();
    for node in 0..mesh.coordinates() / 12 {
        for kind in 0..4 {
            let (first, reference) = mesh.nodal(node, kind);
            let now = turn * (reference + Vector3::from_column_slice(&s.q[first..first + 3])) - reference;
            turned.q[first..first + 3].copy_from_slice(now.as_slice());
        }
    }
    turned
}

/// Any deformation of bending, shear and stretch.
fn bent(mesh: &ShellMesh) -> State {
    let mut s = State::rest(mesh.coordinates(), 0);
    for (k, q) in s.q.iter_mut().enumerate() {
        *q = 0.01 * (1.7 * k as f64 + 0.3).sin();
    }
    s
}

fn assert_same(found: &SurfaceStress, expected: &SurfaceStress, tolerance: f64) {
    for (layer, expected) in found.layers.iter().zip(&expected.layers) {
        assert!((layer - expected).norm() < tolerance * expected.norm(), "{layer} {expected}");
    }
}

/// Components along e₁ = r_,u and e₂ of a uniaxial stress S in the direction x of a skew parallelogram: S cos², S sin², −S sin cos.
#[test]
fn uniform_stress_has_the_components_of_the_orthonormal_frame() {
    let mesh = mesh([2, 3], skew);
    // Stretch along x with free contraction: E_xx = ½ (λ² − 1), S = E E_xx.
    let (stress, across) = (YOUNG * 1e-3, -POISSON * 1e-3);
    let stretch = |green: f64| (1.0 + 2.0 * green).sqrt();
    let s = deformed(&mesh, &Matrix3::from_diagonal(&Vector3::new(stretch(1e-3), stretch(across), 1.0)));
    let (sin, cos) = 0.7_f64.atan2(2.0).sin_cos();
    for at in [[0.0, 0.0], [0.5, 0.3], [0.27, 1.0], [1.0, 2.0 / 3.0]] {
        let found = mesh.stress(&s, at);
        let expected = Vector3::new(cos * cos, sin * sin, -sin * cos) * stress;
        for layer in found.layers {
            assert!((layer - expected).norm() < 1e-9 * stress, "{layer} {expected}");
        }
        assert!((found.force - expected * THICKNESS).norm() < 1e-9 * stress * THICKNESS);
        for [first, second, angle] in found.principal() {
            assert_relative("first principal stress", first, stress, 1e-9);
            assert_near("second principal stress", second, 0.0, 1e-9 * stress);
            // The x-axis is at −atan(0.35) from r_,u.
            assert_near("direction", angle, -0.7_f64.atan2(2.0), 1e-8);
        }
        found.von_mises().iter().for_each(|value| assert_relative("von Mises", *value, stress, 1e-9));
        assert_relative("energy", found.energy(), 0.5 * stress * 1e-3 * THICKNESS, 1e-9);
    }
}

/// Stresses at the faces are n/h ± 6 m/h², and resultants are those of the stresses over the thickness.
#[test]
fn stresses_at_the_faces_follow_from_the_resultants() {
    let mesh = mesh([3, 2], cylinder);
    let found = mesh.stress(&bent(&mesh), [0.4, 0.7]);
    for (layer, sign) in found.layers.iter().zip([1.0, 0.0, -1.0]) {
        let expected = found.force / THICKNESS + found.moment * (sign * 6.0 / THICKNESS.powi(2));
        assert!((layer - expected).norm() < 1e-12 * expected.norm());
    }
}

/// Large rotations do not change the stresses. A rotation alone gives none.
#[test]
fn rotations_do_not_change_stresses() {
    let turn = Rotation3::from_euler_angles(1.1, -0.8, 2.4);
    for map in [skew as Map, cylinder] {
        let mesh = mesh([3, 2], map);
        let s = bent(&mesh);
        let turned = rotated(&mesh, &s, &turn);
        let rigid = rotated(&mesh, &State::rest(mesh.coordinates(), 0), &turn);
        for at in [[0.0, 0.0], [1.0 / 3.0, 0.5], [0.61, 0.13]] {
            let found = mesh.stress(&s, at);
            assert_same(&mesh.stress(&turned, at), &found, 1e-10);
            assert!(mesh.stress(&rigid, at).layers[0].norm() < 1e-11 * found.layers[0].norm());
        }
    }
}

/// The integral of the energy density over Gauss points is the strain energy of the elements, with the assumed membrane strains.
#[test]
fn energy_density_integrates_to_the_strain_energy() {
    let rule = [
        (0.5 - 0.4305681557970263, 0.17392742256872692),
        (0.5 - 0.16999052179242816, 0.32607257743127305),
        (0.5 + 0.16999052179242816, 0.32607257743127305),
        (0.5 + 0.4305681557970263, 0.17392742256872692),
    ];
    for map in [skew as Map, cylinder] {
        let (n, m) = (3, 2);
        let mesh = mesh([n, m], map);
        let s = bent(&mesh);
        let mut sum = 0.0;
        for (i, j) in (0..n).flat_map(|i| (0..m).map(move |j| (i, j))) {
            for ((x, w), (y, z)) in rule.iter().flat_map(|a| rule.iter().map(move |b| (*a, *b))) {
                let at = [(i as f64 + x) / n as f64, (j as f64 + y) / m as f64];
                let tangent = |order| mesh.derivative(at, order).reference();
                let area = tangent([1, 0]).cross(&tangent([0, 1])).norm();
                sum += w * z * area * mesh.stress(&s, at).energy();
            }
        }
        assert_relative("energy", sum, mesh.strain_energy(&s), 1e-12);
    }
}

fn solve(text: &str) -> Series {
    let mut series = Series::new();
    let summary = simulate(&Model::parse(text).unwrap(), &mut series).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    series
}

fn last(series: &Series, name: &str) -> f64 {
    *series.column(name).unwrap().last().unwrap()
}

fn probe(name: &str, [u, v]: [f64; 2]) -> String {
    format!(
        "[[probes]]\nname = \"{name}\"\non = {{ body = \"s\", at = [{u:?}, {v:?}] }}\n\
         record = [\"resultants\", \"surface_stress\"]\n"
    )
}

/// Strip that a moment per length m rolls up to a circle: σ = ∓6 m/h², in any units. At the points ½ − 1/√12 of the elements the
/// curvature is accurate, elsewhere its error is about a twelfth of the square of the angle of an element.
#[test]
fn strip_under_an_end_moment_has_the_stress_six_m_by_h_squared() {
    let strip = |unit: f64, part: f64| {
        let (length, young, moment) = (12.0 * unit, 1.2e6 / unit.powi(2), part * 50.0 * PI / 3.0);
        format!(
            "materials.m = {{ young = {young:e}, poisson = 0, density = 1 }}\n\
             [[bodies]]\nkind = \"shell\"\nname = \"s\"\n\
             surface = {{ kind = \"flat\", corner = [0, 0, 0], side_u = [{length}, 0, 0], side_v = [0, {unit}, 0] }}\n\
             elements = [16, 1]\nthickness = {}\nmaterial = \"m\"\n\
             [[joints]]\nkind = \"support\"\nname = \"root\"\na = {{ body = \"s\", at = {{ edge = \"u_start\" }} }}\ncondition = \"clamped\"\n\
             [[loads]]\nkind = \"edge_moment\"\nbody = \"s\"\nedge = \"u_end\"\nmoment = [0, {:e}, 0]\nfollower = true\n\
             [analysis]\nkind = \"statics\"\n{}{}",
            0.1 * unit,
            -moment,
            probe("inside", [(5.5 - 1.0 / 12.0_f64.sqrt()) / 16.0, 0.5]),
            probe("node", [0.5, 1.0])
        )
    };
    for (unit, part) in [(1.0, 0.25), (1.0, 1.0), (1000.0, 1.0)] {
        let series = solve(&strip(unit, part));
        // The moment per length does not depend on the unit of length.
        let moment = part * 50.0 * PI / 3.0;
        let stress = 6.0 * moment / (0.1 * unit).powi(2);
        let square = 1.05 * (part * TAU / 16.0).powi(2) / 12.0;
        for (name, tolerance) in [("inside", 2e-3), ("node", square.max(2e-3))] {
            // Membrane stresses add an error of the same order.
            let of_stress = tolerance + square.max(1e-3);
            let value = |suffix: &str| last(&series, &format!("{name}.{suffix}"));
            // Rolling up compresses the top.
            assert_relative("muu", value("muu"), -moment, tolerance);
            assert_relative("top", value("suu_top"), -stress, of_stress);
            assert_relative("bottom", value("suu_bottom"), stress, of_stress);
            assert_near("middle", value("suu_middle"), 0.0, of_stress * stress);
            assert_relative("von Mises", value("von_mises"), stress, of_stress);
            for small in ["svv_top", "suv_top", "svv_bottom"] {
                assert_near(small, value(small), 0.0, 2e-3 * stress);
            }
        }
    }
}

/// Square plate of side 1 under the pressure 1 with D = 1.
fn plate(elements: u32, condition: &str, probes: &str) -> Series {
    let edges = ["u_start", "u_end", "v_start", "v_end"].map(|edge| {
        format!(
            "[[joints]]\nkind = \"support\"\nname = \"{edge}\"\na = {{ body = \"s\", at = {{ edge = \"{edge}\" }} }}\n\
             condition = \"{condition}\"\n"
        )
    });
    solve(&format!(
        "materials.m = {{ young = 12e6, poisson = 0.3, density = 1 }}\n\
         [[bodies]]\nkind = \"shell\"\nname = \"s\"\n\
         surface = {{ kind = \"flat\", corner = [0, 0, 0], side_u = [1, 0, 0], side_v = [0, 1, 0] }}\n\
         elements = [{elements}, {elements}]\nthickness = 0.01\nmaterial = \"m\"\n{}\
         [[loads]]\nkind = \"surface_pressure\"\nbody = \"s\"\npressure = 1e-3\n\
         [analysis]\nkind = \"statics\"\n{probes}",
        edges.concat()
    ))
}

/// Moments of a clamped plate: 0.0229051 q a² in the centre, −0.051334 q a² in the middle of an edge. Their error falls with h².
#[test]
fn clamped_plates_have_the_moments_of_the_series() {
    let probes = probe("centre", [0.5, 0.5]) + &probe("edge", [1.0, 0.5]);
    let errors = [4, 8, 16].map(|elements| {
        let series = plate(elements, "clamped", &probes);
        let centre = last(&series, "centre.muu") / 1e-3;
        assert_relative("symmetry", last(&series, "centre.mvv") / 1e-3, centre, 1e-6);
        [centre - 0.0229051, last(&series, "edge.muu") / 1e-3 + 0.051334]
    });
    for (k, exact) in [0.0229051, 0.051334].into_iter().enumerate() {
        let of = |mesh: usize| errors[mesh][k].abs();
        assert!(of(2) < 0.014 * exact, "{errors:?}");
        assert!(of(0) / of(1) > 3.0 && of(1) / of(2) > 3.3, "order 2: {errors:?}");
    }
}

/// Moments of a hinged plate by Navier's series: at (½ ± 1/√12) of the elements, their error falls faster than in other points.
#[test]
fn hinged_plates_have_the_moments_of_navier() {
    let moments = |x: f64, y: f64| {
        let mut sum = 0.0;
        for (m, n) in
            (0..200).flat_map(|i| (0..200).map(move |j| (2.0 * f64::from(i) + 1.0, 2.0 * f64::from(j) + 1.0)))
        {
            let size = 16.0 / (PI.powi(4) * m * n * (m * m + n * n).powi(2));
            sum += size * (m * m + 0.3 * n * n) * (m * PI * x).sin() * (n * PI * y).sin();
        }
        sum
    };
    assert_near("series", moments(0.5, 0.5), 0.0478864, 2e-6);
    let point = 0.5 - 1.0 / 12.0_f64.sqrt();
    let errors = [4_u32, 8].map(|elements| {
        let half = f64::from(elements / 2 - 1);
        let at = (half + point) / f64::from(elements);
        let series = plate(elements, "hinged", &(probe("centre", [0.5, 0.5]) + &probe("point", [at, at])));
        let centre = last(&series, "centre.muu") / 1e-3 - 0.0478864;
        [centre.abs(), (last(&series, "point.muu") / 1e-3 - moments(at, at)).abs()]
    });
    assert!(errors[0][0] / errors[1][0] > 3.3, "order 2: {errors:?}");
    assert!(errors[1][0] < 0.03 * 0.0478864, "{errors:?}");
    assert!(errors[1][1] < 0.1 * errors[1][0] && errors[0][1] / errors[1][1] > 6.0, "order 3: {errors:?}");
}

/// Cylinder under internal pressure: hoop force p R, no axial force and no moments. Errors fall with h².
#[test]
fn pressurised_cylinders_have_the_hoop_force() {
    let guided = |edge: &str, condition: &str| {
        format!(
            "[[joints]]\nkind = \"support\"\nname = \"{edge}\"\na = {{ body = \"s\", at = {{ edge = \"{edge}\" }} }}\n\
             condition = {condition}\n"
        )
    };
    let errors = [3_u32, 6, 12].map(|elements| {
        let series = solve(&format!(
            "materials.m = {{ young = 2e5, poisson = 0.3, density = 1 }}\n\
             [[bodies]]\nkind = \"shell\"\nname = \"s\"\n\
             surface = {{ kind = \"revolved\", from = [3, 0, 0], to = [3, 0, 2], center = [0, 0, 0], axis = [0, 0, 1], angle = {} }}\n\
             elements = [{elements}, 2]\nthickness = 0.05\nmaterial = \"m\"\n{}{}{}\
             [[loads]]\nkind = \"surface_pressure\"\nbody = \"s\"\npressure = 1e-3\n[analysis]\nkind = \"statics\"\n{}",
            0.25 * TAU,
            guided("u_start", "\"symmetry\""),
            guided("u_end", "\"symmetry\""),
            guided("v_start", "\"guided\"\naxes = [\"z\"]"),
            probe("p", [1.46 / f64::from(elements), 0.37])
        ));
        let value = |suffix: &str| last(&series, &format!("p.{suffix}"));
        let names = ["nuu", "nvv", "nuv", "muu", "mvv"];
        let sizes = [3e-3, 3e-3, 3e-3, 3e-3 * 0.05, 3e-3 * 0.05];
        let exact = [1.0, 0.0, 0.0, 0.0, 0.0];
        let errors: Vec<f64> = (0..5).map(|k| (value(names[k]) / sizes[k] - exact[k]).abs()).collect();
        assert_relative("stress", value("suu_middle"), value("nuu") / 0.05, 1e-9);
        errors
    });
    assert!(errors[2].iter().all(|error| *error < 2e-3), "{errors:?}");
    assert!(errors[0][0] / errors[1][0] > 3.0 && errors[1][0] / errors[2][0] > 3.0, "{errors:?}");
}
