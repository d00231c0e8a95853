//! Imports of TypeScript files.

use super::workspace::Workspace;

fn tree(name: &str) -> Workspace {
    Workspace::typescript(name, &[".", "inner"])
        .file("house/main.ts", "")
        .file("house/inner/index.ts", "// Doors.\nexport { A } from \"./a\";\nexport * from './b';\n")
        .file("house/inner/a.ts", "export class A {}\n")
        .file("house/inner/b.ts", "export const B = 1;\n")
}

#[test]
fn a_clean_tree_passes() {
    let said = tree("clean_typescript")
        .file("house/main.ts", "import * as THREE from \"three\";\nimport { A, B } from \"./inner\";\n")
        .passes();
    assert!(said.contains("house: 2 layers, 4 files, 2 imports"), "{said}");
}

#[test]
fn cycles_are_found() {
    let cycle = |name: &str, import: &str, line: usize, found: &str| {
        tree(name)
            .file("house/inner/a.ts", "import { B } from \"./b\";\nexport class A {}\n")
            .file("house/inner/b.ts", &format!("{import}\nexport const B = 1;\n"))
            .fails(&[
                "cycle of 2 files",
                "house/inner/a.ts:1 -> inner/b.ts: `B`",
                &format!("house/inner/b.ts:{line} -> inner/a.ts: `{found}`"),
            ]);
    };
    cycle("ts_named", "import { A } from \"./a\";", 1, "A");
    cycle("ts_type", "import type { A } from '../inner/a.js'", 1, "A");
    cycle("ts_lines", "/* first */\nimport {\n  type A as First, // one\n} from \"./a\";", 2, "A");
    cycle("ts_index", "import { A } from \".\";", 1, "A");
    cycle("ts_namespace", "import * as all from \"./index\";\nnew all.A();", 1, "A");
    cycle("ts_effect", "import \"./a\";", 1, "./a");
    cycle("ts_default", "import First from \"./a\";", 1, "default");
    cycle("ts_export", "export { A as First } from \"./a\";", 1, "A");
    cycle("ts_dynamic", "const x = await import(\"./a\");", 1, "./a");
    cycle("ts_type_query", "\ntype X = import(\"./a\").A;", 2, "./a");
}

#[test]
fn comments_are_no_imports() {
    tree("ts_comments")
        .file("house/inner/a.ts", "import { B } from \"./b\";\nexport class A {}\n")
        .file(
            "house/inner/b.ts",
            "/*\nimport { A } from \"./a\";\n*/ // import { A } from \"./a\";\nexport const B = 1;\n",
        )
        .passes();
}

#[test]
fn imports_point_downwards() {
    tree("ts_upwards")
        .file("house/main.ts", "export const C = 1;\n")
        .file("house/inner/b.ts", "import { C } from \"../main\";\nexport const B = C;\n")
        .fails(&["house/inner/b.ts:1: imports `C` of main.ts, upwards from layer \"inner\" to \".\""]);
}
