// Writes a drawing to a file while it is drawn, so that a kill or a full disk leaves a readable
// prefix. Not responsible for where events come from.
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "input/drawing.h"

namespace parti::input {

/// Times in the file are seconds since the first event, in whole microseconds.
/// Property: what is in the file after each call is what was added, and ReadDrawing reads it all.
class DrawingRecorder {
 public:
  /// Makes the file anew, with its first line.
  /// errors  kFile  it can't be written.
  static Result<DrawingRecorder> Create(const std::string& path);

  /// Appends events; they are in the file when this returns.
  /// errors  kFile  the disk is full;  those of DrawingRules.
  Result<void> Add(const std::vector<InputEvent>& events);

  /// Appends a command at this place. errors as Add.
  Result<void> AddCommand(std::string_view text);

  /// Appends the last line and closes. errors  kFile.  Without it the file reads as cut off.
  Result<void> Finish();

  int strokes() const { return writer_.strokes(); }
  /// Pen and touch events so far.
  size_t reports() const { return reports_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  DrawingRecorder(std::string path, std::FILE* file) : path_(std::move(path)), file_(file) {}
  Result<void> Append(std::string_view text);

  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  DrawingWriter writer_;
  std::optional<double> start_s_;
  size_t reports_ = 0;
};

}  // namespace parti::input
