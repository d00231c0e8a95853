use std::collections::BTreeSet;
use std::sync::Arc;

use ancf_solver::equations::{ContactGroup, ContactPair, ContactSearch, State, Term};
use nalgebra::Vector3;

use super::axis_curve::{AxisCurve, AxisHull};
use super::beam_contact::{BeamContact, ContactElement};
use super::end_planes::EndPlanes;
use crate::contact::parts::{
    AlignedBox, BoxTree, ContactGeometry, ContactPoint, JOINED_OVERLAP, MAX_SAMPLES, SMALLEST_DISTANCE,
    SPACING,
};
use crate::kinematics::ElementAxis;
use crate::laws::ContactLaw;

/// Gap of near elements, relative to the sum of their radii. The terms of near elements fill the matrix, and a smaller gap requires new
/// terms more often.
const MARGIN: f64 = 0.25;

/// Contact search between bodies, including self-contact. A pair is a point and an element, a group is two elements.
///
/// Each point of one body is tested against the elements of the other and vice versa, with half the stiffness each, for
/// symmetry. Pairs that overlap in the first state by more than 1 % of the radii count as joined and have no
/// contact. Examples are neighbours on an axis, or beams at a joint.
#[derive(Debug)]
pub struct BeamContacts {
    tubes: Vec<ContactGeometry>,
    law: ContactLaw,
    /// Body and local index of each element and each point, in the order of the bodies.
    elements: Vec<(usize, usize)>,
    points: Vec<(usize, usize)>,
    /// First point of each body.
    first: Vec<usize>,
    joined: Vec<ContactPair>,
}

/// Axis of an element in a state.
struct ElementShape {
    curve: AxisCurve,
    hull: AxisHull,
}

impl BeamContacts {
    /// Creates the search for all pairs of the given bodies, including each body with itself. Pairs that overlap in the state `begin`
    /// are joined.
    pub fn new(tubes: Vec<ContactGeometry>, law: ContactLaw, begin: &State) -> Self {
        let numbered = |count: &dyn Fn(&ContactGeometry) -> usize| -> Vec<(usize, usize)> {
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
        let mut contacts = Self { tubes, law, elements, points, first, joined: Vec::new() };
        contacts.joined = contacts.overlapping_pairs(begin);
        contacts
    }

    /// Returns the pairs that overlap in a state by more than 1 % of the radii, in ascending order.
    fn overlapping_pairs(&self, s: &State) -> Vec<ContactPair> {
        let (shapes, mut joined) = (self.shapes(s), Vec::new());
        self.visit_groups(&shapes, |group| {
            let radii = self.radii(group);
            self.scan(&shapes, group, radii, |[of_point, other], i, point, _| {
                let curve = &shapes[other].curve;
                let distance = (point - curve.point(curve.closest(point))).norm();
                if distance < (1.0 - JOINED_OVERLAP) * radii {
                    joined.push(self.pair([of_point, other], i));
                }
                radii
            });
        });
        joined.sort_unstable();
        joined
    }

    /// Returns the pairs of different bodies with joined points, in ascending order.
    pub fn joined_bodies(&self) -> Vec<[usize; 2]> {
        let body = |[point, other]: &ContactPair| {
            let [a, b] = [self.points[*point as usize].0, self.elements[*other as usize].0];
            [a.min(b), a.max(b)]
        };
        let pairs: BTreeSet<[usize; 2]> = self.joined.iter().map(body).filter(|[a, b]| a != b).collect();
        pairs.into_iter().collect()
    }

    fn axis(&self, element: usize) -> &ElementAxis {
        let (body, k) = self.elements[element];
        &self.tubes[body].axes[k]
    }

    fn tube(&self, element: usize) -> &ContactGeometry {
        &self.tubes[self.elements[element].0]
    }

    /// Returns the sum of the radii of two elements.
    fn radii(&self, [a, b]: [usize; 2]) -> f64 {
        self.tube(a).radius + self.tube(b).radius
    }

    /// Returns the distance up to which the axes of two elements are near.
    fn limit(&self, group: [usize; 2]) -> f64 {
        (1.0 + MARGIN) * self.radii(group)
    }

    /// Returns the gap for a distance of the axes of two elements, relative to the margin.
    fn gap(&self, group: [usize; 2], distance: f64) -> f64 {
        (distance / self.radii(group) - 1.0) / MARGIN
    }

    /// Returns the pair of point i of an element and another element.
    fn pair(&self, [of_point, other]: [usize; 2], i: usize) -> ContactPair {
        let (body, k) = self.elements[of_point];
        [(self.first[body] + k * self.tubes[body].count + i) as u32, other as u32]
    }

    fn is_joined(&self, pair: ContactPair) -> bool {
        self.joined.binary_search(&pair).is_ok()
    }

    fn shapes(&self, s: &State) -> Vec<ElementShape> {
        let shape = |&(body, k): &(usize, usize)| {
            let curve = AxisCurve::new(&self.tubes[body].axes[k], &s.q, &Vector3::zeros());
            ElementShape { curve, hull: AxisHull::new(&curve) }
        };
        self.elements.iter().map(shape).collect()
    }

    /// Visits the pairs of elements with a gap of at most the margin, smaller index first.
    fn visit_groups(&self, shapes: &[ElementShape], mut visit: impl FnMut([usize; 2])) {
        let boxes = shapes.iter().enumerate().map(|(i, shape)| {
            AlignedBox::around(&shape.curve.bezier_points(), (1.0 + MARGIN) * self.tube(i).radius)
        });
        let boxes: Vec<AlignedBox> = boxes.collect();
        BoxTree::new(&boxes).visit_pairs(|a, b| {
            if shapes[a].hull.distance_from(&shapes[b].hull) <= self.limit([a, b]) {
                visit([a, b]);
            }
        });
    }

    /// Visits the points of both elements of a group that may be nearer to the other element than a limit.
    ///
    /// `visit` receives the element of the point and the other one, the index of the point in its element, the point, and the
    /// lower bound of its distance. It returns the limit of the next points.
    fn scan(
        &self,
        shapes: &[ElementShape],
        [a, b]: [usize; 2],
        limit: f64,
        mut visit: impl FnMut([usize; 2], usize, &Vector3<f64>, f64) -> f64,
    ) {
        let mut limit = limit;
        for [own, other] in [[a, b], [b, a]] {
            let (shape, count) = (&shapes[own], self.tube(own).count);
            shape.hull.scan((&shape.curve, count), &shapes[other].hull, limit, |i, point, distance| {
                limit = visit([own, other], i, point, distance);
                limit
            });
        }
    }

    /// Returns the free ends of an element.
    fn ends(&self, element: usize) -> [bool; 2] {
        let (body, k) = self.elements[element];
        [k == 0, k + 1 == self.tubes[body].axes.len()]
    }

    /// Returns a lower bound of the distances of the points of a group that may have contact, up to a limit.
    fn distance(&self, shapes: &[ElementShape], group: [usize; 2], limit: f64) -> f64 {
        let (radii, mut planes, mut least) = (self.radii(group), [None, None], limit);
        self.scan(shapes, group, limit, |[own, other], i, point, distance| {
            let planes = planes[usize::from(other == group[1])]
                .get_or_insert_with(|| EndPlanes::new(&shapes[other].curve, self.ends(other), radii));
            let is_open = || !self.is_joined(self.pair([own, other], i));
            if distance < least && !planes.are_passed(point) && is_open() {
                least = distance;
            }
            least
        });
        least
    }

    /// Returns the first result of `find` on the straight line between two states, from its position and state.
    ///
    /// `count` states are sampled, of [`Self::samples`].
    fn between<T>(
        &self,
        [from, to]: [&State; 2],
        count: f64,
        find: impl Fn(f64, &State) -> Option<T>,
    ) -> Option<T> {
        if count <= 1.0 {
            return None;
        }
        let mut between = from.clone();
        (1..=count as usize).find_map(|k| {
            let part = k as f64 / count;
            let ends = from.q.iter().zip(&to.q);
            between.q.iter_mut().zip(ends).for_each(|(q, (from, to))| *q = from + part * (to - from));
            find(part, &between)
        })
    }

    /// Returns the number of states to sample between two states, so that no point moves by more than a quarter of the smallest radius,
    /// and a coordinate of the point that moves farthest.
    fn samples(&self, from: &State, to: &State) -> (f64, Option<usize>) {
        let smallest = self.tubes.iter().map(|tube| tube.radius).fold(f64::INFINITY, f64::min);
        let count = |distance: f64| (distance / (SPACING * smallest)).ceil();
        // Terms reject a small distance at the end ([`Term::inadmissibility`]).
        if count(self.largest_displacement(from, to)) <= 1.0 {
            return (1.0, None);
        }
        let all = self.tubes.iter().flat_map(|tube| &tube.points);
        let moved = all.map(|point| ((point.place.value(to) - point.place.value(from)).norm(), &point.place));
        let farthest = moved.max_by(|a, b| a.0.total_cmp(&b.0));
        farthest.map_or((1.0, None), |(distance, place)| (count(distance), place.coordinates().next()))
    }

    /// Returns an upper bound of the displacements of all points of all axes.
    fn largest_displacement(&self, from: &State, to: &State) -> f64 {
        let axes = self.tubes.iter().flat_map(|tube| &tube.axes);
        let of = |axis: &ElementAxis| {
            let [before, after] =
                [from, to].map(|s| AxisCurve::new(axis, &s.q, &Vector3::zeros()).bezier_points());
            (0..4).map(|i| (after[i] - before[i]).norm_squared()).fold(0.0, f64::max)
        };
        axes.map(of).fold(0.0, f64::max).sqrt()
    }

    /// Returns a pair whose axes are too close in a state.
    fn deep(&self, s: &State) -> Option<ContactPair> {
        let near = self.near(s).into_iter().filter(|(_, distance)| *distance < 0.0);
        near.map(|(pair, _)| pair).find(|pair| self.contact(*pair).overlaps(s, 1.0 - SMALLEST_DISTANCE))
    }

    /// Creates the contact of one pair.
    fn contact(&self, [point, element]: ContactPair) -> BeamContact {
        let ((body, i), element) = (self.points[point as usize], element as usize);
        let own = &self.tubes[body];
        let radii = own.radius + self.tube(element).radius;
        let ContactPoint { place, extent, .. } = &own.points[i];
        BeamContact::new(place, self.axis(element), self.ends(element), radii, *extent, self.law)
    }

    /// Returns an element of a group with the points that have no contact with the other one.
    fn element(&self, own: usize, other: usize) -> ContactElement<'_> {
        let tube = self.tube(own);
        let (count, length) = (tube.count, tube.points[0].extent);
        let except = (0..count).filter(|&i| self.is_joined(self.pair([own, other], i))).collect();
        ContactElement { axis: self.axis(own), ends: self.ends(own), count, length, except }
    }
}

impl ContactSearch for BeamContacts {
    fn near(&self, s: &State) -> Vec<(ContactPair, f64)> {
        let (shapes, mut near) = (self.shapes(s), Vec::new());
        self.visit_groups(&shapes, |group| {
            let limit = self.limit(group);
            self.scan(&shapes, group, limit, |elements, i, _, distance| {
                let pair = self.pair(elements, i);
                if !self.is_joined(pair) {
                    near.push((pair, self.gap(group, distance)));
                }
                limit
            });
        });
        near.sort_unstable_by_key(|(pair, _)| *pair);
        near
    }

    fn near_groups(&self, s: &State) -> Vec<(ContactGroup, f64)> {
        let (shapes, mut near) = (self.shapes(s), Vec::new());
        self.visit_groups(&shapes, |group| {
            let limit = self.limit(group);
            let distance = self.distance(&shapes, group, limit);
            if distance < limit {
                near.push((group.map(|i| i as u32), self.gap(group, distance)));
            }
        });
        near.sort_unstable_by_key(|(group, _)| *group);
        near
    }

    fn crossing(&self, from: &State, to: &State) -> Option<usize> {
        let (count, farthest) = self.samples(from, to);
        if count > MAX_SAMPLES {
            return farthest;
        }
        self.between([from, to], count, |_, between| {
            let pair = self.deep(between)?;
            let is_new = !self.contact(pair).overlaps(from, 1.0 - SMALLEST_DISTANCE);
            is_new.then(|| self.contact(pair).coordinates.first().copied()).flatten()
        })
    }

    fn passing(&self, from: &State, to: &State) -> Option<f64> {
        let count = self.samples(from, to).0.min(MAX_SAMPLES);
        self.between([from, to], count, |part, between| {
            let near = self.near(between).into_iter().filter(|(_, distance)| *distance < 0.0);
            let mut pairs = near.map(|(pair, _)| self.contact(pair));
            let is_new = |contact: &BeamContact| [from, to].iter().all(|end| !contact.overlaps(end, 0.0));
            pairs.any(|contact| contact.overlaps(between, 0.0) && is_new(&contact)).then_some(part)
        })
    }

    fn contains(&self, [a, b]: ContactGroup) -> bool {
        a < b && (b as usize) < self.elements.len()
    }

    fn term(&self, pair: ContactPair) -> Arc<dyn Term> {
        Arc::new(self.contact(pair))
    }

    fn group_term(&self, group: ContactGroup) -> Arc<dyn Term> {
        let [a, b] = group.map(|i| i as usize);
        let elements = [self.element(a, b), self.element(b, a)];
        Arc::new(BeamContact::of_elements(elements, self.radii([a, b]), self.law))
    }
}
