// Finds the graphics card whose screen Parti may use.
// Not responsible for using it (render/kms_screen.h).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/display/seat.h"

namespace parti::app {

/// An open card, its DRM master being us; given back to the seat when the value goes.
class Card {
 public:
  Card(Seat* seat, int fd, std::string path) : seat_(seat), fd_(fd), path_(std::move(path)) {}
  ~Card() { seat_->Close(fd_); }
  Card(const Card&) = delete;
  Card& operator=(const Card&) = delete;

  int fd() const { return fd_; }
  const std::string& path() const { return path_; }

 private:
  Seat* seat_;
  int fd_;
  std::string path_;
};

/// The nodes of the cards that the kernel knows, in order.
/// errors  kDevice  there is none.
Result<std::vector<std::string>> CardPaths();

/// The card of that path, or of any: the first that has a screen plugged in, else the first that
/// could have one. The seat outlives the card.
/// errors  kDevice  there is none, or none may be used: says why for the first, with the remedy.
Result<std::unique_ptr<Card>> OpenCard(Seat* seat, const std::string& path);

}  // namespace parti::app
