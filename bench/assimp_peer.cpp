#include "bench/assimp_peer.hpp"

#include <stdexcept>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

namespace quarry::bench {

std::size_t read_with_assimp(const std::string& path, bool weld) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path, weld ? aiProcess_JoinIdenticalVertices : 0U);
  if (scene == nullptr) throw std::runtime_error(importer.GetErrorString());
  std::size_t faces = 0;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) faces += scene->mMeshes[i]->mNumFaces;
  return faces;
}

}  // namespace quarry::bench
