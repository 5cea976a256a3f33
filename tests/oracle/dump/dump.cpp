#include "tests/oracle/dump/dump.h"

#include <cstdio> // sscanf
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/oracle/lib/verdict.h"

using nlohmann::json;

static glm::dvec4 row_of(const json &numbers)
{
    return {numbers.at(0).get<double>(), numbers.at(1).get<double>(),
            numbers.at(2).get<double>(), numbers.at(3).get<double>()};
}

static glm::dvec3 vec3_of_json(const json &numbers)
{
    return {numbers.at(0).get<double>(), numbers.at(1).get<double>(),
            numbers.at(2).get<double>()};
}

static Lamp lamp_of(const std::string &name)
{
    if (name == "directional")
        return Lamp::DIRECTIONAL;
    if (name == "spot")
        return Lamp::SPOT;
    if (name == "point")
        return Lamp::POINT;
    throw BadInput("the oracle knows no light '" + name + "'");
}

static MapView view_of(const json &entry, Lamp lamp)
{
    MapView view;
    view.lamp = lamp;
    for (size_t i = 0; i < 4; i++)
        view.rows[i] = row_of(entry.at("map_from_relative").at(i));
    view.position = glm::dvec3(0);
    if (!view.parallel())
        view.position = vec3_of_json(entry.at("position"));
    view.cone = lamp == Lamp::SPOT ? entry.at("cone").get<double>() : 0;
    view.handover = entry.value("handover", 0.0);
    view.end = entry.value("end", 0.0);
    view.near = entry.at("near").get<double>();
    view.far = entry.at("far").get<double>();
    view.width = entry.at("width").get<int>();
    view.height = entry.at("height").get<int>();
    view.border = entry.at("border").get<double>();
    for (size_t i = 0; i < 4; i++)
        view.looked_up[i] = entry.at("looked_up").at(i).get<int>();
    return view;
}

static Blur blur_of(const std::string &name)
{
    if (name == "none")
        return Blur::NONE;
    if (name == "box")
        return Blur::BOX;
    if (name == "boxes")
        return Blur::BOXES;
    if (name == "gaussian")
        return Blur::GAUSSIAN;
    if (name == "binomial")
        return Blur::BINOMIAL;
    throw BadInput("the oracle knows no blur '" + name + "'");
}

static void read_blur(const json &options, Settings &settings)
{
    settings.downsample = options.at("downsample").get<int>();
    settings.radius = options.at("radius").get<int>();
    settings.blur = blur_of(options.at("blur").get<std::string>());
    settings.mips = options.at("mips").get<bool>();
    settings.anisotropy = options.at("anisotropy").get<int>();
    settings.hardware = options.at("sampler") == "hardware";
    settings.sat = options.at("sat").get<bool>();
    if (settings.blur == Blur::NONE)
        settings.radius = 0;
    if (settings.blur == Blur::BINOMIAL && settings.radius != 3)
        throw BadInput("a binomial blur has radius 3");
}

static bool stores_halves(const json &options)
{
    std::string format = options.at("format").get<std::string>();
    if (format != "rg32f" && format != "rg16f")
        throw BadInput("the oracle knows no format '" + format + "'");
    return format == "rg16f";
}

static Settings settings_of(const json &options, int step)
{
    Settings settings;
    settings.shadows = options.at("shadows") == "on";
    if (!settings.shadows) // nothing else is done
        return settings;
    if (step <= 4) {
        settings.bias = options.at("bias").get<double>();
        settings.slope_bias = options.at("slope-bias").get<double>();
    }
    if (step == 2) {
        settings.kernel = options.at("kernel").get<int>();
        settings.bilinear = options.at("bilinear").get<bool>();
        settings.poisson = options.at("pattern") == "poisson";
        settings.adaptive = options.at("adaptive").get<bool>();
    }
    if (step >= 3) {
        settings.half = stores_halves(options);
        settings.msaa = options.at("msaa").get<int>();
        settings.central = options.at("moments") == "central";
        settings.slope_term = options.at("slope-term").get<bool>();
        settings.slope_derivatives = options.at("slope-from") == "derivatives";
        settings.projected = options.at("depth") == "projected";
    }
    if (step >= 4)
        read_blur(options, settings);
    if (step == 5) {
        const json &floor = options.at("min-variance");
        settings.auto_variance = floor.is_string();
        if (floor.is_number())
            settings.min_variance = floor.get<double>();
        settings.bleed_reduction = options.at("bleed-reduction").get<double>();
        settings.variance_bias = options.at("variance-bias").get<double>();
        settings.smooth = options.at("reduction") == "smooth";
        settings.adaptive_box = options.at("sat-width") == "adaptive";
        settings.soft = options.at("soft").get<bool>();
        settings.light_size = options.at("light-size").get<double>();
        settings.penumbra_scale = options.at("penumbra-scale").get<double>();
        settings.hybrid = options.at("hybrid").get<bool>();
    }
    return settings;
}

static void read_size(const json &options, Run &run)
{
    const std::string &text = options.at("size").get_ref<const std::string &>();
    if (std::sscanf(text.c_str(), "%dx%d", &run.width, &run.height) != 2)
        throw BadInput("run.json: size '" + text + "' is not WxH");
}

static Run run_of(const json &root)
{
    Run run;
    run.step = root.at("step").get<int>();
    run.scene = root.at("scene").get<std::string>();
    run.light = root.at("options").at("light").get<std::string>();
    run.options = root.at("options").dump();
    run.settings = settings_of(root.at("options"), run.step);
    read_size(root.at("options"), run);
    run.origin = vec3_of_json(root.at("origin"));
    for (size_t i = 0; i < 4; i++)
        run.clip_from_relative[i] = row_of(root.at("clip_from_relative").at(i));
    Lamp lamp = lamp_of(root.at("light").get<std::string>());
    for (const json &entry : root.at("views"))
        run.views.push_back(view_of(entry, lamp));
    for (MapView &view : run.views)
        view.projected = run.settings.projected && !view.parallel();
    return run;
}

static std::vector<glm::dvec2> load_places(const Run &run)
{
    int count = run.settings.msaa;
    if (count == 1)
        return {{0.5, 0.5}};
    std::vector<glm::dvec2> places;
    Picture file = load_file(run, "sample_positions.exr", count, 1, 2);
    for (int i = 0; i < count; i++)
        places.emplace_back(file.at(i, 0, 0), file.at(i, 0, 1));
    return places;
}

Run load_run(const std::string &folder)
{
    std::string path = folder + "/run.json";
    std::ifstream file(path);
    if (!file)
        throw BadInput(path + ": cannot be read");
    try {
        Run run = run_of(json::parse(file));
        run.folder = folder;
        run.places = load_places(run);
        return run;
    } catch (const json::exception &error) {
        throw BadInput(path + ": " + error.what());
    }
}

Picture load_file(const Run &run, const std::string &name, int width,
                  int height, int channels)
{
    std::string path = run.folder + "/" + name;
    Picture picture = load_picture(path);
    if (picture.width != width || picture.height != height ||
        picture.channels != channels) {
        char text[160];
        std::snprintf(text, sizeof text,
                      ": is %d x %d with %d channels, not %d x %d with %d",
                      picture.width, picture.height, picture.channels, width,
                      height, channels);
        throw BadInput(path + text);
    }
    return picture;
}

Picture load_map(const Run &run, int layer)
{
    const MapView &view = run.views[size_t(layer)];
    bool moments = run.step >= 3;
    std::string name = moments ? "moments." : "depth.";
    return load_file(run, name + std::to_string(layer) + ".exr", view.width,
                     view.height, moments ? 2 : 1);
}

std::vector<Picture> load_samples(const Run &run, int layer)
{
    if (run.settings.msaa == 1)
        return {load_map(run, layer)};
    const MapView &view = run.views[size_t(layer)];
    std::vector<Picture> samples;
    for (int i = 0; i < run.settings.msaa; i++) {
        std::string name =
            "samples." + std::to_string(layer) + "." + std::to_string(i);
        samples.push_back(
            load_file(run, name + ".exr", view.width, view.height, 2));
    }
    return samples;
}

Picture load_filtered(const Run &run, int layer)
{
    if (run.step < 4)
        return load_map(run, layer);
    const MapView &view = run.views[size_t(layer)];
    int factor = run.settings.downsample;
    return load_file(run, "blurred." + std::to_string(layer) + ".exr",
                     view.width / factor, view.height / factor, 2);
}

Receivers::Receivers(const Run &run)
    : receiver_(load_file(run, "receiver.exr", run.width, run.height, 4)),
      position_(load_file(run, "position.exr", run.width, run.height, 3)),
      normal_(load_file(run, "normal.exr", run.width, run.height, 3)),
      visibility_(load_file(run, "visibility.exr", run.width, run.height, 1)),
      layers_(int(run.views.size()))
{
    if (run.views.at(0).split())
        handover_ = load_file(run, "handover.exr", run.width, run.height, 4);
    for (const MapView &view : run.views)
        widths_.push_back(1 / glm::length(glm::dvec3(view.rows[0])));
}

Receiver Receiver::in_next() const
{
    Receiver r = *this;
    r.layer++;
    r.footprint_scale = next_scale;
    r.u = next.x;
    r.v = next.y;
    r.t = next.z;
    return r;
}

static glm::dvec3 vector_at(const Picture &picture, int x, int y)
{
    return {picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2)};
}

Receiver Receivers::at(int x, int y) const
{
    Receiver r;
    glm::dvec3 map = vector_at(receiver_, x, y);
    float layer = receiver_.at(x, y, 3);
    r.shown = layer != -1;
    if (r.shown && !(layer >= 0 && layer < float(layers_)))
        throw BadInput("receiver.exr: a layer that run.json does not have");
    r.layer = r.shown ? int(layer) : -1;
    r.u = map.x;
    r.v = map.y;
    r.t = map.z;
    r.position = vector_at(position_, x, y);
    r.normal = vector_at(normal_, x, y);
    r.visibility = visibility_.at(x, y);
    if (r.shown && !handover_.values.empty()) {
        r.next = vector_at(handover_, x, y);
        r.share = handover_.at(x, y, 3);
        size_t next = size_t(r.layer) + 1;
        if (next < widths_.size())
            r.next_scale = widths_[next - 1] / widths_[next];
    }
    return r;
}
