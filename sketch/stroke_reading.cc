#include "sketch/stroke_reading.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace parti::sketch {
namespace {

struct Span {
  int from;
  int to;
  bool operator==(const Span&) const = default;
};

Segment2 ChordOf(const Stroke& stroke, const Span& span) {
  return {stroke[static_cast<size_t>(span.from)].position,
          stroke[static_cast<size_t>(span.to)].position};
}

double Length(const Segment2& line) { return glm::distance(line.a, line.b); }

// Furthest sample from the chord, as a share of the chord; infinite for a chord of no length.
double Bow(const Stroke& stroke, const Span& span) {
  const Segment2 chord = ChordOf(stroke, span);
  const double length = Length(chord);
  if (length <= 0) return std::numeric_limits<double>::infinity();
  const Vec2 along = (chord.b - chord.a) / length;
  double furthest = 0;
  for (int i = span.from + 1; i < span.to; ++i) {
    const Vec2 d = stroke[static_cast<size_t>(i)].position - chord.a;
    const double beyond = std::max({0.0, -glm::dot(d, along), glm::dot(d, along) - length});
    furthest = std::max({furthest, std::abs(Cross(along, d)), beyond});
  }
  return furthest / length;
}

std::vector<Span> SpansOf(const Segmentation& segmentation) {
  std::vector<Span> spans;
  for (const StrokeSegment& s : segmentation.segments) spans.push_back({s.from, s.to});
  return spans;
}

void MergeStraightNeighbours(const Stroke& stroke, double joint_bow, std::vector<Span>* spans) {
  for (size_t i = 0; i + 1 < spans->size();) {
    const Span joint{(*spans)[i].from, (*spans)[i + 1].to};
    if (Bow(stroke, joint) > joint_bow) {
      ++i;
      continue;
    }
    (*spans)[i] = joint;
    spans->erase(spans->begin() + static_cast<std::ptrdiff_t>(i) + 1);
    if (i > 0) --i;
  }
}

void DropHooks(const Stroke& stroke, double hook, std::vector<Span>* spans) {
  double longest = 0;
  for (const Span& s : *spans) longest = std::max(longest, Length(ChordOf(stroke, s)));
  std::erase_if(*spans, [&](const Span& s) { return Length(ChordOf(stroke, s)) < hook * longest; });
}

std::optional<Vec2> Crossing(const Segment2& l, const Segment2& m) {
  const Vec2 u = l.b - l.a, v = m.b - m.a;
  const double cross = Cross(u, v);
  if (std::abs(cross) < 0.5 * glm::length(u) * glm::length(v)) return std::nullopt;  // under 30 deg
  return l.a + u * (Cross(m.a - l.a, v) / cross);
}

// Where a closed outline starts, its ends over- or undershoot; both lines are drawn through there.
void CloseOutline(double gap, std::vector<Segment2>* lines) {
  if (lines->size() < 3) return;
  Segment2& first = lines->front();
  Segment2& last = lines->back();
  const double reach = gap * std::min(Length(first), Length(last));
  if (glm::distance(first.a, last.b) > reach) return;
  const auto corner = Crossing(first, last);
  if (!corner || glm::distance(*corner, first.a) > reach) return;
  first.a = *corner;
  last.b = *corner;
}

Result<void> CheckSamples(const Stroke& stroke) {
  for (const StrokeSample& s : stroke) {
    if (!IsFinite(s.position) || !std::isfinite(s.t_s)) {
      return Fail(ErrorCode::kBadNumber, "a sample of the stroke is not finite");
    }
  }
  return {};
}

// Douglas and Peucker: corners where the stroke leaves the chord by more than the tolerance.
void SplitAtFurthest(const Stroke& stroke, const Span& span, double tolerance_px,
                     std::vector<Span>* spans) {
  const Segment2 chord = ChordOf(stroke, span);
  const Vec2 along = chord.b - chord.a;
  const double length = glm::length(along);
  int at = -1;
  double furthest = tolerance_px;
  for (int i = span.from + 1; i < span.to; ++i) {
    const Vec2 d = stroke[static_cast<size_t>(i)].position - chord.a;
    const double distance = length > 0 ? std::abs(Cross(along, d)) / length : glm::length(d);
    if (distance <= furthest) continue;
    furthest = distance;
    at = i;
  }
  if (at < 0) {
    spans->push_back(span);
    return;
  }
  SplitAtFurthest(stroke, {span.from, at}, tolerance_px, spans);
  SplitAtFurthest(stroke, {at, span.to}, tolerance_px, spans);
}

using Spans = std::vector<Span>;

Spans SegmentSpans(const Stroke& stroke, const Segmentation& segmentation,
                   const LineParameters& parameters) {
  Spans spans = SpansOf(segmentation);
  MergeStraightNeighbours(stroke, parameters.joint_bow, &spans);
  DropHooks(stroke, parameters.hook, &spans);
  std::erase_if(spans, [&](const Span& s) { return Bow(stroke, s) > parameters.greatest_bow; });
  return spans;
}

Spans PolygonSpans(const Stroke& stroke, double tolerance, const LineParameters& parameters) {
  const int last = static_cast<int>(stroke.size()) - 1;
  Spans spans;
  SplitAtFurthest(stroke, {0, last}, tolerance * Diagonal(stroke), &spans);
  DropHooks(stroke, parameters.hook, &spans);
  return spans;
}

void AddReading(const Stroke& stroke, const Spans& spans, double price,
                const LineParameters& parameters, std::vector<Spans>* known,
                std::vector<StrokeReading>* readings) {
  if (spans.empty() || std::ranges::count(*known, spans) > 0) return;
  known->push_back(spans);
  StrokeReading reading;
  reading.price = price;
  for (const Span& s : spans) reading.lines.push_back(ChordOf(stroke, s));
  CloseOutline(parameters.closing_gap, &reading.lines);
  readings->push_back(std::move(reading));
}

}  // namespace

Result<std::vector<StrokeReading>> ReadStroke(const Stroke& stroke,
                                              const SegmentationParameters& segmentation,
                                              const LineParameters& parameters) {
  if (const auto fine = CheckSamples(stroke); !fine) return tl::unexpected<Error>(fine.error());
  const auto segments = SegmentStroke(stroke, segmentation);
  if (!segments) return Fail(segments);
  std::vector<StrokeReading> readings;
  std::vector<Spans> known;
  const auto add = [&](const Spans& spans, double price) {
    AddReading(stroke, spans, price, parameters, &known, &readings);
  };
  add(SegmentSpans(stroke, *segments, parameters), 0);
  const Span whole{0, static_cast<int>(stroke.size()) - 1};
  const double bow = Bow(stroke, whole);
  if (bow <= parameters.greatest_bow_of_line) add({whole}, parameters.bow_price * bow);
  for (const double tolerance : parameters.polygon_tolerances) {
    const Spans spans = PolygonSpans(stroke, tolerance, parameters);
    if (spans.size() <= static_cast<size_t>(parameters.most_polygon_lines)) {
      add(spans, parameters.polygon_price);
    }
  }
  if (readings.empty()) {
    return Fail(ErrorCode::kNoFit, "the stroke has no straight line",
                "operations are read from straight lines; draw the edges that they make");
  }
  return readings;
}

Result<std::vector<std::vector<StrokeReading>>> ReadStrokes(
    const std::vector<Stroke>& strokes, const SegmentationParameters& segmentation,
    const LineParameters& parameters) {
  std::vector<std::vector<StrokeReading>> all;
  Error last{ErrorCode::kTooShort, "the sketch has no strokes", "draw a line"};
  for (const Stroke& stroke : strokes) {
    auto readings = ReadStroke(stroke, segmentation, parameters);
    if (readings) {
      all.push_back(std::move(*readings));
    } else if (readings.error().code == ErrorCode::kBadNumber) {
      return Fail(readings);
    } else {
      last = readings.error();
    }
  }
  if (all.empty()) return tl::unexpected<Error>(last);
  return all;
}

}  // namespace parti::sketch
