#include "sketch/segmentation.h"

#include "sketch/corner_search.h"
#include "sketch/speed_curvature.h"
#include "sketch/stroke_path.h"

namespace parti::sketch {

Result<Segmentation> SegmentStroke(const Stroke& stroke, const SegmentationParameters& parameters) {
  const Result<StrokePath> path = FilterStroke(stroke, parameters);
  if (!path) return Fail(path);
  const CornerEvidence evidence = EvidenceOf(*path, parameters);
  const std::vector<int> candidates = CornerCandidates(*path, evidence, parameters);
  Segmentation answer;
  for (const auto& corner : ChooseCorners(*path, candidates, evidence.price, parameters)) {
    const int sample = path->sample[corner.at];
    if (!answer.corners.empty()) {
      const SegmentKind kind = corner.after_curve ? SegmentKind::kCurve : SegmentKind::kLine;
      answer.segments.push_back({answer.corners.back(), sample, kind});
    }
    answer.corners.push_back(sample);
  }
  return answer;
}

}  // namespace parti::sketch
