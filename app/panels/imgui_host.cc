#include "app/panels/imgui_host.h"

#include <imgui_internal.h>
#include <linux/input-event-codes.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <utility>

namespace parti::app::panels {
namespace {

constexpr double kFarthest_px = 1e6;  ///< ImGui makes integers of positions

/// The keys that text fields know. All others are the panels' own.
constexpr std::pair<ImGuiKey, int> kKeys[] = {
    {ImGuiKey_Tab, KEY_TAB},
    {ImGuiKey_LeftArrow, KEY_LEFT},
    {ImGuiKey_RightArrow, KEY_RIGHT},
    {ImGuiKey_UpArrow, KEY_UP},
    {ImGuiKey_DownArrow, KEY_DOWN},
    {ImGuiKey_PageUp, KEY_PAGEUP},
    {ImGuiKey_PageDown, KEY_PAGEDOWN},
    {ImGuiKey_Home, KEY_HOME},
    {ImGuiKey_End, KEY_END},
    {ImGuiKey_Insert, KEY_INSERT},
    {ImGuiKey_Delete, KEY_DELETE},
    {ImGuiKey_Backspace, KEY_BACKSPACE},
    {ImGuiKey_Space, KEY_SPACE},
    {ImGuiKey_Enter, KEY_ENTER},
    {ImGuiKey_Escape, KEY_ESC},
    {ImGuiKey_KeyPadEnter, KEY_KPENTER},
    {ImGuiKey_A, KEY_A},
    {ImGuiKey_C, KEY_C},
    {ImGuiKey_V, KEY_V},
    {ImGuiKey_X, KEY_X},
    {ImGuiKey_Y, KEY_Y},
    {ImGuiKey_Z, KEY_Z},
};

bool IsHeld(const ImGuiIO& io, int left, int right) {
  return io.KeysDown[left] || io.KeysDown[right];
}

render::PixelRect ClipOf(const ImVec4& clip, const ImVec2& size) {
  const auto within = [](float v, float most) {
    return static_cast<int>(std::lround(std::clamp(v, 0.0f, most)));
  };
  const int x0 = within(clip.x, size.x), y0 = within(clip.y, size.y);
  const int x1 = within(clip.z, size.x), y1 = within(clip.w, size.y);
  return {x0, y0, std::max(0, x1 - x0), std::max(0, y1 - y0)};
}

/// Lists that are no sheet's, as that of notes, fade with nothing.
uint32_t PartOf(const ImDrawList& list, const std::vector<PanelSheet>& sheets) {
  const ImGuiWindow* window = ImGui::FindWindowByName(list._OwnerName);
  const auto same = [&](const PanelSheet& sheet) { return sheet.name == window->RootWindow->Name; };
  const auto found = window ? std::find_if(sheets.begin(), sheets.end(), same) : sheets.end();
  return found == sheets.end() ? std::numeric_limits<uint32_t>::max()
                               : static_cast<uint32_t>(found - sheets.begin());
}

void Append(const ImDrawList& list, const ImVec2& size, uint32_t part, render::UiMesh* mesh) {
  const auto base = static_cast<uint32_t>(mesh->vertices.size());
  for (const ImDrawVert& v : list.VtxBuffer) {
    mesh->vertices.push_back({{v.pos.x, v.pos.y}, {v.uv.x, v.uv.y}, v.col});
  }
  for (const ImDrawCmd& command : list.CmdBuffer) {
    const render::PixelRect clip = ClipOf(command.ClipRect, size);
    if (command.ElemCount == 0 || clip.width == 0 || clip.height == 0) continue;
    const auto first = static_cast<uint32_t>(mesh->indices.size());
    for (uint32_t i = 0; i < command.ElemCount; ++i) {
      const auto at = static_cast<int>(command.IdxOffset + i);
      mesh->indices.push_back(base + command.VtxOffset + list.IdxBuffer[at]);
    }
    mesh->commands.push_back({clip, 0, first, command.ElemCount, part});
  }
}

}  // namespace

ImGuiHost::ImGuiHost() : context_(ImGui::CreateContext()) {
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.BackendPlatformName = io.BackendRendererName = "parti";
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  io.ConfigInputTextCursorBlink = false;  // frames only when something changed
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  for (const auto& [key, code] : kKeys) io.KeyMap[key] = code;
}

ImGuiHost::~ImGuiHost() {
  ImGui::SetCurrentContext(context_);
  ImGui::GetIO().Fonts = nullptr;  // letters_ owns it
  ImGui::DestroyContext(context_);
}

void ImGuiHost::SetLetters(Letters letters) {
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  if (!letters_.atlas) IM_DELETE(io.Fonts);  // the context's own, which nobody draws with
  letters_ = std::move(letters);
  io.Fonts = letters_.atlas.get();
  io.FontDefault = letters_.body;
}

void ImGuiHost::Feed(const PanelEvent& event) {
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  const auto* pointer = std::get_if<PanelPointer>(&event);
  if (pointer && IsFinite(pointer->px)) {
    const auto at = [](double v) {
      return static_cast<float>(std::clamp(v, -kFarthest_px, kFarthest_px));
    };
    io.MousePos = {at(pointer->px.x), at(pointer->px.y)};
    io.MouseDown[0] = pointer->down;
  } else if (pointer || std::holds_alternative<PanelPointerGone>(event)) {
    io.MousePos = {-FLT_MAX, -FLT_MAX};
    io.MouseDown[0] = false;
  } else if (const auto* scroll = std::get_if<PanelScroll>(&event)) {
    if (!IsFinite(scroll->steps)) return;
    io.MouseWheel -= static_cast<float>(std::clamp(scroll->steps.y, -100.0, 100.0));
    io.MouseWheelH -= static_cast<float>(std::clamp(scroll->steps.x, -100.0, 100.0));
  } else {
    FeedKey(std::get<KeyEvent>(event));
  }
}

void ImGuiHost::FeedKey(const KeyEvent& key) {
  ImGuiIO& io = ImGui::GetIO();
  if (key.code < std::size(io.KeysDown)) io.KeysDown[key.code] = key.pressed;
  io.KeyCtrl = IsHeld(io, KEY_LEFTCTRL, KEY_RIGHTCTRL);
  io.KeyShift = IsHeld(io, KEY_LEFTSHIFT, KEY_RIGHTSHIFT);
  io.KeyAlt = IsHeld(io, KEY_LEFTALT, KEY_RIGHTALT);
  const bool types = key.pressed && !io.KeyCtrl && !key.text.empty() &&
                     static_cast<unsigned char>(key.text[0]) >= ' ';
  if (types) io.AddInputCharactersUTF8(key.text.c_str());
}

bool ImGuiHost::control() const {
  ImGui::SetCurrentContext(context_);
  return ImGui::GetIO().KeyCtrl;
}

void ImGuiHost::NewFrame(const Vec2& size_px, double step_s) {
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(size_px.x), static_cast<float>(size_px.y)};
  io.DeltaTime = step_s > 1e-4 ? static_cast<float>(std::min(step_s, 0.25)) : 1e-4f;
  ImGui::NewFrame();
}

render::UiMesh ImGuiHost::Render(const std::vector<PanelSheet>& sheets) {
  ImGui::Render();
  const ImDrawData* data = ImGui::GetDrawData();
  render::UiMesh mesh;
  for (int i = 0; i < data->CmdListsCount; ++i) {
    const ImDrawList& list = *data->CmdLists[i];
    Append(list, data->DisplaySize, PartOf(list, sheets), &mesh);
  }
  return mesh;
}

}  // namespace parti::app::panels
