// Another program that computes the same, to measure against.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "models.h"

namespace poinsot::bench {

// What a contestant computes. Each run takes a number of calls and goes through the samples in turn.
struct Contestant {
  std::function<void(int calls)> inverse_dynamics;
  std::function<void(int calls)> forward_dynamics;
  std::function<void(int calls)> mass_matrix;
  // Results for one sample: joint forces, accelerations, and the lower triangle of the mass matrix row by row.
  std::function<std::vector<double>(int sample)> inverse_result;
  std::function<std::vector<double>(int sample)> forward_result;
  std::function<std::vector<double>(int sample)> mass_result;
};

// The peer's name and version, or why there is none.
std::string peer_name();
// Empty functions if there is no peer, or not for this model.
Contestant make_peer(const StatedModel& stated, const std::vector<Sample>& samples);

}  // namespace poinsot::bench
