//! Mesh of a file: nodes, elements and named groups.

use std::collections::{BTreeMap, HashMap, HashSet};

use serde::{Deserialize, Serialize};

/// Quadrilaterals and triangles of a mesh file with their nodes, and its groups.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct FileMesh {
    pub(super) nodes: Vec<[f64; 3]>,
    pub(super) elements: Vec<Vec<usize>>,
    pub(super) groups: BTreeMap<String, MeshGroup>,
}

/// Named group of a mesh.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum MeshGroup {
    /// Nodes.
    Nodes(Vec<usize>),
    /// Chains of nodes.
    Edges(Vec<Vec<usize>>),
    /// Elements.
    Elements(Vec<usize>),
}

/// Point, line, triangle or quadrilateral of a file: its number, dimension, groups and numbers of nodes.
pub(super) struct FileElement {
    pub(super) tag: u64,
    pub(super) dimension: u32,
    pub(super) groups: Vec<String>,
    pub(super) nodes: Vec<u64>,
}

/// Dimension of quadrilaterals and triangles.
pub(super) const FACE: u32 = 2;

impl FileMesh {
    /// Creates the mesh of the quadrilaterals and triangles, with its nodes in the order of the file. Nodes of none are left out, since
    /// they have no effect.
    ///
    /// # Errors
    /// Descriptions of what was found.
    pub(super) fn new(nodes: &[(u64, [f64; 3])], elements: &[FileElement]) -> Result<Self, String> {
        let places: HashMap<u64, [f64; 3]> = nodes.iter().copied().collect();
        if places.len() < nodes.len() {
            return Err("a number of a node a second time".into());
        }
        if let Some((tag, _)) = nodes.iter().find(|(_, place)| place.iter().any(|x| !x.is_finite())) {
            return Err(format!("node {tag} at a place that is not finite"));
        }
        let faces = || elements.iter().filter(|element| element.dimension == FACE);
        let used: HashSet<u64> = faces().flat_map(|element| element.nodes.iter().copied()).collect();
        let (mut mesh, mut numbers) = (Self::default(), HashMap::<u64, usize>::new());
        for (tag, place) in nodes.iter().filter(|(tag, _)| used.contains(tag)) {
            numbers.insert(*tag, mesh.nodes.len());
            mesh.nodes.push(*place);
        }
        for element in faces() {
            let number = |tag: &u64| numbers.get(tag).copied().ok_or_else(|| missing(element.tag, *tag));
            mesh.elements.push(element.nodes.iter().map(number).collect::<Result<_, _>>()?);
        }
        if mesh.elements.is_empty() {
            return Err("no quadrilaterals and no triangles".into());
        }
        mesh.groups = groups(elements, &numbers)?;
        Ok(mesh)
    }
}

/// Returns the groups of the elements with the given numbers of nodes.
fn groups(
    elements: &[FileElement],
    numbers: &HashMap<u64, usize>,
) -> Result<BTreeMap<String, MeshGroup>, String> {
    let mut members = BTreeMap::<(u32, &str), Vec<Vec<usize>>>::new();
    let mut faces = 0;
    for element in elements {
        let own = if element.dimension == FACE {
            faces += 1;
            vec![faces - 1]
        } else if let Some(own) = element.nodes.iter().map(|tag| numbers.get(tag).copied()).collect() {
            own
        } else if element.groups.is_empty() {
            continue;
        } else {
            return Err(format!(
                "element {} of a group with a node of no quadrilateral and no triangle",
                element.tag
            ));
        };
        for group in &element.groups {
            members.entry((element.dimension, group)).or_default().push(own.clone());
        }
    }
    let mut groups = BTreeMap::new();
    for ((dimension, name), own) in members {
        let group = match dimension {
            0 => MeshGroup::Nodes(own.concat()),
            1 => MeshGroup::Edges(chains(&own)),
            _ => MeshGroup::Elements(own.concat()),
        };
        if groups.insert(name.to_owned(), group).is_some() {
            return Err(format!("two groups of different dimensions with the name \"{name}\""));
        }
    }
    Ok(groups)
}

fn missing(element: u64, node: u64) -> String {
    format!("element {element} with the node {node}, which does not exist")
}

/// Joins segments to chains. A closed chain ends with its first node.
fn chains(segments: &[Vec<usize>]) -> Vec<Vec<usize>> {
    let mut at_node = BTreeMap::<usize, Vec<usize>>::new();
    for (k, segment) in segments.iter().enumerate() {
        segment.iter().for_each(|node| at_node.entry(*node).or_default().push(k));
    }
    // Chains start at ends and branches; closed ones are left for the second pass.
    let starts = at_node.iter().filter(|(_, of)| of.len() != 2).map(|(node, _)| *node);
    let all = starts.collect::<Vec<_>>().into_iter().chain(at_node.keys().copied().collect::<Vec<_>>());
    let (mut used, mut chains) = (vec![false; segments.len()], Vec::new());
    for start in all {
        for &first in &at_node[&start] {
            let (mut chain, mut next) = (vec![start], Some(first).filter(|k| !used[*k]));
            while let Some(k) = next {
                used[k] = true;
                let last = chain[chain.len() - 1];
                let end = if segments[k][0] == last { segments[k][1] } else { segments[k][0] };
                chain.push(end);
                let of = &at_node[&end];
                next = of.iter().copied().find(|k| of.len() == 2 && !used[*k]);
            }
            if chain.len() > 1 {
                chains.push(chain);
            }
        }
    }
    chains
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn segments_join_to_chains() {
        let pairs = |all: &[[usize; 2]]| all.iter().map(|pair| pair.to_vec()).collect::<Vec<_>>();
        assert_eq!(chains(&pairs(&[[2, 3], [1, 2], [4, 3]])), [vec![1, 2, 3, 4]]);
        assert_eq!(chains(&pairs(&[[1, 2], [3, 1], [2, 3]])), [vec![1, 2, 3, 1]]);
        assert_eq!(chains(&pairs(&[[5, 6], [1, 2]])), [vec![1, 2], vec![5, 6]]);
    }
}
