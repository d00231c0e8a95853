//! Cases of a study: samples, lists, parts.

use std::fs;
use std::path::Path;
use std::process::Command;

use super::folder::{StudyFolder, TIP, float, stderr, table, text};

/// Samples depend on the seed only, fill the intervals of a Latin hypercube, and are repeated for every combination.
#[test]
fn samples_fill_their_range() {
    let study = |seed: u32, sampling: &str| {
        format!(
            "samples = 20\nseed = {seed}\nsampling = \"{sampling}\"\n[parameters]\nelements = [1, 2]\n\
             \"gravity[1]\" = {{ kind = \"uniform\", low = -10, high = 0 }}{TIP}"
        )
    };
    let folder = StudyFolder::new(&study(1, "latin_hypercube"));
    folder.run(&["-q", "-j", "1"], 0);
    let (elements, first) = (folder.column("elements"), folder.column("gravity[1]"));
    let tips = folder.column("tip");
    assert!(elements[..20].iter().all(|n| *n == 1.0) && elements[20..].iter().all(|n| *n == 2.0));
    assert_eq!(first[..20], first[20..], "the same samples with every combination");
    let mut intervals: Vec<_> = first[..20].iter().map(|x| ((x + 10.0) * 2.0) as usize).collect();
    intervals.sort_unstable();
    assert_eq!(intervals, (0..20).collect::<Vec<_>>());

    fs::remove_file(folder.file("out/cases.parquet")).unwrap();
    folder.run(&[], 0);
    assert_eq!(
        (folder.column("gravity[1]"), folder.column("tip")),
        (first, tips),
        "with any number of threads"
    );
    folder.state(&study(2, "latin_hypercube"));
    assert!(folder.run(&[], 0).starts_with("done: 40 cases, "));
    for sampling in ["random", "sobol"] {
        folder.state(&study(1, sampling));
        assert!(folder.run(&[], 0).starts_with("done: 40 cases, "));
        folder.state(&study(1, sampling).replace("samples = 20", "samples = 30"));
        assert!(folder.run(&[], 0).starts_with("done: 60 cases (40 taken over), "));
    }
}

/// Zipped lists; values of several types in their columns.
#[test]
fn lists_may_be_zipped() {
    let folder = StudyFolder::new(&format!(
        "combine = \"zip\"\n[parameters]\nelements = {{ kind = \"logarithmic\", from = 1, to = 4, count = 3 }}\n\
         gravity = [[0, -1, 0], [0, -2, 0], [0, -3, 0]]\n\"bodies.beam.to[2]\" = [0, 0.5, 1]{TIP}"
    ));
    folder.run(&[], 0);
    let cases = folder.cases();
    assert_eq!(folder.column("elements"), [1.0, 2.0, 4.0]);
    assert_eq!(cases.iter().map(|row| text(row, "gravity")).collect::<Vec<_>>()[1], "[0, -2, 0]");
    assert_eq!(folder.column("bodies.beam.to[2]"), [0.0, 0.5, 1.0]);
}

/// Parts of a study are written into separate files, which a run of all cases takes over.
#[test]
fn parts_make_the_whole() {
    let folder = StudyFolder::new(&format!("parameters.elements = [1, 2, 3, 4, 5]{TIP}"));
    assert!(folder.run(&["--index", "2/2"], 0).starts_with("done: 2 cases, "));
    let part = table(&folder.file("out/cases-2-of-2.parquet"));
    assert_eq!(part.iter().map(|row| float(row, "case")).collect::<Vec<_>>(), [1.0, 3.0]);
    folder.run(&["--index", "1/2"], 0);
    // Another division has its own files.
    assert!(folder.run(&["--index", "2/3"], 0).starts_with("done: 2 cases (2 taken over), "));
    assert_eq!(table(&folder.file("out/cases-2-of-2.parquet")), part);
    assert!(!folder.file("out/cases.parquet").exists());
    assert!(folder.run(&[], 0).starts_with("done: 5 cases (5 taken over), "));
    assert_eq!(folder.column("elements"), [1.0, 2.0, 3.0, 4.0, 5.0]);
    for wrong in ["0/2", "3/2", "2", "a/b"] {
        assert!(folder.run(&["--index", wrong], 2).contains("expected K/N with K from 1 to N"));
    }
}

/// The studies in `models/studies/` run. The cantilever converges as stated in its comment.
#[test]
fn the_examples_run() {
    let studies = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models/studies");
    let folder = StudyFolder::new("");
    for entry in fs::read_dir(studies).unwrap() {
        let path = entry.unwrap().path();
        let out = folder.file(path.file_stem().unwrap().to_str().unwrap());
        let mut study = Command::new(env!("CARGO_BIN_EXE_ancf"));
        let run = study.arg("study").arg(&path).arg("-o").arg(out).output().unwrap();
        assert_eq!(run.status.code(), Some(0), "{}: {}", path.display(), stderr(&run));
    }
    for row in table(&folder.file("convergence/cases.parquet")) {
        let (n, tip) = (float(&row, "elements"), float(&row, "tip"));
        let missing = 1.0 + tip / 2.041e-3;
        assert!((missing * 3.0 * n * n - 1.0).abs() < 0.1 || missing < 5e-3, "{n} elements: {missing}");
    }
}
