//! PaperTables 3 to 7 of the paper, and the times of other programs.

use super::common::{ELEMENTS, compare, compared, row, rows, time, timed};
use super::table::{CellValue, NumberFormat, PaperColumn, PaperTable};
use crate::cases::{peers, published};
use crate::results::{FormValues, Table6};

pub(super) fn table3(forms: &FormValues) -> PaperTable {
    let paper = forms.paper_nondim.iter().flatten();
    let row = |((&n, &ours), &paper): ((&u32, &f64), &f64)| [row![n], compare(ours, paper).to_vec()].concat();
    PaperTable {
        file: "table3",
        columns: [vec![ELEMENTS], compared("unit of time", "s", [5, 2]).to_vec()].concat(),
        rows: forms.n.iter().zip(&forms.nondim).zip(paper).map(row).collect(),
    }
}

pub(super) fn table4(forms: &FormValues) -> PaperTable {
    let ratio = |name| PaperColumn::new(name, "", NumberFormat::Fixed(2)).under("DIM / Non-DIM");
    let printed =
        forms.paper_dim.iter().flatten().zip(forms.paper_nondim.iter().flatten()).map(|(d, n)| d / n);
    let ratios = forms.ratios().into_iter().zip(printed);
    let with_ratio = |(cells, (ours, paper)): (Vec<CellValue>, _)| [cells, row![ours, paper]].concat();
    PaperTable {
        file: "table4",
        columns: [
            vec![ELEMENTS],
            timed("DIM").to_vec(),
            timed("Non-DIM").to_vec(),
            vec![ratio("ancf"), ratio("paper")],
        ]
        .concat(),
        rows: rows(forms, time).into_iter().zip(ratios).map(with_ratio).collect(),
    }
}

/// Times of the dimensional form by different programs, in seconds.
pub(super) fn other_programs(forms: &FormValues) -> PaperTable {
    let seconds = |name, group| PaperColumn::new(name, "s", NumberFormat::Significant(3)).under(group);
    let chrono = |i: usize| peers::CHRONO[i].map_or_else(|| CellValue::from("not measured"), CellValue::from);
    let row = |(i, (&n, &ours)): (usize, (&u32, &f64))| {
        row![n, published::TABLE_4_DIM[i], chrono(i), ours, peers::EXUDYN[i]]
    };
    PaperTable {
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

pub(super) fn table5(forms: &FormValues) -> PaperTable {
    PaperTable {
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

pub(super) fn table6(table: &Table6) -> PaperTable {
    let Table6 { instants, step, seconds } = table;
    let printed = |column: &Option<Vec<f64>>| column.iter().flatten().sum::<f64>();
    let row = |form: &str, step: [CellValue; 3], instants: [CellValue; 3], seconds: [CellValue; 3]| {
        [vec![form.into()], step.to_vec(), instants.to_vec(), seconds.to_vec()].concat()
    };
    PaperTable {
        file: "table6",
        columns: [
            vec![PaperColumn::text("form")],
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

pub(super) fn table7(forms: &FormValues) -> PaperTable {
    let seconds = |name| PaperColumn::new(name, "s", NumberFormat::Significant(3));
    let cells = forms.n.iter().zip(&forms.dim).zip(&forms.nondim);
    PaperTable {
        file: "table7",
        columns: vec![
            ELEMENTS,
            seconds("DIM"),
            seconds("Non-DIM"),
            PaperColumn::new("DIM / Non-DIM", "", NumberFormat::Fixed(2)),
        ],
        rows: cells.map(|((&n, &dim), &nondim)| row![n, dim, nondim, dim / nondim]).collect(),
    }
}
