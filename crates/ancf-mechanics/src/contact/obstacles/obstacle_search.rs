use std::ops::Range;
use std::sync::Arc;

use ancf_solver::equations::{ContactGroup, ContactPair, ContactSearch, State, Term};
use nalgebra::Vector3;

use super::ball_contact::BallContact;
use super::crossing::{obstacle_crossing, obstacle_passing};
use super::obstacle::Obstacle;
use super::obstacle_contact::ObstacleContact;
use crate::contact::parts::{ContactGeometry, ContactPoint};
use crate::laws::ContactLaw;

/// Contact search between bodies and one obstacle. A pair is a point and 0, a group is a part of the points of an element and 0.
#[derive(Debug)]
pub struct ObstacleContacts {
    obstacle: Obstacle,
    bodies: Vec<ContactGeometry>,
    law: ContactLaw,
    /// Body and points of each group, and the index of its first point.
    groups: Vec<PointGroup>,
}

#[derive(Debug)]
struct PointGroup {
    body: usize,
    points: Range<usize>,
    first: usize,
}

/// Maximum number of points that one term evaluates.
const GROUP: usize = 8;

impl ObstacleContacts {
    /// Creates the search for every point of some bodies. The search margin is one radius.
    pub fn new(obstacle: &Obstacle, bodies: &[ContactGeometry], law: ContactLaw) -> Self {
        let (mut groups, mut first) = (Vec::new(), 0);
        for (number, body) in bodies.iter().enumerate() {
            for element in (0..body.points.len()).step_by(body.count.max(1)) {
                let end = element + body.count;
                for start in (element..end).step_by(GROUP) {
                    let points = start..end.min(start + GROUP);
                    groups.push(PointGroup { body: number, first: first + start, points });
                }
            }
            first += body.points.len();
        }
        Self { obstacle: obstacle.clone(), bodies: bodies.to_vec(), law, groups }
    }

    /// Returns the points of a group.
    fn points(&self, PointGroup { body, points, .. }: &PointGroup) -> &[ContactPoint] {
        &self.bodies[*body].points[points.clone()]
    }

    /// Visits all groups with the gaps of their points, relative to the search margin.
    fn visit(&self, s: &State, mut visit: impl FnMut(usize, &PointGroup, &mut dyn Iterator<Item = f64>)) {
        let pose = self.obstacle.pose(&s.q);
        for (i, group) in self.groups.iter().enumerate() {
            let ContactGeometry { radius, margin, .. } = self.bodies[group.body];
            let distance =
                |point: &ContactPoint| (pose.gap(&point.place.value(s)) - radius - point.excess) / margin;
            visit(i, group, &mut self.points(group).iter().map(distance));
        }
    }

    /// Returns the largest depth of each body in the obstacle, relative to its radius or half thickness; negative for bodies outside.
    pub fn depths(&self, s: &State) -> Vec<f64> {
        let mut depths = vec![f64::NEG_INFINITY; self.bodies.len()];
        self.visit(s, |_, group, gaps| {
            depths[group.body] = gaps.map(|gap| -gap).fold(depths[group.body], f64::max);
        });
        depths
    }

    fn contact(&self, body: usize, points: &[ContactPoint]) -> Arc<dyn Term> {
        let ContactGeometry { radius, turning, .. } = &self.bodies[body];
        match turning {
            Some(turning) if self.law.friction > 0.0 => {
                Arc::new(BallContact::new(&self.obstacle, (points, turning), *radius, self.law))
            }
            _ => Arc::new(ObstacleContact::of_points(&self.obstacle, (points, &[]), *radius, self.law)),
        }
    }

    /// Returns the lines of points of each body, as vectors from the obstacle over the sum of the radii.
    fn radial<'a>(
        &'a self,
        from: &'a State,
        to: &'a State,
    ) -> impl Iterator<Item = impl Iterator<Item = (&'a ContactPoint, [Vector3<f64>; 2])>> {
        let poses = [from, to].map(|s| self.obstacle.pose(&s.q));
        let convex = if poses[0].is_convex() { &*self.bodies } else { &[] };
        let lines = convex.iter().flat_map(|body| body.lines().map(|line| (line, body.radius)));
        lines.map(move |(line, radius)| {
            line.filter_map(move |point| {
                let [before, after] = [(&poses[0], from), (&poses[1], to)]
                    .map(|(pose, s)| pose.radial(&point.place.value(s), radius + point.excess));
                Some((point, [before?, after?]))
            })
        })
    }
}

impl ContactSearch for ObstacleContacts {
    fn near(&self, s: &State) -> Vec<(ContactPair, f64)> {
        let mut near = Vec::new();
        self.visit(s, |_, group, distances| {
            let numbered = (group.first as u32..).map(|i| [i, 0]).zip(distances);
            near.extend(numbered.filter(|(_, distance)| *distance <= 1.0));
        });
        near
    }

    fn near_groups(&self, s: &State) -> Vec<(ContactGroup, f64)> {
        let mut near = Vec::new();
        self.visit(s, |i, _, distances| {
            let distance = distances.fold(f64::INFINITY, f64::min);
            if distance <= 1.0 {
                near.push(([i as u32, 0], distance));
            }
        });
        near
    }

    fn contains(&self, [group, other]: ContactGroup) -> bool {
        (group as usize) < self.groups.len() && other == 0
    }

    fn crossing(&self, from: &State, to: &State) -> Option<usize> {
        let passing = self.radial(from, to).find_map(obstacle_crossing)?;
        self.obstacle.coordinates(&passing.place).next()
    }

    fn passing(&self, from: &State, to: &State) -> Option<f64> {
        obstacle_passing(self.radial(from, to).flatten().map(|(_, ends)| ends))
    }

    fn term(&self, [point, _]: ContactPair) -> Arc<dyn Term> {
        let at = self.groups.partition_point(|group| group.first <= point as usize) - 1;
        let group = &self.groups[at];
        let i = point as usize - group.first;
        self.contact(group.body, &self.points(group)[i..=i])
    }

    fn group_term(&self, [group, _]: ContactGroup) -> Arc<dyn Term> {
        let group = &self.groups[group as usize];
        self.contact(group.body, self.points(group))
    }
}
