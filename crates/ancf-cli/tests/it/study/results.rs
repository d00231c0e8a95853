//! `ancf report`, `plot` and `view` of a study.

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Command, Stdio};

use super::folder::{MODEL, StudyFolder, TIP, stderr};

/// Convergence of the static deflection of `continuum` elements: w = w∞ (1 − 1/(3 n²)), order 2 (Kim et al. 2017).
fn convergence() -> StudyFolder {
    let folder = StudyFolder::new(&format!("parameters.elements = [1, 8, 2, 4]{TIP}"));
    let statics = MODEL
        .replace("kind = \"dynamics\", duration = 0.05, step = 1e-3, start = \"zero\"", "kind = \"statics\"")
        .replace("elements = 2,", "elements = 2, formulation = \"continuum\",");
    fs::write(folder.file("model.toml"), statics).unwrap();
    folder.run(&[], 0);
    folder
}

fn ancf(folder: &StudyFolder, command: &str, more: &[&str]) -> String {
    let mut ancf = Command::new(env!("CARGO_BIN_EXE_ancf"));
    let output = ancf.arg(command).arg(folder.file("out")).args(more).output().unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    String::from_utf8(output.stdout).unwrap()
}

#[cfg(feature = "figures")]
#[test]
fn the_report_of_a_convergence_study_states_the_order() {
    let folder = convergence();
    ancf(&folder, "report", &[]);
    let page = fs::read_to_string(folder.file("out/report.html")).unwrap();
    assert_eq!(page.matches("<figure").count(), 2, "curve and errors");
    for part in ["4 of 4 cases finished.", "Study file", "1/elements"] {
        assert!(page.contains(part), "{part} is not in {page}");
    }
    let order = ["1.98", "1.99", "2.00", "2.01", "2.02"];
    assert!(order.iter().any(|order| page.contains(&format!("<td>{order}</td>"))), "{page}");
}

#[cfg(feature = "figures")]
#[test]
fn the_report_of_samples_has_distribution_and_sensitivity() {
    let folder = StudyFolder::new(&format!(
        "samples = 30\n[parameters]\n\"gravity[1]\" = {{ kind = \"uniform\", low = -10, high = -9 }}\n\
         \"materials.steel.young\" = {{ kind = \"uniform\", low = 1.9e11, high = 2e11 }}{TIP}"
    ));
    folder.run(&[], 0);
    ancf(&folder, "report", &[]);
    let page = fs::read_to_string(folder.file("out/report.html")).unwrap();
    assert_eq!(page.matches("<figure").count(), 3, "two scatter plots and a histogram");
    assert!(page.contains("Distribution of tip over 30 cases.") && page.contains("Sensitivity: "), "{page}");
}

/// Cases without a result are listed with their messages.
#[cfg(feature = "figures")]
#[test]
fn the_report_lists_failed_cases() {
    let folder =
        StudyFolder::new(&format!("parameters.\"joints.root.kind\" = [\"clamp\", \"revolute\"]{TIP}"));
    folder.run(&[], 1);
    ancf(&folder, "report", &[]);
    let page = fs::read_to_string(folder.file("out/report.html")).unwrap();
    assert!(page.contains("1 of 2 cases finished, 1 invalid."), "{page}");
    assert!(page.contains("Case 1, invalid: ") && page.contains("found no key `axis`"), "{page}");
}

/// The objective is plotted over the parameter, in the order of its values.
#[test]
fn objectives_are_plotted_over_the_parameter() {
    let folder = convergence();
    let listing = ancf(&folder, "plot", &[]);
    for part in ["case ", "elements ", "tip ", "seconds ", "4 rows"] {
        assert!(listing.contains(part), "{part} is not in {listing}");
    }
    let chart = ancf(&folder, "plot", &["tip"]);
    assert!(chart.starts_with("* tip\n") || chart.starts_with("tip\n"), "{chart}");
    assert!(chart.trim_end().ends_with("elements"), "{chart}");
    let chart = ancf(&folder, "plot", &["tip", "seconds", "--against", "case"]);
    assert_eq!(chart.matches("case\n").count(), 2, "one panel per column: {chart}");
}

#[cfg(feature = "figures")]
#[test]
fn the_page_of_a_study_is_served() {
    let folder = convergence();
    let mut view = Command::new(env!("CARGO_BIN_EXE_ancf"));
    let view = view.arg("view").arg(folder.file("out")).stdout(Stdio::piped()).stderr(Stdio::null());
    let mut view = view.spawn().unwrap();
    let mut address = String::new();
    BufReader::new(view.stdout.take().unwrap()).read_line(&mut address).unwrap();
    let address = address.trim().trim_start_matches("http://").trim_end_matches('/').to_owned();
    let mut stream = TcpStream::connect(&address).unwrap();
    stream.write_all(format!("GET / HTTP/1.1\r\nHost: {address}\r\n\r\n").as_bytes()).unwrap();
    let mut answer = String::new();
    stream.read_to_string(&mut answer).unwrap();
    view.kill().unwrap();
    view.wait().unwrap();
    assert!(answer.starts_with("HTTP/1.1 200") && answer.contains("4 of 4 cases finished."), "{answer}");
}
