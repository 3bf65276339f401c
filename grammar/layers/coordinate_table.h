// One coordinate of many corners, with those that are as good as equal made equal.
// A helper of stitch_edges.h.
#pragma once

#include <cstdint>
#include <vector>

namespace parti::grammar {

/// Values in ascending order, each standing for a cluster of the given ones.
class CoordinateTable {
 public:
  /// `leading`: stands for its cluster before values that are not.
  void Add(double value, bool leading) { given_.push_back({value, leading}); }
  /// To be called once, after all values were added. A cluster spans a few tolerances at most.
  void Merge(double tolerance);

  uint32_t IndexOf(double given) const;  ///< of an added value
  double operator[](uint32_t index) const { return values_[index]; }
  uint32_t size() const { return static_cast<uint32_t>(values_.size()); }

 private:
  struct Given {
    double value;
    bool leading;
  };
  std::vector<Given> given_;
  std::vector<double> lows_;    ///< where each cluster begins
  std::vector<double> values_;  ///< what stands for it
};

}  // namespace parti::grammar
