//! Estimate of the memory of a model, compared with the available memory before anything large is allocated.

use std::fs;
use std::path::Path;

use ancf_solver::eigen::modes_memory;
use ancf_solver::factor::Factor;
use ancf_solver::sparse::{FactorStorage, Pattern};

use crate::errors::{Finding, ModelErrors, finding, number};
use crate::model::{Analysis, Body, IndexedModel};

/// Upper limit on the number of elements. Larger values are assumed to be typing errors.
pub(super) const MAX_ELEMENTS: u64 = 10_000_000;
/// Memory of a run in bytes, measured: per element, rigid body, joint, probe and contact point. That of elements has two parts:
/// without matrices, and the least memory of matrices and factors.
const PER_ELEMENT: [f64; 2] = [5e3, 4e3];
const PER_SHELL_ELEMENT: [f64; 2] = [35e3, 45e3];
const PER_RIGID_BODY: f64 = 6e3;
const PER_JOINT: f64 = 10e3;
const PER_PROBE: f64 = 110e3;
const PER_CONTACT_POINT: f64 = 0.9e3;
/// Least number of coordinates of an element, without those of its first node.
const LEAST_COORDINATES: f64 = 6.0;
/// Required memory below which the available memory is not read.
const SMALL: f64 = 0.2e9;

/// Part of the available memory above which factors of subtrees are not stored.
const SCARCE: f64 = 0.5;

/// Memory of a part of the model.
struct Part {
    path: &'static str,
    what: String,
    bytes: f64,
}

/// Chooses the stored part of the factors of tangents by the available memory.
pub(crate) fn factor_storage(model: &IndexedModel<'_>, pattern: &Pattern) -> FactorStorage {
    let all = total(&parts(model, Matrices::of(pattern, FactorStorage::All)));
    let is_scarce = all > SMALL && available().is_some_and(|available| all > SCARCE * available);
    if is_scarce { FactorStorage::Trunk } else { FactorStorage::All }
}

/// Checks that the matrices and factors of a pattern fit into the available memory.
pub(crate) fn memory_of_equations(
    model: &IndexedModel<'_>,
    pattern: &Pattern,
    available: impl FnOnce() -> Option<f64>,
) -> Result<(), ModelErrors> {
    let parts = parts(model, Matrices::of(pattern, pattern.factor_storage()));
    not_fitting(&parts, available).map_or(Ok(()), |found| Err(ModelErrors(vec![found.error])))
}

/// Checks that the model fits into the available memory.
pub(super) fn memory(model: &IndexedModel<'_>, available: impl FnOnce() -> Option<f64>) -> Option<Finding> {
    not_fitting(&parts(model, Matrices::Least), available)
}

fn total(parts: &[Part]) -> f64 {
    parts.iter().map(|part| part.bytes).sum()
}

/// Finding about parts that do not fit into the available memory.
fn not_fitting(parts: &[Part], available: impl FnOnce() -> Option<f64>) -> Option<Finding> {
    let total = total(parts);
    if total <= SMALL {
        return None;
    }
    let available = available().filter(|&available| total > available)?;
    let largest = parts.iter().max_by(|a, b| a.bytes.total_cmp(&b.bytes))?;
    let found = format!("{}, in all about {} of memory", largest.what, size(total));
    let expected = format!("at most {}, the available memory of this machine", size(available));
    let rests_on = ["bodies", "contacts", "probes", "joints", "analysis"].map(str::to_owned);
    Some(finding(largest.path.to_owned(), found, expected).rests_on(rests_on))
}

/// Memory of matrices and vectors in an estimate.
#[derive(Clone, Copy)]
enum Matrices {
    /// Least memory by the number of elements.
    Least,
    /// Memory in bytes of the matrix of the equations and its factors, with the number of unknowns.
    Of { unknowns: f64, bytes: f64 },
}

impl Matrices {
    fn of(pattern: &Pattern, storage: FactorStorage) -> Self {
        Self::Of { unknowns: pattern.size() as f64, bytes: Factor::memory(pattern, storage) }
    }
}

/// Memory of the parts of a model.
fn parts(model: &IndexedModel<'_>, matrices: Matrices) -> Vec<Part> {
    let flexible = model.bodies.iter().filter(|body| body.is_flexible());
    let elements: f64 = flexible.map(|body| f64::from(body.elements())).sum();
    let rigid =
        model.bodies.iter().filter(|body| matches!(body, Body::Rigid(_) | Body::Mass(_))).count() as f64;
    let shells: f64 =
        model.bodies.iter().filter(|body| body.is_shell()).map(|body| f64::from(body.elements())).sum();
    let points: f64 = (0..model.contacts.len()).map(|i| contact_points(model, i)).sum();
    let modes = match &model.analysis {
        Analysis::Modes(modes) => modes.count,
        Analysis::Buckling(buckling) => buckling.count,
        _ => 0,
    };
    let (unknowns, of_matrix) = match matrices {
        Matrices::Least => (LEAST_COORDINATES * elements, 0.0),
        Matrices::Of { unknowns, bytes } => (unknowns, bytes),
    };
    let per_element = |[rest, least]: [f64; 2]| match matrices {
        Matrices::Least => rest + least,
        Matrices::Of { .. } => rest,
    };
    let vectors = if modes > 0 {
        modes_memory((modes as usize).min(unknowns as usize), unknowns as usize)
    } else {
        0.0
    };
    let count = |n: f64, what: &str| format!("{} {what}", number(n));
    let (joints, probes) = (model.joints.len() as f64, model.probes.len() as f64);
    vec![
        Part {
            path: "bodies",
            what: count(elements, "elements"),
            bytes: elements * per_element(PER_ELEMENT),
        },
        Part {
            path: "bodies",
            what: count(shells, "shell elements"),
            bytes: shells * per_element(PER_SHELL_ELEMENT),
        },
        Part { path: "bodies", what: count(rigid, "rigid bodies"), bytes: rigid * PER_RIGID_BODY },
        Part { path: "joints", what: count(joints, "joints"), bytes: joints * PER_JOINT },
        Part { path: "probes", what: count(probes, "probes"), bytes: probes * PER_PROBE },
        Part { path: "contacts", what: count(points, "contact points"), bytes: points * PER_CONTACT_POINT },
        Part { path: "analysis.count", what: count(f64::from(modes), "shapes"), bytes: vectors },
        Part {
            path: "bodies",
            what: format!("{} of the matrix of the equations and its factors", size(of_matrix)),
            bytes: of_matrix,
        },
    ]
}

/// Number of contact points of a contact.
fn contact_points(model: &IndexedModel<'_>, number: usize) -> f64 {
    let contact = &model.contacts[number];
    let points = |body: &Body| {
        let elements = f64::from(body.elements());
        if let Some(layup) = body.layup() {
            let points =
                contact.points((body.area() / elements).sqrt(), 0.5 * layup.thickness, true) as f64 + 1.0;
            return Some(elements * points * points);
        }
        let radius = contact.radius(model, body)?;
        Some(elements * contact.points(body.length() / elements, radius, false) as f64)
    };
    contact.bodies(model).into_iter().filter_map(|i| points(&model.bodies[i])).sum()
}

/// Memory in words.
fn size(bytes: f64) -> String {
    format!("{} GB", number((bytes / 1e8).round() / 10.0))
}

/// Hint with the memory of a number of elements.
pub(super) fn memory_of(elements: f64) -> String {
    format!(
        "they would need about {} GB of memory",
        number((elements * PER_ELEMENT.iter().sum::<f64>() / 1e9).round())
    )
}

/// Adds a hint on memory to a finding about a number of elements that the schema rejects.
pub(crate) fn with_memory(finding: Finding) -> Finding {
    let elements = finding.error.path.ends_with(".elements").then(|| finding.error.found.parse::<f64>());
    match elements {
        Some(Ok(elements)) if elements > MAX_ELEMENTS as f64 && finding.error.hint.is_none() => {
            finding.hint(memory_of(elements))
        }
        _ => finding,
    }
}

/// Available memory in bytes: of the machine, or of the control group of the process. `None` if the system does not state it.
pub(crate) fn available() -> Option<f64> {
    let text = fs::read_to_string("/proc/meminfo").ok()?;
    let machine = from_meminfo(&text)?;
    let group = Path::new("/sys/fs/cgroup");
    let read = |name: &str| fs::read_to_string(group.join(name)).ok()?.trim().parse::<f64>().ok();
    let left = read("memory.max").zip(read("memory.current")).map(|(most, used)| most - used);
    Some(left.map_or(machine, |left| machine.min(left)))
}

/// Available memory and free swap space in the text of `/proc/meminfo`, whose unit is 1024 bytes.
fn from_meminfo(text: &str) -> Option<f64> {
    let value = |key: &str| {
        let line = text.lines().find_map(|line| line.strip_prefix(key)?.strip_prefix(':'))?;
        line.split_whitespace().next()?.parse::<f64>().ok()
    };
    Some(1024.0 * (value("MemAvailable")? + value("SwapFree").unwrap_or(0.0)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Model;

    #[test]
    fn available_memory_is_that_of_the_system() {
        let text = "MemTotal:       24683428 kB\nMemAvailable:   2000 kB\nSwapFree: 500 kB\n";
        assert_eq!(from_meminfo(text), Some(2_560_000.0));
        assert_eq!(from_meminfo("MemTotal: 5 kB\n"), None);
    }

    /// Parts that do not fit are named, with their memory.
    #[test]
    fn models_that_do_not_fit_are_rejected() {
        let text = |elements: u32, points: u32, count: u32| {
            format!(
                "materials.m = {{ density = 1000, young = 1e7 }}
                sections.s = {{ kind = \"circle\", diameter = 0.02 }}
                bodies = [{{ kind = \"cable\", name = \"rope\", from = [0, 0, 0], to = [1, 0, 0],
                    elements = {elements}, section = \"s\", material = \"m\" }}]
                contacts = [{{ with = {{ kind = \"plane\", point = [0, 0, -1], normal = [0, 0, 1] }},
                    stiffness = 1e6, points = {points} }}]
                analysis = {{ kind = \"modes\", count = {count} }}"
            )
        };
        for (elements, points, count, path, what) in [
            (50_000, 1, 1, "bodies", "50000 elements"),
            (1000, 5000, 1, "contacts", "5000000 contact points"),
            (2000, 1, 2000, "analysis.count", "2000 shapes"),
        ] {
            let data: toml::Value = toml::Value::Table(text(elements, points, count).parse().unwrap());
            let model: Model = data.try_into().unwrap();
            let model = IndexedModel::new(&model);
            let found = memory(&model, || Some(0.3e9)).expect("the model does not fit");
            assert_eq!(found.error.path, path);
            assert!(found.error.found.starts_with(what), "{}", found.error.found);
            assert!(found.error.expected.contains("0.3 GB"), "{}", found.error.expected);
            assert!(memory(&model, || Some(20e9)).is_none() && memory(&model, || None).is_none());
        }
        let data: toml::Value = toml::Value::Table(text(100, 5, 3).parse().unwrap());
        let small: Model = data.try_into().unwrap();
        assert!(memory(&IndexedModel::new(&small), || Some(1e6)).is_none());
    }
}
