// `parti segment STROKES.jsonl`: the segments of every stroke, as docs/interfaces say.
#include <memory>

#include "app/batch.h"
#include "app/commands/commands.h"
#include "sketch/segmentation.h"

namespace parti::app {
namespace {

BatchAnswer ToJson(const sketch::StrokeSegment& segment) {
  const bool line = segment.kind == sketch::SegmentKind::kLine;
  return {{"from", segment.from}, {"to", segment.to}, {"kind", line ? "line" : "curve"}};
}

Result<BatchAnswer> AnswerStroke(const Json& task) {
  const auto points = task.find("points");
  if (points == task.end()) return Fail(ErrorCode::kBadText, "\"points\" is missing");
  const Result<Stroke> stroke = StrokeFrom(*points, "points");
  if (!stroke) return Fail(stroke);
  const Result<sketch::Segmentation> found = sketch::SegmentStroke(*stroke);
  if (!found) return Fail(found);
  BatchAnswer segments = BatchAnswer::array();
  for (const sketch::StrokeSegment& segment : found->segments) segments.push_back(ToJson(segment));
  return BatchAnswer{{"corners", found->corners}, {"segments", segments}};
}

}  // namespace

void AddSegmentCommand(CLI::App& app, Run* run) {
  CLI::App* command = app.add_subcommand("segment", "Finds the lines and curves of pen strokes");
  const auto path = std::make_shared<std::string>();
  command
      ->add_option("STROKES", *path,
                   "strokes, one a line: {\"id\",\"points\":[[x,y,t ms] or [x,y,t,pressure], …]}; "
                   "- reads standard input")
      ->required();
  command->footer(
      "Example:\n"
      "  echo '{\"id\":1,\"points\":[[0,0,0],[50,1,60],[99,0,120],[99,40,190],[100,80,250]]}' |\n"
      "    parti segment -");
  command->callback([path, run] { *run = [path] { return RunBatch(*path, AnswerStroke); }; });
}

}  // namespace parti::app
