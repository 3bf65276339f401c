// Hours of use as a seeded stream of moments: mostly what an architect does, and again and again
// what nobody would: broken events, wrong commands, devices that come and go, windows of any size.
#pragma once

#include <array>
#include <string>

#include "base/random.h"
#include "tests/app/soak/soak_target.h"

namespace parti::tests {

/// Equal seeds on equal targets give equal moments. The clock of the events is the mix's own.
class SoakMix {
 public:
  /// `folder` takes the documents and exports that are written.
  SoakMix(uint64_t seed, std::string folder) : random_(seed), folder_(std::move(folder)) {}

  /// Everything a few times: what is only made when it is first needed (shaders, caches) is there
  /// afterwards.
  void WarmUp(SoakTarget* target);
  /// What happens next; 1 to 4 s pass.
  void Moment(SoakTarget* target);

  double clock_s() const { return clock_s_; }
  int moments() const { return moments_; }

 private:
  struct Share;
  static const std::array<Share, 10> kShares;

  void Do(const Share& share, SoakTarget* target);
  void Plug(SoakTarget* target);
  void DrawOnBuilding(SoakTarget* target);
  void Scribble(SoakTarget* target);
  void DrawLine(SoakTarget* target, const Vec2& from_mm, const Vec2& to_mm);
  void BrokenEvent(SoakTarget* target);
  void Touch(SoakTarget* target);
  void SoundCommand(SoakTarget* target);
  void WrongCommand(SoakTarget* target);
  void Look(SoakTarget* target);
  void Document(SoakTarget* target);
  void Resize(SoakTarget* target);
  void Tidy(SoakTarget* target) const;

  int Below(int n) { return static_cast<int>(random_.Next() % static_cast<uint64_t>(n)); }
  PenEvent Pen(PenEvent::Kind kind, const Vec2& at_mm);

  Random random_;
  std::string folder_;
  double clock_s_ = 0;
  int moments_ = 0;
  int device_ = -1;  // of the pen; -1: unplugged
  int devices_ = 0;  // so far
};

}  // namespace parti::tests
