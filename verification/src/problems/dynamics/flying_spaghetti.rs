use ancf::solver::equations::{EquationsOfMotion, State};
use nalgebra::Vector3;

use super::motion::{Inertia, advance, assemble, dynamics};
use crate::problems::models::{Rod, end_probe};
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError};

/// Flexible rod in free flight after an impulse.
pub const PROBLEM: Problem = Problem {
    name: "flying_spaghetti",
    title: "Flying spaghetti: free flight of a rod after an impulse, in a plane",
    source: "Simo & Vu-Quoc (1986) with E I = 500; ends by a spectral rod of Reissner's theory, order 32, which differs from \
             order 24 by 1.5e-3; momentum and centre of mass exact",
    sketch: r"
   (0, 8) \                         L = 10, force (8, 0) and moment −80
           \                        at the end (6, 0) until t = 2.5
            \
             \ (6, 0) --> F
              M",
    goal: "Ends within 2e-3 of the length of the rod at t = 2.5 and 5, by 16 quadratic elements. Sections of the element \
           deform, those of Reissner's rod do not: with ρI = 10 and ρA = 1 they expand by ρI ω²/EA = 1e-3 ω², which \
           reduces the \
           rotation. Momentum and centre of mass to 1e-9; in free flight angular momentum to 1e-5 and energy to 1e-3, \
           because \
           generalized-α with a spectral radius of 0.8 damps the shock waves",
    run,
};

/// t, loaded end, other end.
const ENDS: [[f64; 5]; 4] = [
    [2.5, 4.43022542, -0.78507807, 5.94529673, 8.97071389],
    [5.0, 5.62004822, 4.76413499, 15.40859921, 4.26469162],
    [7.5, 15.54224214, 8.99496670, 15.75515792, -0.97209286],
    [10.0, 25.40875246, 4.78983913, 15.62458968, 4.15119950],
];
/// Time between the rows of the reference.
const INTERVAL: f64 = 2.5;
/// Steps per interval.
const STEPS: u32 = 500;

/// Text of the model. E A = G A = 1e4, E I = 500, ρ A = 1, ρ I = 10.
fn model() -> String {
    let rod = Rod {
        name: "spaghetti",
        element: "quadratic",
        from: [6.0, 0.0, 0.0],
        to: [0.0, 8.0, 0.0],
        elements: 16,
        keys: "",
    };
    format!(
        r#"
        materials.material = {{ density = 1, young = 1e4 }}

        [sections.section]
        kind = "general"
        area = 1
        iy = 0.05
        iz = 0.05
        ky = 2
        kz = 2
        mass_iy = 10
        mass_iz = 10
        {rod}
        [[loads]]
        kind = "force"
        on = {{ body = "spaghetti", at = "start" }}
        force = [8, 0, 0]
        time = {{ kind = "table", times = [2.5, 2.5], values = [1, 0] }}

        [[loads]]
        kind = "moment"
        on = {{ body = "spaghetti", at = "start" }}
        moment = [0, 0, -80]
        time = {{ kind = "table", times = [2.5, 2.5], values = [1, 0] }}

        [[probes]]
        name = "loaded"
        on = {{ body = "spaghetti", at = "start" }}
        {other}
        [analysis]
        kind = "dynamics"
        duration = 10
        step = 5e-3
        "#,
        other = end_probe("other", "spaghetti")
    )
}

/// Paths of the ends, and changes of the invariants.
#[derive(Default)]
struct Flight {
    ends: [Vec<[f64; 2]>; 2],
    /// Largest changes of angular momentum and energy after the impulse, relative to their values at its end.
    changes: [f64; 2],
}

fn fly(findings: &mut Findings) -> Result<Flight, VerificationError> {
    let assembly = assemble(&model())?;
    let inertia = Inertia::new(&assembly);
    let mut moving = dynamics(&assembly, 0.8, assembly.rest())?;
    let mut flight = Flight::default();
    let mut reference: Option<[f64; 2]> = None;
    for [t, x, y, other_x, other_y] in ENDS {
        let Flight { ends, changes } = &mut flight;
        let mut show = |s: &State| {
            for (end, (_, probe)) in ends.iter_mut().zip(&assembly.probes) {
                let position = probe.value(s);
                end.push([position.x, position.y]);
            }
            if let Some(reference) = reference {
                let now = [inertia.momenta(s).angular.z, assembly.system.energy(s).total()];
                for i in 0..2 {
                    changes[i] = changes[i].max((now[i] / reference[i] - 1.0).abs());
                }
            }
        };
        advance(&assembly, &mut moving, t, STEPS, &mut show)?;
        let s = moving.state();
        if t < 2.0 * INTERVAL + 0.1 {
            for (i, expected) in [[x, y], [other_x, other_y]].into_iter().enumerate() {
                let (name, position) = (&assembly.probes[i].0, assembly.probes[i].1.value(s));
                findings.compare(format!("{name} end x, t = {t}"), position.x, expected[0], 10.0, 2e-3);
                findings.compare(format!("{name} end y, t = {t}"), position.y, expected[1], 10.0, 2e-3);
            }
        }
        let momenta = inertia.momenta(s);
        // The mass is 10.
        let centre = momenta.first / 10.0 - Vector3::new(5.5 + 2.0 * (t - 2.5), 4.0, 0.0);
        findings.compare(format!("centre of mass is off by, t = {t}"), centre.norm(), 0.0, 10.0, 1e-9);
        findings.compare(format!("momentum along x, t = {t}"), momenta.linear.x, 20.0, 20.0, 1e-9);
        reference.get_or_insert([momenta.angular.z, assembly.system.energy(s).total()]);
    }
    Ok(flight)
}

fn run() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    let Flight { ends: [loaded, other], changes: [angular, energy] } = fly(&mut findings)?;
    findings.compare("largest change of angular momentum after the kick, relative", angular, 0.0, 1.0, 1e-5);
    findings.compare("largest change of energy after the kick, relative", energy, 0.0, 1.0, 1e-3);
    findings.plot(
        Plot::new(
            "Paths of the ends until t = 10",
            ["x", "y"],
            vec![
                PlotCurve::line("loaded end", loaded),
                PlotCurve::points("loaded end, spectral rod", ENDS.map(|[_, x, y, ..]| [x, y]).to_vec()),
                PlotCurve::line("other end", other),
                PlotCurve::points("other end, spectral rod", ENDS.map(|[.., x, y]| [x, y]).to_vec()),
            ],
        )
        .with_equal_scales(),
    );
    Ok(findings)
}

#[cfg(test)]
mod tests {
    #[test]
    fn holds() {
        crate::assert_holds(&super::PROBLEM);
    }
}
