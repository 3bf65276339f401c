// The sheets of views, exports and settings.
#include <linux/input-event-codes.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/file_ending.h"
#include "app/output.h"
#include "app/panels/sheet_rows.h"
#include "app/panels/words.h"
#include "app/panels/writing.h"
#include "input/binding_table.h"

namespace parti::app::panels {
namespace {

/// What a format is good for; endings that are new to the exporter come without.
struct Format {
  std::string_view ending, words;
};
constexpr Format kFormats[] = {
    {"glb", "glTF in one file, for viewers and Blender"},
    {"gltf", "glTF as text"},
    {"obj", "Wavefront OBJ, for nearly everything"},
    {"cga", "the rules as text"},
    {"png", "a picture of this view"},
};

std::vector<std::string> Endings() {
  std::vector<std::string> endings;
  const std::string all = ExportEndings();
  for (size_t from = all.find('.'); from != std::string::npos; from = all.find('.', from + 1)) {
    const size_t end = std::min(all.find_first_of(", ", from), all.size());
    endings.push_back(all.substr(from + 1, end - from - 1));
  }
  return endings;
}

std::string WordsFor(const std::string& ending) {
  for (const Format& format : kFormats) {
    if (format.ending == ending) return std::string(format.words);
  }
  return "";
}

/// What a pen's button can be for, in the order in which taps go through them.
struct ActWords {
  input::PenAct act;
  const char* words;
};
constexpr ActWords kActs[] = {
    {input::PenAct::kErase, "erases"}, {input::PenAct::kSelect, "selects"},
    {input::PenAct::kDraw, "draws"},   {input::PenAct::kOrbit, "orbits"},
    {input::PenAct::kPan, "pans"},     {input::PenAct::kZoom, "zooms"},
};

/// A row that says what a button does; a tap changes it to the next.
void PenButton(const char* name, uint32_t button, Form* form, Settings* settings) {
  input::BindingTable table =
      input::ReadBindings(settings->bindings).value_or(input::DefaultBindings());
  if (settings->bindings.empty()) table = input::DefaultBindings();
  const auto row = std::find_if(table.begin(), table.end(), [&](const input::Binding& binding) {
    return binding.source == input::PenSource::kPen && binding.button == button &&
           binding.modifiers == 0;
  });
  if (row == table.end()) return;
  const auto* now = std::find_if(std::begin(kActs), std::end(kActs),
                                 [&](const ActWords& a) { return a.act == row->act; });
  const bool known = now != std::end(kActs);
  const ButtonLook look{.name = name, .icon = Icon::kDraw};
  if (!form->Choice(look, known ? now->words : "does nothing")) return;
  row->act = known && now + 1 != std::end(kActs) ? (now + 1)->act : kActs[0].act;
  settings->bindings = input::BindingsText(table);
}

/// A name that ends as exports do chooses the format; what is left is the name.
void TakeName(const std::string& typed, Memory* memory) {
  memory->file_name = typed;
  for (const std::string& ending : Endings()) {
    if (EndingOf(typed) != "." + ending) continue;
    memory->export_ending = ending;
    memory->file_name.resize(typed.size() - ending.size() - 1);
  }
}

}  // namespace

void ExportRows(Ui* ui, Memory* memory, Form* form) {
  if (form->Heading("Export")) memory->open = Sheet::kNone;
  if (std::exchange(memory->name_asked, false)) {
    memory->file_name = NameNow(ui->view(), "." + memory->export_ending);
  }
  for (const std::string& ending : Endings()) {
    const bool chosen = ending == memory->export_ending;
    const ButtonLook look{
        .name = "." + ending, .icon = chosen ? Icon::kCheck : Icon::kNone, .chosen = chosen};
    if (form->Choice(look, WordsFor(ending))) memory->export_ending = ending;
  }
  if (const auto typed = form->Field("File name", memory->file_name)) TakeName(*typed, memory);
  const bool named = !memory->file_name.empty();
  const std::string path =
      Joined(ui->view().files.folder, memory->file_name + "." + memory->export_ending);
  if (named) form->Words("Goes to " + path);
  const bool built = ui->view().session && !ui->view().session->state->model.lots().empty();
  if (!built) form->Words("There is nothing to export yet: draw a lot first.");
  const DocumentRequest wish{DocumentRequest::Kind::kExport, path};
  if (auto asked = WriteButton(ui, memory, form, "Export", wish, built && named)) {
    ui->Send(std::move(*asked));
    memory->open = Sheet::kNone;
  }
}

void ViewsRows(Ui* ui, Memory* memory, Form* form) {
  if (form->Heading("Views")) memory->open = Sheet::kNone;
  const auto ask = [&](const std::vector<std::pair<const char*, ViewRequest>>& requests) {
    std::vector<ButtonLook> looks;
    for (const auto& [name, request] : requests) looks.push_back({.name = name, .label = name});
    const int pressed = form->Buttons(looks);
    if (pressed >= 0) ui->Send(requests[static_cast<size_t>(pressed)].second);
  };
  ask({{"South", ViewRequest::kSouth},
       {"East", ViewRequest::kEast},
       {"North", ViewRequest::kNorth},
       {"West", ViewRequest::kWest}});
  ask({{"Above", ViewRequest::kAbove}, {"Show all", ViewRequest::kFit}});
  ask({{"Nearer", ViewRequest::kNearer}, {"Farther", ViewRequest::kFarther}});
  if (ui->view().session && !ui->view().session->state->views.empty()) {
    form->Label("Kept views");
    for (const NamedView& view : ui->view().session->state->views) {
      Box row = form->Row(ui->U(kMeasures.target), 2);
      if (!form->draw()) continue;
      const Box drop = row.CutRight(ui->U(kMeasures.target), ui->U(kMeasures.gap));
      const ButtonLook go{
          .name = "Go to " + view.name, .icon = Icon::kBookmark, .label = view.name};
      if (ui->Button(go, row).pressed) ui->SendTyped(GoView{view.name});
      const ButtonLook remove{.name = "Drop " + view.name, .icon = Icon::kDelete};
      if (ui->Button(remove, drop).pressed) ui->SendTyped(DropView{view.name});
    }
  }
  const auto typed = form->Field("Keep this view as", "", "a name, as street corner");
  if (typed) ui->SendTyped(KeepView{*typed});
}

void SettingsRows(Ui* ui, Memory* memory, Form* form) {
  if (form->Heading("Settings")) memory->open = Sheet::kNone;
  Settings settings = ui->view().settings;
  form->Label("Colours");
  const bool dark = settings.theme == Theme::kDark;
  const int theme =
      form->Buttons({{.name = "Light", .icon = Icon::kSun, .label = "Light", .chosen = !dark},
                     {.name = "Dark", .icon = Icon::kMoon, .label = "Dark", .chosen = dark}});
  if (theme >= 0) settings.theme = theme == 1 ? Theme::kDark : Theme::kLight;
  form->Label("Size of the panels");
  const double scale = ui->view().scale;
  const int size = form->Stepper("panels", PlainNumber(scale) + "×", scale > 1, scale < 3);
  if (size < 0) settings.scale = std::max(1.0, std::ceil(scale * 4 - 1) / 4);
  if (size > 0) settings.scale = std::min(3.0, std::floor(scale * 4 + 1) / 4);
  if (form->Switch("Left-handed", "Panels keep to the right of the pen", settings.left_handed)) {
    settings.left_handed = !settings.left_handed;
  }
  if (form->Switch("Finger draws", "One finger draws instead of orbiting", settings.finger_draws)) {
    settings.finger_draws = !settings.finger_draws;
  }
  form->Label("Buttons of the pen");
  PenButton("Lower button", BTN_STYLUS, form, &settings);
  PenButton("Upper button", BTN_STYLUS2, form, &settings);
  if (!(settings == ui->view().settings)) ui->Send(settings);
}

}  // namespace parti::app::panels
