#include "render/canvas.h"

#include "render/look.h"
#include "render/scissor.h"

namespace parti::render {
namespace {

/// From pixels as shaders count them (y up) to the picture's texture ([0, 1], y up).
glm::mat3 TextureFromFragment(const CanvasPicture& picture, int canvas_height_px) {
  const glm::dmat3 flip(1, 0, 0, 0, -1, 0, 0, canvas_height_px, 1);
  const glm::dmat3 unit(1 / picture.view_px.x, 0, 0, 0, -1 / picture.view_px.y, 0, 0, 1, 1);
  return glm::mat3(unit * picture.picture_from_canvas * flip);
}

/// Pixel for pixel, so that nothing is to be interpolated.
bool IsExact(const CanvasPicture& picture) {
  return picture.picture_from_canvas == glm::dmat3(1) &&
         picture.view_px == glm::dvec2(picture.size_px);
}

Vec3f MiddlePaper() {
  const Look look;
  return (look.paper_low + look.paper_high) * 0.5f;
}

void BindTexture(const Gl& gl, const GlProgram& program, int unit, const char* name,
                 GLuint texture) {
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl.BindTexture(GL_TEXTURE_2D, texture);
  program.Set(name, unit);
}

}  // namespace

Canvas::Canvas(const Gl& gl, const glm::ivec2& size, Programs programs, UiLayer panels,
               Layers layers)
    : gl_(&gl),
      size_(size),
      programs_(std::move(programs)),
      full_screen_(gl),
      panels_(std::move(panels)),
      layers_(std::move(layers)),
      strokes_(size),
      paper_(MiddlePaper()),
      fresh_(size),
      history_(size) {
  fresh_.AddAll();
}

Canvas::~Canvas() {
  for (const Retired& retired : retired_) {
    if (retired.drawn) gl_->DeleteSync(retired.drawn);
  }
}

Result<Canvas::Layers> Canvas::CreateLayers(const Gl& gl, const glm::ivec2& size) {
  Result<InkLayer> ink = InkLayer::Create(gl, size);
  if (!ink) return Fail(ink);
  Result<MarkLayer> marks = MarkLayer::Create(gl, size);
  if (!marks) return Fail(marks);
  return Layers{std::move(*ink), std::move(*marks)};
}

Result<std::unique_ptr<Canvas>> Canvas::Create(const Gl& gl, const glm::ivec2& size) {
  Result<GlProgram> picture = GlProgram::Create(gl, "full_screen", "picture");
  if (!picture) return Fail(picture);
  Result<GlProgram> with_ink = GlProgram::Create(gl, "full_screen", "picture_and_ink");
  if (!with_ink) return Fail(with_ink);
  Result<UiLayer> panels = UiLayer::Create(gl);
  if (!panels) return Fail(panels);
  Result<Layers> layers = CreateLayers(gl, size);
  if (!layers) return Fail(layers);
  return std::unique_ptr<Canvas>(new Canvas(gl, size, {std::move(*picture), std::move(*with_ink)},
                                            std::move(*panels), std::move(*layers)));
}

Result<void> Canvas::Resize(const glm::ivec2& size) {
  if (size == size_) return {};
  Result<Layers> layers = CreateLayers(*gl_, size);
  if (!layers) return Fail(layers);
  layers_.ink = std::move(layers->ink);
  layers_.marks = std::move(layers->marks);
  size_ = size;
  strokes_.Resize(size);
  groups_below_ = GroupsOf(marks_below_, size);
  groups_above_ = GroupsOf(marks_above_, size);
  panel_shapes_ = ShapesOf(mesh_, size);
  mesh_sent_ = false;
  fresh_ = Damage(size);
  history_ = DamageHistory(size);
  fresh_.AddAll();
  return {};
}

void Canvas::SetPicture(CanvasPicture picture) {
  if (picture_.keep && picture_.keep != picture.keep) {
    retired_.push_back({picture_.keep, nullptr});
  }
  const bool comparable = picture_.picture_from_canvas == picture.picture_from_canvas &&
                          picture_.view_px == picture.view_px &&
                          picture.view_px == glm::dvec2(size_) && IsExact(picture) &&
                          IsExact(picture_) && !picture.cells.hashes.empty();
  if (comparable) {
    fresh_.Add(ChangeBetween(picture_.cells, picture.cells));
  } else {
    fresh_.AddAll();
  }
  picture_ = std::move(picture);
}

void Canvas::SetPaper(const Vec3f& color) {
  paper_ = color;
  fresh_.AddAll();
}

void Canvas::SetStrokes(const std::vector<InkStroke>& strokes) { strokes_.SetStrokes(strokes); }
void Canvas::BeginStroke(uint64_t id, const Vec4f& color) { strokes_.Begin(id, color); }
void Canvas::AddSamples(std::span<const Vec2f> points, std::span<const float> widths_px) {
  strokes_.Add(points, widths_px);
}
void Canvas::SetPrediction(std::span<const Vec2f> points, std::span<const float> widths_px) {
  strokes_.Predict(points, widths_px);
}
void Canvas::EndStroke() { strokes_.End(); }
void Canvas::CancelStroke() { strokes_.Cancel(); }

void Canvas::SetMarksBelowPanels(std::vector<Mark> marks) {
  SetMarks(std::move(marks), &marks_below_, &groups_below_);
}
void Canvas::SetMarksAbovePanels(std::vector<Mark> marks) {
  SetMarks(std::move(marks), &marks_above_, &groups_above_);
}

void Canvas::SetMarks(std::vector<Mark> marks, std::vector<Mark>* held,
                      std::vector<MarkGroup>* groups) {
  fresh_.Add(ChangeBetween(*held, marks, size_));
  *held = std::move(marks);
  *groups = GroupsOf(*held, size_);
}

void Canvas::SetPanels(const UiMesh& mesh) {
  if (mesh == mesh_) return;
  std::vector<UiShape> shapes = ShapesOf(mesh, size_);
  fresh_.Add(ChangeBetween(panel_shapes_, shapes, size_));
  panel_shapes_ = std::move(shapes);
  mesh_ = mesh;
  mesh_sent_ = false;
}

void Canvas::SetPanelOpacities(std::span<const float> opacities) {
  for (const UiShape& shape : panel_shapes_) {
    const uint32_t part = shape.command.part;
    if (OpacityOf(part, opacities) != OpacityOf(part, panel_opacities_)) fresh_.Add(shape.pixels);
  }
  panel_opacities_.assign(opacities.begin(), opacities.end());
}

Result<void> Canvas::SetPanelTexture(uint32_t id, const Image& image) {
  for (const UiShape& shape : panel_shapes_) {
    if (shape.command.texture == id) fresh_.Add(shape.pixels);
  }
  return panels_.SetTexture(id, image);
}

void Canvas::DamageAll() {
  fresh_.AddAll();
  history_.Forget();
}

bool Canvas::NeedsDraw() const { return !fresh_.empty() || strokes_.changed(); }

Result<Damage> Canvas::Draw(GLuint framebuffer, int age) {
  const InkNews news = strokes_.TakeNews();
  fresh_.Add(news.changed);
  if (!gl_->is_gles) gl_->Disable(GL_FRAMEBUFFER_SRGB);
  WatchRetired();
  SendPanels();
  layers_.ink.Update(strokes_, news);
  const Damage repair = history_.ToRepair(fresh_, age);
  gl_->Disable(GL_DEPTH_TEST);
  gl_->Disable(GL_BLEND);
  gl_->Enable(GL_SCISSOR_TEST);
  gl_->Viewport(0, 0, size_.x, size_.y);
  Compose(repair, framebuffer);
  gl_->Enable(GL_BLEND);
  layers_.marks.Draw(groups_below_, repair, framebuffer);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  panels_.Draw(repair, panel_opacities_);
  layers_.marks.Draw(groups_above_, repair, framebuffer);
  gl_->Disable(GL_BLEND);
  gl_->Disable(GL_SCISSOR_TEST);
  ReleaseRetired();
  if (const auto checked = CheckGl(*gl_, "drawing the canvas"); !checked) return Fail(checked);
  history_.Push(fresh_);
  return std::exchange(fresh_, Damage(size_));
}

void Canvas::Compose(const Damage& repair, GLuint framebuffer) const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  const auto draw = [this](const PixelRect& rect) {
    SetScissor(*gl_, rect, size_.y);
    full_screen_.Draw();
  };
  const Damage inked = Common(repair, layers_.ink.extent());
  if (inked.area() < repair.area()) {
    BindPicture(programs_.picture);
    for (const PixelRect& rect : repair.rects()) draw(rect);
  }
  if (inked.empty()) return;
  BindPicture(programs_.picture_and_ink);
  BindInk();
  for (const PixelRect& rect : inked.rects()) draw(rect);
}

void Canvas::BindPicture(const GlProgram& program) const {
  program.Use();
  // Without a picture any texture will do: no pixel lies in it.
  const bool has_picture = picture_.texture != 0;
  BindTexture(*gl_, program, 0, "picture", has_picture ? picture_.texture : layers_.ink.settled());
  const GLint filter = has_picture && !IsExact(picture_) ? GL_LINEAR : GL_NEAREST;
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  program.Set("picture_from_view",
              has_picture ? TextureFromFragment(picture_, size_.y) : glm::mat3(0));
  program.Set("paper", paper_);
}

void Canvas::BindInk() const {
  const GlProgram& program = programs_.picture_and_ink;
  BindTexture(*gl_, program, 1, "settled", layers_.ink.settled());
  BindTexture(*gl_, program, 2, "coverage", layers_.ink.coverage());
  BindTexture(*gl_, program, 3, "tail", layers_.ink.tail());
  program.Set("live_ink", layers_.ink.color());
}

void Canvas::SendPanels() {
  if (mesh_sent_) return;
  panels_.SetMesh(mesh_, panel_shapes_);
  mesh_sent_ = true;
}

/// All frames that show them have been begun by now.
void Canvas::WatchRetired() {
  for (Retired& retired : retired_) {
    if (!retired.drawn) retired.drawn = gl_->FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  }
}

void Canvas::ReleaseRetired() {
  while (!retired_.empty()) {
    const GLenum waited =
        gl_->ClientWaitSync(retired_.front().drawn, GL_SYNC_FLUSH_COMMANDS_BIT, 0);
    if (waited == GL_TIMEOUT_EXPIRED) return;
    gl_->DeleteSync(retired_.front().drawn);
    retired_.pop_front();
  }
}

}  // namespace parti::render
