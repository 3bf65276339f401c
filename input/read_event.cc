// The reader of one event: see event_text.h.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "input/event_names.h"
#include "input/event_text.h"
#include "input/line_scanner.h"

namespace parti::input {
namespace {

constexpr std::array<std::string_view, 5> kEventWords{"device", "pen", "touch", "key", "scroll"};
constexpr int kAnyInt = std::numeric_limits<int>::max();

/// What every event's line begins with: `WORD DEVICE KIND TIME`.
struct Head {
  int device = 0;
  size_t kind = 0;
  double t_s = 0;
};

template <size_t n>
Result<Head> ReadHead(LineScanner& line, const std::array<std::string_view, n>& kinds) {
  Head head;
  const auto number = line.Next("the device's number");
  if (!number) return Fail(number);
  const auto device = IntegerIn(line, *number, 0, kAnyInt);
  if (!device) return Fail(device);
  head.device = *device;
  const auto kind = line.Next("the kind of event");
  if (!kind) return Fail(kind);
  const auto index = IndexOf(kinds, kind->text);
  if (!index) {
    return line.FailAt(*kind, "an unknown kind of event",
                       fmt::format("one of {} is wanted", fmt::join(kinds, ", ")));
  }
  head.kind = *index;
  const auto time = line.Next("the time");
  if (!time) return Fail(time);
  const auto t_s = NumberIn(line, *time);
  if (!t_s) return Fail(t_s);
  head.t_s = *t_s;
  return head;
}

Result<Vec2> ReadPair(LineScanner& line, std::string_view what) {
  const auto word = line.Next(what);
  if (!word) return Fail(word);
  return PairIn(line, *word);
}

/// Stores a value, or passes on why there is none.
template <typename From, typename To>
Result<void> Store(const Result<From>& value, To* to) {
  if (!value) return Fail(value);
  *to = static_cast<To>(*value);
  return {};
}

std::vector<std::string_view> FeatureWords() {
  std::vector<std::string_view> words;
  for (const Feature& feature : kFeatures) words.push_back(feature.word);
  return words;
}

Result<void> ReadAttribute(const LineScanner& line, const Attribute& attribute,
                           DeviceFacts* facts) {
  const std::string_view key = attribute.key.text;
  if (!attribute.has_value) {
    for (const Feature& feature : kFeatures) {
      if (feature.word != key) continue;
      facts->*feature.flag = true;
      return {};
    }
  } else if (key == "name") {
    return Store(UnquotedIn(line, attribute.value), &facts->name);
  } else if (key == "vendor") {
    return Store(HexIn(line, attribute.value), &facts->vendor);
  } else if (key == "product") {
    return Store(HexIn(line, attribute.value), &facts->product);
  } else if (key == "size_mm") {
    return Store(PairIn(line, attribute.value), &facts->size_mm);
  } else if (key == "view_px_per_mm") {
    return Store(NumberIn(line, attribute.value), &facts->view_px_per_mm);
  }
  return line.FailAt(attribute.key, "an unknown device fact",
                     fmt::format("known are name= vendor= product= size_mm= view_px_per_mm= {}",
                                 fmt::join(FeatureWords(), " ")));
}

Result<void> ReadAttribute(const LineScanner& line, const Attribute& attribute, PenEvent* event) {
  const std::string_view key = attribute.key.text;
  const Word& value = attribute.value;
  if (!attribute.has_value) {
    if (key == "pressed") {
      event->pressed = true;
      return {};
    }
  } else if (key == "p") {
    return Store(NumberIn(line, value), &event->pressure);
  } else if (key == "d") {
    return Store(NumberIn(line, value), &event->distance);
  } else if (key == "tilt") {
    return Store(PairIn(line, value), &event->tilt_deg);
  } else if (key == "button") {
    return Store(IntegerIn(line, value, 0, kAnyInt), &event->button);
  } else if (key == "tool") {
    if (const auto tool = IndexOf(kPenTools, value.text)) {
      event->tool = static_cast<PenTool>(*tool);
      return {};
    }
    return line.FailAt(value, "an unknown tool",
                       fmt::format("one of {} is wanted", fmt::join(kPenTools, ", ")));
  }
  return line.FailAt(attribute.key, "an unknown pen axis",
                     "known are p= d= tilt= tool= button= pressed");
}

Result<void> ReadAttribute(const LineScanner& line, const Attribute& attribute, TouchEvent* event) {
  if (attribute.key.text == "finger" && attribute.has_value) {
    return Store(IntegerIn(line, attribute.value, 0, kAnyInt), &event->finger);
  }
  return line.FailAt(attribute.key, "an unknown fact of a touch", "known is finger=");
}

Result<void> ReadAttribute(const LineScanner& line, const Attribute& attribute, KeyEvent* event) {
  const std::string_view key = attribute.key.text;
  if (key == "text" && attribute.has_value) {
    return Store(UnquotedIn(line, attribute.value), &event->text);
  }
  if (key == "repeat" && !attribute.has_value) {
    event->repeat = true;
    return {};
  }
  return line.FailAt(attribute.key, "an unknown fact of a key", "known are text= and repeat");
}

/// The rest of a line as attributes, none of them twice.
template <typename Value>
Result<void> ReadAttributes(LineScanner& line, Value* value) {
  std::vector<std::string_view> seen;
  while (!line.AtEnd()) {
    const auto attribute = line.NextAttribute();
    if (!attribute) return Fail(attribute);
    const std::string_view key = attribute->key.text;
    if (std::find(seen.begin(), seen.end(), key) != seen.end()) {
      return line.FailAt(attribute->key, fmt::format("{} is given twice", key));
    }
    seen.push_back(key);
    if (auto fine = ReadAttribute(line, *attribute, value); !fine) return fine;
  }
  return {};
}

Result<InputEvent> ReadDevice(LineScanner& line) {
  const auto head = ReadHead(line, kDeviceKinds);
  if (!head) return Fail(head);
  DeviceEvent event{static_cast<DeviceEvent::Kind>(head->kind), head->t_s, head->device, {}};
  if (auto fine = ReadAttributes(line, &event.facts); !fine) return Fail(fine);
  return event;
}

Result<InputEvent> ReadPen(LineScanner& line) {
  const auto head = ReadHead(line, kPenKinds);
  if (!head) return Fail(head);
  PenEvent event;
  event.kind = static_cast<PenEvent::Kind>(head->kind);
  event.device = head->device;
  event.t_s = head->t_s;
  auto fine = Store(ReadPair(line, "the position"), &event.position_mm);
  if (fine) fine = ReadAttributes(line, &event);
  if (!fine) return Fail(fine);
  return event;
}

Result<InputEvent> ReadTouch(LineScanner& line) {
  const auto head = ReadHead(line, kTouchKinds);
  if (!head) return Fail(head);
  TouchEvent event;
  event.kind = static_cast<TouchEvent::Kind>(head->kind);
  event.device = head->device;
  event.t_s = head->t_s;
  auto fine = Store(ReadPair(line, "the position"), &event.position_mm);
  if (fine) fine = ReadAttributes(line, &event);
  if (!fine) return Fail(fine);
  return event;
}

Result<InputEvent> ReadKey(LineScanner& line) {
  const auto head = ReadHead(line, kKeyKinds);
  if (!head) return Fail(head);
  const auto word = line.Next("the key's code");
  if (!word) return Fail(word);
  const auto code = IntegerIn(line, *word, 0, kAnyInt);
  if (!code) return Fail(code);
  KeyEvent event{head->device, head->t_s, static_cast<uint32_t>(*code), head->kind == 1};
  if (auto fine = ReadAttributes(line, &event); !fine) return Fail(fine);
  return event;
}

Result<InputEvent> ReadScroll(LineScanner& line) {
  const auto head = ReadHead(line, kScrollKinds);
  if (!head) return Fail(head);
  ScrollEvent event{.device = head->device, .t_s = head->t_s};
  auto fine = Store(ReadPair(line, "the position"), &event.position_mm);
  if (fine) fine = Store(ReadPair(line, "the number of steps"), &event.steps);
  if (!fine) return Fail(fine);
  if (!line.AtEnd()) return line.FailAt(line.Rest(), "words after the steps");
  return event;
}

}  // namespace

bool IsEventWord(std::string_view word) { return IndexOf(kEventWords, word).has_value(); }

Result<InputEvent> ReadEvent(std::string_view text) {
  LineScanner line(text);
  const auto word = line.Next("the kind of device");
  if (!word) return Fail(word);
  if (word->text == "device") return ReadDevice(line);
  if (word->text == "pen") return ReadPen(line);
  if (word->text == "touch") return ReadTouch(line);
  if (word->text == "key") return ReadKey(line);
  if (word->text == "scroll") return ReadScroll(line);
  return line.FailAt(*word, "an unknown kind of line",
                     "lines begin with device, pen, touch, key, scroll, after or end");
}

}  // namespace parti::input
