//! PaperTables beyond the paper: agreement, gain, iterations, condition numbers, gravity.

use super::common::{ELEMENTS, compare, row, rows};
use super::table::{CellValue, NumberFormat, PaperColumn, PaperTable};
use crate::cases::ConditionRow;
use crate::cases::models::YOUNG;
use crate::results::{
    Agreement, FormValues, Gain, GravityCandidate, IterationEffort, PaperResults, PaperVerdict, PrintedCheck,
    ToleranceRow, UNIT_BLIND,
};

pub(super) fn verdict(verdict: &PaperVerdict) -> PaperTable {
    let count = |name| PaperColumn::new(name, "", NumberFormat::Fixed(0));
    let difference = |name| PaperColumn::new(name, "", NumberFormat::Significant(2));
    let row = |check: &PrintedCheck| {
        let Agreement { exact, numbers, worst } = check.agreement;
        let [numbers, within, exact] = [numbers, check.within, exact].map(|count| count as f64);
        row![check.what, numbers, within, exact, worst, check.tolerance, check.unit]
    };
    PaperTable {
        file: "verdict",
        columns: vec![
            PaperColumn::text("printed"),
            count("numbers"),
            count("reproduced"),
            count("exact"),
            difference("worst"),
            difference("allowed"),
            PaperColumn::text("unit"),
        ],
        rows: verdict.checks.iter().map(row).collect(),
    }
}

pub(super) fn gain(gains: &[Gain]) -> PaperTable {
    let factor = |name| PaperColumn::new(name, "", NumberFormat::Fixed(2)).under("DIM / Non-DIM");
    let row = |gain: &Gain| {
        let Gain { n, total, longer_step, fewer_iterations, faster_iteration, .. } = *gain;
        row![gain.problem.name(), n, total, longer_step, fewer_iterations, faster_iteration]
    };
    PaperTable {
        file: "gain",
        columns: vec![
            PaperColumn::text("problem"),
            ELEMENTS,
            factor("total time"),
            factor("number of steps"),
            factor("iterations per step"),
            factor("time per iteration"),
        ],
        rows: gains.iter().map(row).collect(),
    }
}

pub(super) fn same_step(gains: &[Gain]) -> PaperTable {
    let iterations = |name| PaperColumn::new(name, "", NumberFormat::Fixed(0)).under("Newton iterations");
    let row = |gain: &Gain| {
        let [dim, same] = [gain.iterations_dim, gain.iterations_same_step].map(|count| count as f64);
        row![gain.problem.name(), gain.n, gain.same_step_total, dim, same, gain.tip_difference]
    };
    PaperTable {
        file: "same_step",
        columns: vec![
            PaperColumn::text("problem"),
            ELEMENTS,
            PaperColumn::new("time, DIM / Non-DIM", "", NumberFormat::Fixed(2)),
            iterations("DIM"),
            iterations("Non-DIM"),
            PaperColumn::new("tips apart by", "m", NumberFormat::Scientific(2)),
        ],
        rows: gains.iter().map(row).collect(),
    }
}

pub(super) fn tolerances(rules: &[ToleranceRow]) -> PaperTable {
    let columns = |group| {
        [("most of a step", ""), ("in all", ""), ("stalls at", "s")]
            .map(|(name, unit)| {
                PaperColumn::new(name, unit, NumberFormat::Fixed(if unit == "s" { 3 } else { 0 }))
                    .under(group)
            })
            .to_vec()
    };
    let cells = |effort: &IterationEffort| {
        let end = effort.stalled_at.map_or_else(|| CellValue::from("completes"), CellValue::from);
        vec![effort.max.into(), CellValue::from(effort.total as f64), end]
    };
    let row = |rule: &ToleranceRow| {
        let name = rule.tolerance.map_or_else(|| CellValue::from(UNIT_BLIND), CellValue::from);
        [vec![name], cells(&rule.dim), cells(&rule.nondim)].concat()
    };
    PaperTable {
        file: "tolerances",
        columns: [
            vec![PaperColumn::new("rule", "", NumberFormat::Scientific(1))],
            columns("DIM"),
            columns("Non-DIM"),
        ]
        .concat(),
        rows: rules.iter().map(row).collect(),
    }
}

pub(super) fn conditioning(results: &PaperResults) -> PaperTable {
    let number = |(group, name)| PaperColumn::new(name, "", NumberFormat::Scientific(2)).under(group);
    let forms = [
        ("eq. (37)", "DIM"),
        ("eq. (37)", "DIM, slopes × l"),
        ("eq. (37)", "Non-DIM"),
        ("eq. (37), DIM, rewritten", "symmetric"),
        ("eq. (37), DIM, rewritten", "displacement"),
        ("eq. (37), DIM, rewritten", "Bottasso"),
        ("eq. (37), DIM, rewritten", "equilibrated"),
    ];
    let rows = |young: f64, rows: &[ConditionRow]| -> Vec<Vec<CellValue>> {
        rows.iter()
            .map(|row| [row![young, row.n, row.h], row.condition.map(CellValue::from).to_vec()].concat())
            .collect()
    };
    let young = YOUNG;
    PaperTable {
        file: "conditioning",
        columns: [
            vec![
                PaperColumn::new("E", "Pa", NumberFormat::Scientific(3)),
                ELEMENTS,
                PaperColumn::new("h", "s", NumberFormat::Scientific(1)),
            ],
            forms.map(number).to_vec(),
        ]
        .concat(),
        rows: [rows(young, &results.conditioning.stiff), rows(young / 1000.0, &results.conditioning.soft)]
            .concat(),
    }
}

pub(super) fn gravity(results: &PaperResults) -> PaperTable {
    let row = |c: &GravityCandidate| row![c.g, c.instants as f64, c.static_deflection];
    PaperTable {
        file: "gravity",
        columns: vec![
            PaperColumn::new("g", "m/s²", NumberFormat::Fixed(5)),
            PaperColumn::new("instants of Table 6, Non-DIM", "", NumberFormat::Fixed(0)),
            PaperColumn::new("eq. (34)", "mm", NumberFormat::Fixed(4)),
        ],
        rows: results.gravity.candidates.iter().map(row).collect(),
    }
}

pub(super) fn table5_gravity(recovered: &FormValues, standard: &FormValues) -> PaperTable {
    let columns = |group| {
        [("paper", 3), ("recovered g", 4), ("g = 9.81", 4)]
            .map(|(name, decimals)| PaperColumn::new(name, "mm", NumberFormat::Fixed(decimals)).under(group))
            .to_vec()
    };
    let with = |a: Vec<Vec<CellValue>>, b: Vec<Vec<CellValue>>| -> Vec<Vec<CellValue>> {
        let both = a.into_iter().zip(b);
        both.map(|(a, b)| {
            let pick = |i: usize| [a[i + 1].clone(), a[i].clone(), b[i].clone()];
            [vec![a[0].clone()], pick(1).to_vec(), pick(4).to_vec()].concat()
        })
        .collect()
    };
    PaperTable {
        file: "table5_gravity",
        columns: [vec![ELEMENTS], columns("DIM"), columns("Non-DIM")].concat(),
        rows: with(rows(recovered, compare), rows(standard, compare)),
    }
}
