#include "app/display/card_watch.h"

#include <libudev.h>

#include <cstdlib>

namespace parti::app {

void CardWatch::Unref::operator()(udev* library) const { udev_unref(library); }
void CardWatch::Unref::operator()(udev_monitor* monitor) const { udev_monitor_unref(monitor); }

CardWatch::CardWatch() : library_(udev_new()) {
  if (!library_) return;
  monitor_.reset(udev_monitor_new_from_netlink(library_.get(), "udev"));
  if (!monitor_) return;
  udev_monitor_filter_add_match_subsystem_devtype(monitor_.get(), "drm", nullptr);
  if (udev_monitor_enable_receiving(monitor_.get()) < 0) monitor_.reset();
}
CardWatch::~CardWatch() = default;

int CardWatch::fd() const { return monitor_ ? udev_monitor_get_fd(monitor_.get()) : -1; }

CardWatch::News CardWatch::Look(uint32_t connector) {
  News news = News::kNone;
  while (monitor_) {
    udev_device* device = udev_monitor_receive_device(monitor_.get());
    if (!device) break;
    const char* which = udev_device_get_property_value(device, "CONNECTOR");
    const bool ours = !which || std::strtoul(which, nullptr, 10) == connector;
    if (ours) news = News::kPerhapsOurs;
    if (news == News::kNone) news = News::kOthers;
    udev_device_unref(device);
  }
  return news;
}

}  // namespace parti::app
