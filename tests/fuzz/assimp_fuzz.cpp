// What we make of the scenes that Assimp hands over. Its own parsers are not ours to fuzz (they
// leak and crash by themselves, and are not built for it); instead the reader is built once more
// with this program in Assimp's place, whose importer turns any bytes into any scene that Assimp's
// validation lets pass: a tree of nodes, finite numbers or not, indices that exist or not.
#include <assimp/cimport.h>
#include <assimp/scene.h>

#include <algorithm>
#include <limits>

#include "core/error.h"
#include "core/geometry/tessellate.h"
#include "scenes/readers/mesh_assimp.h"
#include "tests/fuzz/fuzz.h"

namespace overstrike::fuzz {
namespace {

constexpr unsigned kMostMeshes = 3, kMostNodes = 8, kMostVertices = 12, kMostFaces = 8;

float number(ByteSource& bytes) {
  constexpr float kNumbers[] = {0, 1, -1, 2, 0.5F, 1e30F, -1e30F, 1e-38F, 3.4e38F};
  const unsigned b = bytes.byte();
  if (b == 255) return std::numeric_limits<float>::quiet_NaN();
  if (b == 254) return std::numeric_limits<float>::infinity();
  return b < 200 ? kNumbers[b % 5] : kNumbers[b % std::size(kNumbers)];
}

aiVector3D vector(ByteSource& bytes) {
  const float x = number(bytes), y = number(bytes), z = number(bytes);
  return {x, y, z};
}

aiMesh* mesh(ByteSource& bytes) {
  auto* const m = new aiMesh;
  m->mNumVertices = 1 + bytes.below(kMostVertices);
  m->mVertices = new aiVector3D[m->mNumVertices];
  for (unsigned i = 0; i < m->mNumVertices; ++i) m->mVertices[i] = vector(bytes);
  if (bytes.below(2) == 1) {
    m->mNormals = new aiVector3D[m->mNumVertices];
    for (unsigned i = 0; i < m->mNumVertices; ++i) m->mNormals[i] = vector(bytes);
  }
  m->mNumFaces = bytes.below(kMostFaces);
  m->mFaces = new aiFace[m->mNumFaces];
  for (unsigned f = 0; f < m->mNumFaces; ++f) {
    aiFace& face = m->mFaces[f];
    face.mNumIndices = 1 + bytes.below(5);
    face.mIndices = new unsigned[face.mNumIndices];
    for (unsigned i = 0; i < face.mNumIndices; ++i)
      face.mIndices[i] = bytes.below(m->mNumVertices + (bytes.below(64) == 63));
  }
  return m;
}

aiNode* node(ByteSource& bytes, unsigned meshes, unsigned& left) {
  auto* const n = new aiNode;
  if (bytes.below(2) == 1)
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) n->mTransformation[row][column] = number(bytes);
  n->mNumMeshes = meshes == 0 ? 0 : bytes.below(3);
  n->mMeshes = new unsigned[n->mNumMeshes];
  for (unsigned i = 0; i < n->mNumMeshes; ++i) n->mMeshes[i] = bytes.below(meshes);
  const unsigned children = std::min(left, bytes.below(3));
  left -= children;
  n->mNumChildren = children;
  n->mChildren = new aiNode*[children];
  for (unsigned i = 0; i < children; ++i) n->mChildren[i] = node(bytes, meshes, left);
  return n;
}

}  // namespace
}  // namespace overstrike::fuzz

extern "C" {

const aiScene* aiImportFileFromMemory(const char* data, unsigned size, unsigned, const char*) {
  using namespace overstrike::fuzz;
  ByteSource bytes(reinterpret_cast<const std::uint8_t*>(data), size);
  if (bytes.below(32) == 31) return nullptr;
  auto* const scene = new aiScene;
  scene->mNumMeshes = bytes.below(kMostMeshes + 1);
  scene->mMeshes = new aiMesh*[scene->mNumMeshes];
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) scene->mMeshes[i] = mesh(bytes);
  unsigned left = kMostNodes;
  if (bytes.below(32) != 31) scene->mRootNode = node(bytes, scene->mNumMeshes, left);
  return scene;
}
const aiScene* aiImportFile(const char*, unsigned) { return nullptr; }
void aiReleaseImport(const aiScene* scene) { delete scene; }
const char* aiGetErrorString() { return "refused"; }

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace overstrike;
  if (size == 0) return 0;  // refused before it comes to Assimp
  try {
    const Mesh mesh = read_by_assimp(fuzz::text_of(data, size), "glb", "fuzz");
    const std::string fault = validate(Shape(mesh));
    fuzz::expect(fault.empty(), "a mesh that was read can be drawn: " + fault);
    for (const Index i : mesh.polyhedron.indices)
      fuzz::expect(i < mesh.polyhedron.vertices.size(), "faces number their vertices");
  } catch (const InputError& error) {
    fuzz::expect(!error.diagnostics().empty(), "an error says what is wrong");
  }
  return 0;
}
}
