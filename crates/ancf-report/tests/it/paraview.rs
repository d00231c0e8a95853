//! Files for ParaView contain the computed values, and their surfaces are closed.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};
use std::fs;
use std::io::Read;
use std::path::Path;

use ancf_report::Snapshot;
use ancf_report::paraview::{Writer, Written};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::read::ZlibDecoder;

use crate::common::{CANTILEVER, Run, dot, tapered, three};

/// Unstructured grid, read independently by the specification of VTK.
pub struct Grid {
    arrays: BTreeMap<String, Vec<f64>>,
    pub texts: BTreeMap<String, Vec<String>>,
}

impl Grid {
    fn read(path: &Path) -> Self {
        let text = fs::read_to_string(path).unwrap();
        let xml = roxmltree::Document::parse(&text).expect("well-formed");
        let mut grid = Self { arrays: BTreeMap::new(), texts: BTreeMap::new() };
        for node in
            xml.descendants().filter(|node| node.has_tag_name("DataArray") || node.has_tag_name("Array"))
        {
            let (name, bytes) = (node.attribute("Name").unwrap().to_owned(), unpacked(node.text().unwrap()));
            match node.attribute("type").unwrap() {
                "String" => {
                    let texts =
                        bytes.split(|byte| *byte == 0).map(|x| String::from_utf8(x.to_vec()).unwrap());
                    let mut texts: Vec<_> = texts.collect();
                    assert_eq!(texts.pop().as_deref(), Some(""), "each text ends with a zero byte");
                    grid.texts.insert(name, texts);
                }
                kind => drop(grid.arrays.insert(name, numbers(kind, &bytes))),
            }
        }
        let piece = xml.descendants().find(|node| node.has_tag_name("Piece")).expect("a piece");
        let count = |name: &str| piece.attribute(name).unwrap().parse::<usize>().unwrap();
        assert_eq!(count("NumberOfPoints"), grid.points().len());
        assert_eq!(count("NumberOfCells"), grid["types"].len());
        for array in
            piece.children().filter(|node| node.has_tag_name("PointData")).flat_map(|node| node.children())
        {
            let Some(name) = array.attribute("Name") else { continue };
            let width: usize = array.attribute("NumberOfComponents").unwrap().parse().unwrap();
            assert_eq!(grid[name].len(), width * grid.points().len(), "{name}");
        }
        grid
    }

    pub fn points(&self) -> Vec<[f64; 3]> {
        self.vectors("Points")
    }

    pub fn vectors(&self, name: &str) -> Vec<[f64; 3]> {
        self[name].chunks_exact(3).map(three).collect()
    }

    fn cells(&self) -> Vec<Vec<usize>> {
        let mut start = 0;
        let ends = self["offsets"].iter().map(|end| *end as usize);
        ends.map(|end| {
            let own = self["connectivity"][start..end].iter().map(|point| *point as usize).collect();
            start = end;
            own
        })
        .collect()
    }

    /// True if each edge occurs once in each direction.
    pub fn is_closed(&self) -> bool {
        let mut edges: BTreeMap<(usize, usize), i32> = BTreeMap::new();
        for cell in self.cells() {
            for k in 0..cell.len() {
                *edges.entry((cell[k], cell[(k + 1) % cell.len()])).or_default() += 1;
            }
        }
        edges.iter().all(|((a, b), count)| *count == 1 && edges.get(&(*b, *a)) == Some(&1))
    }

    /// Volume of a body, ∮ x·n dA/3 over its cells, divided into fans of triangles.
    pub fn volume(&self, body: usize) -> f64 {
        let points = self.points();
        let own = self.cells().into_iter().zip(&self["body"]).filter(|(_, owner)| **owner == body as f64);
        let fan = |cell: Vec<usize>| -> f64 {
            (2..cell.len()).map(|k| determinant([0, k - 1, k].map(|k| points[cell[k]])) / 6.0).sum()
        };
        own.map(|(cell, _)| fan(cell)).sum()
    }
}

impl std::ops::Index<&str> for Grid {
    type Output = Vec<f64>;

    fn index(&self, name: &str) -> &Vec<f64> {
        self.arrays.get(name).unwrap_or_else(|| panic!("no {name}"))
    }
}

fn determinant([a, b, c]: [[f64; 3]; 3]) -> f64 {
    dot(a, cross(b, c))
}

pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unpacked(text: &str) -> Vec<u8> {
    let (head, body) = text.trim().split_at(if text.trim().len() > 32 { 44 } else { 32 });
    let head = numbers("Int64", &STANDARD.decode(head).unwrap());
    if head[0] == 0.0 {
        return Vec::new();
    }
    let packed = STANDARD.decode(body).unwrap();
    assert_eq!((head[0], head[2], head[3]), (1.0, 0.0, packed.len() as f64));
    let mut bytes = Vec::new();
    ZlibDecoder::new(packed.as_slice()).read_to_end(&mut bytes).unwrap();
    assert_eq!(head[1], bytes.len() as f64);
    bytes
}

fn numbers(kind: &str, bytes: &[u8]) -> Vec<f64> {
    match kind {
        "Float64" => bytes.chunks_exact(8).map(|x| f64::from_le_bytes(x.try_into().unwrap())).collect(),
        "Float32" => {
            bytes.chunks_exact(4).map(|x| f32::from_le_bytes(x.try_into().unwrap()).into()).collect()
        }
        "Int64" => bytes.chunks_exact(8).map(|x| i64::from_le_bytes(x.try_into().unwrap()) as f64).collect(),
        "UInt8" => bytes.iter().map(|x| f64::from(*x)).collect(),
        other => panic!("unknown type of array: {other}"),
    }
}

/// Times and files of a collection.
fn collection(path: &Path) -> Vec<(f64, Grid)> {
    let text = fs::read_to_string(path).unwrap();
    let xml = roxmltree::Document::parse(&text).expect("well-formed");
    let sets = xml.descendants().filter(|node| node.has_tag_name("DataSet"));
    let read = |node: roxmltree::Node<'_, '_>| {
        let file = path.parent().unwrap().join(node.attribute("file").unwrap());
        (node.attribute("timestep").unwrap().parse().unwrap(), Grid::read(&file))
    };
    sets.map(read).collect()
}

pub fn write(run: &Run, folder: &Path) -> Written {
    let recording = run.recording();
    let mut writer = Writer::new(&recording, folder).expect("a folder");
    recording.frames.iter().for_each(|frame| writer.push(frame).expect("a file"));
    writer.finish().expect("collections")
}

pub fn written(run: &Run, name: &str) -> Vec<(f64, Grid)> {
    let folder = tempfile::tempdir().unwrap();
    let written = write(run, folder.path());
    assert_eq!(written.frames, run.frames.len());
    collection(&folder.path().join(name).with_extension("pvd"))
}

#[test]
fn frames_are_files_with_their_times() {
    let run = Run::of_file("models/cantilever.toml", 0.2, 7);
    for name in ["sections", "lines"] {
        let all = written(&run, name);
        let times: Vec<f64> = all.iter().map(|(time, _)| *time).collect();
        assert_eq!(times, run.frames.iter().map(|frame| frame.value).collect::<Vec<_>>());
        for (time, grid) in &all {
            assert_eq!(grid["TimeValue"], [*time]);
            assert_eq!(grid.texts["model"], [run.text.as_str()]);
            assert_eq!(grid.texts["sha256"][0].len(), 64);
            assert_eq!(grid.texts["bodies"], ["beam"]);
            assert!(grid.texts["units"][0].contains(r#""stress":"N/m²""#));
        }
        if name == "lines" {
            for (time, grid) in &all {
                let row = run.column("t").iter().position(|t| t == time).unwrap();
                for (field, columns) in [("Points", ["x", "y", "z"]), ("velocity", ["vx", "vy", "vz"])] {
                    let end = *grid.vectors(field).last().unwrap();
                    let probe = columns.map(|axis| run.column(&format!("tip.{axis}"))[row]);
                    (0..3).for_each(|k| {
                        assert!((end[k] - probe[k]).abs() < 1e-12, "{field}: {end:?}, {probe:?}");
                    });
                }
            }
        }
    }
}

/// The volume of a straight beam is the area of its polygonal outline times its length.
#[test]
fn surfaces_are_closed_and_hold_the_volumes_of_their_bodies() {
    let polygon = (TAU / 24.0).sin() / (TAU / 24.0);
    let kinds = [
        (r#"kind = "circle", diameter = 0.1"#, polygon * PI * 0.0025),
        (r#"kind = "tube", outer = 0.1, inner = 0.08"#, polygon * PI * 0.0009),
        (r#"kind = "rectangle", height = 0.1, width = 0.05"#, 0.005),
        (r#"kind = "ellipse", height = 0.1, width = 0.05"#, polygon * PI * 0.05 * 0.025),
    ];
    for (kind, area) in kinds {
        let text = CANTILEVER.replace("kind = \"rectangle\", height = 0.02, width = 0.01", kind);
        let mut run = Run::of(&text, 1);
        run.frames.insert(0, Snapshot { value: -1.0, state: run.simulation.assembly().initial() });
        let all = written(&run, "sections");
        assert!(all.iter().all(|(_, grid)| grid.is_closed()), "{kind}");
        let volume = all[0].1.volume(0);
        assert!((volume / (2.0 * area) - 1.0).abs() < 1e-12, "{kind}: {volume}, not {}", 2.0 * area);
    }
}

#[test]
fn tapers_are_closed_and_hold_their_volumes() {
    let mut run = Run::of(&tapered(), 1);
    run.frames = vec![Snapshot { value: 0.0, state: run.simulation.assembly().initial() }];
    let (_, grid) = &written(&run, "sections")[0];
    assert!(grid.is_closed());
    assert!((grid.volume(0) / (2.0 * 0.5 * (2e-4 + 1e-4)) - 1.0).abs() < 1e-12);
}

/// A tube whose outer and inner diameters change by different factors: ∫ π (R² − r²) ds with linear radii.
#[test]
fn tapered_tubes_hold_their_volumes() {
    for [outer, inner] in [[0.05, 0.03], [0.1, 0.04], [0.05, 0.08 * 0.5]] {
        let text = format!(
            r#"
            materials.s = {{ density = 7850, young = 2.1e11 }}
            sections.a = {{ kind = "tube", outer = 0.1, inner = 0.08 }}
            sections.b = {{ kind = "tube", outer = {outer}, inner = {inner} }}
            bodies = [{{ kind = "beam", name = "b", from = [0, 0, 0], to = [1, 0, 0], up = [0, 1, 0], elements = 4, section = "a", section_end = "b", material = "s" }}]
            joints = [{{ kind = "clamp", name = "c", a = {{ body = "b", at = "start" }} }}]
            analysis = {{ kind = "statics" }}
            "#
        );
        let mut run = Run::of(&text, 1);
        run.frames = vec![Snapshot { value: 0.0, state: run.simulation.assembly().initial() }];
        let (_, grid) = &written(&run, "sections")[0];
        assert!(grid.is_closed());
        let cone = |a: f64, b: f64| (a * a + a * b + b * b) / 12.0;
        // A regular polygon of 24 sides in a circle.
        let polygon = 12.0 * (TAU / 24.0).sin();
        let volume = polygon * (cone(0.1, outer) - cone(0.08, inner));
        assert!(
            (grid.volume(0) / volume - 1.0).abs() < 1e-5,
            "{outer}, {inner}: {}, not {volume}",
            grid.volume(0)
        );
    }
}

/// σ = N/A − M y/I on the surface, with M from the equilibrium of the remaining part in the deformed state.
#[test]
fn stress_on_the_skin_is_that_of_bending() {
    let run = Run::of(CANTILEVER, 1);
    let folder = tempfile::tempdir().unwrap();
    write(&run, folder.path());
    let read = |name: &str| collection(&folder.path().join(name)).pop().expect("a frame").1;
    let (lines, skin) = (read("lines.pvd"), read("sections.pvd"));
    let axis = lines.points();
    let (tip, (fx, fy)) = (*axis.last().unwrap(), (5.0, -0.003));
    let moment = |x: [f64; 3]| (tip[0] - x[0]) * fy - (tip[1] - x[1]) * fx;
    assert!((lines["N"][0] / fx - 1.0).abs() < 1e-4);
    assert!((lines["Mz"][0] / moment(axis[0]) - 1.0).abs() < 1e-4);
    let mut sides = [0; 2];
    // Stations at nodes, where section forces satisfy equilibrium.
    let stations: Vec<usize> = (0..axis.len()).step_by((axis.len() - 1) / 8).collect();
    for (k, point) in skin.points().into_iter().enumerate() {
        let Some(station) = stations.iter().find(|i| (lines["s"][**i] - skin["s"][k]).abs() < 1e-6) else {
            continue;
        };
        let y = if point[1] > axis[*station][1] { 0.01 } else { -0.01 };
        sides[usize::from(y > 0.0)] += 1;
        let second = 0.01 * 0.02_f64.powi(3) / 12.0;
        let bending = -moment(axis[*station]) * y / second;
        let expected = fx / 2e-4 + bending;
        let allowed = 1e-4 * (fx / 2e-4 + bending.abs());
        assert!((skin["stress"][k] - expected).abs() < allowed, "{}, not {expected}", skin["stress"][k]);
    }
    assert_eq!(sides, [18, 18]);
}

/// Green's strain of a straight axis in a rotation-free stretch u = ε x is ε + ε²/2 at each point, on any mesh.
#[test]
fn strain_of_large_models_is_that_of_the_stretch() {
    let text = CANTILEVER.replace("elements = 8", "elements = 6000").replace("[5, -0.003, 0]", "[400, 0, 0]");
    let run = Run::of(&text, 1);
    let (_, skin) = written(&run, "sections").pop().expect("a frame");
    let (_, lines) = written(&run, "lines").pop().expect("a frame");
    let (axis, rings) = (lines.points(), lines.points().len());
    assert!((6001..=10_000).contains(&rings), "{rings}");
    assert_eq!(skin.points().len(), 4 * rings);
    let stretch = axis[rings - 1][0] / 2.0 - 1.0;
    let expected = stretch + 0.5 * stretch * stretch;
    // Lateral contraction is constrained at the clamp.
    let interior = (0..skin.points().len()).filter(|k| skin["s"][*k] > 0.2);
    interior.for_each(|k| {
        assert!((skin["strain"][k] / expected - 1.0).abs() < 1e-3, "{k}: {}", skin["strain"][k]);
    });
    assert!(skin.is_closed());
}

#[test]
fn shapes_are_vectors_about_their_state() {
    let run = Run::of_file("models/tuning_fork.toml", 1.0, 1);
    let all = written(&run, "sections");
    assert_eq!(all.iter().map(|(time, _)| *time).collect::<Vec<_>>(), run.column("mode"));
    let still = |grid: &Grid| -> Vec<[f64; 3]> {
        let moved = grid.points().into_iter().zip(grid.vectors("shape"));
        moved.map(|(x, shape)| std::array::from_fn(|k| x[k] - shape[k])).collect()
    };
    let first = still(&all[0].1);
    for (_, grid) in &all {
        assert!(grid.is_closed());
        assert!(grid.texts["label"][0].starts_with("mode "));
        assert!(!grid.arrays.contains_key("velocity") && !grid.arrays.contains_key("N"));
        let apart =
            still(grid).into_iter().zip(&first).flat_map(|(x, y)| (0..3).map(move |k| (x[k] - y[k]).abs()));
        assert!(apart.fold(0.0, f64::max) < 1e-6, "without the shape, all frames are equal");
    }
}

#[test]
fn obstacles_are_written_once_unless_they_move() {
    let still = CANTILEVER.replace(
        "[analysis]",
        "[[contacts]]\nbodies = [\"beam\"]\nwith = { kind = \"plane\", point = [0, -1, 0], normal = [0, 1, 0] }\n\
         stiffness = 1e3\nradius = 0.01\n[analysis]",
    );
    let run = Run::of(&still, 1);
    let all = written(&run, "obstacles");
    assert_eq!(all.len(), 1);
    let points = all[0].1.points();
    assert_eq!(points.len(), 4);
    assert!(points.iter().all(|x| (x[1] + 1.0).abs() < 1e-12), "on the plane");
    assert!((points.iter().map(|x| x[0]).sum::<f64>() / 4.0 - 1.0).abs() < 1e-6, "below the beam");
    let run = Run::of_file("models/belt.toml", 0.1, 20);
    let all = written(&run, "obstacles");
    assert_eq!(all.len(), run.frames.len());
}

#[test]
fn fewer_frames_replace_more() {
    let mut run = Run::of_file("models/cantilever.toml", 0.1, 7);
    let folder = tempfile::tempdir().unwrap();
    assert!(write(&run, folder.path()).frames > 3);
    run.frames.truncate(2);
    // A frame with positions that are not finite is omitted.
    let mut broken = run.frames[1].clone();
    broken.state.q.fill(f64::NAN);
    run.frames.push(broken);
    let written = write(&run, folder.path());
    assert_eq!((written.frames, written.left_out), (2, 1));
    let names = |of: &str| {
        let entries = fs::read_dir(folder.path().join(of)).unwrap();
        let mut names: Vec<_> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    };
    assert_eq!(names("sections"), ["00000.vtu", "00001.vtu"]);
    assert_eq!(names(""), ["lines", "lines.pvd", "sections", "sections.pvd"]);
    // Without frames, the undeformed state is written.
    run.frames.clear();
    assert_eq!(write(&run, folder.path()).frames, 1);
}

#[test]
fn a_folder_that_cannot_be_written_is_named() {
    let run = Run::of(CANTILEVER, 1);
    let folder = tempfile::tempdir().unwrap();
    let taken = folder.path().join("taken");
    fs::write(&taken, "a file").unwrap();
    let recording = run.recording();
    let error = Writer::new(&recording, &taken).expect_err("it is a file").to_string();
    assert!(error.starts_with("cannot create the folder ") && error.contains("taken"), "{error}");
}

/// Full disk: the incomplete files are not visible, because there is no collection.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_said_and_leaves_no_collection() {
    let run = Run::of(CANTILEVER, 1);
    let folder = tempfile::tempdir().unwrap();
    write(&run, folder.path());
    std::os::unix::fs::symlink("/dev/full", folder.path().join("lines/00000.part")).unwrap();
    let recording = run.recording();
    let mut writer = Writer::new(&recording, folder.path()).unwrap();
    let error = writer.push(&recording.frames[0]).expect_err("there is no space").to_string();
    assert!(error.contains("cannot write") && error.contains("00000.vtu"), "{error}");
    assert!(error.contains("No space left"), "{error}");
    assert!(!folder.path().join("sections.pvd").exists());
}
