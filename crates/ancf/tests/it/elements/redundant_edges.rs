//! Statics of a bent half shell whose plane of symmetry states motions that the joints of a rigid body state too.

use std::f64::consts::FRAC_PI_4;

use crate::common::assertions::assert_relative;
use crate::common::models::parse;
use crate::common::solutions::Run;

/// Quarter of a tape between planes of symmetry, bent by a body on a hinge that slides along x.
fn bent(angle: f64, guide: &str) -> Run {
    let (radius, height) = (0.02, 0.018);
    let [y, z] = [radius * FRAC_PI_4.sin(), radius * FRAC_PI_4.cos()];
    let body = |name: &str| {
        format!(
            "[[bodies]]\nkind = \"rigid\"\nname = \"{name}\"\ncenter = [0.06, 0, {height}]\nmass = 0.01\ninertia = [1e-6, 1e-6, 1e-6]\n"
        )
    };
    let symmetry = |name: &str, edge: &str| {
        format!(
            "[[joints]]\nkind = \"support\"\nname = \"{name}\"\na = {{ body = \"tape\", at = {{ edge = \"{edge}\" }} }}\ncondition = \"symmetry\"\n"
        )
    };
    let text = format!(
        "materials.steel = {{ density = 8000, young = 1e11, poisson = 0.3 }}\n\
         [[bodies]]\nkind = \"shell\"\nname = \"tape\"\nelements = [2, 3]\nthickness = 2e-4\nmaterial = \"steel\"\n\
         surface = {{ kind = \"revolved\", from = [0, {y}, {z}], to = [0.06, {y}, {z}], center = [0, 0, 0], axis = [1, 0, 0], angle = {FRAC_PI_4} }}\n\
         {}{}{}{}\
         [[joints]]\nkind = \"support\"\nname = \"end\"\na = {{ body = \"tape\", at = {{ edge = \"v_end\" }} }}\n\
         b = {{ body = \"b\", at = \"center\" }}\ncondition = \"clamped\"\n\
         [[joints]]\nname = \"guide\"\na = {{ body = \"slider\", at = \"center\" }}\n{guide}\n\
         [[joints]]\nkind = \"revolute\"\nname = \"hinge\"\na = {{ body = \"b\", at = \"center\" }}\n\
         b = {{ body = \"slider\", at = \"center\" }}\naxis = [0, 1, 0]\ndrive = {{ angle = {angle:e} }}\n\
         [analysis]\nkind = \"statics\"\n",
        body("b"),
        body("slider"),
        symmetry("middle", "v_start"),
        symmetry("crown", "u_end"),
    );
    Run::of(&parse(&text))
}

/// Redundant joints do not change the equilibrium. Before, rounding errors of the tangent gave the scale of the constraint forces of a
/// rigid body: increments did not solve the equations, and the state was accepted with a wrong angle.
#[test]
fn redundant_joints_do_not_change_the_equilibrium() {
    for angle in [1e-6, -1e-3, 0.05] {
        let redundant = bent(angle, "kind = \"prismatic\"\naxis = [1, 0, 0]");
        let least = bent(
            angle,
            "kind = \"generic\"\ndisplacements = [\"free\", \"free\", \"locked\"]\nrotations = [\"free\", \"locked\", \"free\"]",
        );
        for series in [&redundant, &least] {
            assert_relative("angle", series.last("hinge.angle"), angle, 1e-9);
        }
        for name in ["hinge.my", "strain"] {
            assert_relative(name, redundant.last(name), least.last(name), 1e-6);
        }
    }
}
