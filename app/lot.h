// Lots: the ground that buildings begin on, from a text (LOT of docs/interfaces.md) or a file.
// Reading files is footprint.h's; what stands on a lot is the rules'.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/lot_property.h"
#include "base/error.h"
#include "grammar/item.h"

namespace parti::app {

/// World coordinates are x = east - origin.x, y up, z = -(north - origin.y), in metres.
struct Lot {
  std::string name;  ///< the file's id for it, else "Lot"
  grammar::Item item;
  Vec2 origin{0, 0};  ///< (east, north) of the world's origin in the file's coordinates; m
  LotProperties properties = {};  ///< what the file says of it besides; rules take values of them
};

/// Lots are no wider than this; wider ones are in other units.
inline constexpr double kWidestLot_m = 1e5;

/// `rect(WIDTH,DEPTH)` with its minimum corner at the origin, `poly(x,z x,z …)` in world
/// coordinates, or the path of a file (docs/lots.md): rings JSONL, GeoJSON in metres, CityJSON.
/// Lots face up whatever their winding. All lots of a file share one origin, whole metres.
///
/// A file's lots that can't be built on are put into `*refused` with their names, and the others
/// are returned; where `refused` is null the first of them is the error.
/// errors  kBadText  with its place;  kBadNumber  not finite, or wider than kWidestLot_m;
///         kDegenerateGeometry, kSelfIntersecting, kNotPlanar  naming the lot;  kNothingMade  no
///         lot in the file;  kFile.
Result<std::vector<Lot>> ParseLots(std::string_view text, std::vector<Error>* refused = nullptr);

/// The same for the text of such a file; `file` is for messages.
Result<std::vector<Lot>> LotsFrom(std::string_view text, std::string_view file,
                                  std::vector<Error>* refused = nullptr);

}  // namespace parti::app
