// What docstrings of classes show: examples as one types them, in the root of the repository. The tests run all of
// them.
#include <string>

#include "python/bindings/bindings.h"

namespace hottel::python {
namespace {

struct Example {
  const char* name;
  const char* lines;
};

constexpr Example kExamples[] = {
    {"InputError", R"py(
>>> hottel.Scene({"dimension": 2, "edges": [{"name": "a", "points": [[0, 0], [0, 0]]}]})
Traceback (most recent call last):
    ...
hottel.InputError: edge 'a' has no "material")py"},
    {"RequestError", R"py(
>>> hottel.Simulation(hottel.read_scene("scenes/showcase/museum.json")).script_f()
Traceback (most recent call last):
    ...
hottel.RequestError: 'marble', the material of 'reveal_1[0]', is not gray: choose channel r, g or b)py"},
    {"UsageError", R"py(
>>> hottel.generate("house")
Traceback (most recent call last):
    ...
hottel.UsageError: there is no kind of scene called 'house'; the kinds are room, clutter, lattice, maze, comb, star, pillars, plates, room-boxes, room-stacked, room-touching, room-floating, room-turned, room-piercing, street-blocks, town, terrain, nested-cubes, triangle-soup, furnished-room, flat, lattice-boxes)py"},
    {"Scene", R"py(
>>> scene = hottel.Scene({"dimension": 2, "materials": {"grey": {"reflectivity": 0.5}}, "edges": [
...     {"name": "floor", "material": "grey", "points": [[2, 0], [0, 0]]}]})
>>> scene.moved("floor", [0, "1/3"]).points("floor").round(3).tolist()
[[2.0, 0.333], [0.0, 0.333]]
>>> scene.replace(materials={"grey": {"reflectivity": 0.1}}) == scene
False)py"},
    {"Simulation", R"py(
>>> strips = hottel.Simulation(hottel.read_scene("scenes/analytic/strip_obstructed.json"))
>>> strips.factors["bottom", "top"]["factor"]
0.11803398874989485
>>> strips.radiosity.guarantee
'enclosed'
>>> strips.light([[0, 0.5]]).shape
(1, 1))py"},
    {"Factors", R"py(
>>> strips = hottel.Simulation(hottel.read_scene("scenes/analytic/strip_obstructed.json"))
>>> factors = strips.factors
>>> factors
<hottel.Factors of 6 faces and the sky, 10 that are not 0, exact>
>>> factors.names
('bottom', 'bottom:back', 'top', 'top:back', 'obstruction', 'obstruction:back', 'sky')
>>> factors.to_names("bottom")
('top', 'obstruction', 'sky')
>>> begins, columns, values = factors.arrays()
>>> bool(values.sum() == factors.to_scipy().sum())
True)py"},
    {"RootSum", R"py(
>>> strips = hottel.Simulation(hottel.read_scene("scenes/analytic/strip_obstructed.json"))
>>> exact = strips.exact("bottom", "top")
>>> print(exact)
-2 + 1*sqrt(5)
>>> float(exact), (exact - exact).sign()
(0.2360679774997897, 0))py"},
    {"Radiosity", R"py(
>>> cube = hottel.Simulation(hottel.read_scene("scenes/space/cube.json"))
>>> b = cube.radiosity
>>> b.radiosity.shape == (len(b.names), len(b.channels))
True
>>> bool((b.lower <= b.radiosity).all() and (b.radiosity <= b.upper).all())
True)py"},
    {"Temperatures", R"py(
>>> street = hottel.Simulation(hottel.read_scene("scenes/heat/street_canyon.json"))
>>> warm = street.temperatures
>>> warm.names[0], warm["road#0"]["temperature"].round(2).tolist()
('road#0', [293.0]))py"},
    {"NetFlux", R"py(
>>> street = hottel.Simulation(hottel.read_scene("scenes/heat/street_canyon.json"))
>>> [round(watts, 3) for watts in street.flux["sky"]["net"]]
[-1776.766])py"},
    {"Visible", R"py(
>>> strips = hottel.Simulation(hottel.read_scene("scenes/analytic/strip_obstructed.json"))
>>> seen = strips.visible([[0, 0.5]])
>>> len(seen), seen.names
(1, ('sky', 'obstruction', 'bottom'))
>>> seen[0].shape, len(seen.sides(0))
((4, 2), 4))py"},
    {"VisibleMap", R"py(
>>> cube = hottel.Simulation(hottel.read_scene("scenes/space/cube.json"))
>>> seen = cube.visible([[0.5, 0.5, 0.5]])
>>> sorted({round(share, 9) for share in seen[0].values()})
[0.0, 0.166666667]
>>> name, directions, points = seen.pieces(0)[0]
>>> directions.shape == points.shape
True)py"},
    {"VisibilityGraph", R"py(
>>> strips = hottel.Simulation(hottel.read_scene("scenes/analytic/strip_obstructed.json"))
>>> graph = strips.visibility_graph()
>>> graph
<hottel.VisibilityGraph of 6 vertices, 13 pairs>
>>> graph.pairs.shape, graph.lengths.shape
((13, 2), (13,)))py"},
    {"CriticalPoints", R"py(
>>> strips = hottel.Simulation(hottel.read_scene("scenes/analytic/strip_obstructed.json"))
>>> points = strips.critical_points("bottom", "top")
>>> points.exact_t
(Fraction(1, 2), Fraction(1, 2))
>>> points.points.tolist(), points.is_jump.tolist()
([[0.0, 0.0], [0.0, 0.0]], [False, False]))py"},
    {"CriticalLines", R"py(
>>> strips = hottel.Simulation(hottel.read_scene("scenes/analytic/strip_obstructed.json"))
>>> lines = strips.critical_lines()
>>> len(lines), lines.along[0]
(13, 'bottom')
>>> lines.met[0]
('sky', 'sky', 'sky', 'sky'))py"},
    {"FaceSight", R"py(
>>> cube = hottel.Simulation(hottel.read_scene("scenes/space/cube.json"))
>>> sight = cube.faces_seen_by("floor")
>>> len(sight), sight.is_whole.all()
(5, True))py"},
    {"EventSurfaces", R"py(
>>> boxes = hottel.Simulation(hottel.read_scene("scenes/space/two_boxes.json"))
>>> events = boxes.event_surfaces("lamp", "low.top")
>>> events.rulings.shape == (events.begin[-1], 2, 3)
True)py"},
    {"Grid", R"py(
>>> strips = hottel.Simulation(hottel.read_scene("scenes/analytic/strip_obstructed.json"))
>>> grid = strips.grid((8, 4))
>>> grid.values.shape, grid.centres.shape
((4, 8, 1), (4, 8, 2)))py"},
    {"OrientedLight", R"py(
>>> strips = hottel.Simulation(hottel.read_scene("scenes/analytic/strip_obstructed.json"))
>>> up = strips.light_on([[0, 0.5]], normals=[0, 1])
>>> up.sky_view_factor.shape, up.irradiance.shape
((1,), (1, 1)))py"},
    {"PlannedEffect", R"py(
>>> strips = hottel.Simulation(hottel.read_scene("scenes/analytic/strip_obstructed.json"))
>>> [effect.effect for effect in strips.plan if effect.used][:2]
['occlusion', 'back faces'])py"},
    {"Finding", R"py(
>>> maze = hottel.read_scene("scenes/showcase/maze.json")
>>> sorted({finding.severity for finding in maze.check()})
['note'])py"},
    {"Repair", R"py(
>>> maze = hottel.read_scene("scenes/showcase/maze.json")
>>> repair = maze.fixed(within="1e-6")
>>> repair.scene == maze, len(repair.steps)
(True, 0))py"},
    {"RepairStep", R"py(
>>> builder = hottel.SceneBuilder(2).add_material("m")
>>> gap = builder.add_polyline("wall", [[0, 0], [1, 0], [1, "1e-9"], [1, 1]], "m").build()
>>> [step.kind for step in gap.fixed(within="1e-6").steps]
['merged', 'dropped', 'renumbered'])py"},
    {"Judgement", R"py(
>>> strips = hottel.Simulation(hottel.read_scene("scenes/analytic/strip_obstructed.json"))
>>> judged = strips.compare("gauss:4")
>>> judged.max_error < 0.1, len(judged.worst) > 0
(True, True))py"},
    {"JudgedPair", R"py(
>>> strips = hottel.Simulation(hottel.read_scene("scenes/analytic/strip_obstructed.json"))
>>> worst = strips.compare("gauss:4").worst[0]
>>> worst.from_name in strips.factors.names
True)py"},
    {"Verdict", R"py(
>>> strips = hottel.Simulation(hottel.read_scene("scenes/analytic/strip_obstructed.json"))
>>> verdict = strips.compare(strips.factors.factors / 2).verdict
>>> verdict.off == verdict.pairs, len(verdict.sentences) > 0
(True, True))py"},
    {"Fault", R"py(
>>> strips = hottel.Simulation(hottel.read_scene("scenes/analytic/strip_obstructed.json"))
>>> strips.compare(strips.factors.factors / 2).verdict.findings[0].kind
'constant-factor')py"},
    {"RadiosityJudgement", R"py(
>>> strips = hottel.Simulation(hottel.read_scene("scenes/analytic/strip_obstructed.json"))
>>> strips.compare_radiosities(strips.radiosity.radiosity).outside
0)py"},
    {"GridJudgement", R"py(
>>> strips = hottel.Simulation(hottel.read_scene("scenes/analytic/strip_obstructed.json"))
>>> strips.compare_grid(strips.grid().values).off.tolist()
[0])py"},
    {"Frames", R"py(
>>> lighthouse = hottel.Simulation(hottel.read_scene("scenes/lights/lighthouse.json"))
>>> [frame.seconds for frame in lighthouse.frames(3, fps=2)]
[0.0, 0.5, 1.0])py"},
    {"Frame", R"py(
>>> lighthouse = hottel.Simulation(hottel.read_scene("scenes/lights/lighthouse.json"))
>>> frame = next(lighthouse.frames(1))
>>> frame.index, frame.simulation.scene.names == lighthouse.scene.names
(0, True))py"},
    {"Picture", R"py(
>>> strips = hottel.Simulation(hottel.read_scene("scenes/analytic/strip_obstructed.json"))
>>> picture = strips.picture(size=400)
>>> picture.pixels.dtype, picture.pixels.shape[1:]
(dtype('uint8'), (512, 3))
>>> picture.file("png")[:4]
b'\x89PNG')py"},
};

}  // namespace

void add_examples(py::module_& module) {
  for (const Example& example : kExamples) {
    const py::object type = module.attr(example.name);
    type.attr("__doc__") = py::str(type.attr("__doc__")) + py::str("\n") + py::str(example.lines) + py::str("\n");
  }
}

}  // namespace hottel::python
