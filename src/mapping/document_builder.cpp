#include "mapping/document_builder.hpp"

#include <algorithm>
#include <iterator>

#include "mapping/ring_place.hpp"

namespace polygonal_perception::mapping {

namespace {

constexpr int kNumberOverflow = 406;  // nlohmann's error for a number that no double can hold

/// @param at  index of a byte, or of the end
std::string lineAndColumn(const std::string& text, std::size_t at)
{
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(at);
  const auto line_begin = std::find(std::make_reverse_iterator(end), text.rend(), '\n').base();
  return " at line " + std::to_string(1 + std::count(text.begin(), end, '\n')) + ", column " +
         std::to_string(1 + (end - line_begin));
}

}  // namespace

bool DocumentBuilder::number_unsigned(std::uint64_t value)
{
  if (!runs_) return add(value);
  const auto fault = runs_->take(value);
  return fault ? failInRuns(*fault) : true;
}

bool DocumentBuilder::start_array(std::size_t /*size*/)
{
  const bool begins_runs = !runs_ && beginsRuns();
  if (!open(Json::array())) return false;
  if (!begins_runs) return true;
  if (layer() >= kMostSavedLayers)
    return fail("cells: there are more than " + std::to_string(kMostSavedLayers) + " layers");
  runs_.emplace(cells_left_);
  return true;
}

bool DocumentBuilder::key(std::string& name)
{
  key_ = std::move(name);
  return true;
}

bool DocumentBuilder::end_object()
{
  open_.pop_back();
  return true;
}

bool DocumentBuilder::end_array()
{
  if (runs_) {
    if (const auto fault = runs_->end()) return failInRuns(*fault);
    document_.layers.resize(std::max(document_.layers.size(), layer() + 1));
    document_.layers[layer()] = std::move(runs_->values());
    cells_left_ -= document_.layers[layer()].size();
    runs_.reset();
  }
  open_.pop_back();
  return true;
}

bool DocumentBuilder::parse_error(std::size_t position, const std::string& token,
                                  const Json::exception& exception)
{
  // The bytes that were read count: of a text that ends too early also one behind its end.
  const std::size_t read = std::max<std::size_t>(position, 1);
  if (exception.id == kNumberOverflow) {
    const std::size_t first = read - std::min(read, token.size());
    return fail("the number " + cut(token) + lineAndColumn(text_, first) + " is not finite");
  }
  if (read > text_.size()) return fail("the text ends too early," + lineAndColumn(text_, text_.size()));
  return fail("this is no JSON" + lineAndColumn(text_, read - 1));
}

/// @return its place in the tree; nullptr where there are too many
Json* DocumentBuilder::put(Json&& value)
{
  if (++values_ > limits_.values) {
    fail("there are more than " + std::to_string(limits_.values) + " values");
    return nullptr;
  }
  if (open_.empty()) return &(document_.root = std::move(value));
  Json& parent = *open_.back();
  if (parent.is_object()) return &(parent[key_] = std::move(value));
  parent.push_back(std::move(value));
  return &parent.back();
}

bool DocumentBuilder::add(Json&& value)
{
  if (runs_) return failInRuns(runs_->refuse(shown(value)));
  return put(std::move(value)) != nullptr;
}

bool DocumentBuilder::open(Json&& container)
{
  if (runs_) return failInRuns(runs_->refuse(shown(container)));
  if (open_.size() == limits_.depth)
    return fail("arrays and objects are more than " + std::to_string(limits_.depth) + " deep in one another");
  Json* const placed = put(std::move(container));
  if (placed != nullptr) open_.push_back(placed);
  return placed != nullptr;
}

/// Whether the array that begins now is cells/layers/[k]/runs.
bool DocumentBuilder::beginsRuns() const
{
  return open_.size() == 4 && key_ == "runs" && open_[3]->is_object() && open_[2]->is_array() &&
         findMember(*open_[1], "layers") == open_[2] && findMember(*open_[0], "cells") == open_[1];
}

bool DocumentBuilder::failInRuns(const std::string& what)
{
  return fail("cells, layer " + std::to_string(layer()) + ", runs: " + what);
}

bool DocumentBuilder::fail(const std::string& what)
{
  const std::string place = placeInFeatures(open_);
  error_ = place.empty() ? what : place + ": " + what;
  return false;
}

}  // namespace polygonal_perception::mapping
