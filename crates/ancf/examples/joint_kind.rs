//! A kind of joint that a program adds: a bearing with dry friction.

use ancf::joints::{End, JointActions, JointBuilder, JointFriction, JointKind};
use ancf::model::Place;
use ancf::record::Series;
use ancf::units::Scaled;
use ancf::{Extension, Model, Simulation};

/// Bearing about the z axis with a friction torque, reduced below a rate of rotation.
#[derive(Clone, Debug, Scaled)]
struct Bearing {
    name: String,
    a: Place,
    b: End,
    #[unit(force * length)]
    torque: f64,
    #[unit(radian / time)]
    rate: f64,
}

impl JointKind for Bearing {
    fn word(&self) -> &'static str {
        "bearing"
    }

    fn name(&self) -> &str {
        &self.name
    }

    fn ends(&self) -> (&Place, &End) {
        (&self.a, &self.b)
    }

    fn removes(&self) -> usize {
        5
    }

    fn build(&self, builder: &mut JointBuilder<'_>) {
        let friction = Some(JointFriction::constant(self.torque, self.rate));
        let friction = JointActions { friction, ..JointActions::default() };
        builder.coincide();
        builder.parallel([0.0, 0.0, 1.0], "bearing axis");
        builder.angle([0.0, 0.0, 1.0], &friction);
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let model = Model::parse(
        r#"
        bodies = [{ kind = "rigid", name = "rotor", center = [0, 0, 0], mass = 2, inertia = [0.1, 0.1, 0.2], motion = { spin = [0, 0, 10] } }]
        analysis = { kind = "dynamics", duration = 1, step = 1e-4, scheme = "average_acceleration" }
        "#,
    )?;
    let a = Place::new("rotor", ancf::model::At::Named(ancf::model::NamedPosition::Center));
    let bearing = Bearing { name: "bearing".into(), a, b: End::Ground, torque: 0.5, rate: 1e-3 };
    let mut series = Series::new();
    let simulation = Simulation::builder(&model).with(Extension::joint(bearing)).build()?;
    assert!(simulation.run(&mut series)?.outcome.is_finished());
    let rate = series.column("bearing.rate").and_then(<[f64]>::last).ok_or("no such column")?;
    assert!((rate - (10.0 - 0.5 / 0.2)).abs() < 1e-3); // ω₀ − M t/I
    Ok(())
}
