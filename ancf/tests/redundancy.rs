//! Joints that tie what others tie: named, shared, and without effect on the motion.
#![cfg(test)]

#[expect(dead_code, reason = "other test binaries use the rest")]
#[path = "common/rod.rs"]
mod rod;
#[expect(dead_code, reason = "other test binaries use the rest")]
#[path = "common/run.rs"]
mod run;

use std::time::Instant;

use ancf::Model;
use ancf::model::{Analysis, At, AtEnd, Beam, Body, Clamped, End, Formulation, Joint, Modes, Place, Statics};
use ancf::system::{Sparse, dependences};
use nalgebra::{DMatrix, Vector3};
use proptest::prelude::*;

use run::{Run, distance};

fn ball(name: &str, a: Place) -> Joint {
    Joint::Spherical { name: name.into(), a, b: End::Ground }
}

fn clamp(name: &str, a: Place, fix: Clamped) -> Joint {
    Joint::Clamp { name: name.into(), a, b: End::Ground, fix: Some(fix) }
}

fn short(mut model: Model) -> Model {
    rod::settings(&mut model).duration = 0.2;
    model
}

fn with(mut model: Model, joints: impl IntoIterator<Item = Joint>) -> Model {
    model.joints.extend(joints);
    model
}

/// Names of the redundant equations.
fn words(model: &Model) -> Vec<String> {
    model.assemble().unwrap().redundant().iter().map(ToString::to_string).collect()
}

/// Two clamps of one end carry a half each, and the rod moves as with one.
#[test]
fn two_clamps_share_equally() {
    for fix in [Clamped::All, Clamped::Section] {
        let one = short(rod::clamped(4, fix));
        let two = with(one.clone(), [clamp("again", rod::start(), fix)]);
        let (one, two) = (Run::of(&one), Run::of(&two));
        assert!(distance(&one.vectors("tip."), &two.vectors("tip.")) < 1e-9 * rod::LENGTH);
        for part in ["f", "m"] {
            let whole = one.vectors(&format!("root.{part}"));
            let [a, b] = ["root", "again"].map(|joint| two.vectors(&format!("{joint}.{part}")));
            let size = whole.iter().map(Vector3::norm).fold(0.0, f64::max);
            assert!(distance(&a, &b) < 1e-6 * size, "{fix:?}, {part}: halves");
            let sum: Vec<_> = a.iter().zip(&b).map(|(a, b)| a + b).collect();
            assert!(
                distance(&whole, &sum) < 1e-6 * size,
                "{fix:?}, {part}: sum {:e}",
                distance(&whole, &sum) / size
            );
        }
    }
}
