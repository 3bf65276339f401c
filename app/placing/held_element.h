// Which of the elements that are placed by hand is in hand, and which other it is arranged by: by
// their names, so that both outlive the commands that move them.
// What is done with them is layer_arranging.h's.
#pragma once

#include <optional>
#include <string>

#include "app/placing/placed_layers.h"

namespace parti::app {

/// A value.
class HeldElement {
 public:
  /// Takes one in hand. It is arranged by the one that was before, if that lies beside it; else by
  /// the uppermost that does.
  void Hold(const PlacedLayers& placed, size_t layer);
  /// Arranges it by the next of LayersBeside, after the last by the first.
  void TakeNext(const PlacedLayers& placed);
  void LetGo() { *this = {}; }

  /// Nothing where none is in hand, or the face has it no more.
  std::optional<size_t> In(const PlacedLayers& placed) const;
  /// What it is arranged by: the face where nothing else is left. It must be in hand.
  grammar::InteractiveLayer ByIn(const PlacedLayers& placed) const;

 private:
  std::string name_;
  size_t nth_ = 0;  // of those of this name: a face may have one rule's element several times
  std::string by_;
};

}  // namespace parti::app
