//! Imports of Python files.

use super::workspace::Workspace;

fn package(name: &str) -> Workspace {
    Workspace::python(name, &[".", "inner"])
        .file("house/__init__.py", "\"\"\"House.\"\"\"\n\nfrom house.inner import B\n\n__all__ = [\"B\"]\n")
        .file("house/inner/__init__.py", "from .a import A\nfrom .b import (\n    B,  # second\n)\n")
        .file("house/inner/a.py", "class A:\n    pass\n")
        .file("house/inner/b.py", "class B:\n    pass\n")
}

#[test]
fn a_clean_package_passes() {
    let said = package("clean_python")
        .file(
            "house/top.py",
            "import os\nfrom . import inner\nfrom house.inner import A as First\n\nx = inner.B()\n",
        )
        .passes();
    assert!(said.contains("house: 2 layers, 5 files, 2 imports"), "{said}");
}

#[test]
fn cycles_are_found() {
    let cycle = |name: &str, imports: &str, line: usize, found: &str| {
        package(name)
            .file("house/inner/a.py", "from .b import B\n\nclass A:\n    pass\n")
            .file("house/inner/b.py", imports)
            .fails(&[
                "cycle of 2 files",
                "house/inner/a.py:1 -> inner/b.py: `B`",
                &format!("house/inner/b.py:{line} -> inner/a.py: `{found}`"),
            ]);
    };
    let class = "\nclass B:\n    pass\n";
    cycle("python_relative", &format!("from .a import A{class}"), 1, "A");
    cycle("python_package", &format!("from . import A{class}"), 1, "A");
    cycle("python_absolute", &format!("import os, house.inner.a as first{class}"), 1, "house.inner.a");
    cycle("python_module", &format!("from . import a{class}"), 1, "a");
    cycle("python_attribute", &format!("import house\n\nx = house.inner.A(){class}"), 1, "A");
    cycle("python_lines", &format!("\nfrom house.inner import (\n    A as C,\n){class}"), 2, "A");
    cycle("python_backslash", &format!("from house.inner \\\n    import A{class}"), 1, "A");
    cycle("python_types", &format!("if TYPE_CHECKING:\n    from .a import A{class}"), 2, "A");
    cycle("python_function", &format!("def f():\n    \"\"\"Doc.\"\"\"\n    from .a import A{class}"), 3, "A");
}

#[test]
fn text_is_no_import() {
    let text = "\"\"\"Example.\n\nfrom .a import A\n\"\"\"\nx = 'a\\'\\\nfrom .a import A'  # from .a import A\nclass B:\n    pass\n";
    package("python_text")
        .file("house/inner/a.py", "from .b import B\n\nclass A:\n    pass\n")
        .file("house/inner/b.py", text)
        .passes();
}

#[test]
fn imports_point_downwards() {
    package("python_upwards")
        .file("house/top.py", "C = 1\n")
        .file("house/inner/b.py", "class B:\n    def f(self):\n        from house.top import C\n")
        .fails(&["house/inner/b.py:3: imports `C` of top.py, upwards from layer \"inner\" to \".\""]);
}

#[test]
fn a_package_file_that_defines_names_is_part_of_a_cycle() {
    package("python_init")
        .file(
            "house/inner/__init__.py",
            "from .a import A\nfrom .b import B\n\ndef make():\n    return A()\n",
        )
        .file("house/inner/a.py", "from house.inner import make\n\nclass A:\n    pass\n")
        .fails(&["cycle of 2 files", "house/inner/__init__.py:1 -> inner/a.py: `A`"]);
}
