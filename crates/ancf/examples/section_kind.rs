//! A kind of section that a program adds: a regular hexagon.

use ancf::mechanics::sections::Moments;
use ancf::model::{SectionOutline, SectionShape};
use ancf::record::Series;
use ancf::units::Scaled;
use ancf::{Extension, Model, Simulation};

/// Regular hexagon with a corner on the section's y-axis.
#[derive(Clone, Debug, Scaled)]
struct Hexagon {
    #[unit(length)]
    side: f64,
}

impl SectionShape for Hexagon {
    fn moments(&self) -> Moments {
        let [area, second, fourth] = [(1.5, 2), (0.3125, 4), (0.04375, 6)]
            .map(|(factor, degree)| factor * 3.0_f64.sqrt() * self.side.powi(degree));
        Moments { area, yy: second, zz: second, yyyy: 3.0 * fourth, yyzz: fourth, zzzz: 3.0 * fourth }
    }

    fn torsion_constant(&self) -> f64 {
        1.0355 * self.side.powi(4) // Pólya & Szegő (1951): J = 0.1534 A².
    }

    fn shear_factors(&self, poisson: f64) -> [f64; 2] {
        [6.0 * (1.0 + poisson) / (7.0 + 6.0 * poisson); 2] // An estimate: the factor of a circle.
    }

    fn outline(&self) -> SectionOutline {
        let corner = |k: u32| (std::f64::consts::FRAC_PI_3 * f64::from(k)).sin_cos();
        SectionOutline::polygon((0..6).map(corner).map(|(y, x)| [self.side * x, self.side * y]).collect())
    }

    fn towards(&self, end: &Self, fraction: f64) -> Self {
        Self { side: self.side + (end.side - self.side) * fraction }
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let model = Model::parse(
        r#"
        materials.steel = { density = 7800, young = 2e11 }
        sections.bar = { kind = "circle", diameter = 0.02 }
        bodies = [{ kind = "beam", name = "bar", from = [0, 0, 0], to = [1, 0, 0], elements = 4, section = "bar", material = "steel", formulation = "quadratic" }]
        joints = [{ kind = "clamp", name = "wall", a = { body = "bar", at = "start" } }]
        loads = [{ kind = "force", on = { body = "bar", at = "end" }, force = [0, 1, 0] }]
        probes = [{ name = "tip", on = { body = "bar", at = "end" } }]
        analysis = { kind = "statics" }
        "#,
    )?;
    let mut series = Series::new();
    let simulation =
        Simulation::builder(&model).with(Extension::section("bar", Hexagon { side: 0.01 })).build()?;
    assert!(simulation.run(&mut series)?.outcome.is_finished());
    let tip = series.column("tip.y").and_then(<[f64]>::last).ok_or("no such column")?;
    let bending = 2e11 * 0.3125 * 3.0_f64.sqrt() * 0.01_f64.powi(4);
    assert!((tip * 3.0 * bending - 1.0).abs() < 1e-3); // F L³/(3 E I), and 3e-4 of shear
    Ok(())
}
