//! Shear-deformable shell elements: a warped, skew quadrilateral and a triangle.

use ancf::mechanics::functions::Function;
use ancf::mechanics::shells::{
    ElementPatch, Face, Laminate, MembraneLaw, Ply, PlyElasticity, ShearMedium, ShearShellMesh, directors,
};
use ancf::solver::equations::{Local, Term};
use nalgebra::{Rotation3, Vector3};

use super::cases::TermCase;
use super::kind::TermKind;
use super::shells::MEMBRANES;
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
pub(super) fn medium(is_laminate: bool, damping: [f64; 2]) -> ShearMedium {
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

/// Homogeneous plate with a law of the membrane.
pub(super) fn with_law(law: MembraneLaw, damping: [f64; 2]) -> ShearMedium {
    let medium = medium(false, damping);
    ShearMedium { section: medium.section.with_law(Some(law)), ..medium }
}

/// Laminate and plates with laws of the membrane, also tension fields.
fn media() -> Vec<ShearMedium> {
    let field = |(_, law, _): (_, MembraneLaw, _)| MembraneLaw { tension_field: Some(0.1), ..law };
    let own = MEMBRANES.into_iter().map(|(_, law, _)| law);
    let laws = own.chain(MEMBRANES.into_iter().map(field));
    [medium(true, [0.0; 2])].into_iter().chain(laws.map(|law| with_law(law, [0.0; 2]))).collect()
}

/// Shapes with the media of [`media`].
fn shapes_and_media() -> impl Iterator<Item = ((usize, &'static str), ShearMedium)> {
    SHAPES.into_iter().flat_map(|shape| media().into_iter().map(move |medium| (shape, medium)))
}

/// Faces of a mesh of one element.
fn face(corners: usize) -> Face {
    Face::new(&(0..corners).collect::<Vec<_>>()).expect("a face")
}

/// Nodal vectors in the reference state. The directors of a triangle are not parallel.
fn reference(corners: usize) -> Vec<Vector3<f64>> {
    let points = &nodes()[..corners];
    let mut normals = directors(points, &[face(corners)]);
    normals[1] = (normals[1] + Vector3::new(0.05, 0.02, 0.0)).normalize();
    points.iter().zip(normals).flat_map(|(point, normal)| [*point, normal]).collect()
}

/// Element with given nodal vectors.
fn element_of(vectors: &[Vector3<f64>], medium: &ShearMedium) -> Box<dyn Term> {
    let part = |kind: usize| vectors.iter().copied().skip(kind).step_by(2).collect::<Vec<_>>();
    let mesh = ShearShellMesh::new(0, &part(0), &part(1), vec![face(vectors.len() / 2)], medium);
    mesh.terms().swap_remove(0)
}

fn element(corners: usize, is_laminate: bool, damping: [f64; 2]) -> Box<dyn Term> {
    element_of(&reference(corners), &medium(is_laminate, damping))
}

/// Mesh of one element.
pub(super) fn mesh_of(corners: usize, is_laminate: bool, damping: [f64; 2]) -> ShearShellMesh {
    mesh_with(corners, &medium(is_laminate, damping))
}

/// Mesh of one element with some corners.
pub(super) fn mesh_with(corners: usize, medium: &ShearMedium) -> ShearShellMesh {
    let (points, faces) = (&nodes()[..corners], vec![face(corners)]);
    let normals = directors(points, &faces);
    ShearShellMesh::new(0, points, &normals, faces, medium)
}

/// Elements without and with coupling and damping, and their pressure.
pub(super) fn shear_shell_terms() -> impl Iterator<Item = TermCase> {
    let cases = [
        ("shear-deformable shell", false, [0.0; 2], TermKind::Polynomial),
        ("shear-deformable shell, laminate", true, [0.0; 2], TermKind::Polynomial),
        ("shear-deformable shell, damped", true, [0.2, 0.7], TermKind::Retarded),
    ];
    SHAPES.into_iter().flat_map(move |(corners, shape)| {
        let elements = cases.into_iter().map(move |(name, is_laminate, damping, kind)| TermCase {
            name: format!("{name}, {shape}"),
            term: element(corners, is_laminate, damping),
            kind,
        });
        // The term is renumbered to its own coordinates by the mesh: positions only.
        let pressure = ElementPatch::face(&mesh_of(corners, false, [0.0; 2]), 0, Vector3::zeros());
        let pressure = pressure.pressure(1.7, &Function::ONE);
        let membranes = MEMBRANES.into_iter().map(move |(name, law, damping)| TermCase {
            name: format!("shear-deformable shell {name}, {shape}"),
            term: element_of(&reference(corners), &with_law(law, damping)),
            kind: if damping[0] == 0.0 { TermKind::Smooth } else { TermKind::Retarded },
        });
        elements.chain(membranes).chain([TermCase {
            name: format!("pressure on a {shape}"),
            term: pressure,
            kind: TermKind::NonConservative,
        }])
    })
}

/// Numbers of nodes and names of the elements.
pub(super) const SHAPES: [(usize, &str); 2] = [(4, "quadrilateral"), (3, "triangle")];

/// Displacements of a rigid motion after a deformation.
fn moved(reference: &[Vector3<f64>], deformed: &[Vector3<f64>], turn: &Rotation3<f64>) -> Vec<f64> {
    let vector = |i: usize| {
        let shift = if i.is_multiple_of(2) { Vector3::new(3.0, 1.0, -2.0) } else { Vector3::zeros() };
        turn * (reference[i] + deformed[i]) + shift - reference[i]
    };
    (0..reference.len()).flat_map(|i| <[f64; 3]>::from(vector(i))).collect()
}

const REST: [f64; 24] = [0.0; 24];

fn local(q: &[f64]) -> Local<'_> {
    Local { q, v: &REST[..q.len()], a: &REST[..q.len()], lambda: &[], t: 0.0, load: 0.0 }
}

/// Strain energy and forces.
fn energy_and_forces(shell: &dyn Term, q: &[f64]) -> (f64, Vec<f64>) {
    let mut r = vec![0.0; q.len()];
    shell.residual(&local(q), &mut r);
    (shell.energy(&local(q)).strain, r)
}

/// A finite rigid motion of the deformed element changes no energy, and rotates its forces.
#[test]
fn shear_shells_are_objective() {
    for ((corners, shape), medium) in shapes_and_media() {
        let (reference, mut random) = (reference(corners), Random(24));
        let shell = element_of(&reference, &medium);
        let axis = nalgebra::Unit::new_normalize(Vector3::new(1.0, -2.0, 0.5));
        let turn = Rotation3::from_axis_angle(&axis, 1.0);
        let at = |q: &[f64]| energy_and_forces(&*shell, q);
        let (rigid, _) = at(&moved(&reference, &[Vector3::zeros(); 8], &turn));
        let deformed: Vec<Vector3<f64>> = reference.iter().map(|_| random.vector3() * 0.1).collect();
        let straight: Vec<f64> = deformed.iter().flat_map(|x| <[f64; 3]>::from(*x)).collect();
        let ((before, forces), (after, turned)) = (at(&straight), at(&moved(&reference, &deformed, &turn)));
        assert!(rigid < 1e-26 * before, "{shape}, rigid motion: {rigid:e} of {before:e}");
        assert_near("energy", after, before, 1e-13);
        for i in 0..reference.len() {
            let [own, other] = [&forces, &turned].map(|r| Vector3::from_column_slice(&r[3 * i..3 * i + 3]));
            assert!((turn * own - other).norm() < 1e-12 * (1.0 + own.norm()), "{shape}, force {i}");
        }
    }
}

/// A cyclic change of the first node changes neither energy nor forces.
#[test]
fn shear_shells_do_not_depend_on_the_first_node() {
    for ((corners, shape), medium) in shapes_and_media() {
        let (reference, mut random) = (reference(corners), Random(5));
        let deformed: Vec<Vector3<f64>> = reference.iter().map(|_| random.vector3() * 0.1).collect();
        let of = |first: usize| {
            let cyclic = |x: &[Vector3<f64>]| -> Vec<Vector3<f64>> {
                (0..x.len()).map(|a| x[(a + 2 * first) % x.len()]).collect()
            };
            let shell = element_of(&cyclic(&reference), &medium);
            let q: Vec<f64> = cyclic(&deformed).iter().flat_map(|x| <[f64; 3]>::from(*x)).collect();
            let (energy, mut r) = energy_and_forces(&*shell, &q);
            r.rotate_right(6 * first);
            (energy, r)
        };
        let (energy, forces) = of(0);
        for first in 1..corners {
            let (other, turned) = of(first);
            assert_near("energy", other, energy, 1e-12);
            for (i, (a, b)) in forces.iter().zip(turned).enumerate() {
                let error = (a - b).abs();
                assert!(error < 1e-12 * energy.max(1.0), "{shape}, row {i} from node {first}: {b} for {a}");
            }
        }
    }
}

/// Kinetic energy of any rigid motion: ½ m v² + ½ ω·J ω of the plate, with the inertia of its thickness, on a rhombus of one
/// quadrilateral or two triangles.
#[test]
fn masses_of_rigid_motions_are_exact() {
    let (a, h, rho) = (2.0, 0.6, 2.0);
    let points = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let nodes: Vec<_> = points.iter().map(|[x, y]| Vector3::new(x + 0.5 * y, *y, 0.0)).collect();
    let mass = rho * h * a * a;
    // Second moments ∫ x x dm of the parallelogram: x = s + t/2, y = t, s, t uniform in (−1, 1), and z in (−h/2, h/2).
    let [xx, xy, yy, zz] = [1.0 / 3.0 + 1.0 / 12.0, 1.0 / 6.0, 1.0 / 3.0, h * h / 12.0];
    for faces in [vec![Face::Quad([0, 1, 2, 3])], vec![Face::Triangle([0, 1, 2]), Face::Triangle([0, 2, 3])]]
    {
        let normals = [Vector3::z(); 4];
        let mesh = ShearShellMesh::new(0, &nodes, &normals, faces, &medium(false, [0.0; 2]));
        for (v, spin) in [
            (Vector3::new(1.0, 2.0, -1.0), Vector3::zeros()),
            (Vector3::zeros(), Vector3::new(0.3, -0.8, 1.1)),
            (Vector3::new(0.2, 0.1, 0.4), Vector3::new(-1.0, 0.5, 0.2)),
        ] {
            let rates: Vec<f64> = (0..4)
                .flat_map(|k| [spin.cross(&nodes[k]) + v, spin.cross(&normals[k])])
                .flat_map(<[f64; 3]>::from)
                .collect();
            let kinetic = |term: &dyn Term| {
                let own: Vec<f64> = term.coordinates().iter().map(|i| rates[*i]).collect();
                term.energy(&Local { v: &own, ..local(&REST[..own.len()]) }).kinetic
            };
            let [x, y, z]: [f64; 3] = spin.into();
            let moment = |a: f64, b: f64, c: f64| a * (yy + zz) + b * (xx + zz) + c * (xx + yy);
            let rotation = moment(x * x, y * y, z * z) - 2.0 * xy * x * y;
            let exact = 0.5 * mass * (v.norm_squared() + rotation);
            assert_near(
                "kinetic energy",
                mesh.terms().iter().map(|term| kinetic(term.as_ref())).sum(),
                exact,
                1e-14,
            );
        }
    }
}
