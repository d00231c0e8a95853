//! Estimated errors: refinement of meshes and columns of errors.

use std::fs;

use crate::run_folder::{RunFolder, assert_near, root, stderr};

/// The bodies are refined until the estimated error is as small as requested. The model in the results has the last numbers of elements.
#[test]
fn a_mesh_is_refined_to_a_wanted_error() {
    let folder = RunFolder::new();
    let text = fs::read_to_string(root().join("models/elastica.toml")).unwrap();
    let path = folder.0.path().join("coarse.toml");
    fs::write(&path, text.replace("elements = 32", "elements = 2 # few")).unwrap();
    let run = folder.run(path.to_str().unwrap()).args(["--to", "0.1%"]).output().unwrap();
    let messages = stderr(&run);
    assert!(
        run.status.success() && messages.starts_with("mesh 1: elements `wire` 2; error 2 %\n"),
        "{messages}"
    );
    let summary = folder.summary();
    let meshes = summary["meshes"].as_array().unwrap();
    let errors: Vec<f64> = meshes.iter().map(|mesh| mesh["error"].as_f64().unwrap()).collect();
    assert!(errors.windows(2).all(|pair| pair[1] < pair[0]) && errors[errors.len() - 1] < 1e-3, "{errors:?}");
    // The elastica of P L²/EI = 10: 0.810609 L (Bisshopp & Drucker 1945).
    let column = folder.column("tip.y");
    assert_near(&column[column.len() - 1..], &[-0.810609], 1e-3);
    let last = meshes[meshes.len() - 1]["elements"][0][1].as_u64().unwrap();
    assert_eq!(summary["errors"]["elements"].as_u64(), Some(last));
}

/// `--errors` adds the columns of the errors, also to the model in the results. Without it a motion says that nothing is estimated.
#[test]
fn errors_of_a_motion_are_estimated_on_request() {
    let folder = RunFolder::new();
    let text = fs::read_to_string(root().join("models/rotor.toml")).unwrap();
    let path = folder.0.path().join("short.toml");
    fs::write(&path, text.replace("duration = 0.3 ", "duration = 0.002 ")).unwrap();
    let plain = folder.run(path.to_str().unwrap()).output().unwrap();
    assert!(stderr(&plain).contains("errors: not estimated; `--errors`"), "{}", stderr(&plain));
    assert!(folder.summary().get("motion_errors").is_none());
    let run = folder.run(path.to_str().unwrap()).arg("--errors").output().unwrap();
    let messages = stderr(&run);
    assert!(
        run.status.success() && messages.contains("time steps") && messages.contains("mesh"),
        "{messages}"
    );
    let errors = folder.column("middle.z_error");
    assert!(errors[0] == 0.0 && errors.iter().skip(1).all(|error| error.is_finite()), "{errors:?}");
    let summary = folder.summary();
    let last = summary["motion_errors"]["values"].as_array().unwrap();
    let last = last.iter().find(|value| value["column"] == "middle.z").unwrap();
    assert_near(&[errors[errors.len() - 1]], &[last["error"].as_f64().unwrap()], 1e-12);
    let rope = root().join("models/belt.toml");
    let refused = folder.run(rope.to_str().unwrap()).arg("--errors").output().unwrap();
    assert_eq!(refused.status.code(), Some(2));
    assert!(stderr(&refused).contains("true with contacts"), "{}", stderr(&refused));
}

/// Poisson locking: no mesh reaches the error. Motions are not refined.
#[test]
fn an_error_that_no_mesh_reaches_is_reported() {
    let folder = RunFolder::new();
    let text = fs::read_to_string(root().join("models/elastica.toml")).unwrap();
    let path = folder.0.path().join("locked.toml");
    let body = "kind = \"beam\"\nformulation = \"continuum\"";
    let text = text.replacen("kind = \"cable\"", body, 1).replace("elements = 32", "elements = 8");
    let text = text.replace("young = 2.1e11", "poisson = 0.3\nyoung = 2.1e11").replace("0.103084", "0.003");
    fs::write(&path, &text).unwrap();
    let run = folder.run(path.to_str().unwrap()).args(["--to", "1%"]).output().unwrap();
    let messages = stderr(&run);
    assert!(run.status.success(), "{messages}\n{text}");
    assert!(messages.contains("warning: the error of 1 % is not reached: "), "{messages}");
    let run =
        folder.run(root().join("models/bow.toml").to_str().unwrap()).args(["--to", "1%"]).output().unwrap();
    assert_eq!(run.status.code(), Some(2));
    assert!(
        stderr(&run).contains("--to: refines the meshes of statics, modes and buckling"),
        "{}",
        stderr(&run)
    );
}
