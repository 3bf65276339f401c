// listItem, listSize …: CGA's lists are texts whose elements are separated by ";".
#include <algorithm>

#include "grammar/rules/built_ins/tables.h"

namespace parti::grammar::built_ins {
namespace {

/// A trailing ";" ends the last element and begins none.
std::vector<std::string> Elements(const std::string& list) {
  std::vector<std::string> elements;
  for (size_t from = 0; from < list.size();) {
    const size_t to = std::min(list.find(';', from), list.size());
    elements.push_back(list.substr(from, to - from));
    from = to + 1;
  }
  return elements;
}

std::vector<std::string> ElementsOf(Values values) { return Elements(TextOf(values[0])); }

std::string ItemAt(Values values, double index) {
  const auto elements = ElementsOf(values);
  const bool is_there = index >= 0 && index < static_cast<double>(elements.size());
  return is_there ? elements[static_cast<size_t>(index)] : std::string();
}

Value IndexOf(Values values, const Situation&) {
  const auto elements = ElementsOf(values);
  const std::string wanted = TextOf(values[1]);
  for (size_t i = 0; i < elements.size(); ++i) {
    if (elements[i] == wanted) return static_cast<double>(i);
  }
  return -1.0;
}

Value RandomItem(Values values, const Situation& situation) {
  const double share = situation.random->Uniform();
  return ItemAt(values, share * static_cast<double>(ElementsOf(values).size()));
}

std::string Joined(std::span<const std::string> elements) {
  std::string list;
  for (const std::string& element : elements) list += element + ";";
  return list;
}

std::string Without(std::vector<std::string> elements, const std::string& unwanted) {
  std::erase(elements, unwanted);
  return Joined(elements);
}

constexpr std::array<std::optional<ValueType>, 3> kTextTwoNumbers = {kText, kNumber, kNumber};
constexpr std::array<std::optional<ValueType>, 2> kTextNumber = {kText, kNumber};
constexpr auto kOne = First(kTexts, 1);

constexpr BuiltIn kRows[] = {
    {"listSize", kOne, kNumber, "how many elements a list \"a;b;c\" has",
     [](Values values, const Situation&) -> Value {
       return static_cast<double>(ElementsOf(values).size());
     }},
    {"listItem", kTextNumber, kText, "the element of this number, from 0",
     [](Values values, const Situation&) -> Value { return ItemAt(values, NumberOf(values[1])); }},
    {"listFirst", kOne, kText, "the first element",
     [](Values values, const Situation&) -> Value { return ItemAt(values, 0); }},
    {"listLast", kOne, kText, "the last element",
     [](Values values, const Situation&) -> Value {
       return ItemAt(values, static_cast<double>(ElementsOf(values).size()) - 1);
     }},
    {"listIndex", First(kTexts, 2), kNumber, "the number of an element; -1: not in the list",
     IndexOf},
    {"listAdd", First(kTexts, 2), kText, "the list with one element more at its end",
     [](Values values, const Situation&) -> Value {
       const std::string list = TextOf(values[0]);
       const bool ended = list.empty() || list.back() == ';';
       return list + (ended ? "" : ";") + TextOf(values[1]) + ";";
     }},
    {"listRange", kTextTwoNumbers, kText,
     "the elements from one number up to another, without that",
     [](Values values, const Situation&) -> Value {
       const auto elements = ElementsOf(values);
       const auto count = static_cast<double>(elements.size());
       const double from = std::clamp(NumberOf(values[1]), 0.0, count);
       const double to = std::clamp(NumberOf(values[2]), from, count);
       return Joined(std::span(elements).subspan(
           static_cast<size_t>(from), static_cast<size_t>(to) - static_cast<size_t>(from)));
     }},
    {"listTerminate", kOne, kText, "the list with a \";\" at its end",
     [](Values values, const Situation&) -> Value { return Joined(ElementsOf(values)); }},
    {"listClean", kOne, kText, "the list without empty elements",
     [](Values values, const Situation&) -> Value { return Without(ElementsOf(values), ""); }},
    {"listRemoveAll", First(kTexts, 2), kText, "the list without the element, wherever it is",
     [](Values values, const Situation&) -> Value {
       return Without(ElementsOf(values), TextOf(values[1]));
     }},
    {"listCount", First(kTexts, 2), kNumber, "how often an element is in the list",
     [](Values values, const Situation&) -> Value {
       const auto elements = ElementsOf(values);
       return static_cast<double>(std::count(elements.begin(), elements.end(), TextOf(values[1])));
     }},
    {"listRandom", kOne, kText, "an element by chance", RandomItem},
};

}  // namespace

std::span<const BuiltIn> Lists() { return kRows; }

}  // namespace parti::grammar::built_ins
