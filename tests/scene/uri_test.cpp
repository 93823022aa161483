// URIs of glTF.
#include "sim/scene/uri.h"

#include <gmock/gmock.h>

#include "support.h"

namespace wrinkle::test {
namespace {

const Place kPlace{"a.gltf", 0, 0, "/buffers/0/uri"};

TEST(Uris, PercentIsDecodedAndPlusStays) {
  EXPECT_EQ(decode_percent("a%20b+c%2Bd%C3%BC"), "a b+c+d\xc3\xbc");
  EXPECT_EQ(decode_percent("100%"), "100%");
  EXPECT_EQ(decode_percent("50%of%2"), "50%of%2");
}

TEST(Uris, FilesAreFoundEncodedOrNot) {
  const Folder folder;
  for (const std::string name :
       {"a b.bin", "a+b.bin", "10%.bin", "n#1.bin", "\xc3\xbc.bin", "sub/x.bin", "a%20b.txt"}) {
    folder.write(name, name);
  }
  const auto found = [&](const std::string& uri) { return read_bytes(find_uri(folder.path(), uri, kPlace)); };
  EXPECT_EQ(found("a%20b.bin"), "a b.bin");
  EXPECT_EQ(found("a b.bin"), "a b.bin");
  EXPECT_EQ(found("a+b.bin"), "a+b.bin");
  EXPECT_EQ(found("a%2Bb.bin"), "a+b.bin");
  EXPECT_EQ(found("10%.bin"), "10%.bin");
  EXPECT_EQ(found("10%25.bin"), "10%.bin");
  EXPECT_EQ(found("n%231.bin"), "n#1.bin");
  EXPECT_EQ(found("n#1.bin"), "n#1.bin");
  EXPECT_EQ(found("%C3%BC.bin"), "\xc3\xbc.bin");
  EXPECT_EQ(found("sub\\x.bin"), "sub/x.bin");
  EXPECT_EQ(found("./sub/x.bin?version=2"), "sub/x.bin");
  EXPECT_EQ(found("a%20b.txt"), "a%20b.txt");  // a file that is named so
  expect_error([&] { found("gone%20.bin"); }, {"a.gltf: /buffers/0/uri", "gone .bin"});
  expect_error([&] { found("https://a/b.bin"); }, {"https://a/b.bin", "relative"});
  expect_error([&] { found("a%00b"); }, {"zero byte"});
}

TEST(Uris, BytesWithinThem) {
  const auto bytes = [](const std::string& uri) { return decode_data_uri(uri, kPlace).bytes; };
  EXPECT_EQ(bytes("data:application/octet-stream;base64,aGVsbG8="), "hello");
  EXPECT_EQ(bytes("data:application/octet-stream;base64,aGVsbG8"), "hello");
  EXPECT_EQ(bytes("DATA:;charset=utf-8;BASE64,aGVs bG8h"), "hello!");
  EXPECT_EQ(bytes("data:;base64,-_-_"), bytes("data:;base64,+/+/"));
  EXPECT_EQ(bytes("data:;base64,aGVsbG8%3D"), "hello");
  EXPECT_EQ(bytes("data:,a%20b+c"), "a b+c");
  EXPECT_EQ(decode_data_uri("data:Image/X-Odd;a=b,c", kPlace).media_type, "image/x-odd");
  expect_error([&] { bytes("data:image/png;base64"); }, {"/buffers/0/uri", "comma"});
  expect_error([&] { bytes("data:image/png;base64,aGV*"); }, {"image/png", "character 3"});
  expect_error([&] { bytes("data:image/png;base64,aGVsb"); }, {"image/png", "cut short"});
}

TEST(Messages, AreNeverLong) {
  const InputError error(kPlace, std::string(3000000, 'x') + "\n", "less");
  EXPECT_LT(std::string(error.what()).size(), 600U);
  EXPECT_THAT(error.what(), ::testing::HasSubstr("3000001 bytes in all"));
  EXPECT_EQ(shortened("a\nb\tc"), "a b c");
  std::string umlauts;
  for (int i = 0; i < 400; ++i) umlauts += "\xc3\xbc";
  const std::string cut = shortened(umlauts);
  EXPECT_EQ(cut.find("...") % 2, 0U);  // no half of a character
}

}  // namespace
}  // namespace wrinkle::test
