//! The numbers of the report, in the order of the paper: what `results.json` holds.

mod gain;
mod gravity;
mod iterations;
mod verdict;

use std::f64::consts::PI;

use serde::Serialize;

pub use gain::{Gain, Problem};
pub use gravity::{Agreement, Candidate, Gravity, static_deflection};
pub use iterations::{Effort, Figure7, StepCounts, ToleranceRow, UNIT_BLIND};
pub use verdict::{Check, Verdict};

use super::cases::{DIAMETER, ELEMENTS, GRAVITY, time_unit};
use super::conditioning::{Row, Writing};
use super::published;
use super::study::{Comparison, Run, Study};
use crate::report::Machine;

/// All numbers of the report.
#[derive(Debug, Serialize)]
pub struct Results {
    /// Where times were measured.
    pub machine: Machine,
    /// Repetitions behind each median time.
    pub repeats: usize,
    /// Duration of the whole study, s.
    pub seconds: f64,
    /// How the printed numbers compare.
    pub verdict: Verdict,
    /// Static deflection of eq. (34), mm.
    pub equation34: Equation34,
    /// T_ND, s; the unit of time of the dimensional form is 1 s.
    pub table3: Forms,
    /// Analysis time of the cantilever, s.
    pub table4: Forms,
    /// Mean tip deflection of the cantilever, mm.
    pub table5: Forms,
    /// The revolute pendulum.
    pub table6: Table6,
    /// Analysis time of the spherical pendulum, s.
    pub table7: Table7,
    /// Iterations of each step of the revolute pendulum.
    pub fig7: Figure7,
    /// Where the differences in time come from.
    pub gain: Vec<Gain>,
    /// Iterations under each stopping rule.
    pub tolerances: Vec<ToleranceRow>,
    /// Condition numbers of the iteration matrix.
    pub conditioning: Conditioning,
    /// What the unprinted acceleration of gravity decides.
    pub gravity: Gravity,
}

/// Eq. (34), mm.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Equation34 {
    /// With the recovered g.
    pub value: f64,
    /// As printed.
    pub paper: f64,
}

/// A quantity of both forms for each number of elements.
#[derive(Clone, Debug, Serialize)]
pub struct Forms {
    /// Numbers of elements.
    pub n: Vec<u32>,
    /// Dimensional form.
    pub dim: Vec<f64>,
    /// Non-dimensional form.
    pub nondim: Vec<f64>,
    /// Dimensional form as printed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub paper_dim: Option<Vec<f64>>,
    /// Non-dimensional form as printed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub paper_nondim: Option<Vec<f64>>,
}

impl Forms {
    fn new(runs: &[Comparison], quantity: impl Fn(&Run) -> f64) -> Self {
        Self {
            n: runs.iter().map(|c| c.n).collect(),
            dim: runs.iter().map(|c| quantity(&c.dim)).collect(),
            nondim: runs.iter().map(|c| quantity(&c.nondim)).collect(),
            paper_dim: None,
            paper_nondim: None,
        }
    }

    fn beside(self, dim: &[f64], nondim: &[f64]) -> Self {
        Self { paper_dim: Some(dim.to_vec()), paper_nondim: Some(nondim.to_vec()), ..self }
    }

    /// Dimensional over non-dimensional.
    pub fn ratios(&self) -> Vec<f64> {
        self.dim.iter().zip(&self.nondim).map(|(dim, nondim)| dim / nondim).collect()
    }
}

/// Table 6: `dim` and `nondim` of the first part are numbers of instants.
#[derive(Clone, Debug, Serialize)]
pub struct Table6 {
    /// Instants.
    #[serde(flatten)]
    pub instants: Forms,
    /// Physical step, s: dimensional, non-dimensional.
    #[serde(flatten)]
    pub step: Step,
    /// Analysis time, s.
    #[serde(flatten)]
    pub seconds: Seconds,
}

/// Physical step of both forms, s.
#[derive(Clone, Copy, Debug, Serialize)]
#[expect(clippy::struct_field_names, reason = "the fields are keys of results.json")]
pub struct Step {
    /// Dimensional form.
    pub step_dim: f64,
    /// Non-dimensional form.
    pub step_nondim: f64,
    /// Dimensional form as printed.
    pub paper_step_dim: f64,
    /// Non-dimensional form as printed.
    pub paper_step_nondim: f64,
}

/// Analysis time of both forms, s.
#[derive(Clone, Copy, Debug, Serialize)]
#[expect(clippy::struct_field_names, reason = "the fields are keys of results.json")]
pub struct Seconds {
    /// Dimensional form.
    pub seconds_dim: f64,
    /// Non-dimensional form.
    pub seconds_nondim: f64,
    /// Dimensional form as printed.
    pub paper_seconds_dim: f64,
    /// Non-dimensional form as printed.
    pub paper_seconds_nondim: f64,
}

/// Table 7 of section 3.3.
#[derive(Clone, Debug, Serialize)]
pub struct Table7 {
    /// Times, s.
    #[serde(flatten)]
    pub seconds: Forms,
    /// Dimensional over non-dimensional.
    pub ratio: Vec<f64>,
    /// What the paper says of it.
    pub note: &'static str,
}

/// Condition numbers.
#[derive(Clone, Debug, Serialize)]
pub struct Conditioning {
    /// Names of the columns.
    pub writings: [Writing; 7],
    /// E = 193e9 Pa.
    pub stiff: Vec<Row>,
    /// E/1000, as in section 3.3.
    pub soft: Vec<Row>,
}

impl Results {
    /// The numbers of a study that took so many seconds.
    pub fn new(study: &Study, seconds: f64) -> Self {
        let equation34 = Equation34 { value: static_deflection(GRAVITY), paper: published::STATIC };
        let (table3, table5, table6) = (table3(), table5(study), table6(study));
        Self {
            machine: study.machine.clone(),
            repeats: study.repeats,
            seconds,
            verdict: Verdict::new(equation34, &table3, &table5, &table6),
            equation34,
            table4: Forms::new(&study.cantilever, |run| run.seconds)
                .beside(&published::TABLE_4_DIM, &published::TABLE_4_NONDIM),
            gravity: Gravity::new(study, &table5),
            table3,
            table5,
            table6,
            table7: table7(study),
            fig7: Figure7::new(study),
            gain: gain::all(study),
            tolerances: iterations::tolerances(study),
            conditioning: Conditioning {
                writings: Writing::ALL,
                stiff: study.stiff.clone(),
                soft: study.soft.clone(),
            },
        }
    }
}

fn table3() -> Forms {
    Forms {
        n: ELEMENTS.to_vec(),
        dim: vec![1.0; ELEMENTS.len()],
        nondim: ELEMENTS.map(time_unit).to_vec(),
        paper_dim: None,
        paper_nondim: Some(published::TABLE_3.to_vec()),
    }
}

fn table5(study: &Study) -> Forms {
    Forms::new(&study.cantilever, Run::mean_deflection)
        .beside(&published::TABLE_5_DIM, &published::TABLE_5_NONDIM)
}

fn table6(study: &Study) -> Table6 {
    let Comparison { dim, nondim, .. } = &study.revolute;
    let [paper_step_dim, paper_step_nondim] = published::TABLE_6_STEP;
    let [paper_seconds_dim, paper_seconds_nondim] = published::TABLE_6_SECONDS;
    let [paper_dim, paper_nondim] = published::TABLE_6_INSTANTS.map(|instants| instants as f64);
    Table6 {
        instants: Forms::new(std::slice::from_ref(&study.revolute), |run| run.instants() as f64)
            .beside(&[paper_dim], &[paper_nondim]),
        step: Step { step_dim: dim.step, step_nondim: nondim.step, paper_step_dim, paper_step_nondim },
        seconds: Seconds {
            seconds_dim: dim.seconds,
            seconds_nondim: nondim.seconds,
            paper_seconds_dim,
            paper_seconds_nondim,
        },
    }
}

fn table7(study: &Study) -> Table7 {
    let seconds = Forms::new(&study.spherical, |run| run.seconds);
    let note = "The paper prints no Table 7 for this problem, only that the non-dimensional form is more \
                than fourfold faster at 20 elements.";
    Table7 { ratio: seconds.ratios(), seconds, note }
}

/// Area of the section, m².
pub fn area() -> f64 {
    PI * DIAMETER * DIAMETER / 4.0
}

/// Second moment of the section, m⁴.
pub fn second_moment() -> f64 {
    PI * DIAMETER.powi(4) / 64.0
}
