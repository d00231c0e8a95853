//! A kind of load that a program adds: the attraction to a fixed centre.

use ancf::loads::{LoadBuilder, LoadKind};
use ancf::mechanics::functions::ForceFunction;
use ancf::model::{At, NamedPosition, Place};
use ancf::record::Series;
use ancf::units::Scaled;
use ancf::{Extension, Model, Simulation};

/// Attraction to the origin by the force k/r².
#[derive(Clone, Debug, Scaled)]
struct Attraction {
    on: Place,
    #[unit(force * length^2)]
    strength: f64,
}

impl LoadKind for Attraction {
    fn noun(&self) -> &'static str {
        "attraction"
    }

    fn on(&self) -> Option<&Place> {
        Some(&self.on)
    }

    fn build(&self, builder: &mut LoadBuilder<'_>) {
        let strength = self.strength;
        let attraction = ForceFunction::new(move |_, x: [f64; 3], _| {
            let r = x.iter().map(|x| x * x).sum::<f64>().sqrt();
            x.map(|x| -strength * x / r.powi(3))
        });
        builder.external_force(&self.on, attraction);
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let model = Model::parse(
        r#"
        bodies = [{ kind = "mass", name = "moon", center = [1, 0, 0], mass = 1, motion = { velocity = [0, 1, 0] } }]
        probes = [{ name = "moon", on = { body = "moon", at = "center" } }]
        analysis = { kind = "dynamics", duration = 6.283185307179586, step = 1e-3, scheme = "average_acceleration" }
        "#,
    )?;
    let on = Place::new("moon", At::Named(NamedPosition::Center));
    let mut series = Series::new();
    let simulation =
        Simulation::builder(&model).with(Extension::load(Attraction { on, strength: 1.0 })).build()?;
    assert!(simulation.run(&mut series)?.outcome.is_finished());
    let y = series.column("moon.y").and_then(<[f64]>::last).ok_or("no such column")?;
    assert!(y.abs() < 1e-5); // A circular orbit closes after 2π √(m r³/k).
    Ok(())
}
