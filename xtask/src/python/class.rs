//! Classes and type aliases of a definition as text.

use std::collections::BTreeSet;

use serde_json::Value as Json;

use super::form::{Form, Key, alternatives, definition, description, forms};
use super::hint::{arms, hint};
use super::names;
use super::text::{WIDTH, meaning, summary, wrapped};

const DATACLASS: &str = "@checked_arguments\n@dataclass(kw_only=True, slots=True, eq=False, repr=False)\n";
/// Description of the attribute `name` of a part whose name is its key in a table of the model.
const NAME: &str = "Key in the table of the model, for a part that is given instead of its name. Chosen automatically if omitted.";

/// The text of a class or a type alias.
#[derive(Default)]
pub(super) struct Block {
    pub(super) text: String,
    /// Name that the text defines.
    pub(super) name: String,
    /// Names that the text needs.
    pub(super) uses: BTreeSet<String>,
    /// Module of the text, if it is not the module of its definition.
    pub(super) module: Option<&'static str>,
}

impl Block {
    fn uses(&mut self, names: &[&str]) {
        self.uses.extend(names.iter().map(|name| (*name).to_owned()));
    }

    fn class(schema: &Json, form: &Form) -> Self {
        let base = names::base(form.definition, &form.class);
        let mut block = Self { name: form.class.clone(), module: form.module, ..Self::default() };
        block.uses(&["checked_arguments", "dataclass", base]);
        let mut text = format!("{DATACLASS}class {}({base}):\n", form.class);
        text += &docstring(schema, form, base == "Shared");
        text += &format!("\n    _form = {:?}\n", form.definition);
        if let Some((key, word)) = form.tag {
            block.uses(&["ClassVar", "Literal"]);
            text += &format!("    _tag = {key:?}\n    {key}: ClassVar[Literal[{word:?}]] = {word:?}\n");
        }
        text += &block.tables(form);
        if !form.keys.is_empty() {
            text.push('\n');
        }
        text.extend(form.keys.iter().map(|key| block.field(schema, form, key)));
        Self { text, ..block }
    }

    /// Returns the class attribute with the tables of the keys that accept a part instead of its name.
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
        if let Some((part, _)) = names::instead(form.definition, &form.class, key.name) {
            self.uses(&[part]);
            hint += &format!(" | {part}");
        }
        let is_positional = names::positional(&form.class).contains(&key.name);
        let value = match (key.is_required, is_positional) {
            (true, false) => "",
            (false, false) => " = None",
            (true, true) => " = field(kw_only=False)",
            (false, true) => " = field(default=None, kw_only=False)",
        };
        if is_positional {
            self.uses(&["field"]);
        }
        let none = if key.is_required { "" } else { " | None" };
        format!("    {}: {hint}{none}{value}\n", names::attribute(key.name))
    }

    /// The type alias of a definition with several forms, and the meanings of its words.
    fn alias(schema: &Json, name: &str, of: &Json, forms: &[Form]) -> Self {
        let alias = names::alias(name);
        let mut block = Self { name: alias.into(), ..Self::default() };
        let others: Vec<&Json> =
            alternatives(of).into_iter().filter(|form| !form["properties"].is_object()).collect();
        let others = serde_json::json!({ "oneOf": others });
        let mut all = arms(schema, &others, &mut block.uses);
        all.extend(forms.iter().map(|form| form.class.clone()));
        block.uses.extend(forms.iter().map(|form| form.class.clone()));
        let besides = names::besides(name);
        if let Some((callable, _)) = besides {
            block.uses(&["Callable"]);
            all.push(callable.into());
        }
        block.uses(&["TypeAlias"]);
        block.text = assigned(alias, &all) + &meanings(of, besides.map(|(_, text)| text));
        block
    }
}

/// Returns the classes of a definition, and its type alias if it has several forms.
pub(super) fn blocks(schema: &Json, name: &str) -> Vec<Block> {
    let of = definition(schema, name);
    let forms = forms(name, of);
    let mut blocks: Vec<Block> = forms.iter().map(|form| Block::class(schema, form)).collect();
    if !forms.iter().any(|form| form.class == names::alias(name)) || forms.len() > 1 {
        blocks.push(Block::alias(schema, name, of, &forms));
    }
    blocks
}

/// Returns the assignment of a type alias, wrapped to the line width.
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

/// Returns the docstring of a type alias: its description and its words.
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

/// Returns the docstring of a class: its description and its attributes.
fn docstring(schema: &Json, form: &Form, is_shared: bool) -> String {
    let (first, rest) = summary(form.description, 4);
    let mut text = wrapped(&format!("\"\"\"{first}"), 4, 4);
    for paragraph in rest.split("\n\n").filter(|text| !text.is_empty()) {
        text += &format!("\n{}", wrapped(paragraph, 4, 4));
    }
    let attribute = |name: &str, meaning: &str| format!("    {name}\n{}", wrapped(meaning, 8, 8));
    let name = is_shared.then(|| attribute("name", NAME));
    let keys = form.keys.iter().map(|key| {
        let instead = names::instead(form.definition, &form.class, key.name)
            .map_or_else(String::new, |(_, text)| format!(" {text}"));
        attribute(&names::attribute(key.name), &(meaning(schema, key) + &instead))
    });
    let attributes: String = name.into_iter().chain(keys).collect();
    if attributes.is_empty() {
        let end = if rest.is_empty() { text.trim_end().to_owned() } else { text + "    " };
        return end + "\"\"\"\n";
    }
    format!("{text}\n    Attributes\n    ----------\n{attributes}\n    \"\"\"\n")
}
