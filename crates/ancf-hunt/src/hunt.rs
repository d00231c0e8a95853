//! Hunts: many models, all laws, a table of results.

use std::collections::BTreeMap;
use std::fmt;
use std::num::NonZeroUsize;
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use ancf::Model;
use ancf::model::Analysis;

use crate::compare::{Case, Cause, Finding};
use crate::generate::model;
use crate::known;
use crate::laws::{Check, LAWS};
use crate::random::Random;

/// Finding with its model.
#[derive(Clone, Debug)]
pub struct Violation {
    /// Number of the case.
    pub number: u64,
    /// Model that violates a law.
    pub model: Model,
    /// Violation.
    pub finding: Finding,
    /// Name of the known defect, if there is one.
    pub known: Option<&'static str>,
}

/// Counts of checks.
#[derive(Clone, Copy, Debug, Default)]
pub struct Counts {
    /// Number of checks of an applicable law.
    pub checked: u64,
    /// Number of deviations with the measured cause of rounding errors, and of the errors of steps.
    pub explained: [u64; 2],
    /// Number of findings of known defects.
    pub known: u64,
    /// Number of other findings.
    pub new: u64,
}

/// Result of a hunt.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// Number of models.
    pub models: u64,
    /// Number of models by verdict of the run.
    pub verdicts: BTreeMap<(&'static str, &'static str), u64>,
    /// Counts by law and analysis.
    pub counts: BTreeMap<(&'static str, &'static str), Counts>,
    /// All findings.
    pub violations: Vec<Violation>,
    /// Deviations with a measured cause: number of the case and name of the law.
    pub explained: Vec<(u64, &'static str, Cause)>,
    /// Reasons of ends before the analysis was complete, with the numbers of the cases.
    pub refusals: Vec<(u64, String)>,
}

/// Name of an analysis.
pub const fn analysis(model: &Model) -> &'static str {
    match model.analysis {
        Analysis::Dynamics(_) => "dynamics",
        Analysis::Statics(_) => "statics",
        Analysis::Path(_) => "path",
        Analysis::Modes(_) => "modes",
        Analysis::Buckling(_) => "buckling",
    }
}

/// Model of a case of a hunt.
///
/// # Errors
/// If the generator states a model of a wrong form.
pub fn case(seed: u64, number: u64) -> Result<Model, String> {
    model(Random::of_case(seed, number))
}

/// Random numbers of a law in a case of a hunt.
pub fn random_of(law: &str, seed: u64, number: u64) -> Random {
    let hash = law.bytes().fold(seed, |hash, byte| hash.wrapping_mul(31).wrapping_add(u64::from(byte)));
    Random::of_case(hash, number)
}

/// Checks the laws for a model. A law is left out with the probability 1 − `share`.
pub fn check(seed: u64, number: u64, model: Model, share: f64) -> Report {
    let mut report = Report { models: 1, ..Report::default() };
    let kind = analysis(&model);
    let case = Case::new(model);
    *report.verdicts.entry((kind, case.base.verdict.word())).or_default() += 1;
    if !case.base.verdict.is_finished() {
        report.refusals.push((number, format!("{kind}: {}", case.base.verdict.reason())));
    }
    for law in LAWS {
        let mut random = random_of(law.name(), seed, number);
        let is_chosen = random.chance(share);
        if !is_chosen {
            continue;
        }
        let result = law.check(&case, &mut random);
        if result == Check::Inapplicable {
            continue;
        }
        let counts = report.counts.entry((law.name(), kind)).or_default();
        counts.checked += 1;
        if let Check::Explained(cause) = result {
            counts.explained[usize::from(cause == Cause::Steps)] += 1;
            report.explained.push((number, law.name(), cause));
        }
        if let Check::Violated(finding) = result {
            let known = known::cause(&case.model, &finding);
            *if known.is_some() { &mut counts.known } else { &mut counts.new } += 1;
            report.violations.push(Violation { number, model: case.model.clone(), finding, known });
        }
    }
    report
}

/// Stack size of a worker in bytes, as of a main thread.
const STACK: usize = 8 << 20;

/// Hunts with models of a seed on all processors, one model at a time on each.
///
/// Every worker has a pool of one thread. In a common pool, a worker that waits for a part of one model would begin another model
/// meanwhile, and so on to any depth of its stack.
///
/// # Errors
/// If the generator states a model of a wrong form, or a thread cannot be started.
pub fn hunt(seed: u64, numbers: Range<u64>, share: f64) -> Result<Report, String> {
    let workers = thread::available_parallelism().map_or(1, NonZeroUsize::get);
    let next = AtomicU64::new(numbers.start);
    let take = || Some(next.fetch_add(1, Ordering::Relaxed)).filter(|number| *number < numbers.end);
    let work = || -> Result<Vec<Report>, String> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1).stack_size(STACK).build();
        let pool = pool.map_err(|error| error.to_string())?;
        pool.install(|| {
            let check = |number| Ok(check(seed, number, case(seed, number)?, share));
            std::iter::from_fn(take).map(check).collect()
        })
    };
    let parts = thread::scope(|scope| -> Vec<Result<Vec<Report>, String>> {
        let threads: Vec<_> = (0..workers).map(|_| scope.spawn(work)).collect();
        let result = |thread: thread::ScopedJoinHandle<'_, _>| {
            thread.join().unwrap_or_else(|_| Err("a worker panicked".to_owned()))
        };
        threads.into_iter().map(result).collect()
    });
    let mut whole = Report::default();
    for reports in parts {
        whole = reports?.into_iter().fold(whole, Report::with);
    }
    whole.violations.sort_by_key(|violation| violation.number);
    whole.explained.sort_by_key(|explained| explained.0);
    whole.refusals.sort_by_key(|refusal| refusal.0);
    Ok(whole)
}

impl Report {
    /// Sum of two reports.
    #[must_use]
    pub fn with(mut self, other: Self) -> Self {
        self.models += other.models;
        for (key, count) in other.verdicts {
            *self.verdicts.entry(key).or_default() += count;
        }
        for (key, counts) in other.counts {
            let sum = self.counts.entry(key).or_default();
            sum.checked += counts.checked;
            (0..2).for_each(|i| sum.explained[i] += counts.explained[i]);
            sum.known += counts.known;
            sum.new += counts.new;
        }
        self.violations.extend(other.violations);
        self.explained.extend(other.explained);
        self.refusals.extend(other.refusals);
        self
    }

    /// Share of models whose analysis was complete.
    pub fn share_finished(&self) -> f64 {
        let finished: u64 =
            self.verdicts.iter().filter(|((_, word), _)| *word == "finished").map(|(_, count)| count).sum();
        finished as f64 / self.models.max(1) as f64
    }

    /// Share of checks whose deviation has a measured cause.
    pub fn share_explained(&self) -> f64 {
        let checked: u64 = self.counts.values().map(|counts| counts.checked).sum();
        self.explained.len() as f64 / checked.max(1) as f64
    }

    /// Findings without a known defect.
    pub fn new_findings(&self) -> impl Iterator<Item = &Violation> {
        self.violations.iter().filter(|violation| violation.known.is_none())
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{} models, {:.1} % finished", self.models, 100.0 * self.share_finished())?;
        for ((kind, word), count) in &self.verdicts {
            writeln!(f, "  {kind:<10} {word:<10} {count:>6}")?;
        }
        let percent = 100.0 * self.share_explained();
        writeln!(
            f,
            "{percent:.3} % of the checks deviate by rounding errors or by the errors of large steps"
        )?;
        let words = ["checked", "rounding", "steps", "known", "new"];
        writeln!(f, "{:<14} {:<10} {}", "law", "analysis", words.map(|word| format!("{word:>8}")).join(" "))?;
        for ((law, kind), counts) in &self.counts {
            let Counts { checked, explained: [rounding, steps], known, new } = counts;
            writeln!(f, "{law:<14} {kind:<10} {checked:>8} {rounding:>8} {steps:>8} {known:>8} {new:>8}")?;
        }
        Ok(())
    }
}
