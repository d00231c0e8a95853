//! Sums of the contacts of a point with all elements of a shear-deformable shell: one smooth potential at any kinks.

use ancf::mechanics::contact::{ContactGeometry, ContactLaw, ContactPoint, FaceContact};
use ancf::mechanics::kinematics::Marker;
use ancf::mechanics::shells::{
    Face, Laminate, LocalSection, Ply, PlyElasticity, SectionField, ShearMedium, ShearShellMesh,
};
use ancf::solver::equations::{Local, Term, Weights};
use nalgebra::{Matrix3, Vector3};

use crate::common::random::Random;
use crate::common::sample::{Sample, tangent};

const RADIUS: f64 = 0.3;
const LAW: ContactLaw =
    ContactLaw { stiffness: 10.0, transition: 0.01, damping: 0.0, friction: 0.0, slip_speed: 1.0 };

/// Mesh of 3 × 3 cells with heights of its nodes, of quadrilaterals or triangles.
fn mesh(heights: impl FnMut() -> f64, is_split: bool) -> ContactGeometry {
    tapered_mesh(heights, is_split, [0.0; 2])
}

/// Mesh whose half thickness rises by given slopes from ½ at the first corner.
fn tapered_mesh(heights: impl FnMut() -> f64, is_split: bool, slopes: [f64; 2]) -> ContactGeometry {
    let mut heights = heights;
    let nodes: Vec<_> =
        (0..16).map(|k| Vector3::new(f64::from(k % 4), f64::from(k / 4), heights())).collect();
    let split = |k: usize| match is_split {
        false => vec![Face::Quad([k, k + 1, k + 5, k + 4])],
        true => vec![Face::Triangle([k, k + 1, k + 5]), Face::Triangle([k, k + 5, k + 4])],
    };
    let faces: Vec<Face> = (0..9).flat_map(|k| split(k / 3 * 4 + k % 3)).collect();
    let ply =
        Ply { elasticity: PlyElasticity::isotropic(7.0, 0.3), density: 2.0, thickness: 0.1, angle: 0.0 };
    let medium = ShearMedium {
        section: Laminate::new(vec![ply]).thick_section(),
        axis: Vector3::x(),
        retardation: 0.0,
        mass_damping: 0.0,
        gravity: Vector3::zeros(),
    };
    let (of_faces, of_nodes) = (faces.clone(), nodes.clone());
    let scale = move |element: usize, at: [f64; 2]| {
        let face = &of_faces[element];
        let weights = face.weights(at);
        let place: Vector3<f64> =
            face.nodes().iter().zip(weights).map(|(node, weight)| of_nodes[*node] * weight).sum();
        LocalSection { scale: 1.0 + 2.0 * (slopes[0] * place.x + slopes[1] * place.y), ..LocalSection::WHOLE }
    };
    let sections = (slopes != [0.0; 2]).then(|| SectionField::new(scale));
    let mesh = ShearShellMesh::varying(3, (&nodes, &[Vector3::z(); 16]), faces, &medium, sections);
    ContactGeometry::shear_shell(&mesh, 1.0, 5)
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

/// Derivative of the force on the point, reversed.
fn stiffness(contacts: &[FaceContact], point: &Vector3<f64>) -> Matrix3<f64> {
    let of = |term: &FaceContact| {
        let mut s = Sample::rest(term);
        for (q, c) in s.q.iter_mut().zip(term.coordinates()).filter(|(_, c)| **c < 3) {
            *q = point[*c];
        }
        tangent(term, &s, Weights::STIFFNESS).fixed_view::<3, 3>(0, 0).into_owned()
    };
    contacts.iter().map(of).sum()
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

/// Over a flat mesh whose thickness varies the surface is a plane that is tilted to the middle: at the height z from the middle the gap is
/// √(1 − s²) z − e, with the slope s of half the thickness. The force is normal to this plane.
#[test]
fn wedges_are_planes() {
    let (mut random, slopes) = (Random(14), [0.2, -0.1]);
    let rise = f64::sqrt(1.0 - 0.05);
    for is_split in [false, true] {
        let all = contacts(&tapered_mesh(|| 0.0, is_split, slopes), LAW);
        // The smallest half thickness is that of the corner (0, 3).
        let excess = |x: f64, y: f64| slopes[0] * x + slopes[1] * (y - 3.0);
        for case in 0..500 {
            let [x, y] = [0, 1].map(|_| 1.5 + random.number());
            let x = if case % 3 == 0 { x.round() } else { x };
            let height = (RADIUS + excess(x, y)) / rise - 0.1 * (1.1 + random.number());
            let point = Vector3::new(x, y, height);
            let gap = rise * height - excess(x, y) - RADIUS;
            let expected = LAW.energy(gap);
            assert!((energy(&all, &point) - expected).abs() < 1e-13, "{point}: {expected}");
            let exact = Vector3::new(-slopes[0], -slopes[1], rise) * LAW.pressure(gap);
            assert!((force(&all, &point) - exact).norm() < 1e-11, "{point}: {}", force(&all, &point));
            let h = 1e-5;
            let softening = |k: usize| {
                let moved = |sign: f64| LAW.pressure(gap + sign * h * exact.normalize()[k]);
                (moved(1.0) - moved(-1.0)) / (2.0 * h)
            };
            let normal = exact.try_normalize(0.0).unwrap_or_else(Vector3::zeros);
            if gap < -0.02 {
                let stiffness = stiffness(&all, &point);
                for k in 0..3 {
                    let expected = normal * -softening(k);
                    assert!(
                        (stiffness.column(k) - expected).norm() < 1e-7,
                        "{point}: {stiffness} {expected}"
                    );
                }
            }
        }
    }
}

/// Along lines over ridges, valleys and nodes, at more than half a radius, the force is continuous, while the closest element changes.
#[test]
fn forces_are_continuous_at_kinks() {
    let mut random = Random(12);
    for (is_split, slopes) in
        [(false, [0.0; 2]), (true, [0.0; 2]), (false, [0.02, 0.01]), (true, [0.02, 0.01])]
    {
        let heights: Vec<f64> = (0..16).map(|_| 0.1 * random.number()).collect();
        let mut next = heights.iter().copied();
        let all = contacts(&tapered_mesh(|| next.next().unwrap_or_default(), is_split, slopes), LAW);
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
            let slopes = if case % 3 == 0 { [0.02, 0.01] } else { [0.0; 2] };
            let shell = tapered_mesh(|| 0.25 * random.number(), case % 2 == 0, slopes);
            let all = contacts(&shell, law);
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
