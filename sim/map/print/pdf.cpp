#include "sim/map/print/pdf.h"

#include "sim/base/error.h"

#ifndef ROBOSIM_WITHOUT_PDF
#include <fmt/format.h>
#include <hpdf.h>

#include <new>
#include <stdexcept>
#include <vector>

namespace robosim::print {
namespace {

constexpr double kPoint = 72.0 / 25.4;  // points per millimetre

float points(double mm) { return static_cast<float>(mm * kPoint); }

// Converts a text to Helvetica's characters in WinAnsiEncoding.
std::string latin_of(const std::string& utf8) {
  std::string text;
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    const auto c = static_cast<unsigned char>(utf8[i]);
    if (c < 0x80) {
      text += c < 0x20 ? ' ' : utf8[i];
    } else if ((c == 0xC2 || c == 0xC3) && i + 1 < utf8.size()) {
      const auto low = static_cast<unsigned char>(utf8[++i]);
      const auto code = static_cast<unsigned char>((c & 3) << 6 | (low & 0x3F));
      text += code < 0xA0 ? '?' : static_cast<char>(code);
    } else {
      while (i + 1 < utf8.size() && (utf8[i + 1] & 0xC0) == 0x80) ++i;
      text += '?';
    }
  }
  return text;
}

// Ignores errors, which the document stores until they are checked at the end.
void keep_going(HPDF_STATUS, HPDF_STATUS, void*) {}

}  // namespace

struct Pdf::Impl {
  HPDF_Doc document = HPDF_New(keep_going, nullptr);
  HPDF_Page page = nullptr;
  HPDF_Font font = nullptr;
  HPDF_Image picture = nullptr;

  ~Impl() {
    if (document) HPDF_Free(document);
  }
  void check() const {
    if (!document) throw std::bad_alloc();
    if (const HPDF_STATUS status = HPDF_GetError(document); status != HPDF_OK)
      throw std::runtime_error(fmt::format("libhpdf: error 0x{:04x}", status));
  }
};

Pdf::Pdf(const std::string& title, bool compressed) : impl_(std::make_unique<Impl>()) {
  impl_->check();
  if (compressed) HPDF_SetCompressionMode(impl_->document, HPDF_COMP_ALL);
  HPDF_SetInfoAttr(impl_->document, HPDF_INFO_TITLE, latin_of(title).c_str());
  HPDF_SetInfoAttr(impl_->document, HPDF_INFO_PRODUCER, "Robosim");
  HPDF_SetViewerPreference(impl_->document, HPDF_PRINT_SCALING_NONE);
  impl_->font = HPDF_GetFont(impl_->document, "Helvetica", "WinAnsiEncoding");
  impl_->check();
}

Pdf::~Pdf() = default;

void Pdf::begin_page(double width, double height) {
  impl_->page = HPDF_AddPage(impl_->document);
  impl_->check();
  HPDF_Page_SetWidth(impl_->page, points(width));
  HPDF_Page_SetHeight(impl_->page, points(height));
}

void Pdf::begin_part(const Box& clip) {
  HPDF_Page_GSave(impl_->page);
  add_box(clip);
  HPDF_Page_Clip(impl_->page);
  HPDF_Page_EndPath(impl_->page);
}

void Pdf::end_part() { HPDF_Page_GRestore(impl_->page); }

void Pdf::set_grey(double level) {
  HPDF_Page_SetGrayFill(impl_->page, static_cast<float>(level));
  HPDF_Page_SetGrayStroke(impl_->page, static_cast<float>(level));
}

void Pdf::set_colour(double red, double green, double blue) {
  const auto r = static_cast<float>(red), g = static_cast<float>(green), b = static_cast<float>(blue);
  HPDF_Page_SetRGBFill(impl_->page, r, g, b);
  HPDF_Page_SetRGBStroke(impl_->page, r, g, b);
}

void Pdf::set_pen(double width, bool round_ends) {
  HPDF_Page_SetLineWidth(impl_->page, points(width));
  HPDF_Page_SetLineCap(impl_->page, round_ends ? HPDF_ROUND_END : HPDF_BUTT_END);
}

void Pdf::move_to(Vec2 p) { HPDF_Page_MoveTo(impl_->page, points(p.x), points(p.y)); }

void Pdf::line_to(Vec2 p) { HPDF_Page_LineTo(impl_->page, points(p.x), points(p.y)); }

// Approximates the arc by a cubic curve. The distance between them is at most 2e-8 of the radius.
void Pdf::arc_to(const Line& arc) {
  const Vec2 from = arc.from - arc.centre, to = arc.to - arc.centre;
  // Each control point lies on the tangent at an end of the arc, 4/3 tan(turn / 4) radii from that end.
  const double turn = std::atan2(cross(from, to), dot(from, to));
  const double reach = 4.0 / 3.0 * std::tan(turn / 4.0);
  const Vec2 first = arc.from + left_of(from) * reach, second = arc.to - left_of(to) * reach;
  HPDF_Page_CurveTo(impl_->page, points(first.x), points(first.y), points(second.x), points(second.y),
                    points(arc.to.x), points(arc.to.y));
}

void Pdf::add_box(const Box& box) {
  HPDF_Page_Rectangle(impl_->page, points(box.left), points(box.low), points(box.right - box.left),
                      points(box.high - box.low));
}

void Pdf::load_picture(const map::FloorImage& image) {
  std::vector<HPDF_BYTE> greys;
  greys.reserve(static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height()));
  for (int row = 0; row < image.height(); ++row)
    for (int column = 0; column < image.width(); ++column)
      greys.push_back(static_cast<HPDF_BYTE>(255 - image.at(column, row)));
  impl_->picture =
      HPDF_LoadRawImageFromMem(impl_->document, greys.data(), static_cast<HPDF_UINT>(image.width()),
                               static_cast<HPDF_UINT>(image.height()), HPDF_CS_DEVICE_GRAY, 8);
  impl_->check();
}

void Pdf::draw_picture(const Box& box) {
  HPDF_Page_DrawImage(impl_->page, impl_->picture, points(box.left), points(box.low),
                      points(box.right - box.left), points(box.high - box.low));
}

void Pdf::stroke() { HPDF_Page_Stroke(impl_->page); }

void Pdf::fill() { HPDF_Page_Fill(impl_->page); }

void Pdf::text(Vec2 at, double size, const std::string& utf8) {
  HPDF_Page_BeginText(impl_->page);
  HPDF_Page_SetFontAndSize(impl_->page, impl_->font, points(size));
  HPDF_Page_TextOut(impl_->page, points(at.x), points(at.y), latin_of(utf8).c_str());
  HPDF_Page_EndText(impl_->page);
}

double Pdf::width_of(double size, const std::string& utf8) const {
  const std::string text = latin_of(utf8);
  const HPDF_TextWidth width = HPDF_Font_TextWidth(
      impl_->font, reinterpret_cast<const HPDF_BYTE*>(text.data()), static_cast<HPDF_UINT>(text.size()));
  return size * width.width / 1000.0;
}

std::string Pdf::bytes() {
  HPDF_SaveToStream(impl_->document);
  impl_->check();
  HPDF_ResetStream(impl_->document);
  std::string all(HPDF_GetStreamSize(impl_->document), '\0');
  auto size = static_cast<HPDF_UINT32>(all.size());
  HPDF_ReadFromStream(impl_->document, reinterpret_cast<HPDF_BYTE*>(all.data()), &size);
  all.resize(size);
  return all;
}

}  // namespace robosim::print

#else

namespace robosim::print {

struct Pdf::Impl {};
Pdf::Pdf(const std::string&, bool) {
  throw ToolMissing(
      "this build of Robosim cannot write PDF: libhpdf has another name on each Debian, so packages are "
      "built without it; build Robosim from a checkout and run ./robosim map print there");
}
Pdf::~Pdf() = default;
void Pdf::begin_page(double, double) {}
void Pdf::begin_part(const Box&) {}
void Pdf::end_part() {}
void Pdf::set_grey(double) {}
void Pdf::set_colour(double, double, double) {}
void Pdf::set_pen(double, bool) {}
void Pdf::move_to(Vec2) {}
void Pdf::line_to(Vec2) {}
void Pdf::arc_to(const Line&) {}
void Pdf::add_box(const Box&) {}
void Pdf::load_picture(const map::FloorImage&) {}
void Pdf::draw_picture(const Box&) {}
void Pdf::stroke() {}
void Pdf::fill() {}
void Pdf::text(Vec2, double, const std::string&) {}
double Pdf::width_of(double, const std::string&) const { return 0.0; }
std::string Pdf::bytes() { return ""; }

}  // namespace robosim::print
#endif
