//! Classes and types of a module, as text.

use std::collections::BTreeSet;

use serde_json::Value as Json;

use super::form::{Form, Key, alternatives, definition, description, forms};
use super::hint::{arms, hint};
use super::names;
use super::text::{WIDTH, meaning, summary, wrapped};

const DATACLASS: &str = "@dataclass(kw_only=True, slots=True, eq=False, repr=False)\n";
/// What a part with a name that the schema does not have says of it.
const NAME: &str = "Key in the model's table, for a part that is given in the place of its name; found by itself if \
                    left out.";

/// The text of a definition, the names that it defines, and those that it uses.
#[derive(Default)]
pub(super) struct Code {
    /// Classes and types.
    pub(super) blocks: Vec<String>,
    pub(super) defines: Vec<String>,
    pub(super) uses: BTreeSet<String>,
}

impl Code {
    /// A definition: its classes, and its type if it has several forms.
    pub(super) fn of(schema: &Json, name: &str) -> Self {
        let mut code = Self::default();
        let of = definition(schema, name);
        let forms = forms(name, of);
        for form in &forms {
            code.class(schema, form);
        }
        if !forms.iter().any(|form| form.class == name) || forms.len() > 1 {
            code.alias(schema, name, of, &forms);
        }
        code
    }

    fn uses(&mut self, names: &[&str]) {
        self.uses.extend(names.iter().map(|name| (*name).to_owned()));
    }

    fn class(&mut self, schema: &Json, form: &Form) {
        let (_, base) = names::base(form.definition, &form.class);
        self.uses(&["dataclass", base]);
        self.defines.push(form.class.clone());
        let mut text = format!("{DATACLASS}class {}({base}):\n", form.class);
        text += &docstring(schema, form, base == "Shared");
        text += &format!("\n    _form = {:?}\n", form.definition);
        if let Some((key, word)) = form.tag {
            self.uses(&["ClassVar", "Literal"]);
            text += &format!("    _tag = {key:?}\n    {key}: ClassVar[Literal[{word:?}]] = {word:?}\n");
        }
        text += &self.tables(form);
        if !form.keys.is_empty() {
            text.push('\n');
        }
        text.extend(form.keys.iter().map(|key| self.field(schema, form, key)));
        self.blocks.push(text);
    }

    /// The keys for which a part may be given in the place of its name.
    fn tables(&mut self, form: &Form) -> String {
        let table = |key: &Key| {
            let table = names::table(form.definition, key.name)?;
            Some(format!("        {:?}: {table:?},\n", key.name))
        };
        let tables: String = form.keys.iter().filter_map(table).collect();
        if tables.is_empty() {
            return tables;
        }
        self.uses(&["ClassVar", "Mapping"]);
        format!("    _tables: ClassVar[Mapping[str, str]] = {{\n{tables}    }}\n")
    }

    fn field(&mut self, schema: &Json, form: &Form, key: &Key) -> String {
        let mut hint = hint(schema, key.schema, &mut self.uses);
        if let Some((part, _)) = names::instead(form.definition, key.name) {
            self.uses(&[part]);
            hint += &format!(" | {part}");
        }
        let is_first = names::positional(&form.class).contains(&key.name);
        let value = match (key.is_required, is_first) {
            (true, false) => "",
            (false, false) => " = None",
            (true, true) => " = field(kw_only=False)",
            (false, true) => " = field(default=None, kw_only=False)",
        };
        if is_first {
            self.uses(&["field"]);
        }
        let none = if key.is_required { "" } else { " | None" };
        format!("    {}: {hint}{none}{value}\n", names::attribute(key.name))
    }

    /// The type of a definition that has several forms, and what its words mean.
    fn alias(&mut self, schema: &Json, name: &str, of: &Json, forms: &[Form]) {
        let alias = names::alias(name);
        let others: Vec<&Json> =
            alternatives(of).into_iter().filter(|form| !form["properties"].is_object()).collect();
        let others = serde_json::json!({ "oneOf": others });
        let mut all = arms(schema, &others, &mut self.uses);
        all.extend(forms.iter().map(|form| form.class.clone()));
        let besides = names::besides(name);
        if let Some((callable, _)) = besides {
            self.uses(&["Callable"]);
            all.push(callable.into());
        }
        self.uses(&["TypeAlias"]);
        self.defines.push(alias.into());
        self.blocks.push(assigned(alias, &all) + &meanings(of, besides.map(|(_, text)| text)));
    }
}

/// The assignment of a type, in as many lines as it needs.
fn assigned(alias: &str, arms: &[String]) -> String {
    let all = arms.join(" | ");
    if alias.len() + all.chars().count() + ": TypeAlias = ".len() <= WIDTH {
        return format!("{alias}: TypeAlias = {all}\n");
    }
    match arms {
        [words] => {
            let words = words.trim_start_matches("Literal[").trim_end_matches(']').replace(", ", ",\n    ");
            format!("{alias}: TypeAlias = Literal[\n    {words},\n]\n")
        }
        _ if 4 + all.chars().count() <= WIDTH => format!("{alias}: TypeAlias = (\n    {all}\n)\n"),
        arms => format!("{alias}: TypeAlias = (\n    {}\n)\n", arms.join("\n    | ")),
    }
}

/// The docstring of a type: its description and its words.
fn meanings(of: &Json, besides: Option<&str>) -> String {
    let (first, rest) = summary(description(of), 0);
    let words: Vec<_> = alternatives(of).into_iter().filter(|form| form["const"].is_string()).collect();
    let mut text = wrapped(&format!("\"\"\"{first}"), 0, 0);
    for paragraph in rest.split("\n\n").chain(besides).filter(|text| !text.is_empty()) {
        text += &format!("\n{}", wrapped(paragraph, 0, 0));
    }
    if !words.is_empty() {
        text.push('\n');
    }
    for word in words {
        let line = format!("* `{}`: {}", word["const"], description(word));
        text += &wrapped(&line, 0, 2);
    }
    if text.trim_end().contains('\n') { text + "\"\"\"\n" } else { text.trim_end().to_owned() + "\"\"\"\n" }
}

/// The docstring of a class: its description and its attributes.
fn docstring(schema: &Json, form: &Form, is_shared: bool) -> String {
    let (first, rest) = summary(form.description, 4);
    let mut text = wrapped(&format!("\"\"\"{first}"), 4, 4);
    for paragraph in rest.split("\n\n").filter(|text| !text.is_empty()) {
        text += &format!("\n{}", wrapped(paragraph, 4, 4));
    }
    let attribute = |name: &str, meaning: &str| format!("    {name}\n{}", wrapped(meaning, 8, 8));
    let name = is_shared.then(|| attribute("name", NAME));
    let keys = form.keys.iter().map(|key| {
        let itself = names::instead(form.definition, key.name)
            .map_or_else(String::new, |(_, text)| format!(" {text}"));
        attribute(&names::attribute(key.name), &(meaning(schema, key) + &itself))
    });
    let attributes: String = name.into_iter().chain(keys).collect();
    if attributes.is_empty() {
        let end = if rest.is_empty() { text.trim_end().to_owned() } else { text + "    " };
        return end + "\"\"\"\n";
    }
    format!("{text}\n    Attributes\n    ----------\n{attributes}\n    \"\"\"\n")
}
