//! Imports of Rust files.

use super::workspace::Workspace;

const CYCLE: &str = "cycle of 2 files";

fn flat(name: &str, library: &str) -> Workspace {
    Workspace::rust(name, &["."]).file("house/src/lib.rs", library)
}

#[test]
fn a_clean_tree_passes() {
    let said = Workspace::rust("clean", &[".", "upper", "lower"])
        .file("house/src/lib.rs", "mod lower;\npub mod upper;\npub use upper::Roof;")
        .file("house/src/upper/mod.rs", "mod roof;\nmod tile;\npub use roof::Roof;\npub use tile::Tile;")
        .file("house/src/upper/roof.rs", "use super::Tile;\npub struct Roof(Tile, crate::lower::Wall);")
        .file(
            "house/src/upper/tile.rs",
            "use crate::lower::wall::{self, *};\npub struct Tile(Brick, wall::Wall);",
        )
        .file("house/src/lower/mod.rs", "pub mod wall;\npub use wall::Wall;")
        .file("house/src/lower/wall.rs", "pub struct Wall;\npub struct Brick;")
        .passes();
    assert!(said.contains("house/src: 3 layers, 6 files, 3 imports"), "{said}");
}

#[test]
fn direct_imports_make_a_cycle() {
    flat("direct", "mod a;\nmod b;")
        .file("house/src/a.rs", "use crate::b::B;\npub struct A(B);")
        .file("house/src/b.rs", "\nuse crate::a::A;\npub struct B(Box<A>);")
        .fails(&[CYCLE, "house/src/a.rs:1 -> b.rs: `B`", "house/src/b.rs:2 -> a.rs: `A`"]);
}

#[test]
fn siblings_make_a_cycle() {
    flat("siblings", "mod a;\nmod b;")
        .file("house/src/a.rs", "use super::b::{one, two as second};\npub fn a() { one(); second() }")
        .file("house/src/b.rs", "pub fn one() {}\npub fn two() { super::a::a() }")
        .fails(&[CYCLE, "a.rs:1 -> b.rs: `one`, `two`", "b.rs:2 -> a.rs: `a`"]);
}

#[test]
fn re_exports_hide_no_cycle() {
    let inner = "mod a;\nmod b;\npub use a::*;\npub(crate) use b::B as Second;";
    Workspace::rust("re_exports", &[".", "inner"])
        .file("house/src/lib.rs", "mod inner;\npub use inner::{A, Second};")
        .file("house/src/inner/mod.rs", inner)
        .file("house/src/inner/a.rs", "pub struct A(crate::Second);")
        .file("house/src/inner/b.rs", "use super::A;\npub struct B(Box<A>);")
        .fails(&[CYCLE, "inner/a.rs:1 -> inner/b.rs: `B`", "inner/b.rs:1 -> inner/a.rs: `A`"]);
}

#[test]
fn a_method_of_another_file_is_an_import() {
    let tree = |name: &str, call: &str| {
        flat(name, "mod a;\nmod b;\nmod c;")
            .file("house/src/a.rs", "pub struct A;")
            .file("house/src/b.rs", "use crate::{a::A, c::c};\nimpl A { pub fn height(&self) { c(self) } }")
            .file("house/src/c.rs", &format!("use crate::a::A;\npub fn c(a: &A) {{ {call} }}"))
    };
    tree("method", "a.height()").fails(&[CYCLE, "c.rs:2 -> b.rs: `A::height`"]);
    tree("method_path", "A::height(a)").fails(&[CYCLE, "c.rs:2 -> b.rs: `A::height`"]);
    tree("method_arguments", "a.height(1)").passes();
}

#[test]
fn a_method_name_of_two_types_is_no_import() {
    flat("ambiguous", "mod a;\nmod b;\nmod c;")
        .file("house/src/a.rs", "pub struct A;\npub struct Other;\nimpl Other { pub fn height(&self) {} }")
        .file("house/src/b.rs", "use crate::{a::A, c::c};\nimpl A { pub fn height(&self) { c(self) } }")
        .file("house/src/c.rs", "pub fn c(a: &crate::a::A) { a.height() }")
        .passes();
}

#[test]
fn own_methods_are_known_by_their_type() {
    flat("own", "mod a;\nmod b;")
        .file("house/src/a.rs", "pub struct A;\nimpl A { pub fn low(&self) { self.size() } }")
        .file(
            "house/src/b.rs",
            "use crate::a::A;\nimpl A { pub fn size(&self) {} }\nstruct B;\nimpl B { fn size() {} }",
        )
        .fails(&[CYCLE, "a.rs:2 -> b.rs: `A::size`"]);
}

#[test]
fn a_module_file_that_defines_items_is_part_of_a_cycle() {
    Workspace::rust("module_file", &[".", "inner"])
        .file("house/src/lib.rs", "mod inner;")
        .file("house/src/inner/mod.rs", "mod a;\npub use a::A;\npub struct M;\nfn make() -> A { A }")
        .file("house/src/inner/a.rs", "use super::M;\npub struct A;\nfn m(_: M) {}")
        .fails(&[CYCLE, "inner/mod.rs:4 -> inner/a.rs: `A`", "inner/a.rs:1 -> inner/mod.rs: `M`"]);
}

#[test]
fn macros_and_attributes_import() {
    let cycle = |name: &str, code: &str| {
        flat(name, "#[macro_use]\nmod a;\nmod b;")
            .file("house/src/a.rs", &format!("use crate::b;\n{code}"))
            .file("house/src/b.rs", "pub fn b() -> u8 { crate::a::one() }\npub fn two() {}")
            .fails(&[CYCLE, "a.rs:3 -> b.rs: `two`"]);
    };
    cycle("format", "pub fn one() -> u8 {\nprintln!(\"{:?}\", b::two()); 1 }");
    cycle("pattern", "pub fn one() -> u8 {\nany!(x if b::two() => {}); 1 }");
    cycle("definition", "pub fn one() -> u8 { 1 } macro_rules! any {\n() => { $crate::b::two() } }");
    cycle("serde", "pub fn one() -> u8 { 1 } pub struct A {\n#[serde(default = \"b::two\")] x: u8 }");
}

#[test]
fn imports_inside_functions_count() {
    flat("inside", "mod a;\nmod b;")
        .file("house/src/a.rs", "pub fn a() {\n    use crate::b as other;\n    other::b();\n}")
        .file("house/src/b.rs", "pub fn b() { if false { use super::a::*; a() } }")
        .fails(&[CYCLE, "a.rs:3 -> b.rs: `b`", "b.rs:1 -> a.rs: `a`"]);
}

#[test]
fn tests_import_freely() {
    flat("tests", "mod a;\nmod b;\n#[cfg(test)]\nmod c;")
        .file("house/src/a.rs", "pub struct A;\n#[cfg(test)]\nmod tests { use crate::b::B; }")
        .file(
            "house/src/b.rs",
            "use crate::a::A;\npub struct B(A);\n#[cfg(all(test, unix))]\nuse crate::c::c;",
        )
        .file("house/src/c.rs", "use crate::b::B;\npub fn c() {}")
        .passes();
}

#[test]
fn paths_into_other_crates_are_followed_back() {
    let manifest = |name: &str, uses: &str| format!("[package]\nname = \"{name}\"\n[dependencies]\n{uses}");
    Workspace::rust("crates", &["."])
        .tree("base/src", "rust", &["."])
        .file("house/Cargo.toml", &manifest("the-house", "base = {}"))
        .file("base/Cargo.toml", &manifest("base", ""))
        .file("base/src/lib.rs", "mod stone;\npub use stone::Stone;")
        .file("base/src/stone.rs", "pub struct Stone;")
        .file("house/src/lib.rs", "pub mod a;\npub use base::*;")
        .file(
            "house/src/a.rs",
            "pub struct A(crate::Stone);\npub fn run() {}\nimpl A { pub fn go(&self) {} }",
        )
        .file("house/src/main.rs", "mod b;\nfn main() { the_house::a::run() }")
        .file("house/src/b.rs", "pub fn b() {}")
        .passes();
}

#[test]
fn a_file_without_a_module_is_reported() {
    flat("lost", "mod a;")
        .file("house/src/a.rs", "")
        .file("house/src/b.rs", "")
        .fails(&["house/src/b.rs: belongs to no module"]);
}
