//! Values set in the data of a model by paths that people write, such as `bodies.rod.material.young`.

use std::borrow::Cow;

use serde_json::Value as Json;
use toml::{Table, Value};

use crate::errors::{ModelError, listed, nearest, quoted};
use crate::schema::{SCHEMA, Step, did_you_mean, forms, found, keys, kind, segments, spelt, tag};

/// Keys whose texts are names of something, and where that is.
const REFERENCES: [(&str, &str); 5] = [
    ("material", "materials"),
    ("section", "sections"),
    ("section_end", "sections"),
    ("body", "bodies"),
    ("joint", "joints"),
];

/// Sets a value in the data of a model, before this becomes a [`Model`](crate::model::Model); returns the paths that were set.
///
/// | path | what it means |
/// |---|---|
/// | `analysis.step`, `gravity[1]` | keys with dots, places in vectors from 0 |
/// | `joints.root.stiffness`, `loads[0].force` | items of arrays by their `name`, or by their place from 0 |
/// | `bodies.rod.material.young` | a name is followed to what it names, here `materials.steel.young`: for all that use it |
/// | `elements` | a key that is none of a model's own: that of every body that may have it |
///
/// A key that was left out is set if the schema knows it. Whether the value suits is found when the model is read.
///
/// # Errors
/// If the path leads nowhere, at the part of it that does; the data is then as it was.
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
/// assert_eq!(error.to_string(), "bodies.rop: found no `rop`, wanted `rope` (did you mean `rope`?)");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn substitute(data: &mut Value, path: &str, value: Value) -> Result<Vec<String>, ModelError> {
    let mut places: Vec<Vec<Sought>> = Vec::new();
    for place in resolve(data, &segments(path)?)? {
        if !places.iter().any(|other| spelt(other.iter().map(|sought| &sought.step)) == place.path()) {
            places.push(place.steps);
        }
    }
    for place in &places {
        put(data, place, &value);
    }
    Ok(places.iter().map(|place| spelt(place.iter().map(|sought| &sought.step))).collect())
}

/// A step to a place in the data.
#[derive(Clone)]
struct Sought {
    step: Step,
    /// What to put there on the way if there is nothing yet.
    otherwise: Value,
}

/// A place in the data, and what the schema says of it.
#[derive(Clone)]
struct Place<'a> {
    steps: Vec<Sought>,
    schema: &'static Json,
    /// What is there, or what is meant if there is nothing; `None` if nothing can be meant.
    value: Option<Cow<'a, Value>>,
}

/// The places that a path means.
fn resolve<'a>(data: &'a Value, path: &[Step]) -> Result<Vec<Place<'a>>, ModelError> {
    let root = Place { steps: Vec::new(), schema: &SCHEMA, value: Some(Cow::Borrowed(data)) };
    let walk = |from: &Place<'a>| {
        (1..=path.len()).try_fold(from.clone(), |place, end| place.followed(&root).step(&path[..end]))
    };
    let Step::Key(first) = &path[0] else { return walk(&root).map(|place| vec![place]) };
    if !SCHEMA["properties"][first].is_null() {
        return walk(&root).map(|place| vec![place]);
    }
    let bodies = root.clone().step(&[Step::Key("bodies".into())])?;
    let count = bodies.value.as_ref().and_then(|value| value.as_array()).map_or(0, Vec::len);
    let places = (0..count).map(|i| bodies.clone().step(&[Step::Index(i)]));
    let places = places.filter(|body| body.as_ref().is_ok_and(|body| body.keys().contains(&&**first)));
    let places: Vec<_> = places.map(|body| walk(&body?)).collect::<Result<_, _>>()?;
    if places.is_empty() {
        let of_bodies = || forms(&SCHEMA["properties"]["bodies"]["items"]).into_iter().flat_map(keys);
        let known = of_bodies().any(|key| key == first);
        let found = if known { format!("no body that may have `{first}`") } else { unknown(first) };
        let wanted = "a key of the model or of a body".to_owned();
        let near = nearest(first, keys(&SCHEMA).into_iter().chain(of_bodies())).filter(|_| !known);
        return Err(did_you_mean(ModelError::new(spelt(&path[..1]), found, wanted), near.map(ticked)));
    }
    Ok(places)
}

impl<'a> Place<'a> {
    /// The place that is named here, if what is here is the name of something.
    fn followed(self, root: &Self) -> Self {
        let Some(Step::Key(key)) = self.steps.last().map(|sought| &sought.step) else { return self };
        let Some((_, list)) = REFERENCES.iter().find(|(name, _)| name == key) else { return self };
        let Some(name) = self.value.as_ref().and_then(|value| value.as_str()) else { return self };
        let list = root.clone().step(&[Step::Key((*list).into())]);
        let named = list.and_then(|list| list.step(&[Step::Key(name.into())]));
        // A name of nothing is an error of the model, which ends the walk here as any text does.
        named.unwrap_or(self)
    }

    /// One step on: the last of a path.
    fn step(self, path: &[Step]) -> Result<Self, ModelError> {
        let Some(step) = path.last() else { return Ok(self) };
        match (self.value.as_deref(), step) {
            (Some(Value::Table(_)), Step::Key(key)) => self.entry(key, path),
            (Some(Value::Array(_)), Step::Key(name)) => self.named(name, path),
            (Some(Value::Array(items)), Step::Index(i)) => {
                let count = items.len();
                if *i < count { Ok(self.item(*i)) } else { Err(out_of_range(*i, count, path)) }
            }
            (value, step) => Err(no_way_on(value, step, path)),
        }
    }

    /// The keys that the schema admits here.
    fn keys(&self) -> Vec<&'static str> {
        self.forms().into_iter().flat_map(keys).collect()
    }

    /// The forms of the table that is here.
    fn forms(&self) -> Vec<&'static Json> {
        let mut tables = forms(self.schema);
        tables.retain(|form| kind(form) == "object");
        let is_said =
            |form: &&'static Json| tag(form).is_some_and(|(key, word)| self.text(key) == Some(word));
        match tables.iter().copied().find(is_said) {
            Some(form) => vec![form],
            None => tables,
        }
    }

    /// The text of a key of the table that is here.
    fn text(&self, key: &str) -> Option<&str> {
        self.value.as_deref()?.get(key)?.as_str()
    }

    fn entry(self, key: &str, path: &[Step]) -> Result<Self, ModelError> {
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
            return Ok(self.go(Step::Key(key.into()), schema));
        }
        let properties = forms.iter().map(|form| &form["properties"][key]);
        match properties.into_iter().find(|schema| !schema.is_null()) {
            Some(schema) => Ok(self.go(Step::Key(key.into()), schema)),
            None => {
                let mut known = self.keys();
                known.sort_unstable();
                known.dedup();
                let near = nearest(key, known.iter().copied());
                let wanted = listed(known.iter().copied().map(ticked), "or");
                Err(did_you_mean(ModelError::new(spelt(path), unknown(key), wanted), near.map(ticked)))
            }
        }
    }

    /// The item of a name.
    fn named(self, name: &str, path: &[Step]) -> Result<Self, ModelError> {
        let items = self.value.as_deref().and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
        let names: Vec<_> = items.iter().filter_map(|item| item.get("name")?.as_str()).collect();
        let place = items.iter().position(|item| item.get("name").and_then(Value::as_str) == Some(name));
        match place {
            Some(i) => Ok(self.item(i)),
            None if names.is_empty() && !items.is_empty() => {
                let wanted =
                    format!("a place from 0 in brackets, such as `{}[0]`", spelt(&path[..path.len() - 1]));
                Err(ModelError::new(
                    spelt(path),
                    format!("`{name}` after {}", found(&Value::Array(items.to_vec()))),
                    wanted,
                ))
            }
            None => Err(no_such_name(name, &names, path)),
        }
    }

    fn item(self, i: usize) -> Self {
        let array = forms(self.schema).into_iter().find(|form| kind(form) == "array");
        let schema = array.map_or(&Json::Null, |array| &array["items"]);
        self.go(Step::Index(i), schema)
    }

    fn go(self, step: Step, schema: &'static Json) -> Self {
        let value = match self.value {
            Some(Cow::Borrowed(value)) => step.of(value).map(Cow::Borrowed),
            Some(Cow::Owned(value)) => step.of(&value).cloned().map(Cow::Owned),
            None => None,
        };
        let otherwise = initial(schema);
        let value = value.or_else(|| otherwise.clone().map(Cow::Owned));
        let mut steps = self.steps;
        steps.push(Sought { step, otherwise: otherwise.unwrap_or(Value::Table(Table::new())) });
        Self { steps, schema, value }
    }

    fn path(&self) -> String {
        spelt(self.steps.iter().map(|sought| &sought.step))
    }
}

/// What a key means that was left out: its default, a table to be filled, or no items.
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

/// Puts a value at a place that was found in this data.
fn put(data: &mut Value, place: &[Sought], value: &Value) {
    let Some((first, rest)) = place.split_first() else { return data.clone_from(value) };
    let next = match (&first.step, data) {
        (Step::Key(key), Value::Table(table)) => {
            Some(table.entry(key.clone()).or_insert_with(|| first.otherwise.clone()))
        }
        (Step::Index(i), Value::Array(items)) => items.get_mut(*i),
        _ => None,
    };
    if let Some(next) = next {
        put(next, rest, value);
    }
}

fn ticked(key: &str) -> String {
    format!("`{key}`")
}

fn unknown(key: &str) -> String {
    format!("unknown key `{key}`")
}

fn no_such_name(name: &str, names: &[&str], path: &[Step]) -> ModelError {
    let wanted = match names {
        [] => "a name, of which there are none".to_owned(),
        names => listed(names.iter().copied().map(ticked), "or"),
    };
    let error = ModelError::new(spelt(path), format!("no `{name}`"), wanted);
    did_you_mean(error, nearest(name, names.iter().copied()).map(ticked))
}

fn out_of_range(i: usize, count: usize, path: &[Step]) -> ModelError {
    let wanted = match count {
        0 => "an item, of which there are none".to_owned(),
        1 => "the only item, `[0]`".to_owned(),
        _ => format!("a place from `[0]` to `[{}]`", count - 1),
    };
    ModelError::new(spelt(path), format!("place `[{i}]`"), wanted)
}

/// A path that goes on where it should end, or wants an item where there are keys.
fn no_way_on(value: Option<&Value>, step: &Step, path: &[Step]) -> ModelError {
    let before = spelt(&path[..path.len() - 1]);
    let (found, wanted) = match (value, step) {
        (Some(Value::Table(_)), Step::Index(i)) => (format!("place `[{i}]` of a table"), "a key".to_owned()),
        (Some(Value::String(text)), _) => (format!("the text {} before it", quoted(text)), ends(&before)),
        (Some(value), _) => (format!("{} before it", found(value)), ends(&before)),
        (None, _) => (format!("no `{before}` before it"), "it to be set as a whole".to_owned()),
    };
    ModelError::new(spelt(path), found, wanted)
}

fn ends(before: &str) -> String {
    format!("a path that ends with `{before}`")
}
