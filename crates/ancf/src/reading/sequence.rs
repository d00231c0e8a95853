//! Model files with several analyses, each of which starts in the last state before it.

use std::collections::BTreeMap;

use toml::{Table, Value};

use super::check::check_data;
use super::read::{located, with_places};
use super::substitute::substitute;
use super::valid_model::ValidModel;
use crate::errors::{Finding, ModelError, ModelErrors, finding, listed, nearest, quoted};
use crate::schema::{Document, did_you_mean, found, join};

/// Sequence of analyses of a model file.
#[derive(Clone, Debug)]
pub struct AnalysisSequence {
    /// Analyses in their order, at least one.
    pub stages: Vec<SequenceStage>,
}

/// Analysis of a sequence, with a model of its own.
#[derive(Clone, Debug)]
pub struct SequenceStage {
    /// Name, unique in the sequence.
    pub name: String,
    /// Name of the results folder within that of the sequence, such as `2-release`.
    pub folder: String,
    /// Model of this analysis, with the parts that exist in it. Its start time is that of motions of full duration.
    pub model: ValidModel,
    number: usize,
    data: Table,
    places: Places,
}

/// Paths in the data of a stage of parts that have another path in the file.
type Places = BTreeMap<String, String>;

/// Lists of the model whose items may exist in some analyses only.
const LISTS: [&str; 6] = ["joints", "couplings", "loads", "inputs", "contacts", "probes"];
/// Keys of an item of these lists.
const PRESENCE: [&str; 2] = ["only_in", "not_in"];

impl AnalysisSequence {
    /// Reads the text of a model file with a list of analyses; `None` if it states a single one.
    ///
    /// Keys of an analysis of a list, in addition to those of its kind:
    ///
    /// | key | meaning |
    /// |---|---|
    /// | `name` | name, by which results folders and other keys refer to it; its kind by default |
    /// | `set` | values of other keys of the model in this analysis, by path ([`substitute`]) |
    ///
    /// The keys `only_in` and `not_in` of joints, couplings, loads, inputs, contacts and probes are lists of names of analyses.
    ///
    /// # Errors
    /// All errors of the models of all analyses, in the order of the text.
    ///
    /// ```
    /// let text = r#"
    ///     gravity = [0, 0, -9.81]
    ///     materials.steel = { density = 7850, young = 2.1e11 }
    ///     sections.wire = { kind = "circle", diameter = 0.005 }
    ///     bodies = [
    ///         { kind = "cable", name = "rope", from = [0, 0, 0], to = [1, 0, 0], elements = 8, section = "wire", material = "steel" },
    ///     ]
    ///     [[joints]]
    ///     kind = "spherical"
    ///     name = "left"
    ///     a = { body = "rope", at = "start" }
    ///     [[joints]]
    ///     kind = "spherical"
    ///     name = "right"
    ///     a = { body = "rope", at = "end" }
    ///     not_in = ["release"]
    ///     [[analysis]]
    ///     kind = "statics"
    ///     name = "hang"
    ///     [[analysis]]
    ///     kind = "dynamics"
    ///     name = "release"
    ///     duration = 1
    ///     step = 1e-3
    /// "#;
    /// let sequence = ancf::reading::AnalysisSequence::parse(text)?.expect("several analyses");
    /// assert_eq!(sequence.stages[1].folder, "2-release");
    /// assert_eq!(sequence.stages[1].model.joints.len(), 1);
    /// # Ok::<(), ancf::ModelErrors>(())
    /// ```
    pub fn parse(text: &str) -> Result<Option<Self>, ModelErrors> {
        Self::of_document(&mut Document::parse(text), text)
    }

    /// Reads a parsed text; `None`, and the document unchanged, if it states a single analysis.
    pub(super) fn of_document(document: &mut Document, text: &str) -> Result<Option<Self>, ModelErrors> {
        if !document.data.get("analysis").is_some_and(Value::is_array) {
            return Ok(None);
        }
        if !document.errors.is_empty() {
            return Err(ModelErrors(std::mem::take(&mut document.errors)));
        }
        let (stages, findings) = Source::new(std::mem::take(&mut document.data)).stages();
        let mut errors: Vec<ModelError> = Vec::new();
        for error in findings.into_iter().map(|finding| located(finding, document, text)) {
            // Errors of parts of several analyses.
            if !errors.contains(&error) {
                errors.push(error);
            }
        }
        errors.sort_by_key(|error| error.at.as_ref().map(|at| at.bytes.start));
        if errors.is_empty() { Ok(Some(Self { stages })) } else { Err(ModelErrors(errors)) }
    }
}

impl SequenceStage {
    /// Data of the model of this analysis. `start_time` is the time at which its motion starts. `initial.from` is the folder
    /// of the analysis before it, relative to its own.
    pub fn data(&self, start_time: f64) -> Table {
        let mut data = self.data.clone();
        if let Some(Value::Table(initial)) = data.get_mut("initial")
            && self.model.analysis.dynamics().is_some()
        {
            initial.insert("start_time".into(), start_time.into());
        }
        data
    }

    /// Text of the model file of this analysis in its results folder, with [`data`](Self::data).
    pub fn text(&self, start_time: f64) -> String {
        let data = self.data(start_time);
        let text = toml::to_string(&data).expect("data of a model file are a TOML table");
        format!("# Analysis `{}` of a sequence.\n{text}", self.name)
    }

    /// Errors of the model of this analysis, with their places in the text of the file.
    #[must_use]
    pub fn with_places(&self, errors: ModelErrors, text: &str) -> ModelErrors {
        let place = |error: ModelError| {
            let path = in_file(&error.path, &self.places, self.number);
            ModelError { path, ..error }
        };
        with_places(ModelErrors(errors.0.into_iter().map(place).collect()), text)
    }
}

/// Data of a model file with several analyses.
struct Source {
    /// Data without the analyses.
    base: Table,
    analyses: Vec<Value>,
    names: Vec<String>,
}

impl Source {
    fn new(mut base: Table) -> Self {
        let analyses = match base.remove("analysis") {
            Some(Value::Array(analyses)) => analyses,
            _ => Vec::new(),
        };
        let name = |analysis: &Value| {
            let text = |key: &str| analysis.get(key).and_then(Value::as_str);
            text("name").or_else(|| text("kind")).unwrap_or_default().to_owned()
        };
        let names = analyses.iter().map(name).collect();
        Self { base, analyses, names }
    }

    /// Stages with their models, and all errors.
    fn stages(&self) -> (Vec<SequenceStage>, Vec<Finding>) {
        let mut findings = self.wrong_names();
        findings.extend(self.wrong_presence());
        let (mut stages, mut time) = (Vec::new(), 0.0);
        for number in 0..self.analyses.len() {
            let (data, places, wrong) = self.data_of(number, time);
            findings.extend(wrong);
            let (model, found) = check_data(Value::Table(data.clone()));
            findings.extend(found.into_iter().map(|mut finding| {
                finding.error.path = in_file(&finding.error.path, &places, number);
                finding
            }));
            // Used only if there are no findings.
            let Some(model) = model.map(ValidModel) else { continue };
            time += model.analysis.dynamics().map_or(0.0, |own| own.duration);
            let (name, folder) = (self.names[number].clone(), self.folder(number));
            stages.push(SequenceStage { name, folder, model, number, data, places });
        }
        if self.analyses.is_empty() {
            findings.push(finding("analysis".into(), "an empty array", "at least one analysis"));
        }
        (stages, findings)
    }

    fn folder(&self, number: usize) -> String {
        format!("{}-{}", number + 1, self.names[number])
    }

    /// Names that are not unique, or not names of a folder.
    fn wrong_names(&self) -> Vec<Finding> {
        let is_plain = |c: char| c.is_alphanumeric() || c == '_' || c == '-';
        let rule = |(i, name): (usize, &String)| {
            let own = self.analyses[i].get("name");
            let path = format!("analysis[{i}].name");
            if let Some(value) = own.filter(|value| !value.is_str()) {
                return Some(finding(path, found(value), "a text"));
            }
            if own.is_some() && (name.is_empty() || !name.chars().all(is_plain)) {
                return Some(finding(path, quoted(name), "letters, digits, `_` and `-`"));
            }
            let is_repeated = !name.is_empty() && self.names[..i].contains(name);
            let what = if own.is_some() { "a second" } else { "no name, and a second" };
            is_repeated.then(|| finding(path, format!("{what} {}", quoted(name)), "a unique name"))
        };
        self.names.iter().enumerate().filter_map(rule).collect()
    }

    /// Lists of analyses that are not lists of their names.
    fn wrong_presence(&self) -> Vec<Finding> {
        let known = || self.names.iter().map(String::as_str);
        let mut findings = Vec::new();
        for (path, item) in self.items() {
            for key in PRESENCE {
                let Some(value) = item.get(key) else { continue };
                let path = format!("{path}.{key}");
                let Some(names) = value.as_array() else {
                    findings.push(finding(path, found(value), "an array of names of analyses"));
                    continue;
                };
                for (i, name) in names.iter().enumerate() {
                    let text = name.as_str().unwrap_or_default();
                    if !self.names.iter().any(|own| own == text) {
                        let expected = format!("an analysis: {}", listed(known().map(quoted), "or"));
                        let error = ModelError::new(format!("{path}[{i}]"), found(name), expected);
                        findings.push(did_you_mean(error, nearest(text, known()).map(quoted)).into());
                    }
                }
            }
            if PRESENCE.iter().all(|key| item.contains_key(*key)) {
                let expected = "`only_in` or `not_in`";
                findings.push(finding(format!("{path}.not_in"), "`not_in` beside `only_in`", expected));
            }
        }
        findings
    }

    /// Items of the lists, with their paths.
    fn items(&self) -> impl Iterator<Item = (String, &Table)> {
        LISTS.into_iter().flat_map(|list| {
            let items = self.base.get(list).and_then(Value::as_array).into_iter().flatten().enumerate();
            items.filter_map(move |(i, item)| Some((format!("{list}[{i}]"), item.as_table()?)))
        })
    }

    /// Data of the model of an analysis that starts at a time, their places in the file, and errors of the own keys of the analysis.
    fn data_of(&self, number: usize, time: f64) -> (Table, Places, Vec<Finding>) {
        let mut data = Value::Table(self.base.clone());
        let (mut analysis, mut places) = (self.analyses[number].clone(), Places::new());
        let (set, mut findings) = take_set(&mut analysis, number);
        for (path, value) in set {
            let place = join(&format!("analysis[{number}].set"), &path);
            if path.starts_with("analysis") || path.starts_with("initial") {
                findings.push(finding(
                    place,
                    quoted(&path),
                    "a key of the model outside `analysis` and `initial`",
                ));
                continue;
            }
            match substitute(&mut data, &path, value) {
                Ok(set) if self.has_moved(number) && set.iter().any(|path| is_initial_motion(path)) => {
                    let expected = "a key other than `motion`: the motion of an analysis before continues";
                    findings.push(finding(place, quoted(&path), expected));
                }
                Ok(set) => places.extend(set.into_iter().map(|path| (path, place.clone()))),
                Err(error) => findings.push(ModelError { path: place, ..error }.into()),
            }
        }
        let Value::Table(mut data) = data else { unreachable!("a table was not replaced") };
        self.leave_out(&mut data, &mut places, &self.names[number]);
        data.insert("analysis".into(), analysis);
        self.start_from_last(&mut data, number, time);
        if number + 1 < self.analyses.len() {
            store_last_state(&mut data);
        }
        (data, places, findings)
    }

    /// Removes the items that do not exist in an analysis.
    fn leave_out(&self, data: &mut Table, places: &mut Places, name: &str) {
        for list in LISTS {
            let Some(items) = data.get_mut(list).and_then(Value::as_array_mut) else { continue };
            let (mut kept, mut moved) = (Vec::new(), Places::new());
            for (i, mut item) in std::mem::take(items).into_iter().enumerate() {
                let has = |item: &Value, key: &str| {
                    let names = item.get(key).and_then(Value::as_array)?;
                    Some(names.iter().any(|own| own.as_str() == Some(name)))
                };
                let [only, not] = PRESENCE.map(|key| has(&item, key));
                if let Some(item) = item.as_table_mut() {
                    PRESENCE.iter().for_each(|key| _ = item.remove(*key));
                }
                if only.unwrap_or(true) && !not.unwrap_or(false) {
                    let (own, file) = (format!("{list}[{}]", kept.len()), format!("{list}[{i}]"));
                    moved.extend(places.iter().filter_map(|(path, place)| {
                        Some((own.clone() + path.strip_prefix(&file)?, place.clone()))
                    }));
                    moved.insert(own, file);
                    kept.push(item);
                }
            }
            places.retain(|path, _| !path.starts_with(&format!("{list}[")));
            places.extend(moved);
            if kept.is_empty() {
                data.remove(list);
            } else {
                data.insert(list.into(), Value::Array(kept));
            }
        }
    }

    /// True if an analysis is of one of some kinds.
    fn is_of(&self, number: usize, kinds: &[&str]) -> bool {
        let kind = self.analyses[number].get("kind").and_then(Value::as_str);
        kind.is_some_and(|kind| kinds.contains(&kind))
    }

    /// True if an analysis before is a motion.
    fn has_moved(&self, number: usize) -> bool {
        (0..number).any(|i| self.is_of(i, &["dynamics"]))
    }

    /// Starts in the last state of the last analysis before that has states; modes and critical loads have shapes.
    fn start_from_last(&self, data: &mut Table, number: usize, time: f64) {
        let about = self.analyses[number].get("about").and_then(Value::as_str);
        if self.is_of(number, &["modes"]) && about != Some("equilibrium") {
            // About the undeformed state: `initial` is that of the first analysis.
            if number > 0 {
                data.remove("initial");
            }
            return;
        }
        let Some(last) = (0..number).rev().find(|i| !self.is_of(*i, &["modes", "buckling"])) else { return };
        data.remove("assemble");
        let mut initial = Table::new();
        initial.insert("from".into(), format!("../{}", self.folder(last)).into());
        if self.is_of(number, &["dynamics"]) {
            initial.insert("start_time".into(), time.into());
        }
        data.insert("initial".into(), Value::Table(initial));
        // The first motion starts with the initial motions of the bodies.
        if self.has_moved(number) {
            let bodies = data.get_mut("bodies").and_then(Value::as_array_mut).into_iter().flatten();
            bodies.filter_map(Value::as_table_mut).for_each(|body| _ = body.remove("motion"));
        }
    }
}

/// Stores the first and the last state of an analysis whose file requests none: the next analysis may start there.
fn store_last_state(data: &mut Table) {
    if let Some(Value::Table(output)) = data.get_mut("output")
        && output.get("states").and_then(Value::as_integer) == Some(0)
    {
        output.insert("states".into(), 2.into());
    }
}

/// Removes the keys of an analysis of a sequence, and returns its changes of other keys.
fn take_set(analysis: &mut Value, number: usize) -> (Table, Vec<Finding>) {
    let Some(analysis) = analysis.as_table_mut() else { return Default::default() };
    analysis.remove("name");
    match analysis.remove("set") {
        None => Default::default(),
        Some(Value::Table(set)) => (set, Vec::new()),
        Some(other) => {
            let expected = "a table of values by path, such as { \"loads[0].force\" = [0, 0, 1] }";
            (Table::new(), vec![finding(format!("analysis[{number}].set"), found(&other), expected)])
        }
    }
}

/// True for the path of the initial motion of a body, or of a key inside.
fn is_initial_motion(path: &str) -> bool {
    let key = path.strip_prefix("bodies[").and_then(|rest| rest.split_once("].")).map(|(_, key)| key);
    key.is_some_and(|key| key.split('.').next() == Some("motion"))
}

/// Path in the file of a path in the data of a stage.
fn in_file(path: &str, places: &Places, number: usize) -> String {
    let is_in = |own: &str| {
        path.strip_prefix(own).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
    };
    if is_in("analysis") {
        return format!("analysis[{number}]{}", &path["analysis".len()..]);
    }
    if number > 0 && is_in("initial") {
        return format!("analysis[{number}]"); // It starts in the state before.
    }
    // The longest path is that of a changed key.
    let known = places.iter().filter(|(own, _)| is_in(own)).max_by_key(|(own, _)| own.len());
    known.map_or_else(|| path.to_owned(), |(own, place)| format!("{place}{}", &path[own.len()..]))
}
