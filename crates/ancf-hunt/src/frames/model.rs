//! Models in another frame.

use ancf::Model;
use ancf::model::{
    At, Body, ContactSurface, Coupling, End, FibreAngle, InitialMotion, Joint, JointCoordinate, Load,
    Measure, Place, Shape, ShellThickness, ThicknessField,
};

use super::frame::Frame;

impl Frame {
    /// Model in this frame; `None` if it has no such form, as bushings on oblique axes.
    pub fn model(&self, model: &Model) -> Option<Model> {
        let mut other = model.clone();
        other.gravity = self.polar(model.gravity);
        other.bodies.iter_mut().try_for_each(|body| self.body(body))?;
        for joint in &mut other.joints {
            self.joint(joint)?;
        }
        other.couplings.iter_mut().for_each(|coupling| self.coupling(coupling, model));
        for load in &mut other.loads {
            self.load(load)?;
        }
        for contact in &mut other.contacts {
            match &mut contact.with {
                ContactSurface::Plane(plane) => {
                    plane.point = self.point(plane.point);
                    plane.normal = self.polar(plane.normal);
                    plane.on.iter_mut().for_each(|place| self.place(place));
                }
                ContactSurface::Sphere(sphere) => {
                    sphere.center = self.point(sphere.center);
                    sphere.on.iter_mut().for_each(|place| self.place(place));
                }
                ContactSurface::Cylinder(cylinder) => {
                    cylinder.point = self.point(cylinder.point);
                    cylinder.axis = self.polar(cylinder.axis);
                    cylinder.on.iter_mut().for_each(|place| self.place(place));
                }
                ContactSurface::Bodies => {}
            }
        }
        for probe in &mut other.probes {
            self.place(&mut probe.on);
            // The third direction of a section is the product of the other two.
            probe.offset[1] *= self.sign();
        }
        Some(other)
    }

    fn place(&self, place: &mut Place) {
        if let At::Point(point) = &mut place.at {
            *point = self.point(*point);
        }
        place.offset = self.polar(place.offset);
    }

    fn motion(&self, motion: &mut InitialMotion) {
        motion.velocity = self.polar(motion.velocity);
        motion.spin = self.axial(motion.spin);
        motion.about = motion.about.map(|about| self.point(about));
    }

    /// `None` for a thin shell, whose surface is not transformed.
    fn body(&self, body: &mut Body) -> Option<()> {
        let up = body.up();
        match body {
            Body::Beam(beam) => {
                beam.up = up.map(|up| self.polar(up.into()));
                (beam.from, beam.to) = (self.point(beam.from), self.point(beam.to));
                beam.twist *= self.sign();
                match &mut beam.shape {
                    Shape::Straight => {}
                    Shape::Arc { through } => *through = self.point(*through),
                    Shape::Helix { center, axis, .. } => {
                        (*center, *axis) = (self.point(*center), self.axial(*axis));
                    }
                    Shape::Spline { through } => {
                        through.iter_mut().for_each(|point| *point = self.point(*point));
                    }
                }
                self.motion(&mut beam.motion);
            }
            Body::Cable(cable) => {
                cable.up = up.map(|up| self.polar(up.into()));
                (cable.from, cable.to) = (self.point(cable.from), self.point(cable.to));
                self.motion(&mut cable.motion);
            }
            Body::Rigid(rigid) => {
                let tensor = self.matrix * rigid.tensor() * self.matrix.transpose();
                rigid.inertia = [tensor[(0, 0)], tensor[(1, 1)], tensor[(2, 2)]];
                rigid.products = [tensor[(0, 1)], tensor[(0, 2)], tensor[(1, 2)]];
                rigid.center = self.point(rigid.center);
                self.motion(&mut rigid.motion);
            }
            Body::Mass(mass) => {
                mass.center = self.point(mass.center);
                self.motion(&mut mass.motion);
            }
            Body::ShearShell(shell) => {
                // The stress axis of a shell without an axis depends on the frame.
                // Formulas in x, y and z are not transformed.
                let axis = shell.fibre_axis.as_ref()?.uniform()?;
                shell.fibre_axis = Some(self.polar(axis).into());
                if matches!(shell.thickness, ShellThickness::Varying(ThicknessField::Expression { .. })) {
                    return None;
                }
                if let Some(angle) = &mut shell.fibre_angle {
                    let FibreAngle::Uniform(angle) = angle else { return None };
                    // The normal keeps its side of the shell as a polar vector: the angle about it is reversed.
                    *angle *= self.sign();
                }
                shell.mesh.nodes.iter_mut().for_each(|node| *node = self.point(*node));
                shell.mesh.directors.iter_mut().for_each(|director| *director = self.polar(*director));
                // The normal is on the other side of a reflected element, unless its nodes have the opposite order.
                if self.sign() < 0.0 {
                    shell.mesh.elements.iter_mut().for_each(|element| element.reverse());
                }
                self.motion(&mut shell.motion);
            }
            Body::Shell(_) => return None,
        }
        Some(())
    }

    /// Angles about axial axes and displacements along polar axes keep their values.
    fn joint(&self, joint: &mut Joint) -> Option<()> {
        let mut second = |end: &mut End| match end {
            End::Place(place) => self.place(place),
            End::Point(ground) => ground.point = self.point(ground.point),
            End::Ground => {}
        };
        let first = match joint {
            Joint::Clamp(joint) => (&mut joint.a, Some(&mut joint.b)),
            Joint::Spherical(joint) => (&mut joint.a, Some(&mut joint.b)),
            Joint::Distance(joint) => (&mut joint.a, Some(&mut joint.b)),
            Joint::Slide(joint) => (&mut joint.a, Some(&mut joint.b)),
            Joint::Spring(joint) => (&mut joint.a, Some(&mut joint.b)),
            Joint::Revolute(joint) => {
                joint.axis = self.axial(joint.axis);
                (&mut joint.a, Some(&mut joint.b))
            }
            Joint::Drive(joint) => {
                joint.axis = joint.axis.map(|axis| self.axial(axis));
                joint.displacement = self.polar(joint.displacement);
                (&mut joint.a, None)
            }
            Joint::Universal(joint) => {
                (joint.axis_a, joint.axis_b) = (self.polar(joint.axis_a), self.polar(joint.axis_b));
                (&mut joint.a, Some(&mut joint.b))
            }
            Joint::Cylindrical(joint) => {
                joint.axis = self.axial(joint.axis);
                if let Some(feed) = &mut joint.feed {
                    feed.displacement = feed.displacement.map(|x| x * self.sign());
                    feed.speed = feed.speed.map(|x| x * self.sign());
                }
                (&mut joint.a, Some(&mut joint.b))
            }
            Joint::Prismatic(joint) => {
                joint.axis = self.polar(joint.axis);
                (&mut joint.a, Some(&mut joint.b))
            }
            Joint::Sensor(joint) => {
                let turns = joint.measure == Measure::Angle;
                joint.axis = joint.axis.map(|axis| if turns { self.axial(axis) } else { self.polar(axis) });
                (&mut joint.a, Some(&mut joint.b))
            }
            Joint::Planar(joint) => {
                joint.normal = self.polar(joint.normal);
                (&mut joint.a, Some(&mut joint.b))
            }
            Joint::PointOnLine(joint) => {
                joint.axis = self.polar(joint.axis);
                (&mut joint.a, Some(&mut joint.b))
            }
            Joint::Bushing(_) | Joint::Generic(_) | Joint::MatrixBushing(_) => self.axes_of(joint)?,
            Joint::Support(_) | Joint::Seam(_) | Joint::Bond(_) | Joint::Custom(_) => return None,
        };
        self.place(first.0);
        first.1.into_iter().for_each(&mut second);
        Some(())
    }

    /// Maps the axes of a joint with three of them, and returns its ends.
    fn axes_of<'a>(&self, joint: &'a mut Joint) -> Option<(&'a mut Place, Option<&'a mut End>)> {
        Some(match joint {
            Joint::Bushing(joint) => {
                let axis = joint.twist_axis();
                joint.stiffness = self.six(joint.stiffness)?;
                joint.damping = self.six(joint.damping)?;
                // Of equal stiffnesses, the axis of twist is the first one, which is another axis of the body then.
                let is_same = self.matrix[(joint.twist_axis(), axis)].abs() > 1.0 - 1e-12;
                if !is_same {
                    return None;
                }
                (&mut joint.a, Some(&mut joint.b))
            }
            Joint::Generic(joint) => {
                self.axes(&mut joint.x_axis, &mut joint.y_axis);
                (&mut joint.a, Some(&mut joint.b))
            }
            Joint::MatrixBushing(joint) => {
                // The third axis and rotations change their signs with a reflection.
                if self.sign() < 0.0 {
                    return None;
                }
                self.axes(&mut joint.x_axis, &mut joint.y_axis);
                (&mut joint.a, Some(&mut joint.b))
            }
            _ => return None,
        })
    }

    /// Maps axes that are global x and y by default.
    fn axes(&self, x: &mut Option<[f64; 3]>, y: &mut Option<[f64; 3]>) {
        *x = Some(self.polar(x.unwrap_or([1.0, 0.0, 0.0])));
        *y = Some(self.polar(y.unwrap_or([0.0, 1.0, 0.0])));
    }

    fn six(&self, x: [f64; 6]) -> Option<[f64; 6]> {
        let ([a, b, c], [d, e, f]) = (self.diagonal([x[0], x[1], x[2]])?, self.diagonal([x[3], x[4], x[5]])?);
        Some([a, b, c, d, e, f])
    }

    /// Displacements of cylindrical joints change their sign with a reflection, since their axes are axial.
    fn coupling(&self, coupling: &mut Coupling, model: &Model) {
        for part in &mut coupling.joints {
            let joint = model.joints.iter().find(|joint| joint.name() == part.joint);
            let is_cylindrical = matches!(joint, Some(Joint::Cylindrical(_)));
            if is_cylindrical && part.of == Some(JointCoordinate::Displacement) {
                part.factor *= self.sign();
            }
        }
    }

    fn load(&self, load: &mut Load) -> Option<()> {
        match load {
            Load::Force(load) => {
                self.place(&mut load.on);
                load.force = self.polar(load.force);
            }
            Load::Moment(load) => {
                self.place(&mut load.on);
                load.moment = self.axial(load.moment);
            }
            Load::DistributedForce(load) => {
                load.force = self.line_force(load.force, load.follower);
                load.force_end = load.force_end.map(|force| self.line_force(force, load.follower));
            }
            Load::DistributedMoment(load) => {
                load.moment = self.line_moment(load.moment, load.follower);
                load.moment_end = load.moment_end.map(|moment| self.line_moment(moment, load.follower));
            }
            Load::BaseAcceleration(load) => load.acceleration = self.polar(load.acceleration),
            Load::BaseRotation(load) => {
                load.angular_velocity = self.axial(load.angular_velocity);
                load.point = self.point(load.point);
            }
            Load::Fluid(load) => load.current = self.polar(load.current),
            Load::SurfaceFluid(load) => load.current = self.polar(load.current),
            Load::Prestrain(load) => {
                load.curvature = self.line_moment(load.curvature, true);
                load.curvature_end = load.curvature_end.map(|curvature| self.line_moment(curvature, true));
            }
            Load::SurfacePrestrain(load) => {
                // The nodes of a reflected element have the opposite order: the second direction is reversed, the normal is not.
                for components in [&mut load.strain, &mut load.tension, &mut load.curvature] {
                    components[2] *= self.sign();
                }
                load.axis = load.axis.map(|axis| self.polar(axis));
            }
            Load::SurfaceForce(load) => load.force = self.polar(load.force),
            Load::SurfacePressure(_) => {}
            Load::Gas(load) => load.apex = load.apex.map(|apex| self.point(apex)),
            Load::EdgeForce(_) | Load::EdgeMoment(_) => return None,
            Load::External(_) | Load::Custom(_) => return None,
        }
        Some(())
    }

    /// Force per length, in the frame of the section for followers. The third direction of a section is the product of the other two.
    fn line_force(&self, x: [f64; 3], follower: bool) -> [f64; 3] {
        if follower { [x[0], x[1], x[2] * self.sign()] } else { self.polar(x) }
    }

    /// Moment per length or curvature, in the frame of the section for followers.
    fn line_moment(&self, x: [f64; 3], follower: bool) -> [f64; 3] {
        let s = self.sign();
        if follower { [x[0] * s, x[1] * s, x[2]] } else { self.axial(x) }
    }
}
