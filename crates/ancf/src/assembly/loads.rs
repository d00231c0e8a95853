//! Loads that act along bodies or on all of them, as terms.

use std::sync::Arc;

use ancf_mechanics::bodies::{BeamMesh, ElementSpan};
use ancf_mechanics::forces::{ExternalForce, FollowerForce, Force, Moment};
use ancf_mechanics::functions::Function;
use ancf_mechanics::kinematics::Attachment;
use ancf_solver::equations::Term;
use nalgebra::Vector3;

use crate::model::{Body, Fluid, Load, Model, Stretch, TimeMode};

type Terms = Vec<Box<dyn Term>>;

impl Model {
    /// A load that acts at no single place.
    pub(crate) fn spread_load(
        &self,
        load: &Load,
        bodies: &[(String, ancf_mechanics::bodies::BodyTerms)],
        time_mode: TimeMode,
    ) -> Terms {
        let function = load.function(time_mode);
        match load {
            Load::Force { .. } | Load::Moment { .. } | Load::External { .. } => Terms::new(),
            Load::Custom(load) => load.kind().terms(&self.attachment(bodies, load.kind().on()), function),
            Load::DistributedForce { .. } | Load::DistributedMoment { .. } => {
                load.stretch().map_or_else(Terms::new, |on| self.along(load, &on, bodies, &function))
            }
            Load::BaseAcceleration { acceleration, .. } => {
                let inertia = -Vector3::from(*acceleration);
                let markers = bodies.iter().flat_map(|(_, body)| body.mass_markers());
                let term = |marker| Box::new(Force::varying(&marker, inertia, function.clone())) as _;
                markers.map(term).collect()
            }
            Load::Fluid(fluid) => self.immersed(fluid, bodies, time_mode),
        }
    }

    /// A load per length.
    fn along(
        &self,
        load: &Load,
        on: &Stretch<'_>,
        bodies: &[(String, ancf_mechanics::bodies::BodyTerms)],
        function: &Function,
    ) -> Terms {
        let pairs =
            self.bodies.iter().zip(bodies).filter_map(|(body, (_, built))| Some((body, built.mesh()?)));
        let Some((body, mesh)) = pairs.into_iter().find(|(body, _)| body.name() == on.body) else {
            return Terms::new();
        };
        let [from, to] = [on.from, on.to].map(|at| body.arc_length(at));
        let [first, last] = on.loads.map(Vector3::from);
        let part = |s: f64| (s - from) / (to - from);
        let mut terms = Terms::new();
        for piece in mesh.element_spans(from..to) {
            if !load.is_follower() && !load.is_moment() {
                terms.extend(dead(mesh, &piece, [first, last], &part, function));
                continue;
            }
            for (s, length) in piece.points() {
                let now = (first + (last - first) * part(s)) * length;
                let ([_, d, e], function) = (mesh.axes(s), function.clone());
                terms.push(match (load.is_moment(), load.is_follower()) {
                    (false, _) => {
                        Box::new(FollowerForce::in_section(&mesh.point(s), [&d, &e], now, function))
                    }
                    (true, true) => Box::new(Moment::in_section([&d, &e], now, function)),
                    (true, false) => Box::new(Moment::new([&d, &e], now, function)),
                });
            }
        }
        terms
    }

    /// A fluid around bodies.
    fn immersed(
        &self,
        fluid: &Fluid,
        bodies: &[(String, ancf_mechanics::bodies::BodyTerms)],
        time_mode: TimeMode,
    ) -> Terms {
        let medium = fluid.medium(self.gravity, time_mode);
        let around = |(body, mesh): (&Body, &BeamMesh)| {
            let hull = |s: f64| {
                let hull = self.section_at(body, s / mesh.length()).and_then(|section| fluid.hull(&section));
                hull.expect("a checked model says the diameters of its bodies in fluids")
            };
            mesh.hydrodynamic_loads(&medium, hull)
        };
        let wet = self.bodies.iter().zip(bodies).filter_map(|(body, (_, built))| Some((body, built.mesh()?)));
        let wet = wet.filter(|(body, _)| fluid.bodies.iter().any(|name| name == body.name()));
        wet.flat_map(around).map(|term| Box::new(term) as _).collect()
    }
}

/// A load per length that stays, on a piece: exactly the forces that do its work on a cubic axis.
fn dead(
    mesh: &BeamMesh,
    piece: &ElementSpan,
    [first, last]: [Vector3<f64>; 2],
    part: &dyn Fn(f64) -> f64,
    function: &Function,
) -> Terms {
    let force = |p: &dyn Fn(f64) -> f64, force: Vector3<f64>| {
        Box::new(Force::varying(&mesh.distributed_marker(piece, p), force, function.clone())) as Box<dyn Term>
    };
    if first == last {
        return vec![force(&|_| 1.0, first)];
    }
    vec![force(&|s| 1.0 - part(s), first), force(part, last)]
}

impl Load {
    /// What its function of time is in an analysis; 1 if it has none.
    pub(crate) fn function(&self, time_mode: TimeMode) -> Function {
        self.time().map_or(Function::ONE, |time| time_mode.function(time))
    }

    /// The load at a place of a model of a length, if it acts at one and the body has what it holds on to there.
    pub(crate) fn term(&self, on: &Attachment, time_mode: TimeMode, length: f64) -> Option<Box<dyn Term>> {
        let function = self.function(time_mode);
        let directors = on.axes().map(|[_, d, e]| [d, e]);
        Some(match self {
            Self::Force { force, follower: false, .. } => {
                Box::new(Force::varying(&on.point, Vector3::from(*force), function))
            }
            Self::Force { force, follower: true, .. } => {
                Box::new(FollowerForce::new(&on.point, directors?, Vector3::from(*force), function))
            }
            Self::Moment { moment, follower: false, .. } => {
                Box::new(Moment::new(directors?, Vector3::from(*moment), function))
            }
            Self::Moment { moment, follower: true, .. } => {
                Box::new(Moment::follower(directors?, Vector3::from(*moment), function))
            }
            Self::External { units, supplied, .. } => {
                let own = supplied.as_ref()?;
                let own = if time_mode == TimeMode::AsGiven { own.clone() } else { own.frozen_at(1.0) };
                let function = own.in_units(units.length, units.time, units.force);
                Box::new(ExternalForce::new(&on.point, function, length))
            }
            _ => return None,
        })
    }
}

impl Fluid {
    pub(crate) fn medium(
        &self,
        gravity: [f64; 3],
        time_mode: TimeMode,
    ) -> Arc<ancf_mechanics::fluid::FlowField> {
        Arc::new(ancf_mechanics::fluid::FlowField {
            density: self.density,
            gravity: Vector3::from(gravity),
            current: Vector3::from(self.current),
            function: time_mode.function(&self.time),
        })
    }
}
