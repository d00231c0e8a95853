//! Connections of bodies with the ground and with each other.

use crate::joints::End;
use crate::model::{IndexedModel, Load, Model};

/// Bodies and the ground as a graph, with the joints as edges.
pub(super) struct Connections<'a> {
    model: &'a Model,
    indexed: IndexedModel<'a>,
    /// Neighbours of each body, and last those of the ground.
    neighbours: Vec<Vec<usize>>,
    /// Group of connected bodies of each body and of the ground.
    groups: Vec<usize>,
}

impl<'a> Connections<'a> {
    /// Finds the bodies that joints connect, springs included.
    pub(super) fn new(model: &'a Model) -> Self {
        let indexed = IndexedModel::new(model);
        let ground = model.bodies.len();
        let mut neighbours = vec![Vec::new(); ground + 1];
        for joint in &model.joints {
            let (a, b) = joint.ends();
            let b = if let End::Place(b) = b { indexed.body_number(&b.body) } else { Some(ground) };
            if let (Some(a), Some(b)) = (indexed.body_number(&a.body), b) {
                neighbours[a].push(b);
                neighbours[b].push(a);
            }
        }
        let groups = groups(&neighbours);
        Self { model, indexed, neighbours, groups }
    }

    /// Names of the bodies without joints.
    pub(super) fn unconnected(&self) -> Vec<String> {
        self.names(|body| self.neighbours[body].is_empty())
    }

    /// Names of the bodies with joints that do not connect them to the ground.
    pub(super) fn unreached(&self) -> Vec<String> {
        self.names(|body| !self.is_grounded(body) && !self.neighbours[body].is_empty())
    }

    /// True for bodies with a joint between them, or with joints to the same body.
    pub(super) fn are_near(&self, a: usize, b: usize) -> bool {
        let ground = self.model.bodies.len();
        let own = &self.neighbours[a];
        own.contains(&b) || own.iter().any(|other| *other != ground && self.neighbours[b].contains(other))
    }

    fn is_grounded(&self, body: usize) -> bool {
        self.groups[body] == self.groups[self.model.bodies.len()]
    }

    fn names(&self, is_meant: impl Fn(usize) -> bool) -> Vec<String> {
        let bodies = self.model.bodies.iter().enumerate();
        bodies.filter(|(body, _)| is_meant(*body)).map(|(_, body)| body.name().to_owned()).collect()
    }

    /// Warning of bodies of a motion that fall under gravity alone: no joint or spring connects them with the ground, and no
    /// contact, load or initial motion shows that this is intended.
    pub(super) fn falling(&self) -> Option<String> {
        let Model { analysis, gravity, bodies, contacts, loads, .. } = self.model;
        if analysis.dynamics().is_none() || *gravity == [0.0; 3] {
            return None;
        }
        let mut is_intended = vec![false; self.groups.len()];
        let mut intend = |body: usize| is_intended[self.groups[body]] = true;
        intend(bodies.len());
        (0..bodies.len()).filter(|&body| !bodies[body].motion().is_rest()).for_each(&mut intend);
        contacts.iter().flat_map(|contact| contact.bodies(self.model)).for_each(&mut intend);
        for load in loads.iter().map(Load::kind) {
            // Other loads, such as flows, act on any body.
            let body = load.on().map(|on| on.body.as_str()).or_else(|| load.along().map(|part| part.body))?;
            self.indexed.body_number(body).iter().copied().for_each(&mut intend);
        }
        let falling = self.names(|body| !is_intended[self.groups[body]]);
        let (bodies, they) = match falling.as_slice() {
            [] => return None,
            [_] => ("body", "it falls"),
            _ => ("bodies", "they fall"),
        };
        let names = falling.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
        Some(format!("no joint, spring, contact or load acts on {bodies} {names}: {they} freely from rest"))
    }
}

/// Numbers of the connected components of a graph.
fn groups(neighbours: &[Vec<usize>]) -> Vec<usize> {
    let mut groups = vec![usize::MAX; neighbours.len()];
    for start in 0..neighbours.len() {
        let mut open = vec![start];
        while let Some(at) = open.pop() {
            if groups[at] == usize::MAX {
                groups[at] = start;
                open.extend(&neighbours[at]);
            }
        }
    }
    groups
}
