#include "tests/support/debug_events.h"

#include <fmt/format.h>
#include <linux/input-event-codes.h>

#include <regex>
#include <sstream>

#include "tests/support/mock_tablet.h"

namespace parti::tests {
namespace {

using Kind = PenEvent::Kind;

Kind KindIn(const std::string& type, const std::string& line) {
  if (type == "AXIS") return Kind::kMotion;
  if (type == "BUTTON") return Kind::kButton;
  if (type == "TIP") return line.ends_with("down") ? Kind::kDown : Kind::kUp;
  return line.find("proximity-in") != std::string::npos ? Kind::kProximityIn : Kind::kProximityOut;
}

std::optional<PenLine> PenLineIn(const std::string& line) {
  static const std::regex type("TABLET_TOOL_([A-Z]+)");
  static const std::regex position(R"(s\t\t *(-?[0-9.]+)\*?/ *(-?[0-9.]+))");
  static const std::regex pressure("pressure: ([0-9.]+)");
  std::smatch match;
  if (!std::regex_search(line, match, type)) return std::nullopt;
  PenLine pen{.kind = KindIn(match[1], line)};
  if (std::regex_search(line, match, position)) {
    pen.position_mm = Vec2(std::stod(match[1]), std::stod(match[2]));
  }
  if (std::regex_search(line, match, pressure)) pen.pressure = std::stod(match[1]);
  return pen;
}

}  // namespace

Result<std::vector<PenLine>> PlayToDebugEvents(const EvdevRecording& recording) {
  const MockTablet tablet(recording);
  const auto corner_mm = [&](int code) {
    const EvdevAxis& axis = recording.axes.at(code);
    return static_cast<double>(axis.maximum - axis.minimum) / axis.resolution;
  };
  const std::string corner = fmt::format("{:.2f}*/{:.2f}*", corner_mm(ABS_X), corner_mm(ABS_Y));
  const auto outcome =
      tablet.Run({"stdbuf", "-oL", "libinput", "debug-events", "--device", kMockNode},
                 {.ready = "DEVICE_ADDED", .end = corner});
  if (!outcome) return Fail(outcome);
  std::vector<PenLine> lines;
  std::istringstream output(outcome->output.substr(0, outcome->output.find(corner)));
  for (std::string line; std::getline(output, line);) {
    if (const auto pen = PenLineIn(line)) lines.push_back(*pen);
  }
  // The last is the head of the line about the corner, cut off before its position.
  if (!lines.empty()) lines.pop_back();
  return lines;
}

}  // namespace parti::tests
