// A motion that is followed once and then asked for any quantities at any times.
//
// What is asked goes two ways. At a few of the times it is asked as a question of the file would be, with all that
// tells whether it is determined and all checks, on a motion of its own; then it is evaluated at every time along the
// motion that is kept.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/engine/model/state.h"
#include "problem/answers/motion_columns.h"
#include "problem/entries/statement.h"

namespace poinsot::problem {

// A number or a vector over time, in SI units.
struct AskedSeries {
  Unit unit;
  std::vector<std::string> component_names;  // of a vector; empty for a number
  std::vector<double> values;                // time by time, and for each the components
};

struct AskedValues {
  std::vector<AskedSeries> series;
  std::map<std::string, double> checks;
  std::vector<std::string> notes;
};

// The bodies where the motion begins; what each part is says MotionStart (poinsot/problem.h).
struct TreeAtStart {
  Model<double> tree;
  State<double> state;
  std::vector<std::string> coordinates;
  std::vector<Vector3<double>> origins;
  std::vector<std::string> others;
};

class AskedMotion {
 public:
  // Finds the unknowns. `sets` are those of solve_statement. Throws StatementError if the file or a setting is wrong,
  // UnansweredRecord if there is not one motion.
  AskedMotion(Statement statement, SettingTexts sets);
  ~AskedMotion();

  std::vector<std::string> coordinate_names();
  // Throws UnansweredRecord if more than the joints of a tree hold the bodies.
  TreeAtStart start();
  // The values of quantities, as a file would ask for them, at times in any order (s). Throws StatementError if a
  // quantity or a time is wrong, UnansweredRecord if it has no answer or fails a check. Afterwards, and after the end
  // of a budget, the motion can be asked again.
  AskedValues values(const std::vector<double>& times, const std::vector<std::string>& quantities,
                     const std::string& axes);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace poinsot::problem
