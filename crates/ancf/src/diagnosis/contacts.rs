//! Overlaps of bodies that should touch each other or obstacles, and thicknesses that their elements do not resolve.

use std::collections::BTreeSet;

use super::connections::Connections;
use crate::assembly::MutualGeometry;
use crate::errors::percentage;
use crate::model::{IndexedModel, Model};

/// Largest number of pairs in a warning.
const PAIRS: usize = 3;

/// Depth in an obstacle, relative to the radius or half thickness of the body, above which a warning is given.
const DEPTH: f64 = 0.1;
/// Relative deviation of a surface from half the thickness above which a warning is given.
const DEVIATION: f64 = 0.05;

/// Warnings of bodies in contact with each other.
pub(super) fn contact_warnings(model: &Model) -> Vec<String> {
    let MutualGeometry { overlapping, deviations } = IndexedModel::new(model).mutual_geometry();
    let coarse = deviations.iter().filter(|(_, deviation)| **deviation > DEVIATION).map(|(body, deviation)| {
        format!(
            "shell `{}`: in contact with other bodies its surface deviates by up to {} of half the thickness, which varies fast; use \
             smaller elements, or a thickness with smaller slopes",
            model.bodies[*body].name(),
            if *deviation > 1.0 { "more than 100 %".to_owned() } else { percentage(*deviation) }
        )
    });
    coarse.chain(overlap_warning(model, overlapping)).chain(depth_warnings(model)).collect()
}

/// Warnings of bodies that begin deep in an obstacle, whose contact throws them out.
fn depth_warnings(model: &Model) -> Vec<String> {
    if model.starts_from().is_some() {
        return Vec::new();
    }
    let deep = IndexedModel::new(model).obstacle_depths().into_iter().filter(|(.., depth)| *depth > DEPTH);
    let warning = |(contact, body, depth): (usize, usize, f64)| {
        format!(
            "body `{}` begins in the obstacle of `contacts[{contact}]`, at a depth of {} of its radius or half thickness: the contact \
             throws it out; move the body or the obstacle, turn `normal`, or omit the body in `bodies`",
            model.bodies[body].name(),
            percentage(depth)
        )
    };
    deep.map(warning).collect()
}

/// Warning of bodies in contact that overlap in the undeformed state, so that parts of them do not touch.
///
/// Bodies with a joint between them, or with joints to the same body, are meant to overlap.
fn overlap_warning(model: &Model, overlapping: BTreeSet<[usize; 2]>) -> Option<String> {
    if overlapping.is_empty() {
        return None;
    }
    let connections = Connections::new(model);
    let loose: Vec<[usize; 2]> =
        overlapping.into_iter().filter(|[a, b]| !connections.are_near(*a, *b)).collect();
    let name = |body: usize| format!("`{}`", model.bodies[body].name());
    let pair = |[a, b]: &[usize; 2]| format!("{} and {}", name(*a), name(*b));
    let named = loose.iter().take(PAIRS).map(pair).collect::<Vec<_>>().join(", ");
    let others = match loose.len() {
        0 => return None,
        count if count == PAIRS + 1 => " and another pair".to_owned(),
        count if count > PAIRS => format!(" and {} other pairs", count - PAIRS),
        _ => String::new(),
    };
    Some(format!(
        "bodies {named}{others} overlap in the initial state by more than 1 % of their radii or half thicknesses: these parts count as \
         joined and do not touch; leave a gap, or add a joint that connects them"
    ))
}
