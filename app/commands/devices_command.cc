// `parti devices`: the pens, touch screens, mice and keyboards that libinput sees.
#include <fmt/format.h>

#include <memory>
#include <utility>
#include <vector>

#include "app/commands/commands.h"
#include "base/json.h"
#include "input/libinput_source.h"

namespace parti::app {
namespace {

struct Options {
  std::vector<std::string> nodes;
  bool json = false;
};

struct Found {
  std::string node;
  DeviceFacts facts;
};

Result<std::vector<Found>> Find(const std::vector<std::string>& nodes) {
  const input::LibinputOptions options{.mice_and_keys = true};
  auto source = nodes.empty() ? input::LibinputSource::OpenSeat("seat0", options)
                              : input::LibinputSource::OpenDevices(nodes, options);
  if (!source) return Fail(source);
  const auto events = source->Dispatch();
  if (!events) return Fail(events);
  std::vector<Found> found;
  for (const InputEvent& event : *events) {
    if (const auto* device = std::get_if<DeviceEvent>(&event)) {
      found.push_back({source->node(device->device), device->facts});
    }
  }
  if (found.empty()) return tl::unexpected(source->WhyNothing());
  return found;
}

Json JsonOf(const Found& found) {
  const DeviceFacts& facts = found.facts;
  Json json{{"node", found.node},
            {"name", facts.name},
            {"vendor", fmt::format("{:04x}", facts.vendor)},
            {"product", fmt::format("{:04x}", facts.product)},
            {"size_mm", nullptr},
            {"pen", facts.has_pen},
            {"touch", facts.has_touch},
            {"pressure", facts.has_pressure},
            {"tilt", facts.has_tilt},
            {"distance", facts.has_distance},
            {"eraser", facts.has_eraser},
            {"pointer", facts.has_pointer},
            {"keys", facts.has_keys},
            {"display", facts.has_display}};
  if (facts.size_mm) json["size_mm"] = {facts.size_mm->x, facts.size_mm->y};
  return json;
}

std::string LineOf(const Found& found) {
  const DeviceFacts& facts = found.facts;
  std::string kinds;
  for (const auto& [has, name] : {std::pair(facts.has_pen, "pen"),
                                  {facts.has_touch, "touch"},
                                  {facts.has_pointer, "mouse"},
                                  {facts.has_keys, "keys"},
                                  {facts.has_display, "display"},
                                  {facts.has_pressure, "pressure"},
                                  {facts.has_tilt, "tilt"},
                                  {facts.has_distance, "distance"},
                                  {facts.has_eraser, "eraser"}}) {
    if (has) kinds += (kinds.empty() ? "" : ", ") + std::string(name);
  }
  if (kinds.empty()) kinds = "buttons";
  std::string line = fmt::format("{}  {} ({:04x}:{:04x}): {}", found.node, facts.name, facts.vendor,
                                 facts.product, kinds);
  if (facts.size_mm)
    line += fmt::format(", {:.0f} x {:.0f} mm", facts.size_mm->x, facts.size_mm->y);
  return line;
}

int List(const Options& options) {
  const auto found = Find(options.nodes);
  if (!found) return Report(found.error());
  Json devices = Json::array();
  std::string lines;
  for (const Found& device : *found) {
    if (options.json) {
      devices.push_back(JsonOf(device));
    } else {
      lines += LineOf(device) + '\n';
    }
  }
  // A device's name may hold any bytes; what is not UTF-8 is shown as such, not thrown about.
  if (options.json) {
    const Json answer{{"devices", devices}};
    lines = answer.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
  }
  return PrintAnswer(lines);
}

}  // namespace

void AddDevicesCommand(CLI::App& app, Run* run) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("devices", "List pen tablets, touch screens, mice and keyboards");
  command->footer("Example: parti devices --json");
  command->add_option("--device", options->nodes, "Only these nodes, as /dev/input/event5");
  command->add_flag("--json", options->json, "One JSON object instead of a line for each");
  command->callback([options, run] { *run = [options] { return List(*options); }; });
}

}  // namespace parti::app
