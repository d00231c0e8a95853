//! Bodies of a model as coordinates and terms.

use nalgebra::Vector3;

use super::{Beam, Body, Formulation, MaterialLaw, Model};
use crate::mechanics::{self, BeamMesh, Blueprint, Medium, RigidBody};

impl Model {
    /// The bodies, coordinates and multipliers counted on from body to body.
    pub(super) fn meshes(&self) -> Vec<(String, mechanics::Body)> {
        let mut first = [0, 0];
        let meshes = self.bodies.iter().map(|body| {
            let mesh = self.body(body, first);
            first = [first[0] + mesh.coordinates(), first[1] + mesh.multipliers()];
            (body.name().to_owned(), mesh)
        });
        meshes.collect()
    }

    fn body(&self, body: &Body, first: [usize; 2]) -> mechanics::Body {
        let (centre, gravity) = (Vector3::from(body.span()[0]), Vector3::from(self.gravity));
        match body {
            Body::Rigid(rigid) => {
                let rigid = RigidBody::new(first, centre, rigid.mass, rigid.tensor(), gravity);
                mechanics::Body::Rigid(rigid)
            }
            Body::Mass(point) => {
                mechanics::Body::Rigid(RigidBody::point(first[0], centre, point.mass, gravity))
            }
            Body::Beam(_) | Body::Cable(_) => mechanics::Body::Flexible(self.mesh(body, first[0])),
        }
    }

    fn mesh(&self, body: &Body, first: usize) -> BeamMesh {
        let (_, material) = body.stuff().expect("a flexible body has a section and a material");
        let material = &self.materials[material];
        let medium = Medium {
            lame: material.lame(),
            neo_hookean: material.law == MaterialLaw::NeoHookean,
            density: material.density,
            retardation: material.damping.strain,
            drag: material.damping.mass,
            gravity: Vector3::from(self.gravity),
        };
        let elements = body.elements() as usize;
        let curve = body.curve().expect("a checked body has an axis");
        let (total, up) = (curve.length(), body.up().expect("a checked body has a direction `up`"));
        let nodes = |parts: usize, twist: f64| {
            let at: Vec<f64> = (0..=parts).map(|k| total * k as f64 / parts as f64).collect();
            curve.nodes(up, twist, &at)
        };
        let (length, slope) = (total / elements as f64, body.slope_length());
        let section = |s: f64| {
            let section = self.section_at(body, s / total).expect("a flexible body has a section");
            section.cross_section(material.poisson)
        };
        let prismatic = !matches!(body, Body::Beam(Beam { section_end: Some(_), .. }));
        let origin = Vector3::from(body.span()[0]);
        let blueprint =
            Blueprint { first, origin, length, slope, medium: &medium, section: &section, prismatic };
        match body {
            Body::Beam(beam) => match beam.formulation.two_node() {
                Some(formulation) => {
                    BeamMesh::two_node(&blueprint, &nodes(elements, beam.twist), formulation)
                }
                None => BeamMesh::three_node(&blueprint, &nodes(2 * elements, beam.twist)),
            },
            _ => BeamMesh::cable(&blueprint, &nodes(elements, 0.0)),
        }
    }
}

impl Formulation {
    /// The formulation of the two-node element, if it is one.
    const fn two_node(self) -> Option<mechanics::Formulation> {
        match self {
            Self::Continuum => Some(mechanics::Formulation::Continuum),
            Self::Enhanced => Some(mechanics::Formulation::Enhanced),
            Self::Linked => Some(mechanics::Formulation::Linked),
            Self::Quadratic => None,
        }
    }
}
