#include "render/kms_output.h"

#include <xf86drm.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>

namespace parti::render {
namespace {

using Resources = std::unique_ptr<drmModeRes, decltype(&drmModeFreeResources)>;
using Connector = std::unique_ptr<drmModeConnector, decltype(&drmModeFreeConnector)>;
using Encoder = std::unique_ptr<drmModeEncoder, decltype(&drmModeFreeEncoder)>;

bool IsBuiltIn(uint32_t type) {
  return type == DRM_MODE_CONNECTOR_eDP || type == DRM_MODE_CONNECTOR_LVDS ||
         type == DRM_MODE_CONNECTOR_DSI || type == DRM_MODE_CONNECTOR_DPI;
}

std::vector<uint32_t> CrtcsOf(int card, const drmModeRes& resources,
                              const drmModeConnector& connector) {
  std::vector<uint32_t> crtcs;
  uint32_t now = 0;
  for (int i = 0; i < connector.count_encoders; ++i) {
    const Encoder encoder(drmModeGetEncoder(card, connector.encoders[i]), drmModeFreeEncoder);
    if (!encoder) continue;
    if (encoder->encoder_id == connector.encoder_id) now = encoder->crtc_id;
    for (int c = 0; c < resources.count_crtcs; ++c) {
      const bool possible = (encoder->possible_crtcs & (1U << c)) != 0;
      const uint32_t crtc = resources.crtcs[c];
      if (possible && std::find(crtcs.begin(), crtcs.end(), crtc) == crtcs.end()) {
        crtcs.push_back(crtc);
      }
    }
  }
  std::stable_partition(crtcs.begin(), crtcs.end(), [now](uint32_t crtc) { return crtc == now; });
  return crtcs;
}

KmsOutput Describe(int card, const drmModeRes& resources, const drmModeConnector& connector) {
  KmsOutput output;
  output.connector = connector.connector_id;
  const char* type = drmModeGetConnectorTypeName(connector.connector_type);
  output.name =
      std::string(type ? type : "Unknown") + "-" + std::to_string(connector.connector_type_id);
  output.connected = connector.connection == DRM_MODE_CONNECTED;
  output.built_in = IsBuiltIn(connector.connector_type);
  output.size_mm = SizeOf_mm(connector.mmWidth, connector.mmHeight);
  output.modes.assign(connector.modes, connector.modes + connector.count_modes);
  output.crtcs = CrtcsOf(card, resources, connector);
  return output;
}

bool IsUsable(const KmsOutput& output) {
  return output.connected && !output.modes.empty() && !output.crtcs.empty();
}

bool HasPen(const KmsOutput& output, std::span<const Vec2> pens_mm) {
  if (!output.size_mm) return false;
  const auto alike = [](double a, double b) {
    return std::abs(a - b) <= kSamePart * std::max(a, b);
  };
  return std::any_of(pens_mm.begin(), pens_mm.end(), [&](const Vec2& pen) {
    return alike(pen.x, output.size_mm->x) && alike(pen.y, output.size_mm->y);
  });
}

}  // namespace

Result<std::vector<KmsOutput>> ReadKmsOutputs(int card_fd) {
  const Resources resources(drmModeGetResources(card_fd), drmModeFreeResources);
  if (!resources || resources->count_crtcs == 0) {
    return Fail(ErrorCode::kDevice, "the graphics card has no screens");
  }
  std::vector<KmsOutput> outputs;
  for (int i = 0; i < resources->count_connectors; ++i) {
    const Connector connector(drmModeGetConnector(card_fd, resources->connectors[i]),
                              drmModeFreeConnector);
    if (connector) outputs.push_back(Describe(card_fd, *resources, *connector));
  }
  return outputs;
}

std::optional<Vec2> SizeOf_mm(uint32_t width_mm, uint32_t height_mm) {
  const std::pair size(width_mm, height_mm);
  for (const uint32_t unit_mm : {1, 10}) {
    if (size == std::pair(16 * unit_mm, 9 * unit_mm)) return std::nullopt;
    if (size == std::pair(16 * unit_mm, 10 * unit_mm)) return std::nullopt;
  }
  if (width_mm == 0 || height_mm == 0) return std::nullopt;
  return Vec2(width_mm, height_mm);
}

std::optional<size_t> ChooseOutput(std::span<const KmsOutput> outputs, const std::string& wanted,
                                   std::span<const Vec2> pens_mm) {
  std::optional<size_t> best;
  std::pair<bool, bool> best_rank;
  for (size_t i = 0; i < outputs.size(); ++i) {
    if (!IsUsable(outputs[i]) || (!wanted.empty() && outputs[i].name != wanted)) continue;
    const std::pair rank(HasPen(outputs[i], pens_mm), outputs[i].built_in);
    if (best && rank <= best_rank) continue;
    best = i;
    best_rank = rank;
  }
  return best;
}

std::optional<drmModeModeInfo> ChooseMode(const KmsOutput& output) {
  const auto rank = [](const drmModeModeInfo& mode) {
    const bool preferred = (mode.type & DRM_MODE_TYPE_PREFERRED) != 0;
    return std::tuple(preferred, int{mode.hdisplay} * mode.vdisplay, mode.vrefresh);
  };
  const auto best =
      std::max_element(output.modes.begin(), output.modes.end(),
                       [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  if (best == output.modes.end()) return std::nullopt;
  return *best;
}

double ScaleOf(const Vec2& size_px, const std::optional<Vec2>& size_mm) {
  constexpr double kCoarsest = 50, kFinest = 400, kMost = 3, kMmPerInch = 25.4;
  if (!size_mm || !(size_mm->x > 0)) return 1;
  const double px_per_inch = size_px.x / size_mm->x * kMmPerInch;
  if (!(px_per_inch >= kCoarsest && px_per_inch <= kFinest)) return 1;
  return std::clamp(std::round(px_per_inch / 96 * 4) / 4, 1.0, kMost);
}

}  // namespace parti::render
