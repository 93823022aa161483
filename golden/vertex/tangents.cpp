#include "golden/vertex/tangents.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cstdint>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace wrinkle {
namespace {

constexpr std::int32_t kNone = -1;

// Direction of a length that the reference, in single precision, would call not zero; else v as it is.
bool not_zero(double x) { return std::abs(x) > FLT_MIN; }
bool not_zero(Vec3 v) { return not_zero(v.x) || not_zero(v.y) || not_zero(v.z); }
Vec3 unit_or_as_is(Vec3 v) { return not_zero(v) ? normalize(v) : v; }
Vec3 project(Vec3 v, Vec3 n) { return unit_or_as_is(v - dot(n, v) * n); }

struct Face {
  std::array<std::int32_t, 3> corner;                          // welded corners
  std::array<std::int32_t, 3> neighbour{kNone, kNone, kNone};  // across the edge i, i + 1
  std::array<std::int32_t, 3> group{kNone, kNone, kNone};      // of each corner
  Vec3 s, t;                                                   // unit derivatives of P by u and by v
  bool degenerate = false;                                     // two corners at one position
  bool joins_any = true;                                       // uv have no area: takes part, adds nothing
  bool preserving = false;                                     // turned the same way in uv as in space
};

struct Group {
  std::int32_t corner;  // the welded corner it is about
  bool preserving;
  std::vector<std::int32_t> faces;
};

// A face of a group.
struct Member {
  std::int32_t face;
  std::size_t corner;  // of the face, the one that the group is about
  bool joins_any;
  Vec3 s, t;   // projected directions
  Vec3 share;  // of the sum of the group
};

// Sums of consecutive shares, in time that grows with the logarithm of their number, without subtracting.
class RangeSum {
 public:
  explicit RangeSum(const std::vector<Member>& members) : size_(members.size()), nodes_(2 * members.size()) {
    for (std::size_t i = 0; i < size_; ++i) {
      nodes_[size_ + i] = members[i].share;
      total_ = total_ + members[i].share;
    }
    for (std::size_t i = size_; i-- > 1;) nodes_[i] = nodes_[2 * i] + nodes_[2 * i + 1];
  }
  Vec3 total() const { return total_; }  // in order
  Vec3 of(std::size_t first, std::size_t end) const {
    Vec3 sum;
    for (first += size_, end += size_; first < end; first /= 2, end /= 2) {
      if (first % 2 == 1) sum = sum + nodes_[first++];
      if (end % 2 == 1) sum = sum + nodes_[--end];
    }
    return sum;
  }

 private:
  std::size_t size_;
  std::vector<Vec3> nodes_;
  Vec3 total_;
};

// Which members of a group are exactly opposed, in s or in t, as single precision sees it.
class Opposites {
 public:
  Opposites(const std::vector<Member>& members, Vec3 n) : members_(members) {
    // Within a right angle of one of them no two are opposed: the usual case.
    const auto joins = [](const Member& m) { return m.joins_any; };
    const auto first = std::find_if_not(members.begin(), members.end(), joins);
    none_ = std::all_of(first, members.end(), [&](const Member& m) {
      return m.joins_any || (dot(first->s, m.s) > 0 && dot(first->t, m.t) > 0);
    });
    if (none_) return;
    // Directions are at right angles to n: along the axis that is the least along n they differ the most.
    const Vec3 size{std::abs(n.x), std::abs(n.y), std::abs(n.z)};
    axis_ = size.x <= size.y && size.x <= size.z ? &Vec3::x : size.y <= size.z ? &Vec3::y : &Vec3::z;
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (members[i].joins_any) continue;
      by_s_.emplace_back(members[i].s.*axis_, i);
      by_t_.emplace_back(members[i].t.*axis_, i);
    }
    std::sort(by_s_.begin(), by_s_.end());
    std::sort(by_t_.begin(), by_t_.end());
  }

  // Those of member m, in order.
  std::vector<std::size_t> of(std::size_t m) const {
    std::vector<std::size_t> found;
    if (none_ || members_[m].joins_any) return found;
    find(by_s_, members_[m].s, &Member::s, m, found);
    find(by_t_, members_[m].t, &Member::t, m, found);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

 private:
  using Sorted = std::vector<std::pair<double, std::size_t>>;
  void find(const Sorted& sorted, Vec3 direction, Vec3 Member::*which, std::size_t m,
            std::vector<std::size_t>& found) const {
    // A cosine that rounds to -1 leaves no more than this to the opposite direction.
    constexpr double kNear = 4e-4;
    const double opposite = -(direction.*axis_);
    for (auto at = std::lower_bound(sorted.begin(), sorted.end(), std::pair(opposite - kNear, std::size_t{0}));
         at != sorted.end() && at->first <= opposite + kNear; ++at) {
      const bool opposed = static_cast<float>(dot(direction, members_[at->second].*which)) <= -1.0F;
      if (opposed && at->second != m) found.push_back(at->second);
    }
  }

  const std::vector<Member>& members_;
  bool none_ = false;
  double Vec3::*axis_ = &Vec3::x;
  Sorted by_s_, by_t_;
};

class Generator {
 public:
  explicit Generator(std::span<const TangentCorner> corners) : corners_(corners), faces_(corners.size() / 3) {}

  std::vector<Tangent> run() {
    weld();
    differentiate();
    find_neighbours();
    build_groups();
    tangents_.assign(corners_.size(), Tangent{});
    for (const Group& group : groups_) emit(group);
    copy_to_degenerate();
    return std::move(tangents_);
  }

 private:
  const TangentCorner& corner(const Face& face, std::size_t i) const {
    return corners_[static_cast<std::size_t>(face.corner[i])];
  }
  static std::size_t corner_index(const Face& face, std::int32_t welded) {
    return static_cast<std::size_t>(std::find(face.corner.begin(), face.corner.end(), welded) - face.corner.begin());
  }
  Face& face(std::int32_t i) { return faces_[static_cast<std::size_t>(i)]; }
  const Face& face(std::int32_t i) const { return faces_[static_cast<std::size_t>(i)]; }

  void weld();
  void differentiate();
  void find_neighbours();
  void build_groups();
  void grow(std::int32_t group, std::int32_t from);
  bool join(std::int32_t group, std::int32_t candidate);
  std::vector<Member> members_of(const Group& group) const;
  void emit(const Group& group);
  void copy_to_degenerate();

  std::span<const TangentCorner> corners_;
  std::vector<Face> faces_;
  std::vector<Group> groups_;
  std::vector<Tangent> tangents_;
};

// Every corner is replaced by the first one with the same position, normal and uv.
void Generator::weld() {
  const auto key = [&](std::int32_t i) {
    const TangentCorner& c = corners_[static_cast<std::size_t>(i)];
    return std::array{c.P.x, c.P.y, c.P.z, c.N.x, c.N.y, c.N.z, c.uv.x, c.uv.y};
  };
  std::vector<std::int32_t> order(corners_.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    const auto ka = key(a), kb = key(b);
    return ka != kb ? ka < kb : a < b;
  });
  std::int32_t first = kNone;
  for (const std::int32_t i : order) {
    if (first == kNone || key(first) != key(i)) first = i;
    faces_[static_cast<std::size_t>(i) / 3].corner[static_cast<std::size_t>(i) % 3] = first;
  }
}

// Derivatives of position by u and v over each triangle, as directions.
void Generator::differentiate() {
  for (Face& f : faces_) {
    const TangentCorner &a = corner(f, 0), &b = corner(f, 1), &c = corner(f, 2);
    f.degenerate = a.P == b.P || a.P == c.P || b.P == c.P;
    const Vec2 t1 = b.uv - a.uv, t2 = c.uv - a.uv;
    const Vec3 d1 = b.P - a.P, d2 = c.P - a.P;
    const double area = t1.x * t2.y - t1.y * t2.x;
    f.preserving = area > 0;
    if (!not_zero(area)) continue;
    const Vec3 s = t2.y * d1 - t1.y * d2, t = t1.x * d2 - t2.x * d1;
    const double side = f.preserving ? 1 : -1, ls = length(s), lt = length(t);
    if (not_zero(ls)) f.s = (side / ls) * s;
    if (not_zero(lt)) f.t = (side / lt) * t;
    f.joins_any = !(not_zero(ls / std::abs(area)) && not_zero(lt / std::abs(area)));
  }
}

// Pairs faces along edges that they run through in opposite directions. Where more than two meet, the lower numbers
// are paired first.
void Generator::find_neighbours() {
  struct Edge {
    std::int32_t low, high, face;
    std::size_t index;
    auto key() const { return std::tuple(low, high, face); }
  };
  std::vector<Edge> edges;
  for (std::size_t n = 0; n < faces_.size(); ++n) {
    if (faces_[n].degenerate) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t a = faces_[n].corner[i], b = faces_[n].corner[(i + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), static_cast<std::int32_t>(n), i});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.key() < b.key(); });
  const auto start = [&](const Edge& e) { return face(e.face).corner[e.index]; };
  const auto slot = [&](const Edge& e) -> std::int32_t& { return face(e.face).neighbour[e.index]; };
  // Along one edge those that wait for a partner all run the same way.
  std::size_t waiting = 0;
  std::vector<const Edge*> queue;
  for (const Edge& e : edges) {
    const bool same = !queue.empty() && queue.back()->low == e.low && queue.back()->high == e.high;
    if (!same) queue.clear(), waiting = 0;
    if (waiting < queue.size() && start(*queue[waiting]) != start(e)) {
      slot(*queue[waiting]) = e.face;
      slot(e) = queue[waiting++]->face;
    } else {
      // Only what waits is looked at, but the last of those that were paired shows which edge this is.
      queue.push_back(&e);
    }
  }
}

// A group is the faces around a welded corner that can be reached over edges and are turned the same way.
void Generator::build_groups() {
  for (std::size_t n = 0; n < faces_.size(); ++n) {
    const auto number = static_cast<std::int32_t>(n);
    if (faces_[n].degenerate || faces_[n].joins_any) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      if (faces_[n].group[i] != kNone) continue;
      faces_[n].group[i] = static_cast<std::int32_t>(groups_.size());
      groups_.push_back({faces_[n].corner[i], faces_[n].preserving, {number}});
      grow(faces_[n].group[i], number);
    }
  }
}

// Depth first, the neighbour after the corner before the one ahead of it: the order decides which group first claims a
// face without uv area, and with it that face's orientation.
void Generator::grow(std::int32_t group, std::int32_t from) {
  std::vector<std::int32_t> open{from};
  bool first = true;
  while (!open.empty()) {
    const std::int32_t n = open.back();
    open.pop_back();
    if (!first && !join(group, n)) continue;
    first = false;
    const Face& f = face(n);
    const std::size_t i = corner_index(f, groups_[static_cast<std::size_t>(group)].corner);
    for (const std::int32_t next : {f.neighbour[(i + 2) % 3], f.neighbour[i]}) {
      if (next != kNone) open.push_back(next);
    }
  }
}

// True where `candidate` has become a member just now.
bool Generator::join(std::int32_t group, std::int32_t candidate) {
  Face& f = face(candidate);
  Group& g = groups_[static_cast<std::size_t>(group)];
  const std::size_t i = corner_index(f, g.corner);
  if (f.group[i] != kNone) return false;
  if (f.joins_any && f.group == std::array{kNone, kNone, kNone}) f.preserving = g.preserving;
  if (f.preserving != g.preserving) return false;
  f.group[i] = group;
  g.faces.push_back(candidate);
  return true;
}

// The faces of a group in order, each with its directions projected to the plane of the corner's normal, and with what
// it adds to the mean: its direction by its angle at the corner.
std::vector<Member> Generator::members_of(const Group& group) const {
  const Vec3 n = corners_[static_cast<std::size_t>(group.corner)].N;
  std::vector<std::int32_t> sorted = group.faces;
  std::sort(sorted.begin(), sorted.end());
  std::vector<Member> members;
  for (const std::int32_t number : sorted) {
    const Face& f = face(number);
    const std::size_t i = corner_index(f, group.corner);
    Member& m = members.emplace_back(Member{number, i, f.joins_any, {}, {}, {}});
    if (f.joins_any) continue;
    const Vec3 p = corner(f, i).P;
    const Vec3 a = project(corner(f, (i + 2) % 3).P - p, n), b = project(corner(f, (i + 1) % 3).P - p, n);
    m.s = project(f.s, n);
    m.t = project(f.t, n);
    m.share = std::acos(std::clamp(dot(a, b), -1.0, 1.0)) * m.s;
  }
  return members;
}

// Faces whose directions are exactly opposed do not share a tangent; all others of the group do.
void Generator::emit(const Group& group) {
  const std::vector<Member> members = members_of(group);
  const RangeSum shares(members);
  const Opposites opposites(members, corners_[static_cast<std::size_t>(group.corner)].N);
  for (std::size_t m = 0; m < members.size(); ++m) {
    Vec3 sum;
    std::size_t from = 0;
    for (const std::size_t opposed : opposites.of(m)) {
      sum = sum + shares.of(from, opposed);
      from = opposed + 1;
    }
    sum = from == 0 ? shares.total() : sum + shares.of(from, members.size());
    tangents_[3 * static_cast<std::size_t>(members[m].face) + members[m].corner] = {unit_or_as_is(sum),
                                                                                    group.preserving ? 1.0 : -1.0};
  }
}

// A triangle without extent takes what another triangle has at the same welded corner.
void Generator::copy_to_degenerate() {
  std::map<std::int32_t, std::size_t> source;
  for (std::size_t n = 0; n < faces_.size(); ++n) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!faces_[n].degenerate) source.try_emplace(faces_[n].corner[i], 3 * n + i);
    }
  }
  for (std::size_t n = 0; n < faces_.size(); ++n) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!faces_[n].degenerate) continue;
      const auto found = source.find(faces_[n].corner[i]);
      if (found != source.end()) tangents_[3 * n + i] = tangents_[found->second];
    }
  }
}

}  // namespace

std::vector<Tangent> generate_tangents(std::span<const TangentCorner> corners) { return Generator(corners).run(); }

void add_tangents(Mesh& mesh, const std::vector<bool>& keep) {
  std::vector<TangentCorner> corners;
  corners.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t index : triangle) {
      const Vertex& v = mesh.vertices[index];
      corners.push_back({v.P, v.N, {v.uv.x, 1 - v.uv.y}});
    }
  }
  const std::vector<Tangent> tangents = generate_tangents(corners);

  std::vector<Vertex> vertices;
  std::map<std::tuple<std::uint32_t, double, double, double, double>, std::uint32_t> known;
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t old = mesh.triangles[n][i];
      const bool kept = !keep.empty() && keep[old];
      const Tangent t = kept ? Tangent{mesh.vertices[old].T, mesh.vertices[old].sign} : tangents[3 * n + i];
      const auto [entry, is_new] =
          known.try_emplace({old, t.T.x, t.T.y, t.T.z, t.sign}, static_cast<std::uint32_t>(vertices.size()));
      if (is_new) {
        vertices.push_back(mesh.vertices[old]);
        vertices.back().T = t.T;
        vertices.back().sign = t.sign;
      }
      mesh.triangles[n][i] = entry->second;
    }
  }
  mesh.vertices = std::move(vertices);
}

}  // namespace wrinkle
