// The figure of a situation: its bodies with their shapes, in their places at one instant, and what holds them.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "poinsot/engine/solve/instant/mechanism_state.h"
#include "poinsot/scene.h"
#include "problem/explanation/explanation_tex.h"
#include "problem/machine/machine.h"

namespace poinsot::problem {

// A vector's symbol as TeX and as plain text.
struct ArrowSymbol {
  std::string tex, text;
};

// The situation with values and its bodies in their places, from which all of a scene is drawn.
class SceneFigure {
 public:
  // All arguments must outlive the object.
  SceneFigure(const Situation& situation, const Settings& settings, const Machine& machine,
              const solve::MechanismState& state, const ExplanationTex& tex, scene::Scene& scene);

  // These add to the scene.
  void add_bodies();
  void add_points();
  void add_symbols();
  void add_links();
  void add_pitch_circles();
  // Hinges whose place on their axis tells nothing stand where the axis is nearest to both bodies, if these are drawn
  // by their arms alone.
  void stand_hinges_at_bodies();
  void add_world();          // axes, gravity, size; after the others
  void add_joint_springs();  // after the size is known

  const Situation& situation() const { return situation_; }
  const Machine& machine() const { return machine_; }
  const Mechanism<double>& mechanism() const { return machine_.mechanism; }
  const solve::MechanismState& state() const { return state_; }
  const ExplanationTex& tex() const { return tex_; }
  scene::Scene& scene() const { return scene_; }
  DataScope<double>& data() { return data_; }

  // The number in the scene of a body or frame of the machine's tree; of a massless link between the freedoms of a
  // joint there is none, and it counts as the ground.
  int scene_body(int tree_body) const;
  int tree_body(int scene_body) const { return tree_bodies_[static_cast<std::size_t>(scene_body)]; }
  // A place of the machine as the scene has it: on the axes of the body as drawn.
  scene::Place scene_place(const Place<double>& place) const;
  // A point of the ground in the present pose, as one that rides with a body.
  scene::Place riding(int tree_body, const Vector3<double>& on_ground) const;
  scene::Pose pose_of(int tree_body, const solve::MechanismState& state) const;
  Vector3<double> on_ground(const scene::Place& place) const;

  // An arrow with its value in the unit shown. symbol: of the vector; the value is its size.
  scene::Arrow arrow(scene::Quantity quantity, const std::string& name, int body, const scene::Place& at,
                     const Vector3<double>& vector, const ArrowSymbol& symbol) const;
  // A vector's symbol for a name of the statement: \mathbf{P}, P.
  static ArrowSymbol vector_symbol(const std::string& name);
  // That of what has a name: the name itself if it is as short as a symbol, otherwise a letter (TeX) with it as index.
  static ArrowSymbol named_symbol(const std::string& letter, const std::string& name);
  static ArrowSymbol indexed_symbol(const std::string& letter, const std::string& index);
  // An impulse: that of what has a name of its own, and of a force or couple with the time that it acts.
  static ArrowSymbol impulse_symbol(const std::string& letter, const std::string& name);
  // Whether a vector is nothing but rounding beside the natural sizes of the instant. Set by whoever knows them.
  bool vanishes(const Vector3<double>& vector, const Dimension& dimension) const;
  void set_natural_size(std::function<double(const Dimension&)> size) { natural_size_ = std::move(size); }

 private:
  void add_shapes(const Body& body, scene::Body& drawn);
  void add_shape(const Part& part, bool added, scene::Body& drawn);
  void set_length();
  // Of a link to the ground that is much longer than what it holds only the direction counts.
  void cut_long_links();

  const Situation& situation_;
  const Settings& settings_;
  const Machine& machine_;
  const solve::MechanismState& state_;
  const ExplanationTex& tex_;
  scene::Scene& scene_;
  DataScope<double> data_;
  std::vector<int> tree_bodies_;  // of each body of the scene
  std::map<int, int> scene_bodies_;
  std::function<double(const Dimension&)> natural_size_;
  std::size_t vertices_ = 0;
};

// The dimension of a quantity, and whether it is a turning one that has no point of its own.
Dimension dimension_of(scene::Quantity quantity);

}  // namespace poinsot::problem
