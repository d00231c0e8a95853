//! Display geometry of rigid bodies: errors with their lines, and files in the results folder.

use std::fs;

use crate::folder::TestFolder;

const MODEL: &str = "title = \"part\"

[[bodies]]
kind = \"rigid\"
name = \"part\"
center = [0, 0, 0]
mass = 1
inertia = [1, 1, 1]
motion = { spin = [0, 0, 1] }
display = [
    { kind = \"sphere\", radius = 0.1 },
    { kind = \"mesh\", file = \"meshes/part.stl\" },
]

[analysis]
kind = \"dynamics\"
duration = 0.1
step = 0.05
scheme = { spectral_radius = 0.8 }
";

/// STL file with one triangle.
const STL: &str = "solid one
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 1 0
endloop
endfacet
endsolid one
";

#[test]
fn a_missing_mesh_is_an_error_of_its_line() {
    let folder = TestFolder::new();
    folder.write("part.toml", MODEL);
    for arguments in [&["check", "part.toml"][..], &["run", "part.toml", "-o", "out"]] {
        let output = folder.ancf(arguments);
        assert_eq!(output.code, Some(2), "{arguments:?}");
        let place = "part.toml:12:29";
        assert!(output.messages.contains(place), "{}", output.messages);
        assert!(output.messages.contains("found no file meshes/part.stl"), "{}", output.messages);
    }
    assert!(!folder.path("out").exists());
}

/// The report does not need the mesh file: the run keeps the surface, also one that starts again.
#[test]
fn a_run_keeps_its_surfaces() {
    let folder = TestFolder::new();
    folder.write("part.toml", MODEL);
    fs::create_dir(folder.path("meshes")).unwrap();
    folder.write("meshes/part.stl", STL);
    folder.printed(&["run", "part.toml", "-o", "out"]);
    fs::remove_dir_all(folder.path("meshes")).unwrap();
    let surface = folder.path("out/display/0.stl");
    let stored = fs::read(&surface).unwrap();
    for command in ["report", "paraview"] {
        let output = folder.ancf(&[command, "out"]);
        assert_eq!(output.code, Some(0), "{}", output.messages);
        assert!(!output.messages.contains("display"), "{}", output.messages);
    }
    fs::remove_file(folder.path("out/summary.json")).unwrap();
    folder.printed(&["resume", "out"]);
    assert_eq!(fs::read(&surface).unwrap(), stored);
    fs::remove_file(&surface).unwrap();
    let output = folder.ancf(&["paraview", "out"]);
    let warning = "`part` is drawn without its display geometry: no file";
    assert!(output.messages.contains(warning), "{}", output.messages);
    // A model without meshes removes the surfaces of the earlier run.
    folder.write("out/display/0.stl", STL);
    let mesh = "    { kind = \"mesh\", file = \"meshes/part.stl\" },\n";
    folder.write("part.toml", &MODEL.replace(mesh, ""));
    folder.printed(&["run", "part.toml", "-o", "out"]);
    assert!(!folder.path("out/display").exists());
}
