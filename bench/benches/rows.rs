//! The parts of a step by criterion, in time of the processor per element: to compare before and after a change.
//!
//! `cargo bench -p ancf-bench -- --save-baseline before`, then `-- --baseline before`.

use std::hint::black_box;
use std::time::Duration;

use ancf_bench::model::Kind;
use ancf_bench::subject::{OfElements, OfEquations, OfSteps, OfSystem, Part, Subject};
use ancf_bench::table::{FEW, STEPS};
use ancf_bench::{clock, measure, process};
use criterion::measurement::{Measurement, ValueFormatter, WallTime};
use criterion::{Criterion, criterion_group, criterion_main};

/// Seconds of the processor.
struct Processor;

impl Measurement for Processor {
    type Intermediate = f64;
    type Value = f64;

    fn start(&self) -> f64 {
        clock::own() + clock::of_children()
    }

    fn end(&self, begun: f64) -> f64 {
        clock::own() + clock::of_children() - begun
    }

    fn add(&self, a: &f64, b: &f64) -> f64 {
        a + b
    }

    fn zero(&self) -> f64 {
        0.0
    }

    fn to_f64(&self, seconds: &f64) -> f64 {
        1e9 * seconds
    }

    fn formatter(&self) -> &dyn ValueFormatter {
        WallTime.formatter()
    }
}

/// A subject, made when its turn comes.
type Make = fn() -> measure::Result<Box<dyn Subject>>;

fn boxed<S: Subject + 'static>(subject: measure::Result<S>) -> measure::Result<Box<dyn Subject>> {
    Ok(Box::new(subject?))
}

/// The program with a model of 20 elements and 2000 steps.
struct Whole(Kind);

impl Subject for Whole {
    fn count(&self) -> f64 {
        1.0
    }

    fn run(&mut self) -> measure::Result<()> {
        black_box(process::whole(self.0, 20, 2000, 1)?);
        Ok(())
    }
}

const ROWS: [(&str, Make); 10] = [
    ("elastic force", || boxed(OfElements::new(Kind::Beam, FEW, Part::Force))),
    ("force and tangent", || boxed(OfElements::new(Kind::Beam, FEW, Part::Both))),
    ("residual of the system", || boxed(OfSystem::new(Kind::Beam, FEW, Part::Force))),
    ("tangent of the system, scattered", || boxed(OfSystem::new(Kind::Beam, FEW, Part::Stiffness))),
    ("factorise and solve, n = 1e3", || boxed(OfEquations::new(Kind::Beam, 1000, 10))),
    ("step, n = 100", || boxed(OfSteps::new(Kind::Beam, FEW, STEPS))),
    ("step of a cable, n = 100", || boxed(OfSteps::new(Kind::Cable, FEW, STEPS))),
    ("step, n = 1e4", || boxed(OfSteps::new(Kind::Beam, 10_000, 2))),
    ("process, beam of 20, 2000 steps", || boxed(Ok(Whole(Kind::Beam)))),
    ("process, cable of 20, 2000 steps", || boxed(Ok(Whole(Kind::Cable)))),
];

fn rows(criterion: &mut Criterion<Processor>) {
    for (name, make) in ROWS {
        let mut group = criterion.benchmark_group("per element");
        let mut made = None;
        group.bench_function(name, |bencher| {
            let subject = made.get_or_insert_with(|| make().expect("a cantilever can be made"));
            bencher.iter_custom(|times| {
                let each = (0..times).map(|_| measure::sample(subject.as_mut()).expect("a cantilever moves"));
                each.sum::<f64>()
            });
        });
        group.finish();
    }
}

fn processor() -> Criterion<Processor> {
    Criterion::default()
        .with_measurement(Processor)
        .sample_size(20)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1))
}

criterion_group!(name = benches; config = processor(); targets = rows);
criterion_main!(benches);
