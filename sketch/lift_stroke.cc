#include "sketch/lift_stroke.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "sketch/lift.h"
#include "sketch/line_match.h"
#include "sketch/score.h"

namespace parti::sketch {
namespace {

// How much likelier the line is drawn for its fittest candidate than for nothing [nat].
double WorthOf(const WorldLine& line, const View& view, const SketchParameters& parameters) {
  const auto screen = view.Project(line.world);
  if (!screen) return 0;
  const double deviation = parameters.noise.Deviation_px(glm::distance(line.drawn.a, line.drawn.b));
  const double squared = SquaredEndDistance(line.drawn, *screen) / (deviation * deviation);
  return parameters.lift.line_worth -
         parameters.parts.free_end * line.alternatives.front().free_ends -
         DampedError(squared, parameters.descent.outlier_deviations) / 2;
}

LiftedStroke LiftReading(const StrokeReading& reading, const Candidates& candidates,
                         const View& view, const SketchParameters& parameters,
                         std::optional<Error>* last) {
  LiftedStroke lifted;
  lifted.price = reading.price;
  lifted.worth = -reading.price;
  for (const Segment2& line : reading.lines) {
    auto world = Lift(line, candidates, view.camera(), parameters.lift);
    if (!world) *last = world.error();
    const double gain = world ? WorthOf(*world, view, parameters) : 0;
    if (gain > 0) {
      lifted.worth += gain;
      lifted.lines.push_back(std::move(*world));
    } else {
      ++lifted.lost_lines;
      lifted.lost_px += glm::distance(line.a, line.b);
    }
  }
  return lifted;
}

}  // namespace

Result<std::vector<LiftedStroke>> LiftReadings(const std::vector<StrokeReading>& readings,
                                               const Candidates& candidates, const Camera& camera,
                                               const SketchParameters& parameters) {
  const View view(camera);
  std::vector<LiftedStroke> all;
  std::optional<Error> last;
  for (const StrokeReading& reading : readings) {
    LiftedStroke lifted = LiftReading(reading, candidates, view, parameters, &last);
    if (!lifted.lines.empty()) all.push_back(std::move(lifted));
  }
  std::ranges::stable_sort(all, std::greater<>(), &LiftedStroke::worth);
  if (!all.empty()) return all;
  if (last) return tl::unexpected<Error>(*last);
  return Fail(ErrorCode::kNoFit, "no operation on this shape makes an edge near the drawn lines",
              "start or end the line at a corner or an edge of the shape");
}

}  // namespace parti::sketch
