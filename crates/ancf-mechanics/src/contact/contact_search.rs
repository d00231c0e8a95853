use std::sync::Arc;

use ancf_solver::equations::{ContactPair, ContactSearch, State, Term};
use nalgebra::Vector3;
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

use super::beam_contact::BeamContact;
use super::contact_law::ContactLaw;
use super::crossing::{SMALLEST_DISTANCE, SPACING, obstacle_crossing, obstacle_passing};
use super::obstacle::{Obstacle, ObstacleContact};
use crate::bodies::BeamMesh;
use crate::kinematics::{ElementAxis, Marker};

/// Contact geometry of a body: a round tube about its axis, with equidistant points on it, or the balls of a rigid body.
#[derive(Clone, Debug)]
pub struct ContactTube {
    axes: Vec<ElementAxis>,
    points: Vec<Marker>,
    /// Number of points per element.
    count: usize,
    /// Length of beam that each point represents.
    length: f64,
    radius: f64,
    /// Search margin.
    margin: f64,
}

/// Search margin of points without a radius, relative to the size of their body.
const POINT_MARGIN: f64 = 0.05;

impl ContactTube {
    /// Creates the tube of a body with a radius and a number of points per element.
    pub fn new(mesh: &BeamMesh, radius: f64, count: usize) -> Self {
        let all = mesh.count() * count;
        let length = mesh.length() / all as f64;
        let points = (0..all).map(|i| mesh.point((i as f64 + 0.5) * length)).collect();
        Self { axes: mesh.element_axes().collect(), points, count, length, radius, margin: radius }
    }

    /// Creates the balls of a rigid body about its points. They share the size of the body as the length.
    pub fn of_points(points: Vec<Marker>, radius: f64, size: f64) -> Self {
        let length = size / points.len() as f64;
        Self { axes: Vec::new(), points, count: 0, length, radius, margin: radius.max(POINT_MARGIN * size) }
    }

    /// Returns the radius, or the search margin of points without a radius.
    pub const fn margin(&self) -> f64 {
        self.margin
    }

    /// Returns the points of an element.
    fn points_of(&self, element: usize) -> impl Iterator<Item = (usize, &Marker)> {
        let range = element * self.count..(element + 1) * self.count;
        range.clone().zip(&self.points[range])
    }
}

/// Contact search between bodies and one obstacle.
#[derive(Debug)]
pub struct ObstacleContacts {
    contacts: Vec<Arc<ObstacleContact>>,
    margins: Vec<f64>,
    /// End of the contacts of each tube.
    ends: Vec<usize>,
}

impl ObstacleContacts {
    /// Creates the search for every point of some bodies. The search margin is one radius.
    pub fn new(obstacle: &Obstacle, tubes: &[ContactTube], law: ContactLaw) -> Self {
        let (mut contacts, mut margins, mut ends) = (Vec::new(), Vec::new(), Vec::new());
        for tube in tubes {
            let contact =
                |point: &Marker| ObstacleContact::new(obstacle, point, tube.radius, tube.length, law);
            contacts.extend(tube.points.iter().filter_map(contact).map(Arc::new));
            margins.resize(contacts.len(), tube.margin);
            ends.push(contacts.len());
        }
        Self { contacts, margins, ends }
    }
}

impl ContactSearch for ObstacleContacts {
    fn near(&self, s: &State) -> Vec<(ContactPair, f64)> {
        let distance = |(i, contact): (usize, &Arc<ObstacleContact>)| {
            ([i as u32, 0], contact.gap_of_all(&s.q) / self.margins[i])
        };
        self.contacts.iter().enumerate().map(distance).filter(|(_, distance)| *distance <= 1.0).collect()
    }

    fn crossing(&self, from: &State, to: &State) -> Option<usize> {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        let mut tubes = starts.zip(&self.ends).map(|(start, &end)| &self.contacts[start..end]);
        tubes.find_map(|contacts| obstacle_crossing(contacts, &from.q, &to.q))
    }

    fn passing(&self, from: &State, to: &State) -> Option<f64> {
        obstacle_passing(&self.contacts, &from.q, &to.q)
    }

    fn contains(&self, [contact, other]: ContactPair) -> bool {
        (contact as usize) < self.contacts.len() && other == 0
    }

    fn term(&self, pair: ContactPair) -> Arc<dyn Term> {
        Arc::clone(&self.contacts[pair[0] as usize]) as Arc<dyn Term>
    }
}

/// Contact search between bodies, including self-contact.
///
/// Each point of one body is tested against the elements of the other and vice versa, with half the stiffness each, for
/// symmetry. Pairs that overlap in the reference state by more than 1 % of the radii count as joined and have no
/// contact. Examples are a point and its own element, or beams at a joint.
#[derive(Debug)]
pub struct BeamContacts {
    tubes: Vec<ContactTube>,
    law: ContactLaw,
    /// Body and local index of each element and each point, in the order of the bodies.
    elements: Vec<(usize, usize)>,
    points: Vec<(usize, usize)>,
    /// First point of each body.
    first: Vec<usize>,
    joined: Vec<ContactPair>,
}

/// Overlap in the reference state, relative to the sum of the radii, above which two parts count as joined.
const JOINED_OVERLAP: f64 = 0.01;

/// Maximum number of states that are checked between two states.
const MAX_SAMPLES: f64 = 1000.0;

type Corner = [f64; 3];
type ElementBox = GeomWithData<Rectangle<Corner>, usize>;

impl BeamContacts {
    /// Creates the search for all pairs of the given bodies, including each body with itself.
    pub fn new(tubes: Vec<ContactTube>, law: ContactLaw) -> Self {
        let numbered = |count: &dyn Fn(&ContactTube) -> usize| -> Vec<(usize, usize)> {
            let of = |(body, tube)| (0..count(tube)).map(move |i| (body, i));
            tubes.iter().enumerate().flat_map(of).collect()
        };
        let (elements, points) = (numbered(&|tube| tube.axes.len()), numbered(&|tube| tube.points.len()));
        let starts = tubes.iter().scan(0, |next, tube| {
            *next += tube.points.len();
            Some(*next - tube.points.len())
        });
        let first = starts.collect();
        let law = ContactLaw { stiffness: 0.5 * law.stiffness, ..law };
        let contacts = Self { tubes, law, elements, points, first, joined: Vec::new() };
        let coordinates = contacts.tubes.iter().flat_map(|tube| tube.axes.iter());
        let end = coordinates.flat_map(ElementAxis::coordinates).max().map_or(0, |last| last + 1);
        contacts.with_joined_pairs(&State::rest(end, 0))
    }

    /// Treats pairs that overlap in another state as joined too.
    #[must_use]
    pub fn with_joined_pairs(mut self, s: &State) -> Self {
        self.joined.clear();
        let near = self.near(s).into_iter();
        let overlaps = |pair: &ContactPair| self.contact(*pair).overlaps(s, JOINED_OVERLAP);
        self.joined = near.map(|(pair, _)| pair).filter(overlaps).collect();
        self
    }

    /// Returns the first result of `find` on the straight line between two states, from its position and state.
    ///
    /// The states between both are sampled so that no point moves by more than a quarter of the smallest radius.
    fn between<T>(&self, from: &State, to: &State, find: impl Fn(f64, &State) -> Option<T>) -> Option<T> {
        let all = self.tubes.iter().flat_map(|tube| &tube.points);
        let farthest = all.map(|point| (point.value(to) - point.value(from)).norm()).fold(0.0, f64::max);
        let smallest = self.tubes.iter().map(|tube| tube.radius).fold(f64::INFINITY, f64::min);
        let count = (farthest / (SPACING * smallest)).ceil();
        // Terms reject a small distance at the end ([`Term::inadmissibility`]).
        if count <= 1.0 {
            return None;
        }
        let count = count.min(MAX_SAMPLES);
        let mut between = from.clone();
        (1..=count as usize).find_map(|k| {
            let part = k as f64 / count;
            let ends = from.q.iter().zip(&to.q);
            between.q.iter_mut().zip(ends).for_each(|(q, (from, to))| *q = from + part * (to - from));
            find(part, &between)
        })
    }

    /// Returns a pair whose axes are too close in a state.
    fn deep(&self, s: &State) -> Option<ContactPair> {
        let near = self.near(s).into_iter().filter(|(_, distance)| *distance < 0.0);
        near.map(|(pair, _)| pair).find(|pair| self.contact(*pair).overlaps(s, 1.0 - SMALLEST_DISTANCE))
    }

    fn contact(&self, [point, element]: ContactPair) -> BeamContact {
        let ((a, i), (b, k)) = (self.points[point as usize], self.elements[element as usize]);
        let (own, other) = (&self.tubes[a], &self.tubes[b]);
        let ends = [k == 0, k + 1 == other.axes.len()];
        BeamContact::new(
            &own.points[i],
            &other.axes[k],
            ends,
            own.radius + other.radius,
            own.length,
            self.law,
        )
    }
}

impl ContactSearch for BeamContacts {
    /// An R*-tree (Beckmann et al. 1990) finds elements with near boxes, then the points of one near the box of the
    /// other.
    fn near(&self, s: &State) -> Vec<(ContactPair, f64)> {
        let boxes: Vec<AABB<Corner>> = self
            .elements
            .iter()
            .map(|&(body, k)| {
                let hull = self.tubes[body].axes[k].bezier_points(&s.q).map(Corner::from);
                AABB::from_points(&hull)
            })
            .collect();
        let boxed = |(i, b): (usize, &AABB<Corner>)| ElementBox::new(Rectangle::from_aabb(*b), i);
        let tree = RTree::bulk_load(boxes.iter().enumerate().map(boxed).collect());
        let largest = self.tubes.iter().map(|tube| tube.radius).fold(0.0, f64::max);
        let mut near = Vec::new();
        for (i, &(a, element)) in self.elements.iter().enumerate() {
            let tube = &self.tubes[a];
            // Both radii, and a margin of the same size.
            let reach = 2.0 * (tube.radius + largest);
            let around =
                AABB::from_corners(boxes[i].lower().map(|x| x - reach), boxes[i].upper().map(|x| x + reach));
            let others: Vec<usize> = tree.locate_in_envelope_intersecting(around).map(|b| b.data).collect();
            for (number, point) in tube.points_of(element) {
                let value = point.value(s);
                for &k in &others {
                    let radii = tube.radius + self.tubes[self.elements[k].0].radius;
                    let distance = (box_distance(&value, &boxes[k]) - radii) / radii;
                    let pair = [(self.first[a] + number) as u32, k as u32];
                    if distance <= 1.0 && self.joined.binary_search(&pair).is_err() {
                        near.push((pair, distance));
                    }
                }
            }
        }
        near.sort_unstable_by_key(|(pair, _)| *pair);
        near
    }

    fn crossing(&self, from: &State, to: &State) -> Option<usize> {
        self.between(from, to, |_, between| {
            let pair = self.deep(between)?;
            let is_new = !self.contact(pair).overlaps(from, 1.0 - SMALLEST_DISTANCE);
            is_new.then(|| self.contact(pair).coordinates().first().copied()).flatten()
        })
    }

    fn passing(&self, from: &State, to: &State) -> Option<f64> {
        self.between(from, to, |part, between| {
            let near = self.near(between).into_iter().filter(|(_, distance)| *distance < 0.0);
            let mut pairs = near.map(|(pair, _)| self.contact(pair));
            let is_new = |contact: &BeamContact| [from, to].iter().all(|end| !contact.overlaps(end, 0.0));
            pairs.any(|contact| contact.overlaps(between, 0.0) && is_new(&contact)).then_some(part)
        })
    }

    fn contains(&self, pair: ContactPair) -> bool {
        let [point, element] = pair.map(|i| i as usize);
        let is_there = point < self.points.len() && element < self.elements.len();
        is_there && self.joined.binary_search(&pair).is_err()
    }

    fn term(&self, pair: ContactPair) -> Arc<dyn Term> {
        Arc::new(self.contact(pair))
    }
}

/// Returns the distance of a point from a box.
fn box_distance(point: &Vector3<f64>, b: &AABB<Corner>) -> f64 {
    let (lower, upper) = (b.lower(), b.upper());
    let beyond = Vector3::from_fn(|i, _| (lower[i] - point[i]).max(point[i] - upper[i]).max(0.0));
    beyond.norm()
}
