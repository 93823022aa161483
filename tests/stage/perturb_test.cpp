// perturb: every instance of the one source gives the same N'. What N' is, is the datapath's: tests/datapath.
#include "tests/stage/support.h"

namespace wrinkle {
namespace {

TEST(Perturb, LanesAgree) { expect_lanes_agree(kPerturb); }

}  // namespace
}  // namespace wrinkle
