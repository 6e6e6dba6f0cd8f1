// Units of measurement: a curated table, the grammar of composed units, and the unit in which an answer should come.
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
  double factor = 1;  // one of it in SI base units, angles in radians
  Dimension dimension;
  std::string text;  // as written, "" for a pure number
};

class UnitError : public std::invalid_argument {
 public:
  UnitError(std::string message_, std::string hint_, std::size_t offset_);

  std::string message;
  std::string hint;
  std::size_t offset;  // in bytes, where in the unit's text the bad piece begins
};

// A unit of the grammar  piece (('*' | '/') piece)*,  piece = name ['^' exponent] | '1',  exponent = a whole number up
// to 9 or a fraction in parentheses; factors bind from left to right, one at a time: a/b*c = (a/b)*c. No blanks. lb, oz
// and kip are forces, lbm and ozm masses, g is the gram, mph miles per hour. Throws UnitError naming the bad piece,
// with the repair or the nearest unit.
Unit parse_unit(std::string_view text);

// The unit that stands in an entry of the file. Throws StatementError.
Unit parse_unit(const Entry& entry, const std::string& file);

// Is this one name of the table (no composed unit)?
bool is_unit_name(std::string_view name);

// The names of the table, in its order.
const std::vector<std::string>& unit_names();

// For a common wrong unit word (lbs, sec, Nm, Hz, ...) what is wrong with it; "" for any other word.
std::string wrong_unit_message(std::string_view word);

// The coherent SI unit of a dimension: N, N*m (J if asked as an energy), kg*m^2/s, m/s, rad/s, "" for a pure number.
Unit si_unit(const Dimension& dimension, bool as_energy = false);

// The text of that unit.
std::string format_unit(const Dimension& dimension, bool as_energy = false);

// The units that a statement uses, and from them the units in which its answers should come.
class UnitHabits {
 public:
  // One unit literal of the statement.
  void note(const Unit& unit);
  // All unit literals in an expression.
  void note(const Expression& expression);

  // Was a unit of the US customary system (lb, oz, ft, in, slug, ...) used?
  bool customary() const { return customary_; }

  // The most used stated unit of exactly this dimension (the first of several), else one composed in the system used:
  // lb, ft, s, slug or SI. Angles come in deg if deg was used, otherwise in rad; angular velocities in rad/s unless
  // they were stated in other units only. N*m and lb*ft are for moments; J and ft*lb for energies.
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
