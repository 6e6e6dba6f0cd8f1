// Scenes of the examples: what their pictures show is what the answers say.
#include "poinsot/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "example_files.h"
#include "poinsot/problem.h"
#include "poinsot/rendering.h"

namespace poinsot {
namespace scene_test {

namespace fs = std::filesystem;
using scene::Arrow;
using scene::Diagram;
using scene::DiagramKind;
using scene::Quantity;
using scene::Scene;
using Vector = Vector3<double>;

struct Case {
  std::string name;
  Document document;
};

// But for what takes very long.
const std::vector<Case>& cases() {
  static const std::vector<Case> all = [] {
    std::vector<Case> list;
    for (const char* folder : {"textbook", "published"})
      for (const fs::path& file : testing::example_files(folder)) {
        constexpr std::chrono::milliseconds most(15000);
        const Problem problem = Problem::from_file(file.string());
        Document document = problem.illustrate({}, Budget().end_after(most));
        if (!document.ended) list.push_back({file.filename().string(), std::move(document)});
      }
    return list;
  }();
  return all;
}

template <class Look>
void for_each_scene(const Look& look) {
  for (const Case& one : cases())
    for (const Solution& solution : one.document.solutions) {
      ASSERT_TRUE(solution.scene) << one.name;
      SCOPED_TRACE(one.name);
      look(one, solution, *solution.scene);
    }
}

Vector on_ground(const Scene& scene, const scene::Place& place) {
  if (place.body == scene::ground) return place.at;
  const scene::Pose& pose = scene.bodies.at(static_cast<std::size_t>(place.body)).pose;
  return pose.R * place.at + pose.p;
}

bool has_point(Quantity quantity) {
  return quantity == Quantity::force || quantity == Quantity::weight || quantity == Quantity::impulse ||
         quantity == Quantity::linear_momentum || quantity == Quantity::rate_of_momentum;
}

std::string all_notes(const Scene& scene) {
  std::string text;
  for (const std::string& note : scene.notes) text += note + "\n";
  return text;
}

Document illustrated(const std::string& text) { return Problem::from_text(text, "test.yaml").illustrate(); }

const Scene& only_scene(const Document& document) { return *document.solutions.at(0).scene; }

const Diagram& diagram_of(const Scene& scene, DiagramKind kind) {
  for (const Diagram& diagram : scene.diagrams)
    if (diagram.kind == kind) return diagram;
  throw std::out_of_range("no such diagram");
}

void expect_whole_scenes() {
  int scenes = 0, without_bodies = 0;
  for_each_scene([&](const Case&, const Solution&, const Scene& scene) {
    ++scenes;
    if (scene.bodies.empty()) {
      ++without_bodies;
      EXPECT_NE(all_notes(scene), "");
      return;
    }
    ASSERT_FALSE(scene.diagrams.empty());
    EXPECT_EQ(scene.diagrams.front().kind, DiagramKind::model);
    EXPECT_NEAR(norm(scene.up), 1, 1e-12);
    EXPECT_GT(scene.length, 0);
    const int count = static_cast<int>(scene.bodies.size());
    const auto known = [&](int body) { return body >= scene::ground && body < count; };
    for (const scene::Body& body : scene.bodies) {
      EXPECT_NEAR(determinant(body.pose.R), 1, 1e-9);
      for (const scene::Shape& shape : body.shapes) {
        EXPECT_EQ(shape.normals.size(), shape.triangles.size());
        for (const auto& triangle : shape.triangles)
          for (const std::uint32_t k : triangle) ASSERT_LT(k, shape.vertices.size());
        for (const auto& edge : shape.edges)
          for (const std::uint32_t k : edge) ASSERT_LT(k, shape.vertices.size());
      }
    }
    for (const scene::Symbol& symbol : scene.symbols)
      EXPECT_TRUE(known(symbol.from) && known(symbol.to) && known(symbol.place.body));
    for (const Diagram& diagram : scene.diagrams)
      for (const Arrow& arrow : diagram.arrows) {
        EXPECT_TRUE(known(arrow.body) && known(arrow.at.body));
        EXPECT_GT(norm(arrow.vector), 0);
        EXPECT_TRUE(std::isfinite(norm(arrow.vector)));
        EXPECT_FALSE(arrow.symbol.empty());
        EXPECT_FALSE(arrow.text.empty());
      }
  });
  EXPECT_GT(scenes, testing::at_least(190));
  EXPECT_LE(without_bodies, 2);
}

// Sum of forces and of moments about the ground's origin, of each group of diagrams.
void expect_that_what_acts_equals_what_it_does_to_the_momenta() {
  int balances = 0, blows = 0;
  for_each_scene([&](const Case& one, const Solution&, const Scene& scene) {
    // Squares that are neglected are missing on one side; what is not determined is not drawn.
    static const std::set<std::string> neglecting{"18.084.yaml", "18.118.yaml"};
    if (neglecting.contains(one.name) || all_notes(scene).find("leave open") != std::string::npos) return;
    std::map<int, std::vector<const Diagram*>> groups;
    for (const Diagram& diagram : scene.diagrams)
      if (diagram.group > 0) groups[diagram.group].push_back(&diagram);
    for (const auto& [number, diagrams] : groups) {
      Vector force{}, moment{};
      double force_size = 1e-12, moment_size = 1e-12;
      for (const Diagram* diagram : diagrams) {
        const bool right = diagram->kind == DiagramKind::kinetic || diagram->kind == DiagramKind::momenta_after;
        for (const Arrow& arrow : diagram->arrows) {
          const Vector vector = (right ? -1.0 : 1.0) * arrow.vector;
          const Vector turning = has_point(arrow.quantity) ? Vector(cross(on_ground(scene, arrow.at), vector)) : vector;
          if (has_point(arrow.quantity)) force += vector;
          moment += turning;
          if (has_point(arrow.quantity)) force_size = std::max(force_size, norm(vector));
          moment_size = std::max(moment_size, norm(turning));
        }
      }
      EXPECT_LE(norm(force), 1e-7 * force_size) << diagrams.front()->title;
      EXPECT_LE(norm(moment), 1e-7 * std::max(moment_size, 1e-3 * scene.length * force_size))
          << diagrams.front()->title;
      ++(diagrams.size() == 3 ? blows : balances);
    }
  });
  EXPECT_GT(balances, testing::at_least(80));
  EXPECT_GT(blows, testing::at_least(20));
}

std::vector<double> numbers(const Datum& datum) {
  std::vector<double> list;
  if (const auto* items = std::get_if<std::vector<Datum>>(&datum.content))
    for (const Datum& item : *items)
      if (const auto* number = std::get_if<double>(&item.content)) list.push_back(*number);
  return list;
}

void expect_arrows_of_answers_to_be_the_answers() {
  int compared = 0;
  for_each_scene([&](const Case&, const Solution& solution, const Scene& scene) {
    for (const Diagram& diagram : scene.diagrams) {
      if (diagram.kind != DiagramKind::answers) continue;
      for (const Arrow& arrow : diagram.arrows)
        for (const Answer& answer : solution.answers) {
          if (answer.name != arrow.name || answer.state != AnswerState::found) continue;
          const std::vector<double> si = numbers(answer.si), shown = numbers(answer.value);
          ASSERT_EQ(si.size(), 3U);
          // Components on other axes than the ground's have the same size.
          EXPECT_NEAR(norm(arrow.vector), std::hypot(si[0], si[1], si[2]), 1e-9 * norm(arrow.vector)) << answer.name;
          if (answer.words.find("on the axes of") == std::string::npos &&
              answer.component_names == std::vector<std::string>(scene.axes.begin(), scene.axes.end())) {
            EXPECT_LE(norm(Vector(arrow.vector - Vector{si[0], si[1], si[2]})), 1e-9 * norm(arrow.vector));
            ++compared;
          }
          EXPECT_EQ(arrow.unit, answer.unit);
          EXPECT_NEAR(arrow.value, std::hypot(shown[0], shown[1], shown[2]), 1e-9 * std::abs(arrow.value));
        }
    }
  });
  EXPECT_GT(compared, testing::at_least(60));
}

void expect_motions_through_the_shown_positions_with_rigid_bodies() {
  int motions = 0;
  for_each_scene([&](const Case&, const Solution&, const Scene& scene) {
    if (!scene.motion) return;
    ++motions;
    const scene::Motion& motion = *scene.motion;
    ASSERT_GE(motion.times.size(), 2U);
    ASSERT_EQ(motion.poses.size(), motion.times.size());
    for (std::size_t k = 0; k + 1 < motion.times.size(); ++k) EXPECT_LT(motion.times[k], motion.times[k + 1]);
    EXPECT_EQ(motion.times.front(), 0);
    for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
      EXPECT_LE(norm(Vector(motion.poses[0][body].p - scene.bodies[body].pose.p)), 1e-9 * (1 + scene.length));
      for (const auto& poses : motion.poses) EXPECT_NEAR(determinant(poses[body].R), 1, 1e-6);
    }
    for (const scene::Plot& plot : motion.plots) {
      EXPECT_EQ(plot.labels.size(), plot.values.size());
      for (const auto& line : plot.values) EXPECT_EQ(line.size(), motion.times.size());
    }
  });
  EXPECT_GT(motions, testing::at_least(20));
}

// One test, so that the examples are solved once.
TEST(Scene, of_every_example) {
  expect_whole_scenes();
  expect_that_what_acts_equals_what_it_does_to_the_momenta();
  expect_arrows_of_answers_to_be_the_answers();
  expect_motions_through_the_shown_positions_with_rigid_bodies();
}

TEST(Scene, a_coordinate_that_is_asked_for_is_plotted_once) {
  const Document document = illustrated(R"(
given: {m: 2 kg, L: 1 m}
points: {O: [0, 0, 0], A: [L, 0, 0]}
bodies: {rod: {rod: [O, A], mass: m}}
joints: {pin: {revolute: z, at: O, to: rod, angle: q}}
gravity: -y
instants: {start: {q: 0 deg, q': 0}}
ask: {there: q @ 0.2 s}
)");
  const auto& plots = document.solutions.at(0).scene->motion->plots;
  ASSERT_EQ(plots.size(), 1U);
  EXPECT_EQ(plots[0].name, "there");
}

TEST(Scene, what_is_asked_at_several_times_is_plotted_once) {
  const Document document = illustrated(R"(
given: {m: 2 kg}
points: {O: [0, 0, 0]}
bodies: {ball: {particle: O, mass: m}}
gravity: -y
instants: {start: rest}
ask: {v1: velocity(ball).y @ 1 s, v2: velocity(ball).y @ 2 s, y2: center(ball).y @ 2 s, T: kinetic_energy(ball) @ 2 s}
)");
  const auto& plots = document.solutions.at(0).scene->motion->plots;
  ASSERT_EQ(plots.size(), 3U);
  EXPECT_EQ(plots[2].unit, "J");
  EXPECT_EQ(plots[0].name, "v1");
  EXPECT_EQ(plots[1].name, "y2");
  EXPECT_NEAR(plots[0].values[0].back(), -2 * 9.80665, 1e-9);
}

TEST(Scene, poses_at_a_time_are_those_of_the_answers) {
  const Document document = illustrated(R"(
given: {m: 2 kg, L: 0.5 m}
points: {O: [0, 0, 0], E: [0, -L, 0]}
bodies: {bar: {rod: [O, E], mass: m}}
joints: {pin: {revolute: z, at: O, to: bar, angle: theta}}
gravity: -y
instants: {start: {theta: 60 deg, theta': 0}}
ask:
  E: position(E of bar) @ 0.35 s
  theta: theta @ 0.35 s
)");
  const Scene& scene = only_scene(document);
  ASSERT_TRUE(scene.motion);
  std::size_t found = 0;
  for (std::size_t k = 0; k < scene.motion->times.size(); ++k) {
    if (scene.motion->times[k] != 0.35) continue;
    ++found;
    const scene::Pose& pose = scene.motion->poses[k][0];
    const std::vector<double> E = numbers(document.solutions[0].answers[0].si);
    EXPECT_LE(norm(Vector(pose.R * Vector{0, -0.5, 0} + pose.p - Vector{E[0], E[1], E[2]})), 1e-9);
    const double theta = std::get<double>(document.solutions[0].answers[1].si.content);
    EXPECT_NEAR(std::atan2(pose.R(1, 0), pose.R(0, 0)), theta, 1e-9);
  }
  EXPECT_EQ(found, 1U);
  // At the start the bar is where the statement says.
  const scene::Pose& start = scene.bodies.at(0).pose;
  EXPECT_NEAR(std::atan2(start.R(1, 0), start.R(0, 0)), std::numbers::pi / 3, 1e-12);
}

// The same machine, drawn on axes that are turned: every place and every arrow turns with it.
TEST(Scene, turns_with_the_statement) {
  const auto text = [](const char* shaft, const char* A, const char* G, const char* B, const char* across) {
    return std::string("given: {m: 8 kg, r: 150 mm, b: 20 deg, n: 1200 rpm, L: 500 mm}\npoints: {A: ") + A +
           ", G: " + G + ", B: " + B + "}\ndirections: {across: " + across +
           "}\nbodies:\n  disk: {disk: {center: G, normal: across, radius: r}, mass: m}\njoints:\n"
           "  shaft: {revolute: A->B, at: A, to: disk, rate: n, accel: 0, supports: {A: " +
           shaft + "}}\ngravity: none\nask: {H: angular_momentum(disk about G), A: reaction(A), B: reaction(B)}\n";
  };
  const Document drawn =
      illustrated(text("[x, y, z], B: [y, z]", "[-L/2, 0, 0]", "[0, 0, 0]", "[L/2, 0, 0]", "[cos(b), sin(b), 0]"));
  const Document turned =
      illustrated(text("[x, y, z], B: [x, z]", "[0, -L/2, 0]", "[0, 0, 0]", "[0, L/2, 0]", "[-sin(b), cos(b), 0]"));
  const auto turn = [](const Vector& v) { return Vector{-v.y, v.x, v.z}; };
  const Scene &one = only_scene(drawn), &other = only_scene(turned);
  ASSERT_EQ(one.diagrams.size(), other.diagrams.size());
  std::size_t arrows = 0;
  for (const DiagramKind kind : {DiagramKind::model, DiagramKind::kinetic, DiagramKind::answers}) {
    const Diagram &a = diagram_of(one, kind), &b = diagram_of(other, kind);
    ASSERT_EQ(a.arrows.size(), b.arrows.size());
    for (std::size_t k = 0; k < a.arrows.size(); ++k) {
      EXPECT_LE(norm(Vector(turn(a.arrows[k].vector) - b.arrows[k].vector)), 1e-9 * norm(a.arrows[k].vector));
      EXPECT_LE(norm(Vector(turn(on_ground(one, a.arrows[k].at)) - on_ground(other, b.arrows[k].at))), 1e-12);
      EXPECT_EQ(a.arrows[k].symbol, b.arrows[k].symbol);
      ++arrows;
    }
  }
  EXPECT_GE(arrows, 5U);
  ASSERT_EQ(one.symbols.size(), 2U);
  EXPECT_LE(norm(Vector(turn(one.symbols[1].axis) - other.symbols[1].axis)), 1e-12);
}

TEST(Scene, cones_touch_along_the_angular_velocity) {
  const Document document = illustrated(R"(
given: {m: 4 kg, r: 0.3 m}
points: {G: [0, 0, 0]}
bodies: {disk: {disk: {center: G, normal: z, radius: r}, mass: m}}
gravity: none
instants: {start: {angular_velocity(disk): [1 rad/s, 0, 8 rad/s], velocity(disk): [0, 0, 0]}}
ask: {H: angular_momentum(disk about G)}
)");
  const Scene& scene = only_scene(document);
  ASSERT_EQ(scene.cones.size(), 2U);
  // H has half the angle to the axis, as I' is half of I.
  const double gamma = std::atan2(1, 8), theta = std::atan2(0.5, 8);
  EXPECT_NEAR(scene.cones[0].half_angle, gamma, 1e-9);
  EXPECT_NEAR(scene.cones[1].half_angle, gamma - theta, 1e-9);
  EXPECT_NEAR(dot(scene.cones[0].axis, scene.cones[0].touching_line), std::cos(gamma), 1e-12);
  EXPECT_NEAR(dot(scene.cones[1].axis, scene.cones[1].touching_line), std::cos(gamma - theta), 1e-12);
  // The body moves on, as nothing acts on it.
  EXPECT_TRUE(scene.motion);
}

TEST(Scene, the_herpolhode_lies_in_the_invariable_plane) {
  const Document document = illustrated(R"(
points: {G: [0, 0, 0]}
bodies: {block: {box: {center: G, sides: [[0.2 m, 0, 0], [0, 0.4 m, 0], [0, 0, 0.7 m]]}, mass: 3 kg}}
gravity: none
instants: {start: {angular_velocity(block): [3 rad/s, 1 rad/s, 0.5 rad/s], velocity(block): [0, 0, 0]}}
ask: {H: angular_momentum(block about G)}
)");
  const Scene& scene = only_scene(document);
  ASSERT_GE(scene.curves.size(), 2U);
  const std::vector<double> h = numbers(document.solutions[0].answers[0].si);
  const Vector H = normalized(Vector{h[0], h[1], h[2]});
  std::size_t looked = 0;
  for (const scene::Curve& curve : scene.curves) {
    if (curve.kind != scene::CurveKind::herpolhode) continue;
    for (const Vector& point : curve.points) {
      EXPECT_NEAR(dot(point, H), dot(curve.points.front(), H), 1e-9 * norm(point));
      ++looked;
    }
  }
  EXPECT_GT(looked, 100U);
}

TEST(Scene, letters_have_values_that_are_told_and_arrows_their_formulas) {
  const Document document = illustrated(R"(
letters: {m: kg, a: m, w: rad/s}
points: {G: [0, 0, 0], A: [-a, 0, 0], B: [a, 0, 0]}
bodies: {bar: {rod: [A, B], mass: m}}
joints: {pin: {revolute: z, at: G, to: bar, rate: w}}
gravity: none
ask: {H: angular_momentum(bar about G)}
)");
  const Scene& scene = only_scene(document);
  ASSERT_EQ(scene.drawn_letters.size(), 3U);
  std::map<std::string, double> letters;
  for (const scene::DrawnLetter& letter : scene.drawn_letters) letters[letter.name] = letter.value;
  const Diagram& answers = diagram_of(scene, DiagramKind::answers);
  ASSERT_EQ(answers.arrows.size(), 1U);
  const auto& formula = std::get<std::vector<Datum>>(document.solutions[0].answers[0].formula.content);
  EXPECT_EQ(answers.arrows[0].formula, std::get<std::string>(formula.at(2).content));
  EXPECT_NEAR(answers.arrows[0].vector.z, letters["a"] * letters["a"] * letters["m"] * letters["w"] / 3, 1e-12);
  EXPECT_NEAR(scene.bodies[0].shapes[0].vertices[1].x, letters["a"], 1e-12);
  // The length from G to B is a, by its letter.
  ASSERT_EQ(scene.dimensions.size(), 1U);
  EXPECT_EQ(scene.dimensions[0].text, "a");
}

std::map<std::string, double> letters_of(const Scene& scene) {
  std::map<std::string, double> letters;
  for (const scene::DrawnLetter& letter : scene.drawn_letters) letters[letter.name] = letter.value;
  return letters;
}

// The file's own example has the proportions that its author thinks of; without one, no two lengths look alike.
TEST(Scene, letters_have_the_values_of_the_example_or_lengths_that_are_told_apart) {
  const std::string hoist = R"(
plane: [x, y]
letters: {W: N, r: m, R: m, h: m}
points: {O: [0, 0], A: [-r, -h], B: [R, -h]}
bodies: {bar: {rod: [A, B], mass: W/g}}
joints: {pin: {revolute: z, at: O, to: bar}}
gravity: -y
instants: {now: rest}
ask: {al: angular_acceleration(bar)}
)";
  std::map<std::string, double> letters = letters_of(only_scene(illustrated(hoist)));
  EXPECT_GT(letters.at("R"), 1.3 * letters.at("r"));
  EXPECT_GT(letters.at("r"), 1.3 * letters.at("h"));
  letters = letters_of(only_scene(illustrated(
      hoist + "expect: {letters: {W: 20 N, r: 0.15 m, R: 0.2 m, h: 2 m}, al: {value: 0, unit: rad/s^2}}\n")));
  EXPECT_NEAR(letters.at("r"), 0.15, 1e-12);
  EXPECT_NEAR(letters.at("R"), 0.2, 1e-12);
  EXPECT_NEAR(letters.at("h"), 2, 1e-12);
  // Where the example makes no sense it draws nothing.
  letters = letters_of(only_scene(illustrated("assume: [h < r]\n" + hoist)));
  EXPECT_GT(letters.at("r"), letters.at("h"));
}

// The radius at which a bearing rubs shows nowhere.
TEST(Scene, a_length_that_nothing_is_drawn_with_is_told_to_show_in_nothing) {
  const Document document = illustrated(R"(
letters: {m: kg, r: m, s: m, L: m, mu: 1, n: rad/s}
points: {O: [0, 0, 0], A: [L, 0, 0], B: [0, s, 0]}
bodies: {plate: {triangle: [O, A, B], mass: m}}
joints: {pivot: {revolute: z, at: O, to: plate, rate: n, friction: {coefficient: mu, thrust_radius: r}}}
gravity: -z
instants: {now: {}}
ask: {al: angular_acceleration(plate).z}
)");
  for (const scene::DrawnLetter& letter : only_scene(document).drawn_letters)
    EXPECT_EQ(letter.only_grows, letter.name == "r") << letter.name;
}

TEST(Scene, a_solved_document_has_none_unless_it_is_asked_for) {
  const Problem problem =
      Problem::from_file((fs::path(POINSOT_SOURCE_DIR) / "examples" / "textbook" / "18.003.yaml").string());
  EXPECT_FALSE(problem.solve().solutions.at(0).scene);
  EXPECT_EQ(nlohmann::json::parse(to_json(problem.solve())).at("solutions").at(0).count("scene"), 0U);
  const Document with_both = problem.illustrate({}, {}, true);
  EXPECT_TRUE(with_both.solutions.at(0).scene && with_both.solutions.at(0).explanation);
}

TEST(Scene, json_has_the_fields_of_the_scene) {
  const Document document = illustrated(R"(
given: {m: 2 kg, L: 0.5 m}
points: {O: [0, 0, 0], E: [0, -L, 0]}
bodies: {bar: {rod: [O, E], mass: m}}
joints: {pin: {revolute: z, at: O, to: bar, angle: theta}}
gravity: -y
instants: {start: {theta: 60 deg, theta': 0}}
ask: {theta: theta @ 0.35 s}
)");
  const Scene& scene = only_scene(document);
  const auto json = nlohmann::json::parse(to_json(document)).at("solutions").at(0).at("scene");
  EXPECT_EQ(json.at("bodies").at(0).at("name"), "bar");
  EXPECT_EQ(json.at("bodies").at(0).at("shapes").at(0).at("extent"), "line");
  EXPECT_EQ(json.at("symbols").at(0).at("kind"), "revolute");
  EXPECT_EQ(json.at("symbols").at(0).at("from"), -1);
  EXPECT_EQ(json.at("up"), nlohmann::json({0.0, 1.0, 0.0}));
  const auto& motion = json.at("motion");
  const std::size_t times = scene.motion->times.size();
  EXPECT_EQ(motion.at("times").size(), times);
  EXPECT_EQ(motion.at("bodies").at(0).at("position").size(), 3 * times);
  EXPECT_EQ(motion.at("bodies").at(0).at("orientation").size(), 4 * times);
  // The quaternion at the start turns by 60 degrees about z.
  EXPECT_NEAR(motion.at("bodies").at(0).at("orientation").at(0).get<double>(), std::cos(std::numbers::pi / 6), 1e-8);
  EXPECT_NEAR(motion.at("bodies").at(0).at("orientation").at(3).get<double>(), std::sin(std::numbers::pi / 6), 1e-8);
}

}  // namespace scene_test
}  // namespace poinsot
