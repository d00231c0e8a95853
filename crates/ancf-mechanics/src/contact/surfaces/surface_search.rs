use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::Arc;

use ancf_solver::equations::{ContactGroup, ContactPair, ContactSearch, State, Term};
use nalgebra::Vector3;

use super::target::{SurfaceTarget, TargetSurface, hull};
use crate::contact::parts::{
    AlignedBox, BoxTree, ContactGeometry, ContactPoint, JOINED_OVERLAP, MAX_SAMPLES, SMALLEST_DISTANCE,
    SPACING,
};
use crate::laws::ContactLaw;

/// Contact search between points of bodies and the surfaces of shells of one kind. A pair is a point and an element of a shell, a group
/// is the points of an element of a body and an element of a shell.
///
/// Pairs that overlap in the initial state by more than 1 % of the radii count as joined and have no contact. Examples are the
/// points of an element and the element itself, or a beam on a shell.
#[derive(Debug)]
pub struct SurfaceContacts<T> {
    sources: Vec<PointSource>,
    points: Vec<ContactPoint>,
    targets: Vec<Target<T>>,
    law: ContactLaw,
    joined: Vec<ContactPair>,
    /// Index of the first joined pair of each point, and last the number of pairs.
    first_joined: Vec<usize>,
}

/// Points of an element of a body.
#[derive(Debug)]
struct PointSource {
    body: usize,
    points: Range<usize>,
    /// Smallest radius of the body, and the largest one of the points.
    radius: f64,
    reach: f64,
}

/// Element of a shell.
#[derive(Debug)]
struct Target<T> {
    shell: usize,
    geometry: T,
    /// Smallest radius of the shell.
    radius: f64,
}

/// Source and target.
type Candidate = [usize; 2];

impl<T: SurfaceTarget> SurfaceContacts<T> {
    /// Creates the search for the points of some bodies and the elements of some shells.
    ///
    /// Pairs that overlap in a state are joined.
    pub fn new(
        bodies: &[ContactGeometry],
        shells: &[ContactGeometry],
        law: ContactLaw,
        begin: &State,
    ) -> Self {
        let (mut sources, mut points) = (Vec::new(), Vec::new());
        for (number, body) in bodies.iter().enumerate() {
            for part in body.points.chunks(body.count.max(1)) {
                let first = points.len();
                points.extend_from_slice(part);
                let radius = body.radius;
                let reach = part.iter().map(|point| radius + point.excess).fold(radius, f64::max);
                sources.push(PointSource { body: number, points: first..points.len(), radius, reach });
            }
        }
        let of = |(number, shell): (usize, &ContactGeometry)| {
            let radius = shell.radius;
            let target = move |geometry: &T| Target { shell: number, geometry: geometry.clone(), radius };
            T::of(shell).iter().map(target).collect::<Vec<_>>()
        };
        let targets = shells.iter().enumerate().flat_map(of).collect();
        let first_joined = vec![0; points.len() + 1];
        let mut search = Self { sources, points, targets, law, joined: Vec::new(), first_joined };
        search.joined = search.overlapping(begin);
        let first = |point: usize| search.joined.partition_point(|[i, _]| (*i as usize) < point);
        search.first_joined = (0..search.first_joined.len()).map(first).collect();
        search
    }

    /// Returns the pairs that overlap in a state by more than the limit of joined ones.
    fn overlapping(&self, s: &State) -> Vec<ContactPair> {
        let (positions, surfaces, mut found) = (self.positions(s), self.surfaces(s), Vec::new());
        self.visit_candidates(&positions, &surfaces, 0.0, |[source, target]| {
            let limit = 1.0 - JOINED_OVERLAP;
            let hull = hull(&surfaces[target], limit, self.reach([source, target]));
            for i in self.sources[source].points.clone() {
                let (point, surface) = (&positions[i], &surfaces[target]);
                let radius = self.radius([source, target], i);
                if hull.contains(point) && surface.relative_distance(point, radius) < limit {
                    found.push([i as u32, target as u32]);
                }
            }
        });
        found.sort_unstable();
        found
    }

    /// Returns the bodies and shells with joined points, by their numbers in the lists, in ascending order.
    pub fn joined_bodies(&self) -> Vec<[usize; 2]> {
        let of = |[point, target]: &ContactPair| {
            [self.sources[self.source(*point as usize)].body, self.targets[*target as usize].shell]
        };
        let pairs: BTreeSet<[usize; 2]> = self.joined.iter().map(of).collect();
        pairs.into_iter().collect()
    }

    /// Returns the source of a point.
    fn source(&self, point: usize) -> usize {
        self.sources.partition_point(|source| source.points.end <= point)
    }

    /// Returns the sum of the smallest radii.
    fn radii(&self, [source, target]: Candidate) -> f64 {
        self.sources[source].radius + self.targets[target].radius
    }

    /// Returns the sum of the radius of a point and the smallest one of a shell.
    fn radius(&self, candidate: Candidate, point: usize) -> f64 {
        self.radii(candidate) + self.points[point].excess
    }

    /// Returns the largest sum of the radii of the points of a source and the smallest one of a shell.
    fn reach(&self, [source, target]: Candidate) -> f64 {
        self.sources[source].reach + self.targets[target].radius
    }

    fn is_joined(&self, point: usize, target: usize) -> bool {
        let own = &self.joined[self.first_joined[point]..self.first_joined[point + 1]];
        own.binary_search_by_key(&(target as u32), |[_, other]| *other).is_ok()
    }

    fn positions(&self, s: &State) -> Vec<Vector3<f64>> {
        self.points.iter().map(|point| point.place.value(s)).collect()
    }

    fn surfaces(&self, s: &State) -> Vec<T::Surface> {
        self.targets.iter().map(|target| target.geometry.surface(s)).collect()
    }

    /// Visits the sources and targets whose boxes are nearer than the sum of their radii and `margin` times this sum.
    fn visit_candidates(
        &self,
        positions: &[Vector3<f64>],
        surfaces: &[T::Surface],
        margin: f64,
        visit: impl FnMut(Candidate),
    ) {
        let of_source = |source: &PointSource| {
            AlignedBox::around(&positions[source.points.clone()], source.reach * (1.0 + margin))
        };
        let of_target =
            |(surface, target): (&T::Surface, &Target<T>)| hull(surface, 1.0 + margin, target.radius);
        let sources = self.sources.iter().map(of_source);
        self.visit_pairs(sources.chain(surfaces.iter().zip(&self.targets).map(of_target)).collect(), visit);
    }

    /// Visits the sources and targets whose boxes overlap. Boxes are those of the sources and then of the targets.
    fn visit_pairs(&self, boxes: Vec<AlignedBox>, mut visit: impl FnMut(Candidate)) {
        let first = self.sources.len();
        BoxTree::new(&boxes).visit_pairs(|a, b| {
            if a < first && b >= first {
                visit([a, b - first]);
            }
        });
    }

    /// Visits the points of a candidate that have contact or may soon have it, with their distance relative to the radii.
    fn visit_points(
        &self,
        candidate @ [source, target]: Candidate,
        positions: &[Vector3<f64>],
        surface: &T::Surface,
        mut visit: impl FnMut(usize, f64),
    ) {
        let reach = self.reach(candidate);
        let hull = hull(surface, 2.0, reach);
        let radius = |i: usize| self.radius(candidate, i);
        let places = self.sources[source].points.clone().map(|i| (i, positions[i], radius(i)));
        let mut near = places.filter(|(i, point, _)| hull.contains(point) && !self.is_joined(*i, target));
        let geometry = &self.targets[target].geometry;
        let first = target - geometry.number();
        let is_joined = |i: usize, element: usize| self.is_joined(i, first + element);
        geometry
            .visit_near(surface, reach, &mut near, &is_joined, &mut |i, distance| visit(i, distance - 1.0));
    }

    /// Visits the near points of all candidates with their distances.
    fn visit_near(&self, s: &State, mut visit: impl FnMut(Candidate, usize, f64)) {
        let (positions, surfaces) = (self.positions(s), self.surfaces(s));
        self.visit_candidates(&positions, &surfaces, 1.0, |candidate| {
            let surface = &surfaces[candidate[1]];
            self.visit_points(candidate, &positions, surface, |i, distance| visit(candidate, i, distance));
        });
    }

    /// Calls `visit` for the points and elements that move relative to each other by more than a quarter of their radii between two
    /// states, at the checked parts of the straight line, until it returns true for a pair.
    ///
    /// `visit` receives the point, the part, and the distances at the start, there and at the end relative to the radii.
    fn visit_between(&self, [from, to]: [&State; 2], mut visit: impl FnMut(usize, f64, [f64; 3]) -> bool) {
        let ends = [from, to].map(|s| (self.positions(s), self.surfaces(s)));
        let [(starts, before), (stops, after)] = &ends;
        let of_points = starts.iter().zip(stops).map(|(a, b)| (b - a).norm()).fold(0.0, f64::max);
        let nets = before.iter().zip(after).flat_map(|(a, b)| a.hull_points().iter().zip(b.hull_points()));
        let of_nets = nets.map(|(a, b)| (b - a).norm()).fold(0.0, f64::max);
        let least = |radii: &mut dyn Iterator<Item = f64>| radii.fold(f64::INFINITY, f64::min);
        let radii = least(&mut self.sources.iter().map(|source| source.radius))
            + least(&mut self.targets.iter().map(|target| target.radius));
        if of_points + of_nets <= SPACING * radii {
            return;
        }
        let of_source = |source: &PointSource| {
            let places = source.points.clone();
            let all: Vec<_> = starts[places.clone()].iter().chain(&stops[places]).copied().collect();
            AlignedBox::around(&all, source.reach)
        };
        let of_target = |k: usize| {
            let own = |surface| hull(surface, 1.0, self.targets[k].radius);
            own(&before[k]).with(&own(&after[k]))
        };
        let targets = (0..self.targets.len()).map(of_target);
        let boxes = self.sources.iter().map(of_source).chain(targets).collect();
        self.visit_pairs(boxes, |candidate @ [source, target]| {
            let radii = self.radii(candidate);
            for i in self.sources[source].points.clone() {
                if self.is_joined(i, target) {
                    continue;
                }
                let moved = stops[i] - starts[i];
                let net = before[target].hull_points().iter().zip(after[target].hull_points());
                let relative = net.map(|(a, b)| (moved - (b - a)).norm()).fold(0.0, f64::max);
                let count = (relative / (SPACING * radii)).ceil();
                if count > MAX_SAMPLES {
                    // Too many states to check: the point counts as passed through the surface.
                    visit(i, 1.0, [f64::INFINITY, 0.0, f64::INFINITY]);
                    continue;
                }
                if count <= 1.0 {
                    continue;
                }
                let distance = |part: f64| {
                    let surface = before[target].between(&after[target], part);
                    let point = starts[i] + moved * part;
                    surface.relative_distance(&point, self.radius(candidate, i))
                };
                let [first, last] = [0.0, 1.0].map(distance);
                let parts = (1..count as usize).map(|k| k as f64 / count);
                for part in parts {
                    if visit(i, part, [first, distance(part), last]) {
                        break;
                    }
                }
            }
        });
    }
}

impl<T: SurfaceTarget> ContactSearch for SurfaceContacts<T> {
    fn near(&self, s: &State) -> Vec<(ContactPair, f64)> {
        let mut near = Vec::new();
        self.visit_near(s, |[_, target], i, distance| near.push(([i as u32, target as u32], distance)));
        near.sort_unstable_by_key(|(pair, _)| *pair);
        near
    }

    fn near_groups(&self, s: &State) -> Vec<(ContactGroup, f64)> {
        let mut near: Vec<(ContactGroup, f64)> = Vec::new();
        self.visit_near(s, |candidate, _, distance| {
            let group = candidate.map(|k| k as u32);
            match near.last_mut().filter(|(last, _)| *last == group) {
                Some((_, least)) => *least = least.min(distance),
                None => near.push((group, distance)),
            }
        });
        near.sort_unstable_by_key(|(group, _)| *group);
        near
    }

    fn contains(&self, [source, target]: ContactGroup) -> bool {
        (source as usize) < self.sources.len() && (target as usize) < self.targets.len()
    }

    fn crossing(&self, from: &State, to: &State) -> Option<usize> {
        let mut crossing = None;
        self.visit_between([from, to], |point, _, [before, here, _]| {
            let is_crossing = here < SMALLEST_DISTANCE && before >= SMALLEST_DISTANCE;
            if is_crossing && crossing.is_none_or(|other| point < other) {
                crossing = Some(point);
            }
            is_crossing
        });
        crossing.and_then(|point| self.points[point].place.coordinates().next())
    }

    fn passing(&self, from: &State, to: &State) -> Option<f64> {
        let mut earliest: Option<f64> = None;
        self.visit_between([from, to], |_, part, [before, here, after]| {
            let is_passing = here < 1.0 && before >= 1.0 && after >= 1.0;
            if is_passing {
                earliest = Some(earliest.map_or(part, |other| other.min(part)));
            }
            is_passing
        });
        earliest
    }

    fn term(&self, [point, target]: ContactPair) -> Arc<dyn Term> {
        let (point, target) = (point as usize, target as usize);
        self.contact(vec![point], [self.source(point), target])
    }

    fn group_term(&self, [source, target]: ContactGroup) -> Arc<dyn Term> {
        let candidate @ [source, target] = [source as usize, target as usize];
        let open = self.sources[source].points.clone().filter(|i| !self.is_joined(*i, target));
        self.contact(open.collect(), candidate)
    }
}

impl<T: SurfaceTarget> SurfaceContacts<T> {
    /// Creates the contact of points, by their numbers, with an element.
    fn contact(&self, numbers: Vec<usize>, candidate @ [_, target]: Candidate) -> Arc<dyn Term> {
        let points: Vec<ContactPoint> = numbers.iter().map(|i| self.points[*i].clone()).collect();
        let geometry = &self.targets[target].geometry;
        let first = target - geometry.number();
        let is_joined = |i: usize, element: usize| self.is_joined(numbers[i], first + element);
        geometry.contact(&points, &is_joined, self.radii(candidate), self.law)
    }
}
