// All that comes of one task, in order, or by several threads with the same result.
// Which tasks a lot begins with, and its errors' lot, are rule_derivation.h's.
#pragma once

#include "base/error.h"
#include "grammar/rules/rule_runner.h"

namespace parti::grammar {

class RuleArena;

/// Depth first, on this thread. What is reported and printed goes to `notes`, which may be null; it
/// stays there where something fails. errors  those of RunWithScene.
Result<void> DeriveInOrder(const LotRun& run, ShapeTree* tree, NoteBook* notes, RuleTask first);

/// The same tree and notes, to the byte, with the help of the arena's threads: what still waits
/// after some hundred shapes, and when there is help, is shared out, each shape with a tree of its
/// own, and so again in these. False where something failed or more was made than the limits allow;
/// what to say of it only the order tells, and tree and notes are of no use.
bool DeriveAtOnce(const LotRun& run, ShapeTree* tree, NoteBook* notes, RuleTask first,
                  RuleArena* arena);

}  // namespace parti::grammar
