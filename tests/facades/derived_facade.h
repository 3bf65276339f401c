// A façade's rules run, and what became of each of its elements.
#pragma once

#include <memory>

#include "app/session_state.h"
#include "tests/facades/facade_rules.h"

namespace parti::tests {

/// The rules derived on their lot. CHECKs that they can be.
app::Model ModelOf(const AnnotatedFacade& facade, const std::string& rules);

/// Indices of the shapes of the tree that stand for the elements of one wall, by LabelLayers and
/// then in the order of the façade's elements; `wall` counts from 0.
std::vector<grammar::ShapeIndex> PlacedElements(const grammar::ShapeTree& tree, size_t wall);

/// The indices of the façade's elements in that order.
std::vector<size_t> ElementsByLayer(const AnnotatedFacade& facade);

/// Shapes with this symbol at and below `root`.
std::vector<grammar::ShapeIndex> ShapesNamed(const grammar::ShapeTree& tree,
                                             grammar::ShapeIndex root, std::string_view symbol);

}  // namespace parti::tests
