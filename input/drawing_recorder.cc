#include "input/drawing_recorder.h"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <utility>

namespace parti::input {
namespace {

tl::unexpected<Error> CannotWrite(const std::string& path, const char* hint) {
  return Fail(ErrorCode::kFile, fmt::format("can't write {}: {}", path, std::strerror(errno)),
              hint);
}

/// The difference of two times that are whole microseconds, as the nearest double to one.
double Since(double start_s, double t_s) { return std::round((t_s - start_s) * 1e6) / 1e6; }

}  // namespace

Result<DrawingRecorder> DrawingRecorder::Create(const std::string& path) {
  std::FILE* file = std::fopen(path.c_str(), "wbe");
  if (!file) return CannotWrite(path, "check that the folder exists and that you may write there");
  DrawingRecorder recorder(path, file);
  if (auto fine = recorder.Append(DrawingWriter::Begin()); !fine) return Fail(fine);
  return recorder;
}

Result<void> DrawingRecorder::Add(const std::vector<InputEvent>& events) {
  std::string lines;
  for (InputEvent event : events) {
    std::visit(
        [this](auto& e) {
          if (!start_s_) start_s_ = e.t_s;
          e.t_s = Since(*start_s_, e.t_s);
        },
        event);
    const auto line = writer_.Add(event);
    if (!line) return Fail(line);
    lines += *line;
    if (!std::holds_alternative<DeviceEvent>(event)) ++reports_;
  }
  return Append(lines);
}

Result<void> DrawingRecorder::AddCommand(std::string_view text) {
  const auto line = writer_.AddCommand(text);
  if (!line) return Fail(line);
  return Append(*line);
}

Result<void> DrawingRecorder::Finish() {
  if (auto fine = Append(DrawingWriter::End()); !fine) return fine;
  if (std::fclose(file_.release()) != 0) return CannotWrite(path_, "check that the disk has room");
  return {};
}

Result<void> DrawingRecorder::Append(std::string_view text) {
  if (text.empty()) return {};
  const bool written = std::fwrite(text.data(), 1, text.size(), file_.get()) == text.size() &&
                       std::fflush(file_.get()) == 0;
  if (!written) return CannotWrite(path_, "check that the disk has room");
  return {};
}

}  // namespace parti::input
