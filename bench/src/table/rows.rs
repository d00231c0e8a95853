use std::collections::BTreeMap;

use super::process::{self, StepCost};
use super::row::RowUnit::{Factor, Gain, Kilobytes, Microseconds, Milliseconds, Seconds};
use super::row::{LimitingResource, LowerBound, MeasuredValue, RowSpec, TableRow};
use super::{contact_rows, large_model_rows, lower_bounds, motion_rows, shell_rows};
use crate::Result;
use crate::measure::{Machine, SampleSize, median, sample, samples};
use crate::models::{lattice, net, platform};
use crate::subjects::{
    CantileverKind, ElementEvaluation, Evaluation, LinearSolution, Subject, SystemEvaluation, TimeSteps,
    cantilever,
};

/// Number of elements of small models.
pub const SMALL: u32 = 100;
/// Number of elements of large models.
const LARGE: u32 = 100_000;
/// Number of elements of the largest model.
const LARGEST: u32 = 1_000_000;
/// Number of time steps from rest.
pub const STEPS: u32 = 100;

type Measure = fn(&mut RowMeasurements) -> Result<MeasuredValue>;

/// All rows.
const ROWS: [(RowSpec, Measure); 21] = [
    (RowSpec::new("elastic force", Microseconds, 0.30).against("Chrono", 1.02), RowMeasurements::force),
    (
        RowSpec::new("force and tangent", Microseconds, 1.2).against("Chrono", 8.8),
        RowMeasurements::force_and_tangent,
    ),
    (RowSpec::new("scatter", Microseconds, 0.25).against("Chrono", 4.8), RowMeasurements::scatter),
    (
        RowSpec::new("factorise and solve, n = 1e3", Microseconds, 0.8).against("Chrono, n = 100", 9.8),
        RowMeasurements::equations,
    ),
    (
        RowSpec::new("factorise and solve, n = 1e5", Microseconds, 1.2).large(),
        RowMeasurements::many_equations,
    ),
    (RowSpec::new("step, n = 100", Microseconds, 3.0).against("Chrono", 36.0), RowMeasurements::step),
    (
        RowSpec::new("step, n = 1e5", Microseconds, 4.0).against("Chrono, n = 1e4", 51.0).large(),
        RowMeasurements::many_steps,
    ),
    (
        RowSpec::new("process, beam of 20, 2000 steps", Seconds, 0.12).against("Chrono", 1.35),
        RowMeasurements::whole_beam,
    ),
    (
        RowSpec::new("process, cable of 20, 2000 steps", Seconds, 0.04).against("EXUDYN", 0.106),
        RowMeasurements::whole_cable,
    ),
    (
        RowSpec::new("memory per element, n = 1e5", Kilobytes, 4.0).against("Chrono", 40.0).large(),
        RowMeasurements::memory,
    ),
    (RowSpec::new("2 threads, n = 1e5", Gain, 1.7).large(), RowMeasurements::threads),
    (RowSpec::new("step, n = 1e6", Microseconds, 5.2).large(), RowMeasurements::most_steps),
    (RowSpec::new("step, n = 1e6 against n = 1e4", Factor, 1.3).large(), RowMeasurements::growth),
    (RowSpec::new("step, platform on 1000 cables", Seconds, 0.005).large(), |_| {
        structure_step(|n| platform(1000, n), 50)
    }),
    (RowSpec::new("first step, platform on 1000 cables", Seconds, 0.3).large(), |_| {
        first_step(&platform(1000, 1))
    }),
    (RowSpec::new("step, lattice of 480 beams", Seconds, 0.06).large(), |_| {
        structure_step(|n| lattice(5, n), 20)
    }),
    (RowSpec::new("first step, lattice of 1800 beams", Seconds, 2.0).large(), |_| first_step(&lattice(8, 1))),
    (RowSpec::new("step, net of 40 x 40 knots", Seconds, 0.06).large(), |_| {
        structure_step(|n| net(40, n), 50)
    }),
    (RowSpec::new("contact, step of 10 cables in a pile", Milliseconds, 1.5), |_| {
        contact_rows::pile_of_ten()
    }),
    (RowSpec::new("contact, crossing cables", Factor, 7.0), |_| contact_rows::crossing_cables()),
    (RowSpec::new("contact, cable on a plane", Factor, 2.0), |_| contact_rows::cable_on_plane()),
];

/// Cost of a step: difference of a long run and of one of a single step, in seconds.
fn structure_step(text: impl Fn(u32) -> String, steps: u32) -> Result<MeasuredValue> {
    let (long, short) = (process::program_cost(&text(steps), 1)?, process::program_cost(&text(1), 1)?);
    let value = (long - short) / f64::from(steps - 1);
    Ok(MeasuredValue::new(value, format!("mean of {steps} steps")))
}

/// Cost of a run of one step, with reading, checks and the consistent start, in seconds.
fn first_step(text: &str) -> Result<MeasuredValue> {
    let value = process::program_cost(text, 1)?;
    Ok(MeasuredValue::new(value, "from reading to results"))
}

/// Measurements of the rows of a table.
#[derive(Debug)]
pub struct RowMeasurements {
    machine: Machine,
    /// Costs of steps by number of elements and threads.
    step_costs: BTreeMap<(u32, usize), Result<StepCost>>,
}

impl RowMeasurements {
    /// Measurements on a machine.
    pub fn new(machine: Machine) -> Self {
        Self { machine, step_costs: BTreeMap::new() }
    }

    /// Measures selected rows. `report` is called with the name of each row.
    pub fn rows(
        &mut self,
        selected: impl Fn(&RowSpec) -> bool,
        mut report: impl FnMut(&str),
    ) -> Vec<TableRow> {
        let mut rows = Vec::new();
        for (spec, measure) in ROWS.iter().filter(|(spec, _)| selected(spec)) {
            report(spec.name);
            rows.push(TableRow::new(spec, measure(self)));
        }
        let others = large_model_rows::ROWS.iter().chain(&motion_rows::ROWS).chain(&shell_rows::ROWS);
        for (spec, measure) in others.filter(|(spec, _)| selected(spec)) {
            report(spec.name);
            rows.push(TableRow::new(spec, measure()));
        }
        rows
    }

    /// Minimum time of operations in microseconds.
    fn operations(&self, count: f64) -> Option<LowerBound> {
        Some(LowerBound { value: 1e6 * count / self.machine.flops, resource: LimitingResource::Operations })
    }

    /// Minimum time of bytes from memory in microseconds.
    fn bytes(&self, count: f64) -> Option<LowerBound> {
        Some(LowerBound { value: 1e6 * count / self.machine.bytes, resource: LimitingResource::Bytes })
    }

    /// Minimum time of bytes from the cache in microseconds.
    fn cached(&self, count: f64) -> Option<LowerBound> {
        Some(LowerBound { value: 1e6 * count / self.machine.cached, resource: LimitingResource::CachedBytes })
    }

    fn small(subject: &mut dyn Subject) -> Result<f64> {
        Ok(1e6 * median(samples(subject, SampleSize::SMALL)?))
    }

    fn force(&mut self) -> Result<MeasuredValue> {
        let value =
            Self::small(&mut ElementEvaluation::new(CantileverKind::Beam, SMALL, Evaluation::Residual)?)?;
        let note = "with inertia and weight".to_owned();
        Ok(MeasuredValue { value, note, bound: self.operations(lower_bounds::force()) })
    }

    fn force_and_tangent(&mut self) -> Result<MeasuredValue> {
        let value = Self::small(&mut ElementEvaluation::new(CantileverKind::Beam, SMALL, Evaluation::Both)?)?;
        let note = String::new();
        Ok(MeasuredValue { value, note, bound: self.operations(lower_bounds::force_and_tangent()) })
    }

    /// Cost of the tangent of the system minus that of its elements, measured in alternation.
    fn scatter(&mut self) -> Result<MeasuredValue> {
        let mut all = SystemEvaluation::new(CantileverKind::Beam, SMALL, Evaluation::Tangent)?;
        let mut kernels = ElementEvaluation::new(CantileverKind::Beam, SMALL, Evaluation::Tangent)?;
        let mut excess = Vec::new();
        for _ in 0..101 {
            excess.push(1e6 * (sample(&mut all)? - sample(&mut kernels)?));
        }
        let note = "tangent of the system minus that of its elements".to_owned();
        Ok(MeasuredValue { value: median(excess), note, bound: self.cached(lower_bounds::scattered()) })
    }

    fn equations(&mut self) -> Result<MeasuredValue> {
        let value = Self::small(&mut LinearSolution::new(CantileverKind::Beam, 1000, 10)?)?;
        Ok(MeasuredValue { value, note: String::new(), bound: self.operations(lower_bounds::equations()) })
    }

    fn many_equations(&mut self) -> Result<MeasuredValue> {
        let mut equations = LinearSolution::new(CantileverKind::Beam, LARGE, 1)?;
        let value = 1e6 * median(samples(&mut equations, SampleSize::LARGE)?);
        Ok(MeasuredValue { value, note: String::new(), bound: self.bytes(lower_bounds::factorised()) })
    }

    fn step(&mut self) -> Result<MeasuredValue> {
        let mut steps = TimeSteps::new(CantileverKind::Beam, SMALL, STEPS)?;
        let value = Self::small(&mut steps)?;
        let iterations = steps.iterations();
        let note = format!("{STEPS} steps from rest, {iterations:.2} iterations per step");
        Ok(MeasuredValue { value, note, bound: self.operations(lower_bounds::step(iterations)) })
    }

    /// Cost of steps of a beam, measured once.
    fn step_cost(&mut self, elements: u32, threads: usize) -> Result<StepCost> {
        let steps = if elements == LARGE { 5 } else { 20 };
        let run = || process::step_cost(elements, steps, threads);
        self.step_costs.entry((elements, threads)).or_insert_with(run).clone()
    }

    fn many_steps(&mut self) -> Result<MeasuredValue> {
        let StepCost { processor, iterations, .. } = self.step_cost(LARGE, 1)?;
        let note = format!("5 steps, {iterations:.2} iterations per step");
        Ok(MeasuredValue {
            value: 1e6 * processor,
            note,
            bound: self.bytes(lower_bounds::step_bytes(iterations)),
        })
    }

    fn whole_beam(&mut self) -> Result<MeasuredValue> {
        let value = process::program_cost(&cantilever(CantileverKind::Beam, 20, 2000), 5)?;
        Ok(MeasuredValue::new(value, "with output files; Chrono without"))
    }

    fn whole_cable(&mut self) -> Result<MeasuredValue> {
        let value = process::program_cost(&cantilever(CantileverKind::Cable, 20, 2000), 5)?;
        Ok(MeasuredValue::new(value, "with output files; EXUDYN without"))
    }

    fn bytes_per_element(&mut self) -> Result<f64> {
        let base = process::step_cost(SMALL, 1, 1)?.memory;
        Ok((self.step_cost(LARGE, 1)?.memory - base) / f64::from(LARGE - SMALL))
    }

    fn memory(&mut self) -> Result<MeasuredValue> {
        let value = 1e-3 * self.bytes_per_element()?;
        Ok(MeasuredValue::new(value, "maximum resident memory of the process"))
    }

    fn threads(&mut self) -> Result<MeasuredValue> {
        let (one, two) = (self.step_cost(LARGE, 1)?, self.step_cost(LARGE, 2)?);
        let note = "wall-clock time: valid on an idle machine only".to_owned();
        Ok(MeasuredValue::new(one.wall / two.wall, note))
    }

    /// Cost of steps of the largest beam, if memory suffices.
    fn largest(&mut self) -> Result<StepCost> {
        let (needed, available) = (self.bytes_per_element()? * f64::from(LARGEST), process::available());
        if needed > 0.9 * available {
            let [needed, available] = [needed, available].map(|bytes| 1e-9 * bytes);
            return Err(format!("needs {needed:.1} GB of memory, {available:.1} GB are available"));
        }
        self.step_cost(LARGEST, 1)
    }

    fn most_steps(&mut self) -> Result<MeasuredValue> {
        let StepCost { processor, iterations, .. } = self.largest()?;
        let note = format!("20 steps, {iterations:.2} iterations per step");
        Ok(MeasuredValue {
            value: 1e6 * processor,
            note,
            bound: self.bytes(lower_bounds::step_bytes(iterations)),
        })
    }

    fn growth(&mut self) -> Result<MeasuredValue> {
        let (most, some) = (self.largest()?, self.step_cost(10_000, 1)?);
        let per = 1e6 * some.processor;
        let note = format!("20 steps; {per:.2} us at 1e4, {:.2} iterations per step", some.iterations);
        Ok(MeasuredValue::new(most.processor / some.processor, note))
    }
}
