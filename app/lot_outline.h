// Strokes drawn on the ground as one closed chain of straight and curved pieces: the first stage of
// lots from strokes. Not responsible for right angles and round numbers (lot_squaring.h).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "app/lot_from_stroke.h"
#include "app/session_state.h"

namespace parti::app {

/// A part of an outline between two of its corners.
struct OutlinePiece {
  bool straight = true;
  std::vector<Vec2> points;  ///< n >= 2 on the ground, in order: x and z of the world; m
};

/// strokes  each in its own view, in the order drawn; a chain may begin anywhere, run either way,
///          and be made of several strokes that meet.
/// returns  pieces in order around; each begins where the one before it ends, up to the hand's
/// gaps.
///          Straight neighbours that go on in one direction are one piece; hooks are left out.
/// errors   kTooShort  a tap, or no strokes;  kBadNumber  a sample that is not finite;
///          kGrazingView  the ground is seen too much edge on, or not at all, where it was drawn;
///          kNoFit  the ends don't meet yet;  kSelfIntersecting  it crosses itself.
Result<std::vector<OutlinePiece>> ClosedOutline(
    std::span<const std::shared_ptr<const DrawnStroke>> strokes, const LotParameters& parameters);

/// A least-squares line through a straight piece, by orthogonal distances; its ends are where the
/// piece's are nearest to it. The first and last tenth of the points, which may have gone round a
/// corner, count for the ends alone.
Segment2 LineOf(const OutlinePiece& piece);

/// `count` points at equal distances along a path, its first and last included; around it where it
/// is closed (then the last is not repeated). n >= 2; count >= 2.
std::vector<Vec2> EvenPoints(const std::vector<Vec2>& path, size_t count, bool closed);

}  // namespace parti::app
