#include "perception/planes/segment_contacts.hpp"

namespace polygonal_perception::perception {

void SegmentContacts::find(const NoisySamples& samples, const PlaneSegments& segments)
{
  size_ = segments.all.size();
  borders_.assign(size_ * size_, Border{});
  samples.forEachPair([&](std::uint32_t k, std::uint32_t neighbour) {
    const int a = segments.of_sample[k];
    const int b = segments.of_sample[neighbour];
    if (a == b || a == PlaneSegments::kNone || b == PlaneSegments::kNone) return;
    add(static_cast<std::size_t>(a), static_cast<std::size_t>(b),
        {samples[k].point + samples[neighbour].point, 2});
  });
}

std::optional<Eigen::Vector3d> SegmentContacts::middle(std::size_t a, std::size_t b) const
{
  if (size_ == 0) return std::nullopt;
  const Border& border = borders_[a * size_ + b];
  if (border.count == 0) return std::nullopt;
  return (border.sum / static_cast<float>(border.count)).cast<double>();
}

void SegmentContacts::join(std::size_t from, std::size_t into)
{
  for (std::size_t k = 0; k < size_; ++k) {
    if (k != from && k != into) add(into, k, borders_[from * size_ + k]);
  }
}

void SegmentContacts::add(std::size_t a, std::size_t b, const Border& more)
{
  for (Border* const border : {&borders_[a * size_ + b], &borders_[b * size_ + a]}) {
    border->sum += more.sum;
    border->count += more.count;
  }
}

}  // namespace polygonal_perception::perception
