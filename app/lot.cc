#include "app/lot.h"

#include <fmt/format.h>

#include <cmath>

#include "app/footprint.h"
#include "base/text_file.h"
#include "grammar/lexer.h"

namespace parti::app {
namespace {

using grammar::Lexer;
using grammar::Token;

constexpr std::string_view kPlace = "LOT";  // stands for the file in messages about the text
constexpr std::string_view kHint =
    "rect(WIDTH,DEPTH), poly(x,z x,z …), or a GeoJSON, CityJSON or rings JSONL file";

using Rings = std::vector<std::vector<Vec3>>;

Result<Lot> LotFrom(const Rings& rings, std::string name, const Vec2& origin) {
  Vec3 low(1e300), high(-1e300);
  for (const Vec3& p : rings.front()) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double width = std::max(high.x - low.x, high.z - low.z);
  if (width > kWidestLot_m) {
    return Fail(ErrorCode::kBadNumber, fmt::format("a lot is {:.6g} m wide", width),
                fmt::format("lots are in metres, up to {:.6g}", kWidestLot_m));
  }
  const Vec3 up(0, 1, 0);
  auto item = grammar::PlanarFrom(rings, &up);
  if (!item) return Fail(item);
  return Lot{std::move(name), std::move(*item), origin};
}

Result<double> ReadNumber(Lexer* lexer) {
  const bool negative = lexer->Accept('-');
  if (!lexer->At(Token::Kind::kNumber)) {
    return tl::unexpected<Error>(lexer->Unexpected("a number of metres"));
  }
  const double number = lexer->Next().number;
  return negative ? -number : number;
}

/// "3,4"
Result<Vec2> ReadPair(Lexer* lexer) {
  const auto first = ReadNumber(lexer);
  if (!first) return Fail(first);
  const auto comma = lexer->Expect(',', "','");
  if (!comma) return Fail(comma);
  const auto second = ReadNumber(lexer);
  if (!second) return Fail(second);
  return Vec2(*first, *second);
}

Result<Rings> ReadRect(Lexer* lexer) {
  const Token start = lexer->Peek();
  const auto size = ReadPair(lexer);
  if (!size) return Fail(size);
  if (size->x > 0 && size->y > 0) {
    // Counter-clockwise from above (z is south), so that the first edge is the scope's x.
    return Rings{{{0, 0, size->y}, {size->x, 0, size->y}, {size->x, 0, 0}, {0, 0, 0}}};
  }
  Error error{ErrorCode::kDegenerateGeometry, "a lot without area",
              "give a width and a depth above 0, in metres"};
  return tl::unexpected<Error>(lexer->Located(error, start.offset, lexer->previous_end()));
}

Result<Rings> ReadPoly(Lexer* lexer) {
  Rings rings(1);
  while (!lexer->At(')') && !lexer->At(Token::Kind::kEnd)) {
    const auto point = ReadPair(lexer);
    if (!point) return Fail(point);
    rings[0].emplace_back(point->x, 0, point->y);
  }
  if (rings[0].size() >= 3) return rings;
  return tl::unexpected<Error>(lexer->ErrorAt(lexer->Peek(), ErrorCode::kDegenerateGeometry,
                                              "a polygon has at least 3 corners",
                                              "poly(0,0 20,0 20,10)"));
}

/// rect(…) or poly(…), after its word.
Result<std::vector<Lot>> ReadWritten(Lexer lexer, std::string_view word) {
  lexer.Next();
  const auto rings = word == "rect" ? ReadRect(&lexer) : ReadPoly(&lexer);
  if (!rings) return Fail(rings);
  const auto closed = lexer.Expect(')', "')'");
  if (!closed) return Fail(closed);
  if (!lexer.At(Token::Kind::kEnd)) {
    return tl::unexpected<Error>(lexer.Unexpected("the end of the lot"));
  }
  auto lot = LotFrom(*rings, "Lot", Vec2(0));
  if (lot) return std::vector<Lot>{std::move(*lot)};
  return tl::unexpected<Error>(lexer.Located(lot.error(), 0, lexer.previous_end()));
}

/// The south-west corner and the lowest ground of all, in whole metres.
Vec3 OriginOf(const std::vector<Footprint>& footprints) {
  Vec3 low(1e300);
  for (const Footprint& footprint : footprints) {
    low.z = std::min(low.z, footprint.height_m);
    for (const Vec2& p : footprint.rings.front()) {
      low.x = std::min(low.x, p.x);
      low.y = std::min(low.y, p.y);
    }
  }
  return glm::floor(low);
}

Result<Lot> LotFrom(const Footprint& footprint, const Vec3& origin) {
  Rings rings;
  for (const auto& points : footprint.rings) {
    auto& ring = rings.emplace_back();
    for (const Vec2& p : points) {
      ring.emplace_back(p.x - origin.x, footprint.height_m - origin.z, -(p.y - origin.y));
    }
  }
  auto lot = LotFrom(rings, footprint.name, Vec2(origin));
  if (!lot) return lot;
  if (footprint.street_deg) lot->item.street_deg = static_cast<float>(*footprint.street_deg);
  lot->properties = footprint.properties;
  return lot;
}

/// Those that can be built on. The others are taken out of the footprints, and what is wrong with
/// them is added to `bad`.
std::vector<Lot> LotsAt(const Vec3& origin, std::string_view file,
                        std::vector<Footprint>* footprints, std::vector<Error>* bad) {
  std::vector<Lot> lots;
  std::erase_if(*footprints, [&](const Footprint& footprint) {
    auto lot = LotFrom(footprint, origin);
    if (lot) {
      lots.push_back(std::move(*lot));
      return false;
    }
    Error& error = bad->emplace_back(lot.error());
    error.message = fmt::format("{}: lot '{}': {}", file, footprint.name, error.message);
    return true;
  });
  return lots;
}

}  // namespace

Result<std::vector<Lot>> LotsFrom(std::string_view text, std::string_view file,
                                  std::vector<Error>* refused) {
  std::vector<Error> bad;
  auto footprints = FootprintsFrom(text, file, refused != nullptr ? &bad : nullptr);
  if (!footprints) return Fail(footprints);
  for (Error& error : bad) error.message = fmt::format("{}: {}", file, error.message);
  std::vector<Lot> lots;
  for (size_t known = SIZE_MAX; known != bad.size() && !footprints->empty();) {
    known = bad.size();  // once more without bad ones, as if they did not stand in the file
    lots = LotsAt(OriginOf(*footprints), file, &*footprints, &bad);
  }
  if (lots.empty() || (refused == nullptr && !bad.empty())) {
    return tl::unexpected<Error>(bad.front());
  }
  if (refused != nullptr) *refused = std::move(bad);
  return lots;
}

Result<std::vector<Lot>> ParseLots(std::string_view text, std::vector<Error>* refused) {
  Lexer lexer(text, kPlace);
  const Token word = lexer.Next();
  if (word.kind == Token::Kind::kName && lexer.At('(')) {
    if (word.text == "rect" || word.text == "poly") return ReadWritten(lexer, word.text);
    return tl::unexpected<Error>(lexer.ErrorAt(word, ErrorCode::kUnknownName,
                                               fmt::format("there is no lot '{}'", word.text),
                                               std::string(kHint)));
  }
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return Fail(ErrorCode::kBadText, "no lot is given", std::string(kHint));
  }
  const std::string path(text);
  const auto contents = ReadFile(path);
  if (!contents) return Fail(contents);
  return LotsFrom(*contents, path, refused);
}

}  // namespace parti::app
