//! Sums of the contacts of a point with all elements of a shear-deformable shell: one smooth potential at any kinks.

use ancf::mechanics::contact::{ContactGeometry, ContactLaw, ContactPoint, FaceContact};
use ancf::mechanics::kinematics::Marker;
use ancf::mechanics::shells::{Face, Laminate, Ply, PlyElasticity, ShearMedium, ShearShellMesh};
use ancf::solver::equations::{Local, Term};
use nalgebra::Vector3;

use crate::common::random::Random;

const RADIUS: f64 = 0.3;
const LAW: ContactLaw =
    ContactLaw { stiffness: 10.0, transition: 0.01, damping: 0.0, friction: 0.0, slip_speed: 1.0 };

/// Mesh of 3 × 3 cells with heights of its nodes, of quadrilaterals or triangles.
fn mesh(heights: impl FnMut() -> f64, is_split: bool) -> ContactGeometry {
    let mut heights = heights;
    let nodes: Vec<_> =
        (0..16).map(|k| Vector3::new(f64::from(k % 4), f64::from(k / 4), heights())).collect();
    let split = |k: usize| match is_split {
        false => vec![Face::Quad([k, k + 1, k + 5, k + 4])],
        true => vec![Face::Triangle([k, k + 1, k + 5]), Face::Triangle([k, k + 5, k + 4])],
    };
    let faces = (0..9).flat_map(|k| split(k / 3 * 4 + k % 3)).collect();
    let ply =
        Ply { elasticity: PlyElasticity::isotropic(7.0, 0.3), density: 2.0, thickness: 0.1, angle: 0.0 };
    let medium = ShearMedium {
        section: Laminate::new(vec![ply]).thick_section(),
        axis: Vector3::x(),
        retardation: 0.0,
        mass_damping: 0.0,
        gravity: Vector3::zeros(),
    };
    ContactGeometry::shear_shell(&ShearShellMesh::new(3, &nodes, &[Vector3::z(); 16], faces, &medium), 0.1, 5)
}

/// Contacts of a movable point, whose displacement is the first three coordinates, with all elements.
fn contacts(shell: &ContactGeometry, law: ContactLaw) -> Vec<FaceContact> {
    let point = ContactPoint::new(Marker::new([(0, 1.0)], Vector3::zeros()), 1.0);
    (0..).map_while(|k| FaceContact::new(std::slice::from_ref(&point), (shell, k), RADIUS, law)).collect()
}

/// Sum of a quantity over the contacts, with the point at a place and given velocities of all coordinates.
fn sum(
    contacts: &[FaceContact],
    point: &Vector3<f64>,
    v: &[f64],
    of: impl Fn(&dyn Term, &Local<'_>) -> f64,
) -> f64 {
    let of = |term: &FaceContact| {
        let q: Vec<f64> = term.coordinates().iter().map(|&c| if c < 3 { point[c] } else { 0.0 }).collect();
        let v: Vec<f64> = term.coordinates().iter().map(|&c| v.get(c).copied().unwrap_or(0.0)).collect();
        let zeros = vec![0.0; q.len()];
        of(term, &Local { q: &q, v: &v, a: &zeros, lambda: &[], t: 0.0, load: 1.0 })
    };
    contacts.iter().map(of).sum()
}

fn energy(contacts: &[FaceContact], point: &Vector3<f64>) -> f64 {
    sum(contacts, point, &[], |term, at| term.energy(at).strain)
}

/// Force on the point.
fn force(contacts: &[FaceContact], point: &Vector3<f64>) -> Vector3<f64> {
    let component = |k: usize| {
        sum(contacts, point, &[], |term, at| {
            let mut r = vec![0.0; at.q.len()];
            term.residual(at, &mut r);
            -r[k]
        })
    };
    Vector3::new(component(0), component(1), component(2))
}

/// Over a flat mesh the potential is that of the distance from the plane, above elements, edges and nodes, and beyond the free
/// edges that of the distance from the edge.
#[test]
fn flat_meshes_count_each_point_once() {
    let mut random = Random(11);
    for is_split in [false, true] {
        let all = contacts(&mesh(|| 0.0, is_split), LAW);
        for case in 0..500 {
            let [x, y] = [0, 1].map(|_| 1.5 + 1.7 * random.number());
            // Every third point is over a line of the mesh.
            let x = if case % 3 == 0 { x.round() } else { x };
            let point = Vector3::new(x, y, 0.28 * random.number());
            let nearest = Vector3::new(x.clamp(0.0, 3.0), y.clamp(0.0, 3.0), 0.0);
            let distance = (point - nearest).norm();
            let expected = LAW.energy(distance - RADIUS);
            assert!((energy(&all, &point) - expected).abs() < 1e-14, "{point}: {expected}");
            if distance > 0.01 {
                let exact = (point - nearest) * (LAW.pressure(distance - RADIUS) / distance);
                assert!((force(&all, &point) - exact).norm() < 1e-12, "{point}");
            }
        }
    }
}

/// Along lines over ridges, valleys and nodes, at more than half a radius, the force is continuous, while the closest element changes.
#[test]
fn forces_are_continuous_at_kinks() {
    let mut random = Random(12);
    for is_split in [false, true] {
        let heights: Vec<f64> = (0..16).map(|_| 0.1 * random.number()).collect();
        let mut next = heights.iter().copied();
        let all = contacts(&mesh(|| next.next().unwrap_or_default(), is_split), LAW);
        let mut largest: f64 = 0.0;
        for _ in 0..40 {
            let [from, to] = [0, 1].map(|_| {
                Vector3::new(
                    1.5 + 1.4 * random.number(),
                    1.5 + 1.4 * random.number(),
                    0.28 + 0.03 * random.number(),
                )
            });
            let (count, length) = (2000, (to - from).norm());
            let mut last = force(&all, &from);
            for k in 1..=count {
                let now = force(&all, &(from + (to - from) * (f64::from(k) / f64::from(count))));
                // Bound of the second derivative: the stiffness of a few elements.
                let change = (now - last).norm() / (length / f64::from(count));
                assert!(change < 8.0 * LAW.stiffness, "{change}");
                largest = largest.max(now.norm());
                last = now;
            }
        }
        assert!(largest > 0.2 * RADIUS * LAW.stiffness, "{largest}");
    }
}

/// Damping and friction of all elements together dissipate energy, at any kinks and velocities.
#[test]
fn losses_are_positive() {
    let mut random = Random(13);
    for (damping, friction) in [(0.5, 0.0), (0.0, 0.4)] {
        let law = ContactLaw { damping, friction, ..LAW };
        let mut acting = 0;
        for case in 0..30 {
            let all = contacts(&mesh(|| 0.25 * random.number(), case % 2 == 0), law);
            for _ in 0..20 {
                let point = Vector3::new(1.5 + random.number(), 1.5 + random.number(), 0.3 * random.number());
                let v: Vec<f64> = (0..3 + 16 * 6).map(|_| random.number()).collect();
                let loss = sum(&all, &point, &v, |term, at| term.power(at).dissipation);
                assert!(loss >= -1e-12, "{point}: {loss:e}");
                acting += usize::from(loss > 1e-6);
            }
        }
        assert!(acting > 100, "{acting}");
    }
}
