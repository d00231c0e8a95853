//! Balances of energy, momentum and forces; finite numbers.

use ancf::Model;
use ancf::model::{ContactSurface, End, Joint, Load};
use ancf::nalgebra::Vector3;

use super::law::{Check, Law};
use crate::compare::{Case, Finding, last_of};
use crate::random::Random;
use crate::run::{Run, Verdict};

/// Finite numbers in all columns that are defined, and no panic.
pub(super) struct Finite;

impl Law for Finite {
    fn name(&self) -> &'static str {
        "finite"
    }

    fn check(&self, case: &Case, _: &mut Random) -> Check {
        if let Verdict::Panicked(message) = &case.base.verdict {
            return Check::Violated(Finding::of_kind(self.name(), "panic", message.clone()));
        }
        let undefined = [
            "unstable",
            "frequency",
            "slope",
            "residual",
            "increment",
            "drift",
            "frequency_error",
            "factor_error",
        ];
        let columns = case.base.columns.iter().filter(|column| !undefined.contains(&column.name.as_str()));
        let found = columns.into_iter().find_map(|column| {
            let row = column.values.iter().position(|x| !x.is_finite())?;
            Some(Finding::of_kind(self.name(), &column.name, format!("row {row}: {}", column.values[row])))
        });
        Check::of(found)
    }
}

/// Energy balance of dynamics: no energy is created without a warning.
pub(super) struct Energy;

/// Created energy, relative to the exchanged energy, above which a run is wrong.
const CREATED: f64 = 0.05;

impl Law for Energy {
    fn name(&self) -> &'static str {
        "energy"
    }

    fn check(&self, case: &Case, _: &mut Random) -> Check {
        let Some(balance) = case.base.column("balance").filter(|_| case.base.verdict.is_finished()) else {
            return Check::Inapplicable;
        };
        let size = stored(&case.base) + changes(&case.base, "work") + changes(&case.base, "dissipated");
        let created = balance.values.iter().fold(0.0_f64, |m, x| m.max(-x));
        let is_reported = case.base.warnings.iter().any(|warning| {
            ["the integration has made", "the energy may grow"].iter().any(|text| warning.contains(text))
        });
        if created <= CREATED * size || size < 1e-12 || is_reported {
            return Check::Holds;
        }
        let values = format!("{created:.3e} created, exchanged energy {size:.3e}");
        Check::Violated(Finding {
            law: self.name(),
            quantity: "balance".into(),
            values,
            excess: created / size,
        })
    }
}

/// Largest sum of the kinetic energy and the magnitude of the strain energy.
fn stored(run: &Run) -> f64 {
    let [kinetic, strain] =
        ["kinetic", "strain"].map(|name| run.column(name).map_or(&[][..], |column| &column.values));
    kinetic.iter().zip(strain).map(|(kinetic, strain)| kinetic + strain.abs()).fold(0.0, f64::max)
}

/// Sum of the magnitudes of the changes from row to row.
fn changes(run: &Run, name: &str) -> f64 {
    let values = run.column(name).map_or(&[][..], |column| &column.values);
    values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum()
}

/// Balance of forces in statics: reactions of the ground, dead loads and weights have the sum zero.
pub(super) struct Reactions;

impl Law for Reactions {
    fn name(&self) -> &'static str {
        "reactions"
    }

    fn check(&self, case: &Case, _: &mut Random) -> Check {
        let is_statics = case.base.column("load").is_some();
        if !is_statics || !case.base.verdict.is_finished() {
            return Check::Inapplicable;
        }
        let Some(applied) = dead_loads(&case.model) else { return Check::Inapplicable };
        let load = last_of(&case.base, "load");
        let joints = case.model.joints.iter().filter(|joint| is_of_ground(joint));
        let reaction: Vector3<f64> = joints.map(|joint| force(&case.base, joint.name())).sum();
        let size = case.magnitudes.of(ancf::units::Dimension::FORCE).max(load.abs() * applied.norm());
        let gap = (reaction + load * applied).norm();
        let tolerance = case.tolerance(1e-6) * size;
        if gap <= tolerance {
            return Check::Holds;
        }
        let values = format!("sum {gap:.3e}, largest force {size:.3e}");
        Check::Violated(Finding {
            law: self.name(),
            quantity: "force".into(),
            values,
            excess: gap / tolerance,
        })
    }
}

fn force(run: &Run, joint: &str) -> Vector3<f64> {
    let component = |axis: &str| last_of(run, &format!("{joint}.{axis}"));
    Vector3::new(component("fx"), component("fy"), component("fz"))
}

fn is_of_ground(joint: &Joint) -> bool {
    !matches!(joint.ends().1, End::Place(_))
}

/// Sum of weights and dead forces; `None` with loads whose sum depends on the motion.
fn dead_loads(model: &Model) -> Option<Vector3<f64>> {
    if !model.contacts.is_empty() {
        return None;
    }
    let mut sum = Vector3::from(model.gravity) * model.mass();
    for load in &model.loads {
        match load {
            Load::Force(force) if !force.follower => sum += Vector3::from(force.force),
            Load::Moment(_) | Load::DistributedMoment(_) | Load::Prestrain(_) | Load::SurfacePrestrain(_) => {
            }
            Load::DistributedForce(line) if !line.follower => {
                let body = model.bodies.iter().find(|body| body.name() == line.body)?;
                let length = body.arc_length(&line.to) - body.arc_length(&line.from);
                let [start, end] = [line.force, line.force_end.unwrap_or(line.force)].map(Vector3::from);
                sum += 0.5 * length * (start + end);
            }
            _ => return None,
        }
    }
    Some(sum)
}

/// Linear momentum of systems without joints to the ground under weight only: the centre of mass of a single body falls freely.
///
/// For a rigid body or a point mass the centre is a probe. Flexible bodies are covered by the potential energy, which is
/// −m g·x of the centre of mass.
pub(super) struct Momentum;

impl Law for Momentum {
    fn name(&self) -> &'static str {
        "momentum"
    }

    fn check(&self, case: &Case, _: &mut Random) -> Check {
        let model = &case.model;
        let g = Vector3::from(model.gravity);
        let is_free = model.joints.iter().all(|joint| !is_of_ground(joint))
            && model.loads.is_empty()
            && !model.contacts.iter().any(|contact| !matches!(contact.with, ContactSurface::Bodies));
        let is_damped = model.materials.values().any(|material| material.damping.mass > 0.0);
        let dynamics = model.analysis.dynamics();
        if dynamics.is_none() || !is_free || is_damped || g.norm() == 0.0 || !case.base.verdict.is_finished()
        {
            return Check::Inapplicable;
        }
        let (Some(times), Some(potential)) = (case.base.column("t"), case.base.column("potential")) else {
            return Check::Inapplicable;
        };
        // The potential energy of free fall is −m g·(v₀ t + g t²/2). Second differences of the scheme depend on the step only.
        let (m, rows) = (model.mass(), case.base.rows());
        if rows < 5 || case.base.is_divided || case.has_controlled_steps() {
            return Check::Inapplicable;
        }
        let dt = times.values[2] - times.values[1];
        let expected = -m * g.norm_squared() * dt * dt;
        let seconds = potential.values[2..rows - 1].windows(3).map(|v| v[2] - 2.0 * v[1] + v[0]);
        let worst = seconds.map(|second| (second - expected).abs()).fold(0.0_f64, f64::max);
        let size = case.base.largest("potential").max(expected.abs());
        if worst <= case.tolerance(1e-9) * size + 1e-7 * expected.abs() {
            return Check::Holds;
        }
        let values =
            format!("second difference of the potential energy off by {worst:.2e}, expected {expected:.2e}");
        Check::Violated(Finding {
            law: self.name(),
            quantity: "potential".into(),
            values,
            excess: worst / expected.abs(),
        })
    }
}
