//! Tables of the keys of model files in `docs/model-file.md` and `docs/model-file`, generated from the JSON Schema.
//!
//! A line `<!-- keys: Joint revolute -->` starts a table of the form `revolute` of the definition `Joint`, and `<!-- end -->` ends
//! it. Without a form the table has all tagged forms of the definition. `only a b` and `without a b` select keys.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value as Json;

use super::description::Description;
use crate::python::form::{alternatives, definition, description, referred};
use crate::python::hint::kind;
use crate::python::single_analysis::single_analysis;
use crate::system::shell::Done;

const START: &str = "<!-- keys: ";
const END: &str = "<!-- end -->";

/// Descriptions of definitions: definition, text of the link, page in `docs/model-file` with its section.
const LINKS: [(&str, &str, &str); 30] = [
    ("ContactSurface", "obstacle", "contacts.md#obstacles"),
    ("Analysis", "analysis", "analysis.md"),
    ("AngularDrive", "drive", "drives.md"),
    ("AngularFriction", "friction", "drives.md"),
    ("AngularSpring", "spring", "drives.md"),
    ("AngularStops", "stops", "drives.md#stops"),
    ("Body", "body", "bodies.md"),
    ("Contact", "contact", "contacts.md"),
    ("Coupling", "coupling", "drives.md#couplings"),
    ("DisplayShape", "display shape", "bodies.md#display-shapes"),
    ("Formulation", "formulation", "bodies.md#formulations"),
    ("Initial", "initial state", "initial.md"),
    ("JointLaw", "force law", "drives.md#force-laws"),
    ("InitialMotion", "initial motion", "bodies.md#initial-motion"),
    ("Joint", "joint", "joints.md"),
    ("LinearDrive", "drive", "drives.md"),
    ("LinearFriction", "friction", "drives.md"),
    ("LinearSpring", "spring", "drives.md"),
    ("LinearStops", "stops", "drives.md#stops"),
    ("Load", "load", "loads.md"),
    ("Material", "material", "materials.md#materialsname"),
    ("Output", "output", "output.md#output"),
    ("Place", "place", "places.md"),
    ("Probe", "probe", "output.md#probes"),
    ("ScaleChoice", "scales", "analysis.md#scales"),
    ("Section", "section", "materials.md#sectionsname"),
    ("Shape", "shape", "bodies.md#shapes"),
    ("ShellSurface", "surface", "bodies.md#surfaces-of-shells"),
    ("Stop", "criterion", "analysis.md#convergence-criteria"),
    ("TimeFunction", "function of time", "functions.md"),
];

/// Pages with tables: the overview, and a page per section.
fn pages() -> Result<Vec<PathBuf>, String> {
    let overview = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/model-file.md");
    let folder = overview.with_extension("");
    let entries = fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let sections = entries.filter_map(|entry| Some(entry.ok()?.path()));
    let mut pages: Vec<_> = sections.filter(|path| path.extension().is_some_and(|end| end == "md")).collect();
    pages.push(overview);
    pages.sort();
    Ok(pages)
}

/// Writes the tables of all pages.
pub(crate) fn write(schema: &str) -> Done {
    for page in pages()? {
        let wrong = |error| format!("{}: {error}", page.display());
        let text = fs::read_to_string(&page).map_err(wrong)?;
        fs::write(&page, refreshed(&page, &text, schema)?).map_err(wrong)?;
    }
    Ok(())
}

/// Returns the text of a page with new tables.
///
/// # Errors
/// If a marker states an unknown definition, form or key, or has no end.
fn refreshed(page: &Path, text: &str, schema: &str) -> Result<String, String> {
    let schema = single_analysis(schema)?;
    let mut result = String::new();
    let mut rest = text;
    while let Some(at) = rest.find(START) {
        let after = &rest[at + START.len()..];
        let request = after.split_once(" -->").ok_or("a marker without `-->`")?.0;
        let end = after.find(END).ok_or_else(|| format!("`{request}`: no `{END}`"))?;
        let table =
            Request::of(request).table(&schema).map_err(|error| format!("{}: {error}", page.display()))?;
        let table = with_relative_links(&table, page);
        result += &format!("{}{START}{request} -->\n\n{table}\n{END}", &rest[..at]);
        rest = &after[end + END.len()..];
    }
    Ok(result + rest)
}

/// Table with links relative to its page: the overview is one folder above the sections, links within a page have no path.
fn with_relative_links(table: &str, page: &Path) -> String {
    let name = page.file_name().unwrap_or_default().to_string_lossy();
    if name == "model-file.md" {
        return LINKS.iter().fold(table.to_owned(), |text, (.., target)| {
            text.replace(&format!("({target})"), &format!("(model-file/{target})"))
        });
    }
    table.replace(&format!("({name}#"), "(#")
}

/// Content of a table as stated by its marker.
struct Request<'a> {
    definition: &'a str,
    form: Option<&'a str>,
    only: Vec<&'a str>,
    without: Vec<&'a str>,
}

impl<'a> Request<'a> {
    fn of(text: &'a str) -> Self {
        let mut words = text.split_whitespace().peekable();
        let definition = words.next().unwrap_or_default();
        let form = words.next_if(|word| !["only", "without"].contains(word));
        let choice = words.next();
        let keys: Vec<&str> = words.collect();
        let (only, without) = if choice == Some("only") { (keys, Vec::new()) } else { (Vec::new(), keys) };
        Self { definition, form, only, without }
    }

    fn table(&self, schema: &Json) -> Result<String, String> {
        let unknown = |what: &str| format!("the schema has no {what} of `{}`", self.definition);
        let tables: Vec<&Json> = alternatives(definition(schema, self.definition))
            .into_iter()
            .filter(|form| form["properties"].is_object())
            .collect();
        let all: BTreeSet<&str> = tables.iter().flat_map(|form| keys(form)).map(|(key, _)| key).collect();
        if let Some(key) = self.only.iter().chain(&self.without).find(|key| !all.contains(*key)) {
            return Err(unknown(&format!("key `{key}`")));
        }
        let is_listed =
            |key: &str| (self.only.is_empty() || self.only.contains(&key)) && !self.without.contains(&key);
        let Some(word) = self.form else {
            return match &tables[..] {
                [] => Err(unknown("tables")),
                [table] if tag(table).is_none() => Ok(table_of(&rows(schema, table, &is_listed))),
                forms => Ok(table_of_forms(schema, forms, &is_listed)),
            };
        };
        let is_form = |form: &&&Json| {
            tag(form).map_or_else(|| keys(form).any(|(key, _)| key == word), |(_, own)| own == word)
        };
        let form = tables.iter().find(is_form).ok_or_else(|| unknown(&format!("form `{word}`")))?;
        Ok(table_of(&rows(schema, form, &is_listed)))
    }
}

/// Cells of a row: key, type, unit, default, meaning.
type Row = [String; 5];

fn table_of(rows: &[Row]) -> String {
    let mut text = "| key | type | unit | default | meaning |\n|---|---|---|---|---|\n".to_owned();
    rows.iter().for_each(|row| text += &line(row));
    text
}

/// Table of several forms. The first row of a form has its tag and description.
fn table_of_forms(schema: &Json, forms: &[&Json], is_listed: &dyn Fn(&str) -> bool) -> String {
    let key = forms.iter().find_map(|form| tag(form)).map_or("form", |(key, _)| key);
    let mut text =
        format!("| `{key}` | key | type | unit | default | meaning |\n|---|---|---|---|---|---|\n");
    for form in forms {
        let word = tag(form).map(|(_, word)| format!("`\"{word}\"`")).unwrap_or_default();
        let about = Description::of(description(form)).meaning;
        text += &line(&[word, String::new(), String::new(), String::new(), String::new(), about]);
        for row in rows(schema, form, is_listed) {
            text += &line(&[&[String::new()][..], &row[..]].concat());
        }
    }
    text
}

fn line(cells: &[String]) -> String {
    let cells = cells.iter().map(|cell| cell.replace('|', "\\|"));
    let cells = cells.map(|cell| if cell.is_empty() { " ".into() } else { format!(" {cell} ") });
    format!("|{}|\n", cells.collect::<Vec<_>>().join("|"))
}

/// Tag of a form: key and word.
fn tag(form: &Json) -> Option<(&str, &str)> {
    keys(form).find_map(|(key, schema)| Some((key, schema["const"].as_str()?)))
}

fn keys(form: &Json) -> impl Iterator<Item = (&str, &Json)> {
    form["properties"].as_object().into_iter().flatten().map(|(key, schema)| (key.as_str(), schema))
}

/// Rows of a form: required keys in the order of the type, then optional keys. Tables without a section of their own are nested.
fn rows(schema: &Json, form: &Json, is_listed: &dyn Fn(&str) -> bool) -> Vec<Row> {
    let mut rows = Vec::new();
    for (key, of, is_required) in ordered_keys(form).filter(|(key, ..)| is_listed(key)) {
        let Some((table, brackets)) = nested(schema, of) else {
            rows.push(row(schema, key, of, if is_required { "required" } else { "none" }));
            continue;
        };
        let default = of.get("default").unwrap_or(&Json::Null);
        for (inner, inner_of, is_inner_required) in ordered_keys(table) {
            let absent = match (is_inner_required, is_required, &default[inner]) {
                (true, true, _) => "required".to_owned(),
                (true, false, Json::Null) => format!("required in `{key}`"),
                (_, _, Json::Null) => "none".to_owned(),
                (_, _, value) => format!("`{}`", toml(value)),
            };
            rows.push(row(schema, &format!("{key}{brackets}.{inner}"), inner_of, &absent));
        }
    }
    rows
}

/// Keys of a form without its tag: required keys in the order of the type, then optional keys. The flag is true if required.
fn ordered_keys(form: &Json) -> impl Iterator<Item = (&str, &Json, bool)> {
    let required: Vec<&str> =
        form["required"].as_array().into_iter().flatten().filter_map(Json::as_str).collect();
    let mut keys: Vec<_> = keys(form).filter(|(_, schema)| schema["const"].is_null()).collect();
    keys.sort_by_key(|(key, _)| required.iter().position(|other| other == key).unwrap_or(required.len()));
    keys.into_iter().map(move |(key, of)| (key, of, required.contains(&key)))
}

/// Form of a table, or of the tables of an array, that has no section of its own.
fn nested<'a>(schema: &'a Json, of: &'a Json) -> Option<(&'a Json, &'static str)> {
    let (of, brackets) = if of["items"].is_object() { (&of["items"], "[]") } else { (of, "") };
    let [form] = alternatives(of)[..] else { return None };
    let name = referred(form).filter(|name| link(name).is_none())?;
    let table = definition(schema, name);
    (table["properties"].is_object() && tag(table).is_none()).then_some((table, brackets))
}

/// Row of a key. `absent` is the entry of the column `default` without a default value.
fn row(schema: &Json, path: &str, of: &Json, absent: &str) -> Row {
    let Description { meaning, default } = Description::of(description(of));
    let stated = of.get("default").filter(|value| !value.is_null()).map(|value| format!("`{}`", toml(value)));
    let default = stated.or(default).unwrap_or_else(|| absent.to_owned());
    let mut units = Vec::new();
    collect_units(schema, of, &mut units);
    [format!("`{path}`"), joined(&types(schema, of)), units.join(" or "), default, meaning]
}

/// Types that a schema allows.
fn types(schema: &Json, of: &Json) -> Vec<String> {
    alternatives(of).into_iter().flat_map(|form| type_of(schema, form)).collect()
}

fn type_of(schema: &Json, of: &Json) -> Vec<String> {
    if let Some(name) = referred(of) {
        return match link(name) {
            Some(link) => vec![link],
            None => types(schema, definition(schema, name)),
        };
    }
    if let Some(word) = of["const"].as_str() {
        return vec![format!("`\"{word}\"`")];
    }
    vec![match kind(of) {
        "number" => format!("number{}", limits(of)),
        "integer" => format!("integer{}", limits(of)),
        "string" => "text".into(),
        "array" => {
            let items = joined(&types(schema, &of["items"]));
            match (of["minItems"].as_u64(), of["maxItems"].as_u64()) {
                (Some(min), Some(max)) if min == max => format!("[{items}; {min}]"),
                (Some(min), Some(max)) => format!("[{items}; {min} to {max}]"),
                _ => format!("[{items}, ..]"),
            }
        }
        "object" if of["additionalProperties"].is_object() => {
            format!("table of {}", joined(&types(schema, &of["additionalProperties"])))
        }
        "object" => {
            let required: Vec<_> =
                of["required"].as_array().into_iter().flatten().filter_map(Json::as_str).collect();
            let quoted = |keys: &[&str]| keys.iter().map(|key| format!("`{key}`")).collect::<Vec<_>>();
            let optional: Vec<_> =
                of["properties"].as_object().into_iter().flatten().map(|(key, _)| key.as_str()).collect();
            match &required[..] {
                [] => format!("table with {}", joined(&quoted(&optional))),
                keys => format!("table with {}", quoted(keys).join(", ")),
            }
        }
        kind => kind.into(),
    }]
}

fn joined(types: &[String]) -> String {
    match types.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} or {last}", rest.join(", ")),
        _ => types.concat(),
    }
}

fn link(name: &str) -> Option<String> {
    let (_, text, target) = LINKS.iter().find(|(definition, ..)| *definition == name)?;
    Some(format!("[{text}]({target})"))
}

fn limits(of: &Json) -> String {
    let signs = [("exclusiveMinimum", ">"), ("minimum", "≥"), ("exclusiveMaximum", "<"), ("maximum", "≤")];
    let limits: Vec<_> = signs
        .iter()
        .filter(|(key, _)| !of[*key].is_null())
        .map(|(key, sign)| format!(" {sign} {}", of[*key].to_string().replace('-', "−")))
        .collect();
    limits.join(" and")
}

/// Collects the units of a schema and of its alternatives without a section of their own.
fn collect_units(schema: &Json, of: &Json, units: &mut Vec<String>) {
    let mut add = |unit: String| {
        if !units.contains(&unit) {
            units.push(unit);
        }
    };
    match &of["x-unit"] {
        Json::String(unit) => return add(printed(unit)),
        Json::Array(all) => {
            let all: Vec<&str> = all.iter().filter_map(Json::as_str).collect();
            let groups = all.chunk_by(|a, b| a == b).map(|group| printed(group[0]));
            return add(groups.collect::<Vec<_>>().join(", "));
        }
        _ => {}
    }
    for form in alternatives(of) {
        if let Some(name) = referred(form).filter(|name| link(name).is_none()) {
            collect_units(schema, definition(schema, name), units);
        } else if form["x-unit"] != of["x-unit"] {
            collect_units(schema, form, units);
        }
    }
}

/// Unit in the form `force·length/time²`.
fn printed(unit: &str) -> String {
    unit.replace('*', "·").replace("^2", "²").replace("^3", "³").replace("^4", "⁴")
}

/// Value as in a model file.
fn toml(value: &Json) -> String {
    match value {
        Json::Array(items) => format!("[{}]", items.iter().map(toml).collect::<Vec<_>>().join(", ")),
        Json::Object(table) => {
            let entries = table.iter().map(|(key, value)| format!("{key} = {}", toml(value)));
            format!("{{ {} }}", entries.collect::<Vec<_>>().join(", "))
        }
        Json::Number(number) => number.as_f64().map_or_else(String::new, |x| {
            if x != 0.0 && x.abs() < 1e-4 { format!("{x:e}") } else { x.to_string() }
        }),
        value => value.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tables_of_keys_are_up_to_date() {
        let schema = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/model.schema.json");
        let schema = fs::read_to_string(schema).expect("the schema");
        let mut tables = 0;
        for page in pages().expect("the folder of the pages") {
            let text = fs::read_to_string(&page).expect("the page");
            tables += text.matches(START).count();
            let new = refreshed(&page, &text, &schema).expect("tables");
            assert!(text == new, "{} is stale: refresh it by `cargo xtask schema`", page.display());
        }
        assert!(tables > 30, "the pages have tables");
    }

    #[test]
    fn unknown_forms_and_keys_are_errors() {
        let schema = r#"{"$defs": {"Circle": {"properties": {"diameter": {"type": "number"}}}}}"#;
        let page = Path::new("bodies.md");
        let table = |request: &str| refreshed(page, &format!("{START}{request} -->\n{END}\n"), schema);
        assert!(table("Circle").is_ok_and(|text| text.contains("| `diameter` | number |")));
        assert!(table("Circle without radius").is_err_and(|error| error.contains("key `radius`")));
        assert!(table("Square").is_err_and(|error| error.contains("no tables of `Square`")));
        assert!(refreshed(page, &format!("{START}Circle -->\n"), schema).is_err());
    }
    #[test]
    fn links_are_relative_to_their_page() {
        let table = "[shape](bodies.md#shapes), [place](places.md)";
        let on = |page: &str| with_relative_links(table, Path::new(page));
        assert_eq!(on("docs/model-file/bodies.md"), "[shape](#shapes), [place](places.md)");
        assert_eq!(
            on("docs/model-file.md"),
            "[shape](model-file/bodies.md#shapes), [place](model-file/places.md)"
        );
    }
}
