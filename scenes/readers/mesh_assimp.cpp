#include "scenes/readers/mesh_assimp.h"

#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <dlfcn.h>

#include <cmath>
#include <memory>

#include "core/geometry/vec.h"
#include "scenes/readers/mesh_build.h"

namespace overstrike {
namespace {

/// The functions of Assimp's C interface that we need; their types are its own.
struct Library {
  decltype(&aiImportFile) import_file;
  decltype(&aiImportFileFromMemory) import_memory;
  decltype(&aiReleaseImport) release;
  decltype(&aiGetErrorString) error;
};

template <class Function>
void find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(::dlsym(library, name));
  if (!function) throw WorkError(std::string("cannot use " OVERSTRIKE_ASSIMP ": no ") + name);
}

const Library& library() {
  static const Library loaded = [] {
    void* const handle = ::dlopen(OVERSTRIKE_ASSIMP, RTLD_NOW | RTLD_LOCAL);
    if (!handle) throw WorkError(std::string("cannot load the library of meshes: ") + ::dlerror());
    Library l{};
    find(handle, "aiImportFile", l.import_file);
    find(handle, "aiImportFileFromMemory", l.import_memory);
    find(handle, "aiReleaseImport", l.release);
    find(handle, "aiGetErrorString", l.error);
    return l;
  }();
  return loaded;
}

struct Release {
  void operator()(const aiScene* scene) const { library().release(scene); }
};
using ScenePtr = std::unique_ptr<const aiScene, Release>;

Affine affine(const aiMatrix4x4& m) {
  Affine a;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) a.linear[column][row] = m[row][column];
    a.offset[row] = m[row][3];
  }
  return a;
}

Vec3 vec(const aiVector3D& v) { return {v.x, v.y, v.z}; }

/// glTF and X3D are Y up, 3MF and AMF are not; Collada and 3DS are turned so by Assimp; FBX says it
/// itself.
bool is_y_up(const aiScene& scene, const std::string& format) {
  constexpr int kY = 1;
  int up = kY;
  if (format == "fbx" && scene.mMetaData) scene.mMetaData->Get("UpAxis", up);
  return up == kY && format != "3mf" && format != "amf";
}

Affine y_up_to_z_up() { return {Mat3({1, 0, 0}, {0, 0, 1}, {0, -1, 0}), Vec3(0)}; }

class Merger {
 public:
  Merger(const aiScene& scene, const std::string& name) : scene_(scene), name_(name) {}

  Mesh read(const Affine& placement) {
    node(*scene_.mRootNode, placement);
    Polyhedron& p = mesh_.polyhedron;
    if (p.face_count() == 0) fail_mesh(name_, "the file has no faces");
    if (!all_have_normals_) p.corner_normals.clear();
    mesh_.precision = float_precision(p);
    weld_vertices(p);
    return std::move(mesh_);
  }

 private:
  void node(const aiNode& n, const Affine& above) {
    const Affine placement = above * affine(n.mTransformation);
    for (unsigned i = 0; i < n.mNumMeshes; ++i) part(*scene_.mMeshes[n.mMeshes[i]], placement);
    for (unsigned i = 0; i < n.mNumChildren; ++i) node(*n.mChildren[i], placement);
  }

  void part(const aiMesh& m, const Affine& placement) {
    Polyhedron& p = mesh_.polyhedron;
    const std::size_t start = p.vertices.size();
    if (start + m.mNumVertices > kMostCorners) fail_mesh(name_, "has too many vertices");
    for (unsigned i = 0; i < m.mNumVertices; ++i) {
      const Vec3 v = placement(vec(m.mVertices[i])) + 0.0;
      for (int axis = 0; axis < 3; ++axis)
        if (!(std::fabs(v[axis]) <= kLargestCoordinate))
          fail_mesh(name_, std::string{"xyz"[axis]} + " of vertex " + std::to_string(i) +
                               " of mesh '" + m.mName.C_Str() + "' must be a finite number");
      p.vertices.push_back(v);
    }
    const bool mirrored = glm::determinant(placement.linear) < 0;
    for (unsigned i = 0; i < m.mNumFaces; ++i) face(m, m.mFaces[i], start, mirrored, placement);
  }

  void face(const aiMesh& m, const aiFace& f, std::size_t start, bool mirrored,
            const Affine& placement) {
    if (f.mNumIndices < 3) return;  // points and lines
    Polyhedron& p = mesh_.polyhedron;
    all_have_normals_ = all_have_normals_ && m.mNormals;
    for (unsigned i = 0; i < f.mNumIndices; ++i) {
      const unsigned v = f.mIndices[mirrored ? f.mNumIndices - 1 - i : i];
      if (v >= m.mNumVertices)
        fail_mesh(
            name_,
            "vertex " + std::to_string(v) + " of mesh '" + m.mName.C_Str() + "' does not exist",
            "there are " + std::to_string(m.mNumVertices) + ", numbered from 0");
      p.indices.push_back(static_cast<Index>(start + v));
      if (all_have_normals_) normal(vec(m.mNormals[v]), placement.linear);
    }
    p.loop_ends.push_back(static_cast<Index>(p.indices.size()));
    p.end_face();
  }

  /// Normals go with the cofactors.
  void normal(const Vec3& n, const Mat3& m) {
    const Mat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    const Vec3 turned = (glm::determinant(m) < 0 ? -1.0 : 1.0) * (cofactors * n);
    const double length = glm::length(turned);
    all_have_normals_ = length > 0 && std::isfinite(length);
    mesh_.polyhedron.corner_normals.push_back(turned / length);
  }

  const aiScene& scene_;
  const std::string& name_;
  Mesh mesh_;
  bool all_have_normals_ = true;
};

Mesh merged(const ScenePtr& scene, const std::string& format, const std::string& name) {
  if (!scene) fail_mesh(name, std::string("cannot be read: ") + library().error());
  if (!scene->mRootNode) fail_mesh(name, "the file has no faces");
  return Merger(*scene, name).read(is_y_up(*scene, format) ? y_up_to_z_up() : Affine{});
}

constexpr unsigned kSteps = aiProcess_ValidateDataStructure;

}  // namespace

Mesh read_by_assimp(const std::filesystem::path& path, const std::string& format) {
  return merged(ScenePtr(library().import_file(path.c_str(), kSteps)), format, path.string());
}

Mesh read_by_assimp(std::string_view bytes, const std::string& format, const std::string& name) {
  if (bytes.size() > kMostCorners) fail_mesh(name, "is larger than 4 GB");
  return merged(ScenePtr(library().import_memory(bytes.data(), static_cast<unsigned>(bytes.size()),
                                                 kSteps, format.c_str())),
                format, name);
}

}  // namespace overstrike
