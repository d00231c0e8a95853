//! `ancf paper`: files, page, and the printed numbers of Kim et al. (2017).

use std::fs;
use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

use serde_json::Value;

const FIGURES: [&str; 13] = [
    "fig3",
    "fig4",
    "fig5",
    "fig7",
    "fig8a",
    "fig8b",
    "fig9",
    "fig11",
    "fig12a",
    "fig12b",
    "fig13a",
    "fig13b",
    "conditioning",
];
const TABLES: [&str; 8] =
    ["table3", "table4", "table5", "table6", "table7", "conditioning", "gain", "tolerances"];
const ELEMENTS: [u64; 6] = [1, 2, 5, 10, 15, 20];

/// Folder of one report, written once for all tests.
static REPORT: LazyLock<PathBuf> = LazyLock::new(|| {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("paper");
    let _ = fs::remove_dir_all(&folder);
    let output = ancf(&folder).output().unwrap();
    let messages = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{messages}");
    assert!(messages.trim_end().ends_with("index.html"), "{messages}");
    folder
});

static RESULTS: LazyLock<Value> = LazyLock::new(|| serde_json::from_str(&read("results.json")).unwrap());

fn ancf(folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ancf"));
    command.args(["paper", "--repeats", "1", "-o"]).arg(folder);
    command
}

fn read(name: &str) -> String {
    fs::read_to_string(REPORT.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn numbers(value: &Value) -> Vec<f64> {
    let values = value.as_array().unwrap_or_else(|| panic!("no array: {value}"));
    values.iter().map(|x| x.as_f64().unwrap()).collect()
}

fn assert_near(ours: &Value, printed: &[f64], tolerance: f64) {
    let ours = numbers(ours);
    assert_eq!(ours.len(), printed.len());
    for (x, y) in ours.iter().zip(printed) {
        assert!((x - y).abs() <= tolerance, "{x} is not {y}");
    }
}

#[test]
fn figures_are_drawn() {
    for name in FIGURES {
        let svg = read(&format!("{name}.svg"));
        let document = roxmltree::Document::parse(&svg).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(
            document.root_element().attribute("aria-label").is_some_and(|words| words.len() > 20),
            "{name}"
        );
        assert!(!svg.contains("NaN"), "{name}");
        assert!(
            dark_share(&fs::read(REPORT.join(format!("{name}.png"))).unwrap()) > 0.003,
            "{name} is blank"
        );
    }
}

/// Returns the share of dark pixels of a PNG.
fn dark_share(png: &[u8]) -> f64 {
    let mut reader = png::Decoder::new(Cursor::new(png)).read_info().unwrap();
    let mut picture = vec![0; reader.output_buffer_size().unwrap()];
    let frame = reader.next_frame(&mut picture).unwrap();
    let pixels = picture[..frame.buffer_size()].chunks(frame.color_type.samples());
    let (count, dark) = (pixels.len(), pixels.filter(|pixel| pixel[0] < 160).count());
    dark as f64 / count as f64
}

#[test]
fn tables_are_written() {
    for name in TABLES {
        let text = read(&format!("{name}.csv"));
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let width = reader.headers().unwrap().len();
        let rows: Vec<_> = reader.records().map(Result::unwrap).collect();
        assert!(rows.len() > 1 && rows.iter().all(|row| row.len() == width), "{name}");
    }
    assert!(read("table5.csv").starts_with("n,DIM: ancf (mm),DIM: paper (mm),"));
    assert_eq!(fs::read_dir(&*REPORT).unwrap().filter(|file| hidden(file.as_ref().unwrap())).count(), 0);
}

/// True for a temporary file.
fn hidden(file: &fs::DirEntry) -> bool {
    file.file_name().to_string_lossy().starts_with('.')
}

#[test]
fn page_is_complete_and_self_contained() {
    let page = read("index.html");
    for name in FIGURES {
        assert!(page.contains(&format!("<figure id=\"{name}\">")), "{name}");
    }
    for name in TABLES {
        assert!(page.contains(&format!("href=\"{name}.csv\"")), "{name}");
    }
    let targets = [" href=\"", " src=\""].into_iter().flat_map(|attribute| page.split(attribute).skip(1));
    for target in targets.filter_map(|rest| rest.split('"').next()) {
        let is_there = match target.strip_prefix('#') {
            Some(id) => page.contains(&format!("id=\"{id}\"")),
            None => REPORT.join(target).is_file(),
        };
        assert!(is_there, "{target} is not there");
    }
    let ids: Vec<&str> = page.split(" id=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    assert!(ids.iter().all(|id| ids.iter().filter(|other| *other == id).count() == 1), "{ids:?}");
    for remote in ["<script", "<link", "@import", "url(", "src=\"http", "href=\"http"] {
        assert!(!page.contains(remote), "{remote}");
    }
    assert!(page.contains("All 23 printed numbers that do not depend on the machine are reproduced"));
}

#[test]
fn results_have_all_keys() {
    for name in ["table3", "table4", "table5", "table7"] {
        let table = &RESULTS[name];
        assert_eq!(table["n"], Value::from(ELEMENTS.to_vec()), "{name}");
        assert_eq!(
            [table["dim"].clone(), table["nondim"].clone()].map(|x| numbers(&x).len()),
            [6, 6],
            "{name}"
        );
    }
    for key in ["paper_dim", "paper_nondim"] {
        assert_eq!([&RESULTS["table4"], &RESULTS["table5"]].map(|table| numbers(&table[key]).len()), [6, 6]);
    }
    assert_eq!(numbers(&RESULTS["table7"]["ratio"]).len(), 6);
    let times = &RESULTS["table6"];
    assert_eq!(times["paper_seconds_dim"], 37.62);
    assert!(times["seconds_nondim"].as_f64().unwrap() > 0.0);
    assert_eq!(RESULTS["repeats"], 1);
    assert!(RESULTS["machine"]["processor"].is_string());
    assert_eq!(RESULTS["gain"].as_array().unwrap().len(), 13);
    assert_eq!(RESULTS["tolerances"].as_array().unwrap().len(), 10);
}

#[test]
fn table_3() {
    assert_near(&RESULTS["table3"]["nondim"], &[0.32, 0.45, 0.71, 1.01, 1.24, 1.43], 0.005);
    assert_near(&RESULTS["table3"]["paper_nondim"], &[0.32, 0.45, 0.71, 1.01, 1.24, 1.43], 0.0);
}

#[test]
fn table_5() {
    let table = &RESULTS["table5"];
    assert_near(&table["dim"], &[-1.357, -1.870, -2.014, -2.032, -2.036, -2.037], 0.002);
    assert_near(&table["nondim"], &[-1.356, -1.872, -2.015, -2.032, -2.036, -2.037], 0.002);
}

#[test]
fn table_6() {
    let table = &RESULTS["table6"];
    assert_near(&table["dim"], &[2001.0], 0.0);
    assert_near(&table["nondim"], &[6263.0], 0.0);
    assert!((table["step_nondim"].as_f64().unwrap() - 0.00032).abs() < 5e-6);
}

/// The paper: "approximately 80 iterations" and "one or two".
#[test]
fn figure_7() {
    let figure = &RESULTS["fig7"];
    let most = |counts: &Value| numbers(counts).into_iter().fold(0.0, f64::max);
    assert!(most(&figure["dim"]) > 40.0 && most(&figure["nondim"]) <= 3.0);
    let blind = &figure["unit_blind"];
    assert!(most(&blind["dim"]) <= 4.0 && most(&blind["nondim"]) <= 4.0);
    for (t, counts) in [("t_dim", "dim"), ("t_nondim", "nondim")] {
        assert_eq!(numbers(&figure[t]).len(), numbers(&figure[counts]).len());
    }
    assert_eq!([numbers(&blind["dim"]).len(), numbers(&blind["nondim"]).len()], [2000, 6262]);
}

#[test]
fn both_forms_have_equal_motions_with_equal_steps() {
    for gain in RESULTS["gain"].as_array().unwrap() {
        assert!(gain["tip_difference"].as_f64().unwrap() < 1e-9, "{gain}");
        let factor = |name: &str| gain[name].as_f64().unwrap();
        let product = factor("longer_step") * factor("fewer_iterations") * factor("faster_iteration");
        assert!((product / factor("total") - 1.0).abs() < 1e-12, "{gain}");
    }
}

/// n, h, and the condition numbers of all forms, rounded. Independent calculation: dense matrices, inverse of the
/// equilibrated matrix.
const CONDITION: [(u64, f64, [f64; 7]); 3] = [
    (1, 1e-3, [9.611e8, 9.611e8, 3.882e7, 1.693e6, 1.001e15, 1.693e6, 3.911e5]),
    (20, 1e-3, [8.4e10, 2.9e10, 2.1e10, 6.9e8, 3.9e16, 6.9e8, 3.5e5]),
    (20, 1e-6, [3.5e14, 1.8e13, 3.6e13, 2.3e6, 1.1e22, 2.3e6, 26.0]),
];

#[test]
fn condition_numbers() {
    let rows = RESULTS["conditioning"]["stiff"].as_array().unwrap();
    for (n, h, expected) in CONDITION {
        let row = rows.iter().find(|row| row["n"] == n && row["h"] == h).unwrap();
        for (ours, reference) in numbers(&row["condition"]).iter().zip(expected) {
            let factor = ours / reference;
            assert!((0.5..2.0).contains(&factor), "n = {n}, h = {h}: {ours} is not {reference}");
        }
    }
}

#[test]
fn a_folder_that_cannot_be_created_is_reported_before_the_runs() {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("no-folder");
    fs::write(&file, "").unwrap();
    let output = ancf(&file.join("report")).output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).contains("no-folder"));
}
