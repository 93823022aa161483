// The program as a user runs it: exit codes, messages, files written and not written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct Result {
  int exit_code;
  std::string output;  // both streams
};

Result run(const std::string& arguments) {
  FILE* pipe = popen((std::string(WRINKLE_PROGRAM) + " " + arguments + " 2>&1").c_str(), "r");
  Result result{-1, ""};
  std::array<char, 4096> buffer;
  while (std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe)) result.output.append(buffer.data(), n);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  return result;
}

// A folder of this test's own.
class Cli : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("wrinkle_cli_" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  nlohmann::json json(const std::string& name) const { return nlohmann::json::parse(std::ifstream(path(name))); }

  fs::path folder_;
};

struct BadCommand {
  const char* name;
  const char* arguments;
  const char* message;
};

class BadCommands : public testing::TestWithParam<BadCommand> {};

TEST_P(BadCommands, ExitTwoWithOneClearMessage) {
  const Result result = run(GetParam().arguments);
  EXPECT_EQ(result.exit_code, 2) << result.output;
  EXPECT_THAT(result.output, HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    All, BadCommands,
    testing::Values(BadCommand{"NoCommand", "", "A subcommand is required"},
                    BadCommand{"UnknownCommand", "rendr", "did you mean \"render\"?"},
                    BadCommand{"UnknownOption", "render patch_fig6 --fast", "--fast"},
                    BadCommand{"NoScene", "render", "SCENE"},
                    BadCommand{"MissingScene", "render /no/such/scene.toml", "/no/such/scene.toml"},
                    BadCommand{"FolderAsScene", "render /tmp", "/tmp"},
                    BadCommand{"UnknownEngine", "render patch_fig6 -e gpu", "ideal, exact, golden, golden-scalar, rtl"},
                    BadCommand{"UnknownConfig", "render patch_fig6 -c huge", "huge"},
                    BadCommand{"UnknownKey", "render patch_fig6 --set unit_bit=8", "unit_bit"},
                    BadCommand{"ValueOutOfRange", "render patch_fig6 --set unit_bits=99", "16"},
                    BadCommand{"ValueNotANumber", "render patch_fig6 --set unit_bits=many", "many"},
                    BadCommand{"SizeOfNothing", "render patch_fig6 --size 0x5", "WIDTHxHEIGHT"},
                    BadCommand{"SizeTooLarge", "render patch_fig6 --size 5000", "4096"},
                    BadCommand{"SizeWithRest", "render patch_fig6 --size 64x64x64", "WIDTHxHEIGHT"},
                    BadCommand{"UnknownAov", "render patch_fig6 --aov B -o /tmp/x.exr", "found B"},
                    BadCommand{"AovOfAnotherConfig", "render patch_fig1 --set datapath=phong --aov lod -o /tmp/x.exr",
                               "interpolate_lod"},
                    BadCommand{"AovOfAnotherDatapath", "render patch_fig6 --aov texture_offset -o /tmp/x.exr", "texture_n"},
                    BadCommand{"AovIntoPng", "render patch_fig6 --aov N -o /tmp/x.png", ".exr"},
                    BadCommand{"UnknownFormat", "render patch_fig6 --size 8 -o /tmp/x.nothing", ".nothing"},
                    BadCommand{"UnwritableFolder", "render patch_fig6 --size 8 -o /proc/none/x.png",
                               "/proc/none/x.png"},
                    BadCommand{"NothingToVerify", "verify", "--random N or --vectors FILE"},
                    BadCommand{"UnknownStalls", "verify patch_fig6 --stalls often", "bursty"},
                    BadCommand{"MissingVectors", "verify --vectors /no/such.txt", "/no/such.txt"},
                    BadCommand{"MissingRtl", "verify patch_fig6 --rtl /no/such", "/no/such"},
                    BadCommand{"FiguresByIdeal", "figures --engine ideal", "rtl or golden"},
                    BadCommand{"FiguresTooSmall", "figures --size 8", "--size"},
                    BadCommand{"NegativeLatency", "verify patch_fig6 --latency -1", "--latency"}),
    [](const auto& instance) { return instance.param.name; });

TEST_F(Cli, HelpOfEveryCommand) {
  EXPECT_EQ(run("--help").exit_code, 0);
  for (const char* command : {"demo", "render", "verify", "stress", "bench", "figures"}) {
    const Result result = run(std::string(command) + " --help");
    EXPECT_EQ(result.exit_code, 0) << command;
    EXPECT_THAT(result.output, HasSubstr("--json"));
    EXPECT_THAT(run("--help").output, HasSubstr(command));
  }
}

TEST_F(Cli, FailedRenderLeavesNoFile) {
  EXPECT_EQ(run("render /no/such.toml -o " + path("a.png") + " --json " + path("a.json")).exit_code, 2);
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(Cli, RenderWritesThePictureAlone) {
  const Result result = run("render patch_fig6 --size 40x30 -o " + path("a.png") + " --json " + path("a.json"));
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_GT(fs::file_size(path("a.png")), 100U);
  EXPECT_EQ(json("a.json")["width"], 40);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 2);
}

TEST_F(Cli, EveryEngineDrawsTheSameFragments) {
  for (const char* engine : {"ideal", "exact", "golden", "golden-scalar", "rtl"}) {
    const std::string file = path(std::string(engine) + ".json");
    const Result result = run(std::string("render patch_fig6 --size 48 --aov N,L,H,NL,NH,u,v,lod,z,triangle -e ") +
                              engine + " -o " + path("a.exr") + " --json " + file);
    ASSERT_EQ(result.exit_code, 0) << result.output;
  }
  for (const char* engine : {"ideal", "exact", "golden-scalar", "rtl"})
    EXPECT_EQ(json(std::string(engine) + ".json")["fragments"], json("golden.json")["fragments"]) << engine;
}

TEST_F(Cli, VerifyOfEqualEnginesExitsZero) {
  const Result result = run("verify patch_fig6 --random 5000 --json " + path("a.json"));
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_EQ(json("a.json")["equal"], true);
  EXPECT_EQ(json("a.json")["runs"].size(), 2U);
}

TEST_F(Cli, HelpAndVersion) {
  EXPECT_EQ(run("--version").exit_code, 0);
  EXPECT_THAT(run("--version").output, HasSubstr("wrinkle 0."));
  EXPECT_EQ(run("help").output, run("--help").output);
  EXPECT_EQ(run("help").exit_code, 0);
  EXPECT_EQ(run("help render").output, run("render --help").output);
  EXPECT_THAT(run("help render").output, HasSubstr("--exposure"));
}

// What was read, under whatever name, is not written over.
TEST_F(Cli, FilesThatWereReadAreNotWrittenOver) {
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1\nmtllib a.mtl\n";
  std::ofstream(path("a.obj")) << obj;
  std::ofstream(path("a.mtl")) << "newmtl m\nKd 1 1 1\nmap_Kd a.png\n";
  ASSERT_EQ(run("render patch_fig6 --size 8 -o " + path("a.png")).exit_code, 0);
  const auto size = fs::file_size(path("a.png"));
  fs::create_symlink("a.png", folder_ / "link.png");
  for (const std::string& output : {path("a.png"), path("./a.png"), path("link.png"), path("a.obj"), path("a.mtl")}) {
    const Result result = run("render " + path("a.obj") + " --size 64 -o " + output);
    EXPECT_EQ(result.exit_code, 2) << output;
    EXPECT_THAT(result.output, HasSubstr("was read"));
  }
  EXPECT_EQ(run("render " + path("a.obj") + " --size 64 -o " + path("b.png") + " --json " + path("a.mtl")).exit_code,
            2);
  EXPECT_FALSE(fs::exists(path("b.png"))) << "half of the work was written";
  EXPECT_EQ(fs::file_size(path("a.png")), size);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(std::ifstream(path("a.obj")).rdbuf()), {}), obj);
}

TEST_F(Cli, WithoutAnOutputPicturesGoBelowOut) {
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  const Result result = run("render patch_fig6 --size 8");
  const Result exr = run("render patch_fig6 --size 8 --aov N");
  fs::current_path(before);
  EXPECT_EQ(result.exit_code + exr.exit_code, 0) << result.output << exr.output;
  EXPECT_TRUE(fs::exists(folder_ / "out/patch_fig6.png"));
  EXPECT_TRUE(fs::exists(folder_ / "out/patch_fig6.exr"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(Cli, EndingsInUpperCase) {
  EXPECT_EQ(run("render patch_fig6 --size 8 -o " + path("A.PNG")).exit_code, 0);
  EXPECT_EQ(run("render patch_fig6 --size 8 --aov N -o " + path("A.EXR")).exit_code, 0);
  EXPECT_GT(fs::file_size(path("A.EXR")), fs::file_size(path("A.PNG")));
}

// A bare model under another camera and light; a scene seen from behind says why nothing is there.
TEST_F(Cli, ViewAndLightFromTheCommandLine) {
  std::ofstream(path("a.obj")) << "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n";
  const auto render = [&](const std::string& options) {
    return run("render " + path("a.obj") + " --size 64 -o " + path("a.png") + " --json " + path("a.json") + " " +
               options);
  };
  ASSERT_EQ(render("--camera 'height = 4, eye = [0, 0, 5]'").exit_code, 0);
  EXPECT_EQ(json("a.json")["fragments"], 32 * 32);
  ASSERT_EQ(render("--camera '{eye = [0, 0, 5], fov = 90}' --light 'position = [0, 0, 9]' --exposure 2 --background .5")
                .exit_code,
            0);
  const Result behind = render("--camera 'eye = [0, 0, -5]'");
  EXPECT_EQ(behind.exit_code, 0);
  EXPECT_EQ(json("a.json")["fragments"], 0);
  EXPECT_THAT(behind.output, HasSubstr("2 are seen from behind"));
  EXPECT_THAT(render("--camera 'eye = [9, 9, 9], target = [20, 20, 20]'").output, HasSubstr("behind the eye"));
  EXPECT_THAT(render("--camera 'eye = 5'").output, HasSubstr("--camera"));
  EXPECT_THAT(render("--camera 'eya = [1, 2, 3]'").output, HasSubstr("did you mean \"eye\"?"));
  EXPECT_EQ(render("--light up").exit_code, 2);
  EXPECT_EQ(render("--background 1,2,3").exit_code, 2);
  EXPECT_EQ(render("--exposure bright").exit_code, 2);
}

// Whatever a configuration takes from a scene is said.
TEST_F(Cli, LossesAreNoted) {
  const auto said = [&](const std::string& options) {
    return run("render " + options + " --size 16 -o " + path("a.png")).output;
  };
  EXPECT_THAT(said("patch_fig6 -c phong"), HasSubstr("bumps are not drawn"));
  EXPECT_THAT(said("patch_fig6 --set lighting=diffuse"), HasSubstr("highlights are not drawn"));
  EXPECT_THAT(said("patch_fig6 --set specular_squarings=3"), HasSubstr("2^specular_squarings (3)"));
  EXPECT_THAT(said("patch_gloss -c fine"), HasSubstr("gloss maps are not drawn (gloss_map = off)"));
  EXPECT_THAT(said("patch_gloss"), testing::Not(HasSubstr("not drawn")));
  EXPECT_THAT(said("patch_fig6"), testing::Not(HasSubstr("not drawn")));
}

// A command that reads no image does not wait for the libraries that read them: what the loader loads is their time.
TEST_F(Cli, SmallSceneLoadsNoImageLibraries) {
  setenv("LD_DEBUG", "files", 1);
  const auto loads_it = [&](const std::string& picture) {
    setenv("LD_DEBUG_OUTPUT", path("loaded_for_" + picture).c_str(), 1);
    EXPECT_EQ(run("render patch_fig1 -o " + path(picture)).exit_code, 0);
    unsetenv("LD_DEBUG_OUTPUT");
    return std::system(("grep -q 'libOpenImageIO.so' " + path("loaded_for_" + picture) + ".*").c_str()) == 0;
  };
  EXPECT_FALSE(loads_it("a.png"));
  EXPECT_TRUE(loads_it("a.exr"));
  unsetenv("LD_DEBUG");
}

TEST_F(Cli, ConfigShowsWhatFollows) {
  const Result table = run("config lean patch_fig6 --set unit_bits=8,dot_bits=9 --json " + path("a.json"));
  EXPECT_EQ(table.exit_code, 0) << table.output;
  EXPECT_EQ(json("a.json")["parameters"]["unit_bits"], 8);
  EXPECT_EQ(json("a.json")["parameters"]["dot_bits"], 9);
  EXPECT_TRUE(json("a.json")["derived"].contains("uv_width"));
  EXPECT_EQ(run("config patch_fig6 lean --set unit_bits=8,dot_bits=9").output, table.output) << "in either order";
  EXPECT_THAT(run("config lean --verilog").output, HasSubstr(".UNIT_BITS("));
  std::ofstream(path("mine.toml")) << run("config lean --toml --set unit_bits=8").output;
  EXPECT_EQ(run("config " + path("mine.toml")).output, run("config lean --set unit_bits=8").output);
  std::ofstream(path("bare.toml")) << "datapath = phong\n";
  EXPECT_THAT(run("config " + path("bare.toml")).output, HasSubstr("in quotes: datapath = \"phong\""));
}

// A mesh has a truth of its own; what a configuration leaves out of it is an error of the method. The parameters in the
// file are those that were measured.
TEST_F(Cli, ErrorOfAMeshHasAMethodError) {
  std::ofstream(path("a.obj")) << "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n";
  const auto method = [&](const std::string& changes) {
    const Result result = run("error " + path("a.obj") + " lean --set " + changes + " --json " + path("a.json"));
    EXPECT_EQ(result.exit_code, 0) << result.output;
    return json("a.json")["method"]["psnr_db"].get<double>();
  };
  const double with_highlight = method("unit_bits=8");
  EXPECT_EQ(json("a.json")["parameters"]["unit_bits"], 8);
  EXPECT_LT(with_highlight, 199);
  EXPECT_LT(method("unit_bits=8,lighting=diffuse"), with_highlight);
}

// The shell itself takes what is printed.
TEST_F(Cli, CompletionOfBash) {
  std::ofstream(path("words.sh"))
      << run("completion bash").output
      << "COMP_WORDS=(wrinkle ren); COMP_CWORD=1; _wrinkle; echo \"${COMPREPLY[@]}\"\n"
         "COMP_WORDS=(wrinkle render --ba); COMP_CWORD=2; _wrinkle; echo \"${COMPREPLY[@]}\"\n";
  FILE* pipe = popen(("bash " + path("words.sh")).c_str(), "r");
  std::array<char, 256> text{};
  const std::size_t size = fread(text.data(), 1, text.size(), pipe);
  pclose(pipe);
  EXPECT_EQ(std::string(text.data(), size), "render\n--background\n");
  for (const char* shell : {"zsh", "fish"})
    EXPECT_THAT(run(std::string("completion ") + shell).output, HasSubstr("render"));
  EXPECT_EQ(run("completion dos").exit_code, 2);
}

// Fig. 2 converges to `ideal`. Fig. 3 does not, since it filters normals, and with Eq. 8-11 it is the furthest off.
TEST_F(Cli, FiguresAreMeasuredAndWritten) {
  const Result result = run("figures --engine golden --size 128 -o " + folder_.string() + " --json " + path("a.json"));
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const nlohmann::json all = json("a.json");
  for (const auto& [name, file] : all["images"].items())
    EXPECT_GT(fs::file_size(file.get<std::string>()), 100U) << name;
  for (const char* sheet : {"figures", "held", "highlight"}) EXPECT_TRUE(all["images"].contains(sheet));
  ASSERT_EQ(all["pairs"].size(), 3U);
  for (const auto& pair : all["pairs"]) {
    EXPECT_GT(pair["psnr_db"], 25);
    EXPECT_LT(pair["psnr_db"], 45) << "the pictures are not the same";
    EXPECT_GT(pair["ssim"], .9);
    EXPECT_GE(pair["max"], pair["p999"]);
  }
  const auto method = [&](const std::string& name, int divisions) {
    for (const auto& row : all["tessellation"])
      if (row["method"] == name && row["filtering"] == "level0" && row["divisions"] == divisions)
        return row["psnr_method_db"].get<double>();
    return 0.0;
  };
  EXPECT_NEAR(method("fig2", 32) - method("fig2", 4), 36, 2);
  EXPECT_LT(method("fig2_held", 32), method("fig2", 32) - 6);
  EXPECT_LT(method("fig3_eq3-6", 32), method("fig3_eq3-6", 16) + 1);
  EXPECT_LT(method("fig3_eq8-11", 32), method("fig3_eq3-6", 32) - 6);
  EXPECT_NEAR(method("fig1", 32) - method("fig1", 4), 36, 2);
  EXPECT_GT(all["warp"]["max_degrees"], all["warp"]["mean_degrees_bumped"]);
  const auto& exact = all["highlight"]["exact"];
  EXPECT_NEAR(exact[3]["psnr_db"].get<double>() - exact[0]["psnr_db"].get<double>(), 36, 2);
}

// In a copy of the RTL bit 2 of the texture's normals is inverted. The program exits with 1 and names the stage.
TEST_F(Cli, WrongRtlExitsOneAndNamesTheStage) {
  fs::copy(fs::path(WRINKLE_SOURCE_DIR) / "rtl", folder_ / "rtl", fs::copy_options::recursive);
  const fs::path file = folder_ / "rtl/perturb/wrinkle_perturb_normal_map.v";
  std::ifstream in(file);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::string right = "draw_bump_i ? bump_i";
  const std::size_t at = text.find(right);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, right.size(), right + " ^ 4");
  std::ofstream(file) << text;
  const Result figures =
      run("figures --size 64 --rtl " + folder_.string() + " -o " + folder_.string() + " --json " + path("f.json"));
  EXPECT_EQ(figures.exit_code, 1) << figures.output;
  EXPECT_GT(json("f.json")["figures"][1]["mismatches"], 0);
  const Result result = run("verify patch_fig6 --rtl " + folder_.string() + " --json " + path("a.json"));
  EXPECT_EQ(result.exit_code, 1) << result.output;
  EXPECT_THAT(result.output, HasSubstr("perturb"));
  EXPECT_EQ(json("a.json")["runs"][0]["first"]["stage"], "perturb");
  EXPECT_EQ(json("a.json")["equal"], false);
}

}  // namespace
