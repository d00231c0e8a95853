//! Fold of a tape spring.

use std::f64::consts::PI;

use super::models::{ShellModel, edge, increments};
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[Problem {
    name: "tape_spring",
    title: "Tape spring that snaps into a fold",
    source: "Moment of a fold of opposite sense, (1 + ν) D α with the angle α of the arc: Wüst (1954); Seffen & Pellegrino (1999), \
             Deployment dynamics of tape springs. The theory neglects the transition from the fold to the straight parts",
    sketch: r"
        .-''''-.          R = 13.3 mm, α = 110 degrees, h = 0.1 mm, length 120 mm
       /        \         E = 131 GPa, ν = 0.3; both ends turn by 0.7 radians",
    goal: "A quarter with 3 × 16 elements: moment of the fold within 4 %, after a snap from about twenty times this moment",
    run: tape,
}];

/// Radius, angle of the arc and half of the length.
const RADIUS: f64 = 0.0133;
const ARC: f64 = 110.0 / 180.0 * PI;
const LENGTH: f64 = 0.06;

/// Rotation of an end body that slides along the tape. The arc has its centroid at the place of the body.
fn ends() -> String {
    let height = RADIUS * (0.5 * ARC).sin() / (0.5 * ARC);
    let body = |name: &str| {
        format!(
            "[[bodies]]\nkind = \"rigid\"\nname = \"{name}\"\ncenter = [{LENGTH}, 0, {height}]\nmass = 0.01\ninertia = [1e-6, 1e-6, 1e-6]\n"
        )
    };
    format!(
        "{}{}[[joints]]\nkind = \"support\"\nname = \"end\"\na = {{ body = \"s\", at = {{ edge = \"v_end\" }} }}\n\
         b = {{ body = \"grip\", at = \"center\" }}\ncondition = \"clamped\"\n\
         [[joints]]\nkind = \"generic\"\nname = \"guide\"\na = {{ body = \"slider\", at = \"center\" }}\n\
         displacements = [\"free\", \"free\", \"locked\"]\nrotations = [\"free\", \"locked\", \"free\"]\n\
         [[joints]]\nkind = \"revolute\"\nname = \"hinge\"\na = {{ body = \"grip\", at = \"center\" }}\n\
         b = {{ body = \"slider\", at = \"center\" }}\naxis = [0, 1, 0]\ndrive = {{ angle = -0.7 }}\n",
        body("grip"),
        body("slider")
    )
}

fn tape() -> Result<Findings, VerificationError> {
    let (y, z) = (RADIUS * (0.5 * ARC).sin(), RADIUS * (0.5 * ARC).cos());
    let surface = format!(
        "kind = \"revolved\", from = [0, {y}, {z}], to = [{LENGTH}, {y}, {z}], center = [0, 0, 0], axis = [1, 0, 0], angle = {}",
        0.5 * ARC
    );
    let shell = ShellModel {
        surface: &surface,
        elements: [3, 16],
        thickness: 1e-4,
        material: [1.31e11, 0.3, 8000.0],
    };
    let model = format!(
        "{shell}{}{}{}[analysis]\nkind = \"statics\"\n",
        edge("v_start", "\"symmetry\""),
        edge("u_end", "\"symmetry\""),
        ends()
    );
    let (solved, mut found) = (solve(&model)?, Findings::default());
    // The moments are those of the half of the arc.
    let fold = 1.3 * 1.31e11 * 1e-12 / (12.0 * (1.0 - 0.09)) * ARC;
    let curve: Vec<[f64; 2]> = solved
        .points("load", "hinge.my")?
        .into_iter()
        .map(|[load, moment]| [0.7 * load, -2.0 * moment])
        .collect();
    found.compare("moment of the fold, N m", -2.0 * solved.last("hinge.my")?, fold, fold, 4e-2);
    found.plot(Plot::new(
        format!("Moment over the rotation of the end; {} increments and iterations", increments(&solved)),
        ["rotation, rad", "moment, N m"],
        vec![
            PlotCurve::line("(1 + ν) D α", vec![[0.0, fold], [0.7, fold]]),
            PlotCurve::points("computed", curve),
        ],
    ));
    Ok(found)
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
