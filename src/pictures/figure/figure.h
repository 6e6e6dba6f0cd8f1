// Figures of a scene: which there are, and each as a drawing.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pictures/drawing/drawing.h"
#include "pictures/solids/projection.h"
#include "poinsot/scene.h"

namespace poinsot::pictures {

enum class FigureKind { model, free_body, impulse, cones, motion, answers, body };

// A figure that a scene has: by the word for it, "model", "free-body", or by the name of a body.
struct FigureName {
  FigureKind kind = FigureKind::model;
  std::string name, title;
  int body = scene::ground;
};
std::vector<FigureName> figures_of(const scene::Scene& scene);

struct Looks {
  std::optional<View> view{};
  bool values = false;
};

Drawing figure(const scene::Scene& scene, const FigureName& name, const std::string& title, const Looks& looks);

}  // namespace poinsot::pictures
