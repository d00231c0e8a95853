//! Time per step of a stepper, compared with the steps of a run: median and 99.9th percentile.

#![expect(clippy::print_stdout, reason = "the program prints its measurements")]

use std::error::Error;
use std::io;
use std::ops::ControlFlow;
use std::time::Instant;

use ancf::solver::equations::State;
use ancf::{Model, Observer, Simulation, Stepper};

const STEPS: usize = 20_000;

/// Times at which a run records its rows.
struct Clock(Vec<Instant>);

impl Observer for Clock {
    fn begin(&mut self, _: &[String]) -> io::Result<()> {
        Ok(())
    }

    fn record(&mut self, _: &[f64], _: &State) -> io::Result<ControlFlow<()>> {
        self.0.push(Instant::now());
        Ok(ControlFlow::Continue(()))
    }

    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn model(bodies: &str, end: &str) -> Result<Model, Box<dyn Error>> {
    let text = format!(
        "gravity = [0, -9.81, 0]\ninputs = [{{ name = \"push\" }}]\n{bodies}\n\
         [[joints]]\nkind = \"revolute\"\nname = \"pin\"\na = {{ body = \"b\", at = {end} }}\naxis = [0, 0, 1]\n\
         [[probes]]\nname = \"p\"\non = {{ body = \"b\", at = \"center\" }}\n\
         [[loads]]\nkind = \"force\"\non = {{ body = \"b\", at = \"center\" }}\nforce = [1, 0, 0]\n\
         time = {{ kind = \"input\", name = \"push\" }}\n\
         [analysis]\nkind = \"dynamics\"\nduration = {}\nstep = 1e-4\nscheme = {{ spectral_radius = 0.9 }}\n",
        STEPS as f64 * 1e-4
    );
    Ok(Model::parse(&text)?)
}

fn report(what: &str, times: impl IntoIterator<Item = std::time::Duration>) {
    let mut micros: Vec<f64> = times.into_iter().map(|time| 1e6 * time.as_secs_f64()).collect();
    micros.sort_by(f64::total_cmp);
    let at = |part: f64| micros[((micros.len() - 1) as f64 * part) as usize];
    println!("  {what:<28} p50 {:8.2} us, p99.9 {:8.2} us", at(0.5), at(0.999));
}

fn main() -> Result<(), Box<dyn Error>> {
    let rigid = "bodies = [{ kind = \"rigid\", name = \"b\", center = [0.5, 0, 0], mass = 1, inertia = [0.1, 0.1, 0.1] }]";
    let beam = "materials.m = { density = 2700, young = 7e10 }\nsections.s = { kind = \"circle\", diameter = 0.02 }\n\
                bodies = [{ kind = \"beam\", name = \"b\", from = [0, 0, 0], to = [1, 0, 0], elements = 10, \
                section = \"s\", material = \"m\", formulation = \"linked\" }]";
    for (name, model) in
        [("rigid pendulum", model(rigid, "[0, 0, 0]")?), ("beam of 10 elements", model(beam, "\"start\"")?)]
    {
        println!("{name}");
        let mut clock = Clock(Vec::with_capacity(STEPS + 1));
        let _ = Simulation::new(&model)?.run(&mut clock)?;
        report("run", clock.0.windows(2).map(|pair| pair[1] - pair[0]));
        let mut stepper = Stepper::new(&model)?;
        let mut timed = |act: &mut dyn FnMut(&mut Stepper, usize)| {
            let times = (0..STEPS).map(|i| {
                let start = Instant::now();
                act(&mut stepper, i);
                start.elapsed()
            });
            times.collect::<Vec<_>>()
        };
        let failed = "the step of a small model succeeds";
        report(
            "step, read",
            timed(&mut |one, _| {
                one.step(1e-4).expect(failed);
                one.read("p.x").expect(failed);
            }),
        );
        report(
            "set, step, read",
            timed(&mut |one, i| {
                one.set("push", (i as f64 * 1e-3).sin()).expect(failed);
                one.step(1e-4).expect(failed);
                one.read("p.x").expect(failed);
            }),
        );
    }
    Ok(())
}
