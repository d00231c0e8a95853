//! Numbers of the report, in the order of the paper: the content of `results.json`.

use serde::Serialize;

use super::forms::{AnalysisTimes, Equation34, FormValues, StepSizes, Table6, Table7};
use super::gain::{self, Gain};
use super::gravity::{GravityResults, static_deflection};
use super::iterations::{self, Figure7, ToleranceRow};
use super::verdict::PaperVerdict;
use crate::cases::models::{ELEMENTS, GRAVITY, time_unit};
use crate::cases::{CaseRuns, ConditionRow, MatrixForm, PaperRuns, TimedRun, published};
use crate::page::MachineInfo;

/// All numbers of the report.
#[derive(Debug, Serialize)]
pub struct PaperResults {
    /// Machine of the measurements.
    pub machine: MachineInfo,
    /// Repetitions per median time.
    pub repeats: usize,
    /// Duration of all runs, s.
    pub seconds: f64,
    /// Comparison with the printed numbers.
    pub verdict: PaperVerdict,
    /// Static deflection of eq. (34), mm.
    pub equation34: Equation34,
    /// T_ND, s. The unit of time of the dimensional form is 1 s.
    pub table3: FormValues,
    /// Analysis time of the cantilever, s.
    pub table4: FormValues,
    /// Mean tip deflection of the cantilever, mm.
    pub table5: FormValues,
    /// Revolute pendulum.
    pub table6: Table6,
    /// Analysis time of the spherical pendulum, s.
    pub table7: Table7,
    /// Iterations per step of the revolute pendulum.
    pub fig7: Figure7,
    /// Factors of the differences in time.
    pub gain: Vec<Gain>,
    /// Iterations under each stopping rule.
    pub tolerances: Vec<ToleranceRow>,
    /// Condition numbers of the iteration matrix.
    pub conditioning: ConditionNumbers,
    /// Consequences of the acceleration of gravity, which is not printed.
    pub gravity: GravityResults,
}

/// Condition numbers.
#[derive(Clone, Debug, Serialize)]
pub struct ConditionNumbers {
    /// Forms of the matrix, one per column.
    #[serde(rename = "writings")]
    pub forms: [MatrixForm; 7],
    /// E = 193e9 Pa.
    pub stiff: Vec<ConditionRow>,
    /// E/1000, as in section 3.3.
    pub soft: Vec<ConditionRow>,
}

impl PaperResults {
    /// Evaluates runs that took `seconds` in total.
    pub fn new(runs: &PaperRuns, seconds: f64) -> Self {
        let equation34 = Equation34 { value: static_deflection(GRAVITY), paper: published::STATIC };
        let (table3, table5, table6) = (table3(), table5(runs), table6(runs));
        Self {
            machine: runs.machine.clone(),
            repeats: runs.repeats,
            seconds,
            verdict: PaperVerdict::new(equation34, &table3, &table5, &table6),
            equation34,
            table4: FormValues::new(&runs.cantilever, |run| run.seconds)
                .with_printed(&published::TABLE_4_DIM, &published::TABLE_4_NONDIM),
            gravity: GravityResults::new(runs, &table5),
            table3,
            table5,
            table6,
            table7: table7(runs),
            fig7: Figure7::new(runs),
            gain: gain::all(runs),
            tolerances: iterations::tolerances(runs),
            conditioning: ConditionNumbers {
                forms: MatrixForm::ALL,
                stiff: runs.stiff.clone(),
                soft: runs.soft.clone(),
            },
        }
    }
}

fn table3() -> FormValues {
    FormValues {
        n: ELEMENTS.to_vec(),
        dim: vec![1.0; ELEMENTS.len()],
        nondim: ELEMENTS.map(time_unit).to_vec(),
        paper_dim: None,
        paper_nondim: Some(published::TABLE_3.to_vec()),
    }
}

fn table5(runs: &PaperRuns) -> FormValues {
    FormValues::new(&runs.cantilever, TimedRun::mean_deflection)
        .with_printed(&published::TABLE_5_DIM, &published::TABLE_5_NONDIM)
}

fn table6(runs: &PaperRuns) -> Table6 {
    let CaseRuns { dim, nondim, .. } = &runs.revolute;
    let [paper_step_dim, paper_step_nondim] = published::TABLE_6_STEP;
    let [paper_seconds_dim, paper_seconds_nondim] = published::TABLE_6_SECONDS;
    let [paper_dim, paper_nondim] = published::TABLE_6_INSTANTS.map(|instants| instants as f64);
    Table6 {
        instants: FormValues::new(std::slice::from_ref(&runs.revolute), |run| run.instants() as f64)
            .with_printed(&[paper_dim], &[paper_nondim]),
        step: StepSizes { step_dim: dim.step, step_nondim: nondim.step, paper_step_dim, paper_step_nondim },
        seconds: AnalysisTimes {
            seconds_dim: dim.seconds,
            seconds_nondim: nondim.seconds,
            paper_seconds_dim,
            paper_seconds_nondim,
        },
    }
}

fn table7(runs: &PaperRuns) -> Table7 {
    let seconds = FormValues::new(&runs.spherical, |run| run.seconds);
    let note = "The paper prints no Table 7 for this problem, only that the non-dimensional form is more \
                than fourfold faster at 20 elements.";
    Table7 { ratio: seconds.ratios(), seconds, note }
}
