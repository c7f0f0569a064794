#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"

namespace polygonal_perception::perception {

/// A point of the low-resolution grid with the surface normal in it (section III-A, eq. 1).
struct Sample
{
  Eigen::Vector3f point;   ///< [m] in the input's frame; meaningful only with a point
  Eigen::Vector3f normal;  ///< unit, towards the camera; meaningful only with a normal
  std::uint16_t u = 0;     ///< pixel it was taken from
  std::uint16_t v = 0;
  bool has_point = false;
  bool has_normal = false;
};

/// The grid G_c of samples that are spread evenly over the image, its border pixels included (section III-A).
class POLYGONAL_PERCEPTION_EXPORT SampleGrid
{
public:
  struct Parameters
  {
    int samples_x = 32;  ///< samples across the image
    int samples_y = 32;  ///< samples down the image

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit)
    {
      visit("samples_x", self.samples_x, parameters::Range{4, 256}, "",
            "Samples of the floor detector across the image.");
      visit("samples_y", self.samples_y, parameters::Range{4, 256}, "",
            "Samples of the floor detector down the image.");
    }
  };

  explicit SampleGrid(const Parameters& parameters) : parameters_(parameters) {}
  const Parameters& parameters() const { return parameters_; }

  /// Takes the samples of a frame anew; nothing of the last frame is left.
  ///
  /// A sample whose pixel has no return takes the nearest pixel with one, at most a quarter of the sample
  /// spacing away. Normals follow eq. 2 from the neighbours in the grid; where one is missing the one-sided
  /// difference stands in, and where a direction has no usable pair the sample has no normal. Images smaller
  /// than the grid are sampled with fewer samples, one a pixel.
  void update(const PointView& points);

  int samplesX() const { return samples_x_; }
  int samplesY() const { return samples_y_; }
  const Sample& at(int i, int j) const { return samples_[static_cast<std::size_t>(j) * samples_x_ + i]; }
  /// Row by row, samplesX() a row.
  const std::vector<Sample>& samples() const { return samples_; }

private:
  void takePoints(const PointView& points);
  void computeNormals();

  Parameters parameters_;
  int samples_x_ = 0;
  int samples_y_ = 0;
  std::vector<Sample> samples_;
  std::vector<int> columns_;  // of the image, in which samples are taken
};

}  // namespace polygonal_perception::perception
