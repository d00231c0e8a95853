//! Overlaps of bodies that should touch each other.

use super::connections::Connections;
use crate::model::{IndexedModel, Model};

/// Largest number of pairs in a warning.
const PAIRS: usize = 3;

/// Warning of bodies in contact that overlap in the undeformed state, so that parts of them do not touch.
///
/// Bodies with a joint between them, or with joints to the same body, are meant to overlap.
pub(super) fn overlap_warning(model: &Model) -> Option<String> {
    let overlapping = IndexedModel::new(model).overlapping_bodies();
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
