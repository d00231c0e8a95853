//! Generic joints and bushings by matrices.

use ancf::Model;
use nalgebra::{Rotation3, Vector3};

use crate::common::models::jointed_body::{DYNAMICS, STATICS, jointed_body};
use crate::common::models::parse;
use crate::common::solutions::{Run, distance};

/// Motion of the body with a joint under a load, a moment and gravity.
fn motion(keys: &str) -> Run {
    let loads = "[[loads]]\nkind = \"moment\"\non = { body = \"body\", at = \"center\" }\nmoment = [0.3, 0.2, -0.4]\n";
    Run::of(&parse(&(String::from("gravity = [1, 2, -5]\n") + &jointed_body(keys) + loads + DYNAMICS)))
}

fn generic(displacements: [u8; 3], rotations: [u8; 3], axes: &str) -> String {
    let words = |free: [u8; 3]| free.map(|free| if free == 1 { "free" } else { "locked" });
    format!(
        "kind = \"generic\"\ndisplacements = {:?}\nrotations = {:?}\n{axes}\n",
        words(displacements),
        words(rotations)
    )
}

/// A generic joint has the motion and the reactions of the joint with the same free directions.
#[test]
fn generic_joint_equals_special_joints() {
    let turned = "x_axis = [0.6, 0.8, 0]\ny_axis = [0, 0, 2]";
    let pairs = [
        ([0, 0, 0], [0, 0, 0], "", "kind = \"clamp\""),
        ([0, 0, 0], [1, 1, 1], "", "kind = \"spherical\""),
        ([0, 0, 0], [0, 1, 0], "", "kind = \"revolute\"\naxis = [0, 1, 0]"),
        ([0, 0, 0], [1, 0, 0], turned, "kind = \"revolute\"\naxis = [0.6, 0.8, 0]"),
        ([0, 0, 1], [0, 0, 0], "", "kind = \"prismatic\"\naxis = [0, 0, 1]"),
        ([1, 0, 0], [1, 0, 0], turned, "kind = \"cylindrical\"\naxis = [0.6, 0.8, 0]"),
        ([1, 1, 0], [0, 0, 1], "", "kind = \"planar\"\nnormal = [0, 0, 1]"),
        ([1, 0, 0], [1, 1, 1], "", "kind = \"point_on_line\"\naxis = [1, 0, 0]"),
        ([0, 0, 0], [1, 1, 0], "", "kind = \"universal\"\naxis_a = [1, 0, 0]\naxis_b = [0, 1, 0]"),
        ([0, 0, 0], [0, 1, 1], "", "kind = \"universal\"\naxis_a = [0, 1, 0]\naxis_b = [0, 0, 1]"),
    ];
    for (displacements, rotations, axes, special) in pairs {
        let [found, expected] =
            [generic(displacements, rotations, axes), special.to_owned()].map(|keys| motion(&keys));
        let error = distance(&found.vectors("center."), &expected.vectors("center."));
        assert!(error < 1e-7, "{special}: {error}");
        let force = (found.last_vector("joint.f") - expected.last_vector("joint.f")).norm();
        let moment = (found.last_vector("joint.m") - expected.last_vector("joint.m")).norm();
        assert!(force < 1e-5 && moment < 1e-5, "{special}: {force}, {moment}");
        assert!(found.largest("balance") < 2e-3, "{special}: {}", found.largest("balance"));
    }
}

#[test]
fn free_directions_are_recorded() {
    let run = motion(&generic([0, 0, 1], [0, 0, 1], ""));
    assert!(run.column("joint.angle").len() == run.column("joint.displacement").len());
    let error = |keys: &str| Model::parse(&(jointed_body(keys) + DYNAMICS)).unwrap_err().to_string();
    assert!(error(&generic([1; 3], [1; 3], "")).contains("six free directions"));
    let skew = error(&generic([0; 3], [1; 3], "x_axis = [1, 1, 0]"));
    assert!(skew.contains("joints[0].x_axis") && skew.contains("45"), "{skew}");
}

fn matrix(rows: [[f64; 3]; 3]) -> String {
    format!("{rows:?}")
}

fn diagonal(values: [f64; 3]) -> String {
    matrix([[values[0], 0.0, 0.0], [0.0, values[1], 0.0], [0.0, 0.0, values[2]]])
}

/// Rotation by 2.5 rad about any axis under a moment: eᵀ R e φ = M. A hinge holds the axis.
#[test]
fn rotation_vector_is_the_measure_at_large_rotations() {
    let axis = Vector3::new(0.48, -0.6, 0.64);
    let rotation = [[12.0, 1.0, 0.0], [1.0, 9.0, -2.0], [0.0, -2.0, 10.0]];
    let stiffness = axis.dot(&(nalgebra::Matrix3::from_fn(|i, j| rotation[i][j]) * axis));
    let moment = axis * (2.5 * stiffness);
    let keys = format!(
        "kind = \"matrix_bushing\"\nstiffness = {}\nrotation_stiffness = {}\n",
        diagonal([1e3; 3]),
        matrix(rotation)
    );
    let hinge = "[[joints]]\nname = \"hinge\"\nkind = \"revolute\"\na = { body = \"body\", at = [0, 0, 0] }\naxis = [0.48, -0.6, 0.64]\n";
    let loads = format!(
        "[[loads]]\nkind = \"moment\"\non = {{ body = \"body\", at = \"center\" }}\nmoment = {:?}\n",
        [moment.x, moment.y, moment.z]
    );
    let run = Run::of(&parse(&(jointed_body(&keys) + hinge + &loads + STATICS)));
    let found = run.last_vector("center.");
    let expected = Rotation3::new(axis * 2.5) * Vector3::new(0.4, 0.1, -0.2);
    assert!((found - expected).norm() < 1e-6, "{found} for {expected}");
    let reaction = run.last_vector("joint.m").dot(&axis) + moment.norm();
    assert!(reaction.abs() < 1e-5, "{reaction}");
}

/// Full matrices of a small rotation: ζ = K⁻¹ (f, m), and the preload cancels a load.
#[test]
fn coupled_stiffness_has_the_deflection_of_a_beam() {
    // Tip stiffness of a cantilever of length l along x: 12 EI/l³, −6 EI/l², 4 EI/l in both planes, EA/l, GJ/l.
    let (ei, l) = (2e4, 0.5_f64);
    let (t, c, r) = (12.0 * ei / l.powi(3), 6.0 * ei / l.powi(2), 4.0 * ei / l);
    let keys = |preload: &str| {
        format!(
            "kind = \"matrix_bushing\"\nstiffness = {}\nrotation_stiffness = {}\ncoupling = {}\n{preload}\n",
            diagonal([1e7, t, t]),
            diagonal([1e4, r, r]),
            matrix([[0.0; 3], [0.0, 0.0, -c], [0.0, c, 0.0]])
        )
    };
    let force = 10.0;
    let load = format!(
        "[[loads]]\nkind = \"force\"\non = {{ body = \"body\", at = [0, 0, 0] }}\nforce = [0, {force}, 0]\n"
    );
    let run = Run::of(&parse(&(jointed_body(&keys("")) + &load + STATICS)));
    let (tip, turn) = (force * l.powi(3) / (3.0 * ei), force * l * l / (2.0 * ei));
    let found = run.last_vector("center.") - Vector3::new(0.4, 0.1, -0.2);
    let expected = Vector3::new(-0.1 * turn, tip + 0.4 * turn, 0.0);
    assert!(
        (found - expected).norm() < 1e-2 * turn * turn.max(1e-4) + 3.0 * turn * turn,
        "{found} for {expected}"
    );
    let run = Run::of(&parse(&(jointed_body(&keys("preload = [0, -10, 0]")) + &load + STATICS)));
    assert!((run.last_vector("center.") - Vector3::new(0.4, 0.1, -0.2)).norm() < 1e-10);
}

/// The energy-momentum scheme conserves the energy of a free body on a coupled bushing with large rotations.
#[test]
fn energy_is_conserved_at_large_rotations() {
    let keys = format!(
        "kind = \"matrix_bushing\"\nstiffness = {}\nrotation_stiffness = {}\ncoupling = {}\nx_axis = [0.6, 0.8, 0]\ny_axis = [-0.8, 0.6, 0]\n",
        diagonal([300.0, 200.0, 100.0]),
        matrix([[3.0, 0.4, 0.0], [0.4, 2.0, 0.0], [0.0, 0.0, 4.0]]),
        matrix([[0.0, 6.0, 0.0], [-3.0, 0.0, 2.0], [0.0, 1.0, 0.0]])
    );
    let text =
        jointed_body(&keys).replace("mass = 2,", "mass = 2, motion = { spin = [3, -1, 2] },") + DYNAMICS;
    let energy = Run::of(&parse(&text.replace("scheme = { spectral_radius = 0.8 }", "scheme = \"energy\"")));
    assert!(energy.largest("balance") < 1e-8, "{}", energy.largest("balance"));
    assert!(energy.largest("strain") > 0.2, "{}", energy.largest("strain"));
    let alpha = Run::of(&parse(&text));
    assert!(distance(&alpha.vectors("center."), &energy.vectors("center.")) < 2e-3);
    let error =
        Model::parse(&text.replace("[3.0, 0.4", "[3.0, -0.4").replace("[300.0", "[0.001")).unwrap_err();
    let error = error.to_string();
    assert!(error.contains("symmetric") && error.contains("negative eigenvalue"), "{error}");
}
