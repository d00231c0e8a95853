//! The rows and how each is measured.

use std::collections::BTreeMap;

use crate::least;
use crate::machine::Machine;
use crate::measure::{Effort, Result, median, sample, samples};
use crate::model::Kind;
use crate::process::{self, Stepped};
use crate::row::Unit::{Factor, Gain, Kilobytes, Microseconds, Seconds};
use crate::row::{Asked, Best, Bound, Measured, Row, Unit};
use crate::subject::{OfElements, OfEquations, OfSteps, OfSystem, Part, Subject};

/// Elements of the rows of parts.
pub const FEW: u32 = 100;
/// Elements of the rows of large models.
const MANY: u32 = 100_000;
/// Elements of the largest one.
const MOST: u32 = 1_000_000;
/// Steps from rest of a row of whole steps.
pub const STEPS: u32 = 100;

type Measure = fn(&mut Bench) -> Result<Measured>;

const fn row(name: &'static str, unit: Unit, goal: f64) -> Asked {
    Asked { name, unit, goal, peer: None, large: false }
}

impl Asked {
    const fn against(self, peer: &'static str, theirs: f64) -> Self {
        Self { peer: Some((peer, theirs)), ..self }
    }

    const fn large(self) -> Self {
        Self { large: true, ..self }
    }
}

/// All rows.
const ROWS: [(Asked, Measure); 13] = [
    (row("elastic force", Microseconds, 0.30).against("Chrono", 1.02), Bench::force),
    (row("force and tangent", Microseconds, 1.2).against("Chrono", 8.8), Bench::force_and_tangent),
    (row("scatter", Microseconds, 0.25).against("Chrono", 4.8), Bench::scatter),
    (
        row("factorise and solve, n = 1e3", Microseconds, 0.8).against("Chrono, n = 100", 9.8),
        Bench::equations,
    ),
    (row("factorise and solve, n = 1e5", Microseconds, 1.2).large(), Bench::many_equations),
    (row("step, n = 100", Microseconds, 3.0).against("Chrono", 36.0), Bench::step),
    (row("step, n = 1e5", Microseconds, 4.0).against("Chrono, n = 1e4", 51.0).large(), Bench::many_steps),
    (row("process, beam of 20, 2000 steps", Seconds, 0.12).against("Chrono", 1.35), Bench::whole_beam),
    (row("process, cable of 20, 2000 steps", Seconds, 0.04).against("EXUDYN", 0.106), Bench::whole_cable),
    (row("memory per element, n = 1e5", Kilobytes, 4.0).against("Chrono", 40.0).large(), Bench::memory),
    (row("2 threads, n = 1e5", Gain, 1.7).large(), Bench::threads),
    (row("step, n = 1e6", Microseconds, 5.2).large(), Bench::most_steps),
    (row("step, n = 1e6 against n = 1e4", Factor, 1.3).large(), Bench::growth),
];

/// The measurements of a table.
#[derive(Debug)]
pub struct Bench {
    machine: Machine,
    /// What was stepped, by elements and threads.
    stepped: BTreeMap<(u32, usize), Result<Stepped>>,
}

impl Bench {
    /// On a machine.
    pub fn new(machine: Machine) -> Self {
        Self { machine, stepped: BTreeMap::new() }
    }

    /// Measures the rows that are wanted; `report` is told what comes next.
    pub fn rows(&mut self, wanted: impl Fn(&Asked) -> bool, mut report: impl FnMut(&str)) -> Vec<Row> {
        let asked = ROWS.iter().filter(|(asked, _)| wanted(asked));
        let measure = |(asked, measure): &(Asked, Measure)| {
            report(asked.name);
            Row::new(asked, measure(self))
        };
        asked.map(measure).collect()
    }

    /// Least time of operations, us.
    fn operations(&self, count: f64) -> Option<Best> {
        Some(Best { value: 1e6 * count / self.machine.flops, bound: Bound::Operations })
    }

    /// Least time of bytes, us.
    fn bytes(&self, count: f64) -> Option<Best> {
        Some(Best { value: 1e6 * count / self.machine.bytes, bound: Bound::Bytes })
    }

    /// Least time of bytes that stay in the cache, us.
    fn cached(&self, count: f64) -> Option<Best> {
        Some(Best { value: 1e6 * count / self.machine.cached, bound: Bound::CachedBytes })
    }

    fn small(subject: &mut dyn Subject) -> Result<f64> {
        Ok(1e6 * median(samples(subject, Effort::SMALL)?))
    }

    fn force(&mut self) -> Result<Measured> {
        let value = Self::small(&mut OfElements::new(Kind::Beam, FEW, Part::Force)?)?;
        let note = "with inertia and weight".to_owned();
        Ok(Measured { value, note, best: self.operations(least::force()) })
    }

    fn force_and_tangent(&mut self) -> Result<Measured> {
        let value = Self::small(&mut OfElements::new(Kind::Beam, FEW, Part::Both)?)?;
        let note = String::new();
        Ok(Measured { value, note, best: self.operations(least::force_and_tangent()) })
    }

    /// What the tangent of the system takes beyond that of its elements, each pair measured one after the other.
    fn scatter(&mut self) -> Result<Measured> {
        let mut all = OfSystem::new(Kind::Beam, FEW, Part::Stiffness)?;
        let mut kernels = OfElements::new(Kind::Beam, FEW, Part::Stiffness)?;
        let mut excess = Vec::new();
        for _ in 0..101 {
            excess.push(1e6 * (sample(&mut all)? - sample(&mut kernels)?));
        }
        let note = "tangent of the system less that of its elements".to_owned();
        Ok(Measured { value: median(excess), note, best: self.cached(least::scattered()) })
    }

    fn equations(&mut self) -> Result<Measured> {
        let value = Self::small(&mut OfEquations::new(Kind::Beam, 1000, 10)?)?;
        Ok(Measured { value, note: String::new(), best: self.operations(least::equations()) })
    }

    fn many_equations(&mut self) -> Result<Measured> {
        let mut equations = OfEquations::new(Kind::Beam, MANY, 1)?;
        let value = 1e6 * median(samples(&mut equations, Effort::LARGE)?);
        Ok(Measured { value, note: String::new(), best: self.bytes(least::factorised()) })
    }

    fn step(&mut self) -> Result<Measured> {
        let mut steps = OfSteps::new(Kind::Beam, FEW, STEPS)?;
        let value = Self::small(&mut steps)?;
        let iterations = steps.iterations();
        let note = format!("{STEPS} steps from rest, {iterations:.2} iterations a step");
        Ok(Measured { value, note, best: self.operations(least::step(iterations)) })
    }

    /// Steps of a large beam, once.
    fn stepped(&mut self, elements: u32, threads: usize) -> Result<Stepped> {
        let steps = if elements == MANY { 5 } else { 20 };
        let run = || process::stepped(elements, steps, threads);
        self.stepped.entry((elements, threads)).or_insert_with(run).clone()
    }

    fn many_steps(&mut self) -> Result<Measured> {
        let Stepped { processor, iterations, .. } = self.stepped(MANY, 1)?;
        let note = format!("5 steps, {iterations:.2} iterations a step");
        Ok(Measured { value: 1e6 * processor, note, best: self.bytes(least::step_bytes(iterations)) })
    }

    fn whole_beam(&mut self) -> Result<Measured> {
        let value = process::whole(Kind::Beam, 20, 2000, 5)?;
        Ok(Measured { value, note: "with its files; Chrono without".to_owned(), best: None })
    }

    fn whole_cable(&mut self) -> Result<Measured> {
        let value = process::whole(Kind::Cable, 20, 2000, 5)?;
        Ok(Measured { value, note: "with its files; EXUDYN without".to_owned(), best: None })
    }

    fn per_element(&mut self) -> Result<f64> {
        let base = process::stepped(FEW, 1, 1)?.memory;
        Ok((self.stepped(MANY, 1)?.memory - base) / f64::from(MANY - FEW))
    }

    fn memory(&mut self) -> Result<Measured> {
        let value = 1e-3 * self.per_element()?;
        Ok(Measured { value, note: "the most that the process had".to_owned(), best: None })
    }

    fn threads(&mut self) -> Result<Measured> {
        let (one, two) = (self.stepped(MANY, 1)?, self.stepped(MANY, 2)?);
        let note = "on the wall: of use on an idle machine only".to_owned();
        Ok(Measured { value: one.wall / two.wall, note, best: None })
    }

    /// Steps of the largest beam, if there is memory for it.
    fn largest(&mut self) -> Result<Stepped> {
        let (wanted, there) = (self.per_element()? * f64::from(MOST), process::available());
        if wanted > 0.9 * there {
            let [wanted, there] = [wanted, there].map(|bytes| 1e-9 * bytes);
            return Err(format!("wants {wanted:.1} GB of memory, and {there:.1} GB are to be had"));
        }
        self.stepped(MOST, 1)
    }

    fn most_steps(&mut self) -> Result<Measured> {
        let Stepped { processor, iterations, .. } = self.largest()?;
        let note = format!("20 steps, {iterations:.2} iterations a step");
        Ok(Measured { value: 1e6 * processor, note, best: self.bytes(least::step_bytes(iterations)) })
    }

    fn growth(&mut self) -> Result<Measured> {
        let (most, some) = (self.largest()?, self.stepped(10_000, 1)?);
        let per = 1e6 * some.processor;
        let note = format!("20 steps; {per:.2} us at 1e4, {:.2} iterations a step", some.iterations);
        Ok(Measured { value: most.processor / some.processor, note, best: None })
    }
}
