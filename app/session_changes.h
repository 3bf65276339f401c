// What each command does to a state, one function for each; After (session_commands.h) asks the
// one that a command wants. They are part of it, and not for others to call.
#pragma once

#include "app/command.h"
#include "app/node_path.h"
#include "app/session_options.h"
#include "app/session_state.h"

namespace parti::app {

/// The state with other rules. A node that was edited has to work; the others may have problems.
/// errors  those of grammar::Derive, and of the node that was edited.
Result<SessionState> WithRules(SessionState state, grammar::Trees trees,
                               const NodePath& edited = {});

/// What a building stands on, and its rules as a whole.
Result<SessionState> Do(const SetLot& command, SessionState state, const SessionOptions&);
Result<SessionState> Do(const Rewrite& command, SessionState state, const SessionOptions&);
Result<SessionState> Do(const SetRuleText& command, SessionState state, const SessionOptions&);
Result<SessionState> Do(const EditLayers& command, SessionState state, const SessionOptions&);
Result<SessionState> Do(const ChangeLayer& command, SessionState state, const SessionOptions&);
Result<SessionState> Do(const PlaceElement& command, SessionState state, const SessionOptions&);
Result<SessionState> Do(const Take& command, SessionState state, const SessionOptions&);
Result<SessionState> Do(const Switch& command, SessionState state, const SessionOptions&);
Result<SessionState> Do(const Move& command, SessionState state, const SessionOptions&);
Result<SessionState> Do(const Delete& command, SessionState state, const SessionOptions&);
Result<SessionState> Do(const AddTree& command, SessionState state, const SessionOptions&);
Result<SessionState> Do(const RenameTree& command, SessionState state, const SessionOptions&);

/// Nodes, and what they select.
Result<SessionState> Do(const Pick& command, SessionState state, const SessionOptions& options);
Result<SessionState> Do(const RenameSymbol& command, SessionState state, const SessionOptions&);
Result<SessionState> Do(const SetNumber& command, SessionState state, const SessionOptions&);
Result<SessionState> Do(const RenameEverywhere& command, SessionState state, const SessionOptions&);
Result<SessionState> Do(const SetQuery& command, SessionState state, const SessionOptions& options);
Result<SessionState> Do(const AddNode& command, SessionState state, const SessionOptions&);

/// Where it is looked at from.
Result<SessionState> Do(const SetView& command, SessionState state, const SessionOptions&);
Result<SessionState> Do(const KeepView& command, SessionState state, const SessionOptions&);
Result<SessionState> Do(const GoView& command, SessionState state, const SessionOptions&);
Result<SessionState> Do(const DropView& command, SessionState state, const SessionOptions&);

/// What is drawn, and what is selected.
Result<SessionState> Do(const Erase& command, SessionState state, const SessionOptions& options);
Result<SessionState> Do(const Select& command, SessionState state, const SessionOptions& options);
Result<SessionState> Do(const ClearSketch&, SessionState state, const SessionOptions&);

}  // namespace parti::app
