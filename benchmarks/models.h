// The models that the benchmarks run on, stated plainly so that every contestant builds them from the same numbers.
#pragma once

#include <string>
#include <vector>

#include "poinsot/engine/model/builder.h"
#include "poinsot/engine/model/state.h"

namespace poinsot::bench {

struct StatedBody {
  int parent;
  Joint<double> joint;
  SpatialTransform<double> placement;
  MassProperties<double> mass;
};

struct StatedModel {
  std::string name;
  std::vector<StatedBody> bodies;
};

// Free body, heavy top, arms of seven hinges, a humanoid, chains of 10, 100 and 1000 hinges.
std::vector<StatedModel> stated_models();

Model<double> built(const StatedModel& stated);

// Random states with accelerations and forces to go with them.
struct Sample {
  State<double> state;
  std::vector<double> given;
};
std::vector<Sample> samples(const Model<double>& model, int count);

}  // namespace poinsot::bench
