#include "io/scene/plane/svg_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/scene/plane/svg_geometry.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"

namespace hottel::svg_reader_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;

std::string svg(const std::string& body) {
  return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:other='urn:other'>\n" + body + "\n</svg>\n";
}

Scene2 scene(const std::string& body) { return parse_svg_2(svg(body), "plan.svg"); }

// "name: x0,y0 x1,y1" for each surface.
std::vector<std::string> lines(const std::string& body) {
  std::vector<std::string> result;
  const Scene2 read = scene(body);
  for (std::size_t s = 0; s < read.surfaces.size(); ++s) {
    const auto& [from, to] = read.edges[s];
    result.push_back(read.surfaces[s].name + ": " + to_string(from.x) + "," + to_string(from.y) + " " +
                     to_string(to.x) + "," + to_string(to.y));
  }
  return result;
}

std::string refusal(const std::string& text) {
  try {
    parse_svg_2(text, "plan.svg");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SvgReader, TurnsTheAxisSoThatUpIsUp) {
  EXPECT_THAT(lines("<line id='a' x1='1' y1='2' x2='3px' y2='.5'/>"), ElementsAre("a: 1,-2 3,-1/2"));
}

TEST(SvgReader, ReadsNumbersAsTheTextSays) {
  EXPECT_THAT(lines("<polyline id='a' points='0.1.2-3e-1+4, 1e2 007'/>"),
              ElementsAre("a[0]: 1/10,-1/5 -3/10,-4", "a[1]: -3/10,-4 100,-7"));
}

TEST(SvgReader, ListsARectAsARoomSeenFromInside) {
  EXPECT_THAT(lines("<rect id='r' x='1' y='2' width='3' height='4'/>"),
              ElementsAre("r[0]: 1,-2 4,-2", "r[1]: 4,-2 4,-6", "r[2]: 4,-6 1,-6", "r[3]: 1,-6 1,-2"));
}

TEST(SvgReader, KeepsTheInsideOfARectThatIsMirrored) {
  const std::string rect = "<rect id='r' x='1' y='2' width='3' height='4'/>";
  EXPECT_THAT(lines("<g transform='scale(-1 1)'>" + rect + "</g>"),
              ElementsAre("r[0]: -1,-2 -1,-6", "r[1]: -1,-6 -4,-6", "r[2]: -4,-6 -4,-2", "r[3]: -4,-2 -1,-2"));
  EXPECT_EQ(lines("<g transform='scale(-1 1)'><g transform='scale(-1 1)'>" + rect + "</g></g>"), lines(rect));
  // Twice the area to the right of the outline, by the formula of the shoelace: positive for a room.
  const auto twice_the_area_inside = [](const std::string& body) {
    Rational sum = 0;
    for (const Edge2& s : scene(body).edges) sum += s.to.x * s.from.y - s.from.x * s.to.y;
    return sum;
  };
  for (const char* transform :
       {"scale(1)", "scale(-1 1)", "scale(1 -1)", "scale(-1)", "matrix(0 1 1 0 0 0)", "rotate(90) scale(1 -1)"}) {
    const std::string group = "<g transform='" + std::string(transform) + "'>";
    EXPECT_EQ(twice_the_area_inside(group + rect + "</g>"), 24) << transform;
    EXPECT_EQ(twice_the_area_inside(group + "<g data-front='left'>" + rect + "</g></g>"), -24) << transform;
  }
}

TEST(SvgReader, TurnsAnElementRoundOnRequest) {
  EXPECT_THAT(lines("<line id='a' data-front='left' x2='1'/>"), ElementsAre("a: 1,0 0,0"));
}

TEST(SvgReader, ReadsEveryStraightPathCommand) {
  EXPECT_THAT(lines("<path id='p' d='m1 1 2 0 L5,5H6h1V7v1l-1-1z'/>"),
              ElementsAre("p[0]: 1,-1 3,-1", "p[1]: 3,-1 5,-5", "p[2]: 5,-5 6,-5", "p[3]: 6,-5 7,-5", "p[4]: 7,-5 7,-7",
                          "p[5]: 7,-7 7,-8", "p[6]: 7,-8 6,-7", "p[7]: 6,-7 1,-1"));
}

TEST(SvgReader, GivesEachPartOfAPathAName) {
  EXPECT_THAT(lines("<path id='p' d='M0 0h1M5 5h1v1zl-1 0'/>"),
              ElementsAre("p.1[0]: 0,0 1,0", "p.2[0]: 5,-5 6,-5", "p.2[1]: 6,-5 6,-6", "p.2[2]: 6,-6 5,-5",
                          "p.3[0]: 5,-5 4,-5"));
}

TEST(SvgReader, ClosesAPathOnceWhenItReturnsToItsStart) {
  EXPECT_EQ(lines("<path d='M0 0 1 0 1 1 0 0 Z'/>"), lines("<path d='M0 0 1 0 1 1 Z'/>"));
  EXPECT_EQ(lines("<polygon points='0 0 1 0 1 1 0 0'/>"), lines("<polygon points='0 0 1 0 1 1'/>"));
}

TEST(SvgReader, AppliesNestedTransformsExactly) {
  EXPECT_THAT(lines("<g transform='translate(10,20) scale(.1)'><g transform='rotate(90)'>"
                    "<line id='a' x1='1' y1='0' x2='0' y2='3' transform='matrix(1 0 0 -1 0 0)'/></g></g>"),
              ElementsAre("a: 10,-201/10 103/10,-20"));
  EXPECT_THAT(lines("<line id='a' x2='2' transform='rotate(-90 1 1)'/>"), ElementsAre("a: 0,-2 0,0"));
}

TEST(SvgReader, PutsEdgesFirstAndCountsEachKindForNames) {
  EXPECT_THAT(lines("<line x2='1'/><polyline points='0 1 1 1'/><line x2='1' y1='2' y2='2'/>"),
              ElementsAre("edge[0]: 0,0 1,0", "edge[1]: 0,-2 1,-2", "polyline[0][0]: 0,-1 1,-1"));
}

TEST(SvgReader, TakesMaterialsFromDataOrClassAndHandsThemDown) {
  const Scene2 s = scene(
      "<g class='oak' data-back='steel'><line id='a' x2='1'/><line id='b' data-material='lamp' y2='1'/></g>"
      "<line id='c' x2='1' y1='5'/>");
  const auto name = [&](std::uint32_t material) { return s.materials[material].name; };
  EXPECT_EQ(name(s.surfaces[0].material), "oak");
  EXPECT_EQ(name(*s.surfaces[0].back), "steel");
  EXPECT_EQ(name(s.surfaces[1].material), "lamp");
  EXPECT_EQ(name(s.surfaces[2].material), "white");
  EXPECT_FALSE(s.surfaces[2].back.has_value());
  EXPECT_EQ(s.materials[0].reflectivity, Spectrum::scalar(Rational(1, 2)));
}

TEST(SvgReader, KnowsTheLineOfEverySurface) {
  EXPECT_EQ(scene("<title>x</title>\n<g>\n<line x2='1'/></g>").surfaces[0].line, 4);
}

TEST(SvgReader, PassesOverPointsThatRepeatTheOneBeforeAndCountsThem) {
  const auto read = [](const std::string& points, const std::string& path, PassedOver* passed_over) {
    return write_scene_2(parse_svg_2(
        "<svg xmlns='http://www.w3.org/2000/svg'><polygon points='" + points + "'/><path d='" + path + "'/></svg>",
        "drawing.svg", passed_over));
  };
  PassedOver none, some;
  EXPECT_EQ(read("0 0 4 0 4 3", "M0 0 1 1 2 0Z", &none),
            read("0 0 4 0 4 0 4 3 0 0 0 0", "M0 0 0 0 1 1 l0 0 L2 0 0 0 0 0Z", &some));
  EXPECT_EQ(none.note(), "");
  EXPECT_EQ(some.note(), "5 repeated points passed over, the first of <polygon> at drawing.svg:1");
}

TEST(SvgReader, PassesOverLinesWithoutLengthUnlessNothingElseIsDrawn_5) {
  PassedOver some;
  const Scene2 drawn = parse_svg_2(
      "<svg xmlns='http://www.w3.org/2000/svg'>\n<line id='dot' x1='1' x2='1'/>\n<line x2='1'/>"
      "<polyline points='1 1 1 1'/></svg>",
      "drawing.svg", &some);
  ASSERT_EQ(drawn.surfaces.size(), 1u);
  EXPECT_EQ(drawn.surfaces[0].name, "edge[1]");
  EXPECT_EQ(some.note(), "2 lines without length passed over, the first <line id='dot'> at drawing.svg:2");
}

TEST(SvgReader, RefusesADrawingOfNothingButPoints_5) {
  for (const char* element :
       {"<path id='p' d='M1 1 1 1 1 1'/>", "<polygon points='1 1 1 1 1 1'/>", "<line x1='1' x2='1'/>"})
    EXPECT_THAT(refusal(svg("\n" + std::string(element))),
                MatchesRegex("plan.svg:3: <.*> has no length: all its points are the same"));
}

TEST(SvgReader, PassesOverWhatIsNeverDrawn) {
  EXPECT_EQ(lines("<title>t</title><defs><circle r='1'/></defs><other:circle/><style>.a{fill:red}</style>"
                  "<line id='a' x2='1' style='stroke:red; display: inline'><title>t</title></line>")
                .size(),
            1u);
}

TEST(SvgReader, WritesASceneThatReadsBack) {
  const Scene2 drawn = scene("<path id='p' d='M0 0H3.3V1.1Z'/><line id='a' class='oak' x2='0.7'/>");
  const Scene2 read = parse_scene_2(write_scene_2(drawn), "plan.json");
  ASSERT_EQ(read.surfaces.size(), drawn.surfaces.size());
  for (std::size_t i = 0; i < read.surfaces.size(); ++i) {
    EXPECT_EQ(read.surfaces[i].name, drawn.surfaces[i].name);
    EXPECT_EQ(read.edges[i].from, drawn.edges[i].from);
    EXPECT_EQ(read.edges[i].to, drawn.edges[i].to);
    EXPECT_EQ(read.groups[read.surfaces[i].group], drawn.groups[drawn.surfaces[i].group]);
  }
}

TEST(SvgReader, RefusesWhatItCannotReadExactlyAtItsLine) {
  const auto expect_refusal = [](const std::string& body, const std::string& text) {
    const std::string message = refusal(svg("<line x2='1'/>\n" + body));
    EXPECT_THAT(message, HasSubstr(text)) << body;
    EXPECT_EQ(message.rfind("plan.svg:3: ", 0), 0u) << message;
  };
  for (const char* element :
       {"circle", "ellipse", "text", "image", "use", "foreignObject", "switch", "svg", "a", "bogus"})
    expect_refusal("<" + std::string(element) + " id='x'/>", "is not made of straight lines");
  expect_refusal("<path d='M0 0 C1 1 2 2 3 3'/>", "the command 'C'");
  expect_refusal("<path d='L1 1'/>", "does not begin with M");
  expect_refusal("<path d='M1 1'/>", "has no lines");
  expect_refusal("<path d='M0 0 L1'/>", "no number where one is due");
  expect_refusal("<path d='M0 0 1 1 ,'/>", "no number where one is due");
  expect_refusal("<polyline points='0 0 1'/>", "no number where one is due");
  expect_refusal("<polyline points='0 0'/>", "fewer than two points");
  expect_refusal("<line x2='1cm'/>", "has the unit 'cm'");
  expect_refusal("<line x2='50%'/>", "has the unit '%'");
  expect_refusal("<line x2='nan'/>", "no number");
  expect_refusal("<line x2='1e99999'/>", "too long");
  expect_refusal("<rect width='1' height='0'/>", "no positive width and height");
  expect_refusal("<rect width='1' height='1' rx='.1'/>", "rounded corners");
  expect_refusal("<line x2='1' transform='rotate(45)'/>", "only multiples of 90 are exact");
  expect_refusal("<line x2='1' transform='skewX(5)'/>", "only translate, scale, matrix and rotate");
  expect_refusal("<line x2='1' transform='scale(0)'/>", "flattens");
  expect_refusal("<line x2='1' transform='translate(1'/>", "no number");
  expect_refusal("<line x2='1' transform='scale()'/>", "wrong number of arguments");
  expect_refusal("<line x2='1' display='none'/>", "display 'none'");
  expect_refusal("<g style='fill:none;display:none'><line x2='1'/></g>", "display 'none'");
  expect_refusal("<g clip-path='url(#c)'><line x2='1'/></g>", "clip-path");
  expect_refusal("<style>line { transform: scale(2) }</style>", "for 'line' has transform 'scale(2)'");
  expect_refusal("<line x2='1'><animate/></line>", "cannot be read here");
  expect_refusal("<line id='sky' x2='1'/>", "the id is kept for the sky");
  expect_refusal("<line x2='1' x2='2'/>", "twice");
  expect_refusal("<line x2='1' data-front='up'/>", "neither 'left' nor 'right'");
}

TEST(SvgReader, NamesWhatItCannotReadWithItsContainer) {
  const auto message = [](const std::string& body) { return refusal(svg(body)); };
  EXPECT_THAT(message("<text/>"), HasSubstr("plan.svg:2: <text> is not"));
  EXPECT_THAT(message("<g><text/></g>"), HasSubstr("<text> in <g> is not"));
  EXPECT_THAT(message("<g id='labels'><text id='t'/></g>"), HasSubstr("<text id='t'> in <g id='labels'> is not"));
  EXPECT_THAT(message("<g id='labels'><g><text/></g></g>"), HasSubstr("<text> in <g id='labels'> is not"));
  EXPECT_THAT(message("<line id='a' x2='1'><set/></line>"), HasSubstr("<set> in <line id='a'> cannot be read here"));
}

// Each property of CSS that hides, moves or resizes, in a style attribute and in a style sheet.
TEST(SvgReader, RefusesStylesThatHideMoveOrResize) {
  for (const char* declaration : {"display: none",
                                  "visibility:hidden",
                                  "clip-path: circle()",
                                  "mask: url(#m)",
                                  "filter: url('#f')",
                                  "transform: none",
                                  "-webkit-transform: scale(2)",
                                  "TRANSLATE: 1px",
                                  "rotate: 45deg",
                                  "scale: 2",
                                  "zoom: 2",
                                  "offset-path: path('M0 0')",
                                  "offset: none",
                                  "width: 3px",
                                  "height: 3px",
                                  "x: 1",
                                  "y: 1",
                                  "cx: 1",
                                  "cy: 1",
                                  "r: 1",
                                  "rx: 1",
                                  "ry: 1",
                                  "d: path('M0 0L1 1')",
                                  "all: unset",
                                  "vector-effect: fixed-position",
                                  "wi\\64 th: 3px"}) {
    const std::string text = declaration;
    const std::string line = "<line id='a' x2='1' style=\"stroke: red; /* ; */ " + text + "\"/>";
    EXPECT_THAT(refusal(svg(line)), HasSubstr("plan.svg:2: <line id='a'> has ")) << text;
    const std::string rules = "/* } */\n@media screen { g { fill: url(a;b) } line.a {\n" + text + " !important} }";
    for (const std::string& sheet : {"<style>" + rules + "</style>", "<defs><style>" + rules + "</style></defs>",
                                     "<style><![CDATA[" + rules + "]]></style>"})
      EXPECT_THAT(refusal(svg(sheet + "<line x2='1'/>")), MatchesRegex("plan.svg:4: <style>.* has .*")) << sheet;
  }
}

TEST(SvgReader, PassesOverStylesThatPaint) {
  EXPECT_EQ(lines("<style type='text/css'>@charset 'x'; .clip, #width { stroke-width: 3; font: 3px 'x: 1'; "
                  "background: url(data:a;x: 1) } .m { display: inline; scale: none; mask: none !important }</style>"
                  "<line id='a' x2='1' style='stroke-width: 3; zoom: 1; marker-end: none' r='3'/>"),
            lines("<line id='a' x2='1'/>"));
  EXPECT_EQ(parse_svg_2("<svg style='width: 100%; height: auto'><line x2='1'/></svg>", "plan.svg")->surfaces.size(),
            1u);
}

TEST(SvgReader, RefusesWhatChangesADrawingFromOutside) {
  EXPECT_THAT(refusal("<?xml version='1.0'?>\n<?xml-stylesheet href='a.css'?><svg><line x2='1'/></svg>"),
              HasSubstr("plan.svg:2: refers to another style sheet"));
  EXPECT_THAT(refusal(svg("<style>\n@import 'a.css';</style>")), HasSubstr("plan.svg:3: <style> imports another"));
  EXPECT_THAT(refusal(svg("<defs><script/></defs>")), HasSubstr("<script> in <defs> may change the drawing"));
  EXPECT_THAT(refusal(svg("<link xmlns='http://www.w3.org/1999/xhtml'/>")), HasSubstr("<link> may change"));
}

TEST(SvgReader, RefusesDataKeysItDoesNotKnowAndListsThoseItDoes) {
  EXPECT_THAT(refusal(svg("<g data-colour='red'><line x2='1'/></g>")),
              HasSubstr("plan.svg:2: <g> has 'data-colour': of such keys only data-material, data-back, data-front and "
                        "data-on are known"));
  EXPECT_THAT(refusal("<svg data-name='x'><line x2='1'/></svg>"), HasSubstr("<svg> has 'data-name'"));
}

TEST(SvgReader, DataOnMakesPatchesAlsoOfAGroup) {
  const Scene2 scene = parse_svg_2(
      svg("<g data-on='hall'><line id='w' x1='0' y1='2' x2='0' y2='1'/><path id='p' d='M1,0 h1 M3,0 h1'/></g>"
          "<line id='back' x1='0' y1='1' x2='0' y2='2' data-on='hall:back'/>"
          "<polygon id='hall' points='0,0 4,0 4,3 0,3'/>"),
      "plan.svg");
  EXPECT_TRUE(scene.bases == (std::vector<PatchBase>{{"hall", false}, {"hall", true}}));
  for (const char* name : {"w", "p.1[0]", "p.2[0]"}) EXPECT_EQ(scene.surfaces[*scene.find(name)].on, 0u) << name;
  EXPECT_EQ(scene.surfaces[*scene.find("back")].on, 1u);
  EXPECT_FALSE(scene.surfaces[*scene.find("hall[0]")].on);
}

TEST(SvgReader, RefusesEntitiesThatAreUsed) {
  const std::string hall = "<!DOCTYPE svg [<!ENTITY h \"hall\"> <!-- ' -->]>\n";
  EXPECT_EQ(refusal(hall + "<svg>\n<line id='&h;' x2='1'/></svg>"),
            "plan.svg:3: uses the entity &h;, which is not resolved: write out what it stands for");
  EXPECT_EQ(refusal(hall + "<svg><!-- &h; --><title><![CDATA[&h;]]></title><line id='a' x2='1'/></svg>"), "");
  EXPECT_EQ(lines("<line id='&lt;&amp;h;&#65;&#x42;' x2='1'/>"), std::vector<std::string>{"<&h;AB: 0,0 1,0"});
  EXPECT_THAT(refusal(svg("<title>a & b</title><line x2='1'/>")), HasSubstr("plan.svg:2: has an & that begins"));
  EXPECT_THAT(refusal(svg("<title>&#xg;</title><line x2='1'/>")), HasSubstr("the entity &#xg;"));
  EXPECT_THAT(refusal("<!DOCTYPE svg [\n<!ATTLIST line x2 CDATA '1'>]><svg><line/></svg>"),
              HasSubstr("plan.svg:2: declares a list of attributes"));
  EXPECT_THAT(refusal("<!DOCTYPE svg [<!ENTITY % p \"\">%p;]><svg><line x2='1'/></svg>"),
              HasSubstr("declares a parameter entity"));
  EXPECT_EQ(refusal("<!DOCTYPE svg PUBLIC '-//W3C//DTD SVG 1.1//EN' 'svg11.dtd'><svg><line x2='1'/></svg>"), "");
}

TEST(SvgReader, RefusesFilesThatAreNoDrawing) {
  EXPECT_THAT(refusal(""), HasSubstr("not well-formed XML"));
  EXPECT_THAT(refusal("<svg>\n<g>"), HasSubstr("not well-formed XML"));
  EXPECT_THAT(refusal("<html/>"), HasSubstr("outermost element is not <svg>"));
  EXPECT_THAT(refusal("<svg xmlns='urn:other'/>"), HasSubstr("outermost element is not <svg>"));
  EXPECT_THAT(refusal("<svg/><svg/>"), HasSubstr("second outermost element"));
  EXPECT_THAT(refusal(svg("")), HasSubstr("has no lines"));
  EXPECT_THAT(refusal(std::string("<svg>\0</svg>", 12)), HasSubstr("NUL"));
  EXPECT_THAT(refusal(svg("<line id='a' x2='1'/><line id='a' y2='1'/>")), HasSubstr("two surfaces have the name 'a'"));
  std::string deep = "<svg>";
  for (int i = 0; i < 100000; ++i) deep += "<g>";
  for (int i = 0; i < 100000; ++i) deep += "</g>";
  EXPECT_THAT(refusal(deep + "</svg>"), HasSubstr("nested too deeply"));
}

}  // namespace
}  // namespace hottel::svg_reader_test
