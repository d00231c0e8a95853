//! Bodies of a model as coordinates and terms.

use ancf_mechanics::bodies::{BeamMesh, BodyTerms, MeshParameters};
use ancf_mechanics::elements::{BeamMaterial, RigidBody};
use ancf_mechanics::kinematics::{Attachment, BodyVector, Marker};
use ancf_mechanics::shells::{MembraneLaw, ShearMedium, ShearShellMesh, ShellMedium, ShellMesh};
use nalgebra::Vector3;

use crate::loads::{Load, rigidity};
use crate::model::{
    Beam, Body, FibreAxis, FieldShell as _, IndexedModel, Layup, MaterialLaw, Membrane, Place, Probe,
    ShearShell, Shell, TimeMode,
};

impl IndexedModel<'_> {
    /// Bodies as terms. Coordinates and multipliers are numbered consecutively.
    pub(crate) fn meshes(&self) -> Vec<(String, BodyTerms)> {
        let mut first = [0, 0];
        let meshes = self.bodies.iter().map(|body| {
            let mesh = self.body(body, first);
            first = [first[0] + mesh.coordinates(), first[1] + mesh.multipliers()];
            (body.name().to_owned(), mesh)
        });
        meshes.collect()
    }

    /// Adds the strains that loads prescribe to the bodies.
    pub(super) fn prestrained(
        &self,
        bodies: Vec<(String, BodyTerms)>,
        time_mode: TimeMode,
    ) -> Vec<(String, BodyTerms)> {
        let of_body = |(body, (name, terms)): (&Body, (String, BodyTerms))| {
            let of_axis = |load: &Load| match load {
                Load::Prestrain(load) if load.body == name => {
                    Some(load.source(body, rigidity(body, 0.0, self)?, time_mode.function(&load.time)))
                }
                _ => None,
            };
            let of_surface = |load: &Load| match load {
                Load::SurfacePrestrain(load) if load.body == name => {
                    Some(load.source(body, time_mode.function(&load.time)))
                }
                _ => None,
            };
            let surfaces = || self.loads.iter().filter_map(of_surface).collect();
            let terms = match terms {
                BodyTerms::Flexible(mesh) => {
                    BodyTerms::Flexible(mesh.with_prestrains(self.loads.iter().filter_map(of_axis).collect()))
                }
                BodyTerms::Shell(mesh) => BodyTerms::Shell(mesh.with_prestrains(surfaces())),
                BodyTerms::ShearShell(mesh) => BodyTerms::ShearShell(mesh.with_prestrains(surfaces())),
                other => other,
            };
            (name, terms)
        };
        self.bodies.iter().zip(bodies).map(of_body).collect()
    }

    fn body(&self, body: &Body, first: [usize; 2]) -> BodyTerms {
        let (centre, gravity) = (Vector3::from(body.span()[0]), Vector3::from(self.gravity));
        match body {
            Body::Rigid(rigid) => {
                let rigid = RigidBody::new(first, centre, rigid.mass, rigid.tensor(), gravity);
                BodyTerms::Rigid(rigid)
            }
            Body::Mass(point) => BodyTerms::Rigid(RigidBody::point(first[0], centre, point.mass, gravity)),
            Body::Shell(shell) => BodyTerms::Shell(self.shell(shell, first[0])),
            Body::ShearShell(shell) => BodyTerms::ShearShell(self.shear_shell(shell, first[0])),
            Body::Beam(_) | Body::Cable(_) => BodyTerms::Flexible(self.mesh(body, first[0])),
        }
    }

    /// Law of the membrane forces of a shell; `None` for the linear one.
    fn law(&self, membrane: Option<&Membrane>, layup: Layup<'_>) -> Option<MembraneLaw> {
        let (membrane, material) = (membrane?, &self.materials[layup.material]);
        membrane.law(material.young, material.poisson, layup.thickness)
    }

    fn shell(&self, shell: &Shell, first: usize) -> ShellMesh {
        let material = &self.materials[shell.layers()[0].0];
        let layup = shell.layup();
        let law = self.law(shell.membrane.as_ref(), layup);
        let medium = ShellMedium {
            section: self.laminate(layup).section().with_law(law),
            axis: shell.fibre_axis.as_ref().and_then(FibreAxis::uniform).map(Vector3::from),
            retardation: material.damping.strain,
            mass_damping: material.damping.mass,
            gravity: Vector3::from(self.gravity),
        };
        let divisions = shell.elements.map(|count| count as usize);
        let geometry = shell.geometry();
        let sections = shell.section_field(layup.thickness);
        ShellMesh::varying(first, divisions, geometry.origin(), |at| geometry.map(at), (&medium, sections))
    }

    fn shear_shell(&self, shell: &ShearShell, first: usize) -> ShearShellMesh {
        let layup = shell.layup();
        let material = &self.materials[layup.plies()[0].0];
        let directors = shell.unit_directors();
        let medium = ShearMedium {
            section: self.laminate(layup).thick_section().with_law(self.law(shell.membrane.as_ref(), layup)),
            axis: shell.axis(&directors),
            retardation: material.damping.strain,
            mass_damping: material.damping.mass,
            gravity: Vector3::from(self.gravity),
        };
        let sections = shell.section_field(layup.thickness);
        ShearShellMesh::varying(first, (&shell.points(), &directors), shell.faces(), &medium, sections)
    }

    fn mesh(&self, body: &Body, first: usize) -> BeamMesh {
        let (_, material) =
            body.section_and_material().expect("a flexible body has a section and a material");
        let material = &self.materials[material];
        let medium = BeamMaterial {
            lame: material.lame(),
            neo_hookean: material.law == MaterialLaw::NeoHookean,
            density: material.density,
            retardation: material.damping.retardation(),
            mass_damping: material.damping.mass,
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
            MeshParameters { first, origin, length, slope, medium: &medium, section: &section, prismatic };
        match body {
            Body::Beam(beam) => match beam.formulation.two_node_law() {
                Some(formulation) => {
                    BeamMesh::two_node(&blueprint, &nodes(elements, beam.twist), formulation)
                }
                None => BeamMesh::three_node(&blueprint, &nodes(2 * elements, beam.twist)),
            },
            _ => BeamMesh::cable(&blueprint, &nodes(elements, 0.0)),
        }
    }

    /// Index of the body of a place.
    pub(crate) fn body_of(&self, place: &Place) -> usize {
        let index = self.body_number(&place.body);
        index.expect("a checked model names existing bodies")
    }

    /// Attachment of a place to its body.
    pub(crate) fn attachment(&self, bodies: &[(String, BodyTerms)], place: &Place) -> Attachment {
        let index = self.body_of(place);
        let body = &self.bodies[index];
        let point = body.point(&place.at).expect("a checked place is on its body");
        // A shell is attached by its parameters.
        let point = body.shell_place(&place.at).map_or(point, |at| at.parameters());
        let attachment = bodies[index].1.attachment(body.arc_length(&place.at), point);
        if place.offset == [0.0; 3] { attachment } else { attachment.offset(Vector3::from(place.offset)) }
    }

    /// Number of the body, arc length and place of a probe.
    pub(super) fn probed(&self, bodies: &[(String, BodyTerms)], probe: &Probe) -> (usize, f64, Attachment) {
        let index = self.body_of(&probe.on);
        let (s, [y, z]) = (self.bodies[index].arc_length(&probe.on.at), probe.offset);
        let place = self.attachment(bodies, &probe.on);
        let point = match (place.axes(), &bodies[index].1) {
            (Some([_, d, e]), BodyTerms::Flexible(_)) => {
                let own = Marker::combined([(y, d), (z, e)]).into();
                BodyVector::combined([(1.0, &place.point), (1.0, &own)])
            }
            _ => place.point.clone(),
        };
        (index, s, Attachment { point, ..place })
    }
}
