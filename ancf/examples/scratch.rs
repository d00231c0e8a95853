use ancf::record::Series;
use ancf::{Model, simulate};
use std::time::Instant;
fn main() {
    let g: f64 = std::env::args().nth(1).map_or(9.81, |s| s.parse().unwrap());
    for n in [1, 2, 5, 10, 15, 20] {
        for nd in [false, true] {
            let t: f64 = (n as f64 / g).sqrt();
            let step = if nd { 0.001 * t } else { 0.001 };
            let text = format!(
                r#"
gravity = [0, -{g:?}, 0]
materials.steel = {{ density = 8030.0, young = 193e9, poisson=0.0 }}
sections.rod = {{ kind = "circle", diameter = 0.02 }}
scales = {{ kind = "{}" }}
[[bodies]]
kind = "beam"
name = "beam"
from = [0.0, 0.0, 0.0]
to = [1.0, 0.0, 0.0]
elements = {n}
section = "rod"
material = "steel"
slopes = "{}"
[[joints]]
kind = "clamp"
name = "root"
a = {{ body = "beam", at = "start" }}
[[probes]]
name = "tip"
on = {{ body = "beam", at = "end" }}
[analysis]
kind = "dynamics"
duration = 2.0
step = {step:?}
start = "zero"
"#,
                if nd { "paper" } else { "none" },
                if nd { "length" } else { "gradient" }
            );
            let model = Model::parse(&text).unwrap();
            let mut series = Series::new();
            let clock = Instant::now();
            let s = simulate(&model, &mut series).unwrap();
            let tip = series.column("tip.y").unwrap();
            println!(
                "{n:3} {nd} {:.4} steps {} it {} max {} floor {} {:?} {:.3}s",
                1e3 * tip.iter().sum::<f64>() / tip.len() as f64,
                tip.len(),
                s.iterations,
                s.most_iterations,
                s.floor_steps,
                s.outcome,
                clock.elapsed().as_secs_f64()
            );
        }
    }
}
