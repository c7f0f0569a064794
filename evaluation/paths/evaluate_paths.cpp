// Plans the same queries by several methods on the same scenes, and prints a line of JSON for each method on each scene:
// evaluate_paths [--data FOLDER] [--queries N] [--seconds N]. See scripts/evaluate_paths.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>

#include "paths/path_methods.hpp"
#include "paths/path_scenes.hpp"
#include "reference/minimal_construct.hpp"

namespace polygonal_perception::evaluation {
namespace {

using Clock = std::chrono::steady_clock;

struct Options
{
  std::string data;               // folder with arena.json and barn.json; empty: without them
  std::size_t queries = 200;      // a scene
  double seconds = 30.0;          // that a method may take for a scene
  std::size_t most_edges = 4000;  // of scenes whose whole visibility graph is counted
};

struct Answer
{
  std::optional<double> length;  // [m]
  double milliseconds = 0.0;
  std::size_t graph_edges = 0;
};

double millisecondsSince(Clock::time_point begin)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// As many of a scene's queries as the time lets.
std::vector<Answer> answers(PathMethod& method, const PathScene& scene, double seconds, double& preparation)
{
  auto begin = Clock::now();
  method.prepare(scene);
  preparation = millisecondsSince(begin);
  const auto first = Clock::now();
  std::vector<Answer> result;
  for (const PathQuery& query : scene.queries) {
    if (millisecondsSince(first) > 1e3 * seconds) break;
    begin = Clock::now();
    Answer answer;
    answer.length = method.plan(query.start, query.goal);
    answer.milliseconds = millisecondsSince(begin);
    answer.graph_edges = method.graphEdges();
    result.push_back(answer);
  }
  return result;
}

/// @param optima  of the queries; where there are fewer, the rest is not known
void print(const PathScene& scene, const std::string& method, double preparation,
           const std::vector<Answer>& answers, const std::vector<std::optional<double>>& optima,
           std::size_t all_edges)
{
  nlohmann::json line{{"family", scene.family},
                      {"edges", scene.edges()},
                      {"method", method},
                      {"preparation", preparation},
                      {"all_graph_edges", all_edges},
                      {"milliseconds", nlohmann::json::array()},
                      {"ratios", nlohmann::json::array()},
                      {"graph_edges", nlohmann::json::array()}};
  int missed = 0;
  int invented = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    line["milliseconds"].push_back(answers[i].milliseconds);
    line["graph_edges"].push_back(answers[i].graph_edges);
    if (i >= optima.size()) continue;
    if (answers[i].length && optima[i] && *optima[i] > 0.0)
      line["ratios"].push_back(*answers[i].length / *optima[i]);
    if (!answers[i].length && optima[i]) ++missed;
    if (answers[i].length && !optima[i]) ++invented;
  }
  line["missed"] = missed;
  line["invented"] = invented;
  std::cout << line << std::endl;
}

void evaluate(PathScene& scene, const Options& options)
{
  addRandomQueries(scene, scene.queries.empty() ? options.queries : scene.queries.size());
  std::fprintf(stderr, "%s, %zu edges, %zu queries\n", scene.family.c_str(), scene.edges(),
               scene.queries.size());
  std::size_t all_edges = 0;
  if (scene.edges() <= options.most_edges)
    all_edges = reference::MinimalConstruct(scene.obstacles).countEdges();

  double preparation = 0.0;
  const auto plain = plainMethod();
  const auto plain_answers = answers(*plain, scene, options.seconds, preparation);
  std::vector<std::optional<double>> optima;
  for (const Answer& answer : plain_answers) optima.push_back(answer.length);
  // What the source of the scene knows is a reference of its own.
  std::vector<std::optional<double>> known;
  for (const PathQuery& query : scene.queries)
    if (query.optimum) known.push_back(query.optimum);
  print(scene, plain->name(), preparation, plain_answers, known.empty() ? optima : known, all_edges);

  const auto ours = triangulatedMethod();
  const auto our_answers = answers(*ours, scene, options.seconds, preparation);
  print(scene, ours->name(), preparation, our_answers, optima, all_edges);
  optima.clear();
  for (const Answer& answer : our_answers) optima.push_back(answer.length);
  for (const auto& method : otherMethods()) {
    const auto their_answers = answers(*method, scene, options.seconds, preparation);
    print(scene, method->name(), preparation, their_answers, optima, all_edges);
  }
}

void evaluateAll(const Options& options)
{
  for (const std::size_t edges : {500, 1000, 2000, 5000, 10000}) {
    PathScene clutter = clutterScene(edges);
    evaluate(clutter, options);
    PathScene office = officeScene(edges);
    evaluate(office, options);
  }
  std::vector<PathScene> scenes = drivenScenes();
  if (!options.data.empty())
    for (PathScene& scene : publicScenes(options.data)) scenes.push_back(std::move(scene));
  for (PathScene& scene : scenes) evaluate(scene, options);
}

}  // namespace
}  // namespace polygonal_perception::evaluation

int main(int argc, char** argv)
{
  using namespace polygonal_perception::evaluation;
  Options options;
  for (int i = 1; i + 1 < argc; i += 2) {
    if (std::strcmp(argv[i], "--data") == 0) options.data = argv[i + 1];
    if (std::strcmp(argv[i], "--queries") == 0) options.queries = std::strtoul(argv[i + 1], nullptr, 10);
    if (std::strcmp(argv[i], "--seconds") == 0) options.seconds = std::strtod(argv[i + 1], nullptr);
  }
  try {
    evaluateAll(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "evaluate_paths: %s\n", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
