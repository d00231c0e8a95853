//! Shear-deformable shell elements: a warped, skew quadrilateral.

use ancf::mechanics::functions::Function;
use ancf::mechanics::shells::{
    Laminate, Ply, PlyElasticity, QuadPressure, ShearMedium, ShearShellMesh, Shell24, directors,
};
use ancf::solver::equations::{Local, Term};
use nalgebra::{Rotation3, Vector3};

use super::cases::TermCase;
use super::kind::TermKind;
use crate::common::assertions::assert_near;
use crate::common::random::Random;

/// Nodes of a warped quadrilateral.
fn nodes() -> [Vector3<f64>; 4] {
    [
        Vector3::new(0.0, 0.0, 0.0),
        Vector3::new(1.1, 0.1, 0.2),
        Vector3::new(1.3, 1.4, -0.1),
        Vector3::new(-0.1, 1.2, 0.1),
    ]
}

/// Thick plate of one ply, or of two different ones.
fn medium(is_laminate: bool, damping: [f64; 2]) -> ShearMedium {
    let ply = |young: [f64; 2], angle: f64, density: f64| Ply {
        elasticity: PlyElasticity { young, poisson: 0.25, shear: 0.5, transverse_shear: [0.5, 0.2] },
        density,
        thickness: 0.3,
        angle,
    };
    let plies = match is_laminate {
        false => vec![Ply {
            elasticity: PlyElasticity::isotropic(7.0, 0.3),
            density: 2.0,
            thickness: 0.6,
            angle: 0.0,
        }],
        true => vec![ply([25.0, 1.0], 0.3, 2.0), ply([5.0, 2.0], -0.8, 1.0)],
    };
    let [retardation, mass_damping] = damping;
    ShearMedium {
        section: Laminate::new(plies).thick_section(),
        axis: Vector3::x(),
        retardation,
        mass_damping,
        gravity: Vector3::new(0.3, -2.0, 0.7),
    }
}

fn reference() -> [Vector3<f64>; 8] {
    let normals = directors(&nodes(), &[[0, 1, 2, 3]]);
    std::array::from_fn(|a| if a % 2 == 0 { nodes()[a / 2] } else { normals[a / 2] })
}

fn element(is_laminate: bool, damping: [f64; 2]) -> Shell24 {
    Shell24::all([((0..24).collect(), reference())], &medium(is_laminate, damping)).swap_remove(0)
}

/// Elements without and with coupling and damping, and their pressure.
pub(super) fn shear_shell_terms() -> impl Iterator<Item = TermCase> {
    let cases = [
        ("shear-deformable shell", false, [0.0; 2], TermKind::Polynomial),
        ("shear-deformable shell, laminate", true, [0.0; 2], TermKind::Polynomial),
        ("shear-deformable shell, damped", true, [0.2, 0.7], TermKind::Retarded),
    ];
    let elements = cases.into_iter().map(|(name, is_laminate, damping, kind)| TermCase {
        name: name.into(),
        term: Box::new(element(is_laminate, damping)),
        kind,
    });
    let normals = directors(&nodes(), &[[0, 1, 2, 3]]);
    let mesh = ShearShellMesh::new(0, &nodes(), &normals, vec![[0, 1, 2, 3]], &medium(false, [0.0; 2]));
    // The term is renumbered to its own coordinates by the mesh: positions only.
    let pressure = QuadPressure::on(&mesh, 0, 1.7, &Function::ONE);
    elements.chain([TermCase {
        name: "pressure on a quadrilateral".into(),
        term: Box::new(pressure),
        kind: TermKind::NonConservative,
    }])
}

/// Displacements of a rigid motion after a deformation.
fn moved(deformed: &[Vector3<f64>; 8], turn: &Rotation3<f64>) -> Vec<f64> {
    let reference = reference();
    let vector = |i: usize| {
        let shift = if i.is_multiple_of(2) { Vector3::new(3.0, 1.0, -2.0) } else { Vector3::zeros() };
        turn * (reference[i] + deformed[i]) + shift - reference[i]
    };
    (0..8).flat_map(|i| <[f64; 3]>::from(vector(i))).collect()
}

fn local(q: &[f64]) -> Local<'_> {
    Local { q, v: &[0.0; 24], a: &[0.0; 24], lambda: &[], t: 0.0, load: 0.0 }
}

/// A finite rigid motion of the deformed element changes no energy, and rotates its forces.
#[test]
fn shear_shells_are_objective() {
    let (shell, mut random) = (element(true, [0.0; 2]), Random(24));
    let turn = Rotation3::from_axis_angle(&nalgebra::Unit::new_normalize(Vector3::new(1.0, -2.0, 0.5)), 1.0);
    let at = |q: &[f64]| {
        let mut r = [0.0; 24];
        shell.residual(&local(q), &mut r);
        (shell.energy(&local(q)).strain, r)
    };
    let (rigid, _) = at(&moved(&[Vector3::zeros(); 8], &turn));
    let deformed: [Vector3<f64>; 8] = std::array::from_fn(|_| random.vector3() * 0.1);
    let straight: Vec<f64> = deformed.iter().flat_map(|x| <[f64; 3]>::from(*x)).collect();
    let ((before, forces), (after, turned)) = (at(&straight), at(&moved(&deformed, &turn)));
    assert!(rigid < 1e-26 * before, "rigid motion: {rigid:e} of {before:e}");
    assert_near("energy", after, before, 1e-13);
    for i in 0..8 {
        let [own, other] = [&forces, &turned].map(|r| Vector3::from_column_slice(&r[3 * i..3 * i + 3]));
        assert!((turn * own - other).norm() < 1e-12 * (1.0 + own.norm()), "force {i}");
    }
}

/// A cyclic change of the first node changes neither energy nor forces.
#[test]
fn shear_shells_do_not_depend_on_the_first_node() {
    let (medium, reference, mut random) = (medium(true, [0.0; 2]), reference(), Random(5));
    let deformed: [Vector3<f64>; 8] = std::array::from_fn(|_| random.vector3() * 0.1);
    let of = |first: usize| {
        let cyclic =
            |x: &[Vector3<f64>; 8]| -> [Vector3<f64>; 8] { std::array::from_fn(|a| x[(a + 2 * first) % 8]) };
        let shell = Shell24::all([((0..24).collect(), cyclic(&reference))], &medium).swap_remove(0);
        let q: Vec<f64> = cyclic(&deformed).iter().flat_map(|x| <[f64; 3]>::from(*x)).collect();
        let mut r = [0.0; 24];
        shell.residual(&local(&q), &mut r);
        r.rotate_right(6 * first);
        (shell.energy(&local(&q)).strain, r)
    };
    let (energy, forces) = of(0);
    for first in 1..4 {
        let (other, turned) = of(first);
        assert_near("energy", other, energy, 1e-12);
        for (i, (a, b)) in forces.iter().zip(turned).enumerate() {
            assert!((a - b).abs() < 1e-12 * energy.max(1.0), "row {i} from node {first}: {b} for {a}");
        }
    }
}

/// Kinetic energy of any rigid motion: ½ m v² + ½ ω·J ω of the plate, with the inertia of its thickness, on a rhombus.
#[test]
fn masses_of_rigid_motions_are_exact() {
    let (a, h, rho) = (2.0, 0.6, 2.0);
    let points = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let skew = |[x, y]: [f64; 2]| Vector3::new(x + 0.5 * y, y, 0.0);
    let reference: [Vector3<f64>; 8] =
        std::array::from_fn(|k| if k % 2 == 0 { skew(points[k / 2]) } else { Vector3::z() });
    let shell = Shell24::all([((0..24).collect(), reference)], &medium(false, [0.0; 2])).swap_remove(0);
    let mass = rho * h * a * a;
    // Second moments ∫ x x dm of the parallelogram: x = s + t/2, y = t, s, t uniform in (−1, 1), and z in (−h/2, h/2).
    let [xx, xy, yy, zz] = [1.0 / 3.0 + 1.0 / 12.0, 1.0 / 6.0, 1.0 / 3.0, h * h / 12.0];
    for (v, spin) in [
        (Vector3::new(1.0, 2.0, -1.0), Vector3::zeros()),
        (Vector3::zeros(), Vector3::new(0.3, -0.8, 1.1)),
        (Vector3::new(0.2, 0.1, 0.4), Vector3::new(-1.0, 0.5, 0.2)),
    ] {
        let rate =
            |k: usize| spin.cross(&reference[k]) + if k.is_multiple_of(2) { v } else { Vector3::zeros() };
        let rates: Vec<f64> = (0..8).flat_map(|k| <[f64; 3]>::from(rate(k))).collect();
        let state = Local { v: &rates, ..local(&[0.0; 24]) };
        let [x, y, z]: [f64; 3] = spin.into();
        let moment = |a: f64, b: f64, c: f64| a * (yy + zz) + b * (xx + zz) + c * (xx + yy);
        let rotation = moment(x * x, y * y, z * z) - 2.0 * xy * x * y;
        let exact = 0.5 * mass * (v.norm_squared() + rotation);
        assert_near("kinetic energy", shell.energy(&state).kinetic, exact, 1e-14);
    }
}
