// Units of measurement: the grammar of composed units, and the unit in which an answer is given.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "problem/language/diagnostic.h"
#include "problem/language/dimension.h"

namespace poinsot::problem {

struct Entry;
struct Expression;

struct Unit {
  double factor = 1;  // one of the unit in SI base units, angles in radians
  Dimension dimension;
  std::string text;  // as written, "" for a pure number
};

class UnitError : public std::invalid_argument {
 public:
  UnitError(std::string message_, std::string hint_, std::size_t offset_);

  std::string message;
  std::string hint;
  std::size_t offset;  // of the bad piece within the unit's text, in bytes
};

// Parses a unit by the grammar piece (('*' | '/') piece)*, with piece = name ['^' exponent] | '1' and exponent = a
// whole number up to 9 or a fraction in parentheses. Factors bind from left to right, one at a time: a/b*c = (a/b)*c.
// There are no blanks. lb, oz and kip are forces, lbm and ozm masses, g is the gram, mph miles per hour. Throws
// UnitError, which names the bad piece and the repair or the nearest unit.
Unit parse_unit(std::string_view text);

// Parses the unit that stands in an entry of the file. Throws StatementError.
Unit parse_unit(const Entry& entry, const std::string& file);

// Whether this is a name of the table (and no composed unit).
bool is_unit_name(std::string_view name);

// The names of the table, in its order.
const std::vector<std::string>& unit_names();

// What is wrong with a common wrong word for a unit (lbs, sec, Nm, Hz, ...); "" for any other word.
std::string wrong_unit_message(std::string_view word);

// The coherent SI unit of a dimension: N, N*m (J for an energy), kg*m^2/s, m/s, rad/s, and "" for a pure number.
Unit si_unit(const Dimension& dimension, bool as_energy = false);

// The text of that unit.
std::string format_unit(const Dimension& dimension, bool as_energy = false);

// Counts the units that a statement uses, and chooses from them the units of its answers.
class UnitHabits {
 public:
  // Counts one unit of a literal in the statement.
  void note(const Unit& unit);
  // Counts the units of all literals in an expression.
  void note(const Expression& expression);

  // Whether a unit of the US customary system (lb, oz, ft, in, slug, ...) was used.
  bool customary() const { return customary_; }

  // The unit stated most often for exactly this dimension (the first of several), or else one composed in the system
  // used: lb, ft, s and slug, or SI. Angles are given in deg if deg was used, otherwise in rad; angular velocities in
  // rad/s unless they were stated in other units only. N*m and lb*ft serve for moments, J and ft*lb for energies.
  Unit unit_for(const Dimension& dimension, bool as_energy = false) const;

 private:
  struct Use {
    Unit unit;
    int count = 0;
  };
  const Unit* most_used(const Dimension& dimension, bool as_energy) const;

  std::vector<Use> uses_;
  bool customary_ = false;
  bool degrees_ = false;
};

}  // namespace poinsot::problem
