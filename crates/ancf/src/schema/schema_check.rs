//! Checks data against a schema, collects all errors, and returns corrected data.
//!
//! The corrected data satisfy the schema, so that further rules can be checked on their valid part.

use std::collections::{BTreeMap, HashMap};
use std::rc::Rc;

use serde_json::Value as Json;
use toml::{Table, Value};

use super::generate::{
    allows, expected, forms, found, is_free, keys, kind, required, tag, wanted_of, without_links,
};
use super::valid_data::ValidData;
use crate::errors::{Finding, ModelError, listed, nearest, quoted};

/// Result of the check of data against a schema.
#[derive(Debug, Default)]
pub(crate) struct SchemaCheck {
    pub(crate) findings: Vec<Finding>,
    /// Paths whose values were replaced by valid values.
    replaced: Vec<String>,
    /// Corrected paths, and the paths in the file.
    misspelt: Vec<(String, String)>,
    /// Alternative forms of the schemas so far, by the address of the schema.
    forms: HashMap<*const Json, Rc<[&'static Json]>>,
    /// Tags of the forms of tables so far, by the address of the form.
    tags: HashMap<*const Json, Option<(&'static str, &'static str)>>,
}

/// Table by corrected keys, with the keys in the file.
type Entries<'a> = BTreeMap<&'a str, (&'a str, &'a Value)>;

impl SchemaCheck {
    /// Checks data against a schema; returns the findings and the corrected data.
    pub(crate) fn of(schema: &'static Json, data: Value) -> (Self, Value) {
        // Most data are valid. The check with messages takes several times as long.
        if ValidData::default().holds(schema, &data) {
            return (Self::default(), data);
        }
        Self::with_messages(schema, &data)
    }

    pub(super) fn with_messages(schema: &'static Json, data: &Value) -> (Self, Value) {
        let mut check = Self::default();
        let corrected = check.value(schema, data, "");
        (check, corrected)
    }

    /// Converts a path in the model to the path in the file. Misspelt keys differ.
    pub(crate) fn path_in_file(&self, path: &str) -> String {
        self.misspelt.iter().fold(path.to_owned(), |path, (meant, spelt)| match path.strip_prefix(&**meant) {
            Some(rest) if within(&path, meant) => format!("{spelt}{rest}"),
            _ => path,
        })
    }

    /// True if the value at this path of the file was replaced.
    pub(crate) fn has_replaced(&self, path: &str) -> bool {
        self.replaced.iter().any(|replaced| within(path, replaced))
    }

    fn forms(&mut self, schema: &'static Json) -> Rc<[&'static Json]> {
        Rc::clone(self.forms.entry(schema).or_insert_with(|| forms(schema).into()))
    }

    fn tag(&mut self, form: &'static Json) -> Option<(&'static str, &'static str)> {
        *self.tags.entry(form).or_insert_with(|| tag(form))
    }

    fn value(&mut self, schema: &'static Json, value: &Value, path: &str) -> Value {
        let forms = self.forms(schema);
        if forms.iter().any(|form| is_free(form)) {
            return value.clone();
        }
        let of = |kinds: &[&str]| {
            forms.iter().copied().filter(|form| kinds.contains(&kind(form))).collect::<Vec<_>>()
        };
        match value {
            Value::Table(table) if !of(&["object"]).is_empty() => self.table(&of(&["object"]), table, path),
            Value::Array(items) if !of(&["array"]).is_empty() => {
                self.array(array_form(&of(&["array"]), items.len()), items, path)
            }
            Value::Integer(_) | Value::Float(_) if !of(&["number", "integer"]).is_empty() => {
                self.number(of(&["number", "integer"])[0], value, path)
            }
            Value::Boolean(_) if !of(&["boolean"]).is_empty() => value.clone(),
            Value::String(text) if !of(&["string"]).is_empty() => self.text(&forms, text, path),
            _ => self.wrong_type(&forms, value, path),
        }
    }

    fn number(&mut self, form: &'static Json, value: &Value, path: &str) -> Value {
        let x = match *value {
            Value::Float(x) if kind(form) == "number" => x,
            // Integers above 2⁵³ are rounded, like numbers with a decimal point.
            Value::Integer(n) => n as f64,
            _ => return self.wrong_type(&[form], value, path),
        };
        if !x.is_finite() {
            self.report(path, value, expected(form).replacen("a number", "a finite number", 1));
        } else if !allows(form, x) {
            let too_large = kind(form) == "integer" && x > f64::from(u32::MAX);
            self.report(path, value, if too_large { "an integer < 2³²".into() } else { expected(form) });
        } else {
            return value.clone();
        }
        self.replace(form, path)
    }

    fn text(&mut self, forms: &[&'static Json], text: &str, path: &str) -> Value {
        let words = || forms.iter().filter_map(|form| form["const"].as_str());
        let free = |form: &&Json| kind(form) == "string" && form["const"].is_null();
        let value = Value::String(text.to_owned());
        match forms.iter().find(|form| free(form)) {
            _ if words().any(|word| word == text) => return value,
            Some(form) if !text.is_empty() || form["minLength"].as_u64().unwrap_or(0) == 0 => return value,
            _ => {}
        }
        let error = ModelError::new(path, found(&value), wanted_of(forms));
        self.findings.push(did_you_mean(error, nearest(text, words()).map(quoted)).into());
        self.replace(forms[0], path)
    }

    fn array(&mut self, form: &'static Json, items: &[Value], path: &str) -> Value {
        let count = |key: &str| form[key].as_u64().and_then(|count| usize::try_from(count).ok());
        let (min, max) = (count("minItems").unwrap_or(0), count("maxItems").unwrap_or(usize::MAX));
        if (min..=max).contains(&items.len()) && are_valid_numbers(&self.forms(&form["items"]), items) {
            return Value::Array(items.to_vec());
        }
        let before = self.replaced.len();
        let item = |(i, item)| self.value(&form["items"], item, &format!("{path}[{i}]"));
        let mut corrected: Vec<_> = items.iter().enumerate().map(item).collect();
        // Rules use all components of a vector, so one replaced component invalidates the vector.
        if min == max && self.replaced.len() > before {
            self.replaced.push(path.to_owned());
        }
        if !(min..=max).contains(&items.len()) {
            self.report(path, &Value::Array(items.to_vec()), expected(form));
            self.replaced.push(path.to_owned());
            corrected.resize_with(corrected.len().clamp(min, max), || placeholder(&form["items"]));
        }
        Value::Array(corrected)
    }

    fn table(&mut self, forms: &[&'static Json], table: &Table, path: &str) -> Value {
        let any_key = &forms[0]["additionalProperties"];
        if any_key.is_object() {
            let entry =
                |(key, value): (&String, _)| (key.clone(), self.value(any_key, value, &join(path, key)));
            return Value::Table(table.iter().map(entry).collect());
        }
        let mut entries: Entries = table.iter().map(|(key, value)| (&**key, (&**key, value))).collect();
        let (form, is_certain) = self.form(forms, &mut entries, path);
        if is_certain {
            self.correct_keys(form, &mut entries, path);
        }
        self.properties(form, &entries, is_certain, path)
    }

    /// Selects the form of a table by its tag, and removes the tag from the entries. The flag is true if the form is certain.
    fn form(&mut self, forms: &[&'static Json], entries: &mut Entries, path: &str) -> (&'static Json, bool) {
        let Some((key, _)) = self.tag(forms[0]) else { return (untagged_form(forms, entries), true) };
        self.correct_tag(key, forms, entries, path);
        let stated = entries.remove(key);
        let word = stated.and_then(|(_, value)| value.as_str());
        let mut is_stated = |form: &&'static Json| self.tag(form).is_some_and(|(_, own)| word == Some(own));
        if let Some(form) = forms.iter().copied().find(&mut is_stated) {
            return (form, true);
        }
        let words = || forms.iter().filter_map(|form| Some(tag(form)?.1));
        let named = |word| forms.iter().copied().find(|form| tag(form).is_some_and(|(_, own)| own == word));
        let near = word.and_then(|word| nearest(word, words()));
        let expected = listed(words().map(quoted), "or");
        match stated {
            Some((spelt, value)) => {
                let error = ModelError::new(join(path, spelt), found(value), expected);
                self.findings.push(did_you_mean(error, near.map(quoted)).into());
            }
            None => self.missing(key, expected, &Json::Null, path),
        }
        self.replaced.push(join(path, key));
        near.and_then(named)
            .map_or_else(|| (form_by_keys(forms, entries), forms.len() == 1), |form| (form, true))
    }

    /// Corrects a misspelt tag.
    fn correct_tag<'a>(
        &mut self,
        tag: &'a str,
        forms: &[&'static Json],
        entries: &mut Entries<'a>,
        path: &str,
    ) {
        if entries.contains_key(tag) {
            return;
        }
        let known = |key: &str| forms.iter().any(|form| !form["properties"][key].is_null());
        let spelt = entries.keys().copied().find(|key| !known(key) && nearest(key, [tag]).is_some());
        if let Some(spelt) = spelt {
            self.unknown(spelt, Some(tag), format!("`{tag}`"), path);
            self.rename(spelt, tag, entries, path);
        }
    }

    /// Reports unknown keys, and corrects misspelt keys.
    fn correct_keys(&mut self, form: &'static Json, entries: &mut Entries, path: &str) {
        let keys = keys(form);
        let unknown: Vec<_> = entries.keys().copied().filter(|key| !keys.contains(key)).collect();
        for spelt in unknown {
            let near = nearest(spelt, keys.iter().copied());
            self.unknown(spelt, near, listed(keys.iter().map(|key| format!("`{key}`")), "or"), path);
            match near.filter(|meant| {
                !entries.contains_key(meant) && tag(form).is_none_or(|(tag, _)| tag != *meant)
            }) {
                Some(meant) => self.rename(spelt, meant, entries, path),
                None => _ = entries.remove(spelt),
            }
        }
    }

    fn rename<'a>(&mut self, spelt: &'a str, meant: &'a str, entries: &mut Entries<'a>, path: &str) {
        self.misspelt.push((join(path, meant), join(path, spelt)));
        if let Some(entry) = entries.remove(spelt) {
            entries.insert(meant, entry);
        }
    }

    /// Returns the corrected properties of a table. Missing keys are reported if the form is certain.
    fn properties(&mut self, form: &'static Json, entries: &Entries, is_certain: bool, path: &str) -> Value {
        let (mut corrected, tag) = (Table::new(), self.tag(form));
        for key in keys(form) {
            let schema = &form["properties"][key];
            if let Some((_, word)) = tag.filter(|(tag, _)| *tag == key) {
                corrected.insert(key.into(), word.into());
            } else if let Some((spelt, value)) = entries.get(key) {
                corrected.insert(key.into(), self.value(schema, value, &join(path, spelt)));
            } else if required(form).any(|required| required == key) {
                if is_certain {
                    self.missing(key, wanted_of(&forms(schema)), &schema["description"], path);
                }
                corrected.insert(key.into(), self.replace(schema, &join(path, key)));
            }
        }
        Value::Table(corrected)
    }

    fn replace(&mut self, schema: &'static Json, path: &str) -> Value {
        self.replaced.push(path.to_owned());
        placeholder(schema)
    }

    fn wrong_type(&mut self, forms: &[&'static Json], value: &Value, path: &str) -> Value {
        let mut error = ModelError::new(path, found(value), wanted_of(forms));
        let is_list = |form: &&&Json| kind(form) == "array" && kind(&form["items"]) != "number";
        let is_number = |form: &&'static Json| ["number", "integer"].contains(&kind(form));
        let number_hint = value.as_str().filter(|_| forms.iter().any(is_number)).and_then(number_hint);
        if number_hint.is_some() {
            error.hint = number_hint.map(Into::into);
        } else if forms.iter().any(|form| is_list(&form)) && value.is_table() {
            error.hint = Some(format!("write `[[{path}]]`"));
        }
        self.findings.push(error.into());
        self.replace(forms[0], path)
    }

    fn report(&mut self, path: &str, value: &Value, expected: String) {
        self.findings.push(ModelError::new(path, found(value), expected).into());
    }

    fn unknown(&mut self, key: &str, near: Option<&str>, expected: String, path: &str) {
        let error = ModelError::new(join(path, key), format!("unknown key `{key}`"), expected);
        let error = did_you_mean(error, near.map(|near| format!("`{near}`")));
        self.findings.push(Finding { at_key: true, ..error.into() });
    }

    fn missing(&mut self, key: &str, expected: String, description: &Json, path: &str) {
        let mut error = ModelError::new(join(path, key), format!("no key `{key}`"), expected);
        let description = without_links(description.as_str().unwrap_or_default()).replace('\n', " ");
        error.hint = description.split(". ").next().map(|text| text.trim_end_matches('.').to_owned());
        error.hint = error.hint.filter(|hint| !hint.is_empty());
        self.findings.push(Finding { absence: true, ..error.into() });
    }
}

/// Hint for a number in a text, such as `1` or `1 s`.
fn number_hint(text: &str) -> Option<&'static str> {
    if text.trim().parse::<f64>().is_ok() {
        return Some("write the number without quotes");
    }
    let digits = text.trim_start_matches(['+', '-', ' ']);
    let is_quantity = digits.starts_with(|c: char| c.is_ascii_digit());
    is_quantity.then_some("write the number alone; the key `units` of the model names the units")
}

/// First of the arrays that can have a number of items, else the first one.
fn array_form(forms: &[&'static Json], items: usize) -> &'static Json {
    let limit = |form: &Json, key: &str| form[key].as_u64().and_then(|count| usize::try_from(count).ok());
    let fits = |form: &&&'static Json| {
        (limit(form, "minItems").unwrap_or(0)..=limit(form, "maxItems").unwrap_or(usize::MAX))
            .contains(&items)
    };
    forms.iter().find(fits).copied().unwrap_or(forms[0])
}

/// True if all items are valid numbers. Long arrays are checked without a path for each item.
fn are_valid_numbers(forms: &[&'static Json], items: &[Value]) -> bool {
    let [form] = *forms else { return false };
    let is_valid = |item: &Value| match *item {
        Value::Float(x) => x.is_finite() && allows(form, x),
        Value::Integer(n) => allows(form, n as f64),
        _ => false,
    };
    kind(form) == "number" && !is_free(form) && items.iter().all(is_valid)
}

/// Form with the largest number of keys of a table; the first of equals.
fn form_by_keys(forms: &[&'static Json], entries: &Entries) -> &'static Json {
    let common = |form: &&Json| entries.keys().filter(|key| !form["properties"][**key].is_null()).count();
    forms.iter().copied().rev().max_by_key(common).unwrap_or(forms[0])
}

/// Adds a suggestion to an error, if there is one.
pub(crate) fn did_you_mean(error: ModelError, meant: Option<String>) -> ModelError {
    match meant {
        Some(meant) => error.hint(format!("did you mean {meant}?")),
        None => error,
    }
}

/// Form without a tag that has the largest number of keys, also of misspelt keys; the first of equals.
fn untagged_form(forms: &[&'static Json], entries: &Entries) -> &'static Json {
    let known = |form: &Json, key: &str| !form["properties"][key].is_null();
    let meant = |form: &'static Json, key: &str| known(form, key) || nearest(key, keys(form)).is_some();
    let fit = |form: &'static Json| {
        let count = |test: &dyn Fn(&str) -> bool| entries.keys().filter(|key| test(key)).count();
        (count(&|key| known(form, key)), count(&|key| meant(form, key)))
    };
    forms.iter().copied().rev().max_by_key(|form| fit(form)).unwrap_or(forms[0])
}

/// Path of a key in a table, in the syntax of TOML.
///
/// A key with other characters than letters, digits, `_` and `-` is in quotes, with escape sequences for quotes, backslashes
/// and control characters.
pub fn join(path: &str, key: &str) -> String {
    let bare = !key.is_empty() && key.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-');
    let key = if bare { key.to_owned() } else { format!("\"{}\"", escaped(key)) };
    if path.is_empty() { key } else { format!("{path}.{key}") }
}

fn escaped(key: &str) -> String {
    key.chars().fold(String::new(), |text, c| match c {
        '"' | '\\' => format!("{text}\\{c}"),
        _ if c.is_control() => format!("{text}\\u{:04X}", u32::from(c)),
        _ => format!("{text}{c}"),
    })
}

/// True if a path equals another path or is below it.
fn within(path: &str, above: &str) -> bool {
    path.strip_prefix(above).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
}

/// Valid value for a schema: its default, or a value of the required type.
fn placeholder(schema: &'static Json) -> Value {
    if let Some(default) = schema.get("default").and_then(|default| Value::try_from(default).ok()) {
        return default;
    }
    let form = forms(schema)[0];
    match kind(form) {
        "number" => Value::Float(1.0),
        "integer" => Value::Integer(1),
        "boolean" => Value::Boolean(false),
        "array" => {
            let count = form["minItems"].as_u64().unwrap_or(0);
            Value::Array((0..count).map(|_| placeholder(&form["items"])).collect())
        }
        "object" => Value::Table(
            required(form).map(|key| (key.to_owned(), placeholder(&form["properties"][key]))).collect(),
        ),
        _ => form["const"].as_str().unwrap_or_default().into(),
    }
}
