//! Surfaces of models and of mesh files.
#![cfg(test)]

use std::fs;
use std::path::Path;

use ancf::Model;
use ancf::model::ModelErrors;
use ancf_surface::BodySurfaces;
use serde_json::json;
use tempfile::TempDir;

/// Model of a body with center (1, 2, 3) and display shapes.
fn model(display: &str) -> Model {
    let text = format!(
        "bodies = [{{ kind = \"rigid\", name = \"part\", center = [1, 2, 3], mass = 1, inertia = [1, 1, 1], {display} }}]
         [analysis]
         kind = \"dynamics\"
         duration = 1
         step = 0.1
         scheme = {{ spectral_radius = 0.8 }}"
    );
    Model::parse(&text).unwrap()
}

fn bounds(display: &str, folder: &Path) -> [[f64; 3]; 2] {
    let surfaces = BodySurfaces::read(&model(display), folder).unwrap();
    surfaces.get(0).and_then(|surface| surface.bounds()).unwrap()
}

#[track_caller]
fn assert_near(found: [[f64; 3]; 2], expected: [[f64; 3]; 2]) {
    let off = found.iter().flatten().zip(expected.iter().flatten()).map(|(a, b)| (a - b).abs());
    assert!(off.fold(0.0, f64::max) < 1e-6, "{found:?}, expected {expected:?}");
}

/// STL file as text: the tetrahedron of the origin and the unit points of the axes.
const STL: &str = "solid tetrahedron
facet normal 0 0 -1
outer loop
vertex 0 0 0
vertex 0 1 0
vertex 1 0 0
endloop
endfacet
facet normal 0 -1 0
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 0 1
endloop
endfacet
facet normal -1 0 0
outer loop
vertex 0 0 0
vertex 0 0 1
vertex 0 1 0
endloop
endfacet
facet normal 1 1 1
outer loop
vertex 1 0 0
vertex 0 1 0
vertex 0 0 1
endloop
endfacet
endsolid tetrahedron
";

/// glTF file of the same tetrahedron in a node with scale 2 and a child with a translation.
fn gltf(count: usize) -> serde_json::Value {
    use base64::Engine;
    let mut bytes: Vec<u8> = Vec::new();
    for point in [[0.0_f32; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
        point.iter().for_each(|x| bytes.extend(x.to_le_bytes()));
    }
    for corner in [0_u16, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3] {
        bytes.extend(corner.to_le_bytes());
    }
    let data = base64::prelude::BASE64_STANDARD.encode(&bytes);
    json!({
        "asset": { "version": "2.0" },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [{ "scale": [2, 2, 2], "children": [1] }, { "mesh": 0, "translation": [1, 0, 0] }],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 }, "indices": 1 }] }],
        "accessors": [
            { "bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1] },
            { "bufferView": 1, "componentType": 5123, "count": count, "type": "SCALAR" }
        ],
        "bufferViews": [
            { "buffer": 0, "byteOffset": 0, "byteLength": 48 },
            { "buffer": 0, "byteOffset": 48, "byteLength": 24 }
        ],
        "buffers": [{ "byteLength": 72, "uri": format!("data:application/octet-stream;base64,{data}") }]
    })
}

#[test]
fn shapes_are_relative_to_the_centre_of_mass() {
    let here = Path::new("");
    assert_near(
        bounds(r#"display = [{ kind = "box", edges = [1, 2, 4] }]"#, here),
        [[-0.5, -1.0, -2.0], [0.5, 1.0, 2.0]],
    );
    let turned = r#"display = [{ kind = "box", edges = [1, 2, 4], center = [2, 2, 3], rotation = [0, 0, 1.5707963267948966] }]"#;
    assert_near(bounds(turned, here), [[0.0, -0.5, -2.0], [2.0, 0.5, 2.0]]);
    let two = r#"display = [{ kind = "sphere", radius = 0.5 }, { kind = "cylinder", from = [1, 2, 3], to = [4, 2, 3], radius = 0.25 }]"#;
    assert_near(bounds(two, here), [[-0.5, -0.5, -0.5], [3.0, 0.5, 0.5]]);
}

#[test]
fn contact_surfaces_are_drawn_unless_there_are_display_shapes() {
    let here = Path::new("");
    assert_near(bounds("surface = { edges = [1, 2, 3] }", here), [[-0.5, -1.0, -1.5], [0.5, 1.0, 1.5]]);
    let balls = "surface = { radius = 0.5, points = [[1, 2, 3], [2, 2, 3]] }";
    assert_near(bounds(balls, here), [[-0.5; 3], [1.5, 0.5, 0.5]]);
    let both = r#"surface = { radius = 5 }, display = [{ kind = "sphere", radius = 0.5 }]"#;
    assert_near(bounds(both, here), [[-0.5; 3], [0.5; 3]]);
    assert!(
        BodySurfaces::read(&model("surface = { points = [[0, 0, 0], [1, 2, 3]] }"), here)
            .unwrap()
            .get(0)
            .is_none()
    );
    assert!(BodySurfaces::read(&model(""), here).unwrap().get(0).is_none());
}

#[test]
fn meshes_are_scaled_turned_and_moved() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("a.stl"), STL).unwrap();
    fs::write(folder.path().join("b.gltf"), gltf(12).to_string()).unwrap();
    let mesh = |file: &str, more: &str| {
        bounds(&format!(r#"display = [{{ kind = "mesh", file = "{file}"{more} }}]"#), folder.path())
    };
    assert_near(mesh("a.stl", ""), [[-1.0, -2.0, -3.0], [0.0, -1.0, -2.0]]);
    assert_near(mesh("a.stl", ", scale = 0.5, origin = [1, 2, 3]"), [[0.0; 3], [0.5; 3]]);
    let turned = ", origin = [1, 2, 3], rotation = [0, 0, 1.5707963267948966]";
    assert_near(mesh("a.stl", turned), [[-1.0, 0.0, 0.0], [0.0, 1.0, 1.0]]);
    // The same in a binary file.
    let mut json = gltf(12);
    let buffer = json["buffers"][0].as_object_mut().unwrap().remove("uri").unwrap();
    let data = buffer.as_str().unwrap().split_once(',').unwrap().1;
    let data = base64::Engine::decode(&base64::prelude::BASE64_STANDARD, data).unwrap();
    let mut json = json.to_string().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let mut binary = b"glTF".to_vec();
    let words =
        |words: &[usize]| words.iter().flat_map(|word| (*word as u32).to_le_bytes()).collect::<Vec<_>>();
    binary.extend(words(&[2, 28 + json.len() + data.len(), json.len()]));
    binary.extend([&b"JSON"[..], &json, &words(&[data.len()]), b"BIN\0", &data].concat());
    fs::write(folder.path().join("b.glb"), &binary).unwrap();
    assert_eq!(mesh("b.glb", ""), mesh("b.gltf", ""));
    for k in (0..binary.len()).step_by(5) {
        assert!(faults("c.glb", &binary[..k]).is_err());
    }
    // 2 (x + (1, 0, 0))
    assert_near(mesh("b.gltf", ", origin = [1, 2, 3]"), [[2.0, 0.0, 0.0], [4.0, 2.0, 2.0]]);
}

/// A run keeps its surfaces, even if the file of the mesh has vanished.
#[test]
fn surfaces_of_a_results_folder_are_those_of_the_run() {
    let folder = TempDir::new().unwrap();
    let file = folder.path().join("a.stl");
    fs::write(&file, STL).unwrap();
    let model = model(
        r#"display = [{ kind = "mesh", file = "a.stl", scale = 0.5 }, { kind = "sphere", radius = 0.5 }]"#,
    );
    let read = BodySurfaces::read(&model, folder.path()).unwrap();
    fs::remove_file(file).unwrap();
    let results = folder.path().join("out");
    fs::create_dir_all(results.join("display")).unwrap();
    for (name, bytes) in read.files().unwrap() {
        fs::write(results.join(name), bytes).unwrap();
    }
    let (stored, messages) = BodySurfaces::of_run(&model, &results);
    assert!(messages.is_empty(), "{messages:?}");
    let [own, first] = [&stored, &read].map(|surfaces| surfaces.get(0).unwrap());
    assert_eq!(own.corners.len(), first.corners.len());
    assert_near(own.bounds().unwrap(), first.bounds().unwrap());
    fs::remove_dir_all(&results).unwrap();
    let (without, messages) = BodySurfaces::of_run(&model, &results);
    assert!(without.get(0).is_none());
    assert!(messages[0].starts_with("`part` is drawn without its display geometry: no file"), "{messages:?}");
}

fn faults(file: &str, bytes: &[u8]) -> Result<BodySurfaces, ModelErrors> {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join(file), bytes).unwrap();
    let model = model(&format!(r#"display = [{{ kind = "mesh", file = "{file}" }}]"#));
    BodySurfaces::read(&model, folder.path())
}

#[test]
fn all_files_that_cannot_be_read_are_reported() {
    let model = model(
        r#"display = [{ kind = "mesh", file = "a.stl" }, { kind = "sphere", radius = 1 }, { kind = "mesh", file = "b.glb" }]"#,
    );
    let errors = BodySurfaces::read(&model, Path::new("nowhere")).unwrap_err();
    let paths: Vec<&str> = errors.iter().map(|error| error.path.as_str()).collect();
    assert_eq!(paths, ["bodies[0].display[0].file", "bodies[0].display[2].file"]);
    assert!(errors[0].found.starts_with("no file "), "{}", errors[0]);
}

/// Damaged files are refused without a panic: truncated files, and files with one changed byte.
#[test]
fn damaged_files_are_refused() {
    let is_refused = |file: &str, bytes: &[u8]| assert!(faults(file, bytes).is_err(), "{file}");
    is_refused("a.stl", b"");
    is_refused("a.stl", b"solid nothing\nendsolid nothing\n");
    is_refused("a.gltf", b"{}");
    is_refused("a.glb", STL.as_bytes());
    is_refused("a.gltf", gltf(13).to_string().as_bytes());
    let mut beyond = gltf(12);
    beyond["bufferViews"][0]["byteLength"] = 4000.into();
    is_refused("a.gltf", beyond.to_string().as_bytes());
    let mut cycle = gltf(12);
    cycle["nodes"][1]["children"] = json!([0]);
    is_refused("a.gltf", cycle.to_string().as_bytes());
    let mut sparse = gltf(12);
    sparse["accessors"][0]["count"] = 0.into();
    is_refused("a.gltf", sparse.to_string().as_bytes());
    let mut compressed = gltf(12);
    compressed["extensionsRequired"] = json!(["KHR_draco_mesh_compression"]);
    is_refused("a.gltf", compressed.to_string().as_bytes());
    let whole = gltf(12).to_string().into_bytes();
    for k in (0..whole.len()).step_by(7) {
        is_refused("a.gltf", &whole[..k]);
        let mut changed = whole.clone();
        changed[k] = changed[k].wrapping_add(1);
        // Some changes are harmless.
        let _ = faults("a.gltf", &changed);
    }
}

#[test]
fn shapes_without_size_and_other_files_are_rejected_by_the_check() {
    let error = |display: &str| {
        let text = format!(
            "bodies = [{{ kind = \"rigid\", name = \"part\", center = [1, 2, 3], mass = 1, inertia = [1, 1, 1], display = [{display}] }}]
             analysis = {{ kind = \"modes\", count = 1 }}"
        );
        Model::parse(&text).unwrap_err().to_string()
    };
    for (display, expected) in [
        (
            r#"{ kind = "box", edges = [1, 0, 1] }"#,
            "display[0].edges: found [1, 0, 1], expected three numbers > 0",
        ),
        (
            r#"{ kind = "cylinder", from = [1, 0, 0], to = [1, 0, 0], radius = 1 }"#,
            "found a cylinder of length 0",
        ),
        (r#"{ kind = "sphere", radius = 0 }"#, "display[0].radius: found 0"),
        (r#"{ kind = "mesh", file = "part.obj" }"#, "expected a file name that ends in .stl, .gltf or .glb"),
    ] {
        let error = error(display);
        assert!(error.contains(expected), "{error}");
    }
}
