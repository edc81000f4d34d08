// The one file that knows CLI11, which is slow to compile: words -> Command.
#include <fmt/core.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>

#include "cli/commands.h"
#include "cli/help.h"
#include "cli/numbers.h"
#include "cli/usage.h"

namespace overstrike {
namespace {

/// Options that are settings of a device, by the device's own names.
constexpr std::string_view kDeviceSettings[] = {"size",   "cpi",     "lpi",
                                                "levels", "strikes", "stream"};

/// Options that are settings of an emulated machine.
constexpr OptionHelp kMachineSettings[] = {
    {"--lpi", "N", "line printer: lines to the inch (default 6)", "Options"},
    {"--cpi", "N", "line printer: characters to the inch (default 10)", "Options"},
    {"--stream", "cr|asa|plain", "line printer: how overstrikes are written (default cr)",
     "Options"},
    {"--paper", "NAME", "plotter: A4, A3, A or B (default A4)", "Options"},
    {"--dpi", "N", "of a PNG (default: line printer 144, plotter 100)", "Options"},
};

/// Everything the parser fills, still text.
struct Words {
  RenderCommand render;
  EmulateCommand emulate;
  CheckCommand check;
  DevicesCommand devices;
  SceneChangeTexts changes;
  std::vector<std::string> named = std::vector<std::string>(std::size(kDeviceSettings));
  std::vector<std::string> render_sets, emulate_sets;
  std::vector<std::string> machine = std::vector<std::string>(std::size(kMachineSettings));
  std::string method, boolean, coherence, translucent, tolerance, threads, timings;
};

/// One text option; the last one given counts.
void text_option(CLI::App* app, const OptionHelp& help, std::string& value) {
  app->add_option(std::string(help.names), value, std::string(help.meaning))
      ->type_name(std::string(help.value))
      ->group(std::string(help.group))
      ->take_last();
}

void flag(CLI::App* app, const OptionHelp& help, bool& value) {
  app->add_flag(std::string(help.names), value, std::string(help.meaning))
      ->group(std::string(help.group))
      ->disable_flag_override();
}

/// --set name=value, any number of times.
void set_option(CLI::App* app, std::vector<std::string>& sets) {
  app->add_option("--set", sets, "one more setting of the device: see overstrike devices NAME")
      ->type_name("NAME=VALUE")
      ->group("Device settings")
      ->allow_extra_args(false);
}

/// -D name=value, any number of times.
CLI::Option* define_option(CLI::App* app, std::vector<std::string>& definitions) {
  const OptionHelp& help = option_help("-D,--define");
  return app->add_option(std::string(help.names), definitions, std::string(help.meaning))
      ->type_name(std::string(help.value))
      ->group(std::string(help.group))
      ->allow_extra_args(false);
}

/// Help as we like it: usage lines of our own, one blank line between groups.
class HelpFormatter : public CLI::Formatter {
 public:
  explicit HelpFormatter(std::string_view usage) : usage_(usage) {
    label("Positionals", "What");
    column_width(28);
  }
  std::string make_help(const CLI::App* app, std::string, CLI::AppFormatMode mode) const override {
    std::string text = make_description(app) + "\nusage: overstrike " + usage_ + "\n";
    text += make_positionals(app);
    for (const std::string& group : app->get_groups()) {
      const auto options = app->get_options([&](const CLI::Option* option) {
        return option->get_group() == group && option->nonpositional();
      });
      if (!group.empty() && !options.empty()) text += make_group(group, false, options);
    }
    return text + make_subcommands(app, mode) + "\n" + make_footer(app);
  }
  std::string make_option_name(const CLI::Option* option, bool positional) const override {
    const std::string name = CLI::Formatter::make_option_name(option, positional);
    return name.substr(0, name.find('{'));  // the value that CLI11 gives a flag without one
  }

 private:
  std::string usage_;
};

CLI::App* subcommand(CLI::App& app, std::string_view name) {
  const SubcommandHelp& help = subcommand_help(name);
  CLI::App* sub = app.add_subcommand(std::string(name), std::string(help.summary));
  sub->formatter(std::make_shared<HelpFormatter>(help.usage));
  sub->footer(std::string(help.footer));
  sub->allow_extras();
  sub->set_help_flag("-h,--help", "this text");
  return sub;
}

void add_positional(CLI::App* app, const char* name, const char* meaning, std::string& value) {
  app->add_option(name, value, meaning)->option_text(" ");
}

void add_scene_options(CLI::App* app, SceneChangeTexts& t) {
  text_option(app, option_help("--eye"), t.eye);
  text_option(app, option_help("--target"), t.target);
  text_option(app, option_help("--up"), t.up);
  text_option(app, option_help("--look-at"), t.look_at);
  text_option(app, option_help("--distance"), t.distance);
  text_option(app, option_help("--azimuth"), t.azimuth);
  text_option(app, option_help("--elevation"), t.elevation);
  text_option(app, option_help("--parallel"), t.parallel);
  text_option(app, option_help("--fov"), t.fov);
  flag(app, option_help("--fit"), t.fit);
  text_option(app, option_help("--camera"), t.camera);
  text_option(app, option_help("--projection"), t.projection);
  text_option(app, option_help("--light"), t.light);
  flag(app, option_help("--no-light"), t.no_light);
  text_option(app, option_help("--ground"), t.ground);
  flag(app, option_help("--no-ground"), t.no_ground);
  text_option(app, option_help("--density"), t.density);
  flag(app, option_help("--weld"), t.weld);
  flag(app, option_help("--no-weld"), t.no_weld);
}

void add_render(CLI::App& app, Words& w) {
  CLI::App* sub = subcommand(app, "render");
  add_positional(sub, "SCENE", "scene or mesh file, or - for standard input", w.render.scene);
  text_option(sub, option_help("-o,--output"), w.render.output);
  text_option(sub, option_help("-d,--device"), w.render.device);
  text_option(sub, option_help("--format"), w.render.format);
  for (std::size_t i = 0; i < std::size(kDeviceSettings); ++i)
    text_option(sub, option_help("--" + std::string(kDeviceSettings[i])), w.named[i]);
  set_option(sub, w.render_sets);
  add_scene_options(sub, w.changes);
  define_option(sub, w.render.definitions);
  text_option(sub, option_help("--method"), w.method);
  text_option(sub, option_help("--boolean"), w.boolean);
  text_option(sub, option_help("--coherence"), w.coherence);
  text_option(sub, option_help("--translucent"), w.translucent);
  text_option(sub, option_help("--tolerance"), w.tolerance);
  text_option(sub, option_help("--threads"), w.threads);
  sub->add_flag("--timings{text}", w.timings, std::string(option_help("--timings").meaning))
      ->group(std::string(option_help("--timings").group));
  flag(sub, option_help("-v,--verbose"), w.render.verbose);
}

void add_watch(CLI::App& app, Words& w) {
  CLI::App* sub = subcommand(app, "watch");
  add_positional(sub, "SCENE", "scene or mesh file", w.render.scene);
  text_option(sub, option_help("--size"), w.named[0]);
  set_option(sub, w.render_sets);
  add_scene_options(sub, w.changes);
  define_option(sub, w.render.definitions);
  text_option(sub, option_help("--method"), w.method);
  text_option(sub, option_help("--tolerance"), w.tolerance);
  text_option(sub, option_help("--threads"), w.threads);
}

void add_emulate(CLI::App& app, Words& w) {
  CLI::App* sub = subcommand(app, "emulate");
  add_positional(sub, "MACHINE", "line-printer or plotter", w.emulate.machine);
  add_positional(sub, "FILE", "what the machine is sent, or - for standard input", w.emulate.input);
  text_option(sub,
              {"-o,--output", "FILE",
               "the sheet: .png, .pdf or (plotter) .svg; - is standard output", "Options"},
              w.emulate.output);
  text_option(sub,
              {"--format", "FORMAT", "of standard output: png, pdf or (plotter) svg (default png)",
               "Options"},
              w.emulate.format);
  for (std::size_t i = 0; i < std::size(kMachineSettings); ++i)
    text_option(sub, kMachineSettings[i], w.machine[i]);
  sub->add_option("--set", w.emulate_sets, "one more setting of the machine")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
}

void add_check(CLI::App& app, Words& w) {
  CLI::App* sub = subcommand(app, "check");
  add_positional(sub, "SCENE", "scene or mesh file, or - for standard input", w.check.scene);
  text_option(sub, {"--format", "FORMAT", "format of standard input (default yaml)", "Options"},
              w.check.format);
  define_option(sub, w.check.definitions)->group("Options");
}

void add_devices(CLI::App& app, Words& w) {
  CLI::App* sub = subcommand(app, "devices");
  add_positional(sub, "NAME", "a device, for its settings", w.devices.name);
}

std::vector<std::string_view> subcommand_names() {
  return {"render", "watch", "emulate", "check", "devices"};
}

/// Every "--name" that the subcommand has.
std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

[[noreturn]] void refuse_extra(const CLI::App& app, const std::vector<std::string>& extras) {
  const auto is_option = [](const std::string& word) { return word.size() > 1 && word[0] == '-'; };
  const auto option = std::find_if(extras.begin(), extras.end(), is_option);
  if (option == extras.end()) throw UsageError(fmt::format("unexpected word '{}'", extras.front()));
  const std::string name = option->substr(0, option->find('='));
  const std::vector<std::string> names = option_names(app);
  const std::vector<std::string_view> views(names.begin(), names.end());
  throw UsageError(fmt::format("unknown option '{}'{}", name, suggestion(name, views)));
}

/// An option given without a value ("--size=", "--eye ''") is refused, not ignored.
void check_values(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->count() == 0 || option->get_items_expected_max() == 0) continue;
    const auto& values = option->results();
    if (std::find(values.begin(), values.end(), "") != values.end())
      throw UsageError(option->get_name() + ": a value is missing");
  }
}

void check_words(const CLI::App& app) {
  const auto extras = app.remaining();
  if (!extras.empty()) refuse_extra(app, extras);
  check_values(app);
}

void need(const std::string& value, std::string_view what) {
  if (value.empty()) throw UsageError(fmt::format("{} is missing", what));
}

std::pair<std::string, std::string> split_setting(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos)
    throw UsageError(fmt::format("--set: expected NAME=VALUE, found '{}'", text));
  return {text.substr(0, equals), text.substr(equals + 1)};
}

/// Which of the names the text is; `usual` where there is none. `names` as they are listed.
template <std::size_t n>
std::size_t read_choice(std::string_view option, const std::string& text,
                        const std::string_view (&names)[n], std::size_t usual) {
  if (text.empty()) return usual;
  const auto found = std::find(std::begin(names), std::end(names), text);
  if (found != std::end(names)) return static_cast<std::size_t>(found - std::begin(names));
  std::string list(names[0]);
  for (std::size_t i = 1; i < n; ++i) list += (i + 1 < n ? ", " : " or ") + std::string(names[i]);
  throw UsageError(
      fmt::format("{}: expected {}, found '{}'{}", option, list, text, suggestion(text, names)));
}

Method read_method(const std::string& text) {
  static constexpr std::string_view kNames[] = {"auto", "line", "nn74"};
  return static_cast<Method>(read_choice("--method", text, kNames, 0));
}

BooleanForm read_boolean(const std::string& text) {
  static constexpr std::string_view kNames[] = {"auto", "tree", "sop"};
  return static_cast<BooleanForm>(read_choice("--boolean", text, kNames, 0));
}

Coherence read_coherence(const std::string& text) {
  static constexpr std::string_view kNames[] = {"none", "span", "span+behind", "all"};
  return static_cast<Coherence>(read_choice("--coherence", text, kNames, 3));
}

std::optional<double> read_translucent(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const NumberRule rule{"--translucent", "F from 0 to 1"};
  const double factor = read_numbers(rule, text).front();
  if (!(factor >= 0 && factor <= 1)) refuse(rule, text);
  return factor;
}

TimingsFormat read_timings(const std::string& text) {
  if (text.empty()) return TimingsFormat::none;
  if (text == "text") return TimingsFormat::text;
  if (text == "json") return TimingsFormat::json;
  throw UsageError(fmt::format("--timings: expected nothing or =json, found '{}'", text));
}

/// Far more than any machine has; a slip of the finger should not start a million threads.
constexpr int kMostThreads = 1024;

RenderCommand render_command(Words& w) {
  need(w.render.scene, "SCENE");
  for (std::size_t i = 0; i < w.named.size(); ++i) {
    if (!w.named[i].empty()) w.render.settings.emplace_back(kDeviceSettings[i], w.named[i]);
  }
  w.render.options = w.render.settings.size();
  for (const std::string& set : w.render_sets) w.render.settings.push_back(split_setting(set));
  w.render.changes = read_scene_changes(w.changes);
  w.render.method = read_method(w.method);
  w.render.boolean = read_boolean(w.boolean);
  w.render.coherence = read_coherence(w.coherence);
  w.render.translucent = read_translucent(w.translucent);
  if (!w.tolerance.empty())
    w.render.tolerance = read_number_above({"--tolerance", "T in cells, above 0 and at most 100"},
                                           w.tolerance, 0, 100);
  if (!w.threads.empty())
    w.render.threads = read_integer({"--threads", "N from 0 (all processors) to 1024"}, w.threads,
                                    0, kMostThreads);
  w.render.timings = read_timings(w.timings);
  return w.render;
}

Command watch_command(Words& w) {
  RenderCommand render = render_command(w);
  render.device = "terminal";
  return WatchCommand{std::move(render)};
}

Command emulate_command(Words& w) {
  need(w.emulate.machine, "MACHINE (line-printer or plotter)");
  need(w.emulate.input, "FILE");
  need(w.emulate.output, "-o FILE");
  for (std::size_t i = 0; i < w.machine.size(); ++i) {
    if (!w.machine[i].empty())
      w.emulate.settings.emplace_back(kMachineSettings[i].names.substr(2), w.machine[i]);
  }
  w.emulate.options = w.emulate.settings.size();
  for (const std::string& set : w.emulate_sets) w.emulate.settings.push_back(split_setting(set));
  return w.emulate;
}

Command chosen_command(const std::string& name, Words& w) {
  if (name == "render") return render_command(w);
  if (name == "watch") return watch_command(w);
  if (name == "emulate") return emulate_command(w);
  if (name == "devices") return w.devices;
  need(w.check.scene, "SCENE");
  return w.check;
}

/// CLI11 reads "--size=" as "--size" and takes the next word for its value.
void refuse_empty_values(std::span<const std::string> words) {
  for (const std::string& word : words) {
    if (word.size() > 3 && word.starts_with("--") && word.find('=') == word.size() - 1)
      throw UsageError(word.substr(0, word.size() - 1) + ": a value is missing");
  }
}

/// The first word is no subcommand and no option.
void check_subcommand(std::span<const std::string> words) {
  if (words.empty())
    throw UsageError("a subcommand is missing: render, watch, emulate, check or devices");
  const std::string& word = words.front();
  const auto names = subcommand_names();
  if (word.starts_with('-') || std::find(names.begin(), names.end(), word) != names.end()) return;
  throw UsageError(fmt::format("unknown subcommand '{}'{}", word, suggestion(word, names)));
}

}  // namespace

Command parse_command_line(std::span<const std::string> words) {
  check_subcommand(words);
  refuse_empty_values(words);
  Words w;
  CLI::App app(std::string(kProgramSummary), "overstrike");
  app.formatter(std::make_shared<HelpFormatter>("SUBCOMMAND ..."));
  app.footer(std::string(kProgramFooter));
  app.allow_extras();
  app.set_help_flag("-h,--help", "this text");
  app.set_version_flag("--version", std::string(kVersionText), "the version");
  add_render(app, w);
  add_watch(app, w);
  add_emulate(app, w);
  add_check(app, w);
  add_devices(app, w);
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::CallForHelp&) {
    return TextCommand{app.help()};
  } catch (const CLI::CallForVersion& version) {
    return TextCommand{std::string(version.what()) + "\n"};
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
  const auto chosen = app.get_subcommands();
  const CLI::App& asked = chosen.empty() ? app : *chosen.front();
  check_words(asked);
  if (chosen.empty())
    throw UsageError("a subcommand is missing: render, watch, emulate, check or devices");
  return chosen_command(asked.get_name(), w);
}

}  // namespace overstrike
