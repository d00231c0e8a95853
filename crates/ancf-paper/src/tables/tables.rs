//! The tables of the report.

use super::conditioning::Row;
use super::results::{
    Agreement, Candidate, Check, Effort, Forms, Gain, Results, Table6, ToleranceRow, UNIT_BLIND, Verdict,
};
use super::table::{Column, Format, Table, Value};
use super::{peers, published};

/// All tables, each under the name of its file.
#[derive(Clone, Debug)]
pub struct Tables {
    /// How the printed numbers compare.
    pub verdict: Table,
    /// T_ND.
    pub table3: Table,
    /// Analysis time of the cantilever.
    pub table4: Table,
    /// The same by other programs.
    pub peers: Table,
    /// Mean deflection of the cantilever.
    pub table5: Table,
    /// The revolute pendulum.
    pub table6: Table,
    /// Analysis time of the spherical pendulum.
    pub table7: Table,
    /// Where the gain comes from.
    pub gain: Table,
    /// Both forms with one physical step.
    pub same_step: Table,
    /// Iterations under each stopping rule.
    pub tolerances: Table,
    /// Condition numbers, both moduli.
    pub conditioning: Table,
    /// What each candidate for g leads to.
    pub gravity: Table,
    /// Table 5 with two values of g.
    pub table5_gravity: Table,
}

const ELEMENTS: Column = Column::new("n", "", Format::Fixed(0));

impl Tables {
    /// The tables of these results.
    pub fn new(results: &Results) -> Self {
        Self {
            verdict: verdict(&results.verdict),
            table3: table3(&results.table3),
            table4: table4(&results.table4),
            peers: peers(&results.table4),
            table5: table5(&results.table5),
            table6: table6(&results.table6),
            table7: table7(&results.table7.seconds),
            gain: gain(&results.gain),
            same_step: same_step(&results.gain),
            tolerances: tolerances(&results.tolerances),
            conditioning: conditioning(results),
            gravity: gravity(results),
            table5_gravity: table5_gravity(&results.table5, &results.gravity.table5_with_981),
        }
    }

    /// All of them.
    pub fn iter(&self) -> impl Iterator<Item = &Table> {
        [
            &self.verdict,
            &self.table3,
            &self.table4,
            &self.peers,
            &self.table5,
            &self.table6,
            &self.table7,
            &self.gain,
            &self.same_step,
            &self.tolerances,
            &self.conditioning,
            &self.gravity,
            &self.table5_gravity,
        ]
        .into_iter()
    }
}

/// A row from anything that can stand in a cell.
macro_rules! row {
    ($($cell:expr),* $(,)?) => { vec![$(Value::from($cell)),*] };
}

fn verdict(verdict: &Verdict) -> Table {
    let count = |name| Column::new(name, "", Format::Fixed(0));
    let difference = |name| Column::new(name, "", Format::Significant(2));
    let row = |check: &Check| {
        let Agreement { exact, numbers, worst } = check.agreement;
        let [numbers, within, exact] = [numbers, check.within, exact].map(|count| count as f64);
        row![check.what, numbers, within, exact, worst, check.tolerance, check.unit]
    };
    Table {
        file: "verdict",
        columns: vec![
            Column::text("printed"),
            count("numbers"),
            count("reproduced"),
            count("exact"),
            difference("worst"),
            difference("allowed"),
            Column::text("unit"),
        ],
        rows: verdict.checks.iter().map(row).collect(),
    }
}

/// Columns of a quantity of ours, the paper's and the difference.
fn compared(group: &'static str, unit: &'static str, decimals: [usize; 2]) -> [Column; 3] {
    let [ours, printed] = decimals.map(Format::Fixed);
    let difference = Format::Signed(decimals[0]);
    [("ours", ours), ("paper", printed), ("difference", difference)]
        .map(|(name, format)| Column::new(name, unit, format).under(group))
}

/// Cells of [`compared`].
fn compare(ours: f64, paper: f64) -> [Value; 3] {
    [ours, paper, ours - paper].map(Value::from)
}

/// Columns of a time of ours, the paper's and how many times longer the paper's is.
fn timed(group: &'static str) -> [Column; 3] {
    [
        ("ours", "s", Format::Significant(3)),
        ("paper", "s", Format::Fixed(2)),
        ("paper / ours", "", Format::Significant(2)),
    ]
    .map(|(name, unit, format)| Column::new(name, unit, format).under(group))
}

/// Cells of [`timed`].
fn time(ours: f64, paper: f64) -> [Value; 3] {
    [ours, paper, paper / ours].map(Value::from)
}

/// The rows of a quantity that the paper prints for both forms.
fn rows(forms: &Forms, cells: impl Fn(f64, f64) -> [Value; 3]) -> Vec<Vec<Value>> {
    let printed = |column: &Option<Vec<f64>>, i: usize| {
        column.as_ref().and_then(|column| column.get(i)).copied().unwrap_or(f64::NAN)
    };
    let row = |(i, &n): (usize, &u32)| {
        let dim = cells(forms.dim[i], printed(&forms.paper_dim, i));
        let nondim = cells(forms.nondim[i], printed(&forms.paper_nondim, i));
        [row![n], dim.to_vec(), nondim.to_vec()].concat()
    };
    forms.n.iter().enumerate().map(row).collect()
}

fn table3(forms: &Forms) -> Table {
    let paper = forms.paper_nondim.iter().flatten();
    let row = |((&n, &ours), &paper): ((&u32, &f64), &f64)| [row![n], compare(ours, paper).to_vec()].concat();
    Table {
        file: "table3",
        columns: [vec![ELEMENTS], compared("unit of time", "s", [5, 2]).to_vec()].concat(),
        rows: forms.n.iter().zip(&forms.nondim).zip(paper).map(row).collect(),
    }
}

fn table4(forms: &Forms) -> Table {
    let ratio = |name| Column::new(name, "", Format::Fixed(2)).under("DIM / Non-DIM");
    let printed =
        forms.paper_dim.iter().flatten().zip(forms.paper_nondim.iter().flatten()).map(|(d, n)| d / n);
    let ratios = forms.ratios().into_iter().zip(printed);
    let with_ratio = |(cells, (ours, paper)): (Vec<Value>, _)| [cells, row![ours, paper]].concat();
    Table {
        file: "table4",
        columns: [
            vec![ELEMENTS],
            timed("DIM").to_vec(),
            timed("Non-DIM").to_vec(),
            vec![ratio("ours"), ratio("paper")],
        ]
        .concat(),
        rows: rows(forms, time).into_iter().zip(ratios).map(with_ratio).collect(),
    }
}

/// The dimensional form by everyone, in seconds.
fn peers(forms: &Forms) -> Table {
    let seconds = |name, group| Column::new(name, "s", Format::Significant(3)).under(group);
    let chrono = |i: usize| peers::CHRONO[i].map_or_else(|| Value::from("not measured"), Value::from);
    let row = |(i, (&n, &ours)): (usize, (&u32, &f64))| {
        row![n, published::TABLE_4_DIM[i], chrono(i), ours, peers::EXUDYN[i]]
    };
    Table {
        file: "peers",
        columns: vec![
            ELEMENTS,
            seconds("paper (MATLAB)", "24 coordinates an element"),
            seconds("Chrono", "24 coordinates an element"),
            seconds("ancf", "24 coordinates an element"),
            seconds("EXUDYN", "12 coordinates"),
        ],
        rows: forms.n.iter().zip(&forms.dim).enumerate().map(row).collect(),
    }
}

fn table5(forms: &Forms) -> Table {
    Table {
        file: "table5",
        columns: [
            vec![ELEMENTS],
            compared("DIM", "mm", [4, 3]).to_vec(),
            compared("Non-DIM", "mm", [4, 3]).to_vec(),
        ]
        .concat(),
        rows: rows(forms, compare),
    }
}

fn table6(table: &Table6) -> Table {
    let Table6 { instants, step, seconds } = table;
    let printed = |column: &Option<Vec<f64>>| column.iter().flatten().sum::<f64>();
    let row = |form: &str, step: [Value; 3], instants: [Value; 3], seconds: [Value; 3]| {
        [vec![form.into()], step.to_vec(), instants.to_vec(), seconds.to_vec()].concat()
    };
    Table {
        file: "table6",
        columns: [
            vec![Column::text("form")],
            compared("step", "ms", [4, 2]).to_vec(),
            compared("instants", "", [0, 0]).to_vec(),
            timed("analysis time").to_vec(),
        ]
        .concat(),
        rows: vec![
            row(
                "DIM",
                compare(1e3 * step.step_dim, 1e3 * step.paper_step_dim),
                compare(instants.dim[0], printed(&instants.paper_dim)),
                time(seconds.seconds_dim, seconds.paper_seconds_dim),
            ),
            row(
                "Non-DIM",
                compare(1e3 * step.step_nondim, 1e3 * step.paper_step_nondim),
                compare(instants.nondim[0], printed(&instants.paper_nondim)),
                time(seconds.seconds_nondim, seconds.paper_seconds_nondim),
            ),
        ],
    }
}

fn table7(forms: &Forms) -> Table {
    let seconds = |name| Column::new(name, "s", Format::Significant(3));
    let cells = forms.n.iter().zip(&forms.dim).zip(&forms.nondim);
    Table {
        file: "table7",
        columns: vec![
            ELEMENTS,
            seconds("DIM"),
            seconds("Non-DIM"),
            Column::new("DIM / Non-DIM", "", Format::Fixed(2)),
        ],
        rows: cells.map(|((&n, &dim), &nondim)| row![n, dim, nondim, dim / nondim]).collect(),
    }
}

fn gain(gains: &[Gain]) -> Table {
    let factor = |name| Column::new(name, "", Format::Fixed(2)).under("DIM / Non-DIM");
    let row = |gain: &Gain| {
        let Gain { n, total, longer_step, fewer_iterations, faster_iteration, .. } = *gain;
        row![gain.problem.name(), n, total, longer_step, fewer_iterations, faster_iteration]
    };
    Table {
        file: "gain",
        columns: vec![
            Column::text("problem"),
            ELEMENTS,
            factor("total time"),
            factor("number of steps"),
            factor("iterations per step"),
            factor("time per iteration"),
        ],
        rows: gains.iter().map(row).collect(),
    }
}

fn same_step(gains: &[Gain]) -> Table {
    let iterations = |name| Column::new(name, "", Format::Fixed(0)).under("Newton iterations");
    let row = |gain: &Gain| {
        let [dim, same] = [gain.iterations_dim, gain.iterations_same_step].map(|count| count as f64);
        row![gain.problem.name(), gain.n, gain.same_step_total, dim, same, gain.tip_difference]
    };
    Table {
        file: "same_step",
        columns: vec![
            Column::text("problem"),
            ELEMENTS,
            Column::new("time, DIM / Non-DIM", "", Format::Fixed(2)),
            iterations("DIM"),
            iterations("Non-DIM"),
            Column::new("tips apart by", "m", Format::Scientific(2)),
        ],
        rows: gains.iter().map(row).collect(),
    }
}

fn tolerances(rules: &[ToleranceRow]) -> Table {
    let columns = |group| {
        [("most of a step", ""), ("in all", ""), ("stalls at", "s")]
            .map(|(name, unit)| {
                Column::new(name, unit, Format::Fixed(if unit == "s" { 3 } else { 0 })).under(group)
            })
            .to_vec()
    };
    let cells = |effort: &Effort| {
        let end = effort.stalled_at.map_or_else(|| Value::from("completes"), Value::from);
        vec![effort.most.into(), Value::from(effort.total as f64), end]
    };
    let row = |rule: &ToleranceRow| {
        let name = rule.tolerance.map_or_else(|| Value::from(UNIT_BLIND), Value::from);
        [vec![name], cells(&rule.dim), cells(&rule.nondim)].concat()
    };
    Table {
        file: "tolerances",
        columns: [vec![Column::new("rule", "", Format::Scientific(1))], columns("DIM"), columns("Non-DIM")]
            .concat(),
        rows: rules.iter().map(row).collect(),
    }
}

fn conditioning(results: &Results) -> Table {
    let number = |(group, name)| Column::new(name, "", Format::Scientific(2)).under(group);
    let writings = [
        ("eq. (37)", "DIM"),
        ("eq. (37)", "DIM, slopes × l"),
        ("eq. (37)", "Non-DIM"),
        ("eq. (37), DIM, rewritten", "symmetric"),
        ("eq. (37), DIM, rewritten", "displacement"),
        ("eq. (37), DIM, rewritten", "Bottasso"),
        ("eq. (37), DIM, rewritten", "equilibrated"),
    ];
    let rows = |young: f64, rows: &[Row]| -> Vec<Vec<Value>> {
        rows.iter()
            .map(|row| [row![young, row.n, row.h], row.condition.map(Value::from).to_vec()].concat())
            .collect()
    };
    let young = super::cases::YOUNG;
    Table {
        file: "conditioning",
        columns: [
            vec![
                Column::new("E", "Pa", Format::Scientific(3)),
                ELEMENTS,
                Column::new("h", "s", Format::Scientific(1)),
            ],
            writings.map(number).to_vec(),
        ]
        .concat(),
        rows: [rows(young, &results.conditioning.stiff), rows(young / 1000.0, &results.conditioning.soft)]
            .concat(),
    }
}

fn gravity(results: &Results) -> Table {
    let row = |c: &Candidate| row![c.g, c.instants as f64, c.static_deflection];
    Table {
        file: "gravity",
        columns: vec![
            Column::new("g", "m/s²", Format::Fixed(5)),
            Column::new("instants of Table 6, Non-DIM", "", Format::Fixed(0)),
            Column::new("eq. (34)", "mm", Format::Fixed(4)),
        ],
        rows: results.gravity.candidates.iter().map(row).collect(),
    }
}

fn table5_gravity(recovered: &Forms, usual: &Forms) -> Table {
    let columns = |group| {
        [("paper", 3), ("recovered g", 4), ("g = 9.81", 4)]
            .map(|(name, decimals)| Column::new(name, "mm", Format::Fixed(decimals)).under(group))
            .to_vec()
    };
    let with = |a: Vec<Vec<Value>>, b: Vec<Vec<Value>>| -> Vec<Vec<Value>> {
        let both = a.into_iter().zip(b);
        both.map(|(a, b)| {
            let pick = |i: usize| [a[i + 1].clone(), a[i].clone(), b[i].clone()];
            [vec![a[0].clone()], pick(1).to_vec(), pick(4).to_vec()].concat()
        })
        .collect()
    };
    Table {
        file: "table5_gravity",
        columns: [vec![ELEMENTS], columns("DIM"), columns("Non-DIM")].concat(),
        rows: with(rows(recovered, compare), rows(usual, compare)),
    }
}
