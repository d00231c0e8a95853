//! Statics under loads without a potential, in planes that are no coordinate planes.

use nalgebra::{Rotation3, Vector3};

use crate::common::models::parse;
use crate::common::solutions::Run;

const LENGTH: f64 = 10.0;
const STIFFNESS: f64 = 100.0;

/// Cantilever of a round section and a load of its end in the turned frame. Returns the position of its end in this frame, and the number
/// of iterations.
fn end_of(turn: &Rotation3<f64>, load: &str, vector: Vector3<f64>) -> (Vector3<f64>, f64) {
    let text = |v: Vector3<f64>| format!("{:?}", (turn * v).as_slice());
    let run = Run::of(&parse(&format!(
        "materials.m = {{ density = 1.0, young = 1e6, poisson = 0.0 }}\n\
         sections.s = {{ kind = \"general\", area = 1.0, iy = 1e-4, iz = 1e-4, j = 2e-4 }}\n\
         bodies = [{{ kind = \"beam\", name = \"b\", from = [0, 0, 0], to = {}, up = {}, elements = 16, section = \"s\", material = \"m\" }}]\n\
         joints = [{{ kind = \"clamp\", name = \"c\", a = {{ body = \"b\", at = \"start\" }} }}]\n\
         loads = [{{ kind = \"{load}\", on = {{ body = \"b\", at = \"end\" }}, {load} = {}, follower = true }}]\n\
         probes = [{{ name = \"t\", on = {{ body = \"b\", at = \"end\" }} }}]\nanalysis = {{ kind = \"statics\" }}\n",
        text(Vector3::x() * LENGTH),
        text(Vector3::y()),
        text(vector)
    )));
    (turn.inverse() * run.last_vector("t."), run.column("iterations").iter().sum())
}

/// An end moment of half a turn, and a transverse follower force, bend the beam to the same shape in any plane, in as many iterations. Newton's
/// method with the symmetric part of the stiffness alone does not converge out of a coordinate plane: rounding errors grow.
#[test]
fn shapes_do_not_depend_on_the_direction_of_the_model() {
    let turned = Rotation3::from_scaled_axis(Vector3::new(0.3, -0.7, 1.1));
    let moment = Vector3::z() * std::f64::consts::PI * STIFFNESS / LENGTH;
    let force = Vector3::y() * 4.0 * STIFFNESS / LENGTH.powi(2);
    for (load, vector) in [("moment", moment), ("force", force)] {
        let (expected, of_plane) = end_of(&Rotation3::identity(), load, vector);
        let (found, of_turned) = end_of(&turned, load, vector);
        assert!((found - expected).norm() < 1e-9 * LENGTH, "{load}: {found} for {expected}");
        assert!((of_plane - of_turned).abs() <= 4.0, "{load}: {of_plane} and {of_turned} iterations");
    }
    // Half a turn: the end is a diameter from the root.
    let (end, _) = end_of(&turned, "moment", moment);
    assert!((end - Vector3::y() * 2.0 * LENGTH / std::f64::consts::PI).norm() < 1e-3 * LENGTH, "{end}");
}
