// Values of a document as text and bytes, losslessly: every double comes back as it was.
// What a document is made of, and where it is kept, stands in document.h.
#pragma once

#include <string>
#include <string_view>

#include "app/lot.h"
#include "base/camera.h"
#include "base/error.h"
#include "base/stroke.h"

namespace parti::app {

/// {"eye":[…],"target":[…],"up":[…],"vfov_deg":…,"width":…,"height":…}
std::string JsonOf(const Camera& camera);
/// errors  kBadText, kBadNumber, and what Validate refuses. Reads sketch tasks' cameras too.
Result<Camera> CameraFrom(std::string_view json);

/// {"origin","x","y","z","size","facing","rings" (absent: the whole rectangle)}
std::string JsonOf(const grammar::Item& planar);
Result<grammar::Item> PlanarItemFrom(std::string_view json);

/// Little-endian doubles x, y, t_s, pressure (NaN: none), sample by sample.
std::string BytesOf(const Stroke& stroke);
/// errors  kDamagedFile  a length that is no multiple of a sample, or a number that is not finite.
Result<Stroke> StrokeFromBytes(std::string_view bytes);

}  // namespace parti::app
