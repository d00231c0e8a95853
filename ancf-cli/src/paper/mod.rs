//! Every table and figure of Kim et al. (2017).

pub mod cases;
pub mod conditioning;
pub mod machine;
pub mod published;
pub mod rigid;
pub mod study;

use std::path::Path;

/// stub
pub fn reproduce(_out: &Path, repeats: usize) -> anyhow::Result<()> {
    let study = study::Study::run(repeats, |what| crate::progress::say(what))?;
    for (c, name) in [(&study.cantilever, "cant"), (&study.spherical, "sph")] {
        for c in c.iter().chain([&study.revolute]) {
            for (k, r) in [("dim", &c.dim), ("nd", &c.nondim), ("same", &c.same_step)] {
                eprintln!("{name} {} {k} step {} s {} steps {} it {} most {} floor {} mean {}", c.n, r.step, r.seconds, r.summary.steps, r.iterations_per_step(), r.summary.most_iterations, r.summary.floor_steps, r.mean_deflection());
            }
        }
    }
    for t in &study.tolerances { for c in [&t.dim, &t.nondim] { eprintln!("{} {} {:?} {} {:?}", t.tolerance, c.most(), c.stalled_at, c.iterations.len(), &c.iterations[..20.min(c.iterations.len())]); } }
    for r in study.stiff.iter().chain(&study.soft) { eprintln!("{r:?}"); }
    eprintln!("{:?}", study.mean_with_standard_gravity);
    eprintln!("{:?}", study.machine);
    eprintln!("{:?}", study.revolute.dim.series.names().collect::<Vec<_>>());
    Ok(())
}
