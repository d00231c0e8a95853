//! CPU time per element of the parts of a step, measured with criterion to compare versions.
//!
//! `cargo bench -p ancf-bench -- --save-baseline before`, then `-- --baseline before`.

use std::hint::black_box;
use std::time::Duration;

use ancf_bench::Result;
use ancf_bench::measure::{clock, sample};
use ancf_bench::subjects::{
    CantileverKind, ElementEvaluation, Evaluation, LinearSolution, Subject, SystemEvaluation, TimeSteps,
    cantilever,
};
use ancf_bench::table::{SMALL, STEPS, process};
use criterion::measurement::{Measurement, ValueFormatter, WallTime};
use criterion::{Criterion, criterion_group, criterion_main};

/// CPU time in seconds.
struct CpuTime;

impl Measurement for CpuTime {
    type Intermediate = f64;
    type Value = f64;

    fn start(&self) -> f64 {
        clock::own() + clock::of_children()
    }

    fn end(&self, start: f64) -> f64 {
        clock::own() + clock::of_children() - start
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

/// Constructor of a subject.
type Make = fn() -> Result<Box<dyn Subject>>;

fn boxed<S: Subject + 'static>(subject: Result<S>) -> Result<Box<dyn Subject>> {
    Ok(Box::new(subject?))
}

/// Run of the program with 20 elements and 2000 steps.
struct ProgramRun(CantileverKind);

impl Subject for ProgramRun {
    fn count(&self) -> f64 {
        1.0
    }

    fn run(&mut self) -> Result<()> {
        black_box(process::program_cost(&cantilever(self.0, 20, 2000), 1)?);
        Ok(())
    }
}

const ROWS: [(&str, Make); 10] = [
    ("elastic force", || boxed(ElementEvaluation::new(CantileverKind::Beam, SMALL, Evaluation::Residual))),
    ("force and tangent", || boxed(ElementEvaluation::new(CantileverKind::Beam, SMALL, Evaluation::Both))),
    ("residual of the system", || {
        boxed(SystemEvaluation::new(CantileverKind::Beam, SMALL, Evaluation::Residual))
    }),
    ("tangent of the system, scattered", || {
        boxed(SystemEvaluation::new(CantileverKind::Beam, SMALL, Evaluation::Tangent))
    }),
    ("factorise and solve, n = 1e3", || boxed(LinearSolution::new(CantileverKind::Beam, 1000, 10))),
    ("step, n = 100", || boxed(TimeSteps::new(CantileverKind::Beam, SMALL, STEPS))),
    ("step of a cable, n = 100", || boxed(TimeSteps::new(CantileverKind::Cable, SMALL, STEPS))),
    ("step, n = 1e4", || boxed(TimeSteps::new(CantileverKind::Beam, 10_000, 2))),
    ("process, beam of 20, 2000 steps", || boxed(Ok(ProgramRun(CantileverKind::Beam)))),
    ("process, cable of 20, 2000 steps", || boxed(Ok(ProgramRun(CantileverKind::Cable)))),
];

fn rows(criterion: &mut Criterion<CpuTime>) {
    for (name, make) in ROWS {
        let mut group = criterion.benchmark_group("per element");
        let mut made = None;
        group.bench_function(name, |bencher| {
            let subject = made.get_or_insert_with(|| make().expect("a cantilever can be assembled"));
            bencher.iter_custom(|times| {
                let each = (0..times).map(|_| sample(subject.as_mut()).expect("a cantilever can be stepped"));
                each.sum::<f64>()
            });
        });
        group.finish();
    }
}

fn configuration() -> Criterion<CpuTime> {
    Criterion::default()
        .with_measurement(CpuTime)
        .sample_size(20)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1))
}

criterion_group!(name = benches; config = configuration(); targets = rows);
criterion_main!(benches);
