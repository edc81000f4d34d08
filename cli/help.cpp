#include "cli/help.h"

#include <algorithm>
#include <cassert>
#include <iterator>

namespace overstrike {
namespace {

constexpr std::string_view kOutput = "Output";
constexpr std::string_view kSettings = "Device settings";
constexpr std::string_view kCamera = "Camera";
constexpr std::string_view kLight = "Light and ground";
constexpr std::string_view kDrawing = "Drawing";

constexpr OptionHelp kOptions[] = {
    {"-o,--output", "FILE", "where to draw; its extension chooses the device; - is standard output",
     kOutput},
    {"-d,--device", "NAME", "line-printer, plotter, image or terminal (default: by extension)",
     kOutput},
    {"--format", "FORMAT", "format of standard input: yaml, stl, ... (default yaml)", kOutput},
    {"--size", "COLSxROWS", "size in cells", kSettings},
    {"--cpi", "N", "line printer: characters to the inch", kSettings},
    {"--lpi", "N", "line printer: lines to the inch", kSettings},
    {"--levels", "N", "levels of tone", kSettings},
    {"--strikes", "N", "line printer: most strikes on one place", kSettings},
    {"--stream", "cr|asa|plain", "line printer: how overstrikes are written", kSettings},
    {"--eye", "X,Y,Z", "where the eye is, in world units", kCamera},
    {"--target", "X,Y,Z", "what it looks at (default: the middle of the scene)", kCamera},
    {"--up", "X,Y,Z", "what is up in the picture (default 0,0,1)", kCamera},
    {"--look-at", "X,Y,Z", "instead of an eye: what to look at", kCamera},
    {"--distance", "R", "from how far, in world units (default: three diameters of the scene)",
     kCamera},
    {"--azimuth", "DEG", "from where, degrees from +X towards +Y (default -60)", kCamera},
    {"--elevation", "DEG", "from how high, degrees above the ground (default 25)", kCamera},
    {"--parallel", "WIDTH|fit", "parallel view, its window WIDTH world units wide", kCamera},
    {"--fov", "DEG", "perspective, this vertical angle of view in degrees", kCamera},
    {"--fit", "", "fit the window to the scene", kCamera},
    {"--camera", "STRING", "OpenSCAD's own: X,Y,Z,ROTX,ROTY,ROTZ,DISTANCE or eye and target",
     kCamera},
    {"--projection", "o|p", "with --camera: orthogonal or perspective (default p)", kCamera},
    {"--light", "AZ,EL", "where the light comes from: azimuth and elevation in degrees", kLight},
    {"--no-light", "", "no light: no shade and no shadows", kLight},
    {"--ground", "Z", "a ground that takes shadows at the height Z", kLight},
    {"--no-ground", "", "no ground", kLight},
    {"--density", "K,HMAX", "the density law H = HMAX (1 - K cos a) (default 0.8,1)", kLight},
    {"-D,--define", "NAME=VALUE", "set a variable of an OpenSCAD program", kDrawing},
    {"--weld", "", "faces that a file's six digits moved apart are in one plane (.csg: always)",
     kDrawing},
    {"--no-weld", "", "numbers are what they say", kDrawing},
    {"--method", "NAME", "auto, line or nn74 (default auto)", kDrawing},
    {"--boolean", "NAME",
     "solids are followed as auto, tree or sop, a sum of products (default auto)", kDrawing},
    {"--coherence", "NAME",
     "solids keep from span to span: none, span, span+behind or all (default all)", kDrawing},
    {"--translucent", "F",
     "what was cut away and OpenSCAD's % are mixed in by F, 0 to 1 (default: the scene's)",
     kDrawing},
    {"--tolerance", "T", "error of curved outlines and averages, in cells (default: the device's)",
     kDrawing},
    {"--threads", "N", "threads, 0 for all processors (default 0); the bytes are the same",
     kDrawing},
    {"--timings", "",
     "say on standard error what took how long; --timings=json: as one line of JSON", kDrawing},
    {"-v,--verbose", "", "say on standard error what was drawn and how to see it", kDrawing},
};

constexpr SubcommandHelp kSubcommands[] = {
    {"render", "render SCENE [-o FILE] [-d DEVICE] [OPTIONS]", "Draw a scene on a device.",
     R"(Options override what the scene says. Without -o and -d the picture goes to the terminal.

Examples:
  overstrike render scene.yaml                            in the terminal
  overstrike render scene.yaml -o page.txt --lpi 8        a page for a line printer
  overstrike render scene.yaml -o sheet.hpgl              HP-GL for a pen plotter
  overstrike render bunny.stl -o bunny.png --size 1920x1080 --light -20,45
  generate | overstrike render - --format yaml -d line-printer -o - | lpr

Exit status: 0 done, 1 the work failed, 2 bad usage or a bad scene, 130 interrupted.)"},
    {"watch", "watch SCENE [OPTIONS]",
     "Draw a scene in the terminal, and anew whenever it is saved.",
     R"(It is drawn in the window's size, and follows it. While the file cannot be drawn it is said why, and the last
picture stays. Mesh files of the scene are watched, too. q or Ctrl-C ends.

Examples:
  overstrike watch scene.yaml
  overstrike watch scene.yaml --no-light --set color=256

Exit status: 1 the terminal failed, 2 bad usage or no such file, 130 ended.)"},
    {"emulate", "emulate line-printer|plotter FILE -o SHEET [OPTIONS]",
     "Draw what a machine would put on paper.",
     R"(Examples:
  overstrike emulate line-printer page.txt -o page.png --lpi 8
  overstrike emulate plotter sheet.hpgl -o sheet.pdf)"},
    {"check", "check SCENE [--format FORMAT] [-D NAME=VALUE]",
     "Read a scene, name everything that is wrong with it, and say what is in it.",
     R"(Examples:
  overstrike check scene.yaml
  overstrike check - --format stl < part.stl

Exit status: 0 the scene can be drawn, 2 it cannot.)"},
    {"devices", "devices [NAME]", "List the devices, or the settings of one.",
     R"(Examples:
  overstrike devices
  overstrike devices line-printer)"},
};

}  // namespace

const std::string_view kProgramSummary =
    "Draws solid scenes on machines that have no pixels: line printers, pen plotters, terminals.";
const std::string_view kProgramFooter = R"(Examples:
  overstrike render scene.yaml                            in the terminal
  overstrike render scene.yaml -o page.txt                a page for a line printer
  overstrike emulate line-printer page.txt -o page.png    what it prints
  overstrike watch scene.yaml                             in the terminal, whenever it is saved
  overstrike check scene.yaml                             what is wrong with it

'overstrike SUBCOMMAND --help' says more.)";
const std::string_view kVersionText = "overstrike " OVERSTRIKE_VERSION;

const OptionHelp& option_help(std::string_view names) {
  const auto found = std::find_if(std::begin(kOptions), std::end(kOptions),
                                  [&](const OptionHelp& help) { return help.names == names; });
  assert(found != std::end(kOptions));
  return *found;
}

const SubcommandHelp& subcommand_help(std::string_view name) {
  const auto found = std::find_if(std::begin(kSubcommands), std::end(kSubcommands),
                                  [&](const SubcommandHelp& help) { return help.name == name; });
  assert(found != std::end(kSubcommands));
  return *found;
}

bool is_subcommand(std::string_view name) {
  return std::any_of(std::begin(kSubcommands), std::end(kSubcommands),
                     [&](const SubcommandHelp& help) { return help.name == name; });
}

}  // namespace overstrike
