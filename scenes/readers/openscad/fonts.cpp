#include "scenes/readers/openscad/fonts.h"

#include <fontconfig/fontconfig.h>

#include <memory>

#include "scenes/readers/nearest.h"

namespace overstrike::openscad {
namespace {

using Pattern = std::unique_ptr<FcPattern, void (*)(FcPattern*)>;

std::string text_of(FcPattern* pattern, const char* key) {
  FcChar8* text = nullptr;
  if (FcPatternGetString(pattern, key, 0, &text) != FcResultMatch) return {};
  return reinterpret_cast<const char*>(text);
}

/// Fontconfig's lists are read once.
FcConfig* config() {
  static const std::unique_ptr<FcConfig, void (*)(FcConfig*)> loaded(FcInitLoadConfigAndFonts(),
                                                                     FcConfigDestroy);
  return loaded.get();
}

}  // namespace

FontFile find_font(const std::string& name) {
  Pattern pattern(FcNameParse(reinterpret_cast<const FcChar8*>(name.c_str())), FcPatternDestroy);
  if (!pattern || !config()) return {};
  const std::string asked = text_of(pattern.get(), FC_FAMILY);
  FcPatternAddBool(pattern.get(), FC_OUTLINE, FcTrue);
  FcPatternAddBool(pattern.get(), FC_SCALABLE, FcTrue);
  FcConfigSubstitute(config(), pattern.get(), FcMatchPattern);
  FcDefaultSubstitute(pattern.get());
  FcResult result = FcResultNoMatch;
  const Pattern match(FcFontMatch(config(), pattern.get(), &result), FcPatternDestroy);
  if (!match || result != FcResultMatch) return {};
  FontFile file{text_of(match.get(), FC_FILE), 0, text_of(match.get(), FC_FAMILY), false};
  FcPatternGetInteger(match.get(), FC_INDEX, 0, &file.index);
  file.substitute = !asked.empty() && edit_distance(asked, file.family) > 0;
  return file;
}

}  // namespace overstrike::openscad
