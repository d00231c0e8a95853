//! Imports and other statements of a Python module.

use super::statements::{self, Statement};

/// A name that an import statement binds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Binding {
    /// Line, from 1.
    pub(super) line: usize,
    /// Name in the importing module. Empty for `*`.
    pub(super) alias: String,
    /// Absolute module.
    pub(super) module: String,
    /// Name in that module. `None` for `import module`.
    pub(super) name: Option<String>,
}

/// A parsed module.
#[derive(Debug)]
pub(super) struct Module {
    /// Absolute name.
    pub(super) name: String,
    pub(super) is_package: bool,
    pub(super) bindings: Vec<Binding>,
    /// Statements besides imports and `__all__`.
    pub(super) others: Vec<Statement>,
}

impl Module {
    /// Parses a module by its absolute name.
    pub(super) fn parse(name: String, is_package: bool, code: &str) -> Self {
        let mut module = Self { name, is_package, bindings: Vec::new(), others: Vec::new() };
        for statement in statements::split(code) {
            let text = statement.text.trim_start();
            // The body of a compound statement may stand on the line of its head.
            let body = [": import ", ": from "]
                .iter()
                .find_map(|mark| text.find(mark))
                .map_or(text, |at| &text[at + 2..]);
            if let Some(names) = body.strip_prefix("import ") {
                module.import(statement.line, names);
            } else if let Some((from, names)) =
                body.strip_prefix("from ").and_then(|rest| rest.split_once(" import"))
            {
                module.import_from(statement.line, from.trim(), names);
            } else if !text.starts_with("__all__") {
                module.others.push(statement);
            }
        }
        module
    }

    /// Enters `import a.b, c as d`.
    fn import(&mut self, line: usize, names: &str) {
        for name in names.split(',') {
            let (module, alias) = alias(name);
            let bound = alias.unwrap_or_else(|| module.split('.').next().unwrap_or(module));
            self.bindings.push(Binding {
                line,
                alias: bound.to_owned(),
                module: module.to_owned(),
                name: None,
            });
        }
    }

    /// Enters `from .a import b, c as d`.
    fn import_from(&mut self, line: usize, from: &str, names: &str) {
        let module = self.absolute(from);
        for name in names.trim().trim_matches(['(', ')']).split(',').filter(|name| !name.trim().is_empty()) {
            let (name, alias) = alias(name);
            let bound = if name == "*" { "" } else { alias.unwrap_or(name) };
            self.bindings.push(Binding {
                line,
                alias: bound.to_owned(),
                module: module.clone(),
                name: Some(name.to_owned()),
            });
        }
    }

    /// Returns the absolute name of a module that may be relative.
    fn absolute(&self, from: &str) -> String {
        let name = from.trim_start_matches('.');
        let dots = from.len() - name.len();
        if dots == 0 {
            return name.to_owned();
        }
        let mut base: Vec<&str> = self.name.split('.').collect();
        let up = if self.is_package { dots - 1 } else { dots };
        base.truncate(base.len().saturating_sub(up));
        base.extend(Some(name).filter(|name| !name.is_empty()));
        base.join(".")
    }

    /// True for a package file that only imports names and states `__all__` and the like.
    pub(super) fn is_facade(&self) -> bool {
        let is_plain = |statement: &Statement| {
            let text = statement.text.trim();
            let heads = ["if TYPE_CHECKING", "else:", "try:", "except", "pass", "\"\""];
            text.starts_with("__") && text.contains('=') || heads.iter().any(|head| text.starts_with(head))
        };
        self.is_package && self.others.iter().all(is_plain)
    }
}

/// Splits `name as alias`.
fn alias(name: &str) -> (&str, Option<&str>) {
    let mut words = name.split_whitespace();
    (words.next().unwrap_or_default(), words.nth(1))
}
