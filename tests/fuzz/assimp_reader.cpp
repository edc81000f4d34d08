#define OVERSTRIKE_ASSIMP ""
#include "scenes/readers/mesh_assimp.cpp"
