//! `--json` and `--quiet`.

use std::fs;

use crate::folder::{TestFolder, root};

#[test]
fn checks_answer_in_json() {
    let folder = TestFolder::new();
    folder.printed(&["new", "model.toml", "-k", "mechanism"]);
    let right = folder.ancf(&["check", "model.toml", "--json", "-q"]);
    assert_eq!((right.code, right.messages.as_str()), (Some(0), ""));
    let json = right.json();
    assert_eq!(
        (json["errors"].as_array().unwrap().len(), json["diagnosis"]["joints"]["revolute"].as_u64()),
        (0, Some(2))
    );
    folder.write("model.toml", &folder.read("model.toml").replacen("mass = 0.36", "mas = 0.36", 1));
    let wrong = folder.ancf(&["check", "model.toml", "--json"]);
    assert_eq!(wrong.code, Some(2));
    assert!(wrong.messages.contains("found unknown key `mas`"), "also as text: {}", wrong.messages);
    let json = wrong.json();
    let fault = &json["errors"]
        .as_array()
        .unwrap()
        .iter()
        .find(|fault| fault["found"] == "unknown key `mas`")
        .unwrap();
    let line = folder.read("model.toml").lines().position(|line| line.starts_with("mas = ")).unwrap() + 1;
    assert_eq!((fault["file"].as_str(), fault["line"].as_u64()), (Some("model.toml"), Some(line as u64)));
    assert_eq!((fault["column"].as_u64(), fault["path"].as_str()), (Some(1), Some("bodies[0].mas")));
    assert_eq!(fault["hint"], "did you mean `mass`?");
}

/// The JSON output agrees with `summary.json` and is the only output.
#[test]
fn runs_answer_in_json() {
    let folder = TestFolder::new();
    folder.printed(&["new", "model.toml", "-k", "modes"]);
    let run = folder.ancf(&["run", "model.toml", "-o", "out", "--json", "--quiet"]);
    assert_eq!((run.code, run.messages.as_str()), (Some(0), ""));
    let (json, summary) =
        (run.json(), serde_json::from_str::<serde_json::Value>(&folder.read("out/summary.json")).unwrap());
    assert_eq!((json["folder"].as_str(), &json["outcome"]), (Some("out"), &summary["outcome"]));
    assert_eq!((&json["steps"], json["frequency"].as_array().unwrap().len()), (&summary["steps"], 6));
    let again = folder.ancf(&["resume", "out", "--json"]).json();
    assert_eq!((again["folder"].as_str(), &again["steps"]), (Some("out"), &summary["steps"]));
}

#[test]
fn failures_answer_in_json() {
    let folder = TestFolder::new();
    folder.printed(&["new", "model.toml", "-k", "cable"]);
    // The cord has no supports.
    let text = folder.read("model.toml");
    let (head, tail) = (text.split_once("[[joints]]").unwrap().0, text.split_once("[[probes]]").unwrap().1);
    folder.write("model.toml", &format!("{head}[[probes]]{tail}"));
    let failed = folder.ancf(&["run", "model.toml", "-o", "out", "--json", "--quiet"]);
    assert_eq!(failed.code, Some(1));
    let json = failed.json();
    assert_eq!(json["outcome"]["kind"], "failed");
    assert!(json["outcome"]["reason"].as_str().is_some_and(|reason| !reason.is_empty()), "{json}");
    assert!(
        failed.messages.starts_with("failed at load factor 0"),
        "printed with --quiet: {}",
        failed.messages
    );
    for arguments in [
        &["run", "no.toml", "-o", "x", "--json"][..],
        &["resume", "x", "--json"],
        &["run", "--json"],
        &["plot", "x", "--json"],
    ] {
        let refused = folder.ancf(arguments);
        assert_eq!(refused.code, Some(2), "{arguments:?}");
        let message = refused.json()["errors"][0]["message"].clone();
        assert!(message.as_str().is_some_and(|message| !message.is_empty()), "{arguments:?}: {message}");
        assert!(!refused.messages.is_empty(), "{arguments:?}");
    }
}

#[test]
fn verifications_and_studies_answer_in_json() {
    let folder = TestFolder::new();
    let verified = folder.ancf(&["verify", "elastica", "-o", "look", "--json", "-q"]);
    assert_eq!((verified.code, verified.messages.as_str()), (Some(0), ""));
    let json = verified.json();
    assert_eq!(
        (json["holds"].as_bool(), json["problems"][0]["name"].as_str()),
        (Some(true), Some("elastica"))
    );
    fs::copy(root().join("models/elastica.toml"), folder.path("elastica.toml")).unwrap();
    folder.write(
        "study.toml",
        "model = \"elastica.toml\"\n[parameters]\n\"loads[0].force\" = [[0, -0.05, 0], [0, -0.1, 0]]\n[objectives]\ndown = { column = \"tip.y\", take = \"last\" }\n",
    );
    let study = folder.ancf(&["study", "study.toml", "-o", "cases", "--json", "-q"]);
    assert_eq!((study.code, study.messages.as_str()), (Some(0), ""), "{}", study.printed);
    let json = study.json();
    assert_eq!(
        (json["cases"].as_u64(), json["finished"].as_u64(), json["outcome"].as_str()),
        (Some(2), Some(2), Some("finished"))
    );
    let down = &json["objectives"]["down"];
    let number = |key: &str| down[key].as_f64().unwrap();
    assert!(
        -1.0 < number("least") && number("least") < number("mean") && number("mean") < number("largest"),
        "{down}"
    );
}

#[test]
fn quiet_is_quiet() {
    let folder = TestFolder::new();
    for arguments in [
        &["new", "model.toml", "-q"][..],
        &["-q", "check", "model.toml"],
        &["run", "model.toml", "-o", "out", "--quiet"],
        &["resume", "out", "-q"],
        &["plot", "out", "tip.y", "-o", "tip.svg", "-q"],
        &["man", "pages", "-q"],
    ] {
        let output = folder.ancf(arguments);
        assert_eq!((output.code, output.messages.as_str()), (Some(0), ""), "{arguments:?}");
    }
}
