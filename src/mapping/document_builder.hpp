#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mapping/json_document.hpp"
#include "mapping/run_lengths.hpp"

namespace polygonal_perception::mapping {

/// Builds a document from the events of nlohmann::json::sax_parse, whose names its methods have. Each returns
/// whether to go on. Unlike nlohmann's own it has limits, does not throw, and knows where in the map it is.
class DocumentBuilder
{
public:
  /// @param text  that is parsed; it has to live as long
  DocumentBuilder(const std::string& text, const JsonLimits& limits)
      : text_(text), limits_(limits), cells_left_(limits.cells)
  {
  }

  bool null() { return add(nullptr); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(std::int64_t value) { return add(value); }
  bool number_unsigned(std::uint64_t value);
  bool number_float(double value, const std::string& /*text*/) { return add(value); }
  bool string(std::string& value) { return add(std::move(value)); }
  /// Only binary formats have it. Old versions of nlohmann's library know neither it nor its type.
  template <class Binary>
  bool binary(Binary& /*value*/)
  {
    return false;
  }
  bool start_object(std::size_t /*size*/) { return open(Json::object()); }
  bool start_array(std::size_t /*size*/);
  bool key(std::string& name);
  bool end_object();
  bool end_array();
  bool parse_error(std::size_t position, const std::string& token, const Json::exception& exception);

  /// Complete when sax_parse returns true.
  JsonDocument& document() { return document_; }

  /// Why it returned false.
  const std::string& error() const { return error_; }

private:
  Json* put(Json&& value);
  bool add(Json&& value);
  bool open(Json&& container);
  bool beginsRuns() const;
  std::size_t layer() const { return open_[2]->size() - 1; }
  bool failInRuns(const std::string& what);
  bool fail(const std::string& what);

  const std::string& text_;
  const JsonLimits limits_;
  JsonDocument document_;
  std::string error_;
  std::string key_;                 // of the next value, in an object
  std::vector<Json*> open_;         // the containers around the next value, from the outermost
  std::optional<RunDecoder> runs_;  // while runs are read
  std::size_t values_ = 0;
  std::size_t cells_left_;
};

}  // namespace polygonal_perception::mapping
