//! Changes of values in the data of a model by paths, such as `bodies.rod.material.young`.

use std::borrow::Cow;

use serde_json::Value as Json;
use toml::{Table, Value};

use crate::errors::{ModelError, listed, nearest, quoted};
use crate::schema::{PathStep, SCHEMA, did_you_mean, forms, found, keys, kind, path_of, path_steps, tag};

/// Keys whose values are names, and the tables or arrays of the named items.
const REFERENCES: [(&str, &str); 5] = [
    ("material", "materials"),
    ("section", "sections"),
    ("section_end", "sections"),
    ("body", "bodies"),
    ("joint", "joints"),
];

/// Sets a value in the data of a model, from which a [`Model`](crate::model::Model) is then read; returns the paths that were
/// set.
///
/// | path | meaning |
/// |---|---|
/// | `analysis.step`, `gravity[1]` | keys separated by dots, indices of components from 0 |
/// | `joints.root.stiffness`, `loads[0].force` | items of arrays by their `name`, or by their index from 0 |
/// | `bodies.rod.material.young` | a key of the named item, here `materials.steel.young`; it changes for all bodies that use it |
/// | `elements` | a key of bodies, not of the model: set in every body that can have it |
///
/// A missing key is added if the schema contains it. The value is checked when the model is read.
///
/// # Errors
/// If the path does not exist. The error states the first part of the path that does not exist; the data are unchanged.
///
/// ```
/// let mut data: toml::Value = toml::from_str(r#"
///     materials.steel = { density = 7850, young = 2.1e11 }
///     bodies = [{ kind = "cable", name = "rope", material = "steel" }]
/// "#)?;
/// let set = ancf::reading::substitute(&mut data, "bodies.rope.material.young", 2e11.into())?;
/// assert_eq!(set, ["materials.steel.young"]);
///
/// let error = ancf::reading::substitute(&mut data, "bodies.rop.elements", 3.into()).unwrap_err();
/// assert_eq!(error.to_string(), "bodies.rop: found no `rop`, expected `rope` (did you mean `rope`?)");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn substitute(data: &mut Value, path: &str, value: Value) -> Result<Vec<String>, ModelError> {
    let mut locations: Vec<Vec<ResolvedStep>> = Vec::new();
    for location in resolve(data, &path_steps(path)?)? {
        if !locations
            .iter()
            .any(|other| path_of(other.iter().map(|resolved| &resolved.step)) == location.path())
        {
            locations.push(location.steps);
        }
    }
    for steps in &locations {
        set(data, steps, &value);
    }
    Ok(locations.iter().map(|steps| path_of(steps.iter().map(|resolved| &resolved.step))).collect())
}

/// Returns the values to which a path refers, each with its path: those of the data, or the defaults of missing keys.
///
/// # Errors
/// As [`substitute`].
///
/// ```
/// let data: toml::Value = toml::from_str(r#"
///     materials.steel = { density = 7850, young = 2.1e11 }
///     bodies = [{ kind = "cable", name = "rope", material = "steel" }]
/// "#)?;
/// let found = ancf::reading::values_at(&data, "bodies.rope.material.young")?;
/// assert_eq!(found, [("materials.steel.young".to_owned(), Some(toml::Value::Float(2.1e11)))]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn values_at(data: &Value, path: &str) -> Result<Vec<(String, Option<Value>)>, ModelError> {
    let found = resolve(data, &path_steps(path)?)?;
    Ok(found.into_iter().map(|location| (location.path(), location.value.map(Cow::into_owned))).collect())
}

/// Step of a path that was found in the schema.
#[derive(Clone)]
struct ResolvedStep {
    step: PathStep,
    /// Value that is added if the data has none.
    initial: Value,
}

/// Location in the data with its schema.
#[derive(Clone)]
struct Location<'a> {
    steps: Vec<ResolvedStep>,
    schema: &'static Json,
    /// Value in the data, or the default of a missing value; `None` without a default.
    value: Option<Cow<'a, Value>>,
}

/// Returns the locations to which a path refers.
fn resolve<'a>(data: &'a Value, path: &[PathStep]) -> Result<Vec<Location<'a>>, ModelError> {
    let root = Location { steps: Vec::new(), schema: &SCHEMA, value: Some(Cow::Borrowed(data)) };
    let walk = |from: &Location<'a>| {
        (1..=path.len())
            .try_fold(from.clone(), |location, end| location.dereferenced(&root).step(&path[..end]))
    };
    let PathStep::Key(first) = &path[0] else { return walk(&root).map(|location| vec![location]) };
    if !SCHEMA["properties"][first].is_null() {
        return walk(&root).map(|location| vec![location]);
    }
    let bodies = root.clone().step(&[PathStep::Key("bodies".into())])?;
    let count = bodies.value.as_ref().and_then(|value| value.as_array()).map_or(0, Vec::len);
    let bodies = (0..count).map(|i| bodies.clone().step(&[PathStep::Index(i)]));
    let bodies = bodies.filter(|body| body.as_ref().is_ok_and(|body| body.keys().contains(&&**first)));
    let locations: Vec<_> = bodies.map(|body| walk(&body?)).collect::<Result<_, _>>()?;
    if locations.is_empty() {
        let of_bodies = || forms(&SCHEMA["properties"]["bodies"]["items"]).into_iter().flat_map(keys);
        let is_known = of_bodies().any(|key| key == first);
        let found = if is_known { format!("no body that can have `{first}`") } else { unknown(first) };
        let expected = "a key of the model or of a body".to_owned();
        let near = nearest(first, keys(&SCHEMA).into_iter().chain(of_bodies())).filter(|_| !is_known);
        return Err(did_you_mean(ModelError::new(path_of(&path[..1]), found, expected), near.map(ticked)));
    }
    Ok(locations)
}

impl<'a> Location<'a> {
    /// Returns the location of the named item, if the value is a name, else the location itself.
    fn dereferenced(self, root: &Self) -> Self {
        let Some(PathStep::Key(key)) = self.steps.last().map(|resolved| &resolved.step) else { return self };
        let Some((_, list)) = REFERENCES.iter().find(|(name, _)| name == key) else { return self };
        let Some(name) = self.value.as_ref().and_then(|value| value.as_str()) else { return self };
        let list = root.clone().step(&[PathStep::Key((*list).into())]);
        let named = list.and_then(|list| list.step(&[PathStep::Key(name.into())]));
        // An unknown name is an error of the model. The next step reports it like any other text.
        named.unwrap_or(self)
    }

    /// Follows the last step of a path.
    fn step(self, path: &[PathStep]) -> Result<Self, ModelError> {
        let Some(step) = path.last() else { return Ok(self) };
        match (self.value.as_deref(), step) {
            (Some(Value::Table(_)), PathStep::Key(key)) => self.entry(key, path),
            (Some(Value::Array(_)), PathStep::Key(name)) => self.named_item(name, path),
            (Some(Value::Array(items)), PathStep::Index(i)) => {
                let count = items.len();
                if *i < count { Ok(self.item(*i)) } else { Err(out_of_range(*i, count, path)) }
            }
            (value, step) => Err(no_such_step(value, step, path)),
        }
    }

    /// Keys that the schema allows.
    fn keys(&self) -> Vec<&'static str> {
        self.forms().into_iter().flat_map(keys).collect()
    }

    /// Forms that the schema allows for the table; one form if the table states its tag.
    fn forms(&self) -> Vec<&'static Json> {
        let mut tables = forms(self.schema);
        tables.retain(|form| kind(form) == "object");
        let is_stated =
            |form: &&'static Json| tag(form).is_some_and(|(key, word)| self.text(key) == Some(word));
        match tables.iter().copied().find(is_stated) {
            Some(form) => vec![form],
            None => tables,
        }
    }

    /// Text of a key of the table.
    fn text(&self, key: &str) -> Option<&str> {
        self.value.as_deref()?.get(key)?.as_str()
    }

    fn entry(self, key: &str, path: &[PathStep]) -> Result<Self, ModelError> {
        let forms = self.forms();
        let any_key = forms.first().map(|form| &form["additionalProperties"]).filter(|any| any.is_object());
        if let Some(schema) = any_key {
            let names: Vec<&str> = self
                .value
                .as_deref()
                .and_then(Value::as_table)
                .into_iter()
                .flat_map(Table::keys)
                .map(|name| &**name)
                .collect();
            if !names.contains(&key) {
                return Err(no_such_name(key, &names, path));
            }
            return Ok(self.child(PathStep::Key(key.into()), schema));
        }
        let properties = forms.iter().map(|form| &form["properties"][key]);
        match properties.into_iter().find(|schema| !schema.is_null()) {
            Some(schema) => Ok(self.child(PathStep::Key(key.into()), schema)),
            None => {
                let mut known = self.keys();
                known.sort_unstable();
                known.dedup();
                let near = nearest(key, known.iter().copied());
                let expected = listed(known.iter().copied().map(ticked), "or");
                Err(did_you_mean(ModelError::new(path_of(path), unknown(key), expected), near.map(ticked)))
            }
        }
    }

    /// Item of an array by its name.
    fn named_item(self, name: &str, path: &[PathStep]) -> Result<Self, ModelError> {
        let items = self.value.as_deref().and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
        let names: Vec<_> = items.iter().filter_map(|item| item.get("name")?.as_str()).collect();
        let index = items.iter().position(|item| item.get("name").and_then(Value::as_str) == Some(name));
        match index {
            Some(i) => Ok(self.item(i)),
            None if names.is_empty() && !items.is_empty() => {
                let expected =
                    format!("an index from 0 in brackets, such as `{}[0]`", path_of(&path[..path.len() - 1]));
                Err(ModelError::new(
                    path_of(path),
                    format!("`{name}` after {}", found(&Value::Array(items.to_vec()))),
                    expected,
                ))
            }
            None => Err(no_such_name(name, &names, path)),
        }
    }

    fn item(self, i: usize) -> Self {
        let array = forms(self.schema).into_iter().find(|form| kind(form) == "array");
        let schema = array.map_or(&Json::Null, |array| &array["items"]);
        self.child(PathStep::Index(i), schema)
    }

    fn child(self, step: PathStep, schema: &'static Json) -> Self {
        let value = match self.value {
            Some(Cow::Borrowed(value)) => step.of(value).map(Cow::Borrowed),
            Some(Cow::Owned(value)) => step.of(&value).cloned().map(Cow::Owned),
            None => None,
        };
        let initial = initial(schema);
        let value = value.or_else(|| initial.clone().map(Cow::Owned));
        let mut steps = self.steps;
        steps.push(ResolvedStep { step, initial: initial.unwrap_or(Value::Table(Table::new())) });
        Self { steps, schema, value }
    }

    fn path(&self) -> String {
        path_of(self.steps.iter().map(|resolved| &resolved.step))
    }
}

/// Value of a missing key: its default, an empty table, or an empty array of tables.
fn initial(schema: &'static Json) -> Option<Value> {
    let default = schema.get("default").and_then(|default| Value::try_from(default).ok());
    default.or_else(|| {
        forms(schema).into_iter().find_map(|form| match kind(form) {
            "object" => Some(Value::Table(Table::new())),
            "array" if kind(forms(&form["items"])[0]) == "object" => Some(Value::Array(Vec::new())),
            _ => None,
        })
    })
}

/// Sets a value at a location that was found in this data.
fn set(data: &mut Value, steps: &[ResolvedStep], value: &Value) {
    let Some((first, rest)) = steps.split_first() else { return data.clone_from(value) };
    let next = match (&first.step, data) {
        (PathStep::Key(key), Value::Table(table)) => {
            Some(table.entry(key.clone()).or_insert_with(|| first.initial.clone()))
        }
        (PathStep::Index(i), Value::Array(items)) => items.get_mut(*i),
        _ => None,
    };
    if let Some(next) = next {
        set(next, rest, value);
    }
}

fn ticked(key: &str) -> String {
    format!("`{key}`")
}

fn unknown(key: &str) -> String {
    format!("unknown key `{key}`")
}

fn no_such_name(name: &str, names: &[&str], path: &[PathStep]) -> ModelError {
    let expected = match names {
        [] => "a path without a name, since there are no items".to_owned(),
        names => listed(names.iter().copied().map(ticked), "or"),
    };
    let error = ModelError::new(path_of(path), format!("no `{name}`"), expected);
    did_you_mean(error, nearest(name, names.iter().copied()).map(ticked))
}

fn out_of_range(i: usize, count: usize, path: &[PathStep]) -> ModelError {
    let expected = match count {
        0 => "a path without an index, since there are no items".to_owned(),
        1 => "the only item, `[0]`".to_owned(),
        _ => format!("an index from `[0]` to `[{}]`", count - 1),
    };
    ModelError::new(path_of(path), format!("index `[{i}]`"), expected)
}

/// Error of a path that is too long, or that has an index where there are keys.
fn no_such_step(value: Option<&Value>, step: &PathStep, path: &[PathStep]) -> ModelError {
    let before = path_of(&path[..path.len() - 1]);
    let (found, expected) = match (value, step) {
        (Some(Value::Table(_)), PathStep::Index(i)) => {
            (format!("index `[{i}]` of a table"), "a key".to_owned())
        }
        (Some(Value::String(text)), _) => (format!("the text {} before it", quoted(text)), path_end(&before)),
        (Some(value), _) => (format!("{} before it", found(value)), path_end(&before)),
        (None, _) => (format!("no `{before}` before it"), format!("a value for `{before}` as a whole")),
    };
    ModelError::new(path_of(path), found, expected)
}

fn path_end(before: &str) -> String {
    format!("a path that ends with `{before}`")
}
