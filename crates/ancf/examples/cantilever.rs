//! First program of `docs/extending.md`: the cantilever of Kim et al. (2017), from the root of the repository.
#![expect(clippy::print_stdout, reason = "an example says what it found")]

use ancf::record::Series;
use ancf::{Model, simulate};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let model = Model::read("models/cantilever.toml")?;
    let mut series = Series::new();
    let summary = simulate(&model, &mut series)?;
    println!("{:?}, {} iterations", summary.outcome, summary.iterations);
    println!("tip at the end: {:?}", series.column("tip.y").and_then(<[f64]>::last));
    Ok(())
}
