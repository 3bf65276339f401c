#include "app/document_record.h"

#include <fmt/format.h>

#include <cstdint>

#include "app/document_values.h"
#include "app/lot_values.h"
#include "base/json.h"

namespace parti::app {
namespace {

Json NumbersOf(const std::vector<std::shared_ptr<const DrawnStroke>>& strokes) {
  Json numbers = Json::array();
  for (const auto& drawn : strokes) numbers.push_back(drawn->number);
  return numbers;
}

/// A name that is no UTF-8 loses what is not, instead of the document.
std::string Dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json RefJson(const ShapeRef& ref) { return Json::array({ref.lot, ref.shape}); }

/// Only what there is: most states have no sketch and no selection.
Json SketchJson(const SessionRecord& record) {
  Json json = Json::object();
  if (!record.strokes.empty()) json["strokes"] = NumbersOf(record.strokes);
  if (!record.unread.empty()) json["unread"] = NumbersOf(record.unread);
  if (record.query) json["query"] = grammar::TextOf(*record.query);
  if (record.target) json["target"] = RefJson(*record.target);
  for (const ShapeRef& ref : record.selection) json["selection"].push_back(RefJson(ref));
  if (!record.in_hand.empty()) json["in_hand"] = record.in_hand;
  if (record.just_made) json["just_made"] = true;
  return json;
}

/// A list of whole numbers from 0 to 2^32 - 1 under a key; empty where there is none.
Result<std::vector<uint32_t>> Numbers(const Json& object, const char* key) {
  std::vector<uint32_t> numbers;
  const auto found = object.find(key);
  if (found == object.end()) return numbers;
  if (!found->is_array()) return Fail(ErrorCode::kBadText, fmt::format("{} is not a list", key));
  for (const Json& number : *found) {
    if (!number.is_number_unsigned() || number.get<uint64_t>() > UINT32_MAX) {
      return Fail(ErrorCode::kBadText, fmt::format("{} has what is not a number in it", key));
    }
    numbers.push_back(number.get<uint32_t>());
  }
  return numbers;
}

Result<ShapeRef> RefFrom(const Json& pair) {
  const auto numbers = Numbers({{"shape", pair}}, "shape");
  if (!numbers) return Fail(numbers);
  if (numbers->size() != 2) return Fail(ErrorCode::kBadText, "a shape is not two numbers");
  return ShapeRef{(*numbers)[0], (*numbers)[1]};
}

Result<std::vector<std::shared_ptr<const DrawnStroke>>> StrokesOf(
    const Json& sketch, const char* key, const RecordReader::Strokes& strokes) {
  const auto numbers = Numbers(sketch, key);
  if (!numbers) return Fail(numbers);
  std::vector<std::shared_ptr<const DrawnStroke>> list;
  for (const uint32_t number : *numbers) {
    const auto found = strokes.find(number);
    if (found == strokes.end()) {
      return Fail(ErrorCode::kDamagedFile, fmt::format("stroke {} is missing", number));
    }
    list.push_back(found->second);
  }
  return list;
}

Result<void> ReadShapesInto(const Json& json, SessionRecord* record) {
  if (const auto target = json.find("target"); target != json.end()) {
    const auto ref = RefFrom(*target);
    if (!ref) return Fail(ref);
    record->target = *ref;
  }
  for (const Json& pair : json.value("selection", Json::array())) {
    const auto ref = RefFrom(pair);
    if (!ref) return Fail(ref);
    record->selection.push_back(*ref);
  }
  return {};
}

Result<void> ReadSketchInto(std::string_view text, const RecordReader::Strokes& strokes,
                            SessionRecord* record) {
  const auto json = ParseJson(text);
  if (!json) return Fail(json);
  if (!json->is_object()) return Fail(ErrorCode::kBadText, "a sketch is not an object");
  auto drawn = StrokesOf(*json, "strokes", strokes);
  if (!drawn) return Fail(drawn);
  record->strokes = std::move(*drawn);
  auto unread = StrokesOf(*json, "unread", strokes);
  if (!unread) return Fail(unread);
  record->unread = std::move(*unread);
  if (const auto query = json->find("query"); query != json->end() && query->is_string()) {
    auto parsed = grammar::ParseQuery(query->get<std::string>());
    if (!parsed) return Fail(parsed);
    record->query = std::move(*parsed);
  }
  const auto path = Numbers(*json, "in_hand");
  if (!path) return Fail(path);
  record->in_hand.assign(path->begin(), path->end());
  record->just_made = json->contains("just_made");
  return ReadShapesInto(*json, record);
}

Result<void> ReadViewsInto(std::string_view text, SessionRecord* record) {
  const auto json = ParseJson(text);
  if (!json) return Fail(json);
  for (const Json& entry : *json) {
    if (!entry.is_object() || !entry.contains("camera") || !entry.contains("name") ||
        !entry["name"].is_string()) {
      return Fail(ErrorCode::kBadText, "a view has no name or no camera");
    }
    const auto camera = CameraFrom(entry["camera"].dump());
    if (!camera) return Fail(camera);
    record->views.push_back({entry["name"].get<std::string>(), *camera});
  }
  return {};
}

Result<SharedText> TextIn(const StateParts& parts, const char* name) {
  const auto found = parts.find(name);
  if (found != parts.end()) return found->second;
  return Fail(ErrorCode::kDamagedFile, fmt::format("a state has no {}", name));
}

}  // namespace

std::string LotsText(const std::vector<Lot>& lots) {
  Json list = Json::array();
  for (const Lot& lot : lots) {
    list.push_back({{"name", lot.name},
                    {"item", Json::parse(JsonOf(lot.item))},
                    {"origin", {lot.origin.x, lot.origin.y}}});
    if (!lot.properties.empty()) list.back()["properties"] = JsonOf(lot.properties);
  }
  return Dumped(list);
}

Result<std::vector<Lot>> LotsFrom(std::string_view text) {
  const auto json = ParseJson(text);
  if (!json) return Fail(json);
  if (!json->is_array()) return Fail(ErrorCode::kBadText, "the lots are not a list");
  std::vector<Lot> lots;
  for (const Json& entry : *json) {
    if (!entry.is_object() || !entry.contains("item") || !entry.contains("origin")) {
      return Fail(ErrorCode::kBadText, "a lot has no item or no origin");
    }
    auto item = PlanarItemFrom(entry["item"].dump());
    if (!item) return Fail(item);
    const Json& origin = entry["origin"];
    if (!origin.is_array() || origin.size() != 2) {
      return Fail(ErrorCode::kBadText, "a lot has no origin");
    }
    const auto x = NumberFrom(origin[0], "origin"), y = NumberFrom(origin[1], "origin");
    if (!x) return Fail(x);
    if (!y) return Fail(y);
    const auto name = entry.find("name");
    const bool named = name != entry.end() && name->is_string();
    lots.push_back({named ? name->get<std::string>() : "Lot",
                    std::move(*item),
                    {*x, *y},
                    PropertiesIn(entry.value("properties", Json()))});
  }
  return lots;
}

StateParts PartsOf(const SessionRecord& record) {
  const auto text = [](std::string body) {
    return std::make_shared<const std::string>(std::move(body));
  };
  StateParts parts{{"lots", text(LotsText(record.ground->lots))},
                   {"rules", text(grammar::TextOf(*record.rules))},
                   {"view", text(JsonOf(record.camera))}};
  const Json sketch = SketchJson(record);
  if (record.ground->source) parts["source"] = text(TextOf(*record.ground->source));
  if (!sketch.empty()) parts["sketch"] = text(Dumped(sketch));
  Json views = Json::array();
  for (const NamedView& view : record.views) {
    views.push_back({{"name", view.name}, {"camera", Json::parse(JsonOf(view.camera))}});
  }
  if (!views.empty()) parts["views"] = text(Dumped(views));
  return parts;
}

Result<std::shared_ptr<const Ground>> RecordReader::Lots(const StateParts& parts) {
  const auto text = TextIn(parts, "lots");
  if (!text) return Fail(text);
  const auto source = parts.find("source");
  const SharedText source_text = source != parts.end() ? source->second : nullptr;
  auto& known = grounds_[{*text, source_text}];
  if (known) return known;
  auto lots = LotsFrom(**text);
  if (!lots) return Fail(lots);
  if (!source_text) return known = GroundOf(std::move(*lots));
  auto rules = RuleSourceFrom(*source_text);
  if (!rules) return Fail(rules);
  // Derived where it is needed: most states are never gone back to.
  return known = std::make_shared<const Ground>(Ground{
             std::move(*lots), {}, std::make_shared<const RuleSource>(std::move(*rules)), nullptr});
}

Result<std::shared_ptr<const grammar::Trees>> RecordReader::Rules(const StateParts& parts) {
  const auto text = TextIn(parts, "rules");
  if (!text) return Fail(text);
  auto& known = rules_[*text];
  if (known) return known;
  auto trees = grammar::ParseTrees(**text);
  if (!trees) return tl::unexpected<Error>(trees.error().front());
  return known = std::make_shared<const grammar::Trees>(std::move(*trees));
}

Result<SessionRecord> RecordReader::Read(const StateParts& parts) {
  SessionRecord record;
  auto ground = Lots(parts);
  if (!ground) return Fail(ground);
  record.ground = std::move(*ground);
  auto rules = Rules(parts);
  if (!rules) return Fail(rules);
  record.rules = std::move(*rules);
  const auto view = TextIn(parts, "view");
  if (!view) return Fail(view);
  const auto camera = CameraFrom(**view);
  if (!camera) return Fail(camera);
  record.camera = *camera;
  if (const auto sketch = parts.find("sketch"); sketch != parts.end()) {
    if (auto done = ReadSketchInto(*sketch->second, strokes_, &record); !done) return Fail(done);
  }
  if (const auto views = parts.find("views"); views != parts.end()) {
    if (auto done = ReadViewsInto(*views->second, &record); !done) return Fail(done);
  }
  return record;
}

}  // namespace parti::app
