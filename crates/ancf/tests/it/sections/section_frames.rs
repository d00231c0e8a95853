//! The frame of a section: derivatives, objectivity, mirrored and renamed axes.

use ancf::mechanics::kinematics::{Marker, SectionFrame};
use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::common::random::Random;

/// Frame of two directors with three coordinates each.
fn frame(reference: [Vector3<f64>; 2], weight: f64) -> SectionFrame {
    let [d, e] = [0, 1].map(|k| Marker::new([(3 * k, 1.0)], reference[k]));
    SectionFrame::new([&d, &e], weight)
}

fn coordinates(parts: [Vector3<f64>; 2]) -> [f64; 6] {
    std::array::from_fn(|i| parts[i / 3][i % 3])
}

/// Reference directors that may be skew, and displacements of magnitude 0.3.
fn sample(random: &mut Random, is_skew: bool) -> ([Vector3<f64>; 2], [Vector3<f64>; 2]) {
    let turn = Rotation3::new(random.vector3());
    let skew = if is_skew { 0.2 } else { 0.0 };
    let reference = [Vector3::y(), Vector3::z()].map(|axis| turn * (axis + random.vector3() * skew));
    (reference, [0, 1].map(|_| random.vector3() * 0.3))
}

/// δθ = T (δd, δe), ω̇ and S(M) as derivatives; M·ω is the power of the forces, whose couple is M.
#[test]
fn variations_are_derivatives() {
    let mut random = Random(1883);
    for k in 0..40 {
        let (reference, u) = sample(&mut random, k % 2 == 0);
        let frame = frame(reference, [0.5, 0.3, 0.81][k % 3]);
        let (rates, moment) = ([0, 1].map(|_| random.vector3()), random.vector3());
        let moved = |h: f64| frame.at(&coordinates([0, 1].map(|i| u[i] + rates[i] * h)));
        let (now, h) = (frame.at(&coordinates(u)), 1e-5);
        let own = frame.rates(&coordinates(rates));
        let spin = now.spin(own);
        let slope = (moved(h).rotation() - moved(-h).rotation()) / (2.0 * h);
        let expected = spin.cross_matrix() * now.rotation();
        assert!((slope - expected).amax() < 1e-8, "{k}: {slope} {expected}");
        let acceleration = (moved(h).spin(own) - moved(-h).spin(own)) / (2.0 * h);
        assert!((acceleration - now.spin_rate(own)).norm() < 1e-7, "{k}");
        let forces = now.forces(&moment);
        let power: f64 = forces.iter().zip(&own).map(|(force, rate)| force.dot(rate)).sum();
        assert!((power - moment.dot(&spin)).abs() < 1e-13, "{k}");
        let directors = frame.directors().each_ref().map(Marker::reference);
        let values = [0, 1].map(|i| directors[i] + frame.rates(&coordinates(u))[i]);
        let couple = values[0].cross(&forces[0]) + values[1].cross(&forces[1]);
        assert!((couple - moment).norm() < 1e-13, "{k}");
        let change = now.force_variation(&moment, own);
        for i in 0..2 {
            let slope = (moved(h).forces(&moment)[i] - moved(-h).forces(&moment)[i]) / (2.0 * h);
            assert!((slope - change[i]).norm() < 1e-7, "{k}: {slope} {}", change[i]);
        }
        let [of_d, of_e] = now.variation();
        assert!((of_d * own[0] + of_e * own[1] - spin).norm() < 1e-13, "{k}");
        assert!((now.change(&moment) - (now.turned(&moment) - moment)).norm() < 1e-14, "{k}");
    }
}

/// R(Q d, Q e) = Q R; exchanged names of the axes and mirrored sections have the same and the mirrored rotation.
#[test]
fn frame_is_objective_and_closed_under_mirroring() {
    let mut random = Random(1909);
    for k in 0..40 {
        let (reference, u) = sample(&mut random, k % 2 == 0);
        let values = [0, 1].map(|i| reference[i] + u[i]);
        let weight = [0.5, 0.3, 0.81][k % 3];
        let of = |[d0, e0]: [Vector3<f64>; 2], [d, e]: [Vector3<f64>; 2], weight| {
            frame([d0, e0], weight).at(&coordinates([d - d0, e - e0])).rotation()
        };
        let rotation = of(reference, values, weight);
        let turn = Rotation3::new(random.vector3());
        let turned = of(reference, values.map(|x| turn * x), weight);
        assert!((turned - turn.matrix() * rotation).amax() < 2e-15, "{k}: turned");
        // The reference of skew directors is the bisector, which the exchange of names keeps for equal weights.
        if k % 2 == 1 || weight == 0.5 {
            let renamed = |[d, e]: [Vector3<f64>; 2]| [e, -d];
            let other = of(renamed(reference), renamed(values), 1.0 - weight);
            assert!((other - rotation).amax() < 2e-15, "{k}: renamed");
        }
        let mirror = Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, 1.0));
        let mirrored = |[d, e]: [Vector3<f64>; 2]| [-(mirror * d), mirror * e];
        let other = of(mirrored(reference), mirrored(values), weight);
        assert!((other - mirror * rotation * mirror).amax() < 2e-15, "{k}: mirrored");
    }
}

/// Rigid rotations are reproduced, with any weights and any size of the section.
#[test]
fn rigid_rotations_are_exact() {
    let mut random = Random(1867);
    for k in 0..20 {
        let (reference, _) = sample(&mut random, k % 2 == 0);
        let turn = Rotation3::new(random.vector3() * 3.0);
        let values = reference.map(|x| turn * x * 1.3);
        let moved = coordinates([0, 1].map(|i| values[i] - reference[i]));
        let found = frame(reference, 0.3).at(&moved).rotation();
        assert!((found - turn.matrix()).amax() < 2e-15, "{k}");
    }
}
