//! Runs and checks: files, messages, exit codes.

use std::fs;
use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};

use crate::run_folder::{RunFolder, assert_near, command, root, stderr};

/// Command of the README. Mean tip deflection: Kim et al. (2017), Table 5, 20 elements, -2.037 mm.
#[test]
fn the_cantilever_runs_as_the_readme_says() {
    let folder = RunFolder::new();
    let run = folder.run("models/cantilever.toml").output().unwrap();
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    let tip = folder.column("tip.y");
    assert_eq!(tip.len(), 2001);
    let mean = 1e3 * tip.iter().sum::<f64>() / tip.len() as f64;
    assert!((mean + 2.037).abs() < 2e-3, "mean deflection {mean} mm");
    assert_eq!(folder.summary()["outcome"]["kind"], "finished");
    assert_eq!(folder.summary()["steps"], 2000);
}

/// Every model in `models/` is valid and runs. Motions run for 0.1 s; their physics is tested elsewhere.
#[test]
fn every_model_runs() {
    let entries = fs::read_dir(root().join("models")).unwrap().map(|entry| entry.unwrap().path());
    let (models, others): (Vec<_>, Vec<_>) = entries
        .filter(|path| path.is_file())
        .partition(|path| path.extension().is_some_and(|ending| ending == "toml"));
    for path in models {
        let (folder, text) = (RunFolder::new(), fs::read_to_string(&path).unwrap());
        for mesh in &others {
            fs::copy(mesh, folder.0.path().join(mesh.file_name().unwrap())).unwrap();
        }
        let duration = text.lines().find(|line| line.starts_with("duration"));
        let text = duration.map_or(text.clone(), |line| text.replace(line, "duration = 0.1"));
        let short = folder.0.path().join("short.toml");
        fs::write(&short, text).unwrap();
        let run = folder.run(short.to_str().unwrap()).output().unwrap();
        assert_eq!(run.status.code(), Some(0), "{}: {}", path.display(), stderr(&run));
    }
}

/// Runs a model of `models/` and returns standard error and standard output.
fn ran(folder: &RunFolder, model: &str) -> (String, String) {
    let run = folder.run(&format!("models/{model}.toml")).output().unwrap();
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    (stderr(&run), String::from_utf8(run.stdout).unwrap())
}

/// Returns x, y and z of a probe in the last row.
fn last(folder: &RunFolder, probe: &str) -> [f64; 3] {
    ["x", "y", "z"].map(|axis| *folder.column(&format!("{probe}.{axis}")).last().unwrap())
}

/// Tips as in the comments of the models. Elastica: Bisshopp & Drucker (1945); bend: Romero (2004).
#[test]
fn equilibria_are_reported() {
    let folder = RunFolder::new();
    let (messages, printed) = ran(&folder, "elastica");
    let (mesh, done) = messages.split_once('\n').unwrap();
    assert!(mesh.starts_with("mesh: displacement of `tip` ") && mesh.contains("(better: tip."), "{mesh}");
    assert!(
        done.starts_with("done: equilibrium at load factor 1 in ") && printed.is_empty(),
        "{messages}{printed}"
    );
    assert_near(&last(&folder, "tip"), &[0.445004, -0.810609, 0.0], 5e-6);
    let (messages, _) = ran(&folder, "arc");
    assert!(
        messages.contains("\ndone: equilibrium at load factor 1, ")
            && messages.contains(" Newton iterations, "),
        "{messages}"
    );
    assert_near(&last(&folder, "tip"), &[47.15, 15.69, 53.47], 0.02);
}

/// Lee's frame: the loads at the limit points by a planar rod without shear, to 1 % of the larger. The smallest load differs
/// by 0.6 %, more than in `crates/ancf/tests/paths.rs`, which states the joints explicitly: to be explained.
#[test]
fn an_equilibrium_path_is_reported() {
    let folder = RunFolder::new();
    let (messages, _) = ran(&folder, "lees_frame");
    assert!(messages.contains(" points to load factor 2.5, 2 limit points, "), "{messages}");
    let (load, limit) = (folder.column("load"), folder.column("limit"));
    let limits: Vec<f64> =
        load.iter().zip(&limit).filter(|(_, limit)| **limit != 0.0).map(|(load, _)| *load).collect();
    assert_near(&limits, &[1.85567, -0.94144], 0.01 * 1.85567);
}

/// Euler (1744): 1017.5 N and nine times as much, each twice.
#[test]
fn critical_loads_are_reported_and_printed() {
    let folder = RunFolder::new();
    let (messages, printed) = ran(&folder, "column");
    assert!(messages.contains("\ndone: 6 critical load factors, 1017."), "{messages}");
    assert!(messages.starts_with("mesh: load factor "), "{messages}");
    let factors: Vec<f64> = printed
        .lines()
        .skip(1)
        .map(|line| line.split_whitespace().nth(1).unwrap().parse().unwrap())
        .collect();
    let euler = std::f64::consts::PI.powi(2) * 2.1e11 * std::f64::consts::PI * 0.02_f64.powi(4) / 64.0 / 16.0;
    assert_near(
        &factors.iter().map(|factor| factor / euler).collect::<Vec<_>>(),
        &[1.0, 1.0, 9.0, 9.0, 25.0, 25.0],
        0.06,
    );
    assert!(printed.starts_with("mode     load factor  too high by\n   1"), "{printed}");
}

#[test]
fn modes_are_reported_and_printed() {
    let (messages, printed) = ran(&RunFolder::new(), "tuning_fork");
    assert!(messages.starts_with("mesh: frequency 7 about 0.41 % too low (better: 441.5"), "{messages}");
    assert!(messages.contains("\ndone: 12 modes, 6 rigid, "), "{messages}");
    let lines: Vec<&str> = printed.lines().collect();
    assert_eq!((lines.len(), lines[6]), (13, "   6           rigid"), "{printed}");
    let is_aligned = |line: &&str| line.chars().count() == 33;
    assert!(lines[..1].iter().chain(&lines[7..]).all(is_aligned), "aligned: {printed}");
}

/// An unsupported model has no equilibrium: exit code 1, load factor and free motion.
#[test]
fn a_failed_equilibrium_is_reported() {
    let folder = RunFolder::new();
    let text = fs::read_to_string(root().join("models/arc.toml")).unwrap();
    let path = folder.0.path().join("loose.toml");
    fs::write(&path, text.replace("kind = \"clamp\"", "kind = \"spherical\"")).unwrap();
    let run = folder.run(path.to_str().unwrap()).output().unwrap();
    assert_eq!(run.status.code(), Some(1));
    let messages = stderr(&run);
    assert!(messages.starts_with("failed at load factor 0: the model has no equilibrium"), "{messages}");
    assert!(
        messages.contains("body `bend` can rotate") && messages.contains("\nno equilibrium, "),
        "{messages}"
    );
}

/// Bad input: message with file, line, column, key, value found and value required; exit code 2; no folder.
#[test]
fn bad_input_is_rejected() {
    let density = "density = 8030.0";
    let cases = [
        (density, "denstiy = 8030.0", ":11:1: materials.steel.denstiy: found unknown key `denstiy`"),
        (
            density,
            "density = -8030.0",
            ":11:11: materials.steel.density: found -8030.0, expected a number > 0",
        ),
        (
            density,
            "density = nan",
            ":11:11: materials.steel.density: found nan, expected a finite number > 0",
        ),
        ("elements = 20", "elements = 0", ":24:12: bodies[0].elements: found 0, expected an integer >= 1"),
        ("to = [1.0, 0.0, 0.0]", "to = [0, 0, 0]", ":23:6: bodies[0].to: found a beam of length 0"),
        ("section = \"rod\"", "", "bodies[0].section: found no key `section`"),
        ("{ body = \"beam\"", "{ body = \"bean\"", ":32:14: joints[0].a.body: found \"bean\""),
    ];
    for (line, by, message) in cases {
        let folder = RunFolder::new();
        let run = folder.run(&folder.cantilever(line, by)).output().unwrap();
        assert_eq!(run.status.code(), Some(2), "{by}");
        assert!(stderr(&run).contains(message), "{by}: {}", stderr(&run));
        assert!(!folder.out().exists(), "{by}: an output folder");
    }
}

/// The program supplies no external functions: it reports the functions that a model needs.
#[test]
fn external_functions_are_rejected() {
    let (folder, file) = (RunFolder::new(), "crates/ancf/tests/models/good/external.toml");
    for mut command in [command(&["check", file]), folder.run(file)] {
        let output = command.output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
        let messages = stderr(&output);
        assert_eq!(messages.lines().count(), 5, "{messages}");
        let motor = "external.toml:30:59: joints[0].drive.time.name: found the external function \"motor\", expected a function \
                     that the program supplies under this name\n";
        assert!(messages.contains(motor), "{messages}");
    }
    assert!(!folder.out().exists(), "an output folder");
    assert_eq!(command(&["scaled", file]).output().unwrap().status.code(), Some(0));
}

/// Failed analysis: exit code 1, message with time, reason and location, results so far.
#[test]
fn a_failed_analysis_keeps_its_results() {
    let folder = RunFolder::new();
    let absolute = "step = 1e-3\nmax_halvings = 1\nstop = { rule = \"residual\", tolerance = 1e-13 }";
    let run = folder.run(&folder.cantilever("step = 1e-3", absolute)).output().unwrap();
    assert_eq!(run.status.code(), Some(1), "{}", stderr(&run));
    assert!(
        stderr(&run).contains("failed at t = ") && stderr(&run).contains("did not converge"),
        "{}",
        stderr(&run)
    );
    assert_eq!(folder.summary()["outcome"]["kind"], "failed");
    let steps = folder.summary()["steps"].as_u64().unwrap();
    assert_eq!(folder.column("t").len() as u64, steps + 1, "every step that was solved is there");
}

/// Ctrl-C: exit code 130 and the results so far.
#[cfg(unix)]
#[test]
fn an_interrupt_keeps_its_results() {
    let folder = RunFolder::new();
    let mut run = folder.run(&folder.cantilever("duration = 2.0", "duration = 1000.0")).spawn().unwrap();
    let csv = folder.out().join("probes.csv");
    while fs::metadata(&csv).map_or(0, |file| file.len()) == 0 {
        assert!(run.try_wait().unwrap().is_none(), "the run ended before the interrupt");
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    Command::new("kill").args(["-INT", &run.id().to_string()]).status().unwrap();
    assert_eq!(run.wait().unwrap().code(), Some(130));
    assert_eq!(folder.summary()["outcome"]["kind"], "stopped");
    assert_eq!(folder.column("t").len() as u64, folder.summary()["steps"].as_u64().unwrap() + 1);
}

/// The scaled model is a valid model with the numbers of eqs (7), (26), (33) of Kim et al. (2017).
#[test]
fn the_scaled_model_is_printed() {
    let printed = command(&["scaled", "models/revolute_pendulum.toml"]).output().unwrap();
    assert!(printed.status.success());
    let model: toml::Table = String::from_utf8(printed.stdout).unwrap().parse().unwrap();
    let number = |path: [&str; 3]| model[path[0]][path[1]][path[2]].as_float().unwrap();
    let area = std::f64::consts::FRAC_PI_4 * 0.02 * 0.02;
    let force = 8030.0 * area * 9.81 / 4.0;
    assert!((number(["materials", "steel", "young"]) / (193e9 / force) - 1.0).abs() < 1e-12);
    assert!((number(["materials", "steel", "density"]) * area - 1.0).abs() < 1e-12, "rho A = 1 by eq. (7)");
    assert!((model["gravity"][1].as_float().unwrap() * 0.25 + 1.0).abs() < 1e-12, "an element weighs 1");
}

/// Without `-o` the folder has the name of the file, unless it contains other files.
#[test]
fn results_have_a_folder_by_default() {
    let place = tempfile::TempDir::new().unwrap();
    fs::copy(root().join("models/elastica.toml"), place.path().join("elastica.toml")).unwrap();
    let run = || {
        let mut command = command(&["run", "elastica.toml"]);
        command.current_dir(place.path()).output().unwrap()
    };
    for _ in 0..2 {
        let ended = run();
        assert!(stderr(&ended).contains("results in elastica"), "{}", stderr(&ended));
        assert!(place.path().join("elastica/summary.json").is_file());
    }
    fs::remove_dir_all(place.path().join("elastica")).unwrap();
    fs::create_dir(place.path().join("elastica")).unwrap();
    fs::write(place.path().join("elastica/notes.txt"), "mine").unwrap();
    let refused = run();
    assert_eq!(refused.status.code(), Some(2));
    assert!(stderr(&refused).contains("choose the folder of the results with `-o`"), "{}", stderr(&refused));
    assert_eq!(fs::read_dir(place.path().join("elastica")).unwrap().count(), 1);
}

/// `--open` writes the report and passes it to the browser.
#[cfg(target_os = "linux")]
#[test]
fn the_report_opens_in_the_browser() {
    use std::os::unix::fs::PermissionsExt;
    let folder = RunFolder::new();
    let browser = folder.0.path().join("xdg-open");
    fs::write(&browser, "#!/bin/sh\necho \"$1\" > \"$(dirname \"$0\")/opened.part\"\nmv \"$(dirname \"$0\")/opened.part\" \"$(dirname \"$0\")/opened\"\n").unwrap();
    fs::set_permissions(&browser, fs::Permissions::from_mode(0o755)).unwrap();
    let path = format!("{}:{}", folder.0.path().display(), std::env::var("PATH").unwrap());
    let file = root().join("models/elastica.toml");
    let ended = folder.run(file.to_str().unwrap()).arg("--open").env("PATH", path).output().unwrap();
    assert!(ended.status.success(), "{}", stderr(&ended));
    let report = folder.out().join("report.html");
    assert!(report.is_file());
    let opened = folder.0.path().join("opened");
    let since = std::time::Instant::now();
    while !opened.exists() && since.elapsed().as_secs() < 30 {
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    assert_eq!(fs::read_to_string(opened).unwrap().trim(), report.to_str().unwrap());
}

/// A run states the size of large result files before it writes them. 10⁶ steps of the cantilever with 27 columns of 15 bytes in
/// text and 6 bytes in Parquet.
#[test]
fn large_results_are_announced() {
    let folder = RunFolder::new();
    let long = folder.cantilever("duration = 2.0", "duration = 1000.0");
    let mut run = folder.run(&long).stderr(Stdio::piped()).spawn().unwrap();
    let mut first = String::new();
    BufReader::new(run.stderr.take().unwrap()).read_line(&mut first).unwrap();
    run.kill().unwrap();
    let _ = run.wait().unwrap();
    assert_eq!(
        first,
        "warning: the results will have about 568 MB: 1000001 rows of 27 columns; `output.every` or `output.interval` records \
         fewer rows, and `output.csv = false` omits the text file of 405 MB\n"
    );
}

/// The expected sizes of result files are those of the files, to a half.
#[test]
fn expected_sizes_are_those_of_the_files() {
    for name in ["cantilever", "robot_arm"] {
        let folder = RunFolder::new();
        let file = format!("models/{name}.toml");
        let run = folder.run(&file).output().unwrap();
        assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
        let model = ancf::Model::read(root().join(&file)).unwrap();
        let simulation = ancf::Simulation::new(&model).unwrap();
        let recorder =
            ancf_results::Recorder::new(ancf_results::Folder::new(folder.out()), "", "", &model, &simulation);
        let size = recorder.expected_size(&model);
        for (expected, file) in
            [(size.csv, "probes.csv"), (size.results, "results.parquet"), (size.states, "states.parquet")]
        {
            let bytes = fs::metadata(folder.out().join(file)).unwrap().len() as f64;
            assert!(
                (0.67..1.5).contains(&(expected / bytes)),
                "{name}, {file}: {expected} instead of {bytes}"
            );
        }
    }
}

/// A motion of few rows has no more states than rows.
#[test]
fn expected_states_are_at_most_the_rows() {
    let folder = RunFolder::new();
    let size = |duration: &str| {
        let model = ancf::Model::read(folder.cantilever("duration = 2.0", duration)).unwrap();
        let simulation = ancf::Simulation::new(&model).unwrap();
        let folder = ancf_results::Folder::new(folder.out());
        ancf_results::Recorder::new(folder, "", "", &model, &simulation).expected_size(&model)
    };
    let (long, short) = (size("duration = 2.0"), size("duration = 0.005"));
    assert_near(&[long.rows, short.rows], &[2001.0, 6.0], 0.0);
    assert_near(&[long.states / short.states], &[200.0 / 6.0], 1e-9);
}
