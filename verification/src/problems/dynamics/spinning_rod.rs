use ancf::solver::equations::{EquationsOfMotion, State};
use nalgebra::{Unit, UnitQuaternion, Vector3};

use super::motion::{Inertia, advance, assemble, dynamics};
use crate::problems::models::{ROD, Rod, end_probe};
use crate::{Findings, Plot, PlotCurve, Problem, SolvedModel, VerificationError, solve};

/// Spinning rods: axial stretch on a hub, tumbling in free flight.
pub const PROBLEM: Problem = Problem {
    name: "spinning_rod",
    title: "Spinning rods: stretch on a hub, tumbling in free flight",
    source: "Steady stretch tan(kL)/k − L, k = ω √(ρ/E), and root force E A (1/cos kL − 1) in closed form from the radial \
             equilibrium; a free symmetric top precesses about its angular momentum at |L|/J_t",
    sketch: r"
    ___ ω                         L               L = 1 m, steel
   /   \ |                        |   /
   O=====|==============          |  /   tumbling rod of d = 0.1 m,
  hub                             | /    10⁴ steps of 0.5 ms
                                  |/",
    goal: "On a hub at 50 rad/s, after 1 s of spin-up: stretch and root force within 2e-4 of theory, 6e-5 of which is due to \
           Green's strain. Tumbling: momentum, angular momentum and energy to 1e-6, over 10⁴ steps of generalized-α with a \
           spectral radius of 0.8; tip within 1e-5 of the tip of the rigid top",
    run,
};

/// Speed of the hub, 1/s.
const SPEED: f64 = 50.0;
/// Stretch, m.
const STRETCH: f64 = 3.467329063900729e-5;
/// Root force, N.
const FORCE: f64 = 3153.5102984358;
/// Angular velocity of the top about its axis and across, 1/s.
const SPIN: Vector3<f64> = Vector3::new(1.0, 0.0, 1.5);
/// Velocity of the top, m/s.
const SPEEDS: Vector3<f64> = Vector3::new(0.3, -0.2, 0.5);
/// Mass of the top.
const MASS: f64 = 8030.0 * std::f64::consts::PI * 0.0025;
/// Moments of inertia about the axis and across.
const INERTIA: [f64; 2] = [MASS * 0.01 / 8.0, MASS * (1.0 / 12.0 + 0.01 / 16.0)];

fn model(diameter: f64, retardation: f64, rest: &str) -> String {
    format!(
        r#"
        materials.material = {{ density = 8030, young = 193e9, damping = {{ strain = {retardation} }} }}
        sections.section = {{ kind = "circle", diameter = {diameter} }}
        {rod}{tip}
        {rest}
        "#,
        rod = Rod { element: "linked", elements: 2, ..ROD },
        tip = end_probe("tip", "rod")
    )
}

/// Smooth spin-up to 50 rad/s within one second, constant for half a second.
const HUB: &str = r#"
    [output]
    interval = 0.01

    [[joints]]
    kind = "drive"
    name = "hub"
    a = { body = "rod", at = "start" }
    axis = [0, 0, 1]
    angle = 50
    time = { kind = "expression", text = "if(t < 1, t^2/2 + (cos(2*pi*t) - 1)/(2*pi)^2, t - 0.5)" }

    [analysis]
    kind = "dynamics"
    duration = 1.5
    step = 5e-4
    scheme = { spectral_radius = 0.8 }
    "#;

const FREE: &str = r#"
    [analysis]
    kind = "dynamics"
    duration = 5
    step = 5e-4
    "#;

/// Returns t, stretch and root force.
fn radial(solved: &SolvedModel) -> Result<Vec<[f64; 3]>, VerificationError> {
    let column = |name: &str| solved.column(name);
    let (t, x, y) = (column("t")?, column("tip.x")?, column("tip.y")?);
    let (fx, fy) = (column("hub.fx")?, column("hub.fy")?);
    let radial = (0..t.len()).map(|i| [t[i], x[i].hypot(y[i]) - 1.0, fx[i].hypot(fy[i])]);
    Ok(radial.collect())
}

fn on_a_hub(findings: &mut Findings) -> Result<(), VerificationError> {
    let radial = radial(&solve(&model(0.02, 1e-3, HUB))?)?;
    let steady: Vec<_> = radial.iter().filter(|[t, ..]| *t > 1.4).collect();
    let mean = |i: usize| steady.iter().map(|row| row[i]).sum::<f64>() / steady.len() as f64;
    findings.compare(format!("stretch at {SPEED} 1/s, m"), mean(1), STRETCH, STRETCH, 2e-4);
    findings.compare(format!("root force at {SPEED} 1/s, N"), mean(2), FORCE, FORCE, 2e-4);
    findings.plot(Plot::new(
        "Stretch of the rod",
        ["t, s", "m"],
        vec![
            PlotCurve::line("ancf", radial.iter().map(|row| [row[0], row[1]]).collect()),
            PlotCurve::points("steady", vec![[1.25, STRETCH], [1.5, STRETCH]]),
        ],
    ));
    Ok(())
}

fn tumbling(findings: &mut Findings) -> Result<(), VerificationError> {
    let assembly = assemble(&model(0.1, 0.0, FREE))?;
    let (inertia, mut start) = (Inertia::new(&assembly), assembly.rest());
    let centre = Vector3::new(0.5, 0.0, 0.0);
    let vectors: Vec<_> = assembly.bodies().flat_map(|(_, mesh)| mesh.vectors(&start)).collect();
    for vector in vectors {
        let velocity = if vector.is_position() {
            SPEEDS + SPIN.cross(&(vector.value - centre))
        } else {
            SPIN.cross(&vector.value)
        };
        start.v[vector.first..vector.first + 3].copy_from_slice(velocity.as_slice());
    }
    let mut moving = dynamics(&assembly, 0.8, start)?;
    let (first, energy) = (inertia.momenta(moving.state()), moving.energy().total());
    // About the moving centre of mass.
    let own = Vector3::new(INERTIA[0] * SPIN.x, 0.0, INERTIA[1] * SPIN.z);
    let mut changes = [0.0_f64; 3];
    let mut paths = [Vec::new(), Vec::new()];
    let mut show = |s: &State| {
        let now = inertia.momenta(s);
        changes[0] = changes[0].max((now.linear - first.linear).norm() / first.linear.norm());
        changes[1] = changes[1].max((now.angular - first.angular).norm() / first.angular.norm());
        changes[2] = changes[2].max((assembly.system.energy(s).total() / energy - 1.0).abs());
        let turn = UnitQuaternion::from_axis_angle(&Unit::new_normalize(own), own.norm() / INERTIA[1] * s.t);
        let rigid = centre + SPEEDS * s.t + turn * Vector3::x() * 0.5;
        let place = assembly.probes[0].1.value(s);
        paths[0].push([place, rigid]);
        paths[1].push([Vector3::repeat(s.t), place - rigid]);
    };
    advance(&assembly, &mut moving, 5.0, 10_000, &mut show)?;
    for (what, change) in ["momentum", "angular momentum", "energy"].iter().zip(changes) {
        findings.compare(format!("tumbling, largest change of {what}, relative"), change, 0.0, 1.0, 1e-6);
    }
    let reference = own + first.first.cross(&first.linear) / MASS;
    let off = (first.angular - reference).norm();
    findings.compare("tumbling, angular momentum at the start is off by", off, 0.0, reference.norm(), 1e-9);
    let largest = paths[1].iter().map(|[_, off]| off.norm()).fold(0.0, f64::max);
    findings.compare(
        "tumbling, largest distance of the tip from the rigid top's, m",
        largest,
        0.0,
        1.0,
        1e-5,
    );
    let thin =
        |which: usize, step: usize| paths[0].iter().step_by(step).map(|p| [p[which].y, p[which].z]).collect();
    findings.plot(
        Plot::new(
            "Tumbling: path of an end, seen along x",
            ["y, m", "z, m"],
            vec![PlotCurve::line("ancf", thin(0, 20)), PlotCurve::points("rigid top", thin(1, 500))],
        )
        .with_equal_scales(),
    );
    Ok(())
}

fn run() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    on_a_hub(&mut findings)?;
    tumbling(&mut findings)?;
    Ok(findings)
}

#[cfg(test)]
mod tests {
    #[test]
    fn holds() {
        crate::assert_holds(&super::PROBLEM);
    }
}
