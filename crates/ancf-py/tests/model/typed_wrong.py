"""Models with deliberate errors for a type checker. Read by test_model.py, never run."""

import ancf

steel = ancf.Material("steel", density=7850.0, young=2.1e11)
beam = ancf.Beam(
    "b", from_=(0, 0, 0), to=(1, 0, 0), elements=4, section=ancf.Circle(diameter=0.02), material=steel
)

ancf.Circle(diametre=0.02)  # wrong
ancf.Circle(diameter="wide")  # wrong
ancf.Tube(outer=0.02)  # wrong
ancf.Material("steel", 7850.0, young=2.1e11)  # wrong
ancf.Cable("c", from_=0.0, to=(1, 0, 0), elements=4, section="s", material="m")  # wrong
ancf.Beam("b", from_=(0, 0, 0), to=(1, 0, 0), elements=4, section=steel, material=steel)  # wrong
ancf.Clamp("root", a=beam)  # wrong
ancf.Clamp("root", a=beam.start, fix="some")  # wrong
ancf.Clamp("root", a=beam.start, b="wall")  # wrong
ancf.Force(on=beam.end, force=(0, 0, -1), time="ramp")  # wrong
ancf.Dynamics(duration=1.0, step=1e-3, scheme=ancf.EnergyCriterion())  # wrong
ancf.Model(bodies=[steel], analysis=ancf.Modes())  # wrong
beam.elemnts = 40  # wrong
beam.at((0, 0, 0))  # wrong

ancf.Force(on=beam.at(0.5), force=[0, 0, -1], time=lambda t: t * t)
ancf.Clamp("root", a=beam.start, b=ancf.Ground(point=[0, 0, 0]))
ancf.Distance("rod", a=beam.start, b=beam.end, time=ancf.Ramp(end=1.0))
