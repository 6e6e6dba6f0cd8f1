#include "problem/explanation/general_motion.h"

#include <algorithm>

#include "poinsot/engine/work/budget.h"

namespace poinsot::problem {
namespace {

// The letters that FormulaInstant makes for coordinates without name and for parts of a pose are not for a reader.
std::string unnamed_position(const std::string& joint) { return "position of joint '" + joint + "'"; }

std::optional<LetterValues> coordinate_letters(const Machine& machine, const MotionState& now) {
  LetterValues letters{{"time", now.time}};
  const Model<double>& tree = machine.mechanism.tree;
  for (std::size_t k = 0; k < now.v.size(); ++k) letters[machine.mechanism.coordinate_names[k]] = now.v[k];
  for (const NamedCoordinate& coordinate : machine.coordinates) {
    letters[coordinate.name.empty() ? unnamed_position(coordinate.joint) : coordinate.name] =
        now.q[static_cast<std::size_t>(coordinate.position)];
    if (!coordinate.name.empty())
      letters[GeneralMotion::rate_letter(coordinate.name)] = now.v[static_cast<std::size_t>(coordinate.velocity)];
  }
  for (int i = 0; i < tree.body_count(); ++i) {
    const auto& body = tree.body(i);
    if (body.joint != JointType::ball && body.joint != JointType::free) continue;
    const auto q = static_cast<std::size_t>(body.q);
    // A half turn has no such letters.
    if (now.q[q] == 0) return std::nullopt;
    for (std::size_t k = 1; k <= 3; ++k) letters[letter_of_turn(tree.name(i), k - 1)] = now.q[q + k] / now.q[q];
  }
  return letters;
}

// What instants state of a coordinate or its rate, by the letter that it has in formulas; null if nothing.
const Fact* stated_of(const std::string& letter, const std::vector<const Instant*>& stated) {
  for (const Instant* instant : stated)
    for (const Fact& fact : instant->facts) {
      const Name* name = fact.quantity.as<Name>();
      if (name && name->primes <= 1 &&
          (name->primes == 0 ? name->name : GeneralMotion::rate_letter(name->name)) == letter)
        return &fact;
    }
  return nullptr;
}

}  // namespace

std::unique_ptr<GeneralMotion> GeneralMotion::of(const Situation& situation, const FormulaValues& values,
                                                 const Settings& settings, const MotionState& now,
                                                 LetterValues letters) {
  std::unique_ptr<GeneralMotion> general(new GeneralMotion);
  general->situation_ = situation;
  // What is known of instants holds there alone.
  general->situation_.instants.clear();
  general->settings_ = settings;
  general->letters_ = std::move(letters);
  for (const auto& [name, value] : values) general->dimensions_[name] = value.dimension;
  general->open_.all_poses = true;
  try {
    general->numbers_ = std::make_unique<SolvedInstant>(general->situation_, general->settings_, now, OpenChoice{});
    const std::optional<LetterValues> point = general->letters_at(now);
    if (!point) return nullptr;
    const PlainPointScope decisions(*point);
    general->formulas_ =
        std::make_unique<FormulaInstant>(general->situation_, values, *general->numbers_, &general->open_);
  } catch (const std::exception&) {
    return nullptr;
  }
  return general;
}

std::optional<LetterValues> GeneralMotion::letters_at(const MotionState& now) const {
  std::optional<LetterValues> all = coordinate_letters(numbers_->machine(), now);
  if (all)
    for (const auto& [name, value] : letters_) all->insert_or_assign(name, value);
  return all;
}

std::optional<Formula> GeneralMotion::at_start(const Formula& formula, const MotionState& start,
                                               const std::vector<const Instant*>& stated) const {
  const std::optional<LetterValues> there = letters_at(start);
  if (!there) return std::nullopt;
  std::map<std::string, Formula> values;
  for (const std::string& letter : formula.letters()) {
    if (!is_of_motion(letter)) continue;
    if (const Fact* fact = stated_of(letter, stated))
      values.insert_or_assign(letter, formulas_->data().number(fact->value, dimension_of(letter)));
    else if (there->at(letter) == 0)
      values.insert_or_assign(letter, Formula(0));
    else
      return std::nullopt;
  }
  return substituted(formula, values);
}

LetterValues GeneralMotion::in_shown_units(const LetterValues& letters, const ExplanationTex& tex) const {
  LetterValues shown = letters;
  for (auto& [name, value] : shown) {
    const auto datum = dimensions_.find(name);
    if (datum != dimensions_.end())
      value /= tex.unit(datum->second).factor;
    else if (is_of_motion(name))
      value /= tex.unit(dimension_of(name)).factor;
  }
  return shown;
}

const NamedCoordinate* GeneralMotion::coordinate_of(const std::string& letter) const {
  for (const NamedCoordinate& coordinate : numbers_->machine().coordinates)
    if (!coordinate.name.empty() && (letter == coordinate.name || letter == rate_letter(coordinate.name)))
      return &coordinate;
  return nullptr;
}

std::vector<std::string> GeneralMotion::named_coordinates() const {
  std::vector<std::string> names;
  const Model<double>& tree = numbers_->machine().mechanism.tree;
  for (int i = 0; i < tree.body_count(); ++i)
    if (velocity_size(tree.body(i).joint) > 1) return {};
  for (const NamedCoordinate& coordinate : numbers_->machine().coordinates) {
    if (coordinate.name.empty()) return {};
    names.push_back(coordinate.name);
  }
  return names;
}

bool GeneralMotion::is_of_motion(const std::string& letter) const { return coordinate_of(letter) != nullptr; }

Dimension GeneralMotion::dimension_of(const std::string& letter) const {
  const NamedCoordinate& coordinate = *coordinate_of(letter);
  if (letter == coordinate.name) return coordinate.turning ? dimensions::angle : dimensions::length;
  return coordinate.turning ? dimensions::angular_velocity : dimensions::velocity;
}

bool GeneralMotion::is_named(const Formula& formula) const {
  return std::ranges::all_of(
      formula.letters(), [&](const std::string& letter) { return letters_.contains(letter) || is_of_motion(letter); });
}

}  // namespace poinsot::problem
